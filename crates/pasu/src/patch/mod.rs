//! What every surface is made of: pieces over the unit square, and what can be asked of one.

mod breaks;
mod cell;
mod columns;
mod contract;
mod corners;
#[cfg(test)]
pub(crate) mod examples;
mod jet;
mod lines;
mod normal_limit;
mod row;
mod side;
mod strips;

pub(crate) use breaks::Breaks;
pub(crate) use cell::{Cell, Suprema};
pub(crate) use columns::{Columns, Spread};
pub(crate) use contract::Patch;
#[cfg(feature = "patchwork")]
pub(crate) use contract::ShowCell;
pub(crate) use corners::{ENDS, first_corners};
pub(crate) use jet::AxisJet;
pub use jet::SurfaceJet;
pub(crate) use lines::{Lines, deviation_of, lines_within};
pub(crate) use normal_limit::normal_limit;
pub(crate) use row::Row;
pub(crate) use side::Side;
pub(crate) use strips::SAME_LINE;
