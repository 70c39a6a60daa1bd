//! Ends of the columns of a side of a wall.

/// Where a column begins, or ends.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Start {
    pub(crate) s: f64,
    /// How that changes with `v`.
    pub(crate) dv: f64,
}
