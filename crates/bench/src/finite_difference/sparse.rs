//! The direct way: one sparse matrix for the whole grid, factored in an order that keeps the fill small.

use faer::Mat;
use faer::linalg::solvers::Solve;
use faer::sparse::{SparseColMat, Triplet};

use super::{Coefficients, Curves, Problem};

/// Solves a problem: positions, component by component, row by row. Components of equal equations share one factorisation.
///
/// # Panics
/// When the matrix is singular, which that of an elliptic equation is not.
pub fn solve(problem: &Problem) -> [Vec<f64>; 3] {
    let mut solution = std::array::from_fn(|_| Vec::new());
    for component in 0..3 {
        let equation = problem.components[component].equation;
        let alike = |other: &usize| problem.components[*other].equation == equation;
        if (0..component).any(|earlier| alike(&earlier)) {
            continue;
        }
        let alike: Vec<usize> = (component..3).filter(alike).collect();
        let stencil = stencil(problem, equation);
        let mut sides = Mat::zeros((problem.rows - 2) * problem.columns, alike.len());
        for (side, &other) in alike.iter().enumerate() {
            let side = sides.as_mut().col_mut(side).try_as_col_major_mut().expect("a column of its own").as_slice_mut();
            known(problem, &stencil, &problem.components[other], side);
        }
        let factors = matrix(problem, &stencil).sp_lu().expect("the matrix of an elliptic equation is regular");
        factors.solve_in_place(&mut sides);
        for (side, &other) in alike.iter().enumerate() {
            let curves = &problem.components[other];
            let inner = sides.col(side).try_as_col_major().expect("a column of its own").as_slice();
            solution[other] = [&curves.start, inner, &curves.end].concat();
        }
    }
    solution
}

/// One neighbour in the difference equation: so many rows and columns away, with this factor.
#[derive(Debug, Clone, Copy)]
struct Neighbour {
    down: isize,
    right: isize,
    factor: f64,
}

/// The difference equation at one point.
fn stencil(problem: &Problem, equation: Coefficients) -> Vec<Neighbour> {
    let (h, g) = (problem.step(), std::f64::consts::TAU / problem.columns as f64);
    let Coefficients { is_fourth, s, t, w } = equation;
    let second = [(-1, 1.0), (0, -2.0), (1, 1.0)];
    let fourth = [(-2, 1.0), (-1, -4.0), (0, 6.0), (1, -4.0), (2, 1.0)];
    let mut neighbours: Vec<Neighbour> = Vec::new();
    let mut add = |down, right, factor| match neighbours.iter_mut().find(|at| (at.down, at.right) == (down, right)) {
        Some(neighbour) => neighbour.factor += factor,
        None => neighbours.push(Neighbour { down, right, factor }),
    };
    if is_fourth {
        for (along, factor) in fourth {
            add(along, 0, s * factor / h.powi(4));
            add(0, along, w * factor / g.powi(4));
        }
        for (down, first) in second {
            for (right, other) in second {
                add(down, right, t * first * other / (h * h * g * g));
            }
        }
    } else {
        for (along, factor) in second {
            add(along, 0, s * factor / (h * h));
            add(0, along, t * factor / (g * g));
        }
    }
    neighbours
}

/// The matrix of the points between the boundaries.
fn matrix(problem: &Problem, stencil: &[Neighbour]) -> SparseColMat<usize, f64> {
    let (rows, columns) = (problem.rows, problem.columns);
    let n = (rows - 2) * columns;
    let mut entries = Vec::with_capacity(stencil.len() * n);
    for row in 1..rows - 1 {
        for column in 0..columns {
            for neighbour in stencil {
                let (other, right) = (mirrored(row, neighbour, rows), around(column, neighbour, columns));
                if (1..rows - 1).contains(&other) {
                    let place = ((row - 1) * columns + column, (other - 1) * columns + right);
                    entries.push(Triplet::new(place.0, place.1, neighbour.factor));
                }
            }
        }
    }
    SparseColMat::try_new_from_triplets(n, n, &entries).expect("every entry lies inside")
}

/// The right-hand side: what the boundary curves contribute.
fn known(problem: &Problem, stencil: &[Neighbour], curves: &Curves, side: &mut [f64]) {
    let (rows, columns) = (problem.rows, problem.columns);
    for row in (1..rows - 1).filter(|row| *row < 3 || row + 4 > rows) {
        for column in 0..columns {
            let mut sum = 0.0;
            for neighbour in stencil {
                let right = around(column, neighbour, columns);
                let other = row as isize + neighbour.down;
                sum -= neighbour.factor
                    * match other {
                        0 => curves.start[right],
                        -1 => -2.0 * problem.step() * curves.start_u[right],
                        _ if other == rows as isize - 1 => curves.end[right],
                        _ if other == rows as isize => 2.0 * problem.step() * curves.end_u[right],
                        _ => 0.0,
                    };
            }
            side[(row - 1) * columns + column] = sum;
        }
    }
}

/// The row of a neighbour; a point beyond a boundary stands for its mirror image.
fn mirrored(row: usize, neighbour: &Neighbour, rows: usize) -> usize {
    let (other, last) = (row as isize + neighbour.down, rows as isize - 1);
    (if other > last { 2 * last - other } else { other.abs() }) as usize
}

fn around(column: usize, neighbour: &Neighbour, columns: usize) -> usize {
    (column as isize + neighbour.right).rem_euclid(columns as isize) as usize
}
