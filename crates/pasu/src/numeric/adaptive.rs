//! Adaptive quadrature: the [Gauss-Kronrod](super::gauss_kronrod) rule on intervals that are halved where it is not good enough (R. Piessens and others, *QUADPACK*, 1983, routine `QAGP`).

use super::gauss_kronrod;
use super::integral::{Integral, ROUNDING};
use crate::watch;

/// Integrates a function of one variable that comes with errors of its own, over the intervals between the breaks; the interval with the largest error
/// is halved until the sum is accurate enough or there are too many. What is accurate enough goes by the integral of the absolute value or by `at_least`, whichever is larger.
///
/// The error is that of the rule, estimated, the integral of the function's own errors, and rounding; where `most_intervals` are not enough, it says by how much. Between breaks the function is to be smooth: a kink costs a halving for each bit of its place. Breaks that do not ascend
/// bound an interval without content.
pub(crate) fn integrate<const N: usize>(
    breaks: &[f64],
    relative: f64,
    at_least: [f64; N],
    most_intervals: usize,
    mut at: impl FnMut(f64) -> Integral<N>,
) -> Integral<N> {
    let mut intervals: Vec<Interval<N>> = Vec::with_capacity(breaks.len());
    for ends in breaks.windows(2).filter(|ends| ends[0] < ends[1]) {
        intervals.push(Interval::new(ends[0], ends[1], &mut at));
    }
    loop {
        let mut total = Integral::default();
        let mut of_rule = [0.0; N];
        for interval in &intervals {
            total.add(&interval.integral);
            for (sum, error) in of_rule.iter_mut().zip(interval.of_rule) {
                *sum += error;
            }
        }
        let allowed: [f64; N] = core::array::from_fn(|i| relative * total.size[i].max(at_least[i]));
        // What the function itself is off does not shrink when an interval does.
        let done = watch::is_stopped() || (0..N).all(|i| of_rule[i] <= allowed[i]);
        let worst = (0..intervals.len())
            .max_by(|&i, &j| intervals[i].excess(&allowed).total_cmp(&intervals[j].excess(&allowed)).then(j.cmp(&i)));
        let Some(worst) = worst.filter(|_| !done && intervals.len() < most_intervals.max(breaks.len())) else {
            for ((error, of_rule), size) in total.error.iter_mut().zip(of_rule).zip(total.size) {
                *error += of_rule + ROUNDING * size;
            }
            return total;
        };
        let Interval { from, to, .. } = intervals[worst];
        let middle = 0.5 * from + 0.5 * to;
        intervals[worst] = Interval::new(from, middle, &mut at);
        intervals.push(Interval::new(middle, to, &mut at));
    }
}

/// One interval of a composite rule.
struct Interval<const N: usize> {
    from: f64,
    to: f64,
    /// With the errors of the function.
    integral: Integral<N>,
    /// The errors of the rule.
    of_rule: [f64; N],
}

impl<const N: usize> Interval<N> {
    fn new(from: f64, to: f64, at: &mut impl FnMut(f64) -> Integral<N>) -> Interval<N> {
        let mut integral = Integral::default();
        let mut gauss = Integral::<N>::default();
        let mut samples = [[0.0; N]; 21];
        for ((a, weight, gauss_weight), sample) in gauss_kronrod::nodes(from, to).zip(&mut samples) {
            let here = at(a);
            *sample = here.value;
            integral.add(&here.scaled(weight));
            gauss.add(&here.scaled(gauss_weight));
        }
        let of_rule = core::array::from_fn(|i| {
            let mean = integral.value[i] / (to - from);
            let departures = samples.iter().map(|sample| (sample[i] - mean).abs());
            let departure: f64 =
                gauss_kronrod::nodes(from, to).zip(departures).map(|((_, weight, _), d)| weight * d).sum();
            let difference = (integral.value[i] - gauss.value[i]).abs();
            // What is left is rounding, and halving would not help.
            if difference > ROUNDING * integral.size[i] { gauss_kronrod::error(difference, departure) } else { 0.0 }
        });
        Interval { from, to, integral, of_rule }
    }

    /// The largest error of the rule in terms of what is allowed.
    fn excess(&self, allowed: &[f64; N]) -> f64 {
        (0..N).fold(0.0, |most, i| if self.of_rule[i] > 0.0 { most.max(self.of_rule[i] / allowed[i]) } else { most })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integral(breaks: &[f64], relative: f64, most: usize, of: impl Fn(f64) -> f64) -> (Integral<1>, usize) {
        let mut asked = 0;
        let found = integrate(breaks, relative, [0.0], most, |x| {
            asked += 1;
            Integral::of([of(x)])
        });
        (found, asked)
    }

    #[test]
    fn smooth_functions_take_one_interval() {
        let (found, asked) = integral(&[0.0, 1.0], 1e-12, 32, libm::exp);
        assert!((found.value[0] - (core::f64::consts::E - 1.0)).abs() <= found.error[0] && found.error[0] < 2e-14);
        assert_eq!(asked, 21);
    }

    #[test]
    fn a_peak_is_halved_towards() {
        let (width, exact) = (1e-3, 1e-3 * (libm::atan(300.0) + libm::atan(700.0)));
        let peak = |x: f64| width * width / (width * width + (x - 0.3) * (x - 0.3));
        let (found, asked) = integral(&[0.0, 1.0], 1e-10, 64, peak);
        assert!((found.value[0] - exact).abs() <= found.error[0] && found.error[0] <= 1.1e-10 * exact, "{found:?}");
        assert!(asked < 60 * 21, "{asked}");
    }

    #[test]
    fn a_kink_is_no_trouble_at_a_break_and_admitted_elsewhere() {
        let (at_break, asked) = integral(&[0.0, 0.3, 1.0], 1e-12, 8, |x| (x - 0.3).abs());
        assert!((at_break.value[0] - 0.29).abs() < 1e-15 && asked == 42);
        let (elsewhere, _) = integral(&[0.0, 1.0], 1e-12, 4, |x| (x - 0.3).abs());
        assert!((elsewhere.value[0] - 0.29).abs() <= elsewhere.error[0] && elsewhere.error[0] > 1e-9, "{elsewhere:?}");
    }

    #[test]
    fn errors_of_the_function_stay() {
        let found = integrate(&[0.0, 2.0], 1e-12, [0.0], 8, |x| Integral { error: [1e-3], ..Integral::of([x]) });
        assert!((found.value[0] - 2.0).abs() < 1e-14 && (found.error[0] - 2e-3).abs() < 1e-13, "{found:?}");
    }

    #[test]
    fn no_interval_makes_nothing() {
        assert_eq!(integral(&[1.0, 1.0], 1e-9, 4, libm::exp), (Integral::default(), 0));
        assert_eq!(integral(&[], 1e-9, 4, libm::exp), (Integral::default(), 0));
    }
}
