//! Integrals between two rows: [adaptive] along `a`, and the [trapezoidal rule](trapezoid) round `v`, where everything is periodic.

use core::f64::consts::TAU;

use super::accuracy::Accuracy;
use crate::numeric::adaptive;
use crate::numeric::integral::{Integral, ROUNDING};
use crate::numeric::trapezoid;

/// Integrates between two rows of a face that is closed round `v`, with respect to `da dv`: the integrand brings its own area element.
pub(crate) fn between<const N: usize>(
    (from, to): (f64, f64),
    accuracy: &Accuracy,
    integrand: impl FnMut(f64, f64) -> [f64; N],
) -> Integral<N> {
    let mut row = Round::new(accuracy, integrand);
    let breaks = accuracy.breaks(from, to);
    let most_intervals = accuracy.most_intervals.max(if accuracy.knots.is_empty() { 0 } else { 4 * breaks.len() });
    adaptive::integrate(&breaks, accuracy.relative, [0.0; N], most_intervals, |a| row.at(a))
}

/// The places of a face beyond which its rows get no more columns, however rough they are: the last change of each says by how much they are off.
const MOST_PLACES: usize = 1 << 20;

/// Integrals round one row, with as many columns as it takes.
pub(crate) struct Round<const N: usize, F> {
    at: F,
    relative: f64,
    columns: usize,
    most: usize,
    /// How many places were asked for in all rows.
    n_places: usize,
    /// The largest size of any row so far: small rows need not be more accurate than large ones.
    largest: [f64; N],
}

impl<const N: usize, F: FnMut(f64, f64) -> [f64; N]> Round<N, F> {
    /// For a function of `(a, v)`.
    pub(crate) fn new(accuracy: &Accuracy, at: F) -> Self {
        let Accuracy { relative, columns, most_columns: most, .. } = *accuracy;
        Round { at, relative, columns, most, n_places: 0, largest: [0.0; N] }
    }

    /// The integrals over `v` at one `a`, with more columns until that changes too little.
    pub(crate) fn at(&mut self, a: f64) -> Integral<N> {
        let Round { at, relative, columns, most, n_places, largest } = self;
        let most = if *n_places < MOST_PLACES { *most } else { 0 };
        // The last change of a row is far more than what is left of its error; what changes by rounding alone is not worth more columns.
        let allowed = |size: &[f64; N]| {
            core::array::from_fn(|i| {
                largest[i] = largest[i].max(size[i]);
                *relative * largest[i]
            })
        };
        trapezoid::integrate(*columns, most, ROUNDING, allowed, |n| {
            *n_places += n;
            let step = TAU / n as f64;
            let mut sum = Integral::default();
            (0..n).for_each(|j| sum.add(&Integral::of(at(a, step * j as f64))));
            sum
        })
    }
}
