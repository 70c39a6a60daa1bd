//! Golden sections: the extreme of a function of one variable with one extreme between two ends, by comparing values alone (J. Kiefer, *Sequential minimax search for a maximum*, 1953).
//!
//! Each step leaves 0.618 of the interval, whatever the function; values near a smooth extreme differ by less than rounding over half of the digits of its place, and what is beyond is chance. Where there are several extremes one of them is found. Where
//! digits of the place are wanted in few steps, [`brent`](super::brent) is quicker.
//!
//! There are two, which round differently: [`least`] forms one value a step and keeps the other, [`middle_of_greatest`] forms both at places that are measured from the ends anew.

/// `(sqrt(5) - 1) / 2`.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// The place of the least value between two ends and that value, after so many steps: one of the places that were looked at. Takes `steps + 2` values.
pub(crate) fn least(from: f64, to: f64, steps: usize, of: impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut from, mut to) = (from, to);
    let mut inner = [to - GOLDEN * (to - from), from + GOLDEN * (to - from)].map(|x| (x, of(x)));
    for _ in 0..steps {
        if inner[0].1 < inner[1].1 {
            to = inner[1].0;
            let x = to - GOLDEN * (to - from);
            inner = [(x, of(x)), inner[0]];
        } else {
            from = inner[0].0;
            let x = from + GOLDEN * (to - from);
            inner = [inner[1], (x, of(x))];
        }
    }
    if inner[0].1 < inner[1].1 { inner[0] } else { inner[1] }
}

/// The middle of what is left round the greatest value after so many steps. Takes `2 steps` values.
pub(crate) fn middle_of_greatest(from: f64, to: f64, steps: usize, of: impl Fn(f64) -> f64) -> f64 {
    let (mut from, mut to) = (from, to);
    for _ in 0..steps {
        let inner = [to - GOLDEN * (to - from), from + GOLDEN * (to - from)];
        if of(inner[0]) > of(inner[1]) { to = inner[1] } else { from = inner[0] }
    }
    0.5 * (from + to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_inside_at_ends_and_with_a_kink() {
        type Valley = (fn(f64) -> f64, f64, f64);
        let valleys: [Valley; 4] = [
            (|x| (x - 1.7).powi(2) + 4.0, 1.7, 1e-7),
            (|x| (x - 1.7).abs(), 1.7, 1e-9),
            (|x| x, 0.0, 1e-9),
            (|x| -x, 3.0, 1e-9),
        ];
        for (of, exact, within) in valleys {
            let (x, value) = least(0.0, 3.0, 48, of);
            assert!((x - exact).abs() <= within && value == of(x), "{x} {exact}");
            let x = middle_of_greatest(0.0, 3.0, 48, |x| -of(x));
            assert!((x - exact).abs() <= within, "{x} {exact}");
        }
    }

    #[test]
    fn a_step_leaves_the_golden_part() {
        for steps in [0, 1, 10, 30] {
            let x = middle_of_greatest(0.0, 1.0, steps, |x| x);
            assert!((1.0 - x - 0.5 * GOLDEN.powi(steps as i32)).abs() < 1e-14, "{steps}: {x}");
        }
    }
}
