//! How thick a wall can be: as asked for, or thinner where the surface bends or comes close to itself.
//!
//! A point at a distance `t` from `P` along its normal has no nearer point of the surface than `P` as long as `t` is less than the radius of the largest ball that touches the surface at `P`
//! on that side and holds no other point of it. So no two of the lines along which the wall is laid meet, and the other side of the wall is embedded, whatever its thickness is within that bound.
//! The ball is found by shrinking it to one through a point inside (J. Ma, S. W. Bae, S. Choi, *3D medial axis point approximation using nearest neighbors and the normal field*, 2012).
//! How the surface bends at `P` itself is known from its second derivatives.

use core::f64::consts::TAU;

use glam::DVec3;

use super::ball::Crowd;
use super::skin::{Skin, SkinJet, SkinWalk};
use crate::design::Wall;
use crate::error::Result;
use crate::mesh::places;
use crate::watch;

/// The part of the largest ball's radius that a wall may take up.
const SHARE: f64 = 0.8;

/// Rows are no further apart than this.
const WIDEST: f64 = 1.0 / 48.0;

/// The fewest columns.
const COLUMNS: usize = 64;

/// Between places it is looked at closer where the wall takes up more than this part of the radius at which the surface bends.
const NEAR: f64 = 0.4;

/// So many times as closely.
const CLOSER: usize = 3;

/// A third difference of the thickness that is more than this part of what was asked for shows in an integral.
const ROUGH: f64 = 2e-4;

/// What is thinner by less than this part is not thinned.
const ROUNDING: f64 = 1e-12;

/// What can be thicker than asked for by this factor is plainly as asked for.
const PLAINLY: f64 = 1.0 + 1e-9;

/// The thickness is looked into at the places of a mesh that keeps this part of the size.
const FINENESS: f64 = 1.0 / 600.0;

/// Rows no further apart than this are the two of a corner.
const APART: f64 = 1e-12;

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
    asked: f64,
}

/// By how much a wall is thinned where there is one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Told {
    /// The least thickness, and where.
    pub(crate) thinnest: (f64, DVec3),
    /// The greatest.
    pub(crate) thickest: f64,
    /// The share of the wall's area that is thinner than asked for.
    pub(crate) share: f64,
    /// How far the least, the greatest and the share may be off.
    pub(crate) errors: [f64; 3],
}

/// The places at which the ball was sought.
pub(crate) struct Sought {
    /// From 0 to 1.
    rows: Vec<f64>,
    /// Without one that repeats the first.
    pub(crate) columns: usize,
    /// Of each row the stretch of the surface that it is of: at a corner there are two.
    stretches: Vec<usize>,
    /// Row by row.
    samples: Vec<Sample>,
    /// 1 for a wall outwards, -1 for one inwards.
    direction: f64,
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

impl Sought {
    /// How many there are.
    pub(crate) fn n_places(&self) -> usize {
        self.samples.len()
    }
}

impl Thickness {
    /// The thickness of a wall on one side of a surface, and where it was sought; `direction` is 1 for outwards and -1 for inwards. With places that are `closer` together by some factor than those at which it
    /// was sought before: what the ball must not hold are still the points of before, how the surface bends is known everywhere.
    ///
    /// # Errors
    /// What [`places`] refuses.
    pub(crate) fn of(
        skin: &Skin,
        wall: &Wall,
        direction: f64,
        closer: Option<(usize, &Sought)>,
    ) -> Result<(Thickness, Sought)> {
        let (rows, columns) = rows_and_columns(skin, closer.map_or(1, |(factor, _)| factor))?;
        let (rows, stretches): (Vec<f64>, Vec<usize>) = rows.into_iter().unzip();
        let samples = samples(skin, (&rows, &stretches), columns, direction);
        watch::go_on()?;
        let asked = wall.thickness;
        let (points, of_points) =
            closer.map_or((&samples, &stretches), |(_, before)| (&before.samples, &before.stretches));
        let n_around = closer.map_or(columns, |(_, before)| before.columns);
        let mut crowds = crowds(skin, |stretch| {
            let rows = points.chunks(n_around).zip(of_points).filter(|(_, of)| **of == stretch);
            rows.flat_map(|(row, _)| row).map(|sample| sample.position).collect()
        });
        let values = within_balls(&samples, &stretches, columns, &mut crowds, asked)?;
        let sought = |rows: Vec<f64>| Sought { rows, columns, stretches, samples, direction };
        let mut values = least_nearby(&values, columns);
        // What is thinner by rounding alone is not thinned.
        values.iter_mut().filter(|t| **t > asked * (1.0 - ROUNDING)).for_each(|t| *t = asked);
        if values.iter().all(|t| *t >= asked) {
            return Ok((Thickness::Even(asked), sought(rows)));
        }
        let thinned = Thinned { rows: rows.clone(), values, n_columns: columns, asked };
        Ok((Thickness::Thinned(thinned), sought(rows)))
    }

