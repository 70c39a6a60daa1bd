//! One `n` of one component at one row.

/// Coefficients of `cos(k v)` and `sin(k v)` at one row.
#[derive(Debug, Clone)]
pub(crate) struct RowTerm<const N: usize> {
    /// Index of the distinct `n` in the [`ColumnTable`].
    pub(crate) column: usize,
    pub(crate) k: f64,
    /// Derivatives of `A` up to order `N - 1`.
    pub(crate) cos: [f64; N],
    /// Derivatives of `B` up to order `N - 1`.
    pub(crate) sin: [f64; N],
}
