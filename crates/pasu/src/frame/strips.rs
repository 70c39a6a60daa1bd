//! The cubic terms of a network: one for each strip.
//!
//! The cubic term along an edge belongs to both patches that meet there and to the opposite edge of each, and so on: it runs through a whole strip of patches, with its sign turned where the parameter turns.

use glam::DVec3;

use super::network::along;
use crate::design::{FramePatch, FrameRule};
use crate::error::{Code, Error, Result};
use crate::numeric::signed_sets::SignedSets;
use crate::patch::Side;

/// Sums over one strip.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    /// Of `sign a b g / 3`, and of `a^2`, where `a` and `b` are the parameters of the second derivatives along and across the strip and `g` the mixed coefficient, all over the largest `a`.
    above: DVec3,
    below: DVec3,
    /// The largest `a` of each component.
    largest: DVec3,
}

/// The strips of a network, which its frames and its rule decide alone.
///
/// Number `2 p + d` is direction `d` of patch `p`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strips {
    /// For each direction the one that stands for its strip, and whether it runs against that.
    found: Vec<(usize, bool)>,
    /// Of that which stands for a strip: whether the strip meets itself reversed.
    is_own_reverse: Vec<bool>,
    /// Of that which stands for a strip: the patch that decides it by itself; `None` where all its patches do.
    deciding: Option<Vec<u32>>,
}

impl Strips {
    pub(super) fn of(sides: &[[Side; 4]], rule: FrameRule) -> Strips {
        let n = 2 * sides.len();
        let mut sets = SignedSets::new(n);
        for (index, met) in sides.iter().enumerate() {
            for (side, met) in met.iter().enumerate() {
                if let Side::Shared { patch: other, side: others, is_reversed } = *met
                    && (index, side) < (other, others)
                {
                    sets.join(2 * index + along(side), 2 * other + along(others), is_reversed);
                }
            }
        }
        let found: Vec<(usize, bool)> = (0..n).map(|direction| sets.find(direction)).collect();
        let deciding = match rule {
            FrameRule::Global => None,
            FrameRule::Seed(seed) => {
                let mut first = vec![u32::MAX; n];
                for patch in walk(sides, seed as usize) {
                    for (top, _) in &found[2 * patch..2 * patch + 2] {
                        if first[*top] == u32::MAX {
                            first[*top] = patch as u32;
                        }
                    }
                }
                Some(first)
            }
        };
        Strips { found, is_own_reverse: (0..n).map(|direction| sets.is_contradicted(direction)).collect(), deciding }
    }

    /// The directions that stand for the two strips of a patch.
    pub(super) fn tops(&self, patch: usize) -> [usize; 2] {
        [self.found[2 * patch].0, self.found[2 * patch + 1].0]
    }

    fn is_heard(&self, direction: usize, top: usize) -> bool {
        self.deciding.as_ref().is_none_or(|first| first[top] as usize == direction / 2)
    }

    /// The coefficients of `u^3` and of `v^3` of every patch on the strips that are wanted, which are told by the direction that stands for them; 0 on the others. `mixed` gives those of `u v^2` and of `u^2 v`. The path begins at the patches.
    ///
    /// The bits of a strip do not depend on which others are wanted.
    ///
    /// # Errors
    /// `out-of-range` where the parameter along a strip is 0 in all patches that decide it.
    pub(super) fn cubic(
        &self,
        patches: &[FramePatch],
        mixed: impl Fn(usize) -> [DVec3; 2],
        is_wanted: impl Fn(usize) -> bool,
    ) -> Result<Vec<[DVec3; 2]>> {
        let wanted = || self.found.iter().enumerate().filter(|(_, (top, _))| is_wanted(*top));
        let heard = || wanted().filter(|(direction, (top, _))| self.is_heard(*direction, *top));
        let mut sums = vec![Sum::default(); self.found.len()];
        let parameters = |direction: usize| {
            let FramePatch { a1, a2, .. } = &patches[direction / 2];
            let [a1, a2] = [*a1, *a2].map(DVec3::from_array);
            if direction.is_multiple_of(2) { (a1, a2) } else { (a2, a1) }
        };
        for (direction, (top, _)) in heard() {
            sums[*top].largest = sums[*top].largest.max(parameters(direction).0.abs());
        }
        for (direction, (top, is_against)) in heard() {
            let ((a, b), g, sum) = (parameters(direction), mixed(direction / 2)[direction % 2], &mut sums[*top]);
            // 0 / 0 is of a component that is refused below, or of a strip that has no cubic term.
            let share =
                DVec3::from_array(core::array::from_fn(
                    |i| if sum.largest[i] > 0.0 { a[i] / sum.largest[i] } else { 0.0 },
                ));
            let term = share * b * g / 3.0;
            sum.above += if *is_against { -term } else { term };
            sum.below += share * share;
        }
        let mut coefficients = vec![[DVec3::ZERO; 2]; patches.len()];
        for (direction, (top, is_against)) in wanted() {
            // What meets itself reversed is its own negative.
            if self.is_own_reverse[*top] {
                continue;
            }
            let Sum { above, below, largest } = sums[*top];
            if let Some(component) = (0..3).find(|component| !(below[*component] > 0.0)) {
                let mut of_strip = heard().filter(|(_, (other, _))| other == top);
                let first = of_strip.next().map_or(direction, |(number, _)| number);
                return Err(undecided(first, component, self.deciding.is_some()));
            }
            let coefficient = -above / below / largest;
            coefficients[direction / 2][direction % 2] = if *is_against { -coefficient } else { coefficient };
        }
        Ok(coefficients)
    }
}

/// The refusal of a strip whose cubic term has no say in the residual of whoever decides it.
fn undecided(direction: usize, component: usize, is_alone: bool) -> Error {
    let (name, axis) = (["a1", "a2"][direction % 2], ["x", "y", "z"][component]);
    let who = if is_alone {
        "this patch decides its strip by the rule, and"
    } else {
        "in all patches of the strip it is 0, but"
    };
    let message =
        format!("{who} the cubic term of {axis} along the strip needs it: expected a number other than 0, found 0");
    let error = Error::new(Code::OutOfRange, "", message).inside_item(component).inside_field(name);
    error.inside_item(direction / 2).with("component", axis).with("not", 0.0).with("found", 0.0)
}

/// All patches in the order of a breadth-first walk: by how many edges have to be crossed from the first, and then by number. What cannot be reached comes after, beginning with the lowest number.
fn walk(sides: &[[Side; 4]], seed: usize) -> Vec<usize> {
    let mut order = Vec::with_capacity(sides.len());
    let mut is_known = vec![false; sides.len()];
    for start in core::iter::once(seed).chain(0..sides.len()) {
        if core::mem::replace(&mut is_known[start], true) {
            continue;
        }
        let mut level = vec![start];
        while !level.is_empty() {
            order.extend_from_slice(&level);
            let mut next = Vec::with_capacity(2 * level.len());
            for met in level.iter().flat_map(|patch| &sides[*patch]) {
                if let Side::Shared { patch, .. } = *met
                    && !core::mem::replace(&mut is_known[patch], true)
                {
                    next.push(patch);
                }
            }
            next.sort_unstable();
            level = next;
        }
    }
    order
}
