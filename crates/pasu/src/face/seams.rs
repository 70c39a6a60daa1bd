//! Lines along which the derivatives of a face jump: the knots of a thickness that had to be interpolated, or of the surface itself.

use crate::numeric::turn;

/// The lines along which the derivatives of a face jump, in the coordinates `(s, v)` of [`Face::straight`](super::Face::straight), in which they are straight: `s` between two of `along` and `v`
/// between two of `round` the face is smooth.
#[derive(Debug, Clone, PartialEq)]
pub struct Seams {
    /// Values of `s`, from 0 to 1.
    pub(crate) along: Vec<f64>,
    /// Values of `v` in [0, 2 pi), in ascending order.
    pub(crate) round: Vec<f64>,
    /// Values of `v` where the beginning of a trimmed face crosses a line of `along`.
    pub(crate) crossings: Vec<f64>,
    /// Where neighbouring cells between the lines cannot be taken together: row by row one for each gap of `along` and each of `round`, the last of which goes on to the first. All of them where there are none.
    pub(crate) rough: Vec<bool>,
    /// How many times as long it takes to find a place of the face as one of the side of a wall.
    pub(crate) cost: usize,
}

/// Curves between which a face lies are sought anew at every `v`.
const ACROSS: usize = 50;

impl Seams {
    /// Of a face along which nothing jumps, cut into so many pieces that a short rule is good on each.
    pub(crate) fn across(pieces: usize, round: Vec<f64>) -> Seams {
        let along = (0..=pieces).map(|i| i as f64 / pieces as f64).collect();
        Seams { along, round: ascending(round), crossings: Vec::new(), rough: Vec::new(), cost: ACROSS }
    }

    /// Whether the cell between line number `i` of `along` and the next, and number `j` of `round` and the next, is one by itself.
    pub(crate) fn is_rough(&self, i: usize, j: usize) -> bool {
        self.rough.get(i * self.round.len() + j).is_none_or(|rough| *rough)
    }
}

/// Ascending values of `v` within one turn, without those that follow within rounding.
pub(crate) fn ascending(mut places: Vec<f64>) -> Vec<f64> {
    const APART: f64 = 1e-9;
    places.iter_mut().for_each(|v| *v = turn::within(*v));
    places.sort_by(f64::total_cmp);
    places.dedup_by(|next, kept| *next - *kept < APART);
    places
}
