//! The numerical baseline: the same boundary-value problem on a grid of finite differences, solved in two ways.
//!
//! ```text
//! order 2:   s X_uu   + t X_vv               = 0      X(0, v), X(1, v) given
//! order 4:   s X_uuuu + t X_uuvv + w X_vvvv  = 0      X_u(0, v), X_u(1, v) given as well
//! ```
//!
//! Central differences of second order in `u` on `rows` points from boundary to boundary, and `columns` points round the
//! axis, the first of which is not repeated. A given slope enters through a point beyond the boundary, `X(-h) = X(h) - 2 h X_u(0)`.
//! The error falls with the square of the step.

mod fourier;
#[cfg(feature = "sparse")]
pub mod sparse;

pub use fourier::Fourier;

use std::f64::consts::TAU;

use pasu::{BoundaryValue, Component, Datum, Order, Surface};

/// What a solver gets: the equation and the boundary curves of each component, at the columns of the grid.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Points along `u`, both boundaries included.
    pub rows: usize,
    /// Points round the axis.
    pub columns: usize,
    /// `x`, `y` and `z`.
    pub components: [Curves; 3],
}

/// One component: its equation and the given curves.
#[derive(Debug, Clone)]
pub struct Curves {
    /// The coefficients of the equation.
    pub equation: Coefficients,
    /// `X(0, v)`.
    pub start: Vec<f64>,
    /// `X(1, v)`.
    pub end: Vec<f64>,
    /// `X_u(0, v)`; not used by order 2.
    pub start_u: Vec<f64>,
    /// `X_u(1, v)`; not used by order 2.
    pub end_u: Vec<f64>,
}

/// `s`, `t`, `w` of an equation of order 2 (where `w` is 0) or 4.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// Whether the equation is of order 4.
    pub is_fourth: bool,
    /// Of the highest derivative in `u`.
    pub s: f64,
    /// Of the mixed derivative, or of `X_vv`.
    pub t: f64,
    /// Of the fourth derivative in `v`.
    pub w: f64,
}

impl Problem {
    /// The problem of a closed shape without forces.
    pub fn new(shape: &BoundaryValue, rows: usize, columns: usize) -> Problem {
        Problem { rows, columns, components: [&shape.x, &shape.y, &shape.z].map(|given| Curves::new(given, columns)) }
    }

    /// Distance of neighbours in `u`.
    fn step(&self) -> f64 {
        1.0 / (self.rows - 1) as f64
    }

    /// The largest distance, in any coordinate, of a solution (component by component, row by row) from the closed form.
    pub fn error(&self, surface: &Surface, solution: &[Vec<f64>; 3]) -> f64 {
        let mut largest = 0.0f64;
        for row in 0..self.rows {
            for column in 0..self.columns {
                let (u, v) = (row as f64 * self.step(), column as f64 * TAU / self.columns as f64);
                let exact = surface.at(u, v).position.to_array();
                for (found, exact) in solution.iter().zip(exact) {
                    largest = largest.max((found[row * self.columns + column] - exact).abs());
                }
            }
        }
        largest
    }
}

impl Curves {
    fn new(component: &Component, columns: usize) -> Curves {
        let curve = |of: fn(&Datum) -> f64| {
            let at = |column: usize| {
                let v = column as f64 * TAU / columns as f64;
                component
                    .modes
                    .iter()
                    .map(|mode| of(&mode.cos) * (mode.n * v).cos() + of(&mode.sin) * (mode.n * v).sin())
                    .sum()
            };
            (0..columns).map(at).collect::<Vec<f64>>()
        };
        let &Component { order, s, t, w, .. } = component;
        Curves {
            equation: Coefficients { is_fourth: order == Order::Fourth, s, t, w },
            start: curve(|datum| datum.start),
            end: curve(|datum| datum.end),
            start_u: curve(|datum| datum.start_u),
            end_u: curve(|datum| datum.end_u),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::designs;

    #[test]
    fn errors_fall_with_the_square_of_the_step() {
        for design in [designs::vase(4).unwrap(), designs::vase_of_second_order(4).unwrap()] {
            let shape = designs::shape(&design);
            let surface = Surface::solve(&shape, "shape").unwrap();
            let errors = [33, 65, 129].map(|rows| {
                let problem = Problem::new(&shape, rows, 32);
                problem.error(&surface, Fourier::new(rows, 32).solve(&problem))
            });
            assert!(errors[2] < 1e-3, "{errors:?}");
            for pair in errors.windows(2) {
                let power = (pair[0] / pair[1]).log2();
                assert!((1.7..2.3).contains(&power), "{errors:?}");
            }
        }
    }

    #[test]
    #[cfg(feature = "sparse")]
    fn both_ways_find_the_same_where_the_columns_are_many() {
        for design in [designs::vase(2).unwrap(), designs::vase_of_second_order(2).unwrap()] {
            let shape = designs::shape(&design);
            let surface = Surface::solve(&shape, "shape").unwrap();
            let errors = [16, 32, 64].map(|side| {
                let problem = Problem::new(&shape, side + 1, 2 * side);
                problem.error(&surface, &sparse::solve(&problem))
            });
            assert!(errors[2] < 2e-3 && errors[2] < 0.4 * errors[1] && errors[1] < 0.4 * errors[0], "{errors:?}");
        }
    }
}
