//! The fast way: a Fourier transform round the axis leaves one band matrix in `u` for each frequency.
//!
//! As much is shared as a careful program would share: components of equal equations use one factorisation, the six right-hand sides (real and
//! imaginary part of three components) run through it side by side, and plans and arrays are kept.

use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::{Coefficients, Problem};

/// Right-hand sides of one frequency: real and imaginary part of three components.
const SIDES: usize = 6;

/// A solver for one size of grid, with its transforms and arrays.
pub struct Fourier {
    rows: usize,
    columns: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
    real: Vec<f64>,
    scratch: Vec<Complex64>,
    /// Transforms of the four given curves of each component.
    given: [[Vec<Complex64>; 4]; 3],
    /// Transforms of every row of each component.
    spectra: [Vec<Complex64>; 3],
    sides: Vec<[f64; SIDES]>,
    band: Band,
    solution: [Vec<f64>; 3],
}

impl Fourier {
    /// Prepares grids of `rows` points along `u` and `columns` round the axis; at least 5 and 2.
    pub fn new(rows: usize, columns: usize) -> Fourier {
        let mut planner = RealFftPlanner::new();
        let (forward, backward) = (planner.plan_fft_forward(columns), planner.plan_fft_inverse(columns));
        let zero = Complex64::default();
        let spectrum = || vec![zero; columns / 2 + 1];
        Fourier {
            rows,
            columns,
            real: vec![0.0; columns],
            scratch: vec![zero; forward.get_scratch_len().max(backward.get_scratch_len())],
            forward,
            backward,
            given: std::array::from_fn(|_| std::array::from_fn(|_| spectrum())),
            spectra: std::array::from_fn(|_| vec![zero; rows * (columns / 2 + 1)]),
            sides: vec![[0.0; SIDES]; rows],
            band: Band::default(),
            solution: std::array::from_fn(|_| vec![0.0; rows * columns]),
        }
    }

    /// Solves a problem of this size: positions, component by component, row by row.
    pub fn solve(&mut self, problem: &Problem) -> &[Vec<f64>; 3] {
        assert_eq!((problem.rows, problem.columns), (self.rows, self.columns), "the solver is for another grid");
        self.transform(problem);
        for frequency in 0..=self.columns / 2 {
            let mut done = [false; 3];
            for component in 0..3 {
                if done[component] {
                    continue;
                }
                let equation = problem.components[component].equation;
                let alike: [bool; 3] = std::array::from_fn(|other| problem.components[other].equation == equation);
                self.solve_frequency(equation, frequency, alike);
                for (done, alike) in done.iter_mut().zip(alike) {
                    *done |= alike;
                }
            }
        }
        let width = self.columns / 2 + 1;
        for (spectra, solution) in self.spectra.iter_mut().zip(&mut self.solution) {
            for (spectrum, row) in spectra.chunks_exact_mut(width).zip(solution.chunks_exact_mut(self.columns)) {
                self.backward
                    .process_with_scratch(spectrum, row, &mut self.scratch)
                    .expect("lengths are those of the plan, and the ends of a real row's transform are real");
            }
        }
        &self.solution
    }

    /// Transforms the given curves, scaled so that the way back needs no scaling.
    fn transform(&mut self, problem: &Problem) {
        let scale = 1.0 / self.columns as f64;
        for (curves, given) in problem.components.iter().zip(&mut self.given) {
            for (curve, spectrum) in [&curves.start, &curves.start_u, &curves.end, &curves.end_u].into_iter().zip(given)
            {
                for (scaled, value) in self.real.iter_mut().zip(curve) {
                    *scaled = scale * value;
                }
                self.forward
                    .process_with_scratch(&mut self.real, spectrum, &mut self.scratch)
                    .expect("lengths are those of the plan");
            }
        }
    }

