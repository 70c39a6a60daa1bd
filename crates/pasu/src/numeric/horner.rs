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

/// How many polynomials are formed side by side: a step of one waits for the step before, while others go on.
const ABREAST: usize = 4;

/// [`derivatives`] of many polynomials, each with its own `x`, to the bit. Coefficients are lowest power first; none make 0.
pub(crate) fn derivatives_of_all<const N: usize>(polynomials: &[(&[f64], f64)]) -> Vec<[f64; N]> {
    let mut all = Vec::with_capacity(polynomials.len().next_multiple_of(ABREAST));
    for some in polynomials.chunks(ABREAST) {
        let x: [f64; ABREAST] = core::array::from_fn(|i| some.get(i).map_or(0.0, |(_, x)| *x));
        let longest = some.iter().map(|(coefficients, _)| coefficients.len()).max().unwrap_or(0);
        let mut jets = [[0.0; ABREAST]; N];
        // The shorter ones begin with powers that they do not have, which leaves 0.
        for power in (0..longest).rev() {
            let coefficients: [f64; ABREAST] = core::array::from_fn(|i| {
                some.get(i).and_then(|(coefficients, _)| coefficients.get(power)).copied().unwrap_or(0.0)
            });
            for order in (1..N).rev() {
                for i in 0..ABREAST {
                    jets[order][i] = jets[order][i] * x[i] + jets[order - 1][i];
                }
            }
            for i in 0..ABREAST {
                jets[0][i] = jets[0][i] * x[i] + coefficients[i];
            }
        }
        for i in 0..some.len() {
            let mut factorial = 1.0;
            all.push(core::array::from_fn(|order| {
                factorial *= order.max(1) as f64;
                factorial * jets[order][i]
            }));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_are_what_each_is_by_itself() {
        let coefficients: Vec<f64> = (0..40).map(|i| libm::sin(f64::from(i * i)) / f64::from(1 + i)).collect();
        let lengths = [0, 1, 2, 7, 40, 39, 3, 5, 12];
        let polynomials: Vec<(&[f64], f64)> =
            lengths.iter().zip(0..).map(|(length, i)| (&coefficients[..*length], 0.5 - f64::from(i) / 8.0)).collect();
        for n in 0..=polynomials.len() {
            let each: Vec<[f64; 4]> = polynomials[..n]
                .iter()
                .map(|(coefficients, x)| derivatives(coefficients.iter().rev().copied(), *x))
                .collect();
            let bits = |jets: &[[f64; 4]]| jets.as_flattened().iter().map(|value| value.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&derivatives_of_all::<4>(&polynomials[..n])), bits(&each));
        }
    }

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
