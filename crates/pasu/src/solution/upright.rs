//! A placed surface from foot to rim.

use core::f64::consts::TAU;
use std::sync::Arc;

use glam::DVec3;

use super::columns::Columns;
use super::placed::Placed;
use crate::numeric::scattered::scattered;
use crate::patch::{Patch, Row, Side, SurfaceJet};
use crate::watch;

/// `X(s, v)` of a placed surface between two ends: `s = 0` is the foot, the end whose mean height along the placed z axis is the lower one, and `v` is in [0, 2 pi].
#[derive(Debug, Clone)]
pub(crate) struct Upright {
    placed: Arc<Placed>,
    /// Whether the foot is at `u = 0`.
    is_upward: bool,
    /// 1 where `X_s x X_v` points out of the pot, otherwise -1.
    outward: f64,
    /// The highest harmonic round the axis.
    waves: f64,
    /// How fast it may change next to its ends.
    rate: f64,
    is_closed: bool,
}

/// What of a surface lies between two corners of its profile, or its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    /// Where it begins and ends along `s`.
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// The same along `u`, in ascending order; `None` where it is all of the surface.
    between: Option<[f64; 2]>,
}

impl Stretch {
    /// All of a surface.
    pub(crate) const WHOLE: Stretch = Stretch { from: 0.0, to: 1.0, between: None };

    /// The `u` of the corner at which it ends, or begins.
    pub(crate) fn corner(&self, is_end: bool, is_upward: bool) -> f64 {
        let [low, high] = self.between.unwrap_or([0.0, 1.0]);
        if is_end == is_upward { high } else { low }
    }
}

/// Jets of one place after the other: shares with the place before what depends on `s` alone, or on `v` alone.
pub(crate) struct Walk<'a> {
    upright: &'a Upright,
    n_terms: usize,
    stretch: Stretch,
    row: Option<(f64, Box<dyn Row + 'a>)>,
    columns: Seen,
}

/// Columns that were asked for: what a patch makes of one is worth keeping from the second time on.
#[derive(Default)]
struct Seen {
    /// The last one and, once there were [`FEW`], each in the one place that is its own, where the next with that place takes over.
    slots: Vec<(u64, Option<Columns>)>,
    n_turns: usize,
}

/// A walk that goes to another column so many times keeps more than one.
const FEW: usize = 64;

/// How many it keeps then, a power of two.
const MANY: usize = 1 << 11;

impl Seen {
    /// The place of a column, and whether it was asked for before.
    fn place(&mut self, v: f64) -> (usize, bool) {
        let bits = v.to_bits();
        let mut place = scattered(bits) as usize & (self.slots.len().max(1) - 1);
        if self.slots.get(place).is_some_and(|(known, _)| *known == bits) {
            return (place, true);
        }
        self.n_turns += 1;
        let n = if self.n_turns > FEW { MANY } else { 1 };
        if self.slots.len() < n {
            // No number has these bits but one that is none.
            self.slots.resize_with(n, || (u64::MAX, None));
            place = scattered(bits) as usize & (n - 1);
        }
        self.slots[place] = (bits, None);
        (place, false)
    }
}

impl Upright {
    /// A part whose shape has two ends; `None` for any other.
    pub(crate) fn new(placed: &Arc<Placed>) -> Option<Upright> {
        let patch = placed.solved().wall()?;
        let [along, round] = patch.breaks();
        let is_closed = patch.sides()[2] == Side::Joined;
        let outward = if placed.is_forwards(0) { 1.0 } else { -1.0 };
        let mut upright = Upright {
            placed: Arc::clone(placed),
            is_upward: true,
            outward,
            waves: round.waves,
            rate: along.rate,
            is_closed,
        };
        let axis = placed.axis();
        let [start, end] = [0.0, 1.0].map(|s| axis.dot(upright.centre(s)));
        if end < start {
            upright.is_upward = false;
            upright.outward = -upright.outward;
        }
        Some(upright)
    }

    fn patch(&self) -> Option<&dyn Patch> {
        self.placed.solved().wall()
    }

    pub(crate) fn placed(&self) -> &Placed {
        &self.placed
    }

    /// Whether `s` is `u`, not `1 - u`.
    pub(crate) fn is_upward(&self) -> bool {
        self.is_upward
    }

    /// 1 where `X_s x X_v` points out of the pot, otherwise -1.
    pub(crate) fn outward(&self) -> f64 {
        self.outward
    }

    /// Whether the surface meets itself round the axis.
    pub(crate) fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// How many waves go round at most.
    pub(crate) fn waves(&self) -> f64 {
        self.waves
    }

    /// How fast it may change next to its ends, as `exp(-rate s)` and `exp(-rate (1 - s))`.
    pub(crate) fn rate(&self) -> f64 {
        self.rate
    }

