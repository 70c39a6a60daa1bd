//! The equation of a mode, reduced to the two numbers that decide its regime.

use super::basis::Basis;
use super::order::Order;
use super::pair::Pair;
use super::roots::{largest_rate, rate_of, roots, swing};
use super::unsolvable::Unsolvable;

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
    ///
    /// ```
    /// use pasu::{Equation, Order, Unsolvable};
    ///
    /// assert!(Equation::new(Order::Second, 1.0, 1.0, 0.0, 3.0).is_ok());
    /// assert_eq!(Equation::new(Order::Second, 0.0, 1.0, 0.0, 3.0), Err(Unsolvable::NoHighestDerivative));
    /// // q'' + pi^2 q = 0 does not say how far q swings between q(0) = 0 and q(1) = 0.
    /// assert_eq!(Equation::new(Order::Second, 1.0, -1.0, 0.0, std::f64::consts::PI), Err(Unsolvable::Resonant));
    /// ```
    pub fn new(order: Order, s: f64, t: f64, w: f64, k: f64) -> Result<Self, Unsolvable> {
        let [b, c] = Self::coefficients(order, s, t, w, k)?;
        let roots = roots(order, b, c);
        Self::of_coefficients(order, s, [b, c], rate_of(roots, c), roots)
    }

    /// The operator with these coefficients, this largest rate and these [`roots`] on an interval of this length, as an equation on [0, 1]: the rates grow shorter with it.
    pub(super) fn on(
        order: Order,
        s: f64,
        [b, c]: [f64; 2],
        rate: f64,
        all: Option<(f64, f64)>,
        length: f64,
    ) -> Result<Self, Unsolvable> {
        if length == 1.0 {
            return Self::of_coefficients(order, s, [b, c], rate, all);
        }
        let square = length * length;
        let [b, c] = [b * square, c * (square * square)];
        Self::of_coefficients(order, s, [b, c], rate * length, roots(order, b, c))
    }

    #[inline(never)]
    fn of_coefficients(
        order: Order,
        s: f64,
        [b, c]: [f64; 2],
        rate: f64,
        roots: Option<(f64, f64)>,
    ) -> Result<Self, Unsolvable> {
        let basis = Basis::of(order, [b, c], rate, roots);
        let halves = basis.halves();
        basis.check(&halves)?;
        Ok(Equation { order, s, b, c, basis, halves })
    }

    /// The operator of one mode, divided by `s`: `b` and `c`.
    ///
    /// # Errors
    /// As [`Equation::new`], but for resonance.
    pub(super) fn coefficients(order: Order, s: f64, t: f64, w: f64, k: f64) -> Result<[f64; 2], Unsolvable> {
        if s == 0.0 {
            return Err(Unsolvable::NoHighestDerivative);
        }
        let b = k * k * (t / s);
        let c = match order {
            Order::Second => 0.0,
            Order::Fourth => k * k * (w / s) * (k * k),
        };
        if b.is_finite() && c.is_finite() && s.is_finite() { Ok([b, c]) } else { Err(Unsolvable::Overflow) }
    }

    /// The size of the fastest rate, `max |r|` over the roots of the characteristic polynomial.
    ///
    /// ```
    /// use pasu::{Equation, Order};
    ///
    /// // q'' - t k^2 q = 0 grows and falls as exp(k sqrt(t) u).
    /// let equation = Equation::new(Order::Second, 1.0, 4.0, 0.0, 3.0)?;
    /// assert!((equation.largest_rate() - 6.0).abs() < 1e-14);
    /// # Ok::<(), pasu::Unsolvable>(())
    /// ```
    pub fn largest_rate(&self) -> f64 {
        largest_rate(self.order, self.b, self.c)
    }

    /// The rate of the fastest solution that swings without falling off, in radians from `u = 0` to 1; 0 where none does.
    pub(crate) fn swing(&self) -> f64 {
        swing(self.order, self.b, self.c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
