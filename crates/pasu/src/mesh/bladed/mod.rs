//! An octant that thins out towards edges and tips, with triangles that single precision can hold.
//!
//! With an exponent below 1 an octant is like a blade along an edge, and with two of them like a needle at a tip: thinner than a number of seven digits for a tenth of its size. Along the axes that is no harm, because zero is held exactly; of one that is turned or moved, rounding would put its
//! curved side beneath its flat ones. So where it is thinner than a least thickness it gets that: a place of the curved side or of an edge keeps this distance from every plane that it is not in. A blade becomes a plate, and a needle a square rod, of which all places between its edges
//! fall on one line. Those of a row, or round a corner of the grid, are one vertex there, and what has no area left is no triangle. Tips stay where they are.
//!
//! Triangles that are too narrow all the same are done away with one by one (`narrow.rs`), and how far that moves a point is in the bound.
//!
//! The flat sides need no places within: each is a fan of triangles from the origin, and where it is a needle a strip along its axis.

mod apart;
mod flat_side;
mod narrow;
mod octant;
mod vertices;
mod weaver;

use glam::DVec3;

use self::weaver::{Triangle, Weaver};
use crate::patch::{Lines, deviation_of};
use crate::solution::Placed;
use crate::watch;

/// How thick an octant is at least, in units of what rounding moves a point at most: beside an edge the blade is as much thinner as a point of the flat side is nearer to the edge.
const THICK: f64 = 32.0;

/// A triangle whose corners are moved by one unit keeps its side if it is so many times as high.
const HIGH: f64 = 8.0;

/// Of a mesh of more vertices none is looked for: nobody waits for that.
const MOST_VERTICES: usize = 1 << 16;

/// What rounding to single precision moves a point of a placed octant at most.
fn rounding(placed: &Placed) -> f64 {
    let corners = (0..8).map(|k| placed.point(DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2))));
    0.5 * f64::from(f32::EPSILON) * libm::sqrt(3.0) * corners.fold(0.0, |most, at| at.abs().max_element().max(most))
}

/// The mesh, by patch, and how far from the octant it is at most.
pub(super) struct Bladed {
    pub(super) positions: Vec<DVec3>,
    /// Of each patch.
    pub(super) triangles: [Vec<[u32; 3]>; 4],
    pub(super) bound: f64,
}

/// An octant on the lines of its curved side, without triangles that are too narrow; `None` of one that is as thin all over, where such triangles cannot be spared, and where without them it is further from the octant than `most`.
pub(super) fn bladed(placed: &Placed, lines: &[Lines], most: f64) -> Option<Bladed> {
    let lines = lines.first()?;
    let unit = rounding(placed);
    let m = placed.matrix();
    let lengths = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length);
    let stretch = DVec3::from_array(lengths);
    if lines.n_vertices() > MOST_VERTICES || !(stretch.min_element() > 4.0 * THICK * unit) {
        return None;
    }
    let off = deviation(placed, lines, lengths);
    if watch::is_stopped() || !(off <= most) {
        return None;
    }
    watch::work(4 * lines.n_vertices() as u64);
    let curved = placed.solved().patch(0);
    let row = |u: &f64| lines.v.iter().map(|v| stretch * curved.position(*u, *v)).collect();
    let grid: Vec<Vec<DVec3>> = lines.u.iter().map(row).collect();
    let mut mesh = Weaver::woven(&grid, stretch, THICK * unit)?;
    let drift = mesh.without_narrow(HIGH * unit, most - off)?;
    let bound = bound(off, &mesh, unit) + drift;
    let positions = mesh.places.iter().map(|at| placed.point(*at / stretch)).collect();
    let triangles = by_patch(mesh.triangles, m.determinant() < 0.0);
    (bound <= most).then_some(Bladed { positions, triangles, bound })
}

/// How far an octant on these lines is from the true one, but for what is done to blades and for rounding.
fn deviation(placed: &Placed, lines: &Lines, stretch: [f64; 3]) -> f64 {
    let across = |v: &[f64]| Lines { u: vec![0.0, 1.0], v: v.to_vec() };
    let all = [lines.clone(), across(&lines.u), across(&lines.u), across(&lines.v)];
    deviation_of(&placed.solved().patches(), &all, stretch)
}

/// How far a mesh is from the octant at most, but for what doing away with narrow triangles moves.
fn bound(grids: f64, mesh: &Weaver, unit: f64) -> f64 {
    // A place is lifted off three planes at most; what falls on a rod was within twice its thickness of the axis both ways, and what slides within a blade stays in that; half a thickness is left to what is so near to its neighbour. Together that is less than six.
    let lift = if mesh.is_lifted { 6.0 * THICK * unit } else { 0.0 };
    grids + lift + 2.0 * unit
}

/// The triangles of each patch, where the octant may be mirrored.
fn by_patch(all: Vec<Triangle>, is_mirrored: bool) -> [Vec<[u32; 3]>; 4] {
    let mut triangles: [Vec<[u32; 3]>; 4] = Default::default();
    for Triangle { corners: [a, b, c], patch } in all {
        triangles[patch].push(if is_mirrored { [a, c, b] } else { [a, b, c] });
    }
    triangles
}
