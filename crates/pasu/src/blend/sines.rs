//! The discrete sine transform of the inner points `i / (L + 1)` (DST-I): its matrix is orthogonal but for a factor.

use crate::surface::of_turns;

/// Sines at `L` inner points, for `L` frequencies.
#[derive(Debug, Clone)]
pub(super) struct Sines {
    n: usize,
    /// `sin(pi k / (L + 1))` for `k` below `2 (L + 1)`, the whole period.
    table: Vec<f64>,
}

impl Sines {
    /// Of so many points, at least one.
    pub(super) fn new(n: usize) -> Sines {
        let period = 2 * (n + 1);
        Sines { n, table: (0..period).map(|k| of_turns(k as f64 / period as f64).1).collect() }
    }

    pub(super) fn len(&self) -> usize {
        self.n
    }

    /// The inner points.
    pub(super) fn points(&self) -> impl Iterator<Item = f64> + use<> {
        let n = self.n;
        (1..=n).map(move |i| i as f64 / (n + 1) as f64)
    }

    /// `sin(l pi i / (L + 1))`.
    fn at(&self, l: usize, i: usize) -> f64 {
        self.table[l * i % self.table.len()]
    }

    /// The `a_l` for which `sum_l a_l sin(l pi u_i)` is what is given at each inner point.
    pub(super) fn coefficients(&self, given: &[f64]) -> Vec<f64> {
        let factor = 2.0 / (self.n + 1) as f64;
        let of = |l: usize| given.iter().enumerate().map(|(i, f)| f * self.at(l, i + 1)).sum::<f64>();
        (1..=self.n).map(|l| factor * of(l)).collect()
    }
}

/// The derivatives of order 0 to 4 of `sin(l pi x)` for `l` from 1 to `n`, one after the other.
pub(super) fn derivatives(n: usize, x: f64) -> [Vec<f64>; 5] {
    let waves: Vec<(f64, f64, f64)> = (1..=n)
        .map(|l| {
            let (c, s) = of_turns(0.5 * l as f64 * x);
            (core::f64::consts::PI * l as f64, c, s)
        })
        .collect();
    core::array::from_fn(|order| {
        let of = |&(k, c, s): &(f64, f64, f64)| {
            let turned = [s, c, -s, -c][order % 4];
            (0..order).fold(turned, |product, _| product * k)
        };
        waves.iter().map(of).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_transformed_comes_back_at_the_points() {
        for n in [1, 2, 5, 32] {
            let sines = Sines::new(n);
            let given: Vec<f64> = sines.points().map(|u| 1.0 + u * u - 3.0 * u * u * u).collect();
            let coefficients = sines.coefficients(&given);
            for (u, given) in sines.points().zip(&given) {
                let [values, ..] = derivatives(n, u);
                let sum: f64 = values.iter().zip(&coefficients).map(|(s, a)| s * a).sum();
                assert!((sum - given).abs() < 1e-13, "{n} at {u}");
            }
        }
    }

    #[test]
    fn one_sine_is_one_coefficient() {
        let sines = Sines::new(7);
        let given: Vec<f64> = sines.points().map(|u| 2.5 * (3.0 * core::f64::consts::PI * u).sin()).collect();
        for (l, a) in sines.coefficients(&given).into_iter().enumerate() {
            assert!((a - if l == 2 { 2.5 } else { 0.0 }).abs() < 1e-14);
        }
    }

    #[test]
    fn derivatives_are_those_of_sines() {
        let all = derivatives(3, 0.3);
        let k = 2.0 * core::f64::consts::PI;
        let expected = [(k * 0.3).sin(), k * (k * 0.3).cos(), -k * k * (k * 0.3).sin()];
        for (found, expected) in all.iter().zip(expected) {
            assert!((found[1] - expected).abs() < 1e-12);
        }
        assert!((all[4][1] - k.powi(4) * (k * 0.3).sin()).abs() < 1e-9);
    }
}
