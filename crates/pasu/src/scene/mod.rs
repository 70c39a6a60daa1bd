//! Designs as scenes: sets of solids.

mod branch;
mod compare;
mod connectivity;
mod difference;
mod flat;
mod tree;
#[cfg(feature = "typescript")]
mod typescript;

pub use compare::compare;
pub use connectivity::{Connectivity, connectivity};
pub use difference::{Counterpart, Difference};
pub use flat::flat;
pub use tree::{Content, Leaf, Node, Tree, tree};
#[cfg(feature = "typescript")]
pub use typescript::typescript_of_answers;
