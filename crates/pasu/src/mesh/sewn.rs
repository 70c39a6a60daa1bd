//! The grids of patches as one mesh, with one vertex for each point.

use glam::DVec3;

use super::grid::append_patch;
use super::seams::Seams;
use crate::patch::{Lines, Spread};
use crate::solution::Placed;

/// The cell of a triangle: its patch, and its place among the cells of that.
pub(super) type InCell = (usize, usize);

/// Places of all lines, and triangles that share their vertices, each with its cell.
pub(super) type Sewn = (Vec<DVec3>, Vec<([u32; 3], InCell)>);

/// The grids as one mesh.
pub(super) fn sewn(placed: &Placed, lines: &[Lines]) -> Sewn {
    let patches = placed.solved().patches();
    let firsts = firsts(lines);
    let number = Seams { patches: &patches, lines, firsts: &firsts }.numbers();
    let (mut positions, mut triangles) = (Vec::with_capacity(number.len()), Vec::new());
    for (index, (patch, Lines { u, v })) in patches.iter().zip(lines).enumerate() {
        let columns = patch.columns(Spread::At(v));
        for u in u {
            let row = patch.row(*u);
            positions.extend((0..v.len()).map(|j| placed.place(&row.jet_at(&columns, j)).position));
        }
        let mut indices = Vec::new();
        append_patch(&mut indices, firsts[index] as u32, u.len() as u32, v.len() as u32, placed.is_forwards(index));
        let corners = indices.as_chunks::<3>().0.iter().map(|corners| corners.map(|vertex| number[vertex as usize]));
        // Two of each cell, but that along a pole every other triangle has no width.
        let numbered = corners.enumerate().map(|(triangle, corners)| (corners, (index, triangle / 2)));
        triangles.extend(numbered.filter(|([a, b, c], _)| a != b && b != c && c != a));
    }
    (positions, triangles)
}

/// The first vertex of each grid.
pub(super) fn firsts(lines: &[Lines]) -> Vec<usize> {
    let mut next = 0;
    let first = |lines: &Lines| {
        next += lines.n_vertices();
        next - lines.n_vertices()
    };
    lines.iter().map(first).collect()
}
