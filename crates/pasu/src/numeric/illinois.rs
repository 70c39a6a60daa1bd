//! Roots by false position, the Illinois form: secants whose idle end counts for half (M. Dowell and P. Jarratt, *A modified regula falsi method for computing the root of an equation*, BIT 11, 1971),
//! with a bisection now and then, so that no function keeps them waiting.
//!
//! There are two, because they answer different questions and round differently. [`root`] takes ends in any order with the values there, which its callers have, and looks for the place of least size. [`rise`] is for a function
//! that rises through 0 and forms the values at the ends itself; where no double is a root, it prefers the place from which on the function is not negative. A bisection comes when the secants have moved the same end four times in the first, and
//! at every fourth step in the second.

/// The most steps of [`root`]: more than three times those of a bisection to neighbouring doubles within [-1, 1].
const MOST_STEPS: usize = 200;

/// The most steps of [`rise`]: 30 bisections and 90 secants.
const MOST_STEPS_OF_RISE: usize = 120;

/// So many doubles apart, ends are as near as rounding lets a function tell.
const APART: f64 = 4.0 * f64::EPSILON;

/// Roots nearer to 0 than this are found to as much as those at it, not to the same part of themselves.
const SMALLEST: f64 = 1e-3;

/// The root of a function between two ends, each given with the value there, at which its signs differ, to the last bits.
///
/// The end at which the function is smaller in size once they are within four units in the last place, or after 200 steps; an end or a place where the function is 0 at once. Simple roots of smooth functions take about eight steps. Where the signs of the
/// ends do not differ it is one of the ends or a place between them, which says nothing of a root.
pub(crate) fn root(from: (f64, f64), to: (f64, f64), mut of: impl FnMut(f64) -> f64) -> f64 {
    let ((mut x0, mut f0), (mut x1, mut f1)) = (from, to);
    // How many times in a row the end 1 (counted upwards) or the end 0 (downwards) has moved.
    let mut side = 0i32;
    for _ in 0..MOST_STEPS {
        if f0 == 0.0 {
            return x0;
        }
        if f1 == 0.0 {
            return x1;
        }
        let gap = x1 - x0;
        if gap.abs() <= APART * x0.abs().max(x1.abs()).max(SMALLEST) {
            break;
        }
        let secant = x1 - f1 * gap / (f1 - f0);
        let within = (secant - x0) * (x1 - secant) > 0.0;
        let x = if within && side.abs() < 4 { secant } else { 0.5 * (x0 + x1) };
        let f = of(x);
        if (f < 0.0) == (f1 < 0.0) {
            (x1, f1) = (x, f);
            if side > 0 {
                f0 *= 0.5;
            }
            side = if side.abs() >= 4 { 0 } else { side.max(0) + 1 };
        } else {
            (x0, f0) = (x, f);
            if side < 0 {
                f1 *= 0.5;
            }
            side = if side.abs() >= 4 { 0 } else { side.min(0) - 1 };
        }
    }
    if f0.abs() < f1.abs() { x0 } else { x1 }
}

/// The root of a function that is negative at `low` and not at `high`, `0 <= low < high`, to rounding.
///
/// `high`, or where it has moved to, once it is a root or within four units in its last place of the other end; where no double is left between the two, the better of them.
pub(crate) fn rise(low: f64, high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let (mut f_low, mut f_high) = (f(low), f(high));
    for step in 0..MOST_STEPS_OF_RISE {
        if f_high == 0.0 || high - low <= APART * high {
            return high;
        }
        let share = if step % 4 == 3 { 0.5 } else { f_low / (f_low - f_high) };
        let middle = low + share * (high - low);
        if !(middle > low && middle < high) {
            // The two are neighbours, or one of them is the root to rounding.
            return if -f_low < f_high { low } else { high };
        }
        let f_middle = f(middle);
        if f_middle < 0.0 {
            (low, f_low) = (middle, f_middle);
            f_high *= if step % 4 == 3 { 1.0 } else { 0.5 };
        } else {
            (high, f_high) = (middle, f_middle);
            f_low *= if step % 4 == 3 { 1.0 } else { 0.5 };
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_between_ends_of_either_order() {
        for f in [|x: f64| x.powi(9) - 1e-5, |x: f64| (x - 0.3).tanh(), |x: f64| x - 0.999_999] {
            for (from, to) in [(0.0, 1.0), (1.0, 0.0)] {
                let mut n = 0;
                let x = root((from, f(from)), (to, f(to)), |x| {
                    n += 1;
                    f(x)
                });
                assert!(f(x).abs() < 1e-15 && n < 60, "{x} {} {n}", f(x));
            }
        }
    }

    #[test]
    fn an_end_that_is_the_root_comes_back() {
        let f = |x: f64| x - 0.25;
        assert_eq!(root((0.25, 0.0), (1.0, 0.75), f), 0.25);
        assert_eq!(root((0.0, -0.25), (0.25, 0.0), f), 0.25);
        assert_eq!(rise(0.0, 0.25, f), 0.25);
    }

    #[test]
    fn rises_are_found_to_rounding() {
        for (exact, f) in [
            (0.5f64.sqrt(), (|x: f64| x * x - 0.5) as fn(f64) -> f64),
            (0.3, |x| (x - 0.3) * (x - 0.3) * (x - 0.3)),
            (1e-3, |x| x - 1e-3),
            (0.9, |x| libm::exp(40.0 * x) - libm::exp(36.0)),
        ] {
            let found = rise(0.0, 1.0, f);
            assert!((found - exact).abs() < 1e-5 && f(found).abs() < 1e-15 * f(1.0).abs().max(1.0), "{found} {exact}");
        }
    }

    #[test]
    fn a_jump_is_as_good_as_a_root() {
        let step = |x: f64| if x < 0.6 { -1.0 } else { 1.0 };
        assert!((rise(0.0, 1.0, step) - 0.6).abs() < 1e-8);
        assert!((root((0.0, -1.0), (1.0, 1.0), step) - 0.6).abs() < 1e-15);
    }
}
