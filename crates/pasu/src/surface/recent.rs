//! Rows of a surface that were asked for lately: whoever goes from column to column asks for the same ones over and over.

use core::ops::Deref;
use std::sync::Arc;

use super::row_table::RowTable;
use crate::numeric::recent::Recent;

/// The most rows that are kept, a power of two.
const MOST: usize = 1 << 10;

/// The most terms of all rows that are kept, of some seventy bytes each.
const MOST_TERMS: usize = 1 << 16;

/// The coefficients of a row, wherever they are kept.
pub(super) enum KeptRow<'a> {
    End(&'a RowTable<3>),
    Recent(Arc<RowTable<3>>),
}

impl Deref for KeptRow<'_> {
    type Target = RowTable<3>;

    fn deref(&self) -> &RowTable<3> {
        match self {
            KeptRow::End(row) => row,
            KeptRow::Recent(row) => row,
        }
    }
}

/// Rows by their `u`.
pub(super) type RecentRows = Recent<Arc<RowTable<3>>, 1>;

impl RecentRows {
    /// The row at `u` of a surface of so many terms; `make` makes it where it is not kept.
    pub(super) fn row(&self, u: f64, n_terms: usize, make: impl FnOnce() -> RowTable<3>) -> Arc<RowTable<3>> {
        let n = (MOST_TERMS / n_terms.max(1)).clamp(1, MOST);
        self.at([u], 1 << n.ilog2(), || Arc::new(make()))
    }
}