    /// Where the wall of a surface of revolution was sought, if it can be as thick as asked for everywhere and a little more: on one meridian. `None` where it cannot, or where that is not plain.
    ///
    /// Of a circle about the axis, what stops a ball that touches the meridian is the point of it on the meridian or the one across from that: `|Q - P|^2 / (2 N . (Q - P))` is linear by linear in the cosine of the angle between the two, and so least at an end of it.
    ///
    /// # Errors
    /// What [`places`] refuses.
    pub(crate) fn plain_on_a_meridian(skin: &Skin, wall: &Wall, direction: f64) -> Result<Option<Sought>> {
        let (rows, _) = rows_and_columns(skin, 1)?;
        let (rows, stretches): (Vec<f64>, Vec<usize>) = rows.into_iter().unzip();
        let samples = samples(skin, (&rows, &stretches), 1, direction);
        watch::go_on()?;
        let frame = skin.frame();
        let mut crowds = crowds(skin, |stretch| {
            let on_meridian = samples.iter().zip(&stretches).filter(|(_, of)| **of == stretch);
            let both = on_meridian.flat_map(|(Sample { position, .. }, _)| {
                [*position, frame.point(-frame.plan(*position), frame.level(*position))]
            });
            both.collect()
        });
        let asked = PLAINLY * wall.thickness;
        let values = within_balls(&samples, &stretches, 1, &mut crowds, asked)?;
        let is_even = values.iter().all(|t| *t > asked * (1.0 - ROUNDING));
        Ok(is_even.then_some(Sought { rows, columns: 1, stretches, samples, direction }))
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

    /// The two of the knots round between which `v` is, from 0 to a turn.
    pub(crate) fn gap_round(&self, v: f64) -> Option<[f64; 2]> {
        match self {
            Thickness::Even(_) => None,
            Thickness::Thinned(thinned) => {
                let n = thinned.n_columns as f64;
                let below = libm::floor(v / TAU * n - 0.5);
                Some([below + 0.5, below + 1.5].map(|knot| TAU * knot / n))
            }
        }
    }

    /// Whether the wall takes up more than a share of the radius at which the surface bends, looked at between the places at which it was sought: it does nowhere where these are close enough
    /// together, and where the share is 1 its other side folds. Columns of the wall begin at `starts`.
    pub(crate) fn is_crowded(&self, skin: &Skin, sought: &Sought, starts: &[f64], limit: f64) -> bool {
        let Sought { rows, columns, samples, direction, stretches } = sought;
        let (n, thickest) = (*columns, self.thickest());
        let is_near = |k: usize| samples.get(k).is_some_and(|sample| thickest > NEAR * sample.bend);
        let mut walks: Vec<SkinWalk> = skin.stretches().iter().map(|stretch| skin.walk_on(*stretch)).collect();
        let shares: Vec<f64> = (0..=CLOSER).map(|i| i as f64 / CLOSER as f64).collect();
        for (i, pair) in rows.windows(2).enumerate().take_while(|_| !watch::is_stopped()) {
            let Some(walk) = walks.get_mut(stretches[i]).filter(|_| stretches[i] == stretches[i + 1]) else { continue };
            let row = |i: usize, j: usize| i * n + j % n;
            let exists = |j: usize| pair[1] >= starts[j % n].min(starts[(j + 1) % n]);
            let corners = |j: usize| [row(i, j), row(i, j + 1), row(i + 1, j), row(i + 1, j + 1)];
            let cells: Vec<usize> = (0..n).filter(|&j| exists(j) && corners(j).into_iter().any(is_near)).collect();
            for share in shares.iter().filter(|_| !cells.is_empty()) {
                let s = pair[0] + share * (pair[1] - pair[0]);
                for &j in &cells {
                    for part in &shares[..CLOSER] {
                        let v = TAU * (j as f64 + part) / n as f64;
                        let start = starts[j] + part * (starts[(j + 1) % n] - starts[j]);
                        if s >= start && self.at(s, v)[0] > limit * bend(&walk.jet(s, v), *direction) {
                            return true;
                        }
                    }
                }
            }
        }
        false
    }

    fn thickest(&self) -> f64 {
        match self {
            Thickness::Even(thickness) => *thickness,
            Thickness::Thinned(thinned) => thinned.thickest(),
        }
    }

    /// By how much the wall is thinned where there is one, from where its columns begin; `None` where it is as asked for all over.
    pub(crate) fn told(&self, skin: &Skin, sought: &Sought, starts: &[f64]) -> Option<Told> {
        let Thickness::Thinned(thinned) = self else { return None };
        let Sought { rows, columns: n, samples, .. } = sought;
        let (n, asked) = (*n, thinned.asked);
        // What stands at a place counts for the wall if the wall is there or at a neighbour.
        let counts = |i: usize, j: usize| {
            let above = rows[(i + 1).min(rows.len() - 1)];
            [n - 1, 0, 1].iter().any(|step| above >= starts[(j + step) % n])
        };
        let coefficients = (0..samples.len()).filter(|k| counts(k / n, k % n)).map(|k| thinned.values[k]);
        let (least, most) = coefficients.fold((f64::INFINITY, 0.0f64), |(least, most), t| (least.min(t), most.max(t)));
        if !(least < asked) {
            return None;
        }
        let (mut thinnest, mut thickest) = ((f64::INFINITY, DVec3::ZERO), 0.0f64);
        let (mut thinned_area, mut area, mut edge) = (0.0, 0.0, 0.0);
        let mut kinds = Vec::with_capacity(samples.len());
        for (k, sample) in samples.iter().enumerate() {
            let (s, v) = (rows[k / n], TAU * (k % n) as f64 / n as f64);
            let [t, ..] = self.at(s, v);
            kinds.push(t < asked);
            if s < starts[k % n] {
                continue;
            }
            if t < thinnest.0 {
                thinnest = (t, sample.position);
            }
            thickest = thickest.max(t);
            area += sample.area;
            if t < asked {
                thinned_area += sample.area;
            }
        }
        // And where it begins, between two rows.
        for (j, start) in starts.iter().enumerate() {
            let v = TAU * j as f64 / n as f64;
            let [t, ..] = self.at(*start, v);
            if t < thinnest.0 {
                thinnest = (t, skin.second(*start, v).position);
            }
        }
        for (k, sample) in samples.iter().enumerate().filter(|(k, _)| rows[k / n] >= starts[k % n]) {
            if has_other_neighbour(&kinds, n, k) {
                edge += sample.area;
            }
        }
        // The spline is between its least and its greatest coefficient; the edge of what is thinned lies within the gaps beside places of both kinds.
        let rounding = 4.0 * f64::EPSILON;
        let [share, edge] = [thinned_area, edge].map(|part| if area > 0.0 { part / area } else { 0.0 });
        let errors = [
            (thinnest.0 - least).max(0.0) + rounding * asked,
            (most - thickest).max(0.0) + rounding * asked,
            edge + if area > 0.0 { 1e3 * rounding } else { 0.0 },
        ];
        Some(Told { thinnest, thickest: thickest.max(thinnest.0), share, errors })
    }

    /// For each cell between [`Thickness::knots`], row by row, whether second derivatives jump there by more than a little.
    pub(crate) fn rough(&self) -> Vec<bool> {
        match self {
            Thickness::Even(_) => Vec::new(),
            Thickness::Thinned(thinned) => thinned.rough(),
        }
    }

    /// `t`, `t_s`, `t_v`.
    pub(crate) fn at(&self, s: f64, v: f64) -> [f64; 3] {
        match self {
            Thickness::Even(thickness) => [*thickness, 0.0, 0.0],
            Thickness::Thinned(thinned) => thinned.at(&thinned.row(s), v),
        }
    }

    /// The same, with what is kept of the row before if it is the same.
    pub(crate) fn on_row(&self, kept: &mut Option<SplineRow>, s: f64, v: f64) -> [f64; 3] {
        match self {
            Thickness::Even(thickness) => [*thickness, 0.0, 0.0],
            Thickness::Thinned(thinned) => {
                let row = kept.filter(|row| row.s == s).unwrap_or_else(|| thinned.row(s));
                *kept = Some(row);
                thinned.at(&row, v)
            }
        }
    }
}

impl Thinned {
    /// The greatest thickness.
    pub(crate) fn thickest(&self) -> f64 {
        self.values.iter().fold(0.0, |most, t| most.max(*t))
    }

