//! The solutions of an equation of order 4 all of whose rates are small, by power series about the middle.

use wide::f64x2;

/// `q'''' - b q'' + c q = 0` where no rate is large.
///
/// Let `g` be the solution with `g(0) = 1`, `g'(0) = 0`, `g''(0) = b`, `g'''(0) = 0` and `G_m` its integral from 0, taken `m` times (a derivative where `m < 0`). With `x^m / m!` as 0 where `m < 0`
///
/// ```text
/// G_m = x^m / m! + b G_(m+2) - c G_(m+4)
/// ```
///
/// and the solutions with one of the first four derivatives 1 at 0 and the others 0 are `1 - c G_4`, `x - c G_5`, `G_2`, `G_3`. Their derivatives are such integrals too, so that two sums, of the even and of the odd ones, give all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slow {
    b: f64,
    c: f64,
    rate: f64,
}

/// `m` of the last term that is ever added: as many as a rate of 4 takes at three times the half-width, where surfaces go on beyond their rings. On them 24 is the most.
const LAST: usize = 40;

/// `1 / ((m + 1) (m + 2))`.
const STEPS: [f64; LAST + 4] = {
    let mut steps = [0.0; LAST + 4];
    let mut m = 0;
    while m < steps.len() {
        steps[m] = 1.0 / ((m + 1) * (m + 2)) as f64;
        m += 1;
    }
    steps
};

fn pair(steps: &[f64]) -> f64x2 {
    match steps {
        [even, odd] => f64x2::new([*even, *odd]),
        _ => f64x2::ZERO,
    }
}

impl Slow {
    /// With the size of its fastest rate, `max |r|` over the roots of `r^4 - b r^2 + c`.
    pub(super) fn new(b: f64, c: f64, rate: f64) -> Self {
        Slow { b, c, rate }
    }

    /// `m` of the last term that counts for `|x|` up to this: what is left out is below `2^-56` of the sum, roots that coincide included.
    fn last(&self, x: f64) -> usize {
        let rate = self.rate * f64::max(1.0, 2.0 * x);
        // Found by adding up what is left out, for rates up to 12.
        (2 * (1.35 * rate + 7.3) as usize).min(LAST)
    }

    /// `G_5`, `G_4` and so on down to `G_-4`, at `x`.
    #[inline(never)]
    fn integrals(&self, x: f64) -> [f64; 10] {
        let Slow { b, c, .. } = *self;
        let square = x * x;
        let [by, by_fourth] = [b * square, c * (square * square)].map(f64x2::splat);
        // In parts of x^m / m!, of an even m and of the odd one behind it at once; then those of m + 2 and m + 4.
        let [mut here, mut next, mut after] = [f64x2::ONE; 3];
        let mut steps = STEPS[..self.last(x.abs()) + 4].chunks_exact(2).rev().map(pair);
        let mut behind = steps.next().unwrap_or(f64x2::ZERO);
        for step in steps {
            (next, after) = (here, next);
            here = (f64x2::ONE - by_fourth * (step * behind) * after) + by * step * next;
            behind = step;
        }
        let [[zeroth, first], [second, third], [fourth, fifth]] = [here, next, after].map(f64x2::to_array);
        let cube = square * x;
        let [first, second, third] = [x * first, square / 2.0 * second, cube / 6.0 * third];
        let (fourth, fifth) = (square * square / 24.0 * fourth, square * cube / 120.0 * fifth);
        let mut integrals = [fifth, fourth, third, second, first, zeroth, 0.0, 0.0, 0.0, 0.0];
        for index in 6..integrals.len() {
            integrals[index] = b * integrals[index - 2] - c * integrals[index - 4];
        }
        integrals
    }

    /// The even solutions with value and with second derivative 1 at the middle, then the odd ones with slope and with third derivative 1, at `x` with their derivatives up to order `N - 1`. `N` is 6 at most.
    pub(super) fn jets<const N: usize>(&self, x: f64) -> [[f64; N]; 4] {
        let (c, integrals) = (self.c, self.integrals(x));
        let mut jets = [[0.0; N]; 4];
        for order in 0..N {
            jets[0][order] = -c * integrals[1 + order];
            jets[1][order] = integrals[3 + order];
            jets[2][order] = -c * integrals[order];
            jets[3][order] = integrals[2 + order];
        }
        for (function, polynomial) in [(0, [1.0, 0.0]), (2, [x, 1.0])] {
            for (value, term) in jets[function].iter_mut().zip(polynomial) {
                *value += term;
            }
        }
        jets
    }

