//! Which side of a network is its outside.

use glam::DVec3;

use super::four_sided::FourSided;
use crate::numeric::gauss_legendre::FOUR;
use crate::numeric::signed_sets::SignedSets;
use crate::patch::{Patch, Side};

/// The sides of a network.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Orientation {
    /// For each patch whether `X_u x X_v` points outwards.
    pub(super) is_outward: Vec<bool>,
    /// Whether the network has two sides: a Moebius strip has one.
    pub(super) is_two_sided: bool,
}

/// Turns all patches that hang together the same way: so that they go round a volume that is not negative. Of what is open that is the volume between it and its middle.
pub(super) fn orientation(patches: &[FourSided]) -> Orientation {
    let mut sets = SignedSets::new(patches.len());
    for (index, patch) in patches.iter().enumerate() {
        for (side, met) in patch.sides().into_iter().enumerate() {
            if let Side::Shared { patch: other, side: others, is_reversed } = met
                && (index, side) < (other, others)
            {
                // Patches that lie on the same side go round in the same sense, and so pass what they share in opposite ones.
                let is_against = (is_forwards(side) == is_forwards(others)) != is_reversed;
                sets.join(index, other, is_against);
            }
        }
    }
    let found: Vec<(usize, bool)> = (0..patches.len()).map(|patch| sets.find(patch)).collect();
    let mut middles = vec![(DVec3::ZERO, 0.0); patches.len()];
    for (patch, (top, _)) in patches.iter().zip(&found) {
        let (sum, n) = &mut middles[*top];
        *sum += patch.points().into_iter().sum::<DVec3>();
        *n += 8.0;
    }
    let mut fluxes = vec![0.0; patches.len()];
    for (patch, (top, is_against)) in patches.iter().zip(&found) {
        let (sum, n) = middles[*top];
        let flux = flux(patch, sum / n);
        fluxes[*top] += if *is_against { -flux } else { flux };
    }
    let is_outward = found.iter().map(|(top, is_against)| (fluxes[*top] >= 0.0) != *is_against).collect();
    let is_two_sided = found.iter().all(|(top, _)| !sets.is_contradicted(*top));
    Orientation { is_outward, is_two_sided }
}

/// Whether whoever goes round the unit square anticlockwise passes a side in the sense of its parameter.
fn is_forwards(side: usize) -> bool {
    matches!(side, 1 | 2)
}

/// The flux of `X - middle` along `X_u x X_v`, nearly.
fn flux(patch: &FourSided, middle: DVec3) -> f64 {
    let mut sum = 0.0;
    for (u, weight) in FOUR {
        let row = patch.row(*u);
        for (v, other) in FOUR {
            let jet = row.jet(*v);
            sum += weight * other * (jet.position - middle).dot(jet.du.cross(jet.dv));
        }
    }
    sum
}
