//! The rectangle of a force where it goes on beyond its patch.

use std::collections::HashMap;
use std::collections::VecDeque;

use crate::design::plain;
use crate::error::{Code, Error, Result};
use crate::patch::Side;

/// The most patches, each counted as often as it is met, that one force reaches.
const MOST_MET: usize = 10_000;

/// How a patch lies on the grid that goes on from another: its `u` and `v` from the two coordinates `a` and `b` within a square of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Laid {
    patch: usize,
    /// Whether `u` runs along `b` and `v` along `a`.
    is_swapped: bool,
    /// Whether `u` and `v` run against that.
    is_against: [bool; 2],
}

/// A patch and the part of a rectangle that lies on it, in its own parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub(super) patch: usize,
    pub(super) sides: [[f64; 2]; 2],
}

impl Laid {
    /// The side of the patch that lies along an edge of the square, numbered as sides are: `a = 0`, `a = 1`, `b = 0`, `b = 1`; and whether its parameter runs against that of the edge.
    fn side(&self, edge: usize) -> (usize, bool) {
        // Which parameter is constant along the edge.
        let across = usize::from((edge < 2) == self.is_swapped);
        let end = (edge % 2 == 1) != self.is_against[across];
        (2 * across + usize::from(end), self.is_against[1 - across])
    }

    /// How another patch lies so that its side is along an edge of its square, with its parameter running against that of the edge or not.
    fn along(patch: usize, side: usize, edge: usize, is_against_edge: bool) -> Laid {
        let across = side / 2;
        let mut is_against = [is_against_edge; 2];
        is_against[across] = side % 2 != edge % 2;
        Laid { patch, is_swapped: (edge < 2) != (side < 2), is_against }
    }

    /// A rectangle of `a` and `b` in the parameters of the patch.
    fn own(&self, [a, b]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        let mut own = if self.is_swapped { [b, a] } else { [a, b] };
        for (side, is_against) in own.iter_mut().zip(self.is_against) {
            if is_against {
                *side = [1.0 - side[1], 1.0 - side[0]];
            }
        }
        own
    }
}

/// The pieces of a rectangle in the parameters of a patch, which go on into its neighbours beyond 0 and 1. At a free edge it is cut off. The path begins at the force.
///
/// # Errors
/// `out-of-range` for a rectangle that does not meet its patch; `crosses-itself` for one that goes round a point at which the patches do not lie four by four; `too-large` beyond so many.
pub(super) fn pieces(patch: usize, rectangle: [[f64; 2]; 2], sides: &[[Side; 4]]) -> Result<Vec<Piece>> {
    for (name, [from, to]) in ["u", "v"].into_iter().zip(rectangle) {
        if !(from < 1.0 && to > 0.0) {
            let message =
                format!("expected a rectangle that meets its patch, 0 to 1, found {} to {}", plain(from), plain(to));
            return Err(Error::new(Code::OutOfRange, name, message).with("found", from));
        }
    }
    let home = Laid { patch, is_swapped: false, is_against: [false; 2] };
    let mut laid = HashMap::from([([0i64, 0], home)]);
    let mut next = VecDeque::from([[0i64, 0]]);
    let mut pieces = Vec::new();
    while let Some(at) = next.pop_front() {
        let here = laid[&at];
        let place = at.map(|x| x as f64);
        let moved = [0, 1].map(|i| rectangle[i].map(|x| x - place[i]));
        pieces.push(Piece { patch: here.patch, sides: here.own(moved) });
        for (edge, goes_on) in
            [moved[0][0] < 0.0, moved[0][1] > 1.0, moved[1][0] < 0.0, moved[1][1] > 1.0].into_iter().enumerate()
        {
            let (side, is_against) = here.side(edge);
            let (true, Side::Shared { patch: other, side: others, is_reversed }) = (goes_on, sides[here.patch][side])
            else {
                continue;
            };
            let there = Laid::along(other, others, edge ^ 1, is_against != is_reversed);
            let mut beside = at;
            beside[edge / 2] += if edge % 2 == 1 { 1 } else { -1 };
            match laid.get(&beside) {
                None => {
                    laid.insert(beside, there);
                    next.push_back(beside);
                }
                Some(known) if *known == there => {}
                Some(_) => {
                    let message = format!(
                        "the rectangle goes round a corner of patch {} at which not four patches meet, and cannot lie flat there: expected one that does not",
                        here.patch
                    );
                    return Err(Error::new(Code::CrossesItself, "", message).with("what", "region"));
                }
            }
            if laid.len() > MOST_MET {
                let message = format!("expected a rectangle over at most {MOST_MET} patches");
                return Err(Error::new(Code::TooLarge, "", message).with("greatest", MOST_MET));
            }
        }
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What any way of laying a patch says of its sides is what it is laid by.
    #[test]
    fn a_patch_that_is_laid_along_an_edge_lies_along_it() {
        for edge in 0..4 {
            for side in 0..4 {
                for is_against in [false, true] {
                    let laid = Laid::along(7, side, edge, is_against);
                    assert_eq!(laid.side(edge), (side, is_against), "{edge} {side}");
                    // The middle of the edge is the middle of the side.
                    let at = [[0.0, 1.0], [0.5; 2], [0.5; 2], [0.0, 1.0]];
                    let middle =
                        if edge < 2 { [[(edge % 2) as f64; 2], at[1]] } else { [at[2], [(edge % 2) as f64; 2]] };
                    let own = laid.own(middle);
                    assert_eq!(own[side / 2], [(side % 2) as f64; 2]);
                    assert_eq!(own[1 - side / 2], [0.5; 2]);
                }
            }
        }
    }
}
