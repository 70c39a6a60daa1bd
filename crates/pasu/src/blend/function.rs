//! What a blend is made of along one parameter.

use core::f64::consts::PI;
use std::sync::Arc;

use crate::mode::{Equation, ModeSolution};
use crate::numeric::{horner, taylor};
use crate::surface::{MOST_MULTIPLES, of_turns};

/// A function of one parameter in [0, 1] that knows its derivatives.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Function {
    /// A polynomial of degree 3 at most, lowest power first.
    Cubic([f64; 4]),
    /// `cos(pi m x)`.
    Cosine(f64),
    /// `sin(pi m x)`.
    Sine(f64),
    /// `sqrt(1 - (2x - 1)^2)`: its derivatives are infinite at both ends.
    HalfRound,
    /// The solution of a mode problem.
    Mode(Arc<Equation>, ModeSolution),
}

impl Function {
    /// 1.
    pub(super) const ONE: Function = Function::Cubic([1.0, 0.0, 0.0, 0.0]);

    /// `x`.
    pub(super) const X: Function = Function::Cubic([0.0, 1.0, 0.0, 0.0]);

    /// `2x - 1`.
    pub(super) const MIDDLE: Function = Function::Cubic([-1.0, 2.0, 0.0, 0.0]);

    /// Value and derivatives up to order `N - 1`, `N` at most 5.
    pub(super) fn jet<const N: usize>(&self, x: f64) -> [f64; N] {
        match self {
            Function::Cubic(coefficients) => horner::derivatives(coefficients.iter().rev().copied(), x),
            Function::Cosine(m) => {
                let (c, s) = of_turns(0.5 * m * x);
                wave(PI * m, [c, -s, -c, s])
            }
            Function::Sine(m) => {
                let (c, s) = of_turns(0.5 * m * x);
                wave(PI * m, [s, c, -s, -c])
            }
            Function::HalfRound => {
                let s = 2.0 * x - 1.0;
                // Each derivative in x is twice that in s.
                let square = (4.0 * x * (1.0 - x)).max(0.0);
                let root = square.sqrt();
                let all = [
                    root,
                    2.0 * (-s / root),
                    4.0 * (-1.0 / (square * root)),
                    8.0 * (-3.0 * s / (square * square * root)),
                    16.0 * (-(3.0 + 12.0 * s * s) / (square * square * square * root)),
                ];
                core::array::from_fn(|order| all.get(order).copied().unwrap_or(f64::NAN))
            }
            Function::Mode(equation, solution) => {
                let [jet] = equation.jets::<N, 1>([solution], x);
                jet
            }
        }
    }

    /// The same where `(cos, sin)` of every whole multiple of `x` turns are known, as [`multiples`] has them: waves take them from there.
    pub(super) fn jet_by<const N: usize>(&self, x: f64, turns: &[(f64, f64)]) -> [f64; N] {
        match self {
            Function::Cosine(m) | Function::Sine(m) => match (turns.get((0.5 * m) as usize), self) {
                (None, _) => self.jet(x),
                (Some((c, s)), Function::Cosine(_)) => wave(PI * m, [*c, -s, -c, *s]),
                (Some((c, s)), _) => wave(PI * m, [*s, *c, -s, -c]),
            },
            _ => self.jet(x),
        }
    }

    /// How often `x` goes round, if it is a wave that goes round whole times.
    pub(super) fn whole_turns(&self) -> Option<usize> {
        match self {
            Function::Cosine(m) | Function::Sine(m) => {
                let turns = 0.5 * m;
                (turns >= 0.0 && turns == turns.trunc() && turns <= MOST_MULTIPLES as f64).then_some(turns as usize)
            }
            _ => None,
        }
    }

    /// Bounds of the sizes of value and derivatives on all of `[from, to]`, never larger on a smaller interval.
    pub(super) fn suprema<const N: usize>(&self, [from, to]: [f64; 2]) -> [f64; N] {
        match self {
            Function::Cubic(coefficients) => {
                let mut derived = *coefficients;
                core::array::from_fn(|order| {
                    if order > 0 {
                        derived = derivative(derived);
                    }
                    largest(&derived, [from, to])
                })
            }
            Function::Cosine(m) | Function::Sine(m) => wave((PI * m).abs(), [1.0; 4]),
            Function::HalfRound => core::array::from_fn(|order| if order == 0 { 1.0 } else { f64::INFINITY }),
            Function::Mode(equation, solution) => {
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let [mut suprema] = equation.suprema::<5, 1>([solution], from, to);
                let [jet] = equation.jets::<5, 1>([solution], middle);
                taylor::tighten(&mut suprema, &jet, half);
                core::array::from_fn(|order| suprema.get(order).copied().unwrap_or(f64::INFINITY))
            }
        }
    }

    /// Whether it is 0 everywhere.
    pub(super) fn is_zero(&self) -> bool {
        match self {
            Function::Cubic(coefficients) => *coefficients == [0.0; 4],
            Function::Sine(m) => *m == 0.0,
            Function::Mode(_, solution) => solution.is_zero(),
            Function::Cosine(_) | Function::HalfRound => false,
        }
    }

    /// Whether it is the same everywhere.
    pub(super) fn is_constant(&self) -> bool {
        match self {
            Function::Cubic([_, rest @ ..]) => *rest == [0.0; 3],
            Function::Cosine(m) | Function::Sine(m) => *m == 0.0,
            Function::Mode(_, solution) => solution.is_zero(),
            Function::HalfRound => false,
        }
    }

