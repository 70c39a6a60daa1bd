//! Two-sided PDE surfaces: Fourier boundary data in, closed form out.

mod circle;
mod jet;
mod solve;
mod table;

pub use jet::SurfaceJet;
pub use solve::Surface;
pub(crate) use table::{BLOCK, Block, ColumnTable, RowTable, RowTerm, distinct};
