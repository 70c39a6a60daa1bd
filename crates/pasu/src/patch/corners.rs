//! Which corners of patches are one point.

use super::contract::Patch;
use super::side::Side;
use crate::numeric::signed_sets::SignedSets;

/// The corners `(u, v)` of a patch are numbered `2 u + v`; these are the first and the last of each side, in the order of its parameter.
pub(crate) const ENDS: [[usize; 2]; 4] = [[0, 1], [2, 3], [0, 2], [1, 3]];

/// For every corner of the patches of one shape, number `4 patch + corner`, the first that is the same point by the sides that they are on.
pub(crate) fn first_corners(patches: &[&dyn Patch]) -> Vec<usize> {
    let mut sets = SignedSets::new(4 * patches.len());
    for (patch, sides) in patches.iter().map(|patch| patch.sides()).enumerate() {
        for (side, met) in sides.into_iter().enumerate() {
            let [from, to] = ENDS[side].map(|corner| 4 * patch + corner);
            match met {
                Side::Free => {}
                Side::Pole => sets.join(from, to, false),
                Side::Joined => {
                    let [other_from, other_to] = ENDS[side ^ 1].map(|corner| 4 * patch + corner);
                    sets.join(from, other_from, false);
                    sets.join(to, other_to, false);
                }
                Side::Shared { patch: other, side: others, is_reversed } => {
                    let mut ends = ENDS[others].map(|corner| 4 * other + corner);
                    if is_reversed {
                        ends.reverse();
                    }
                    sets.join(from, ends[0], false);
                    sets.join(to, ends[1], false);
                }
            }
        }
    }
    let mut first = vec![usize::MAX; 4 * patches.len()];
    let mut firsts = Vec::with_capacity(first.len());
    for corner in 0..first.len() {
        let (top, _) = sets.find(corner);
        first[top] = first[top].min(corner);
        firsts.push(first[top]);
    }
    firsts
}
