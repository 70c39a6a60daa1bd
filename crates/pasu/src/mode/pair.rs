//! Two functions that meet two conditions at one end: the half of a mode problem.

use super::unsolvable::Unsolvable;

/// A determinant this small against its parts, per unit of oscillation, cannot be told from 0 to the promised 1e-10 of the solution:
/// the rounding of the parts, 2e-16 each, would be magnified beyond it.
const RESONANCE: f64 = 2e-6;

/// Value and slope at `u = 1` of two functions, with the determinant `f g' - f' g` where it is known better than by subtraction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pair {
    pub(super) first: [f64; 2],
    pub(super) second: [f64; 2],
    pub(super) determinant: f64,
}

impl Pair {
    pub(super) fn by_subtraction(first: [f64; 2], second: [f64; 2]) -> Self {
        Pair { first, second, determinant: first[0] * second[1] - first[1] * second[0] }
    }

    /// Refuses a determinant that may be 0. Only functions that oscillate, at `rate` in total, can have one.
    ///
    /// It is held against the sizes of both functions, value and slope taken together as `sqrt(f^2 + (f' / rate)^2)`: where a cosine
    /// stands still at the end, both products of the determinant vanish, and comparing it with these would see nothing.
    pub(super) fn check(&self, rate: f64) -> Result<(), Unsolvable> {
        let size = |f: [f64; 2]| libm::hypot(f[0], f[1] / rate);
        if rate > 0.0 && self.determinant.abs() < RESONANCE * (2.0 + rate) * rate * size(self.first) * size(self.second)
        {
            Err(Unsolvable::Resonant)
        } else {
            Ok(())
        }
    }

    /// The factors `(a, b)` for which `a first + b second` has the given value and slope (Cramer's rule).
    pub(super) fn meet(&self, value: f64, slope: f64) -> [f64; 2] {
        [
            (value * self.second[1] - slope * self.second[0]) / self.determinant,
            (slope * self.first[0] - value * self.first[1]) / self.determinant,
        ]
    }
}
