//! The way up to a local maximum of a smooth function of two variables whose slopes are known: Newton's method.

use nalgebra::{Matrix2, Vector2};

use super::climb::{Place, top};

/// What a function is at a place: its value, and its derivatives by `a` and by `v`.
pub(crate) type Sloped = (f64, [f64; 2]);

/// Steps that the method takes at most: where it is of use, a handful.
const MOST_STEPS: usize = 12;

/// Slopes are compared over this part of a step: what is cut off and what is rounded are then both some 1e-6 of the second derivatives.
const BESIDE: f64 = 1e-5;

/// A step as short as this part of the first leads to the top but for rounding: the value there is level.
const SHORTEST: f64 = 1e-7;

/// Values that are level may fall by this part.
const ROUNDING: f64 = 1e-14;

/// Ascends from a place to a local maximum, within `a` in [0, 1]; no step is longer than the first ones. `None` where the function is not like a hill, or too rough for the method: [`climb`] is slower
/// and minds neither.
///
/// [`climb`]: super::climb::climb
pub(crate) fn ascend(
    start: (f64, f64),
    (step_a, step_v): (f64, f64),
    mut at: impl FnMut(f64, f64) -> Sloped,
) -> Option<Place> {
    let (mut a, mut v) = start;
    let (mut value, mut slopes) = at(a, v);
    for _ in 0..MOST_STEPS {
        // In steps, so that both coordinates weigh alike.
        let gradient = Vector2::new(slopes[0] * step_a, slopes[1] * step_v);
        let mut bend = |to_a: f64, to_v: f64| {
            let (_, there) = at(a + to_a * step_a, v + to_v * step_v);
            let rise = Vector2::new(there[0] * step_a, there[1] * step_v) - gradient;
            rise / (to_a + to_v)
        };
        let round = bend(0.0, BESIDE);
        // The step round alone, where that bends downwards.
        let alone = || (round.y < 0.0).then(|| -gradient.y / round.y);
        let is_held = a == 0.0 && gradient.x <= 0.0 || a == 1.0 && gradient.x >= 0.0;
        let step = if is_held {
            Vector2::new(0.0, alone()?)
        } else {
            let along = bend(if a < 0.5 { BESIDE } else { -BESIDE }, 0.0);
            let across = 0.5 * (along.y + round.x);
            match top(&gradient, &Matrix2::new(along.x, across, across, round.y)) {
                Some(step) => step,
                // It rises to an end without bending downwards.
                None if along.x >= 0.0 && gradient.x != 0.0 => Vector2::new(gradient.x.signum(), alone()?),
                None => return None,
            }
        };
        let step = step.map(|step| step.clamp(-1.0, 1.0));
        let next = ((a + step.x * step_a).clamp(0.0, 1.0), v + step.y * step_v);
        let (higher, there) = at(next.0, next.1);
        // Nor what is no number.
        if !(higher >= value - ROUNDING * value.abs()) {
            return None;
        }
        let is_done = step.amax() <= SHORTEST;
        if is_done && higher < value {
            return Some(Place { a, v, value });
        }
        ((a, v), value, slopes) = (next, higher, there);
        if is_done {
            return Some(Place { a, v, value });
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: (f64, f64) = (0.05, 0.2);

    #[test]
    fn a_smooth_top_is_reached_to_rounding_in_a_few_steps() {
        let mut asked = 0;
        let hill = |a: f64, v: f64| {
            asked += 1;
            let (x, y) = (a - 0.31, v - 1.3);
            let value = libm::exp(-x * x - x * y - y * y);
            (value, [-(2.0 * x + y) * value, -(x + 2.0 * y) * value])
        };
        let found = ascend((0.2, 1.0), STEPS, hill).unwrap();
        assert!((found.value - 1.0).abs() < 1e-15, "{found:?}");
        assert!((found.a - 0.31).abs() < 1e-8 && (found.v - 1.3).abs() < 1e-8, "{found:?}");
        assert!(asked <= 25, "{asked}");
    }

    #[test]
    fn the_way_ends_at_an_end_and_goes_along_it() {
        let found = ascend((0.9, 1.0), STEPS, |a, v| (a - 0.5 * (v - 1.2) * (v - 1.2), [1.0, 1.2 - v])).unwrap();
        assert!(found.a == 1.0 && (found.v - 1.2).abs() < 1e-8, "{found:?}");
    }

    #[test]
    fn what_is_no_smooth_hill_is_left_to_others() {
        assert_eq!(ascend((0.4, 2.0), STEPS, |_, _| (3.0, [0.0; 2])), None);
        assert_eq!(ascend((0.4, 2.0), STEPS, |_, _| (f64::NAN, [f64::NAN; 2])), None);
        // A roof whose slopes point to the ridge and say nothing of how far it is.
        let roof = |a: f64, v: f64| (-(a - 0.43).abs() - v * v, [if a < 0.43 { 1.0 } else { -1.0 }, -2.0 * v]);
        assert_eq!(ascend((0.4, 0.1), STEPS, roof), None);
    }
}
