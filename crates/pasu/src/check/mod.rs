//! Exact predicates on triangles: whether they close, degenerate or cross.

mod boxes;
mod closed;
mod crossing;
mod degenerate;
mod neighbours;
mod plane;

pub(crate) use closed::{Topology, closed};
pub(crate) use crossing::{Against, a_crossing, crossings_soon};
pub(crate) use degenerate::is_degenerate;
pub(crate) use neighbours::Neighbours;
