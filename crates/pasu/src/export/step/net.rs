//! One patch as a B-spline surface within a tolerance.

use glam::DVec3;

use super::columns::between;
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

/// How far a spline is from its patch.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Deviation {
    /// The largest distance between points of both with the same parameters.
    pub(super) greatest: f64,
    /// The same, and what the slope of the difference can add between two samples.
    pub(super) bound: f64,
    pub(super) n_samples: usize,
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
    fn position(&self, along_u: (usize, f64), along_v: (usize, f64)) -> DVec3 {
        let [point, ..] = self.jet(along_u, along_v);
        point
    }

    /// As [`Self::position`], with its derivatives in `u` and in `v`.
    fn jet(&self, (i, u): (usize, f64), (j, v): (usize, f64)) -> [DVec3; 3] {
        let (across, along) = (basis(&self.v, j, v), basis(&self.u, i, u));
        let mut jet = [DVec3::ZERO; 3];
        for (r, (value, slope)) in along.into_iter().enumerate() {
            let row = |of: fn(&(f64, f64)) -> f64| -> DVec3 {
                across.iter().enumerate().map(|(q, weights)| of(weights) * self.control[i + r][j + q]).sum()
            };
            let here = row(|(value, _)| *value);
            jet[0] += value * here;
            jet[1] += slope * here;
            jet[2] += value * row(|(_, slope)| *slope);
        }
        jet
    }

    /// Compares it with the patch at so many places in each direction of every interval, none of them at a node.
    pub(super) fn deviation(&self, at: &dyn Fn(f64, f64) -> SurfaceJet, samples: usize) -> Deviation {
        let places = |nodes: &[f64]| -> Vec<(usize, f64, f64)> {
            let of = |i: usize| {
                let (from, step) = (nodes[i], (nodes[i + 1] - nodes[i]) / samples as f64);
                (0..samples).map(move |k| (i, from + (k as f64 + 0.5) * step, 0.5 * step))
            };
            (0..nodes.len() - 1).flat_map(of).collect()
        };
        let (rows, columns) = (places(&self.u), places(&self.v));
        let mut told = Deviation { n_samples: rows.len() * columns.len(), ..Deviation::default() };
        for (i, u, half_u) in &rows {
            for (j, v, half_v) in &columns {
                let ([point, du, dv], exact) = (self.jet((*i, *u), (*j, *v)), at(*u, *v));
                let off = (point - exact.position).length();
                let slopes = half_u * (du - exact.du).length() + half_v * (dv - exact.dv).length();
                told.greatest = told.greatest.max(off);
                told.bound = told.bound.max(off + slopes);
            }
        }
        told
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A patch that no cubic is.
    fn wave(u: f64, v: f64) -> SurfaceJet {
        let (s, c, e) = (libm::sin(3.0 * u), libm::cos(3.0 * u), libm::exp(v));
        SurfaceJet {
            position: DVec3::new(u, v, s * e),
            du: DVec3::new(1.0, 0.0, 3.0 * c * e),
            dv: DVec3::new(0.0, 1.0, s * e),
            duu: DVec3::new(0.0, 0.0, -9.0 * s * e),
            duv: DVec3::new(0.0, 0.0, 3.0 * c * e),
            dvv: DVec3::new(0.0, 0.0, s * e),
        }
    }

    #[test]
    fn no_place_is_farther_off_than_the_bound() {
        for nodes in [3, 5, 9] {
            let line: Vec<f64> = (0..nodes).map(|i| f64::from(i) / f64::from(nodes - 1)).collect();
            let net = PatchNet::through(&line, &line, &wave);
            let Deviation { greatest, bound, n_samples } = net.deviation(&wave, 5);
            assert_eq!(n_samples, 25 * (line.len() - 1) * (line.len() - 1));
            let mut farthest = 0.0f64;
            for (i, j) in (0..=240).flat_map(|i| (0..=240).map(move |j| (i, j))) {
                let [u, v] = [i, j].map(|k| f64::from(k) / 240.0);
                let interval = |x: f64| line.windows(2).position(|pair| x <= pair[1]).unwrap();
                let off = net.position((interval(u), u), (interval(v), v)) - wave(u, v).position;
                farthest = farthest.max(off.length());
            }
            assert!(
                greatest <= farthest && farthest <= bound && bound < 3.0 * farthest,
                "{greatest} {farthest} {bound}"
            );
        }
    }
}
