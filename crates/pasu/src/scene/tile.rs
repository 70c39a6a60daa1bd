//! A cell of the border of a part, with what encloses it.

use glam::DVec3;

use super::border::{Beyond, Border, Jet};
use super::bounds::Bounds;
use super::isometry::Isometry;
use crate::numeric::triangle::Triangle;
use crate::patch::Cell;

/// A cell whose border is no further from the two triangles of its corners than it says.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tile {
    /// The piece of the border.
    pub(super) border: usize,
    pub(super) cell: Cell,
    /// At `(u0, v0)`, `(u1, v0)`, `(u0, v1)`, `(u1, v1)`: points of the border itself.
    pub(super) corners: [DVec3; 4],
    /// How far border and triangles are apart at most.
    pub(super) deviation: f64,
    /// Bounds of `X_uu`, `X_uv` and `X_vv` in parameters that run from 0 to 1 across the cell.
    pub(super) bends: [f64; 3],
}

/// A bound is larger than what it bounds by more than rounding, which is this part of the largest coordinate.
const ROUNDING: f64 = 8e-16;

/// What bends by more than this part of its length is halved across the bend; all else across the length.
const BENT: f64 = 0.05;

/// The largest coordinate of corners, whatever its sign.
fn far(corners: &[DVec3; 4]) -> f64 {
    corners.iter().fold(0.0f64, |most, corner| most.max(corner.abs().max_element()))
}

impl Tile {
    /// A cell of a piece of the border.
    pub(super) fn of(borders: &[Border], border: usize, cell: Cell) -> Tile {
        let ([u0, u1], [v0, v1]) = (cell.u, cell.v);
        let corners = [(u0, v0), (u1, v0), (u0, v1), (u1, v1)].map(|(u, v)| borders[border].position(u, v));
        Tile::with(borders, border, cell, corners)
    }

    fn with(borders: &[Border], border: usize, cell: Cell, corners: [DVec3; 4]) -> Tile {
        let (deviation, bends) = borders[border].enclosed(cell, corners);
        let deviation = deviation + ROUNDING * far(&corners);
        // What is no number encloses everything.
        let deviation = if deviation.is_finite() { deviation } else { f64::INFINITY };
        Tile { border, cell, corners, deviation, bends }
    }

    /// How much further it reaches in a direction than its corners at most, and whether halves along `u` would less than those along `v`, where one is known to be better.
    pub(super) fn beyond(&self, borders: &[Border], direction: DVec3) -> (f64, Option<bool>) {
        let Beyond { by, bends } = borders[self.border].beyond(self.cell, self.corners, direction);
        let by = by + ROUNDING * far(&self.corners);
        let is_along = bends.filter(|[along, round]| along != round).map(|[along, round]| along > round);
        // What is no number is no bound.
        if by < self.deviation { (by, is_along) } else { (self.deviation, is_along) }
    }

    /// The same tile of what is turned, then moved: how it bends stays as it was.
    pub(super) fn moved(&self, motion: &Isometry) -> Tile {
        if *motion == Isometry::NONE {
            return *self;
        }
        let corners = self.corners.map(|corner| motion.point(corner));
        // Corners are those of the moved border to rounding, before it was moved and after.
        let deviation = self.deviation + 2.0 * ROUNDING * (far(&corners) + far(&self.corners));
        Tile { corners, deviation, ..*self }
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds::of(&self.corners).wider(self.deviation)
    }

    /// The two triangles of its corners.
    pub(super) fn triangles(&self) -> [Triangle; 2] {
        let [a, b, c, d] = self.corners;
        [Triangle([a, b, d]), Triangle([a, d, c])]
    }

    /// How far two points of it are apart at most.
    pub(super) fn size(&self) -> f64 {
        let [a, b, c, d] = self.corners;
        let sides = [(a, b), (c, d), (a, c), (b, d), (a, d), (b, c)];
        sides.into_iter().map(|(one, other)| (one - other).length()).fold(0.0, f64::max) + 2.0 * self.deviation
    }

    /// How long it is along `u` and along `v`.
    fn lengths(&self) -> [f64; 2] {
        let [a, b, c, d] = self.corners;
        [(b - a).length().max((d - c).length()), (c - a).length().max((d - b).length())]
    }

    /// Its middle.
    pub(super) fn middle(&self) -> [f64; 2] {
        [self.cell.u, self.cell.v].map(|[from, to]| 0.5 * from + 0.5 * to)
    }

    /// The position and derivatives in its middle.
    pub(super) fn middle_jet(&self, borders: &[Border]) -> Jet {
        let [u, v] = self.middle();
        borders[self.border].jet(u, v)
    }

    /// How far `X_u` and `X_v`, in parameters that run from 0 to 1 across the cell, are from those of its middle at most.
    pub(super) fn turns(&self) -> [f64; 2] {
        let [uu, uv, vv] = self.bends;
        [0.5 * (uu + uv), 0.5 * (uv + vv)]
    }

    /// Its halves; `None` where there is no number between its ends.
    pub(super) fn halves(&self, borders: &[Border]) -> Option<[Tile; 2]> {
        self.halves_along(borders, None)
    }

    /// The same, along `u` or along `v` where that is given.
    pub(super) fn halves_along(&self, borders: &[Border], is_along: Option<bool>) -> Option<[Tile; 2]> {
        let [along, round] = self.lengths();
        let [uu, _, vv] = self.bends;
        let is_bent = 0.125 * uu.max(vv) > BENT * along.max(round);
        let is_along = is_along.unwrap_or(if is_bent { uu >= vv } else { along >= round });
        let halves = |[from, to]: [f64; 2]| {
            let middle = 0.5 * from + 0.5 * to;
            (from < middle && middle < to).then_some([[from, middle], [middle, to]])
        };
        let ([u0, u1], [v0, v1]) = (self.cell.u, self.cell.v);
        let [a, b, c, d] = self.corners;
        let border = &borders[self.border];
        let tile = |u, v, corners| Tile::with(borders, self.border, Cell { u, v }, corners);
        // The two corners that are new are those of both halves.
        let of_u = || {
            let [before, after] = halves([u0, u1])?;
            let [p, q] = [v0, v1].map(|v| border.position(before[1], v));
            Some([tile(before, [v0, v1], [a, p, c, q]), tile(after, [v0, v1], [p, b, q, d])])
        };
        let of_v = || {
            let [before, after] = halves([v0, v1])?;
            let [p, q] = [u0, u1].map(|u| border.position(u, before[1]));
            Some([tile([u0, u1], before, [a, b, p, q]), tile([u0, u1], after, [p, q, c, d])])
        };
        if is_along { of_u().or_else(of_v) } else { of_v().or_else(of_u) }
    }

    /// How far a point is from it at least.
    pub(super) fn distance_to(&self, point: DVec3) -> f64 {
        let near = self.triangles().into_iter().map(|triangle| (triangle.nearest(point) - point).length());
        (near.fold(f64::INFINITY, f64::min) - self.deviation).max(0.0)
    }
}
