//! The grid, or grids, of one part.

use super::contract::{Mesh, MeshOptions};
use super::fill::Workspace;
use super::part::PartGrid;
use super::patches::PatchGrids;
use crate::error::Result;
use crate::solution::Placed;
use crate::surface::Curves;

/// A part, ready to be sampled: a Fourier series by the kernel, anything else patch by patch.
pub(super) enum Grids<'a> {
    Fourier(PartGrid<'a>),
    Patches(PatchGrids<'a>),
}

impl<'a> Grids<'a> {
    /// Chooses the grid of a part; `spare` are curves of any other mesh, whose memory is used again.
    ///
    /// # Errors
    /// `tolerance-too-fine`, `too-large`.
    pub(super) fn choose(
        placed: &'a Placed,
        options: &MeshOptions,
        is_bounded: bool,
        spare: &mut Vec<Curves>,
    ) -> Result<Grids<'a>> {
        Ok(match placed.solved().fourier() {
            Some(surface) => {
                let curves = spare.pop().unwrap_or_default();
                Grids::Fourier(PartGrid::choose(placed, surface, options, is_bounded, curves)?)
            }
            None => Grids::Patches(PatchGrids::choose(placed, options, is_bounded)?),
        })
    }

    /// Patches cut into so many pieces between their knots, both ways.
    pub(super) fn pieces(placed: &'a Placed, pieces: usize) -> Grids<'a> {
        Grids::Patches(PatchGrids::pieces(placed, pieces))
    }

    /// The numbers of rows and columns; of patches those of all together in one row.
    pub(super) fn counts(&self) -> [f64; 2] {
        match self {
            Grids::Fourier(grid) => [grid.tessellation.along + 1.0, grid.tessellation.round + 1.0],
            Grids::Patches(grids) => [1.0, grids.n_vertices() as f64],
        }
    }

    pub(super) fn n_vertices(&self) -> usize {
        match self {
            Grids::Fourier(grid) => grid.n_vertices(),
            Grids::Patches(grids) => grids.n_vertices(),
        }
    }

    /// The bound that it keeps, where that is known.
    pub(super) fn bound(&self) -> Option<f64> {
        match self {
            Grids::Fourier(grid) => grid.tessellation.bound,
            Grids::Patches(grids) => grids.bound,
        }
    }

    /// Asks for every sum in double precision.
    pub(super) fn make_precise(&mut self) {
        if let Grids::Fourier(grid) = self {
            grid.is_precise = true;
        }
    }

    /// Names the grid and its winding.
    pub(super) fn append_topology(&self, topology: &mut String) {
        match self {
            Grids::Fourier(grid) => grid.append_topology(topology),
            Grids::Patches(grids) => grids.append_topology(topology),
        }
    }

    /// Appends what depends on the grid alone, and room for positions and normals.
    pub(super) fn append_to(&self, mesh: &mut Mesh) {
        match self {
            Grids::Fourier(grid) => grid.append_to(mesh),
            Grids::Patches(grids) => grids.append_to(mesh),
        }
    }

    /// Fills positions and normals; those of patches as they are before they are smoothed go into `unsmoothed` too.
    ///
    /// # Errors
    /// `overflow` for a point beyond single precision.
    pub(super) fn fill(
        &self,
        workspace: &mut Workspace,
        positions: &mut [f32],
        normals: &mut [f32],
        unsmoothed: Option<&mut Vec<[f32; 3]>>,
    ) -> Result<()> {
        match self {
            Grids::Fourier(grid) => {
                workspace.fill(grid, positions, normals)?;
                grid.join(positions);
                Ok(())
            }
            Grids::Patches(grids) => grids.fill(positions, normals, unsmoothed),
        }
    }

    /// Its expansions, when it has been sampled.
    pub(super) fn into_curves(self) -> Option<Curves> {
        match self {
            Grids::Fourier(grid) => Some(grid.into_curves()),
            Grids::Patches(_) => None,
        }
    }

    /// Where its vertices are, in their order.
    pub(super) fn places(&self) -> Places {
        match self {
            Grids::Fourier(grid) => {
                let (rows, columns, _) = grid.places();
                Places::Fourier { rows, columns }
            }
            Grids::Patches(grids) => {
                Places::Patches(grids.lines().iter().map(|lines| [lines.u.clone(), lines.v.clone()]).collect())
            }
        }
    }
}

/// Where the vertices of one part's mesh are.
pub(crate) enum Places {
    /// The `u` of each row, and the number of columns, the repeated one included.
    Fourier { rows: Vec<f64>, columns: usize },
    /// For each patch the `u` of its rows and the `v` of its columns.
    Patches(Vec<[Vec<f64>; 2]>),
}
