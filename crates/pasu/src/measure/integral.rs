//! Integrals over a face: Gauss-Kronrod along `a`, halving where it is needed, and the trapezoidal rule round `v`.
//!
//! Round `v` everything is periodic, so that the trapezoidal rule converges faster than any power as soon as it resolves the petals (L. N. Trefethen and
//! J. A. C. Weideman, *The exponentially convergent trapezoidal rule*, 2014).

use core::f64::consts::TAU;

use super::{panels, rule};
use crate::solid::{Face, FaceJet};

/// What is asked of an integral.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Accuracy {
    /// The largest error, as a part of the integral of the absolute value.
    pub(crate) relative: f64,
    /// Columns to begin with: more than twice the highest harmonic, so that no petal is met at the same place each time.
    pub(crate) columns: usize,
    /// The most columns of a row.
    pub(crate) most_columns: usize,
    /// The most intervals along the face.
    pub(crate) most_intervals: usize,
    /// The largest error of what goes by an interpolated thickness.
    pub(crate) seamed: f64,
    /// The highest harmonic.
    pub(crate) highest: f64,
}

impl Accuracy {
    /// A relative error for a face of harmonics up to `highest`.
    pub(crate) fn new(relative: f64, highest: f64) -> Self {
        let highest = highest.abs().clamp(1.0, 1e5) as usize;
        Accuracy {
            relative,
            columns: prime(2 * highest + 13),
            most_columns: (64 * highest).clamp(1024, 8192),
            most_intervals: 32,
            seamed: relative.max(SEAMED),
            highest: highest as f64,
        }
    }
}

/// What is asked at most of an integral over a face with seams.
const SEAMED: f64 = 1e-7;

/// Several integrals over the same face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Integral<const N: usize> {
    /// The integrals.
    pub(crate) value: [f64; N],
    /// How far each may be off.
    pub(crate) error: [f64; N],
    /// The integrals of the absolute values: what errors are held against.
    pub(crate) size: [f64; N],
}

impl<const N: usize> Default for Integral<N> {
    fn default() -> Self {
        Integral { value: [0.0; N], error: [0.0; N], size: [0.0; N] }
    }
}

/// Rounding of a sum, as a part of the integral of the absolute value.
pub(super) const ROUNDING: f64 = 4e-15;

impl<const N: usize> Integral<N> {
    pub(crate) fn add(&mut self, other: &Integral<N>) {
        for i in 0..N {
            self.value[i] += other.value[i];
            self.error[i] += other.error[i];
            self.size[i] += other.size[i];
        }
    }

    /// With the rounding of a sum.
    pub(crate) fn rounded(mut self) -> Self {
        for (error, size) in self.error.iter_mut().zip(self.size) {
            *error += ROUNDING * size;
        }
        self
    }

    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let all = |numbers: [f64; N]| numbers.map(|x| factor * x);
        Integral { value: all(self.value), error: all(self.error), size: all(self.size) }
    }
}

/// Integrates over the whole face, with respect to `da dv`: the integrand brings its own area element.
pub(crate) fn over_face<const N: usize>(
    face: &dyn Face,
    accuracy: &Accuracy,
    integrand: impl Fn(&FaceJet) -> [f64; N],
) -> Integral<N> {
    match face.seams() {
        Some(seams) => panels::over_seamed(&seams, accuracy, integrand),
        None => between((0.0, 1.0), accuracy, |a, v| integrand(&face.jet(a, v))),
    }
}

/// The same between two rows.
pub(crate) fn between<const N: usize>(
    (from, to): (f64, f64),
    accuracy: &Accuracy,
    integrand: impl FnMut(f64, f64) -> [f64; N],
) -> Integral<N> {
    let mut row = Round::new(accuracy, integrand);
    along(&[from, to], accuracy.relative, [0.0; N], accuracy.most_intervals, |a| row.at(a))
}

