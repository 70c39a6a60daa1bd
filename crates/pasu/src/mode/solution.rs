//! The closed form of one mode.

use std::sync::OnceLock;

use super::equation::Equation;
use super::order::Order;
use super::series;
use super::unsolvable::Unsolvable;

/// Boundary values and force of a mode problem. Slopes are not used by order 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeData<'a> {
    /// `q(0)`.
    pub start: f64,
    /// `q'(0)`.
    pub start_u: f64,
    /// `q(1)`.
    pub end: f64,
    /// `q'(1)`.
    pub end_u: f64,
    /// Polynomial force in ascending powers of `u`.
    pub force: &'a [f64],
}

/// `q(u)`: factors of the equation's basis plus a polynomial in `u - 1/2`. At `u = 0` and `u = 1` it is the boundary data, to the bit: a pole is
/// where every datum is 0, and rounding would open it.
#[derive(Debug, Clone)]
pub struct ModeSolution {
    factors: [f64; 4],
    /// `q` and `q'` at the start, then at the end.
    ends: [[f64; 2]; 2],
    /// Apart, because most have nothing of it: hundreds of solutions are moved about while a surface is solved, and each is small.
    rare: OnceLock<Box<Rare>>,
}

/// What a force adds, and what follows from the rest once somebody asked.
#[derive(Debug, Clone, Default)]
struct Rare {
    particular: Vec<f64>,
    /// The number of coefficients of the force.
    force_len: usize,
    /// All of the solution as a power series in `u - 1/2`.
    about_middle: OnceLock<Vec<f64>>,
}

impl PartialEq for ModeSolution {
    fn eq(&self, other: &ModeSolution) -> bool {
        let told = |solution: &ModeSolution| (solution.factors, solution.ends, solution.force_len());
        told(self) == told(other) && self.particular() == other.particular()
    }
}

impl ModeData<'_> {
    /// Whether nothing but 0 is asked for.
    pub(super) fn is_zero(&self) -> bool {
        let &ModeData { start, start_u, end, end_u, force } = self;
        [start, start_u, end, end_u].iter().chain(force).all(|&x| x == 0.0)
    }
}

impl Default for ModeSolution {
    fn default() -> Self {
        ModeSolution::zero()
    }
}

impl ModeSolution {
    /// The solution that is 0.
    pub(super) const fn zero() -> Self {
        ModeSolution { factors: [0.0; 4], ends: [[0.0; 2]; 2], rare: OnceLock::new() }
    }

    /// Adds to a particular solution the homogeneous one that meets the boundary data.
    pub(super) fn meeting(equation: &Equation, data: &ModeData, particular: Vec<f64>) -> Result<Self, Unsolvable> {
        let [p0, p0_u] = series::jet::<2>(&particular, 0.0);
        let [p1, p1_u] = series::jet::<2>(&particular, 1.0);
        let (q0, q1) = (data.start - p0, data.end - p1);
        let (even, odd) = (0.5 * q0 + 0.5 * q1, 0.5 * q1 - 0.5 * q0);
        let [even_half, odd_half] = &equation.halves;
        let factors = match equation.order {
            Order::Second => [even / even_half.first[0], 0.0, odd / odd_half.first[0], 0.0],
            Order::Fourth => {
                let (q0_u, q1_u) = (data.start_u - p0_u, data.end_u - p1_u);
                let [a, b] = even_half.meet(even, 0.5 * q1_u - 0.5 * q0_u);
                let [c, d] = odd_half.meet(odd, 0.5 * q0_u + 0.5 * q1_u);
                [a, b, c, d]
            }
        };
        if !factors.iter().chain(&particular).all(|f| f.is_finite()) {
            return Err(Unsolvable::Overflow);
        }
        let ends = [[data.start, data.start_u], [data.end, data.end_u]];
        let rare = match data.force.len() {
            0 => OnceLock::new(),
            force_len => OnceLock::from(Box::new(Rare { particular, force_len, about_middle: OnceLock::new() })),
        };
        Ok(ModeSolution { factors, ends, rare })
    }

    /// The factors of the equation's basis.
    pub(super) fn factors(&self) -> [f64; 4] {
        self.factors
    }

    /// The polynomial in `u - 1/2`.
    pub(super) fn particular(&self) -> &[f64] {
        self.rare.get().map_or(&[], |rare| &rare.particular)
    }

    /// The power series in `u - 1/2` that it is, found at most once.
    pub(super) fn about_middle(&self, find: impl FnOnce() -> Vec<f64>) -> &[f64] {
        self.rare.get_or_init(Box::default).about_middle.get_or_init(find)
    }

    /// The number of coefficients of the force.
    pub(super) fn force_len(&self) -> usize {
        self.rare.get().map_or(0, |rare| rare.force_len)
    }

    /// Whether `q` is 0 everywhere.
    ///
    /// ```
    /// use pasu::{Equation, ModeData, Order};
    ///
    /// let equation = Equation::new(Order::Second, 1.0, 1.0, 0.0, 2.0)?;
    /// let nothing = ModeData { start: 0.0, end: 0.0, start_u: 0.0, end_u: 0.0, force: &[] };
    /// assert!(equation.solve(&nothing)?.is_zero());
    /// # Ok::<(), pasu::Unsolvable>(())
    /// ```
    pub fn is_zero(&self) -> bool {
        self.particular().is_empty() && self.factors == [0.0; 4]
    }
}

impl Equation {
    /// The solutions at `u` in [0, 1], each with its derivatives up to order `N - 1`. They share the transcendental functions.
    ///
    /// ```
    /// use pasu::{Equation, ModeData, Order};
    ///
    /// // The fourth derivative 0, with q(0) = 0, q'(0) = 0, q(1) = 1, q'(1) = 3 is u^3.
    /// let equation = Equation::new(Order::Fourth, 1.0, 0.0, 0.0, 0.0)?;
    /// let solution = equation.solve(&ModeData { start: 0.0, end: 1.0, start_u: 0.0, end_u: 3.0, force: &[] })?;
    /// let [[q, q_u, q_uu]] = equation.jets::<3, 1>([&solution], 0.5);
    /// assert!((q - 0.125).abs() < 1e-15 && (q_u - 0.75).abs() < 1e-15 && (q_uu - 3.0).abs() < 1e-14);
    /// # Ok::<(), pasu::Unsolvable>(())
    /// ```
    pub fn jets<const N: usize, const M: usize>(&self, solutions: [&ModeSolution; M], u: f64) -> [[f64; N]; M] {
        let needs_basis = solutions.iter().any(|solution| solution.factors != [0.0; 4]);
        let basis = if needs_basis { self.basis.jets::<N>(u) } else { [[0.0; N]; 4] };
        solutions.map(|solution| {
            let mut jet = series::jet::<N>(solution.particular(), u);
            for (factor, function) in solution.factors.iter().zip(&basis) {
                // A factor 0 marks a function that is absent, and may stand beside an infinite derivative.
                if *factor != 0.0 {
                    for (sum, value) in jet.iter_mut().zip(function) {
                        *sum += factor * value;
                    }
                }
            }
            let end = match u {
                0.0 => Some(solution.ends[0]),
                1.0 => Some(solution.ends[1]),
                _ => None,
            };
            if let Some(end) = end {
                let n_given = if self.order == Order::Second { 1 } else { 2 };
                for (value, given) in jet.iter_mut().zip(end).take(n_given) {
                    *value = given;
                }
            }
            jet
        })
    }
}
