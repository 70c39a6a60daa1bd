//! Faces as B-spline surfaces within a tolerance.

use std::f64::consts::TAU;

use glam::DVec3;

use super::columns::{Columns, between, halved};
use super::exchange::settled;
use super::spline::{Ends, basis, control_points};
use crate::error::Result;
use crate::face::{Face, FaceWalk};
use crate::watch;

/// The rows that a face begins with.
const FIRST_ROWS: usize = 2;
/// At most so many nodes in a direction: one that needs more has creases, which no spline of its kind follows.
const MOST_ROWS: usize = 257;
const MOST_COLUMNS: usize = 769;
/// Within an interval each direction is measured here while it is being refined,
const PROBES: [f64; 3] = [0.25, 0.5, 0.75];
/// and with so many samples in each direction at last, of which none is at a node; with fewer where there are many intervals.
const SAMPLES: [usize; 2] = [5, 3];
const MANY: usize = 10_000;
/// The part of the tolerance that each direction may use.
const SHARE: f64 = 0.4;
/// The bends of a face that is not exact jump where its thickness has knots, which are no part of the pot: it is followed so many times less closely, and with fewer nodes.
const INEXACT: f64 = 10.0;
const MOST_ROWS_INEXACT: usize = 129;
const MOST_COLUMNS_INEXACT: usize = 513;

/// The faces of one solid as splines, with common columns: neighbours that share a boundary curve have the same boundary row.
pub(super) struct Fitted {
    /// The nodes in `v`.
    pub(super) columns: Columns,
    pub(super) faces: Vec<Net>,
    /// The largest distance found between a point of a spline and the point of its face with the same parameters, millimetres.
    pub(super) deviation: f64,
    /// `deviation`, and what the slope of the difference can add between two samples.
    pub(super) bound: f64,
    /// The number of points compared.
    pub(super) n_samples: usize,
}

/// The control points of one face.
pub(super) struct Net {
    /// The nodes in `a`, from 0 to 1.
    pub(super) rows: Vec<f64>,
    /// Row by row, `rows.len() + 2` of them with the control points of [`Columns`] each.
    pub(super) control: Vec<Vec<DVec3>>,
}

/// Fits all faces. `boundaries[face]` tells for each end `a = 0`, `a = 1` from which face and end its row is taken: two neighbours take it from the same.
///
/// Interpolates positions on a grid, and derivatives in `a` at both ends, by cubic splines in both directions, in `v` closed or from one of `cuts` to the next; halves the intervals where one direction
/// by itself is off by more than its share of the tolerance, until none is. A pole stays one point.
///
/// # Errors
/// `cancelled`.
pub(super) fn fit(faces: &[Scaled], boundaries: &[[Boundary; 2]], cuts: &[f64], tolerance: f64) -> Result<Fitted> {
    let mut columns = Columns::first(cuts);
    let mut rows = vec![(0..FIRST_ROWS).map(|i| i as f64 / (FIRST_ROWS - 1) as f64).collect::<Vec<_>>(); faces.len()];
    loop {
        let edges: Vec<[Vec<DVec3>; 2]> = (0..faces.len())
            .map(|face| [0, 1].map(|end| boundary_points(faces, boundaries[face][end], &columns.nodes)))
            .collect();
        let nets: Vec<Net> =
            faces.iter().zip(&rows).zip(&edges).map(|((face, rows), edges)| net(face, rows, &columns, edges)).collect();
        let mut rough_columns = vec![false; columns.n_intervals()];
        let mut is_done = true;
        for ((face, net), rows) in faces.iter().zip(&nets).zip(&mut rows) {
            let share = SHARE * face.looseness() * tolerance;
            let [most_rows, most_columns] = match face.face.is_exact() {
                true => [MOST_ROWS, MOST_COLUMNS],
                false => [MOST_ROWS_INEXACT, MOST_COLUMNS_INEXACT],
            };
            let rough_rows = rough_rows(face, net, &columns, share);
            is_done &= !halved(rows, &rough_rows, most_rows);
            if columns.nodes.len() < most_columns {
                mark_rough_columns(face, net, &columns, share, &mut rough_columns);
            }
        }
        is_done &= !columns.halve(&rough_columns, MOST_COLUMNS);
        watch::go_on()?;
        if is_done {
            return measured(faces, columns, nets);
        }
    }
}

