//! Whether a pot can be made: checks of the mesh that a file holds, after rounding.

mod closed;
mod crossing;
mod degenerate;
mod report;

pub(crate) use closed::closed;
pub(crate) use crossing::crossings;
pub(crate) use degenerate::is_degenerate;

pub use report::{Finding, MeshReport, Report, Severity};
