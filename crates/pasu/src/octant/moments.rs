//! Volume and first moments of an octant, by Dirichlet's integral.

use core::array;

/// The volume and the first moments along the three axes:
///
/// `V = G(1 + 1/a) G(1 + 1/b) G(1 + 1/c) / G(1 + 1/a + 1/b + 1/c)`, and with one more factor `x` one more `1/a` stands everywhere but in the first place: `G(2/a) G(1 + 1/b) G(1 + 1/c) / (a G(1 + 2/a + 1/b + 1/c))`.
pub(super) fn moments(exponents: [f64; 3]) -> (f64, [f64; 3]) {
    let shares = exponents.map(|exponent| 1.0 / exponent);
    let integral = |moment: Option<usize>| {
        let mut product = 1.0;
        let mut sum = 1.0;
        for (axis, share) in shares.into_iter().enumerate() {
            if moment == Some(axis) {
                product *= 0.5 * libm::tgamma(1.0 + 2.0 * share);
                sum += 2.0 * share;
            } else {
                product *= libm::tgamma(1.0 + share);
                sum += share;
            }
        }
        // No argument is beyond 81, and the function of that is far from the largest number.
        product / libm::tgamma(sum)
    };
    (integral(None), array::from_fn(|axis| integral(Some(axis))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solids_that_are_known() {
        let pi = core::f64::consts::PI;
        for (exponents, volume, moment) in [
            // An eighth of a ball, whose centre is 3/8 from each plane.
            ([2.0; 3], pi / 6.0, pi / 16.0),
            // A tetrahedron.
            ([1.0; 3], 1.0 / 6.0, 1.0 / 24.0),
            // 1/90 = 8 / 6!, and 5! / (2 * 10!) times 8 * 4.
            ([0.5; 3], 1.0 / 90.0, 24.0 * 2.0 * 2.0 / 2.0 / 40320.0),
        ] {
            let (found, moments) = super::moments(exponents);
            assert!((found - volume).abs() < 1e-14, "{exponents:?} {found} {volume}");
            for found in moments {
                assert!((found - moment).abs() < 1e-14, "{exponents:?} {found} {moment}");
            }
        }
    }

    /// Volumes that were computed with thirty digits.
    #[test]
    fn any_exponents_to_thirteen_digits() {
        for (exponents, volume) in [
            ([5.75, 0.165, 1.08], 0.10391870053264223),
            ([0.05, 0.05, 0.05], 1.7306091726154983e-27),
            ([50.0, 50.0, 50.0], 0.9981015899537836),
            ([0.05, 50.0, 2.0], 0.18100837401180094),
            ([0.7, 13.0, 0.31], 0.12780967022082),
            ([3.5, 1.25, 24.0], 0.7723408882168731),
        ] {
            let (found, _) = moments(exponents);
            assert!((found - volume).abs() < 1e-13 * volume, "{exponents:?} {found} {volume}");
        }
    }

    /// The triple integral by the midpoint rule, one variable after the other: `z` is `(1 - x^a - y^b)^(1/c)`.
    #[test]
    fn any_exponents_by_counting() {
        for exponents in [[0.7, 2.5, 1.3], [3.0, 0.9, 6.0], [50.0, 2.0, 0.4]] {
            let (volume, first) = moments(exponents);
            let [a, b, c] = exponents;
            let n = 2000;
            let at = |i: usize| (i as f64 + 0.5) / n as f64;
            let (mut sum, mut along) = (0.0, [0.0; 3]);
            for i in 0..n {
                for j in 0..n {
                    let (x, y) = (at(i), at(j));
                    let left = 1.0 - x.powf(a) - y.powf(b);
                    if left > 0.0 {
                        let z = left.powf(1.0 / c);
                        sum += z;
                        for (total, part) in along.iter_mut().zip([x * z, y * z, 0.5 * z * z]) {
                            *total += part;
                        }
                    }
                }
            }
            let cell = 1.0 / (n * n) as f64;
            assert!((sum * cell - volume).abs() < 1e-3 * volume, "{exponents:?}");
            for (total, moment) in along.iter().zip(first) {
                assert!((total * cell - moment).abs() < 1e-3 * moment, "{exponents:?}");
            }
        }
    }
}
