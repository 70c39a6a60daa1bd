//! How thick a wall can be: as asked for, or thinner where the surface bends or comes close to itself.
//!
//! A point at a distance `t` from `P` along its normal has no nearer point of the surface than `P` as long as `t` is less than the radius of the largest ball that touches the surface at `P`
//! on that side and holds no other point of it. So no two of the lines along which the wall is laid meet, and the other side of the wall is embedded, whatever its thickness is within that bound.
//! The ball is found by shrinking it to one through a point inside (J. Ma, S. W. Bae, S. Choi, *3D medial axis point approximation using nearest neighbors and the normal field*, 2012).
//! How the surface bends at `P` itself is known from its second derivatives.

use core::f64::consts::TAU;
use core::ops::ControlFlow;

use glam::DVec3;

use super::cells::Cells;
use super::skin::{Skin, SkinJet};
use crate::design::Wall;
use crate::error::Result;
use crate::mesh::places;

/// The part of the largest ball's radius that a wall may take up.
const SHARE: f64 = 0.8;

/// Rows are no further apart than this.
const WIDEST: f64 = 1.0 / 48.0;

/// The fewest columns.
const COLUMNS: usize = 64;

/// A ball is shrunk at once when it can be by this factor.
const SHRUNK: f64 = 0.7;

/// What is thinner by less than this part is not thinned.
const ROUNDING: f64 = 1e-12;

/// The thickness is looked into at the places of a mesh that keeps this part of the size.
const FINENESS: f64 = 1.0 / 600.0;

/// The most places of such a mesh.
const MOST_PLACES: usize = 100_000;

/// How thick the wall is at each place of the surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Thickness {
    /// As asked for, everywhere.
    Even(f64),
    /// Less than asked for somewhere.
    Thinned(Thinned),
}

/// A thickness that had to be reduced somewhere.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Thinned {
    /// The rows, from 0 to 1.
    rows: Vec<f64>,
    /// Row by row, without the column that would repeat the first.
    values: Vec<f64>,
    n_columns: usize,
    /// The least, and where.
    pub(crate) thinnest: (f64, DVec3),
    /// The share of the area that is thinner than asked for.
    pub(crate) share: f64,
    /// How far the least, the greatest and the share may be off.
    pub(crate) errors: [f64; 3],
}

/// One place at which the ball is sought.
struct Sample {
    position: DVec3,
    /// Towards the other side of the wall.
    inward: DVec3,
    /// The radius of the ball that bends as the surface does.
    bend: f64,
    area: f64,
}

impl Thickness {
    /// The thickness of a wall on one side of a surface; `direction` is 1 for outwards and -1 for inwards.
    ///
    /// # Errors
    /// What [`places`] refuses.
    pub(crate) fn of(skin: &Skin, wall: &Wall, direction: f64, fineness: usize) -> Result<Thickness> {
        let (rows, columns) = rows_and_columns(skin, fineness)?;
        let samples = samples(skin, &rows, columns, direction);
        let asked = wall.thickness;
        let most = asked / SHARE;
        let positions: Vec<DVec3> = samples.iter().map(|sample| sample.position).collect();
        let cells = Cells::new(&positions, most / 2.0);
        let values: Vec<f64> = samples.iter().map(|sample| asked.min(SHARE * radius(sample, &cells, most))).collect();
        if values.iter().all(|t| *t >= asked) {
            return Ok(Thickness::Even(asked));
        }
        let mut values = least_nearby(&values, columns);
        // What is thinner by rounding alone is not thinned.
        values.iter_mut().filter(|t| **t > asked * (1.0 - ROUNDING)).for_each(|t| *t = asked);
        let mut thinned =
            Thinned { rows, values, n_columns: columns, thinnest: (asked, DVec3::ZERO), share: 0.0, errors: [0.0; 3] };
        let mut thinnest = (f64::INFINITY, DVec3::ZERO);
        let mut thickest = 0.0f64;
        let mut is_thinned = Vec::with_capacity(samples.len());
        let (mut thinned_area, mut area) = (0.0, 0.0);
        for (number, sample) in samples.iter().enumerate() {
            let (row, column) = (number / columns, number % columns);
            let [t, ..] = thinned.at(thinned.rows[row], TAU * column as f64 / columns as f64);
            if t < thinnest.0 {
                thinnest = (t, sample.position);
            }
            thickest = thickest.max(t);
            is_thinned.push(t < asked);
            area += sample.area;
            if t < asked {
                thinned_area += sample.area;
            }
        }
        thinned.thinnest = thinnest;
        thinned.share = if area > 0.0 { thinned_area / area } else { 0.0 };
        // The spline is between its least and its greatest coefficient; the edge of what is thinned lies within the gaps beside places of both kinds.
        let least = thinned.values.iter().fold(thinnest.0, |least, t| least.min(*t));
        let edge: f64 = (0..samples.len())
            .filter(|&k| has_other_neighbour(&is_thinned, columns, k))
            .filter_map(|k| samples.get(k))
            .map(|sample| sample.area)
            .sum();
        let rounding = 4.0 * f64::EPSILON;
        thinned.errors = [
            thinnest.0 - least + rounding * asked,
            thinned.thickest() - thickest + rounding * asked,
            if area > 0.0 { edge / area + 1e3 * rounding } else { 0.0 },
        ];
        Ok(Thickness::Thinned(thinned))
    }

