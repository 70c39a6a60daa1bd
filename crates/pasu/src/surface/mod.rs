//! Two-sided PDE surfaces: Fourier boundary data in, closed form out.

mod circle;
mod circumference;
mod curves;
mod ends;
mod orientation;
mod patch;
mod recent;
mod round;
mod row;
mod row_table;
mod solve;
mod supremum;
mod table;
mod term;
mod third;
mod turns;

pub(crate) use circle::{MOST_MULTIPLES, most_of_many, multiples, of_turns};
pub(crate) use circumference::{Circumference, RowSuprema};
pub(crate) use curves::Curves;
pub(crate) use orientation::{is_outward, points_outward};
pub(crate) use round::Round;
pub(crate) use row::{Row, Sums};
pub(crate) use row_table::RowTable;
#[cfg(test)]
pub(crate) use solve::SOLVED;
pub use solve::Surface;
pub(crate) use table::{BLOCK, Block, ColumnTable};
pub(crate) use term::Term;
pub(crate) use third::ThirdSuprema;
pub(crate) use turns::Turns;
