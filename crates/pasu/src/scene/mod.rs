//! Designs as scenes: sets of solids.

mod compare;
mod difference;
#[cfg(feature = "typescript")]
mod typescript;

pub use compare::compare;
pub use difference::{Counterpart, Difference};
#[cfg(feature = "typescript")]
pub use typescript::typescript_of_answers;
