//! How large a mode's solution can be between two points.

use super::basis::{Basis, product};
use super::force::added;
use super::rate::Rate;
use super::{Equation, ModeSolution};
use crate::numeric::horner;

impl Equation {
    /// Bounds of `|q|` and its derivatives up to order `N - 1` on all of `[from, to]`, a part of [0, 1], for several solutions.
    ///
    /// Every function of the basis is bounded by itself and the bounds are added up, so the result may be several times too large where they cancel,
    /// but decays with the solution from the boundary that it comes from. A hyperbolic function of `x = u - 1/2` is largest in size at an end of every interval; a
    /// trigonometric one is bounded by 1, or by its argument.
    #[inline(never)]
    pub(crate) fn suprema<const N: usize, const M: usize>(
        &self,
        solutions: [&ModeSolution; M],
        from: f64,
        to: f64,
    ) -> [[f64; N]; M] {
        let reach = (from - 0.5).abs().max((to - 0.5).abs());
        let slow = match &self.basis {
            Basis::Slow(slow) => Some(slow),
            _ => None,
        };
        let needs_basis = slow.is_none() && solutions.iter().any(|solution| solution.factors() != [0.0; 4]);
        let basis = if needs_basis { self.basis.suprema::<N>(from, to) } else { [[0.0; N]; 4] };
        solutions.map(|solution| {
            if solution.is_zero() {
                return [0.0; N];
            }
            let (factors, particular) = (solution.factors(), solution.particular());
            if let Some(slow) = slow {
                return polynomial(solution.about_middle(|| added(slow.terms(factors), particular)), reach);
            }
            let mut suprema = polynomial::<N>(particular, reach);
            for (factor, function) in factors.iter().zip(&basis).filter(|(factor, _)| **factor != 0.0) {
                for (sum, value) in suprema.iter_mut().zip(function) {
                    *sum += factor.abs() * value;
                }
            }
            suprema
        })
    }
}

impl Basis {
    /// As `jets`, bounds of the sizes on an interval. Where all rates are small a solution is bounded as the power series that it is, and these are not asked for.
    fn suprema<const N: usize>(&self, from: f64, to: f64) -> [[f64; N]; 4] {
        match self {
            Basis::Single(rate) => {
                let (even, odd) = rate.suprema(from, to);
                [even, [0.0; N], odd, [0.0; N]]
            }
            Basis::Slow(_) => [[0.0; N]; 4],
            Basis::Products { sigma, delta } => {
                let ((c, s), (c_delta, s_delta)) = (sigma.suprema(from, to), delta.suprema(from, to));
                [product(&c, &c_delta), product(&s, &s_delta), product(&s, &c_delta), product(&c, &s_delta)]
            }
            Basis::Separate(first, second) => {
                let ((c1, s1), (c2, s2)) = (first.suprema(from, to), second.suprema(from, to));
                [c1, c2, s1, s2]
            }
        }
    }
}

impl Rate {
    /// Bounds of `|C|`, `|S|` and their derivatives.
    fn suprema<const N: usize>(self, from: f64, to: f64) -> ([f64; N], [f64; N]) {
        let (mut c, mut s) = if self.z < 0.0 {
            (1.0, (1.0 / self.oscillation()).min((from - 0.5).abs().max((to - 0.5).abs())))
        } else {
            let ((c0, s0), (c1, s1)) = (self.at(from), self.at(to));
            (c0.abs().max(c1.abs()), s0.abs().max(s1.abs()))
        };
        let (mut even, mut odd) = ([0.0; N], [0.0; N]);
        for order in 0..N {
            even[order] = c;
            odd[order] = s;
            (c, s) = (self.z.abs() * s, c);
        }
        (even, odd)
    }
}

/// Bounds of a polynomial in `x` and its derivatives for `|x| <= reach`.
fn polynomial<const N: usize>(coefficients: &[f64], reach: f64) -> [f64; N] {
    horner::derivatives(coefficients.iter().rev().map(|coefficient| coefficient.abs()), reach)
}

#[cfg(test)]
mod tests {
    use super::super::ModeData;
    use super::*;
    use crate::mode::Order;

    #[test]
    fn nothing_between_is_larger() {
        let force = [3.0, -20.0, 0.0, 40.0];
        let data = ModeData { start: 1.0, start_u: -3.0, end: -0.5, end_u: 2.0, force: &force };
        let mut checked = 0;
        for order in [Order::Second, Order::Fourth] {
            for t in [-30.0, -1.0, 0.0, 1e-9, 1.0, 10.1, 300.0] {
                for w in [-400.0, -1.0, 0.0, 1.0, 25.0, 26.0, 9e4] {
                    for k in [0.0, 1e-6, 1.0, 3.3, 40.0] {
                        let Ok(equation) = Equation::new(order, 1.0, t, w, k) else { continue };
                        let Ok(solution) = equation.solve(&data) else { continue };
                        for (from, to) in [(0.0, 0.01), (0.1, 0.5), (0.4, 0.7), (0.9, 1.0)] {
                            let [suprema] = equation.suprema::<5, 1>([&solution], from, to);
                            for i in 0..=20 {
                                let u = from + (to - from) * f64::from(i) / 20.0;
                                let [jet] = equation.jets::<5, 1>([&solution], u);
                                for (value, supremum) in jet.iter().zip(suprema) {
                                    assert!(
                                        value.abs() <= supremum * (1.0 + 1e-9) + 1e-9,
                                        "{order:?} t {t} w {w} k {k} at {u}: {jet:?} above {suprema:?}"
                                    );
                                }
                                checked += 1;
                            }
                        }
                    }
                }
            }
        }
        assert!(checked > 20_000);
    }
}
