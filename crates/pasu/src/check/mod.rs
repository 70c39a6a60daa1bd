//! Whether a pot can be made: checks of the mesh that a file holds, after rounding.

mod report;

pub use report::{Finding, MeshReport, Report, Severity};
