//! Cubics between two places, as numbers from the lowest power up.

/// The cubic with these values and slopes at 0 and at 1.
pub(crate) fn through([start, end]: [f64; 2], [start_w, end_w]: [f64; 2]) -> [f64; 4] {
    let rise = end - start;
    [start, start_w, 3.0 * rise - 2.0 * start_w - end_w, start_w + end_w - 2.0 * rise]
}

/// The value of a cubic at a place.
pub(crate) fn at([a, b, c, d]: [f64; 4], x: f64) -> f64 {
    ((d * x + c) * x + b) * x + a
}

/// Where a cubic is level between 0 and 1; of one that is level nowhere, where it is nearest to that.
pub(crate) fn level([_, b, c, d]: [f64; 4]) -> impl Iterator<Item = f64> {
    let root = libm::sqrt((c * c - 3.0 * b * d).max(0.0));
    // Both roots of b + 2 c x + 3 d x^2, without cancellation.
    let sum = -(c + libm::copysign(root, c));
    [sum / (3.0 * d), b / sum].into_iter().filter(|x| *x > 0.0 && *x < 1.0)
}

/// Where a cubic has a top between 0 and 1.
pub(crate) fn top(cubic: [f64; 4]) -> Option<f64> {
    let [_, b, c, d] = cubic;
    level(cubic).find(|x| c * c > 3.0 * b * d && c + 3.0 * d * x < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::horner;

    #[test]
    fn values_and_slopes_are_met() {
        let ends = |cubic: [f64; 4], w: f64| horner::derivatives::<2>(cubic.into_iter().rev(), w);
        let cubic = through([4.0, 2.0], [-2.0, -3.0]);
        assert_eq!((ends(cubic, 0.0), ends(cubic, 1.0)), ([4.0, -2.0], [2.0, -3.0]));
        assert_eq!((at(cubic, 0.0), at(cubic, 1.0)), (4.0, 2.0));
        assert_eq!(through([0.0, 0.0], [1.0, 0.0]), [0.0, 1.0, -2.0, 1.0]);
    }

    #[test]
    fn tops_and_dips_between_the_ends() {
        // Level at 1/4 and at 3/4: x^3 / 3 - x^2 / 2 + 3 x / 16, which has a top first.
        let cubic = [7.0, 3.0 / 16.0, -0.5, 1.0 / 3.0];
        assert_eq!(level(cubic).fold(0.0, |sum, x| sum + x), 1.0);
        assert_eq!(top(cubic), Some(0.25));
        assert_eq!(top(cubic.map(|x| -x)), Some(0.75));
        // Steady all along, beyond the ends, a parabola, and level everywhere.
        assert_eq!(top([0.0, 1.0, -1.0, 1.0]), None);
        assert_eq!(top([0.0, 1.0, 0.0, 0.0]), None);
        assert_eq!(top([0.0, 1.0, -0.25, 0.0]), None);
        assert_eq!(top([0.0, 1.0, -1.0, 0.0]), Some(0.5));
        assert_eq!(top([3.0, 0.0, 0.0, 0.0]), None);
    }
}