    /// A jump of a second derivative is a third difference of the coefficients.
    fn rough(&self) -> Vec<bool> {
        let (n, last) = (self.n_columns, self.rows.len() - 1);
        let third = |[a, b, c, d]: [f64; 4]| (d - a - 3.0 * (c - b)).abs() > ROUGH * self.asked;
        let at = |i: usize, j: usize| self.values[i.min(last) * n + j % n];
        // Number j is of the four columns from j on.
        let round: Vec<bool> =
            (0..=last).flat_map(|i| (0..n).map(move |j| [0, 1, 2, 3].map(|k| at(i, j + k))).map(third)).collect();
        let along: Vec<bool> = (0..=last)
            .flat_map(|i| (0..n).map(move |j| [0, 1, 2, 3].map(|k: usize| at((i + k).saturating_sub(1), j))).map(third))
            .collect();
        // The cell after knot number j is about column j + 1.
        let is_rough = |i: usize, j: usize| {
            let column = j + 1;
            [1, 2, 3].iter().any(|back| round[i * n + (column + n - back) % n])
                || [0, 1, 2].iter().any(|back| i >= *back && along[(i - back) * n + column % n])
        };
        (0..=last).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| is_rough(i, j)).collect()
    }

    /// Where the spline's second derivatives jump: along the surface, with both ends, and round it.
    fn knots(&self) -> (Vec<f64>, Vec<f64>) {
        let mut along = vec![0.0];
        along.extend(self.rows.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
        along.push(1.0);
        let n = self.n_columns;
        (along, (0..n).map(|j| TAU * (j as f64 + 0.5) / n as f64).collect())
    }

    /// The part of [`Thinned::at`] that goes by `s` alone.
    fn row(&self, s: f64) -> SplineRow {
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
        SplineRow {
            s,
            first: [row - 1, row, row + 1].map(|k| k.clamp(0, last) as usize * self.n_columns),
            along: [behind * behind / ((c - b) * (c - a)), before * before / ((c - b) * (d - b))],
            along_s: [-2.0 * behind / ((c - b) * (c - a)), 2.0 * before / ((c - b) * (d - b))],
        }
    }

    /// A quadratic spline whose knots lie half-way between the places, so that its slopes have no jumps: near a place it is a mean of what stands there and at its eight neighbours.
    fn at(&self, &SplineRow { first, along, along_s, .. }: &SplineRow, v: f64) -> [f64; 3] {
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
        let columns = [-1, 0, 1].map(|step| (column + step).rem_euclid(n as isize) as usize);
        let [above, here, below] = first.map(|first| {
            let values = columns.map(|column| self.values[first + column]);
            let ((l, r, middle), (l_v, r_v, _)) = (mixed(values, round), mixed(values, round_v));
            [middle + (l + r), l_v + r_v]
        });
        let ((l, r, t), (l_s, r_s, _)) =
            (mixed([above[0], here[0], below[0]], along), mixed([above[0], here[0], below[0]], along_s));
        let (l_v, r_v, t_v) = mixed([above[1], here[1], below[1]], along);
        [t + (l + r), l_s + r_s, t_v + (l_v + r_v)]
    }
}

/// What a spline of the thickness has in common along a row: where the values of three rows begin, and by how much those before and behind count, with the derivatives of that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SplineRow {
    s: f64,
    first: [usize; 3],
    along: [f64; 2],
    along_s: [f64; 2],
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

/// Points that may stop a ball, stretch by stretch of the surface, and the one that stopped the last.
type Crowds = Vec<(Crowd, Option<DVec3>)>;

fn crowds(skin: &Skin, points: impl Fn(usize) -> Vec<DVec3>) -> Crowds {
    (0..skin.stretches().len()).map(|stretch| (Crowd::new(points(stretch)), None)).collect()
}

/// How thick the wall can be at each place by itself, up to what is asked for.
fn within_balls(
    samples: &[Sample],
    stretches: &[usize],
    columns: usize,
    crowds: &mut Crowds,
    asked: f64,
) -> Result<Vec<f64>> {
    let mut values = Vec::with_capacity(samples.len());
    // By what is next round a corner.
    let mut beside: Vec<[f64; 2]> = Vec::new();
    for (row, stretch) in samples.chunks(columns).zip(stretches) {
        watch::go_on()?;
        for sample in row {
            let most = (asked / SHARE).min(sample.bend);
            let mut by = [most; 2];
            let mut ball = most;
            for (number, (crowd, touched)) in crowds.iter_mut().enumerate() {
                let radius = crowd.ball(sample.position, sample.inward, most, touched);
                match stretch.abs_diff(number) {
                    1 => by[usize::from(number > *stretch)] = radius,
                    _ => ball = ball.min(radius),
                }
            }
            values.push(asked.min(SHARE * ball));
            beside.push(by);
        }
    }
    if crowds.len() > 1 {
        thin_beside_corners(&mut values, &beside, stretches, columns, asked);
    }
    Ok(values)
}

/// Thins what is too close to its neighbour round a corner, but not what lies next to the corner itself: there the wall is mitred, and what would be too close is cut away.
fn thin_beside_corners(values: &mut [f64], beside: &[[f64; 2]], stretches: &[usize], columns: usize, asked: f64) {
    let n_rows = stretches.len();
    for side in [0, 1] {
        for column in 0..columns {
            // Away from the corner.
            let mut is_cut = false;
            let mut before = None;
            for step in 0..n_rows {
                let row = if side == 0 { step } else { n_rows - 1 - step };
                is_cut |= before != Some(stretches[row]);
                before = Some(stretches[row]);
                let place = row * columns + column;
                let radius = SHARE * beside[place][side];
                is_cut &= radius < asked;
                if !is_cut {
                    values[place] = values[place].min(radius);
                }
            }
        }
    }
}

/// The rows, each with the stretch that it is of, and columns of a mesh of the part, and as many more as it takes.
fn rows_and_columns(skin: &Skin, fineness: usize) -> Result<(Vec<(f64, usize)>, usize)> {
    let mut tolerance = FINENESS * skin.size();
    // A mesh far from the origin is finer, because its numbers have fewer digits there. The wall is the same wherever it stands.
    let unmoved = skin.placed().unmoved();
    let (placed, columns) = loop {
        let (placed, columns, _) = places(&unmoved, Some(tolerance))?;
        if placed.len() * columns <= MOST_PLACES {
            break (placed, columns);
        }
        tolerance *= 2.0;
    };
    let (is_upward, n_stretches) = (skin.is_upward(), skin.stretches().len());
    let mut rows = Vec::with_capacity(placed.len());
    for index in 0..n_stretches {
        let number = if is_upward { index } else { n_stretches - 1 - index };
        let [low, high] = [!is_upward, is_upward].map(|is_end| skin.stretches()[number].corner(is_end, is_upward));
        let within = placed.iter().copied().filter(|u| *u - low > APART && high - *u > APART);
        let ends: Vec<f64> = [low].into_iter().chain(within).chain([high]).collect();
        rows.push((low, number));
        for pair in ends.windows(2) {
            let n = (libm::ceil((pair[1] - pair[0]) / WIDEST) as usize).max(1) * fineness;
            rows.extend((1..=n).map(|i| (pair[0] + (pair[1] - pair[0]) * i as f64 / n as f64, number)));
        }
    }
    if !is_upward {
        rows = rows.into_iter().rev().map(|(u, number)| (1.0 - u, number)).collect();
    }
    Ok((rows, (columns - 1).max(COLUMNS) * fineness))
}

fn samples(skin: &Skin, (rows, stretches): (&[f64], &[usize]), columns: usize, direction: f64) -> Vec<Sample> {
    let mut samples = Vec::with_capacity(rows.len() * columns);
    let even = skin.columns(columns);
    let mut walks: Vec<SkinWalk> = skin.stretches().iter().map(|stretch| skin.walk_on(*stretch)).collect();
    for (&s, &stretch) in rows.iter().zip(stretches) {
        let walk = &mut walks[stretch];
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::design::Design;
    use crate::solution::Placed;

    fn skin(parts: &str) -> (Skin, Wall) {
        let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{parts}] }}"#)).unwrap();
        let part = &design.parts()[0];
        (Skin::new(&Arc::new(Placed::new(part, 0).unwrap())).unwrap(), part.wall.unwrap())
    }

