//! Values of `v` that many rows have in common.

/// Which values of `v`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Spread<'a> {
    /// `j / n` for every `j` below `n`: exact where that matters.
    Even(usize),
    /// These.
    At(&'a [f64]),
}

impl Spread<'_> {
    /// All of them.
    pub(crate) fn places(self) -> Vec<f64> {
        match self {
            Spread::Even(n) => (0..n).map(|j| j as f64 / n as f64).collect(),
            Spread::At(places) => places.to_vec(),
        }
    }
}

/// Values of `v` in [0, 1], with what a patch made of them beforehand.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Columns {
    places: Vec<f64>,
    /// Column by column as many pairs as the patch makes of one; none of a patch that makes nothing.
    pairs: Vec<(f64, f64)>,
}

impl Columns {
    /// Nothing but the places.
    pub(super) fn plain(spread: Spread) -> Columns {
        Columns::with_pairs(spread, Vec::new())
    }

    /// With as many pairs at each column: cosine and sine of each harmonic, or value and derivatives of two functions.
    pub(crate) fn with_pairs(spread: Spread, pairs: Vec<(f64, f64)>) -> Columns {
        Columns { places: spread.places(), pairs }
    }

    /// `v` of a column.
    pub(crate) fn v(&self, column: usize) -> f64 {
        self.places.get(column).copied().unwrap_or(0.0)
    }

    /// The pairs of one column, of which there are `n`.
    pub(crate) fn pairs(&self, column: usize, n: usize) -> &[(f64, f64)] {
        self.pairs.get(column * n..(column + 1) * n).unwrap_or_default()
    }
}
