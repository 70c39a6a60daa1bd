//! The pieces of which the border of a part is made, whatever they are of, and what encloses them.

use core::f64::consts::TAU;
use std::sync::Arc;

use glam::{DMat2, DVec2, DVec3};

use super::isometry::Isometry;
use crate::face::{Face, FaceKind};
use crate::patch::{Breaks, Cell, Side};
use crate::solid::Pot;
use crate::solution::{Placed, Solved};

/// What is measured of a face, of which no bounds are known, is taken this many times: a kink may be twice as high between two samples as it seems.
const MARGIN: f64 = 2.0;

/// Into how many pieces a closed piece is cut at least, so that none is flat.
const LEAST_ROUND: usize = 6;

/// The fewest and the most columns of a face of a wall.
const COLUMNS: (f64, f64) = (12.0, 96.0);

/// One piece `X(u, v)`, placed, over the unit square.
#[derive(Debug)]
pub(super) enum Border {
    /// A patch, of which bounds are proved.
    Patch { placed: Arc<Placed>, patch: usize, stretch: [f64; 3] },
    /// A face of a wall, of which they are measured; the wall is found before it is turned and moved.
    Face { pot: Arc<Pot>, face: usize, motion: Isometry },
}

/// Position and first derivatives.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Jet {
    pub(super) position: DVec3,
    pub(super) du: DVec3,
    pub(super) dv: DVec3,
}

impl Jet {
    /// How far the parameters are from those of the place of the tangent plane that is nearest to one so far away.
    pub(super) fn towards(&self, away: DVec3) -> DVec2 {
        let normal = DMat2::from_cols(
            DVec2::new(self.du.length_squared(), self.du.dot(self.dv)),
            DVec2::new(self.du.dot(self.dv), self.dv.length_squared()),
        );
        let downhill = DVec2::new(self.du.dot(away), self.dv.dot(away));
        match normal.determinant() {
            0.0 => downhill / normal.col(0).x.max(normal.col(1).y),
            _ => normal.inverse() * downhill,
        }
    }
}

/// How far a cell goes beyond its corners in a direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Beyond {
    /// No further than this.
    pub(super) by: f64,
    /// Bounds of how it bends in that direction along `u` and along `v`, where they are known.
    pub(super) bends: Option<[f64; 2]>,
}

impl Border {
    /// Every patch of a part.
    pub(super) fn patches(placed: &Arc<Placed>) -> Vec<Border> {
        let matrix = placed.matrix();
        // What scales, then turns: a vector is as long as the stretched one before.
        let stretch = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(DVec3::length);
        let patches = 0..placed.solved().n_patches();
        patches.map(|patch| Border::Patch { placed: Arc::clone(placed), patch, stretch }).collect()
    }

    /// Every face of a pot.
    pub(super) fn faces(pot: &Arc<Pot>) -> Vec<Border> {
        let faces = 0..pot.faces().len();
        faces.map(|face| Border::Face { pot: Arc::clone(pot), face, motion: Isometry::NONE }).collect()
    }

    pub(super) fn jet(&self, u: f64, v: f64) -> Jet {
        match self {
            Border::Patch { placed, patch, .. } => {
                let jet = placed.place(&placed.solved().patch(*patch).jet(u, v));
                Jet { position: jet.position, du: jet.du, dv: jet.dv }
            }
            Border::Face { pot, face, motion } => {
                let jet = pot.faces()[*face].jet(u, v * TAU);
                let du = motion.vector(jet.da);
                Jet { position: motion.point(jet.position), du, dv: motion.vector(jet.dv * TAU) }
            }
        }
    }

    /// The position alone, to the bit that of the jet.
    pub(super) fn position(&self, u: f64, v: f64) -> DVec3 {
        match self {
            Border::Patch { placed, patch, .. } => placed.point(placed.solved().patch(*patch).position(u, v)),
            Border::Face { .. } => self.jet(u, v).position,
        }
    }

    /// Whether its bounds are proved.
    pub(super) fn is_proved(&self) -> bool {
        matches!(self, Border::Patch { .. })
    }

