//! What a design has become: every part solved once and placed.

mod columns;
mod kept;
mod newest;
mod placed;
mod solved;
mod upright;
mod whole;
mod workable;

pub(crate) use columns::Columns;
pub(crate) use kept::Kept;
pub(crate) use newest::Newest;
pub(crate) use placed::Placed;
pub(crate) use solved::Solved;
pub(crate) use upright::{Stretch, Upright, Walk};
pub use whole::Solution;
