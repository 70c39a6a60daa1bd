//! One patch as a B-spline surface within a tolerance.

use glam::DVec3;

use super::exchange::settled;
use super::spline::{Ends, basis, control_points};
use crate::patch::SurfaceJet;

/// Within an interval each direction is compared here while it is being refined.
const PROBES: [f64; 3] = [0.25, 0.5, 0.75];

/// The control points of a patch over its nodes in `u` and in `v`, from 0 to 1: row by row two more in each direction than there are nodes.
pub(super) struct PatchNet {
    pub(super) u: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) control: Vec<Vec<DVec3>>,
}

impl PatchNet {
    /// Interpolates positions on the grid of nodes, the derivatives across every side and the twist at every corner: a cubic spline in both directions.
    pub(super) fn through(u: &[f64], v: &[f64], at: &dyn Fn(f64, f64) -> SurfaceJet) -> PatchNet {
        let ends = [0.0, 1.0];
        // A curve along v of constant u, and how it changes with u.
        let curve = |place: f64| {
            let jets: Vec<SurfaceJet> = v.iter().map(|v| at(place, *v)).collect();
            let [start, end] = [&jets[0], &jets[jets.len() - 1]];
            let spline = |of: fn(&SurfaceJet) -> DVec3, slope: fn(&SurfaceJet) -> DVec3| {
                let points: Vec<DVec3> = jets.iter().map(of).collect();
                control_points(v, &points, &Ends::Slopes(slope(start), slope(end)))
            };
            [spline(|jet| jet.position, |jet| jet.dv), spline(|jet| jet.du, |jet| jet.duv)]
        };
        let points: Vec<Vec<DVec3>> = u.iter().map(|u| curve(*u)).map(|[points, _]| points).collect();
        let [start, end] = ends.map(curve).map(|[_, slopes]| slopes);
        let mut control = vec![Vec::with_capacity(v.len() + 2); u.len() + 2];
        for j in 0..v.len() + 2 {
            let column: Vec<DVec3> = points.iter().map(|row| row[j]).collect();
            let spline = control_points(u, &column, &Ends::Slopes(start[j], end[j]));
            for (row, point) in control.iter_mut().zip(spline) {
                row.push(DVec3::from_array(point.to_array().map(settled)));
            }
        }
        PatchNet { u: u.to_vec(), v: v.to_vec(), control }
    }

    /// The intervals of nodes along `u` and along `v` that are off by more than a distance where only that direction is interpolated, or by twice as much where both are.
    pub(super) fn rough(&self, at: &dyn Fn(f64, f64) -> SurfaceJet, distance: f64) -> [Vec<usize>; 2] {
        let is_off = |(i, u): (usize, f64), (j, v): (usize, f64)| {
            !((self.position((i, u), (j, v)) - at(u, v).position).length() <= distance)
        };
        let between = |nodes: &[f64], i: usize, part: f64| nodes[i] + part * (nodes[i + 1] - nodes[i]);
        let node = |nodes: &[f64], i: usize| (i.min(nodes.len() - 2), nodes[i]);
        let rows = (0..self.u.len() - 1).filter(|&i| {
            PROBES.iter().any(|part| {
                let u = (i, between(&self.u, i, *part));
                (0..self.v.len()).any(|j| is_off(u, node(&self.v, j)))
            })
        });
        let columns = (0..self.v.len() - 1).filter(|&j| {
            PROBES.iter().any(|part| {
                let v = (j, between(&self.v, j, *part));
                (0..self.u.len()).any(|i| is_off(node(&self.u, i), v))
            })
        });
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = (rows.collect(), columns.collect());
        if rows.is_empty() && columns.is_empty() {
            // What swells between nodes and is flat on all of their lines is seen in the middle of cells alone.
            let cells = (0..self.u.len() - 1).flat_map(|i| (0..self.v.len() - 1).map(move |j| (i, j)));
            for (i, j) in cells {
                let places = PROBES.iter().flat_map(|p| PROBES.iter().map(move |q| (*p, *q)));
                let mut places = places.map(|(p, q)| (between(&self.u, i, p), between(&self.v, j, q)));
                if places
                    .any(|(u, v)| !((self.position((i, u), (j, v)) - at(u, v).position).length() <= 2.0 * distance))
                {
                    rows.push(i);
                    columns.push(j);
                }
            }
        }
        [rows, columns]
    }

    /// The point at a place in an interval along `u` and one along `v`.
    fn position(&self, (i, u): (usize, f64), (j, v): (usize, f64)) -> DVec3 {
        let (across, along) = (basis(&self.v, j, v), basis(&self.u, i, u));
        let row = |r: usize| (0..4).map(|q| across[q].0 * self.control[i + r][j + q]).sum::<DVec3>();
        (0..4).map(|r| along[r].0 * row(r)).sum()
    }

    /// The largest distance at so many places in each direction of every interval, none of them at a node, and how many that were.
    pub(super) fn deviation(&self, at: &dyn Fn(f64, f64) -> SurfaceJet, samples: usize) -> (f64, usize) {
        let places = |nodes: &[f64]| -> Vec<(usize, f64)> {
            let of = |i: usize| {
                let (from, step) = (nodes[i], (nodes[i + 1] - nodes[i]) / samples as f64);
                (0..samples).map(move |k| (i, from + (k as f64 + 0.5) * step))
            };
            (0..nodes.len() - 1).flat_map(of).collect()
        };
        let (rows, columns) = (places(&self.u), places(&self.v));
        let pairs = rows.iter().flat_map(|u| columns.iter().map(move |v| (*u, *v)));
        let off = pairs.map(|(u, v)| (self.position(u, v) - at(u.1, v.1).position).length());
        (off.fold(0.0, f64::max), rows.len() * columns.len())
    }
}
