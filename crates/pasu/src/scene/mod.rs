//! Designs as scenes: sets of solids.

mod border;
mod bounds;
mod boxes;
mod branch;
mod breach;
mod budget;
mod coaxial;
mod compare;
mod connectivity;
mod constraints;
mod crossed;
mod crossings;
mod deep;
mod difference;
mod divided;
mod flat;
mod formula;
mod halvings;
mod hit;
mod holds;
mod isometry;
mod judged;
mod meeting;
mod meridian;
mod missed;
mod nearest;
mod node;
mod open;
mod pick;
mod reach;
mod scenery;
mod section;
mod segment;
mod shallow;
mod sight;
mod space;
mod still;
mod stroke;
mod tile;
mod tree;
#[cfg(feature = "typescript")]
mod typescript;

pub use breach::{Breach, Constraints};
pub use compare::compare;
pub use connectivity::{Connectivity, connectivity};
pub use constraints::constraints;
pub use difference::{Counterpart, Difference};
pub use flat::flat;
pub use hit::{Hit, Ray};
pub use node::{Content, Leaf, Node};
pub use pick::{at, pick};
pub use tree::{Tree, tree};
#[cfg(feature = "typescript")]
pub use typescript::typescript_of_answers;