/// Integrates a function of one variable that comes with errors of its own, over the intervals between the breaks; the interval with the largest error
/// is halved until the sum is accurate enough or there are too many. What is accurate enough goes by the integral of the absolute value or by `at_least`, whichever is larger.
pub(crate) fn along<const N: usize>(
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
        let done = (0..N).all(|i| of_rule[i] <= allowed[i]);
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
        for ((a, weight, gauss_weight), sample) in rule::nodes(from, to).zip(&mut samples) {
            let here = at(a);
            *sample = here.value;
            integral.add(&here.scaled(weight));
            gauss.add(&here.scaled(gauss_weight));
        }
        let of_rule = core::array::from_fn(|i| {
            let mean = integral.value[i] / (to - from);
            let departures = samples.iter().map(|sample| (sample[i] - mean).abs());
            let departure: f64 = rule::nodes(from, to).zip(departures).map(|((_, weight, _), d)| weight * d).sum();
            let difference = (integral.value[i] - gauss.value[i]).abs();
            // What is left is rounding, and halving would not help.
            if difference > ROUNDING * integral.size[i] { rule::error(difference, departure) } else { 0.0 }
        });
        Interval { from, to, integral, of_rule }
    }

    /// The largest error of the rule in terms of what is allowed.
    fn excess(&self, allowed: &[f64; N]) -> f64 {
        (0..N).fold(0.0, |most, i| if self.of_rule[i] > 0.0 { most.max(self.of_rule[i] / allowed[i]) } else { most })
    }
}

/// Integrals round one row, with as many columns as it takes.
pub(crate) struct Round<F> {
    at: F,
    relative: f64,
    columns: usize,
    most: usize,
    /// The largest size of any row so far: small rows need not be more accurate than large ones.
    largest: Vec<f64>,
}

impl<const N: usize, F: FnMut(f64, f64) -> [f64; N]> Round<F> {
    /// For a function of `(a, v)`.
    pub(crate) fn new(accuracy: &Accuracy, at: F) -> Self {
        // The last change of a row is far more than what is left of its error.
        let relative = accuracy.relative;
        Round { at, relative, columns: accuracy.columns, most: accuracy.most_columns, largest: vec![0.0; N] }
    }

    /// The integrals over `v` at one `a`, with more columns until that changes too little. The error is the last change.
    pub(crate) fn at(&mut self, a: f64) -> Integral<N> {
        let mut n = self.columns;
        let mut before = [0.0; N];
        for is_first in core::iter::once(true).chain(core::iter::repeat(false)) {
            let step = TAU / n as f64;
            let (mut sum, mut size) = ([0.0; N], [0.0; N]);
            for j in 0..n {
                add(&mut sum, &mut size, (self.at)(a, step * j as f64));
            }
            let (value, size) = (sum.map(|sum| step * sum), size.map(|size| step * size));
            // What changes by rounding alone is not worth more columns.
            let change: [f64; N] = core::array::from_fn(|i| {
                let change = (value[i] - before[i]).abs();
                if change <= ROUNDING * size[i] { 0.0 } else { change }
            });
            let mut done = !is_first;
            for i in 0..N {
                self.largest[i] = self.largest[i].max(size[i]);
                done &= change[i] <= self.relative * self.largest[i];
            }
            let next = finer(n);
            if done || next > self.most && !is_first {
                return Integral { value, error: change, size };
            }
            (n, before) = (next, value);
        }
        Integral::default()
    }
}

/// About twice as many columns: the next prime.
///
/// A shape of `m` equal petals is met by `n` columns in `n / gcd(n, m)` different places of a petal. Doubling an odd number of columns adds none if `m` is even; primes meet each in as many places as they can.
pub(crate) fn finer(n: usize) -> usize {
    prime(2 * n)
}

/// The least prime from a number on.
fn prime(from: usize) -> usize {
    let is_prime = |n: usize| (2..).take_while(|d| d * d <= n).all(|d| !n.is_multiple_of(d));
    (from.max(2)..).find(|&n| is_prime(n)).unwrap_or(from)
}

fn add<const N: usize>(sum: &mut [f64; N], size: &mut [f64; N], here: [f64; N]) {
    for i in 0..N {
        sum[i] += here[i];
        size[i] += here[i].abs();
    }
}
