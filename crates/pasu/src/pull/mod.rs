//! A point of a pot is taken hold of and pulled: what of the design has to change so that it comes along.

mod bump;
mod contract;
mod curve;
mod kept;
mod least_change;
mod named;
mod pulled;
mod ringed;
mod written;

pub use contract::{Hand, Pulled};
pub use pulled::pull;
