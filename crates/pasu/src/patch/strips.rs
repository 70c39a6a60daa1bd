//! Which directions of patches have their lines in common.

use super::contract::Patch;
use super::side::Side;
use crate::numeric::signed_sets::SignedSets;

/// Lines nearer to each other than this are one: a knot, and the same knot seen from the other end of its side.
pub(crate) const SAME_LINE: f64 = 1e-9;

/// The strips of patches that are joined from edge to opposite edge: all of a strip have the same lines, in one sense or the other.
pub(super) struct Strips {
    /// For direction `d` of patch `p`, number `2 p + d`, the one that stands for its strip, and whether it runs against that; lines of constant `u` are in direction 0.
    of: Vec<(usize, bool)>,
    /// Of that which stands for a strip: whether the strip meets itself reversed.
    is_own_reverse: Vec<bool>,
}

impl Strips {
    pub(super) fn of(patches: &[&dyn Patch]) -> Strips {
        let n = 2 * patches.len();
        let mut sets = SignedSets::new(n);
        for (patch, sides) in patches.iter().map(|patch| patch.sides()).enumerate() {
            for (side, met) in sides.into_iter().enumerate() {
                if let Side::Shared { patch: other, side: others, is_reversed } = met {
                    sets.join(2 * patch + across(side), 2 * other + across(others), is_reversed);
                }
            }
        }
        let of = (0..n).map(|direction| sets.find(direction)).collect();
        Strips { of, is_own_reverse: (0..n).map(|direction| sets.is_contradicted(direction)).collect() }
    }

    /// Gives every direction, in the order of their numbers, the lines of its strip, and says of which these are others than before.
    pub(super) fn share(&self, lines: Vec<&mut Vec<f64>>) -> Vec<bool> {
        let mut all: Vec<Vec<f64>> = vec![Vec::new(); self.of.len()];
        for (own, (top, is_against)) in lines.iter().zip(&self.of) {
            let into = &mut all[*top];
            // Mostly all of a strip have the same lines already.
            let is_there = match is_against {
                true => into.len() == own.len() && into.iter().zip(own.iter().rev()).all(|(a, b)| *a == 1.0 - b),
                false => into == *own,
            };
            if is_there && !self.is_own_reverse[*top] {
                continue;
            }
            if self.is_own_reverse[*top] {
                into.extend(own.iter().flat_map(|place| [*place, 1.0 - place]));
            } else if *is_against {
                into.extend(own.iter().map(|place| 1.0 - place));
            } else {
                into.extend_from_slice(own);
            }
        }
        for places in &mut all {
            places.sort_by(f64::total_cmp);
            places.dedup_by(|next, kept| *next - *kept <= SAME_LINE);
            // What is as good as the last one is not put in its place.
            if let Some(last) = places.last_mut() {
                *last = 1.0;
            }
        }
        let take = |(own, (top, is_against)): (&mut Vec<f64>, &(usize, bool))| {
            let here = all[*top].iter();
            match is_against {
                true => replace(own, here.rev().map(|place| 1.0 - place)),
                false => replace(own, here.copied()),
            }
        };
        lines.into_iter().zip(&self.of).map(take).collect()
    }
}

/// Puts other numbers into a list, and says whether they are others.
fn replace(list: &mut Vec<f64>, others: impl ExactSizeIterator<Item = f64> + Clone) -> bool {
    let is_same = list.len() == others.len() && list.iter().zip(others.clone()).all(|(one, other)| *one == other);
    if !is_same {
        list.clear();
        list.extend(others);
    }
    !is_same
}

/// The direction whose lines cut a side.
fn across(side: usize) -> usize {
    usize::from(side < 2)
}