/// A face in millimetres.
pub(super) struct Scaled<'a> {
    pub(super) face: &'a dyn Face,
    pub(super) millimetres: f64,
}

impl Scaled<'_> {
    pub(super) fn position(&self, a: f64, v: f64) -> DVec3 {
        self.walk().position(a, v)
    }

    /// How many times the tolerance it is followed within.
    pub(super) fn looseness(&self) -> f64 {
        if self.face.is_exact() { 1.0 } else { INEXACT }
    }

    /// One place after the other.
    pub(super) fn walk(&self) -> ScaledWalk<'_> {
        ScaledWalk { walk: self.face.walk(), millimetres: self.millimetres }
    }
}

/// Places of one row after the other, which share what depends on it alone.
pub(super) struct ScaledWalk<'a> {
    walk: Box<dyn FaceWalk + 'a>,
    millimetres: f64,
}

impl ScaledWalk<'_> {
    pub(super) fn position(&mut self, a: f64, v: f64) -> DVec3 {
        self.millimetres * self.walk.jet(a, around(v)).position
    }

    fn slope(&mut self, a: f64, v: f64) -> DVec3 {
        self.millimetres * self.walk.jet(a, around(v)).da
    }
}

/// The last column is the first one.
pub(super) fn around(v: f64) -> f64 {
    if v >= TAU { v - TAU } else { v }
}

/// Where the points of an end of a face come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Boundary {
    /// The boundary curve of a face, at its end 0 or 1.
    Curve { face: usize, end: usize },
    /// One point.
    Pole { face: usize, end: usize },
}

fn boundary_points(faces: &[Scaled], boundary: Boundary, columns: &[f64]) -> Vec<DVec3> {
    let rounded = |point: DVec3| DVec3::from_array(point.to_array().map(settled));
    match boundary {
        Boundary::Curve { face, end } => {
            let mut walk = faces[face].walk();
            columns.iter().map(|v| walk.position(end as f64, *v)).collect()
        }
        Boundary::Pole { face, end } => vec![rounded(faces[face].position(end as f64, 0.0)); columns.len()],
    }
}

fn net(face: &Scaled, rows: &[f64], columns: &Columns, edges: &[Vec<DVec3>; 2]) -> Net {
    let last = rows.len() - 1;
    let mut walk = face.walk();
    let along_v = |points: &[DVec3]| columns.control_points(points);
    let points: Vec<Vec<DVec3>> = rows
        .iter()
        .enumerate()
        .map(|(i, a)| match i {
            0 => along_v(&edges[0]),
            i if i == last => along_v(&edges[1]),
            _ => along_v(&columns.nodes.iter().map(|v| walk.position(*a, *v)).collect::<Vec<_>>()),
        })
        .collect();
    let slopes = [0.0, 1.0].map(|a| along_v(&columns.nodes.iter().map(|v| walk.slope(a, *v)).collect::<Vec<_>>()));
    let width = points[0].len();
    let mut control = vec![Vec::with_capacity(width); rows.len() + 2];
    for j in 0..width {
        let column: Vec<DVec3> = points.iter().map(|row| row[j]).collect();
        let spline = control_points(rows, &column, &Ends::Slopes(slopes[0][j], slopes[1][j]));
        for (row, point) in control.iter_mut().zip(spline) {
            row.push(DVec3::from_array(point.to_array().map(settled)));
        }
    }
    Net { rows: rows.to_vec(), control }
}

