//! The rows at both ends of a surface, which are asked for more often than any other.

use std::sync::OnceLock;

use super::row_table::RowTable;

/// The coefficients at `u = 0` and `u = 1`, once they have been asked for. They follow from the surface, so that all of them count as equal.
#[derive(Debug, Clone, Default)]
pub(super) struct Ends([OnceLock<RowTable<3>>; 2]);

impl PartialEq for Ends {
    fn eq(&self, _: &Ends) -> bool {
        true
    }
}

impl Ends {
    /// The row at `u` if that is an end; `make` makes it when it is first asked for.
    pub(super) fn at(&self, u: f64, make: impl FnOnce() -> RowTable<3>) -> Option<&RowTable<3>> {
        let end = [0.0, 1.0].into_iter().position(|end| end == u)?;
        Some(self.0[end].get_or_init(make))
    }
}
