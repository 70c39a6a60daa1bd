//! Evaluation as a sum of outer products: tables of `q` per row and of `cos`, `sin` per column (`math.md` section 1).

use super::circle;
use super::solve::Surface;

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

/// What one row of constant `u` needs of the solution.
#[derive(Debug, Clone)]
pub(crate) struct RowTable<const N: usize> {
    pub(crate) components: [Vec<RowTerm<N>>; 3],
}

impl<const N: usize> RowTable<N> {
    /// The coefficients at `u`, for the columns of a table of the same surface.
    pub(crate) fn at(surface: &Surface, distinct: &[f64], u: f64) -> Self {
        let components = surface.components().each_ref().map(|terms| {
            let row = |term: &super::solve::Term| {
                let [cos, sin] = term.equation.jets::<N, 2>([&term.cos, &term.sin], u);
                let column = distinct.iter().position(|n| *n == term.n).unwrap_or(0);
                RowTerm { column, k: term.k, cos, sin }
            };
            terms.iter().map(row).collect()
        });
        RowTable { components }
    }
}

/// `cos(k_n v_j)` and `sin(k_n v_j)` for every distinct `n` of a surface and every column.
#[derive(Debug, Clone)]
pub(crate) struct ColumnTable {
    /// The distinct `n`, in the order of `cos` and `sin`.
    pub(crate) distinct: Vec<f64>,
    pub(crate) cos: Vec<Vec<f64>>,
    pub(crate) sin: Vec<Vec<f64>>,
}

impl ColumnTable {
    /// Tables for `n_columns` columns from `v = 0` to `v = span`, both included. For whole `n` the last column has the bits of the first.
    pub(crate) fn new(surface: &Surface, n_columns: usize) -> Self {
        let mut distinct = Vec::new();
        for term in surface.components().iter().flatten() {
            if !distinct.contains(&term.n) {
                distinct.push(term.n);
            }
        }
        let steps = (n_columns.max(2) - 1) as f64;
        let (mut cos, mut sin) = (Vec::new(), Vec::new());
        for &n in &distinct {
            // n j is exact for every grid within the vertex limit, so the turn is reduced before the division rounds.
            let turn = |j: usize| circle::of_turns(libm::fmod(n * j as f64, steps) / steps);
            let (c, s) = (0..n_columns).map(turn).unzip();
            cos.push(c);
            sin.push(s);
        }
        ColumnTable { distinct, cos, sin }
    }
}
