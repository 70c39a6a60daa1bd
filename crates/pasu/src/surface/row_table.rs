//! The coefficients of one row.

use super::term::Term;
use crate::patch::SurfaceJet;

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
#[derive(Debug, Clone, Default)]
pub(crate) struct RowTable<const N: usize> {
    pub(crate) components: [Vec<RowTerm<N>>; 3],
}

impl<const N: usize> RowTable<N> {
    /// The coefficients at `u`, for the columns of a table of the same surface.
    pub(crate) fn at(terms: &[Vec<Term>; 3], distinct: &[f64], u: f64) -> Self {
        let mut table = RowTable::default();
        table.take(terms, distinct, u);
        table
    }

    /// As [`RowTable::at`], by the closed form between two rings or ends, which goes on beyond them.
    pub(crate) fn along(terms: &[Vec<Term>; 3], distinct: &[f64], u: f64, between: [f64; 2]) -> Self {
        let mut table = RowTable::default();
        table.take_by(terms, distinct, |term| term.beam.jets_along::<N, 2>([&term.cos, &term.sin], u, between));
        table
    }

    /// Takes the coefficients at another `u`.
    pub(crate) fn take(&mut self, terms: &[Vec<Term>; 3], distinct: &[f64], u: f64) {
        self.take_by(terms, distinct, |term| term.beam.jets::<N, 2>([&term.cos, &term.sin], u));
    }

    fn take_by(&mut self, terms: &[Vec<Term>; 3], distinct: &[f64], jets: impl Fn(&Term) -> [[f64; N]; 2]) {
        for (row, terms) in self.components.iter_mut().zip(terms) {
            row.clear();
            row.extend(terms.iter().map(|term| {
                let [cos, sin] = jets(term);
                let column = distinct.iter().position(|n| *n == term.n).unwrap_or(0);
                RowTerm { column, k: term.k, cos, sin }
            }));
        }
    }
}

impl RowTable<3> {
    /// Position and derivatives at one column, given cosine and sine of each distinct `n` there.
    pub(crate) fn jet(&self, circle: impl Fn(usize) -> (f64, f64)) -> SurfaceJet {
        let mut jet = SurfaceJet::default();
        for (axis, terms) in self.components.iter().enumerate() {
            for term in terms {
                jet.add(axis, term.k, &term.cos, &term.sin, circle(term.column));
            }
        }
        jet
    }
}