/// Which intervals of rows are off by more than their share, along the columns.
fn rough_rows(face: &Scaled, net: &Net, columns: &Columns, share: f64) -> Vec<bool> {
    let mut walk = face.walk();
    (0..net.rows.len() - 1)
        .map(|interval| {
            PROBES.iter().any(|part| {
                let a = between(&net.rows, interval, *part);
                let row = net.row(interval, a);
                (0..columns.n_intervals()).any(|j| {
                    let v = columns.nodes[j];
                    let (found, _) = columns.point(&row.0, j, v);
                    !((found - walk.position(a, v)).length() <= share)
                })
            })
        })
        .collect()
}

/// Which intervals of columns are off by more than their share, along the rows.
fn mark_rough_columns(face: &Scaled, net: &Net, columns: &Columns, share: f64, rough: &mut [bool]) {
    let mut walk = face.walk();
    for (i, a) in net.rows.iter().enumerate() {
        let row = net.row(i.min(net.rows.len() - 2), *a);
        for (j, rough) in rough.iter_mut().enumerate().filter(|(_, rough)| !**rough) {
            *rough = PROBES.iter().any(|part| {
                let v = between(&columns.nodes, j, *part);
                let (found, _) = columns.point(&row.0, j, v);
                !((found - walk.position(*a, v)).length() <= share)
            });
        }
    }
}

fn measured(faces: &[Scaled], columns: Columns, nets: Vec<Net>) -> Result<Fitted> {
    let (mut deviation, mut bound, mut n_samples) = (0.0f64, 0.0f64, 0);
    for (face, net) in faces.iter().zip(&nets) {
        let mut walk = face.face.walk();
        let samples = SAMPLES[usize::from((net.rows.len() - 1) * columns.n_intervals() > MANY)];
        let part = |p: usize| (p as f64 + 0.5) / samples as f64;
        let cells = 0..columns.n_intervals();
        let sampled = cells.flat_map(|j| (0..samples).map(move |q| (j, q)));
        let sampled = face.face.columns(sampled.map(|(j, q)| around(between(&columns.nodes, j, part(q)))).collect());
        for i in 0..net.rows.len() - 1 {
            watch::go_on()?;
            let half_a = (net.rows[i + 1] - net.rows[i]) / (2 * samples) as f64;
            for p in 0..samples {
                let a = between(&net.rows, i, part(p));
                let (row, row_slopes) = net.row(i, a);
                for j in 0..columns.n_intervals() {
                    let half_v = (columns.nodes[j + 1] - columns.nodes[j]) / (2 * samples) as f64;
                    for q in 0..samples {
                        let column = j * samples + q;
                        let v = between(&columns.nodes, j, part(q));
                        let (found, found_dv) = columns.point(&row, j, v);
                        let (found_da, _) = columns.point(&row_slopes, j, v);
                        let jet = walk.jet_at(a, &sampled, column);
                        let off = (found - face.millimetres * jet.position).length();
                        let along_a = (found_da - face.millimetres * jet.da).length() * half_a;
                        let along_v = (found_dv - face.millimetres * jet.dv).length() * half_v;
                        deviation = deviation.max(off);
                        bound = bound.max(off + along_a + along_v);
                        n_samples += 1;
                    }
                }
            }
        }
    }
    Ok(Fitted { columns, faces: nets, deviation, bound, n_samples })
}

impl Net {
    /// The control points in `v` of the curve at `a`, in an interval of rows, and those of its derivative in `a`.
    fn row(&self, interval: usize, a: f64) -> (Vec<DVec3>, Vec<DVec3>) {
        let weights = basis(&self.rows, interval, a);
        let width = self.control[0].len();
        let mut row = (vec![DVec3::ZERO; width], vec![DVec3::ZERO; width]);
        for (r, (value, slope)) in weights.into_iter().enumerate() {
            for (j, control) in self.control[interval + r].iter().enumerate() {
                row.0[j] += value * control;
                row.1[j] += slope * control;
            }
        }
        row
    }
}
