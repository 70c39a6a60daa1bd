//! The fast way: a Fourier transform round the axis leaves one band matrix in `u` for each frequency.
//!
//! Written as a careful program would be: real and imaginary parts of the three components run through elimination side by side, in vector
//! registers, and plans and arrays are kept.

use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::{Coefficients, Problem};

/// What runs side by side: real and imaginary part of three components.
const LANES: usize = 6;
type Lanes = [f64; LANES];

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
    sides: Vec<Lanes>,
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
            sides: vec![[0.0; LANES]; rows],
            band: Band::default(),
            solution: std::array::from_fn(|_| vec![0.0; rows * columns]),
        }
    }

    /// Solves a problem of this size: positions, component by component, row by row.
    pub fn solve(&mut self, problem: &Problem) -> &[Vec<f64>; 3] {
        assert_eq!((problem.rows, problem.columns), (self.rows, self.columns), "the solver is for another grid");
        self.transform(problem);
        for frequency in 0..=self.columns / 2 {
            self.solve_frequency(problem, frequency);
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

    /// Solves one frequency.
    fn solve_frequency(&mut self, problem: &Problem, frequency: usize) {
        let n = self.rows - 2;
        let side = |which: usize| -> Lanes {
            std::array::from_fn(|lane| {
                let value = self.given[lane / 2][which][frequency];
                if lane % 2 == 0 { value.re } else { value.im }
            })
        };
        let [start, start_u, end, end_u] = std::array::from_fn(side);
        let h = problem.step();
        let diagonals: [[f64; 3]; 3] =
            std::array::from_fn(|component| diagonals(problem.components[component].equation, h, frequency));
        let [diagonal, beside, beyond]: [Lanes; 3] =
            std::array::from_fn(|which| std::array::from_fn(|lane| diagonals[lane / 2][which]));
        let inner = &mut self.sides[1..=n];
        inner.fill([0.0; LANES]);
        for lane in 0..LANES {
            inner[0][lane] -= beside[lane] * start[lane] - 2.0 * h * beyond[lane] * start_u[lane];
            inner[n - 1][lane] -= beside[lane] * end[lane] + 2.0 * h * beyond[lane] * end_u[lane];
            inner[1][lane] -= beyond[lane] * start[lane];
            inner[n - 2][lane] -= beyond[lane] * end[lane];
        }
        self.band.factor(n, diagonal, beside, beyond);
        self.band.solve(inner);
        (self.sides[0], self.sides[n + 1]) = (start, end);
        let width = self.columns / 2 + 1;
        // The highest frequency of an even number of columns has no sine.
        let is_real = frequency == 0 || 2 * frequency == self.columns;
        for (component, spectra) in self.spectra.iter_mut().enumerate() {
            for (row, sides) in self.sides.iter().enumerate() {
                let imaginary = if is_real { 0.0 } else { sides[2 * component + 1] };
                spectra[row * width + frequency] = Complex64::new(sides[2 * component], imaginary);
            }
        }
    }
}

/// The matrix of one frequency: its diagonal but for the ends, what stands beside it, and what stands beyond that.
fn diagonals(equation: Coefficients, h: f64, frequency: usize) -> [f64; 3] {
    let Coefficients { is_fourth, s, t, w } = equation;
    let k = (frequency * frequency) as f64;
    let inverse = 1.0 / (h * h);
    if is_fourth {
        let (fourth, second) = (s * inverse * inverse, t * k * inverse);
        [6.0 * fourth + 2.0 * second + w * k * k, -4.0 * fourth - second, fourth]
    } else {
        let second = s * inverse;
        [2.0 * second + t * k, -second, 0.0]
    }
}

/// The factors `L D L^T` of symmetric matrices of five diagonals, one matrix for each lane.
#[derive(Debug, Default)]
struct Band {
    /// Row by row: `1 / D`, and the two entries of `L` below the diagonal in the column of that row.
    rows: Vec<[Lanes; 3]>,
}

impl Band {
    /// Factors the matrices with these diagonals; `beyond` is added to the first and the last diagonal entry (a given slope). Without pivoting, as the
    /// matrices of elliptic equations allow.
    fn factor(&mut self, n: usize, diagonal: Lanes, beside: Lanes, beyond: Lanes) {
        self.rows.clear();
        // The entries of `L` in the columns of the two rows before, and `D` times the upper one of the row before.
        let [mut one, mut two, mut two_before, mut scaled] = [[0.0; LANES]; 4];
        for row in 0..n {
            let edge = if row == 0 || row + 1 == n { 1.0 } else { 0.0 };
            let mut inverse = [0.0; LANES];
            for lane in 0..LANES {
                inverse[lane] = 1.0
                    / (diagonal[lane] + edge * beyond[lane]
                        - one[lane] * scaled[lane]
                        - two_before[lane] * beyond[lane]);
                scaled[lane] = beside[lane] - two[lane] * scaled[lane];
                one[lane] = scaled[lane] * inverse[lane];
                two_before[lane] = two[lane];
                two[lane] = beyond[lane] * inverse[lane];
            }
            self.rows.push([inverse, one, two]);
        }
    }

    /// Solves in place.
    fn solve(&self, sides: &mut [Lanes]) {
        let [mut before, mut before_that] = [[0.0; LANES]; 2];
        let [mut one_before, mut two_before, mut two_before_that] = [[0.0; LANES]; 3];
        for (side, [_, one, two]) in sides.iter_mut().zip(&self.rows) {
            for lane in 0..LANES {
                side[lane] -= one_before[lane] * before[lane] + two_before_that[lane] * before_that[lane];
            }
            (before_that, before) = (before, *side);
            (one_before, two_before_that, two_before) = (*one, two_before, *two);
        }
        let [mut after, mut after_that] = [[0.0; LANES]; 2];
        for (side, [inverse, one, two]) in sides.iter_mut().zip(&self.rows).rev() {
            for lane in 0..LANES {
                side[lane] = inverse[lane] * side[lane] - one[lane] * after[lane] - two[lane] * after_that[lane];
            }
            (after_that, after) = (after, *side);
        }
    }
}
