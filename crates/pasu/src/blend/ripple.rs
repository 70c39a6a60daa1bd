//! What is added to the cubic between two sections so that the equation holds: sines along `u` and `v`, which vanish on the border, so that positions and tangents of both sections stay.

use core::f64::consts::PI;

use glam::DVec2;
use nalgebra::{DMatrix, DVector};

use super::fading::fading;
use super::section::Product;
use super::sines::Sines;
use crate::mode::{Equation, ModeData, ModeSolution, Order, Unsolvable};
use crate::numeric::horner;
use crate::surface::of_turns;

/// `sum_lm q_lm(w) sin(l pi u) sin(m pi v)` in `x` and `y`.
#[derive(Debug)]
pub(super) struct Ripple {
    /// How many sines along `u` and along `v`.
    pub(super) n: [usize; 2],
    along: Along,
}

/// `q_lm` for every `m` of the first `l`, then of the next.
#[derive(Debug)]
enum Along {
    /// The solution of each mode problem for what either section asks.
    Modal(Vec<Modal>),
    /// `sum_n a_lmn sin^2(n pi w)`, so many coefficients one after the other.
    Squares { n: usize, coefficients: Vec<DVec2> },
}

/// One product of sines, solved along `w`.
#[derive(Debug)]
struct Modal {
    /// By how much either solution is to be taken.
    by: [DVec2; 2],
    equation: Equation,
    solutions: [ModeSolution; 2],
}

/// What the two sections ask of the sines.
pub(super) struct Asked<'a> {
    pub(super) sections: [&'a [Product]; 2],
    pub(super) tapers: [f64; 2],
    pub(super) weights: [f64; 3],
}

impl Asked<'_> {
    /// The coefficients in sines of `a S_uuuu + b S_vvvv` for either section, by collocation at the inner points; `None` where it vanishes.
    fn transformed(&self, n: [usize; 2]) -> Option<[Vec<DVec2>; 2]> {
        let sines = n.map(Sines::new);
        let both = self.sections.map(|products| transformed(products, self.weights, &sines));
        both.iter().flatten().any(|by| *by != DVec2::ZERO).then_some(both)
    }

    /// `a l^4 + b m^4` times `pi^4`, for every `m` of the first `l`, then of the next.
    fn stiffnesses(&self, n: [usize; 2]) -> impl Iterator<Item = f64> + use<> {
        let [a, b, _] = self.weights;
        let fourth = |l: usize| (l as f64 * l as f64) * (l as f64 * l as f64);
        let pi_fourth = (PI * PI) * (PI * PI);
        (1..=n[0]).flat_map(move |l| (1..=n[1]).map(move |m| pi_fourth * (a * fourth(l) + b * fourth(m))))
    }

    /// The mode problem of each product of sines, solved: `c q'''' + pi^4 (a l^4 + b m^4) q` is what takes away what the cubic leaves, with `q` and `q'` 0 at both sections.
    pub(super) fn modal(&self, n: [usize; 2]) -> Result<Option<Ripple>, Unsolvable> {
        let Some([starts, ends]) = self.transformed(n) else { return Ok(None) };
        let forces = [0, 1].map(|end| fading(end == 1, self.tapers[end]).map(|c| -c));
        let mut modes = Vec::with_capacity(starts.len());
        for ((stiffness, start), end) in self.stiffnesses(n).zip(starts).zip(ends) {
            let equation = Equation::new(Order::Fourth, self.weights[2], 0.0, stiffness, 1.0)?;
            let solved =
                |force: &[f64]| equation.solve(&ModeData { start: 0.0, end: 0.0, start_u: 0.0, end_u: 0.0, force });
            let solutions = [solved(&forces[0])?, solved(&forces[1])?];
            modes.push(Modal { by: [start, end], equation, solutions });
        }
        Ok(Some(Ripple { n, along: Along::Modal(modes) }))
    }

    /// The method of ZY04: the equation holds at `w_k = k / 2N`. The sines along `u` and `v` are orthogonal on their points, so that each product of two has a system of its own, of the size `N`.
    pub(super) fn collocation(&self, [l, m, n]: [usize; 3]) -> Result<Option<Ripple>, Unsolvable> {
        let Some([starts, ends]) = self.transformed([l, m]) else { return Ok(None) };
        let points: Vec<f64> = (1..=n).map(|k| k as f64 / (2 * n) as f64).collect();
        let asked = [0, 1].map(|end| {
            let fading = fading(end == 1, self.tapers[end]);
            DVector::from_iterator(n, points.iter().map(|w| -horner::derivatives::<1>(fading.into_iter().rev(), *w)[0]))
        });
        // sin^2(n pi w) and its fourth derivative, -8 (n pi)^4 cos(2 n pi w), at each point.
        let entry = |k: usize, j: usize| {
            let (c, s) = of_turns(0.5 * (j + 1) as f64 * points[k]);
            let rate = PI * (j + 1) as f64;
            let (sine, cosine) = (s * s, c * c - s * s);
            (sine, -8.0 * self.weights[2] * (rate * rate) * (rate * rate) * cosine)
        };
        let entries: Vec<(f64, f64)> = (0..n * n).map(|i| entry(i % n, i / n)).collect();
        let mut coefficients = Vec::with_capacity(l * m * n);
        for ((stiffness, start), end) in self.stiffnesses([l, m]).zip(starts).zip(ends) {
            let matrix = DMatrix::from_iterator(n, n, entries.iter().map(|(sine, fourth)| stiffness * sine + fourth));
            let factors = matrix.lu();
            let solved = |asked: &DVector<f64>| factors.solve(asked).ok_or(Unsolvable::Resonant);
            let [of_start, of_end] = [solved(&asked[0])?, solved(&asked[1])?];
            coefficients.extend(of_start.iter().zip(&of_end).map(|(one, other)| start * *one + end * *other));
        }
        match coefficients.iter().all(|a| a.is_finite()) {
            true => Ok(Some(Ripple { n: [l, m], along: Along::Squares { n, coefficients } })),
            false => Err(Unsolvable::Overflow),
        }
    }
}

