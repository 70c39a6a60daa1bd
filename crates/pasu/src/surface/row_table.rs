//! The coefficients of one row.

use std::sync::Arc;

use super::term::Term;
use crate::mode::{Beam, Deflection};
use crate::patch::{AxisJet, SurfaceJet};

/// Coefficients of `cos(k v)` and `sin(k v)` at one row.
#[derive(Debug, Clone)]
pub(crate) struct RowTerm<const N: usize> {
    /// Index of the distinct `n`, the same in the [`ColumnTable`](super::table::ColumnTable).
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
    pub(crate) fn at(terms: &[Vec<Term>; 3], u: f64) -> Self {
        let mut table = RowTable::default();
        table.take(terms, u);
        table
    }

    /// As [`RowTable::at`], by the closed form between two rings or ends, which goes on beyond them.
    pub(crate) fn along(terms: &[Vec<Term>; 3], u: f64, between: [f64; 2]) -> Self {
        let mut table = RowTable::default();
        table.take_by(
            terms,
            |beam, of| beam.jets_along::<N, 2>(of, u, between),
            |beam, of| beam.jets_along::<N, 4>(of, u, between),
        );
        table
    }

    /// Takes the coefficients at another `u`.
    pub(crate) fn take(&mut self, terms: &[Vec<Term>; 3], u: f64) {
        self.take_by(terms, |beam, of| beam.jets::<N, 2>(of, u), |beam, of| beam.jets::<N, 4>(of, u));
    }

    /// `y` has the equations of `x` nearly always, in the same order: what they have in common is formed once.
    fn take_by(
        &mut self,
        terms: &[Vec<Term>; 3],
        one: impl Fn(&Beam, [&Deflection; 2]) -> [[f64; N]; 2],
        two: impl Fn(&Beam, [&Deflection; 4]) -> [[f64; N]; 4],
    ) {
        let row_term = |term: &Term, cos: [f64; N], sin: [f64; N]| RowTerm { column: term.column, k: term.k, cos, sin };
        for (row, terms) in self.components.iter_mut().zip(terms) {
            row.clear();
            row.reserve_exact(terms.len());
        }
        let ([x, y, z], [row_x, row_y, row_z]) = (terms, &mut self.components);
        // What draws the first pot has to be small, and asks for few rows.
        let pairs = x.iter().zip(y).take_while(|(x, y)| cfg!(feature = "patchwork") && Arc::ptr_eq(&x.beam, &y.beam));
        for (x, y) in pairs {
            let [x_cos, x_sin, y_cos, y_sin] = two(&x.beam, [&x.cos, &x.sin, &y.cos, &y.sin]);
            row_x.push(row_term(x, x_cos, x_sin));
            row_y.push(row_term(y, y_cos, y_sin));
        }
        for (row, terms) in [(row_x, x), (row_y, y), (row_z, z)] {
            let left = terms.get(row.len()..).unwrap_or_default();
            row.extend(left.iter().map(|term| {
                let [cos, sin] = one(&term.beam, [&term.cos, &term.sin]);
                row_term(term, cos, sin)
            }));
        }
    }
}

impl RowTable<3> {
    /// Position and derivatives at one column, given cosine and sine of each distinct `n` there.
    pub(crate) fn jet(&self, circle: impl Fn(usize) -> (f64, f64)) -> SurfaceJet {
        let mut jet = SurfaceJet::default();
        for (axis, terms) in self.components.iter().enumerate() {
            let mut sums = AxisJet::default();
            for term in terms {
                sums.add(term.k, &term.cos, &term.sin, circle(term.column));
            }
            jet.set(axis, sums);
        }
        jet
    }
}
