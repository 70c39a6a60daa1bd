//! The trapezoidal rule once round something periodic.
//!
//! It converges faster than any power as soon as it resolves what there is (L. N. Trefethen and J. A. C. Weideman, *The exponentially convergent trapezoidal rule*, 2014).

use core::f64::consts::TAU;

use super::integral::Integral;
use crate::watch;

/// Integrates over a turn of 2 pi with more and more columns, until that changes no more than is `allowed` of integrals of these sizes; at least twice, and with no more than `most` columns from the second time on.
///
/// `sum` adds up the integrands at so many even places. The error is the last change, far more than what is left of a smooth function, and the integral of the function's own errors; changes of less than the part `negligible` of the size, which are rounding, count as none.
pub(crate) fn integrate<const N: usize>(
    columns: usize,
    most: usize,
    negligible: f64,
    mut allowed: impl FnMut(&[f64; N]) -> [f64; N],
    mut sum: impl FnMut(usize) -> Integral<N>,
) -> Integral<N> {
    let mut n = columns;
    let mut before: Option<[f64; N]> = None;
    loop {
        let Integral { value, error, size } = sum(n).scaled(TAU / n as f64);
        let allowed = allowed(&size);
        n = finer(n);
        if let Some(before) = before {
            let change: [f64; N] = core::array::from_fn(|i| {
                let change = (value[i] - before[i]).abs();
                if change <= negligible * size[i] { 0.0 } else { change }
            });
            if (0..N).all(|i| change[i] <= allowed[i]) || n > most || watch::is_stopped() {
                return Integral { value, error: core::array::from_fn(|i| error[i] + change[i]), size };
            }
        }
        before = Some(value);
    }
}

/// Even angles once round.
pub(crate) fn round(n: usize) -> impl Iterator<Item = f64> {
    (0..n).map(move |j| TAU * j as f64 / n as f64)
}

/// About twice as many columns: the next prime.
///
/// A shape of `m` equal petals is met by `n` columns in `n / gcd(n, m)` different places of a petal. Doubling an odd number of columns adds none if `m` is even; primes meet each in as many places as they can.
pub(crate) fn finer(n: usize) -> usize {
    prime(2 * n)
}

/// The least prime from a number on.
pub(crate) fn prime(from: usize) -> usize {
    let is_prime = |n: usize| (2..).take_while(|d| d * d <= n).all(|d| !n.is_multiple_of(d));
    (from.max(2)..).find(|&n| is_prime(n)).unwrap_or(from)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn round(n: usize, of: impl Fn(f64) -> f64) -> Integral<1> {
        let mut sum = Integral::default();
        (0..n).for_each(|j| sum.add(&Integral::of([of(TAU * j as f64 / n as f64)])));
        sum
    }

    #[test]
    fn what_is_resolved_is_exact() {
        let mut asked = Vec::new();
        let found = integrate(
            13,
            1000,
            4e-15,
            |size| size.map(|size| 1e-12 * size),
            |n| {
                asked.push(n);
                round(n, |v| 2.0 + libm::cos(5.0 * v))
            },
        );
        assert!((found.value[0] - 2.0 * TAU).abs() < 1e-14 && found.error[0] <= 1e-12 * found.size[0], "{found:?}");
        assert_eq!(asked, [13, 29]);
    }

    #[test]
    fn a_smooth_function_converges_and_a_kink_is_admitted() {
        let relative = |size: &[f64; 1]| size.map(|size| 1e-10 * size);
        // The integral of exp(cos v) is 2 pi I_0(1).
        let found = integrate(5, 1000, 0.0, relative, |n| round(n, |v| libm::exp(libm::cos(v))));
        assert!((found.value[0] - 7.954_926_521_012_844).abs() <= found.error[0].max(1e-14) && found.error[0] < 1e-9);
        let kink = integrate(5, 200, 0.0, relative, |n| round(n, |v| libm::cos(v).abs()));
        assert!((kink.value[0] - 4.0).abs() <= kink.error[0] && kink.error[0] > 1e-5, "{kink:?}");
    }

    #[test]
    fn columns_are_primes_and_twice_as_many() {
        assert_eq!([0, 1, 2, 8, 90, 7918].map(prime), [2, 2, 2, 11, 97, 7919]);
        assert_eq!([2, 13, 97].map(finer), [5, 29, 197]);
    }
}
