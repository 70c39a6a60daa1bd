//! The coefficients of one row.

use super::row_term::RowTerm;
use super::term::Term;
use crate::mode::{Beam, Spot};
use crate::numeric::horner;
use crate::patch::SurfaceJet;

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
        table.take_by(terms, distinct, |beam| beam.spot_along(u, between));
        table
    }

    /// Takes the coefficients at another `u`.
    pub(crate) fn take(&mut self, terms: &[Vec<Term>; 3], distinct: &[f64], u: f64) {
        self.take_by(terms, distinct, |beam| beam.spot(u));
    }

    fn take_by(&mut self, terms: &[Vec<Term>; 3], distinct: &[f64], spot: impl Fn(&Beam) -> Spot) {
        // All polynomials of a row at once, which takes a quarter of the time.
        let n_terms = terms.iter().map(Vec::len).sum();
        let (mut spots, mut polynomials) = (Vec::with_capacity(n_terms), Vec::with_capacity(2 * n_terms));
        for term in terms.iter().flatten() {
            let spot = spot(&term.beam);
            spots.push(spot);
            if term.found.is_none() {
                polynomials.extend([&term.cos, &term.sin].map(|deflection| deflection.polynomial(spot)));
            }
        }
        let mut jets = horner::derivatives_of_all::<N>(&polynomials).into_iter();
        let mut spots = spots.into_iter();
        let [x, others @ ..] = &mut self.components;
        let mut take = |row: &mut Vec<RowTerm<N>>, terms: &[Term], known: &[RowTerm<N>]| {
            row.clear();
            row.extend(terms.iter().zip(&mut spots).map(|(term, spot)| {
                let [cos, sin] = term.found_in(known).unwrap_or_else(|| {
                    let polynomials = [0; 2].map(|_| jets.next().unwrap_or([0.0; N]));
                    term.beam.jets_on(polynomials, spot, [&term.cos, &term.sin])
                });
                let column = distinct.iter().position(|n| *n == term.n).unwrap_or(0);
                RowTerm { column, k: term.k, cos, sin }
            }));
        };
        take(x, &terms[0], &[]);
        for (row, terms) in others.iter_mut().zip(&terms[1..]) {
            take(row, terms, x);
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
