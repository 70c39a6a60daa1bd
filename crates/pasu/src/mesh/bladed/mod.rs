//! An octant that thins out towards edges and tips, with triangles that single precision can hold.
//!
//! With an exponent below 1 an octant is like a blade along an edge, and with two of them like a needle at a tip: thinner than a number of seven digits for a tenth of its size. Along the axes that is no harm, because zero is held exactly; of one that is turned or moved, rounding would put its
//! curved side beneath its flat ones. So where it is thinner than a least thickness it gets that: a place of the curved side or of an edge keeps this distance from every plane that it is not in. A blade becomes a plate, and a needle a square rod, of which all places between its edges
//! fall on one line. Those of a row, or round a corner of the grid, are one vertex there, and what has no area left is no triangle. Tips stay where they are.
//!
//! The flat sides need no places within: each is a fan of triangles from the origin, and where it is a needle a strip along its axis.

mod flat_side;
mod octant;
mod vertices;
mod weaver;

use glam::DVec3;

use self::weaver::{Triangle, Weaver};
use super::cleared::height;
use crate::patch::{Lines, deviation_of};
use crate::solution::Placed;
use crate::watch;

/// How thick an octant is at least, in units of what rounding moves a point at most: beside an edge the blade is as much thinner as a point of the flat side is nearer to the edge.
const THICK: f64 = 32.0;

/// A triangle whose corners are moved by one unit keeps its side if it is so many times as high.
const HIGH: f64 = 8.0;

/// No more lines are taken away than this: of those between which triangles are too narrow.
const MOST: usize = 256;

/// After so many it is looked at whether what is left is near enough, which takes as long as to make it again.
const LOOKED_AT: usize = 16;

/// Of a mesh of more vertices none is: all of it is made again for each line, and nobody waits for that.
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

/// An octant on some of the lines of its curved side, so many that no triangle is too narrow; `None` of one that is as thin all over, where lines are in the way that cannot be spared, and where without them it is further from the octant than `most`.
pub(super) fn bladed(placed: &Placed, lines: &[Lines], most: f64) -> Option<Bladed> {
    let mut lines = lines.first()?.clone();
    let unit = rounding(placed);
    let m = placed.matrix();
    let lengths = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length);
    let stretch = DVec3::from_array(lengths);
    if lines.n_vertices() > MOST_VERTICES || !(stretch.min_element() > 4.0 * THICK * unit) {
        return None;
    }
    let curved = placed.solved().patch(0);
    let row = |u: &f64| lines.v.iter().map(|v| stretch * curved.position(*u, *v)).collect();
    let mut grid: Vec<Vec<DVec3>> = lines.u.iter().map(row).collect();
    let mut spared: [Vec<f64>; 3] = Default::default();
    for round in 1..=MOST {
        // With fewer lines it is no nearer.
        if watch::is_stopped() || (round % LOOKED_AT == 0 && deviation(placed, &lines, lengths) > most) {
            return None;
        }
        watch::work(2 * lines.n_vertices() as u64);
        let mesh = Weaver::woven(&grid, &spared, stretch, THICK * unit)?;
        let place = |at: &DVec3| placed.point(*at / stretch);
        let positions: Vec<DVec3> = mesh.places.iter().map(place).collect();
        let narrow = mesh.triangles.iter().filter(|triangle| {
            let [a, b, c] = triangle.corners.map(|vertex| positions[vertex as usize]);
            !(height(a, b, c) >= HIGH * unit)
        });
        let narrow: Vec<&Triangle> = narrow.collect();
        if narrow.is_empty() {
            let bound = bound(deviation(placed, &lines, lengths), &mesh, unit);
            let triangles = by_patch(mesh.triangles, m.determinant() < 0.0);
            return (bound <= most).then_some(Bladed { positions, triangles, bound });
        }
        // A place on an axis is of use to one of the two flat sides and may be in the way on the other.
        let of_axes: Vec<(usize, f64)> = narrow.iter().filter_map(|triangle| triangle.on_axis).collect();
        if !of_axes.is_empty() {
            of_axes.into_iter().for_each(|(axis, at)| spared[axis].push(at));
            continue;
        }
        let mut between = [vec![0usize; lines.u.len()], vec![0; lines.v.len()]];
        let all = narrow.iter().flat_map(|triangle| triangle.between);
        all.flatten().for_each(|(direction, k)| between[direction][k] += 1);
        match in_the_way(&lines, &between)? {
            (0, line) => {
                lines.u.remove(line);
                grid.remove(line);
            }
            (_, line) => {
                lines.v.remove(line);
                grid.iter_mut().for_each(|row| {
                    row.remove(line);
                });
            }
        }
    }
    None
}

/// Of the two lines on both sides of the interval between which most triangles are too narrow, that which is nearer to the one beyond; the first and the last stay.
fn in_the_way(lines: &Lines, between: &[Vec<usize>; 2]) -> Option<(usize, usize)> {
    let mut most: Option<(usize, usize, usize)> = None;
    for (direction, (own, counts)) in [&lines.u, &lines.v].into_iter().zip(between).enumerate() {
        let last = own.len() - 1;
        for (k, n) in counts.iter().copied().enumerate().filter(|(k, n)| *n > 0 && *k < last) {
            let gap = |from: usize| own[from + 1] - own[from];
            let inner = |line: usize| 0 < line && line < last;
            let before = inner(k).then(|| (gap(k - 1), k));
            let after = inner(k + 1).then(|| (gap(k + 1), k + 1));
            let nearer = [after, before].into_iter().flatten().min_by(|one, other| one.0.total_cmp(&other.0));
            if let Some((_, line)) = nearer.filter(|_| own.len() > 3 && most.is_none_or(|(most, ..)| n > most)) {
                most = Some((n, direction, line));
            }
        }
    }
    most.map(|(_, direction, line)| (direction, line))
}

/// How far an octant on these lines is from the true one, but for what is done to blades and for rounding.
fn deviation(placed: &Placed, lines: &Lines, stretch: [f64; 3]) -> f64 {
    let across = |v: &[f64]| Lines { u: vec![0.0, 1.0], v: v.to_vec() };
    let all = [lines.clone(), across(&lines.u), across(&lines.u), across(&lines.v)];
    deviation_of(&placed.solved().patches(), &all, stretch)
}

/// How far a mesh is from the octant at most.
fn bound(grids: f64, mesh: &Weaver, unit: f64) -> f64 {
    // A place is lifted off three planes at most; what falls on a rod was within twice its thickness of the axis both ways, and what slides within a blade stays in that; half a thickness is left to what is so near to its neighbour. Together that is less than six.
    let lift = if mesh.is_lifted { 6.0 * THICK * unit } else { 0.0 };
    grids + lift + 2.0 * unit
}

/// The triangles of each patch, where the octant may be mirrored.
fn by_patch(all: Vec<Triangle>, is_mirrored: bool) -> [Vec<[u32; 3]>; 4] {
    let mut triangles: [Vec<[u32; 3]>; 4] = Default::default();
    for Triangle { corners: [a, b, c], patch, .. } in all {
        triangles[patch].push(if is_mirrored { [a, c, b] } else { [a, b, c] });
    }
    triangles
}
