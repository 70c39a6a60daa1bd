//! A polynomial that meets the force, whatever its boundary values.

use super::equation::Equation;
use super::order::Order;
use super::roots::{largest_rate, squared_roots};
use super::series::{about_the_middle, continue_series, falling};

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
                None if rate > ONE_PIECE_RATE => {
                    let (low, high) = split(&force, rate);
                    added(invert_complex(b, c, low), &continue_series(&[0.0; 4], &[(2, b), (0, -c)], &high))
                }
                _ => continue_series(&[0.0; 4], &[(2, b), (0, -c)], &force),
            }
        }
    }
}

/// The powers below half the rate and the others.
///
/// Of the low ones the polynomial is found from the highest power down: dividing by the squared rate outweighs differentiating twice on
/// `|x| <= 1/2`, so no term outgrows the force. Of the high ones it is grown from the middle up: each step divides by two powers and multiplies by the rate times `x`,
/// twice. Either would lose all digits where the other is right, so a force of any degree needs both.
fn split(force: &[f64], rate: f64) -> (&[f64], Vec<f64>) {
    let cut = force.len().min((0.5 * rate) as usize);
    let mut high = force.to_vec();
    high[..cut].fill(0.0);
    (&force[..cut], high)
}

pub(super) fn added(mut sum: Vec<f64>, other: &[f64]) -> Vec<f64> {
    if sum.len() < other.len() {
        sum.resize(other.len(), 0.0);
    }
    for (sum, term) in sum.iter_mut().zip(other) {
        *sum += term;
    }
    sum
}

/// A solution of `q'' - z q = g`.
fn invert(z: f64, g: &[f64]) -> Vec<f64> {
    let (low, high) = split(g, z.abs().sqrt());
    // q = -(g + g'' / z + g'''' / z^2 + ..) / z, from the highest power down.
    let mut q = vec![0.0; low.len()];
    for m in (0..low.len()).rev() {
        let second = q.get(m + 2).map_or(0.0, |a| falling(m + 2, 2) * a);
        q[m] = (second - low[m]) / z;
    }
    added(q, &continue_series(&[0.0; 2], &[(0, z)], &high))
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
