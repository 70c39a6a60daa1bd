//! Two-sided PDE surfaces: Fourier boundary data in, closed form out.

mod circle;
mod circumference;
mod jet;
mod solve;
mod supremum;
mod table;

pub(crate) use circumference::{Circumference, RowSuprema};
pub use jet::SurfaceJet;
pub use solve::Surface;
pub(crate) use table::{BLOCK, Block, ColumnTable, RowTable, RowTerm};
