//! Designs as scenes: sets of solids.

mod border;
mod bounds;
mod boxes;
mod breach;
mod compare;
mod constraints;
mod crossings;
mod difference;
mod hit;
mod holds;
mod meeting;
mod nearest;
mod pick;
mod space;
mod tile;
mod triangles;
#[cfg(feature = "typescript")]
mod typescript;

pub use breach::{Breach, Constraints};
pub use compare::compare;
pub use constraints::constraints;
pub use difference::{Counterpart, Difference};
pub use hit::{Hit, Ray};
pub use pick::{at, pick};
#[cfg(feature = "typescript")]
pub use typescript::typescript_of_answers;