    /// Whether it is as asked for everywhere.
    pub(crate) fn is_even(&self) -> bool {
        matches!(self, Thickness::Even(_))
    }

    /// Where derivatives of it jump, along and round; `None` where they do not.
    pub(crate) fn knots(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        match self {
            Thickness::Even(_) => None,
            Thickness::Thinned(thinned) => Some(thinned.knots()),
        }
    }

    /// `t`, `t_s`, `t_v`.
    pub(crate) fn at(&self, s: f64, v: f64) -> [f64; 3] {
        match self {
            Thickness::Even(thickness) => [*thickness, 0.0, 0.0],
            Thickness::Thinned(thinned) => thinned.at(s, v),
        }
    }
}

impl Thinned {
    /// The greatest thickness.
    pub(crate) fn thickest(&self) -> f64 {
        self.values.iter().fold(0.0, |most, t| most.max(*t))
    }

    /// Where the spline's second derivatives jump: along the surface, with both ends, and round it.
    fn knots(&self) -> (Vec<f64>, Vec<f64>) {
        let mut along = vec![0.0];
        along.extend(self.rows.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
        along.push(1.0);
        let n = self.n_columns;
        (along, (0..n).map(|j| TAU * (j as f64 + 0.5) / n as f64).collect())
    }

    /// A quadratic spline whose knots lie half-way between the places, so that its slopes have no jumps: near a place it is a mean of what stands there and at its eight neighbours.
    fn at(&self, s: f64, v: f64) -> [f64; 3] {
        let last = self.rows.len() as isize - 1;
        // Beyond the ends the rows are mirrored.
        let place = |k: isize| {
            let row = |k: isize| self.rows[k.clamp(0, last) as usize];
            if k < 0 {
                2.0 * row(0) - row(-k)
            } else if k > last {
                2.0 * row(last) - row(2 * last - k)
            } else {
                row(k)
            }
        };
        let knot = |k: isize| 0.5 * (place(k) + place(k + 1));
        let after = self.rows.partition_point(|row| *row <= s) as isize;
        let row = if after > 0 && s < knot(after - 1) { after - 1 } else { after.min(last) };
        let [a, b, c, d] = [knot(row - 2), knot(row - 1), knot(row), knot(row + 1)];
        let (before, behind) = (s - b, c - s);
        let along = [behind * behind / ((c - b) * (c - a)), before * before / ((c - b) * (d - b))];
        let along_s = [-2.0 * behind / ((c - b) * (c - a)), 2.0 * before / ((c - b) * (d - b))];

        let n = self.n_columns;
        let turns = v / TAU * n as f64;
        let nearest = libm::floor(turns + 0.5);
        let off = turns - nearest;
        let round = [0.5 * (0.5 - off) * (0.5 - off), 0.5 * (0.5 + off) * (0.5 + off)];
        let round_v = [off - 0.5, off + 0.5].map(|slope| slope * n as f64 / TAU);
        let column = nearest as isize;
        // Differences, so that equal numbers have themselves as mean.
        let mixed =
            |[left, middle, right]: [f64; 3], [l, r]: [f64; 2]| (l * (left - middle), r * (right - middle), middle);
        let at_row = |k: isize| {
            let values = [-1, 0, 1].map(|step| {
                let column = (column + step).rem_euclid(n as isize) as usize;
                self.values[k.clamp(0, last) as usize * n + column]
            });
            let ((l, r, middle), (l_v, r_v, _)) = (mixed(values, round), mixed(values, round_v));
            [middle + (l + r), l_v + r_v]
        };
        let [above, here, below] = [at_row(row - 1), at_row(row), at_row(row + 1)];
        let ((l, r, t), (l_s, r_s, _)) =
            (mixed([above[0], here[0], below[0]], along), mixed([above[0], here[0], below[0]], along_s));
        let (l_v, r_v, t_v) = mixed([above[1], here[1], below[1]], along);
        [t + (l + r), l_s + r_s, t_v + (l_v + r_v)]
    }
}

/// Whether one of the eight neighbours of a place is of the other kind.
fn has_other_neighbour(kinds: &[bool], columns: usize, number: usize) -> bool {
    let (row, column) = (number / columns, number % columns);
    let rows = row.saturating_sub(1)..=row + 1;
    rows.flat_map(|row| [columns - 1, 0, 1].map(|step| row * columns + (column + step) % columns))
        .any(|other| kinds.get(other).is_some_and(|kind| Some(kind) != kinds.get(number)))
}

/// The least of each value and its eight neighbours: a mean of these round a place is nowhere more than what was there.
fn least_nearby(values: &[f64], columns: usize) -> Vec<f64> {
    let rows = values.len() / columns;
    let at = |i: usize, j: usize| values[i * columns + j % columns];
    let round: Vec<f64> = (0..values.len())
        .map(|k| (k / columns, k % columns))
        .map(|(i, j)| at(i, j + columns - 1).min(at(i, j)).min(at(i, j + 1)))
        .collect();
    let at = |i: usize, j: usize| round[i * columns + j];
    (0..values.len())
        .map(|k| (k / columns, k % columns))
        .map(|(i, j)| at(i.saturating_sub(1), j).min(at(i, j)).min(at((i + 1).min(rows - 1), j)))
        .collect()
}

/// The rows and columns of a mesh of the part, and as many more as it takes.
fn rows_and_columns(skin: &Skin, fineness: usize) -> Result<(Vec<f64>, usize)> {
    let mut tolerance = FINENESS * skin.size();
    let (placed, columns) = loop {
        let (placed, columns, _) = places(skin.placed(), Some(tolerance))?;
        if placed.len() * columns <= MOST_PLACES {
            break (placed, columns);
        }
        tolerance *= 2.0;
    };
    let mut rows = vec![0.0];
    for pair in placed.windows(2) {
        let n = (libm::ceil((pair[1] - pair[0]) / WIDEST) as usize).max(1) * fineness;
        rows.extend((1..=n).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / n as f64));
    }
    if !skin.is_upward() {
        rows = rows.iter().rev().map(|u| 1.0 - u).collect();
    }
    Ok((rows, (columns - 1).max(COLUMNS) * fineness))
}

