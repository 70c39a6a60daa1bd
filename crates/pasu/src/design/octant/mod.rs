//! Octants of superspheres (ASB88), as a document describes them.

mod described;
mod fields;
mod standing;

pub use fields::Octant;