    /// Rings with narrow necks, sharp corners and walls up to as thick as half of the pot: what is found on one meridian is what is found all round.
    #[test]
    fn a_meridian_of_a_round_pot_tells_what_all_of_it_does() {
        let mut state = 1u64;
        let mut between = |least: f64, most: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            least + (most - least) * (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let (mut n_plain, mut n_thinned) = (0, 0);
        for round in 0..60 {
            let size = 10f64.powf(between(-3.0, 3.0));
            let rings: Vec<String> = (0..4)
                .map(|i| {
                    let sharp = if i == 1 && round % 3 == 0 { r#", "sharp": true"# } else { "" };
                    let (u, r) = (f64::from(i) / 3.0, between(0.4, 2.0) * size);
                    let z = (2.0 * f64::from(i) + between(-0.6, 0.6)) * size;
                    format!(r#"{{ "u": {u}, "r": {{ "mean": {r} }}, "z": {{ "mean": {z} }}{sharp} }}"#)
                })
                .collect();
            let side = ["inside", "outside"][round % 2];
            let thickness = between(0.02, 1.2) * size;
            let axis = [between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)];
            let (skin, wall) = skin(&format!(
                r#"{{ "shape": {{ "kind": "rings", "rings": [{}] }}, "wall": {{ "thickness": {thickness}, "base": {size}, "side": "{side}" }}, "place": {{ "axis": {axis:?}, "angle": {}, "shift": [{size}, 0, {}] }} }}"#,
                rings.join(", "),
                between(-3.0, 3.0),
                between(-9.0, 9.0) * size,
            ));
            assert!(skin.is_round());
            let direction = if side == "inside" { -1.0 } else { 1.0 };
            let all_round = |factor: f64| {
                let wall = Wall { thickness: factor * thickness, ..wall };
                Thickness::of(&skin, &wall, direction, None).unwrap().0.is_even()
            };
            match Thickness::plain_on_a_meridian(&skin, &wall, direction).unwrap() {
                Some(sought) => {
                    assert!(all_round(1.0), "{round}");
                    assert_eq!(sought.columns, 1);
                    n_plain += 1;
                }
                None => {
                    // What is straight across the axis need not be a place of all round.
                    assert!(!all_round(1.01), "{round}");
                    n_thinned += 1;
                }
            }
        }
        assert!(n_plain > 10 && n_thinned > 10, "{n_plain} {n_thinned}");
    }

    #[test]
    fn what_is_not_round_is_looked_at_all_round() {
        let cup = |r: &str, place: &str| {
            let shape = format!(r#"{{ "kind": "second-order", "r": {r}, "n": [1, 5], "height": 2 }}"#);
            let part =
                format!(r#"{{ "shape": {shape}, "wall": {{ "thickness": 0.1, "base": 0.1 }}, "place": {place} }}"#);
            skin(&part).0.is_round()
        };
        assert!(cup("[1, 0, 0.6, 0]", "{}"));
        assert!(cup("[1, 0, 0.6, 0]", r#"{ "scale": [2, 2, 3] }"#));
        assert!(!cup("[1, 0, 0.6, 0]", r#"{ "scale": [2, 2.001, 3] }"#));
        assert!(!cup("[1, 0.001, 0.6, 0]", "{}"));
    }
}
