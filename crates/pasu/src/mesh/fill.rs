//! Positions and normals of one part.

use super::exact::ExactRows;
use super::fourier::Kernel;
use super::part::PartGrid;
use crate::error::Result;
use crate::watch;

/// What sampling needs besides the mesh, kept from one mesh to the next.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    kernel: Kernel,
}

impl Workspace {
    /// Fills positions and normals of a part: in single precision where that is enough, in double precision where a tolerance is promised.
    ///
    /// # Errors
    /// `overflow` for a point beyond single precision.
    pub(super) fn fill(&mut self, grid: &PartGrid, positions: &mut [f32], normals: &mut [f32]) -> Result<()> {
        let (_, n_columns) = grid.tessellation.counts();
        let mut exact = ExactRows::new(grid, n_columns);
        if !grid.is_precise {
            return self.kernel.fill(grid, &mut exact, positions, normals);
        }
        let rows = positions.chunks_exact_mut(3 * n_columns).zip(normals.chunks_exact_mut(3 * n_columns));
        for (index, (positions, normals)) in rows.enumerate() {
            watch::work(4 * n_columns as u64);
            watch::go_on()?;
            exact.fill(index, positions, normals)?;
        }
        Ok(())
    }
}
