//! `rings`: a pot as a potter says it, by the radius and the height of every ring.
//!
//! Each ring is a mean and a few waves round the axis, both of its radius and of its height. Foot, rim and what lies between are curves of one surface with the equation of Bloor and Wilson, which
//! `expansion.rs` writes out; `pot.rs` has the fields of the document, `spelling.rs` is how a readable link says it.

mod described;
mod expansion;
mod pot;
mod spelling;

pub use pot::{Hoop, Rings, Series, Slopes, Wave};