    /// The places along `u` between which it is smooth, ends included; of a face, which has none, both ends.
    pub(super) fn knots(&self) -> Vec<f64> {
        match self {
            Border::Patch { placed, patch, .. } => placed.solved().patch(*patch).breaks()[0].with_ends(),
            Border::Face { .. } => vec![0.0, 1.0],
        }
    }

    /// Whether it is known to be straight along `u`, whatever `v` is.
    pub(super) fn is_straight(&self) -> bool {
        match self {
            Border::Patch { .. } => false,
            Border::Face { pot, face, .. } => pot.faces()[*face].is_straight(),
        }
    }

    /// What it is of a wall.
    pub(super) fn kind(&self) -> Option<FaceKind> {
        match self {
            Border::Patch { .. } => None,
            Border::Face { pot, face, .. } => Some(pot.faces()[*face].kind()),
        }
    }

    /// The unit normal out of the body, or out of the pot where there is none; beside a place at which it has no direction, the nearest that has.
    pub(super) fn normal(&self, u: f64, v: f64) -> DVec3 {
        const BESIDE: [f64; 4] = [0.0, 1e-9, 1e-6, 1e-3];
        let outward = match self {
            Border::Patch { placed, patch, .. } => {
                if placed.is_forwards(*patch) {
                    1.0
                } else {
                    -1.0
                }
            }
            Border::Face { pot, face, .. } => pot.faces()[*face].outward(),
        };
        let beside = |x: f64, by: f64| if x < 0.5 { x + by } else { x - by };
        let products = BESIDE.into_iter().map(|by| {
            let jet = self.jet(beside(u, by), beside(v, by));
            (jet.du.cross(jet.dv), jet.du.length() * jet.dv.length())
        });
        let found = products.into_iter().find(|(normal, size)| normal.length() > 1e-9 * size && *size > 0.0);
        found.map_or(DVec3::Z, |(normal, _)| normal.normalize_or(DVec3::Z) * outward)
    }

    /// The cells with which it begins: between knots, and so many that none is flat.
    pub(super) fn cells(&self) -> Vec<Cell> {
        let [along, round] = match self {
            Border::Patch { placed, patch, .. } => {
                let patch = placed.solved().patch(*patch);
                let [along, round] = patch.breaks();
                let sides = patch.sides();
                let least = |side: usize| if sides[side] == Side::Joined { LEAST_ROUND } else { 1 };
                [lines(&along, least(0)), lines(&round, least(2))]
            }
            Border::Face { pot, face, .. } => {
                let piece = &pot.faces()[*face];
                // What runs straight or in an arc from one curve to another needs few rows.
                let rows = if piece.is_straight() { 1 } else { 6 };
                let columns = (2.0 * pot.skin().waves() + 4.0).clamp(COLUMNS.0, COLUMNS.1) as usize;
                let even = |n: usize| (0..=n).map(|i| i as f64 / n as f64).collect();
                [even(rows), even(columns)]
            }
        };
        let rows = along.windows(2).map(|u| [u[0], u[1]]);
        let columns = || round.windows(2).map(|v| [v[0], v[1]]);
        rows.flat_map(|u| columns().map(move |v| Cell { u, v })).collect()
    }

    /// How far a cell with these corners is from its two triangles at most, but for rounding, and bounds of `X_uu`, `X_uv` and `X_vv` in parameters that run from 0 to 1 across it.
    pub(super) fn enclosed(&self, cell: Cell, corners: [DVec3; 4]) -> (f64, [f64; 3]) {
        match self {
            Border::Patch { placed, patch, stretch } => {
                let patch = placed.solved().patch(*patch);
                let [p, q] = cell.lengths();
                let (suprema, deviation) = patch.enclosed(cell, *stretch);
                let bends = [p * p * suprema.uu, p * q * suprema.uv, q * q * suprema.vv];
                (deviation, bends)
            }
            Border::Face { .. } => {
                let bends = self.measured(cell, corners).map(|bend| MARGIN * bend);
                (0.125 * (bends[0] + 2.0 * bends[1] + bends[2]), bends)
            }
        }
    }

