//! Points of the curved side of an octant, kept off its flat sides by as much as single precision tells.
//!
//! An octant with an exponent below 1 thins out towards edges like a blade: along one it may be thinner than a number of seven digits for a hundredth of its size. Along the axes that is no harm, because zero is held exactly; of one that is turned or moved, rounding would put its
//! curved side beneath its flat ones. So what is nearer to a flat side than rounding allows goes off it by that, within the curved side; its edges stay where they are.

use glam::DVec3;

use crate::patch::Lines;
use crate::solution::Placed;

/// A point is kept off a flat side by so many times what rounding moves one at most: beside an edge the blade is as much thinner as a point of the flat side is nearer to the edge.
#[cfg(feature = "patchwork")]
const SAFE: f64 = 32.0;

/// Moves the positions of all lines of an octant that are too near to one of its flat sides; says how far one was moved at most, 0 where none was and for what is no octant.
#[cfg(feature = "patchwork")]
pub(super) fn lifted(placed: &Placed, lines: &[Lines], positions: &mut [DVec3]) -> f64 {
    let (Some(_), Some(Lines { u, v })) = (placed.solved().octant(), lines.first()) else { return 0.0 };
    let largest = positions.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
    let least = SAFE * 0.5 * f64::from(f32::EPSILON) * libm::sqrt(3.0) * largest;
    let (curved, m) = (placed.solved().patch(0), placed.matrix());
    let mut most = 0.0f64;
    // The first and the last of both are edges, which the flat sides share.
    let inner = |all: &[f64]| 1..all.len().saturating_sub(1);
    for i in inner(u) {
        for j in inner(v) {
            let own = curved.position(u[i], v[j]).to_array();
            let missing = |axis: DVec3, from: f64| axis * (least / axis.length() - from).max(0.0);
            let lift = [m.x_axis, m.y_axis, m.z_axis]
                .into_iter()
                .zip(own)
                .map(|(axis, from)| missing(axis, from))
                .sum::<DVec3>();
            positions[i * v.len() + j] += lift;
            most = most.max(lift.length());
        }
    }
    most
}

#[cfg(not(feature = "patchwork"))]
pub(super) fn lifted(_: &Placed, _: &[Lines], _: &mut [DVec3]) -> f64 {
    0.0
}
