//! The equation of a mode, reduced to the two numbers that decide its regime.

use libm::hypot;

use super::basis::Basis;
use super::force;
use super::pair::Pair;
use super::solution::{ModeData, ModeSolution};
use crate::design::Order;

/// Why a mode problem has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unsolvable {
    /// The shape control parameter of the highest derivative is 0.
    NoHighestDerivative,
    /// Oscillating solutions whose boundary matrix is singular, or so nearly that no digit of the answer could be promised.
    Resonant,
    /// The numbers leave the range of doubles.
    Overflow,
}

/// The operator of one mode divided by `s`: `q'' - b q` for order 2 (`c` is 0), `q'''' - b q'' + c q` for order 4,
/// with `b = t k^2 / s` and `c = w k^4 / s`.
///
/// Everything that depends on the equation alone is computed once, for any number of boundary data.
#[derive(Debug, Clone, PartialEq)]
pub struct Equation {
    pub(super) order: Order,
    pub(super) s: f64,
    pub(super) b: f64,
    pub(super) c: f64,
    pub(super) basis: Basis,
    /// The even and the odd functions of the basis at `u = 1`.
    pub(super) halves: [Pair; 2],
}

impl Equation {
    /// The equation of the mode with angular frequency `k` and shape control parameters `s`, `t`, `w` (`w` is not used by order 2).
    ///
    /// # Errors
    /// [`Unsolvable::NoHighestDerivative`] if `s = 0`, [`Unsolvable::Overflow`] if a parameter or a coefficient is not finite,
    /// [`Unsolvable::Resonant`] if the homogeneous problem has a solution of its own, for instance order 2 with `k sqrt(-t/s) = m pi`.
    pub fn new(order: Order, s: f64, t: f64, w: f64, k: f64) -> Result<Self, Unsolvable> {
        if s == 0.0 {
            return Err(Unsolvable::NoHighestDerivative);
        }
        let b = k * k * (t / s);
        let c = match order {
            Order::Second => 0.0,
            Order::Fourth => k * k * (w / s) * (k * k),
        };
        if !(b.is_finite() && c.is_finite() && s.is_finite()) {
            return Err(Unsolvable::Overflow);
        }
        let (basis, halves) = Basis::of(order, b, c)?;
        Ok(Equation { order, s, b, c, basis, halves })
    }

    /// The solution with the given boundary data and force.
    ///
    /// Accuracy: `1e-10` of the largest datum for `q` and `1e-9 max(1, k sqrt(t/s))` of it for `q'`, for rates up to 1e3
    /// (in practice about `1e-13`; see `tests/mode.rs`).
    ///
    /// # Errors
    /// [`Unsolvable::Overflow`] if the solution leaves the range of doubles.
    pub fn solve(&self, data: &ModeData) -> Result<ModeSolution, Unsolvable> {
        if data.is_zero() {
            return Ok(ModeSolution::zero());
        }
        let force = force::particular(self, data.force);
        ModeSolution::meeting(self, data, force)
    }

    /// The size of the fastest rate, `max |r|` over the roots of the characteristic polynomial.
    pub fn largest_rate(&self) -> f64 {
        largest_rate(self.order, self.b, self.c)
    }
}

pub(super) fn largest_rate(order: Order, b: f64, c: f64) -> f64 {
    match order {
        Order::Second => b.abs().sqrt(),
        Order::Fourth => match squared_roots(b, c) {
            Some((z, _)) => z.abs().sqrt(),
            None => c.sqrt().sqrt(),
        },
    }
}

/// The real roots of `z^2 - b z + c`, the larger in size first, or `None` when they are complex.
///
/// Neither the discriminant nor the smaller root is got by subtraction of near-equal numbers other than `b` and `2 sqrt(c)`.
pub(super) fn squared_roots(b: f64, c: f64) -> Option<(f64, f64)> {
    let discriminant_root = if c > 0.0 {
        let twice = 2.0 * c.sqrt();
        if b.abs() < twice {
            return None;
        }
        (b.abs() - twice).sqrt() * (b.abs() + twice).sqrt()
    } else {
        hypot(b, 2.0 * (-c).sqrt())
    };
    let large = 0.5 * (b.abs() + discriminant_root);
    if large == 0.0 {
        return Some((0.0, 0.0));
    }
    let large = if b < 0.0 { -large } else { large };
    Some((large, c / large))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_every_sign() {
        assert_eq!(squared_roots(5.0, 4.0), Some((4.0, 1.0)));
        assert_eq!(squared_roots(-5.0, 4.0), Some((-4.0, -1.0)));
        assert_eq!(squared_roots(0.0, -4.0), Some((2.0, -2.0)));
        assert_eq!(squared_roots(3.0, 0.0), Some((3.0, 0.0)));
        assert_eq!(squared_roots(0.0, 0.0), Some((0.0, 0.0)));
        assert_eq!(squared_roots(0.0, 4.0), None);
        assert_eq!(squared_roots(2.0, 1.0), Some((1.0, 1.0)));
    }

    #[test]
    fn a_missing_highest_derivative_is_refused() {
        assert_eq!(Equation::new(Order::Second, 0.0, 1.0, 0.0, 1.0), Err(Unsolvable::NoHighestDerivative));
    }

    #[test]
    fn resonance_is_refused() {
        for m in 1..20 {
            let t = -(m as f64 * std::f64::consts::PI);
            assert_eq!(Equation::new(Order::Second, 1.0, t * -t, 0.0, 1.0), Err(Unsolvable::Resonant), "m = {m}");
        }
    }
}
