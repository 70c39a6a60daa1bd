//! What is asked of an integral over a face.

use crate::numeric::trapezoid::prime;

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

/// What is asked at most of an integral over a face with seams: what is found is far better than that as a rule, because the longer of two rules counts and their difference is the error.
const SEAMED: f64 = 1e-5;
