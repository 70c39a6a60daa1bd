//! Taylor expansions of a mode: many rows from one evaluation of its exponentials.

use super::solution::ModeSolution;
use super::{Equation, series};
use crate::design::Order;

/// Terms of an expansion. On an interval that is no longer than [`Equation::reach`] allows, what is left out is below `1 / 14!`, some
/// 1e-11 of the mode: a thousandth of what single precision can show.
pub(crate) const TERMS: usize = 14;

/// `q(centre + half x)` on `x` in [-1, 1], lowest power first.
pub(crate) type Expansion = [f64; TERMS];

impl Equation {
    /// The half-width on which [`TERMS`] terms are enough: the reciprocal of the fastest rate; a force of higher degree bends faster than the rates say. 0 where no width is.
    pub(crate) fn reach(&self, solution: &ModeSolution) -> f64 {
        let degree = solution.force_len();
        if degree > TERMS / 2 { 0.0 } else { 1.0 / (self.largest_rate() + 2.0 * degree as f64) }
    }

    /// The expansions of two solutions about `centre`, to be used up to `half` away from it.
    ///
    /// The derivatives follow from the first ones by the equation itself: those of the homogeneous part by
    /// `q^(m+4) = b q^(m+2) - c q^(m)` (order 2: `q^(m+2) = b q^(m)`), those of the particular polynomial as they are.
    pub(crate) fn expansions(&self, solutions: [&ModeSolution; 2], centre: f64, half: f64) -> [Expansion; 2] {
        let needs_basis = solutions.iter().any(|solution| solution.factors() != [0.0; 4]);
        let basis = if needs_basis { self.basis.jets::<4>(centre) } else { [[0.0; 4]; 4] };
        solutions.map(|solution| {
            let mut derivatives = [0.0; TERMS];
            for (factor, function) in solution.factors().iter().zip(&basis) {
                // A factor 0 marks a function that is absent, and may stand beside an infinite derivative.
                if *factor != 0.0 {
                    for (sum, value) in derivatives.iter_mut().zip(function) {
                        *sum += factor * value;
                    }
                }
            }
            let n_known = if self.order == Order::Second { 2 } else { 4 };
            for m in n_known..TERMS {
                derivatives[m] = match self.order {
                    Order::Second => self.b * derivatives[m - 2],
                    Order::Fourth => self.b * derivatives[m - 2] - self.c * derivatives[m - 4],
                };
            }
            let polynomial = series::jet::<TERMS>(solution.particular(), centre);
            for (sum, value) in derivatives.iter_mut().zip(polynomial) {
                *sum += value;
            }
            let mut power = 1.0;
            for (m, term) in derivatives.iter_mut().enumerate() {
                *term *= power;
                power *= half / (m + 1) as f64;
            }
            derivatives
        })
    }
}
