//! Whether a pot can be made: checks of the mesh that a file holds, after rounding.

mod closed;
mod crossing;
mod degenerate;
mod report;
mod verdict;

pub(crate) use closed::{Topology, closed};
pub(crate) use crossing::crossings;
pub(crate) use degenerate::is_degenerate;

pub use report::{Finding, MeshReport, Report, Severity};
pub use verdict::check;
pub(crate) use verdict::verdict;