/// The coefficients in sines of `a S_uuuu + b S_vvvv` of one section.
fn transformed(products: &[Product], [a, b, _]: [f64; 3], sines: &[Sines; 2]) -> Vec<DVec2> {
    let [along, across] = sines;
    let mut grid = vec![DVec2::ZERO; along.len() * across.len()];
    for product in products {
        let [us, vs]: [Vec<[f64; 5]>; 2] =
            [along.points().map(|u| product.u.jet(u)).collect(), across.points().map(|v| product.v.jet(v)).collect()];
        for (row, u) in grid.chunks_exact_mut(vs.len()).zip(&us) {
            for (value, v) in row.iter_mut().zip(&vs) {
                *value += product.by * (a * u[4] * v[0] + b * u[0] * v[4]);
            }
        }
    }
    if grid.iter().all(|value| *value == DVec2::ZERO) {
        return grid;
    }
    let transform = |line: Vec<DVec2>, sines: &Sines| -> Vec<DVec2> {
        let [x, y] = [0, 1].map(|axis| sines.coefficients(&line.iter().map(|value| value[axis]).collect::<Vec<f64>>()));
        x.into_iter().zip(y).map(DVec2::from).collect()
    };
    for row in grid.chunks_exact_mut(across.len()) {
        let transformed = transform(row.to_vec(), across);
        row.copy_from_slice(&transformed);
    }
    for column in 0..across.len() {
        let line = grid.iter().skip(column).step_by(across.len()).copied().collect();
        for (row, value) in transform(line, along).into_iter().enumerate() {
            grid[row * across.len() + column] = value;
        }
    }
    grid
}

impl Ripple {
    /// Every `q_lm` with its derivatives at one `w`.
    pub(super) fn at(&self, w: f64) -> Vec<[DVec2; 5]> {
        match &self.along {
            Along::Modal(modes) => {
                let of = |Modal { by, equation, solutions: [one, other] }: &Modal| {
                    let [one, other] = equation.jets::<5, 2>([one, other], w);
                    core::array::from_fn(|order| by[0] * one[order] + by[1] * other[order])
                };
                modes.iter().map(of).collect()
            }
            Along::Squares { n, coefficients } => {
                let squares: Vec<[f64; 5]> = (1..=*n).map(|n| squared_sine(n, w)).collect();
                let of = |coefficients: &[DVec2]| {
                    let sum = |order: usize| coefficients.iter().zip(&squares).map(|(a, s)| *a * s[order]).sum();
                    core::array::from_fn(sum)
                };
                coefficients.chunks_exact(*n).map(of).collect()
            }
        }
    }
}

/// `sin^2(n pi w)` and its derivatives.
fn squared_sine(n: usize, w: f64) -> [f64; 5] {
    let (c, s) = of_turns(0.5 * n as f64 * w);
    let rate = 2.0 * PI * n as f64;
    // Of (1 - cos(rate w)) / 2.
    let (cosine, sine) = (c * c - s * s, 2.0 * s * c);
    let half = 0.5 * rate;
    [s * s, half * sine, half * rate * cosine, -half * rate * rate * sine, -half * rate * rate * rate * cosine]
}