fn samples(skin: &Skin, rows: &[f64], columns: usize, direction: f64) -> Vec<Sample> {
    let mut samples = Vec::with_capacity(rows.len() * columns);
    let even = skin.columns(columns);
    let mut walk = skin.walk();
    for &s in rows {
        for j in 0..columns {
            let jet = walk.jet_at(s, &even, j);
            let inward = jet.normal * direction;
            samples.push(Sample {
                position: jet.position,
                inward,
                bend: bend(&jet, direction),
                area: jet.ds.cross(jet.dv).length(),
            });
        }
    }
    // Rows are not even: a sample stands for half of the way to its neighbours.
    for (i, row) in samples.chunks_mut(columns).enumerate() {
        let width = rows[(i + 1).min(rows.len() - 1)] - rows[i.saturating_sub(1)];
        for sample in row {
            sample.area *= width;
        }
    }
    samples
}

/// The radius at which `X + direction t N` first bends back: the least of `-1 / (direction k)` that is positive, with `k` the eigenvalues of `dN = k dX`.
fn bend(jet: &SkinJet, direction: f64) -> f64 {
    let (e, f, g) = (jet.ds.length_squared(), jet.ds.dot(jet.dv), jet.dv.length_squared());
    let (l, m, n) = (jet.normal_s.dot(jet.ds), jet.normal_s.dot(jet.dv), jet.normal_v.dot(jet.dv));
    let area = e * g - f * f;
    let (half, product) = ((g * l - 2.0 * f * m + e * n) / (2.0 * area), (l * n - m * m) / area);
    let root = libm::sqrt((half * half - product).max(0.0));
    let sharpest = (-direction * (half + root)).max(-direction * (half - root));
    if sharpest > 0.0 && sharpest.is_finite() { 1.0 / sharpest } else { f64::INFINITY }
}

/// The radius of the largest ball, up to `most`: the least of `|Q - P|^2 / (2 N . (Q - P))` over all points `Q` on its side.
fn radius(sample: &Sample, cells: &Cells, most: f64) -> f64 {
    let mut radius = most.min(sample.bend);
    loop {
        let mut least = radius;
        cells.near(sample.position + sample.inward * radius, radius, |point| {
            let across = point - sample.position;
            let depth = sample.inward.dot(across);
            // Most points are outside of the ball, which is seen without dividing.
            if across.length_squared() < 2.0 * depth * least {
                least = across.length_squared() / (2.0 * depth);
            }
            // Where there are many points, most of them are outside of the ball through the first.
            if least < SHRUNK * radius { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        if !(least < SHRUNK * radius) {
            return least;
        }
        radius = least;
    }
}
