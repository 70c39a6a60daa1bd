//! Functions that are polynomials of one degree between breaks, as smooth as that allows at them, and least squares with them.

/// A basis of them.
pub(super) struct Basis {
    degree: usize,
    /// From the first on, each larger than the one before.
    breaks: Vec<f64>,
}

/// Values of basis functions at one place: the number of the first that is not 0, and as many as there are.
pub(super) struct Row {
    pub(super) first: usize,
    pub(super) values: Vec<f64>,
}

impl Basis {
    pub(super) fn new(degree: usize, breaks: Vec<f64>) -> Basis {
        Basis { degree, breaks }
    }

    /// How many functions there are.
    pub(super) fn len(&self) -> usize {
        self.breaks.len() - 1 + self.degree
    }

    /// What is not 0 at a place, by the recurrence of Cox and de Boor. The first function alone is not 0 at the first break, and the last alone at the last.
    pub(super) fn at(&self, x: f64) -> Row {
        let (degree, last) = (self.degree, self.breaks.len() - 1);
        let knot = |i: usize| self.breaks[i.saturating_sub(degree).min(last)];
        let span = self.breaks[1..last].partition_point(|at| *at <= x) + degree;
        let mut values = vec![0.0; degree + 1];
        values[degree] = 1.0;
        // The last place is the function that begins at the span.
        for order in 1..=degree {
            for place in degree - order..=degree {
                let i = span + place - degree;
                let part = |from: f64, to: f64, value: f64| if to > from { value / (to - from) } else { 0.0 };
                let next = values.get(place + 1).copied().unwrap_or(0.0);
                let up = part(knot(i), knot(i + order), values[place]) * (x - knot(i));
                let down = part(knot(i + 1), knot(i + order + 1), next) * (knot(i + order + 1) - x);
                values[place] = up + down;
            }
        }
        Row { first: span - degree, values }
    }
}

impl Row {
    /// Those that are not 0, with their numbers.
    pub(super) fn entries(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.values.iter().enumerate().map(|(place, value)| (self.first + place, *value))
    }
}

/// The matrix that gives the coefficients of least squares of all functions but the first and the last, from what these leave of the values at places with these rows.
pub(super) fn inverse(rows: &[Row], n: usize) -> Vec<Vec<f64>> {
    let inner = n - 2;
    let mut both = vec![vec![0.0; inner + rows.len()]; inner];
    for (k, row) in rows.iter().enumerate() {
        for (i, one) in row.entries().filter(|(i, _)| (1..=inner).contains(i)) {
            both[i - 1][inner + k] += one;
            for (j, other) in row.entries().filter(|(j, _)| (1..=inner).contains(j)) {
                both[i - 1][j - 1] += one * other;
            }
        }
    }
    // Elimination without a choice of pivots: the matrix is positive definite.
    for i in 0..inner {
        let pivot = both[i][i];
        both[i].iter_mut().for_each(|x| *x /= pivot);
        let own = std::mem::take(&mut both[i]);
        for row in both.iter_mut().filter(|row| !row.is_empty()) {
            let times = row[i];
            if times != 0.0 {
                row.iter_mut().zip(&own).for_each(|(x, own)| *x -= times * own);
            }
        }
        both[i] = own;
    }
    both.into_iter().map(|row| row[inner..].to_vec()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_sum_to_one_and_least_squares_finds_what_is_in_their_span() {
        for (degree, breaks) in [(1, vec![0.0, 0.3, 1.0]), (2, vec![0.0, 1.0]), (3, vec![0.0, 0.5, 0.7, 2.0, 3.0])] {
            let last = breaks[breaks.len() - 1];
            let basis = Basis::new(degree, breaks);
            let n = basis.len();
            let rows: Vec<Row> = (0..40).map(|k| basis.at(last * (k as f64 + 0.5) / 40.0)).collect();
            assert!(rows.iter().all(|row| (row.values.iter().sum::<f64>() - 1.0).abs() < 1e-12));
            let value = |row: Row, wanted: &[f64]| row.entries().map(|(i, value)| value * wanted[i]).sum::<f64>();
            let wanted: Vec<f64> = (0..n).map(|k| (k * k) as f64 - 3.0).collect();
            assert_eq!([value(basis.at(0.0), &wanted), value(basis.at(last), &wanted)], [wanted[0], wanted[n - 1]]);
            let mut inner = wanted.clone();
            (inner[0], inner[n - 1]) = (0.0, 0.0);
            let left: Vec<f64> = (0..40).map(|k| value(basis.at(last * (k as f64 + 0.5) / 40.0), &inner)).collect();
            for (k, weights) in inverse(&rows, n).iter().enumerate() {
                let found: f64 = weights.iter().zip(&left).map(|(weight, left)| weight * left).sum();
                assert!((found - wanted[k + 1]).abs() < 1e-9, "{degree}");
            }
        }
    }

    #[test]
    fn a_polynomial_of_the_degree_is_in_the_span_across_breaks() {
        // Marsden's identity for x: its coefficients are means of knots.
        let basis = Basis::new(3, vec![0.0, 0.5, 2.0]);
        let coefficients = [0.0, 0.5 / 3.0, 2.5 / 3.0, 4.5 / 3.0, 2.0];
        for x in [0.0, 0.2, 0.5, 1.1, 2.0] {
            let found: f64 = basis.at(x).entries().map(|(i, value)| value * coefficients[i]).sum();
            assert!((found - x).abs() < 1e-14, "{x} {found}");
        }
    }
}
