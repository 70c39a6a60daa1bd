//! How strong a pull is round the axis.

use core::f64::consts::{LN_2, TAU};

/// `cos^(2N)(p (v - v0) / 2)`: a trigonometric polynomial of degree `N` in `p (v - v0)`, never negative, 1 at `v0` and at the `p - 1` other petals. No other of so few modes is as
/// narrow.
///
/// `cos^(2N)(x / 2) = sum_k C(2N, N - k) cos(k x) / 4^N` over `k` from `-N` to `N`. `N = 0` is 1 everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Bump {
    /// `N`.
    degree: u32,
    /// `p`.
    petals: u32,
}

/// `N p`, the most waves that a bump puts round the axis.
pub(super) const MOST_WAVES: u32 = 256;

impl Bump {
    /// The bump whose width at half its height is nearest to that asked for; `None` where it would take more than [`MOST_WAVES`].
    ///
    /// `cos^(2N)(x / 2) = 1/2` at `x = 2 acos(2^(-1/(2N)))`, so that `N = ln 2 / (-2 ln cos(x / 2))` for a width of `2 x`.
    pub(super) fn of_width(width: Option<f64>, petals: u32) -> Option<Bump> {
        let half = width.map_or(f64::INFINITY, |width| 0.25 * width * f64::from(petals));
        let degree = if half < 0.25 * TAU { libm::round(LN_2 / (2.0 * libm::log(libm::cos(half)).abs())) } else { 0.0 };
        let is_narrow = !(degree * f64::from(petals) <= f64::from(MOST_WAVES));
        (!is_narrow).then_some(Bump { degree: degree as u32, petals })
    }

    /// The narrowest width that [`Bump::of_width`] takes.
    pub(super) fn least_width(petals: u32) -> f64 {
        let degree = f64::from(MOST_WAVES / petals);
        4.0 * libm::acos(libm::exp2(-0.5 / (degree + 0.5))) / f64::from(petals)
    }

    /// Whether it is 1 everywhere.
    pub(super) fn is_round(self) -> bool {
        self.degree == 0
    }

    /// The waves that it is the sum of, the constant first: how many go round, and the amplitude of `cos n (v - v0)`.
    pub(super) fn waves(self) -> impl Iterator<Item = (u32, f64)> {
        let Bump { degree, petals } = self;
        // C(2N, N) / 4^N
        let middle = (1..=degree).fold(1.0, |product, j| product * f64::from(2 * j - 1) / f64::from(2 * j));
        let both_sides = (1..=degree).scan(2.0 * middle, move |amplitude, k| {
            *amplitude *= f64::from(degree + 1 - k) / f64::from(degree + k);
            Some((k * petals, *amplitude))
        });
        core::iter::once((0, middle)).chain(both_sides)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(bump: Bump, x: f64) -> f64 {
        bump.waves().map(|(n, amplitude)| amplitude * libm::cos(f64::from(n) * x)).sum()
    }

    #[test]
    fn a_bump_is_the_power_of_a_cosine() {
        for (degree, petals) in [(0, 1), (1, 1), (6, 1), (64, 1), (5, 4)] {
            let bump = Bump { degree, petals };
            assert_eq!(bump.waves().count(), degree as usize + 1);
            for x in [0.0, 0.1, 0.7, 2.0, 3.1, -1.3] {
                let power = libm::pow(libm::cos(0.5 * f64::from(petals) * x), 2.0 * f64::from(degree));
                assert!((value(bump, x) - power).abs() < 1e-14, "N = {degree}, p = {petals} at {x}");
            }
        }
    }

    #[test]
    fn a_bump_is_about_as_wide_as_was_asked_for() {
        for petals in [1, 3] {
            for width in [0.5, 0.8, 1.5, 2.0] {
                let width = width / f64::from(petals);
                let bump = Bump::of_width(Some(width), petals).unwrap();
                let half = value(bump, 0.5 * width);
                assert!((half - 0.5).abs() < 0.1, "{width} of {petals}: {half} at half its width");
            }
        }
    }

    #[test]
    fn a_pull_without_width_is_the_same_all_round() {
        assert_eq!(Bump::of_width(None, 1), Some(Bump { degree: 0, petals: 1 }));
        assert_eq!(Bump::of_width(Some(TAU), 1), Some(Bump { degree: 0, petals: 1 }));
    }

    #[test]
    fn what_is_too_narrow_is_refused() {
        for petals in [1, 2, 7, MOST_WAVES] {
            let least = Bump::least_width(petals);
            assert!(Bump::of_width(Some(1.001 * least), petals).is_some(), "{petals}");
            assert!(Bump::of_width(Some(0.999 * least), petals).is_none(), "{petals}");
        }
        assert!(Bump::of_width(Some(1e-300), 1).is_none());
    }
}