    /// What lies between the corners of the profile, from foot to rim.
    pub(crate) fn stretches(&self) -> Vec<Stretch> {
        let surface = self.placed.solved().fourier();
        let rings = surface.iter().flat_map(|surface| surface.rings());
        let corners: Vec<f64> = rings.filter(|(_, is_corner)| *is_corner).map(|(u, _)| u).collect();
        if corners.is_empty() {
            return vec![Stretch::WHOLE];
        }
        let places: Vec<f64> = [0.0].into_iter().chain(corners).chain([1.0]).collect();
        let stretch = |&[low, high]: &[f64; 2]| {
            let ends = [low, high].map(|u| self.along(u));
            Stretch { from: ends[0].min(ends[1]), to: ends[0].max(ends[1]), between: Some([low, high]) }
        };
        let mut stretches: Vec<Stretch> = places.array_windows().map(stretch).collect();
        if !self.is_upward {
            stretches.reverse();
        }
        stretches
    }

    /// Where derivatives jump along `s`, in ascending order.
    pub(crate) fn knots(&self) -> Vec<f64> {
        let knots = self.patch().map(|patch| patch.breaks()[0].knots.clone()).unwrap_or_default();
        match self.is_upward {
            true => knots,
            false => knots.iter().rev().map(|u| 1.0 - u).collect(),
        }
    }

    /// Where `u` of the shape is.
    pub(crate) fn along(&self, u: f64) -> f64 {
        if self.is_upward { u } else { 1.0 - u }
    }

    /// The mean of a row.
    pub(crate) fn centre(&self, s: f64) -> DVec3 {
        let n = 2 * self.waves.min(1e4) as usize + 5;
        let mut walk = self.walk();
        (0..n).map(|j| walk.at(s, TAU * j as f64 / n as f64).position).sum::<DVec3>() / n as f64
    }

    /// Position and derivatives up to the second.
    pub(crate) fn at(&self, s: f64, v: f64) -> SurfaceJet {
        self.walk().at(s, v)
    }

    /// One place after the other.
    pub(crate) fn walk(&self) -> Walk<'_> {
        self.walk_on(Stretch::WHOLE)
    }

    /// The same on what lies between two corners, and on its continuation beyond them.
    pub(crate) fn walk_on(&self, stretch: Stretch) -> Walk<'_> {
        let n_terms = self.patch().map_or(0, Patch::n_terms);
        Walk { upright: self, n_terms, stretch, row: None, columns: Seen::default() }
    }

    /// Even columns of this surface.
    pub(crate) fn even_columns(&self, n: usize) -> Columns {
        self.patch().map(|patch| Columns::even(patch, n)).unwrap_or_default()
    }

    /// Columns at places of their own.
    pub(crate) fn columns_at(&self, places: Vec<f64>) -> Columns {
        self.patch().map(|patch| Columns::at(patch, places)).unwrap_or_default()
    }

    fn stand(&self, row: &dyn Row, jet: &SurfaceJet) -> SurfaceJet {
        let (along, round) = (if self.is_upward { 1.0 } else { -1.0 }, row.length() / TAU);
        self.placed.place(jet).stretched(along, round)
    }
}

impl<'a> Walk<'a> {
    fn jet(&mut self, s: f64, of: impl FnOnce(&dyn Row) -> SurfaceJet) -> SurfaceJet {
        watch::place(self.n_terms);
        let (_, row) = match self.row.take().filter(|row| row.0 == s) {
            Some(row) => row,
            None => match self.upright.patch() {
                Some(patch) => {
                    watch::row(self.n_terms);
                    let u = self.upright.along(s);
                    (s, self.stretch.between.map_or_else(|| patch.row(u), |between| patch.row_along(u, between)))
                }
                None => return SurfaceJet::default(),
            },
        };
        let jet = self.upright.stand(&*row, &of(&*row));
        self.row = Some((s, row));
        jet
    }

    /// Position and derivatives up to the second.
    pub(crate) fn at(&mut self, s: f64, v: f64) -> SurfaceJet {
        let (place, is_known) = self.columns.place(v);
        if !is_known {
            return self.jet(s, |row| row.jet(v / TAU));
        }
        let kept = self.columns.slots[place].1.take();
        let columns = kept.unwrap_or_else(|| self.upright.columns_at(vec![v]));
        let jet = self.at_column(s, &columns, 0);
        self.columns.slots[place].1 = Some(columns);
        jet
    }

    /// The same at a column.
    pub(crate) fn at_column(&mut self, s: f64, columns: &Columns, column: usize) -> SurfaceJet {
        self.jet(s, |row| row.jet_at(columns.of_patch(), column))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::solution::Solution;

    #[test]
    fn what_is_kept_of_rows_and_columns_changes_no_bit() {
        let text = "#1/bloor-wilson?n1=5";
        let solution = Solution::of(&Design::parse(text).unwrap());
        let upright = Upright::new(solution.part(0).unwrap()).unwrap();
        let mut walk = upright.walk();
        // More columns than are kept, row by row, then column by column; each by a walk of its own besides.
        let (few, many) = (7, 3 * MANY / 2);
        let place = |i: usize, j: usize| (i as f64 / 6.0, TAU * j as f64 / many as f64);
        let by_rows = (0..few).flat_map(|i| (0..many).map(move |j| (i, j)));
        let by_columns = (0..many).step_by(9).flat_map(|j| (0..few).map(move |i| (i, j)));
        for (i, j) in by_rows.chain(by_columns) {
            let (s, v) = place(i, j);
            let kept = walk.at(s, v);
            if j % 37 == 0 {
                assert_eq!(kept, upright.at(s, v), "{i} {j}");
            }
        }
    }
}
