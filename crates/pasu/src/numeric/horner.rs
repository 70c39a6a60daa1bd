//! Horner's rule: a polynomial and its derivatives.

/// The polynomial with these coefficients, highest power first, at `x`, with its derivatives up to order `N - 1`.
///
/// Forms the Taylor coefficients, which are the derivatives over factorials; each is off by some rounding of the sum of the sizes of its terms. No coefficients make 0. `N` is 1 at least.
#[inline]
pub(crate) fn derivatives<const N: usize>(coefficients: impl Iterator<Item = f64>, x: f64) -> [f64; N] {
    let mut jet = [0.0; N];
    for coefficient in coefficients {
        for order in (1..N).rev() {
            jet[order] = jet[order] * x + jet[order - 1];
        }
        jet[0] = jet[0] * x + coefficient;
    }
    let mut factorial = 1.0;
    for (order, value) in jet.iter_mut().enumerate().skip(2) {
        factorial *= order as f64;
        *value *= factorial;
    }
    jet
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers() {
        assert_eq!(derivatives::<5>([1.0, 0.0, 0.0, 0.0, 7.0].into_iter(), 1.0), [8.0, 4.0, 12.0, 24.0, 24.0]);
        assert_eq!(derivatives::<3>([2.0, -3.0, 5.0].into_iter(), 4.0), [25.0, 13.0, 4.0]);
    }

    #[test]
    fn nothing_is_zero() {
        assert_eq!(derivatives::<3>(core::iter::empty(), 2.0), [0.0; 3]);
    }
}
