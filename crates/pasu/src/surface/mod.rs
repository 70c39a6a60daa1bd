//! Two-sided PDE surfaces: Fourier boundary data in, closed form out.

mod circle;
mod circumference;
mod curves;
mod jet;
mod orientation;
mod row;
mod solve;
mod supremum;
mod table;
mod turns;

pub(crate) use circle::of_turns;
pub(crate) use circumference::{Circumference, RowSuprema};
pub(crate) use curves::Curves;
pub use jet::SurfaceJet;
pub(crate) use orientation::{is_outward, points_outward};
pub(crate) use row::{Row, Sums};
pub use solve::Surface;
pub(crate) use table::{BLOCK, Block, ColumnTable, RowTable, distinct};
pub(crate) use turns::Turns;
