//! Values of `v` that many rows have in common.

/// Which values of `v`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Spread<'a> {
    /// `j / n` for every `j` below `n`: exact where that matters.
    Even(usize),
    /// These.
    At(&'a [f64]),
}

/// Values of `v` in [0, 1], with what a patch made of them beforehand.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Columns {
    places: Vec<f64>,
    /// Column by column as many pairs as the patch has harmonics; none of a patch without.
    circles: Vec<(f64, f64)>,
}

impl Columns {
    /// Nothing but the places.
    pub(super) fn plain(spread: Spread) -> Columns {
        Columns::with_circles(spread, Vec::new())
    }

    /// With the cosine and sine of each harmonic at each column.
    pub(crate) fn with_circles(spread: Spread, circles: Vec<(f64, f64)>) -> Columns {
        let places = match spread {
            Spread::Even(n) => (0..n).map(|j| j as f64 / n as f64).collect(),
            Spread::At(places) => places.to_vec(),
        };
        Columns { places, circles }
    }

    /// `v` of a column.
    pub(crate) fn v(&self, column: usize) -> f64 {
        self.places.get(column).copied().unwrap_or(0.0)
    }

    /// The pairs of one column, of which there are `n`.
    pub(crate) fn circles(&self, column: usize, n: usize) -> &[(f64, f64)] {
        self.circles.get(column * n..(column + 1) * n).unwrap_or_default()
    }
}
