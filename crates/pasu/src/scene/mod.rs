//! Designs as scenes: sets of solids.

mod branch;
mod compare;
mod connectivity;
mod difference;
mod flat;
mod node;
mod tree;
#[cfg(feature = "typescript")]
mod typescript;

pub use compare::compare;
pub use connectivity::{Connectivity, connectivity};
pub use difference::{Counterpart, Difference};
pub use flat::flat;
pub use node::{Content, Leaf, Node};
pub use tree::{Tree, tree};
#[cfg(feature = "typescript")]
pub use typescript::typescript_of_answers;
