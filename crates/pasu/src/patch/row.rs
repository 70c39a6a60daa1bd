//! One curve of constant `u`.

use super::columns::Columns;
use super::jet::SurfaceJet;

/// A row of a patch, asked at one `v` in [0, 1] after the other.
///
/// Its derivatives are those by a parameter of the row's own, which runs from 0 to [`Row::length`] while `v` runs from 0 to 1: whoever wants others multiplies once, at the end.
pub(crate) trait Row {
    /// How far that parameter runs.
    fn length(&self) -> f64;

    /// Position and derivatives.
    fn jet(&self, v: f64) -> SurfaceJet;

    /// The same at one of several columns of the same patch.
    fn jet_at(&self, columns: &Columns, column: usize) -> SurfaceJet {
        self.jet(columns.v(column))
    }
}
