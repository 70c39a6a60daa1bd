//! Taylor expansions of a mode: many rows from one evaluation of its exponentials.

use super::equation::Equation;
use super::order::Order;
use super::series;
use super::solution::ModeSolution;

/// Terms of an expansion. On an interval that is no longer than [`Equation::reach`] allows, what is left out is below `0.7^12 / 12!`, some
/// 3e-11 of the mode: a thousandth of what single precision can show.
pub(crate) const TERMS: usize = 12;

/// The half-width of an interval in parts of the fastest rate's reciprocal.
const WIDTH: f64 = 0.7;

/// `q(centre + half x)` on `x` in [-1, 1].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Expansion {
    /// Lowest power first.
    pub(crate) terms: [f64; TERMS],
    /// How far values may be off, by the terms left out and by the rounding of those that cancel.
    pub(crate) noise: f64,
}

impl Expansion {
    /// How far slopes in `u` may be off, for one of so many expansions that cover [0, 1].
    pub(crate) fn slope_noise(&self, n_expansions: usize) -> f64 {
        // The slope of the first term left out is TERMS times the term, and a little more for the next.
        const STEEPER: f64 = (TERMS + 2) as f64;
        self.noise * STEEPER * 2.0 * n_expansions as f64
    }
}

/// An expansion is used a little beyond its interval, to where the first terms left out are less than seven times as large.
const BEYOND: f64 = 7.0;

/// What a term rounds by before it cancels with others, in parts of it: the few operations that a function of the basis and its factor are made by.
pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Derivatives that are looked at: two more than are kept.
const LOOKED_AT: usize = TERMS + 2;

impl Equation {
    /// The half-width on which [`TERMS`] terms are enough, in the scale of the fastest rate; a force of higher degree bends faster than the rates say. 0 where no width is.
    pub(crate) fn reach(&self, solution: &ModeSolution) -> f64 {
        let degree = solution.force_len();
        if degree > TERMS / 2 { 0.0 } else { WIDTH / (self.largest_rate() + 2.0 * degree as f64) }
    }

    /// The expansions of two solutions about `centre`, to be used up to `half` away from it.
    ///
    /// The derivatives follow from the first ones by the equation itself: those of the homogeneous part by
    /// `q^(m+4) = b q^(m+2) - c q^(m)` (order 2: `q^(m+2) = b q^(m)`), those of the particular polynomial as they are.
    pub(crate) fn expansions(&self, solutions: [&ModeSolution; 2], centre: f64, half: f64) -> [Expansion; 2] {
        let needs_basis = solutions.iter().any(|solution| solution.factors() != [0.0; 4]);
        let basis = if needs_basis { self.basis.jets::<4>(centre) } else { [[0.0; 4]; 4] };
        let mut powers = [1.0; LOOKED_AT];
        for m in 1..LOOKED_AT {
            powers[m] = powers[m - 1] * half / m as f64;
        }
        solutions.map(|solution| {
            let mut derivatives = [0.0; LOOKED_AT];
            // What the first derivatives would be if nothing cancelled, in parts of an interval.
            let mut size = 0.0;
            for (factor, function) in solution.factors().iter().zip(&basis) {
                // A factor 0 marks a function that is absent, and may stand beside an infinite derivative.
                if *factor != 0.0 {
                    for ((sum, value), power) in derivatives.iter_mut().zip(function).zip(powers) {
                        *sum += factor * value;
                        size += (factor * value * power).abs();
                    }
                }
            }
            let n_known = if self.order == Order::Second { 2 } else { 4 };
            for m in n_known..LOOKED_AT {
                derivatives[m] = match self.order {
                    Order::Second => self.b * derivatives[m - 2],
                    Order::Fourth => self.b * derivatives[m - 2] - self.c * derivatives[m - 4],
                };
            }
            let polynomial = series::jet::<LOOKED_AT>(solution.particular(), centre);
            for (sum, value) in derivatives.iter_mut().zip(polynomial) {
                *sum += value;
            }
            size += solution.particular().iter().rev().fold(0.0, |sum, term| 0.5 * sum + term.abs());
            let mut expansion = Expansion::default();
            for ((term, derivative), power) in expansion.terms.iter_mut().zip(derivatives).zip(powers) {
                *term = derivative * power;
            }
            let left_out: f64 = (TERMS..LOOKED_AT).map(|m| (derivatives[m] * powers[m]).abs()).sum();
            expansion.noise = BEYOND * left_out + ROUNDING * size;
            expansion
        })
    }
}
