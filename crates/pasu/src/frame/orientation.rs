//! Which side of a network is its outside.

use std::sync::Arc;

use glam::DVec3;

use super::four_sided::FourSided;
use crate::numeric::gauss_legendre::FOUR;
use crate::numeric::signed_sets::SignedSets;
use crate::patch::{Row, Side};

/// Which patches of a network hang together and how each lies against the others, which its frames decide alone.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Lay {
    /// For each patch the one that stands for all that hang together with it, and whether it lies against that.
    found: Vec<(usize, bool)>,
    /// Whether the network has two sides: a Moebius strip has one.
    pub(super) is_two_sided: bool,
}

impl Lay {
    pub(super) fn of(all: &[[Side; 4]]) -> Lay {
        let mut sets = SignedSets::new(all.len());
        for (index, sides) in all.iter().enumerate() {
            for (side, met) in sides.iter().enumerate() {
                if let Side::Shared { patch: other, side: others, is_reversed } = *met
                    && (index, side) < (other, others)
                {
                    // Patches that lie on the same side go round in the same sense, and so pass what they share in opposite ones.
                    let is_against = (is_forwards(side) == is_forwards(others)) != is_reversed;
                    sets.join(index, other, is_against);
                }
            }
        }
        let found: Vec<(usize, bool)> = (0..all.len()).map(|patch| sets.find(patch)).collect();
        let is_two_sided = found.iter().all(|(top, _)| !sets.is_contradicted(*top));
        Lay { found, is_two_sided }
    }

    /// Whether a patch lies against the one that stands for all that hang together with it.
    pub(super) fn is_against(&self, patch: usize) -> bool {
        self.found.get(patch).is_some_and(|(_, is_against)| *is_against)
    }
}

/// The outside of a network.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Orientation {
    /// For each patch whether `X_u x X_v` points outwards.
    pub(super) is_outward: Vec<bool>,
    /// For each patch of a network: the flux of `X - middle` through it along `X_u x X_v`, and of a constant, nearly. The middle is that of the points of all patches that hang together, as they were when the whole network was solved last.
    fluxes: Vec<Flux>,
    /// Of those which stand for patches that hang together.
    middles: Vec<DVec3>,
}

/// What goes through a patch.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Flux {
    /// Of `X - middle`, and how much of it goes through either way at most.
    of_position: f64,
    either_way: f64,
    of_constant: DVec3,
}

impl Orientation {
    /// Turns all patches that hang together the same way: so that they go round a volume that is not negative. Of what is open that is the volume between it and its middle.
    pub(super) fn of(patches: &[Arc<FourSided>], lay: &Lay) -> Orientation {
        let middles = middles(patches, lay);
        let fluxes: Vec<Flux> =
            patches.iter().zip(&lay.found).map(|(patch, (top, _))| flux(patch, middles[*top])).collect();
        let mut sums = vec![0.0; patches.len()];
        for (flux, (top, is_against)) in fluxes.iter().zip(&lay.found) {
            sums[*top] += if *is_against { -flux.of_position } else { flux.of_position };
        }
        let is_outward = lay.found.iter().map(|(top, is_against)| (sums[*top] >= 0.0) != *is_against).collect();
        Orientation { is_outward, fluxes, middles }
    }

    /// The same of patches of which those of these numbers are other ones than before; `None` where the volume is so near to 0 that all of it has to be added up anew to tell its sign.
    pub(super) fn after(&self, patches: &[Arc<FourSided>], lay: &Lay, changed: &[usize]) -> Option<Orientation> {
        let mut fluxes = self.fluxes.clone();
        for patch in changed {
            fluxes[*patch] = flux(&patches[*patch], self.middles[lay.found[*patch].0]);
        }
        let mut sums = vec![Flux::default(); patches.len()];
        for (flux, (top, is_against)) in fluxes.iter().zip(&lay.found) {
            let (sum, sign) = (&mut sums[*top], if *is_against { -1.0 } else { 1.0 });
            sum.of_position += sign * flux.of_position;
            sum.of_constant += sign * flux.of_constant;
            sum.either_way += flux.either_way;
        }
        let mut is_positive = vec![true; patches.len()];
        for (top, middle) in middles(patches, lay).into_iter().enumerate().filter(|(top, _)| lay.found[*top].0 == *top)
        {
            let (sum, moved) = (sums[top], middle - self.middles[top]);
            let volume = sum.of_position - moved.dot(sum.of_constant);
            // Far more than rounding, in either way of adding up, can turn.
            if !(volume.abs() > NEARLY_NONE * (sum.either_way + moved.length() * sum.of_constant.length())) {
                return None;
            }
            is_positive[top] = volume >= 0.0;
        }
        let is_outward = lay.found.iter().map(|(top, is_against)| is_positive[*top] != *is_against).collect();
        Some(Orientation { is_outward, fluxes, middles: self.middles.clone() })
    }
}

/// A volume is nearly none when it is this small against all that goes through the patches either way.
const NEARLY_NONE: f64 = 1e-6;

/// The mean of the points of all patches that hang together, of each that stands for some.
fn middles(patches: &[Arc<FourSided>], lay: &Lay) -> Vec<DVec3> {
    let mut sums = vec![(DVec3::ZERO, 0.0); patches.len()];
    for (patch, (top, _)) in patches.iter().zip(&lay.found) {
        let (sum, n) = &mut sums[*top];
        *sum += patch.points().into_iter().sum::<DVec3>();
        *n += 8.0;
    }
    sums.into_iter().map(|(sum, n)| sum / n).collect()
}

/// Whether whoever goes round the unit square anticlockwise passes a side in the sense of its parameter.
fn is_forwards(side: usize) -> bool {
    matches!(side, 1 | 2)
}

/// What goes through a patch along `X_u x X_v`, nearly.
fn flux(patch: &FourSided, middle: DVec3) -> Flux {
    let mut sum = Flux::default();
    for (u, weight) in FOUR {
        let curve = patch.curve(*u);
        for (v, other) in FOUR {
            let jet = curve.jet(*v);
            let (arm, normal) = (jet.position - middle, jet.du.cross(jet.dv));
            let here = weight * other * arm.dot(normal);
            sum.of_position += here;
            sum.either_way += here.abs();
            sum.of_constant += weight * other * normal;
        }
    }
    sum
}