    /// The power series in `x` of the solution with these factors of the four.
    pub(super) fn terms(&self, [value, second, slope, third]: [f64; 4]) -> Vec<f64> {
        let n_terms = self.last(0.5) + 1;
        let mut terms = Vec::with_capacity(n_terms);
        terms.extend([value, slope, 0.5 * second, third / 6.0]);
        for m in 4..n_terms {
            terms.push((self.b * terms[m - 2] - self.c * STEPS[m - 4] * terms[m - 4]) * STEPS[m - 2]);
        }
        terms
    }

    /// The size of the fastest rate.
    pub(super) fn rate(&self) -> f64 {
        self.rate
    }
}

#[cfg(test)]
mod tests {
    use super::super::order::Order;
    use super::super::roots::largest_rate;
    use super::*;

    /// Of every regime, up to the largest rate that there is a series for.
    fn equations() -> Vec<Slow> {
        let coefficients = [-31.0, -8.0, -1.0, 0.0, 1e-9, 0.7, 5.0, 16.0, 31.0];
        let all = coefficients.iter().flat_map(|b| [-250.0, -3.0, 0.0, 0.25 * b * b, 40.0, 255.0].map(|c| (*b, c)));
        let slow = all.map(|(b, c)| Slow::new(b, c, largest_rate(Order::Fourth, b, c)));
        slow.filter(|slow| slow.rate <= 4.0).collect()
    }

    /// The solution that begins with these four derivatives, summed up term by term, with its derivatives; and what its terms would be if none cancelled.
    fn summed(Slow { b, c, .. }: Slow, begin: [f64; 4], x: f64) -> [[f64; 2]; 6] {
        let mut derivatives = begin.to_vec();
        for m in 4..120 {
            derivatives.push(b * derivatives[m - 2] - c * derivatives[m - 4]);
        }
        core::array::from_fn(|order| {
            let mut power = 1.0;
            let [mut sum, mut size] = [0.0f64; 2];
            for (m, derivative) in derivatives[order..].iter().enumerate() {
                sum += derivative * power;
                size += (derivative * power).abs();
                power *= x / (m + 1) as f64;
            }
            [sum, size]
        })
    }

    const BEGIN: [[f64; 4]; 4] =
        [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

    #[test]
    fn the_four_solutions_are_what_their_series_add_up_to() {
        let equations = equations();
        assert!(equations.len() > 25);
        for slow in equations {
            for (x, within) in [(0.0, 2e-15), (0.013, 2e-15), (-0.3, 2e-15), (0.5, 2e-15), (0.9, 1e-14), (-1.5, 1e-12)]
            {
                let jets = slow.jets::<6>(x);
                for (jet, begin) in jets.iter().zip(BEGIN) {
                    // Against the largest that there is of its kind: a derivative may pass through 0.
                    let growth = f64::max(1.0, slow.rate);
                    for (order, (value, [sum, size])) in jet.iter().zip(summed(slow, begin, x)).enumerate() {
                        let scale = size + libm::pow(growth, order as f64);
                        assert!(
                            (value - sum).abs() <= within * scale,
                            "{slow:?} {begin:?} at {x}, {order}: {value}, not {sum}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn a_solution_is_its_power_series() {
        let factors = [0.3, -2.0, 0.7, 5.0];
        for slow in equations() {
            let terms = slow.terms(factors);
            for x in [-0.5, 0.2, 0.5] {
                let found = terms.iter().rev().fold(0.0, |sum, term| sum * x + term);
                let expected: f64 = slow.jets::<1>(x).iter().zip(factors).map(|([value], factor)| factor * value).sum();
                assert!((found - expected).abs() < 1e-14, "{slow:?} at {x}: {found}, not {expected}");
            }
        }
    }
}
