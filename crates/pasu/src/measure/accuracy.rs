//! What is asked of an integral over a face.

use crate::numeric::trapezoid::prime;

/// What is asked of an integral.
#[derive(Debug, Clone, PartialEq)]
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
    /// How fast a face may change next to its ends, as `exp(-rate a)`.
    pub(crate) rate: f64,
    /// Where derivatives of a face may jump along `a`, in ascending order.
    pub(crate) knots: Vec<f64>,
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
            rate: 0.0,
            knots: Vec::new(),
        }
    }

    /// The same for a face that changes as fast as this next to its ends.
    pub(crate) fn falling(self, rate: f64) -> Self {
        Accuracy { rate, ..self }
    }

    /// The same for a face whose derivatives may jump there.
    pub(crate) fn broken(self, knots: Vec<f64>) -> Self {
        Accuracy { knots, ..self }
    }

    /// Intervals by which an integral along a face begins: where a face changes so fast next to its ends that no node of a rule over the whole would see it, the ends are stepped towards.
    pub(crate) fn breaks(&self, from: f64, to: f64) -> Vec<f64> {
        let knots = self.knots_between(from, to);
        // Between knots the layers next to them are as wide as those next to the ends.
        let is_whole = knots.is_empty();
        self.breaks_at(knots, from, to, is_whole)
    }

    /// The same of a small part of a face: its layers are as wide as those of the whole.
    pub(crate) fn breaks_of_a_part(&self, from: f64, to: f64) -> Vec<f64> {
        self.breaks_at(self.knots_between(from, to), from, to, false)
    }

    /// The knots on the way from one place to another.
    fn knots_between(&self, from: f64, to: f64) -> Vec<f64> {
        let (least, most) = (from.min(to), from.max(to));
        let mut knots: Vec<f64> = self.knots.iter().copied().filter(|knot| least < *knot && *knot < most).collect();
        if to < from {
            knots.reverse();
        }
        knots
    }

    fn breaks_at(&self, knots: Vec<f64>, from: f64, to: f64, is_whole: bool) -> Vec<f64> {
        let mut breaks = vec![from];
        let mut from = from;
        for to in knots.into_iter().chain([to]) {
            let share = if is_whole { 1.0 } else { (to - from).abs() };
            Self::add_breaks(&mut breaks, from, to, LAYER / (self.rate * share));
            from = to;
        }
        breaks
    }

    /// Goes on from one knot to the next, whose layers are this share of it.
    fn add_breaks(breaks: &mut Vec<f64>, from: f64, to: f64, layer: f64) {
        if layer < NARROW {
            let steps =
                || core::iter::successors(Some(layer), |step| Some(step * STEP)).take_while(|step| *step < 0.25);
            let rising: Vec<f64> = steps().collect();
            breaks.extend(rising.iter().map(|step| from + step * (to - from)));
            breaks.extend(rising.iter().rev().map(|step| to - step * (to - from)));
        }
        breaks.push(to);
    }
}

/// What falls off as `exp(-x)` is down to rounding of a sum's other terms, and is integrated by one rule, up to here.
const LAYER: f64 = 12.0;

/// A layer narrower than this is stepped towards: a rule over the whole has two nodes within it.
const NARROW: f64 = 0.02;

/// By how much a step is longer than the one before.
const STEP: f64 = 4.0;

/// What is asked at most of an integral over a face with seams: what is found is far better than that as a rule, because the longer of two rules counts and their difference is the error.
pub(crate) const SEAMED: f64 = 1e-5;
