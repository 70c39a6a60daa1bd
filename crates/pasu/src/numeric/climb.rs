//! The way up to a local maximum of a function of two variables, without derivatives: a quadratic through nine points at each step.

use nalgebra::{Matrix2, Vector2};

use crate::watch;

/// A place in the parameters of a surface and the value of a function there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    pub(crate) a: f64,
    pub(crate) v: f64,
    pub(crate) value: f64,
}

/// How often a step is taken or shortened at most.
const MOST_STEPS: usize = 60;

/// Steps end when they are this part of the first: then a quadratic top is reached to rounding.
const SHORTEST: f64 = 1e-8;

/// A quadratic whose determinant is this small against the product of its diagonal is a ridge, which has no top.
const FLAT: f64 = 1e-8;

/// Climbs from a place to a local maximum, within `a` in [0, 1].
///
/// At each step a quadratic is laid through nine points; its top, or the best of the nine where it has none, is taken if it is higher, otherwise the points draw together. A kink slows
/// this down and does not mislead it.
pub(crate) fn climb(start: Place, step_a: f64, step_v: f64, mut of: impl FnMut(f64, f64) -> f64) -> Place {
    let mut best = start;
    let (mut p, mut q) = (step_a.min(0.5), step_v);
    for _ in 0..MOST_STEPS {
        if p < SHORTEST * step_a || watch::is_stopped() {
            break;
        }
        let centre = best.a.clamp(p, 1.0 - p);
        let mut f = [[0.0; 3]; 3];
        let before = best;
        for (i, row) in f.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                let (a, v) = (centre + (i as f64 - 1.0) * p, before.v + (j as f64 - 1.0) * q);
                *value = of(a, v);
                if *value > best.value {
                    best = Place { a, v, value: *value };
                }
            }
        }
        let gradient = Vector2::new(0.5 * (f[2][1] - f[0][1]), 0.5 * (f[1][2] - f[1][0]));
        let (haa, hvv) = (f[2][1] - 2.0 * f[1][1] + f[0][1], f[1][2] - 2.0 * f[1][1] + f[1][0]);
        let hav = 0.25 * (f[2][2] - f[2][0] - f[0][2] + f[0][0]);
        let hessian = Matrix2::new(haa, hav, hav, hvv);
        let alone = |gradient: f64, bend: f64| {
            let step = if bend < 0.0 { -gradient / bend } else { gradient * 1e300 };
            if step.is_finite() { step.clamp(-3.0, 3.0) } else { 0.0 }
        };
        let step =
            top(&gradient, &hessian).unwrap_or_else(|| Vector2::new(alone(gradient.x, haa), alone(gradient.y, hvv)));
        let (sa, sv) = (step.x, step.y);
        let mut candidates = vec![(centre + sa * p, before.v + sv * q)];
        if !(0.0..=1.0).contains(&candidates[0].0) {
            // Against an end: the best along it.
            let end = candidates[0].0.clamp(0.0, 1.0);
            let slope = gradient.y + hav * (end - centre) / p;
            candidates[0] = (end, before.v + alone(slope, hvv) * q);
        }
        for (a, v) in candidates {
            let value = of(a, v);
            if value > best.value {
                best = Place { a, v, value };
            }
        }
        let moved = ((best.a - before.a) / p).abs().max(((best.v - before.v) / q).abs());
        if moved < 0.5 {
            // Nearly there: the quadratic is the better the closer its points.
            (p, q) = (0.125 * p, 0.125 * q);
        } else if moved < 1.5 {
            (p, q) = (0.5 * p, 0.5 * q);
        } else if moved > 2.5 {
            (p, q) = ((2.0 * p).min(0.5), 2.0 * q);
        }
    }
    best
}

/// The way to the top of a quadratic, `-H^-1 g`, shortened to three steps where it is longer; `None` where it has no top, or hardly one.
pub(super) fn top(gradient: &Vector2<f64>, hessian: &Matrix2<f64>) -> Option<Vector2<f64>> {
    let is_clear = hessian.determinant() > FLAT * hessian.m11 * hessian.m22;
    // A top is where minus the matrix is positive definite: where it has a Cholesky factor.
    let step = (-hessian).cholesky().filter(|_| is_clear)?.solve(gradient);
    let step = step * (3.0 / step.amax()).min(1.0);
    step.iter().all(|step| step.is_finite()).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From where it is begun to the top within a few steps of the first size.
    fn climbed(a: f64, v: f64, hill: fn(f64, f64) -> f64) -> Place {
        climb(Place { a, v, value: hill(a, v) }, 0.05, 0.2, hill)
    }

    #[test]
    fn a_smooth_top_is_reached_to_rounding() {
        let found = climbed(0.2, 1.0, |a, v| 1.0 - (a - 0.31).powi(2) - (a - 0.31) * (v - 1.3) - (v - 1.3).powi(2));
        assert!((found.value - 1.0).abs() < 1e-15, "{found:?}");
        assert!((found.a - 0.31).abs() < 1e-7 && (found.v - 1.3).abs() < 1e-7, "{found:?}");
    }

    #[test]
    fn a_climb_stays_within_the_ends() {
        let found = climbed(0.9, 1.0, |a, v| a - (v - 1.2).powi(2));
        assert!(found.a == 1.0 && (found.v - 1.2).abs() < 1e-7, "{found:?}");
    }

    #[test]
    fn a_level_function_and_one_that_is_nowhere_finite_stay_where_they_are() {
        assert_eq!(climbed(0.4, 2.0, |_, _| 3.0), Place { a: 0.4, v: 2.0, value: 3.0 });
        let found = climb(Place { a: 0.4, v: 2.0, value: 3.0 }, 0.05, 0.2, |_, _| f64::NAN);
        assert_eq!(found, Place { a: 0.4, v: 2.0, value: 3.0 });
    }
}
