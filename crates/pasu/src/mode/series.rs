//! Polynomials and power series in `x = u - 1/2`, lowest power first.

use crate::numeric::horner;

/// Terms that no longer change a sum of doubles on |x| <= 1/2.
const NEGLIGIBLE: f64 = 1e-19;

/// More than any series here needs beyond its force: 4^m / m! < 1e-19 from m = 32 on, and powers above the rate die away faster.
const MAX_TERMS: usize = 400;

/// As many as a rate of 4 takes.
const USUAL_TERMS: usize = 36;

/// Solves `q^(order) = sum_j feedback_j q^(j) + force` for the power series of `q` from its first `order` coefficients.
///
/// `feedback` holds pairs `(j, factor)` with `j < order`. Stops when the terms at `|x| = 1/2` have become negligible against the largest.
pub(super) fn continue_series(start: &[f64], feedback: &[(usize, f64)], force: &[f64]) -> Vec<f64> {
    let order = start.len();
    // As many as most take, so that they are moved once at most.
    let mut terms = Vec::with_capacity(order + force.len() + USUAL_TERMS);
    terms.extend_from_slice(start);
    let mut largest = terms.iter().enumerate().fold(0.0f64, |m, (i, a)| m.max(a.abs() * power_of_half(i)));
    let mut quiet = 0;
    while terms.len() < force.len() + MAX_TERMS && !(quiet >= order && terms.len() >= force.len() + order) {
        let m = terms.len() - order;
        let mut sum = force.get(m).copied().unwrap_or(0.0);
        for &(j, factor) in feedback {
            sum += factor * falling(m + j, j) * terms[m + j];
        }
        let next = sum / falling(m + order, order);
        let size = next.abs() * power_of_half(m + order);
        largest = largest.max(size);
        quiet = if size <= NEGLIGIBLE * largest { quiet + 1 } else { 0 };
        terms.push(next);
    }
    while terms.last() == Some(&0.0) {
        terms.pop();
    }
    terms
}

/// `n (n - 1) .. (n - j + 1)`, the factor of the `j`-th derivative of `x^n`.
pub(super) fn falling(n: usize, j: usize) -> f64 {
    let n = n as f64;
    match j {
        0 => 1.0,
        2 => n * (n - 1.0),
        4 => n * (n - 1.0) * (n - 2.0) * (n - 3.0),
        _ => (0..j).fold(1.0, |product, i| product * (n - i as f64)),
    }
}

/// `2^-n` for the counts of terms that there are, far below the smallest double.
fn power_of_half(n: usize) -> f64 {
    const BIAS: u64 = 1023;
    f64::from_bits(BIAS.saturating_sub(n as u64) << 52)
}

/// The polynomial in `x` that equals the polynomial `in_u` of `u = x + 1/2`.
pub(super) fn about_the_middle(in_u: &[f64]) -> Vec<f64> {
    about(in_u, 0.5)
}

/// The polynomial in `x` that equals the polynomial `in_u` of `u = x + place`.
pub(super) fn about(in_u: &[f64], place: f64) -> Vec<f64> {
    let mut shifted = in_u.to_vec();
    for first in 0..shifted.len() {
        for i in (first..shifted.len().saturating_sub(1)).rev() {
            shifted[i] += place * shifted[i + 1];
        }
    }
    shifted
}

/// The polynomial at `u` with its derivatives up to order `N - 1`.
pub(super) fn jet<const N: usize>(polynomial: &[f64], u: f64) -> [f64; N] {
    horner::derivatives(polynomial.iter().rev().copied(), u - 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shifting_keeps_the_values() {
        let in_u = [0.3, -2.0, 0.0, 5.0, 1.0];
        let about = about_the_middle(&in_u);
        for u in [0.0, 0.2, 0.5, 1.0] {
            let direct: f64 = in_u.iter().rev().fold(0.0, |sum, c| sum * u + c);
            assert!((jet::<1>(&about, u)[0] - direct).abs() < 1e-14);
        }
        assert!(about_the_middle(&[]).is_empty());
    }

    #[test]
    fn jet_gives_the_derivatives() {
        assert_eq!(jet::<5>(&[7.0, 0.0, 0.0, 0.0, 1.0], 1.5), [8.0, 4.0, 12.0, 24.0, 24.0]);
    }

    #[test]
    fn a_series_that_ends_is_exact() {
        assert_eq!(continue_series(&[1.0, 2.0], &[(0, 0.0)], &[6.0]), [1.0, 2.0, 3.0]);
    }
}
