//! Points and cells one after the other.

use crate::interior::Cells;

/// Numbers of one point after the other.
pub(super) fn points(cells: &Cells) -> impl Iterator<Item = &[f64]> {
    cells.positions.chunks_exact(3)
}

/// The corners of one cell after the other.
pub(super) fn corners(cells: &Cells) -> impl Iterator<Item = &[u32]> {
    cells.corners.chunks_exact(cells.shape.n_corners())
}
