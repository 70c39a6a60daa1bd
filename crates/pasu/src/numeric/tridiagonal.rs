//! Systems of equations with three diagonals.

/// The factors of a matrix with three diagonals, by elimination with partial pivoting: rows change places with their neighbour where that one is larger.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Tridiagonal {
    rows: Vec<Row>,
}

/// One row of the upper triangle, and how it was got.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Row {
    /// On the diagonal and beside it.
    upper: [f64; 3],
    /// What of this row was taken from the next.
    factor: f64,
    /// Whether it changed places with the next before.
    is_swapped: bool,
}

impl Tridiagonal {
    /// The matrix whose rows have these entries before, on and behind the diagonal; the first of the first row and the last of the last are not there. `None` where it is singular, or not of numbers.
    #[inline(never)]
    pub(crate) fn factors(rows: &[[f64; 3]]) -> Option<Self> {
        let mut factors = Vec::with_capacity(rows.len());
        let Some((&[_, diagonal, behind], rest)) = rows.split_first() else { return Some(Tridiagonal::default()) };
        let mut here = [diagonal, if rest.is_empty() { 0.0 } else { behind }, 0.0];
        for (index, &[before, diagonal, behind]) in rest.iter().enumerate() {
            let mut next = [before, diagonal, if index + 1 == rest.len() { 0.0 } else { behind }];
            let is_swapped = next[0].abs() > here[0].abs();
            if is_swapped {
                (here, next) = (next, here);
            }
            let factor = next[0] / here[0];
            factors.push(Row { upper: here, factor, is_swapped });
            here = [next[1] - factor * here[1], next[2] - factor * here[2], 0.0];
        }
        factors.push(Row { upper: here, factor: 0.0, is_swapped: false });
        let is_regular = factors.iter().all(|row| row.upper[0].is_normal() && row.factor.is_finite());
        is_regular.then_some(Tridiagonal { rows: factors })
    }

    /// Solves for one right-hand side, in its place. What is there beyond the matrix is left as it is.
    #[inline(never)]
    pub(crate) fn solve(&self, values: &mut [f64]) {
        for (index, row) in self.rows.iter().enumerate() {
            let [here, next, ..] = &mut values[index..] else { break };
            if row.is_swapped {
                core::mem::swap(here, next);
            }
            *next -= row.factor * *here;
        }
        let mut behind = [0.0; 2];
        for (row, value) in self.rows.iter().zip(values).rev() {
            let [diagonal, next, second] = row.upper;
            *value = (*value - next * behind[0] - second * behind[1]) / diagonal;
            behind = [*value, behind[0]];
        }
    }

    /// The largest sum of the sizes in a row of the inverse: how much an error of 1 in every equation can do.
    #[inline(never)]
    pub(crate) fn inverse_norm(&self) -> f64 {
        let n = self.rows.len();
        let mut sums = vec![0.0; n];
        let mut column = vec![0.0; n];
        for index in 0..n {
            column.fill(0.0);
            column[index] = 1.0;
            self.solve(&mut column);
            for (sum, value) in sums.iter_mut().zip(&column) {
                *sum += value.abs();
            }
        }
        sums.into_iter().fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(rows: &[[f64; 3]], x: &[f64]) -> Vec<f64> {
        let at = |i: usize| x.get(i).copied().unwrap_or(0.0);
        rows.iter().enumerate().map(|(i, [a, b, c])| a * at(i.wrapping_sub(1)) + b * at(i) + c * at(i + 1)).collect()
    }

    #[test]
    fn every_size_is_solved() {
        for n in 1..9 {
            // Small diagonals, so that rows have to change places.
            let mut rows: Vec<[f64; 3]> =
                (0..n).map(|i| [1.0 + i as f64, 0.1 - 0.3 * i as f64, 2.5 - i as f64]).collect();
            (rows[0][0], rows[n - 1][2]) = (0.0, 0.0);
            let x: Vec<f64> = (0..n).map(|i| 1.0 - 0.7 * i as f64).collect();
            let factors = Tridiagonal::factors(&rows).unwrap();
            let mut found = product(&rows, &x);
            factors.solve(&mut found);
            for (found, x) in found.iter().zip(&x) {
                assert!((found - x).abs() < 1e-12, "{n}: {found}, not {x}");
            }
        }
    }

    #[test]
    fn the_inverse_is_as_large_as_it_is() {
        let factors = Tridiagonal::factors(&[[0.0, 2.0, 1.0], [1.0, 2.0, 0.0]]).unwrap();
        // [[2, -1], [-1, 2]] / 3
        assert!((factors.inverse_norm() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_is_singular_has_no_factors() {
        assert_eq!(Tridiagonal::factors(&[[0.0, 1.0, 1.0], [1.0, 1.0, 0.0]]), None);
        assert_eq!(Tridiagonal::factors(&[[0.0, f64::NAN, 0.0]]), None);
        assert!(Tridiagonal::factors(&[]).is_some());
    }
}
