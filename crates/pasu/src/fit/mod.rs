//! A pot of rings that says what something else said: a pot of another kind, or a drawn line.

mod azimuth;
mod contract;
mod curves;
mod digits;
mod free;
mod line;
mod profile;
mod sections;
mod series;

pub use contract::Ringed;
pub use free::free;
pub use profile::{Profile, fit};