    /// Solves one frequency for the components that share an equation.
    fn solve_frequency(&mut self, equation: Coefficients, frequency: usize, alike: [bool; 3]) {
        let n = self.rows - 2;
        let side = |which: usize| -> [f64; SIDES] {
            let value = |side: usize| self.given[side / 2][which][frequency];
            std::array::from_fn(|side| if side % 2 == 0 { value(side).re } else { value(side).im })
        };
        let [start, start_u, end, end_u] = std::array::from_fn(side);
        let h = 1.0 / (self.rows - 1) as f64;
        let k = (frequency * frequency) as f64;
        let Coefficients { is_fourth, s, t, w } = equation;
        // Rows of the matrix, which is constant along its diagonals but for the first and the last row.
        let (diagonal, beside, beyond) = if is_fourth {
            let (fourth, second) = (s / h.powi(4), t * k / (h * h));
            (6.0 * fourth + 2.0 * second + w * k * k, -4.0 * fourth - second, fourth)
        } else {
            let second = s / (h * h);
            (2.0 * second + t * k, -second, 0.0)
        };
        let inner = &mut self.sides[1..=n];
        inner.fill([0.0; SIDES]);
        for lane in 0..SIDES {
            inner[0][lane] -= beside * start[lane] - 2.0 * h * beyond * start_u[lane];
            inner[n - 1][lane] -= beside * end[lane] + 2.0 * h * beyond * end_u[lane];
            inner[1][lane] -= beyond * start[lane];
            inner[n - 2][lane] -= beyond * end[lane];
        }
        self.band.factor(n, diagonal, beside, beyond);
        self.band.solve(inner);
        (self.sides[0], self.sides[n + 1]) = (start, end);
        let width = self.columns / 2 + 1;
        // The highest frequency of an even number of columns has no sine.
        let is_real = frequency == 0 || 2 * frequency == self.columns;
        for (component, spectra) in self.spectra.iter_mut().enumerate().filter(|(component, _)| alike[*component]) {
            for (row, sides) in self.sides.iter().enumerate() {
                let imaginary = if is_real { 0.0 } else { sides[2 * component + 1] };
                spectra[row * width + frequency] = Complex64::new(sides[2 * component], imaginary);
            }
        }
    }
}

/// The factors `L D L^T` of a symmetric matrix of five diagonals.
#[derive(Debug, Default)]
struct Band {
    /// Row by row: `1 / D`, and the two entries of `L` below the diagonal in the column of that row.
    rows: Vec<[f64; 3]>,
}

impl Band {
    /// Factors the matrix with these diagonals; `beyond` is added to its first and last diagonal entry (a given slope). Without pivoting, as the
    /// matrices of elliptic equations allow.
    fn factor(&mut self, n: usize, diagonal: f64, beside: f64, beyond: f64) {
        self.rows.clear();
        // The entries of `L` in the columns of the two rows before, and `D` times the upper one of the row before.
        let (mut one, mut two, mut two_before, mut scaled) = (0.0, 0.0, 0.0, 0.0);
        for row in 0..n {
            let edge = if row == 0 || row + 1 == n { beyond } else { 0.0 };
            let inverse = 1.0 / (diagonal + edge - one * scaled - two_before * beyond);
            scaled = beside - two * scaled;
            (one, two_before, two) = (scaled * inverse, two, beyond * inverse);
            self.rows.push([inverse, one, two]);
        }
    }

    /// Solves in place, all right-hand sides side by side.
    fn solve(&self, sides: &mut [[f64; SIDES]]) {
        let n = sides.len();
        for row in 0..n {
            let [_, one, two] = self.rows[row];
            let current = sides[row];
            if row + 1 < n {
                subtract(&mut sides[row + 1], one, &current);
            }
            if row + 2 < n {
                subtract(&mut sides[row + 2], two, &current);
            }
        }
        for row in (0..n).rev() {
            let [inverse, one, two] = self.rows[row];
            let mut current = sides[row].map(|value| value * inverse);
            if row + 1 < n {
                subtract(&mut current, one, &sides[row + 1]);
            }
            if row + 2 < n {
                subtract(&mut current, two, &sides[row + 2]);
            }
            sides[row] = current;
        }
    }
}

fn subtract(from: &mut [f64; SIDES], factor: f64, values: &[f64; SIDES]) {
    for (from, value) in from.iter_mut().zip(values) {
        *from -= factor * value;
    }
}
