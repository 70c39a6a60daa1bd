//! One part of a design on its grid.

use core::fmt::Write;

use glam::{DMat3, DVec3};

use super::contract::{Mesh, MeshOptions};
use super::grid::append_triangles;
use super::profile::Profile;
use super::tolerance::Tessellation;
use crate::error::Result;
use crate::solution::Placed;
use crate::surface::{Curves, Surface, is_outward};

/// One part, ready to be sampled.
pub(super) struct PartGrid<'a> {
    pub(super) surface: &'a Surface,
    pub(super) tessellation: Tessellation,
    /// Whether every sum is to be formed in double precision.
    pub(super) is_precise: bool,
    pub(super) matrix: DMat3,
    pub(super) shift: DVec3,
    /// Whether `X_u x X_v` points away from the inside, before placement.
    is_outward: bool,
    pub(super) curves: Curves,
    /// The number of the part.
    pub(super) index: usize,
}

impl<'a> PartGrid<'a> {
    /// Chooses the grid of a part whose shape is this series; `curves` are those of any other mesh, whose memory is used again.
    pub(super) fn choose(
        placed: &'a Placed,
        surface: &'a Surface,
        options: &MeshOptions,
        is_bounded: bool,
        mut curves: Curves,
    ) -> Result<PartGrid<'a>> {
        let (matrix, shift) = (placed.matrix(), placed.shift());
        // A tolerance that is asked for is held to the rounding of single precision itself.
        let is_precise = options.tolerance.is_some();
        let tessellation = Tessellation::choose(
            || Profile::of(surface, matrix),
            &surface.stops(),
            shift.length(),
            options,
            is_precise,
            is_bounded,
        )?;
        curves.prepare(surface, tessellation.along);
        let is_outward = is_outward(surface, &curves);
        Ok(PartGrid { surface, tessellation, is_precise, matrix, shift, is_outward, curves, index: placed.index() })
    }

    /// The rows behind which the next is the same curve seen from the other side of a corner: there is nothing between the two.
    fn seams(&self) -> impl Iterator<Item = usize> + '_ {
        let rows = self.tessellation.rows.iter().flat_map(|rows| rows.windows(2).enumerate());
        rows.filter(|(_, pair)| pair[0].next_up() == pair[1]).map(|(index, _)| index)
    }

    /// Puts the two rows of a corner on each other to the bit.
    pub(super) fn join(&self, positions: &mut [f32]) {
        let (_, columns) = self.tessellation.counts();
        for row in self.seams() {
            positions.copy_within(3 * (row + 1) * columns..3 * (row + 2) * columns, 3 * row * columns);
        }
    }

    /// Its expansions, when it has been sampled.
    pub(super) fn into_curves(self) -> Curves {
        self.curves
    }

    /// The `u` of every row, the number of columns with the one that repeats the first, and the bound that such a grid keeps.
    pub(super) fn places(&self) -> (Vec<f64>, usize, Option<f64>) {
        let (rows, columns) = self.tessellation.counts();
        ((0..rows).map(|i| self.tessellation.row(i)).collect(), columns, self.tessellation.bound)
    }

    pub(super) fn n_vertices(&self) -> usize {
        let (rows, columns) = self.tessellation.counts();
        rows * columns
    }

    /// Names the grid and its winding.
    pub(super) fn append_topology(&self, topology: &mut String) {
        let (rows, columns) = self.tessellation.counts();
        let winding = if self.is_wound_forwards() { '+' } else { '-' };
        // A String takes whatever is written to it.
        let _ = write!(topology, "{rows}x{columns}{winding}");
        if let Some(places) = self.tessellation.hash() {
            let _ = write!(topology, "{places:016x}");
        }
    }

    /// Whether triangles go round as `X_u x X_v` does.
    pub(super) fn is_wound_forwards(&self) -> bool {
        self.is_outward != (self.matrix.determinant() < 0.0)
    }

    /// What turns `X_u x X_v` outward.
    pub(super) fn sign(&self) -> f64 {
        if self.is_wound_forwards() { 1.0 } else { -1.0 }
    }

    /// Appends what depends on the grid alone, and room for positions and normals.
    pub(super) fn append_to(&self, mesh: &mut Mesh) {
        let (rows, columns) = self.tessellation.counts();
        let base = mesh.n_vertices() as u32;
        mesh.positions.resize(mesh.positions.len() + 3 * rows * columns, 0.0);
        mesh.normals.resize(mesh.normals.len() + 3 * rows * columns, 0.0);
        mesh.uvs.reserve(2 * rows * columns);
        for i in 0..rows {
            let u = self.tessellation.row(i) as f32;
            mesh.uvs.extend((0..columns).flat_map(|j| [u, (j as f64 / (columns - 1) as f64) as f32]));
        }
        let first = mesh.indices.len() as u32;
        let is_wound_forwards = self.is_wound_forwards();
        let mut from = 0;
        for seam in self.seams().chain([rows - 1]) {
            let base = base + (from * columns) as u32;
            append_triangles(&mut mesh.indices, base, (seam + 1 - from) as u32, columns as u32, is_wound_forwards);
            from = seam + 1;
        }
        mesh.groups.extend_from_slice(&[first, mesh.indices.len() as u32 - first, self.index as u32]);
    }
}