    /// How much further a cell reaches in a direction than its corners at most, but for rounding: of what is level all over not at all, however it is bent within its plane.
    ///
    /// `d . M x = (M^T d) . x` is no more than the square root of 3 times the length of `x` with its axes stretched by the components of `M^T d`.
    pub(super) fn beyond(&self, cell: Cell, corners: [DVec3; 4], direction: DVec3) -> Beyond {
        let (deviation, bends) = match self {
            Border::Patch { placed, patch, .. } => {
                let stretch = (placed.matrix().transpose() * direction).abs();
                let n_axes = stretch.to_array().into_iter().filter(|share| *share > 0.0).count();
                let (suprema, deviation) = placed.solved().patch(*patch).enclosed(cell, stretch.to_array());
                let ([p, q], most) = (cell.lengths(), libm::sqrt(n_axes as f64));
                let bends = [p * p * suprema.uu, p * q * suprema.uv, q * q * suprema.vv].map(|bend| most * bend);
                // Beside the rim of a force slopes jump, by what its suprema do not say.
                let is_smooth = matches!(placed.solved(), Solved::TwoSided(_) | Solved::Blend(_));
                (most * deviation, is_smooth.then_some(bends))
            }
            Border::Face { .. } => {
                let bends = self.differences(cell, corners, |vector| vector.dot(direction).abs());
                let [uu, uv, vv] = bends.map(|bend| MARGIN * bend);
                (0.125 * (uu + 2.0 * uv + vv), Some([uu, uv, vv]))
            }
        };
        let Some([uu, uv, vv]) = bends else { return Beyond { by: deviation, bends: None } };
        // What rises or falls all along a parameter reaches furthest on one of both edges across that, which bend along themselves alone.
        let [p, q] = cell.lengths();
        let middle = self.jet(0.5 * (cell.u[0] + cell.u[1]), 0.5 * (cell.v[0] + cell.v[1]));
        let is_steady = [(middle.du * p, uu + uv), (middle.dv * q, uv + vv)]
            .map(|(slope, turn)| slope.dot(direction).abs() > 0.5 * turn);
        let steady = match is_steady {
            [true, true] => 0.0,
            [true, false] => 0.125 * vv,
            [false, true] => 0.125 * uu,
            [false, false] => deviation,
        };
        Beyond { by: steady.min(deviation), bends: Some([uu, vv]) }
    }

    /// The second differences of a cell, each the largest of those of its lines through corners and middles.
    fn measured(&self, cell: Cell, corners: [DVec3; 4]) -> [f64; 3] {
        self.differences(cell, corners, DVec3::length)
    }

    /// The same, each by this measure of it.
    fn differences(&self, cell: Cell, [a, b, c, d]: [DVec3; 4], length: impl Fn(DVec3) -> f64) -> [f64; 3] {
        let ([u0, u1], [v0, v1]) = (cell.u, cell.v);
        let (u, v) = (0.5 * (u0 + u1), 0.5 * (v0 + v1));
        let [s, n, w, e, m] = [(u, v0), (u, v1), (u0, v), (u1, v), (u, v)].map(|(u, v)| self.jet(u, v).position);
        let bend = |lines: [[DVec3; 3]; 3]| {
            let bends = lines.into_iter().map(|[from, at, to]| 4.0 * length((from - at) + (to - at)));
            bends.fold(0.0, f64::max)
        };
        let twist = |one: DVec3, other: DVec3, third: DVec3, fourth: DVec3| length((one - other) - (third - fourth));
        let parts = [twist(a, s, w, m), twist(s, b, m, e), twist(w, m, c, n), twist(m, e, n, d)];
        let twisted = parts.into_iter().map(|part| 4.0 * part).fold(twist(a, b, c, d), f64::max);
        [bend([[a, s, b], [w, m, e], [c, n, d]]), twisted, bend([[a, w, c], [s, m, n], [b, e, d]])]
    }
}

/// Knots and ends, and between two of them so many pieces that there are enough in all.
fn lines(breaks: &Breaks, least: usize) -> Vec<f64> {
    let knots = breaks.with_ends();
    let pieces = least.div_ceil(knots.len() - 1);
    let between = |pair: &[f64]| {
        let (from, step) = (pair[0], (pair[1] - pair[0]) / pieces as f64);
        (0..pieces).map(|i| from + i as f64 * step).collect::<Vec<f64>>()
    };
    knots.windows(2).flat_map(between).chain([1.0]).collect()
}
