//! A polynomial that meets the force, whatever its boundary values.

use super::equation::{Equation, largest_rate, squared_roots};
use super::series::{about_the_middle, continue_series, falling};
use crate::design::Order;

/// Up to this rate a particular solution may be grown from the middle as a power series: at the ends it reaches `e^15 / 30^2`
/// times the force, so that rounding costs at most `1e-12` of the force.
const SERIES_RATE: f64 = 30.0;

/// Up to this rate an order 4 problem is grown in one piece, whatever its regime.
const ONE_PIECE_RATE: f64 = 6.0;

/// A particular solution of the equation under the force (ascending powers of `u`, not divided by `s`), as a polynomial
/// in `x = u - 1/2`; empty when there is no force.
pub(super) fn particular(equation: &Equation, force: &[f64]) -> Vec<f64> {
    if force.iter().all(|&f| f == 0.0) {
        return Vec::new();
    }
    let force: Vec<f64> = about_the_middle(force).iter().map(|f| f / equation.s).collect();
    let (b, c) = (equation.b, equation.c);
    match equation.order {
        Order::Second => invert(b, &force),
        Order::Fourth => {
            let rate = largest_rate(Order::Fourth, b, c);
            match squared_roots(b, c) {
                Some((large, small)) if rate > ONE_PIECE_RATE => invert(small, &invert(large, &force)),
                None if rate > ONE_PIECE_RATE && (recursion_is_tame(rate, &force) || rate > SERIES_RATE) => {
                    invert_complex(b, c, &force)
                }
                _ => continue_series(&[0.0; 4], &[(2, b), (0, -c)], &force),
            }
        }
    }
}

/// Whether dividing by the squared rate outweighs differentiating twice, so that the terms of the recursion never grow.
fn recursion_is_tame(rate: f64, force: &[f64]) -> bool {
    rate >= ONE_PIECE_RATE.max(force.len() as f64)
}

/// A solution of `q'' - z q = g`.
fn invert(z: f64, g: &[f64]) -> Vec<f64> {
    let rate = libm::sqrt(z.abs());
    if rate > SERIES_RATE || recursion_is_tame(rate, g) {
        // q = -(g + g'' / z + g'''' / z^2 + ..) / z, from the highest power down.
        let mut q = vec![0.0; g.len()];
        for m in (0..g.len()).rev() {
            let second = q.get(m + 2).map_or(0.0, |a| falling(m + 2, 2) * a);
            q[m] = (second - g[m]) / z;
        }
        q
    } else {
        continue_series(&[0.0; 2], &[(0, z)], g)
    }
}

/// A solution of `q'''' - b q'' + c q = g` whose roots are complex, from the highest power down.
fn invert_complex(b: f64, c: f64, g: &[f64]) -> Vec<f64> {
    let mut q = vec![0.0; g.len()];
    for m in (0..g.len()).rev() {
        let second = q.get(m + 2).map_or(0.0, |a| falling(m + 2, 2) * a);
        let fourth = q.get(m + 4).map_or(0.0, |a| falling(m + 4, 4) * a);
        q[m] = (g[m] + b * second - fourth) / c;
    }
    q
}
