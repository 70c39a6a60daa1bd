//! A computed number and how far it may be off.

use core::ops::{Add, AddAssign, Mul};

use crate::answer::answers;

answers! {
    /// A value with a bound on its error, both in the same unit.
    ///
    /// The error is an estimate on the safe side: what the last refinement changed, and the rounding of the sums. It covers the quadrature and the search, not the clay.
    #[derive(Copy, Default)]
    pub struct Quantity as "Quantity" {
        /// The value.
        pub value: f64,
        /// How far it may be off; never negative.
        pub error: f64,
    }
}

impl Quantity {
    /// A value and its error.
    pub(crate) fn new(value: f64, error: f64) -> Self {
        Quantity { value, error }
    }

    /// A value found by a search to the end: off by rounding at the size of the numbers that went into it.
    pub(crate) fn rounded(value: f64, size: f64) -> Self {
        Quantity { value, error: ROUNDING * size.abs().max(value.abs()) }
    }
}

/// What the last steps of a search and the evaluation of a face leave, as a part of the largest number involved: measured 2e-14 at most.
pub(crate) const ROUNDING: f64 = 1e-13;

impl Add for Quantity {
    type Output = Quantity;

    fn add(self, other: Quantity) -> Quantity {
        Quantity { value: self.value + other.value, error: self.error + other.error }
    }
}

impl AddAssign for Quantity {
    fn add_assign(&mut self, other: Quantity) {
        *self = *self + other;
    }
}

impl Mul<f64> for Quantity {
    type Output = Quantity;

    fn mul(self, factor: f64) -> Quantity {
        Quantity { value: self.value * factor, error: self.error * factor.abs() }
    }
}
