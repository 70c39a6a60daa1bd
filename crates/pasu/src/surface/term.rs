//! One mode of one component, solved.

use std::sync::Arc;

use super::row_term::RowTerm;
use crate::mode::{Beam, Deflection, Likeness};

/// One `n` of one component.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Term {
    pub(crate) n: f64,
    pub(super) k: f64,
    /// Shared by all components and modes with the same equation.
    pub(crate) beam: Arc<Beam>,
    pub(super) cos: Deflection,
    pub(super) sin: Deflection,
    /// Where cosine and sine are found among the terms of `x`, if both are or are 0: those of `y` nearly always, as a circle's `y` is its `x` a quarter of a turn further on.
    pub(super) found: Option<[Option<Found>; 2]>,
}

/// Which term of `x` has the same values or the opposite ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(super) term: usize,
    pub(super) is_sin: bool,
    pub(super) likeness: Likeness,
}

impl Found {
    /// Where the values of a term are among those of `terms`; nothing stands for 0.
    pub(super) fn among(terms: &[Term], Term { beam, cos, sin, .. }: &Term) -> Option<[Option<Found>; 2]> {
        let known: Vec<_> = terms
            .iter()
            .enumerate()
            .filter(|(_, term)| Arc::ptr_eq(&term.beam, beam))
            .flat_map(|(term, other)| [(term, false, &other.cos), (term, true, &other.sin)])
            .collect();
        let find = |deflection: &Deflection| {
            if deflection.is_zero() {
                return Some(None);
            }
            known
                .iter()
                .find_map(|&(term, is_sin, other)| Some(Found { term, is_sin, likeness: deflection.likeness(other)? }))
                .map(Some)
        };
        Some([find(cos)?, find(sin)?])
    }
}

impl Term {
    /// Cosine and sine of a row whose terms of `x` are known, where they are found among those.
    pub(super) fn found_in<const N: usize>(&self, x: &[RowTerm<N>]) -> Option<[[f64; N]; 2]> {
        let of = |Found { term, is_sin, likeness }: Found| {
            let RowTerm { cos, sin, .. } = &x[term];
            (if is_sin { sin } else { cos }).map(|value| likeness.of(value))
        };
        Some(self.found?.map(|found| found.map_or([0.0; N], of)))
    }

    /// The factors of cosine and sine at `u`.
    pub(crate) fn values(&self, u: f64) -> [f64; 2] {
        let [[cos], [sin]] = self.beam.jets::<1, 2>([&self.cos, &self.sin], u);
        [cos, sin]
    }
}
