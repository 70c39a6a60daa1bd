//! From samples round the axis to a mean and waves.

use core::f64::consts::TAU;

use crate::design::{Series, Wave};

/// The trigonometric polynomial through samples at equal angles that has so many waves at most, without those that are not seen: waves are left out, the smallest first, as long as all of these together reach no further than `unseen`; a wave `n` is seen as `seen(n)` times what it is.
pub(super) fn series(samples: &[f64], most: usize, unseen: f64, seen: impl Fn(f64) -> f64) -> Series {
    let size = |wave: &Wave| seen(wave.n) * libm::hypot(wave.cos, wave.sin);
    let n = samples.len();
    let table: Vec<(f64, f64)> =
        (0..n).map(|i| TAU * i as f64 / n as f64).map(|angle| (libm::cos(angle), libm::sin(angle))).collect();
    let mean = samples.iter().sum::<f64>() / n as f64;
    let wave = |k: usize| {
        let sums = samples.iter().enumerate().fold((0.0, 0.0), |(cos, sin), (i, sample)| {
            let (c, s) = table[i * k % n];
            (cos + sample * c, sin + sample * s)
        });
        Wave { n: k as f64, cos: 2.0 * sums.0 / n as f64, sin: 2.0 * sums.1 / n as f64 }
    };
    let mut waves: Vec<Wave> = (1..=most.min((n - 1) / 2)).map(wave).collect();
    waves.sort_by(|one, other| size(other).total_cmp(&size(one)));
    let mut left_out = 0.0;
    while let Some(smallest) = waves.last() {
        left_out += size(smallest);
        if left_out > unseen {
            break;
        }
        waves.pop();
    }
    waves.sort_by(|one, other| one.n.total_cmp(&other.n));
    Series { mean, waves }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_are_found_again() {
        let n = 32;
        let samples: Vec<f64> = (0..n)
            .map(|i| TAU * f64::from(i) / f64::from(n))
            .map(|v| 2.0 + 0.5 * libm::cos(3.0 * v) - 0.25 * libm::sin(7.0 * v) + 1e-6 * libm::cos(9.0 * v))
            .collect();
        let Series { mean, waves } = series(&samples, 12, 2e-6, |_| 1.0);
        assert!((mean - 2.0).abs() < 1e-14);
        let [three, seven] = &waves[..] else { panic!("{waves:?}") };
        assert!(three.n == 3.0 && (three.cos - 0.5).abs() < 1e-14 && three.sin.abs() < 1e-14);
        assert!(seven.n == 7.0 && (seven.sin + 0.25).abs() < 1e-14 && seven.cos.abs() < 1e-14);
        assert_eq!(series(&samples, 12, 1e-7, |_| 1.0).waves.len(), 3);
        assert_eq!(series(&samples, 12, 2e-6, |n| n).waves.len(), 3);
    }
}