    /// How many waves there are from 0 to 1, half the degree of a polynomial, and how fast it may change next to its ends.
    pub(super) fn waves(&self) -> (f64, f64) {
        match self {
            Function::Cubic(coefficients) => {
                (0.5 * coefficients.iter().rposition(|c| *c != 0.0).unwrap_or(0) as f64, 0.0)
            }
            Function::Cosine(m) | Function::Sine(m) => (0.5 * m.abs(), 0.0),
            Function::HalfRound => (0.5, 0.0),
            Function::Mode(equation, _) => (1.0, equation.largest_rate()),
        }
    }
}

/// Derivatives of a wave of angular frequency `k`, whose first four without it are these.
fn wave<const N: usize>(k: f64, turned: [f64; 4]) -> [f64; N] {
    let mut power = 1.0;
    core::array::from_fn(|order| {
        if order > 0 {
            power *= k;
        }
        power * turned[order % 4]
    })
}

fn derivative([_, b, c, d]: [f64; 4]) -> [f64; 4] {
    [b, 2.0 * c, 3.0 * d, 0.0]
}

/// The largest size of a cubic on an interval: at an end, or where its derivative vanishes.
fn largest(coefficients: &[f64; 4], [from, to]: [f64; 2]) -> f64 {
    let at = |x: f64| horner::derivatives::<1>(coefficients.iter().rev().copied(), x)[0].abs();
    let [c, b, a, _] = derivative(*coefficients);
    let mut largest = at(from).max(at(to));
    // The roots of a x^2 + b x + c, without the difference of near-equal numbers.
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let q = -0.5 * (b + root.copysign(b));
    for turn in [q / a, c / q] {
        if turn > from && turn < to {
            largest = largest.max(at(turn));
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mode::{ModeData, Order};
    use crate::surface::multiples;

    fn all() -> Vec<Function> {
        let equation = Arc::new(Equation::new(Order::Fourth, 1.0, 0.0, 1.0, 7.0).unwrap());
        let data = ModeData { start: 1.0, start_u: -2.0, end: 0.5, end_u: 3.0, force: &[] };
        let solution = equation.solve(&data).unwrap();
        vec![
            Function::ONE,
            Function::X,
            Function::MIDDLE,
            Function::Cubic([0.3, -2.0, 5.0, -3.0]),
            Function::Cubic([0.0, 0.0, 1.0, 0.0]),
            Function::Cosine(1.0),
            Function::Cosine(6.0),
            Function::Sine(4.0),
            Function::Mode(equation, solution),
            Function::HalfRound,
        ]
    }

    #[test]
    fn multiples_of_turns_are_those_of_every_wave_by_itself() {
        for x in [0.0, 0.25, 0.5, 1.0, 0.1, 0.734_512, 1e-9] {
            let turns = multiples(x, 1000);
            for n in [0, 1, 2, 3, 17, 512, 999, 1000] {
                let m = 2.0 * f64::from(n as u16);
                for function in [Function::Cosine(m), Function::Sine(m)] {
                    let (by, alone) = (function.jet_by::<3>(x, &turns), function.jet::<3>(x));
                    for (order, (by, alone)) in by.into_iter().zip(alone).enumerate() {
                        let scale = (PI * m).max(1.0).powi(order as i32);
                        assert!(
                            (by - alone).abs() <= 1e-15 * (1.0 + m) * scale,
                            "{function:?} at {x}: {by}, not {alone}"
                        );
                    }
                }
                // Round once is where it began, to the bit.
                assert!(x != 1.0 || turns[n] == (1.0, 0.0));
            }
        }
    }

    #[test]
    fn each_derivative_is_that_of_the_one_before() {
        let h = 1e-5;
        for function in all() {
            for x in [0.1, 0.35, 0.5, 0.77] {
                let [before, here, after] = [x - h, x, x + h].map(|x| function.jet::<5>(x));
                for order in 0..4 {
                    let slope = (after[order] - before[order]) / (2.0 * h);
                    let scale = here.iter().fold(1.0f64, |most, x| most.max(x.abs()));
                    assert!((slope - here[order + 1]).abs() < 2e-8 * scale * scale, "{function:?} at {x}, {order}");
                }
            }
        }
    }

    #[test]
    fn nothing_between_is_larger_and_a_part_is_no_larger_than_the_whole() {
        for function in all() {
            let whole = function.suprema::<3>([0.0, 1.0]);
            for [from, to] in [[0.0, 1.0], [0.0, 0.2], [0.2, 0.7], [0.9, 1.0]] {
                let suprema = function.suprema::<3>([from, to]);
                assert!(suprema.iter().zip(whole).all(|(part, whole)| *part <= whole), "{function:?}");
                for i in 0..=40 {
                    let jet = function.jet::<3>((from + (to - from) * f64::from(i) / 40.0).clamp(1e-9, 1.0 - 1e-9));
                    for (value, supremum) in jet.iter().zip(suprema) {
                        assert!(value.abs() <= supremum * (1.0 + 1e-12) + 1e-14, "{function:?}: {value}, {supremum}");
                    }
                }
            }
        }
        // Of a polynomial it is the supremum itself.
        assert_eq!(Function::Cubic([0.0, 1.0, -1.0, 0.0]).suprema::<3>([0.0, 1.0]), [0.25, 1.0, 2.0]);
    }

    #[test]
    fn constants_and_zeros_are_known() {
        let [one, none] = [Function::ONE, Function::Cubic([0.0; 4])];
        assert!(one.is_constant() && !one.is_zero() && none.is_zero() && none.is_constant());
        assert!(
            !Function::X.is_constant() && !Function::HalfRound.is_constant() && !Function::Cosine(2.0).is_constant()
        );
        assert!(Function::Sine(0.0).is_zero() && Function::Cosine(0.0).is_constant());
    }
}
