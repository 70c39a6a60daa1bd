//! Limits of a function at a place where it cannot be formed, from places beside it.

/// What a function tends to at 0, by the cubic through its values at 1, 2, 3 and 4; and how far that may be off, rounding apart: twice what a parabola finds otherwise.
///
/// Exact for cubics. The weights add up to 15 in size, by which the rounding of the values grows. Not finite where one of the values is not.
pub(crate) fn limit(near: impl Fn(f64) -> f64) -> (f64, f64) {
    let [one, two, three, four] = [1.0, 2.0, 3.0, 4.0].map(near);
    let (cubic, parabola) = (4.0 * one - 6.0 * two + 4.0 * three - four, 3.0 * one - 3.0 * two + three);
    (cubic, 2.0 * (cubic - parabola).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_exact() {
        let (value, _) = limit(|x| 5.0 - 2.0 * x + 3.0 * x * x - x * x * x);
        assert_eq!(value, 5.0);
        let (value, off) = limit(|x| 5.0 - 2.0 * x + 3.0 * x * x);
        assert_eq!((value, off), (5.0, 0.0));
    }

    #[test]
    fn the_error_is_covered() {
        for step in [0.3, 0.1, 0.01] {
            let (value, off) = limit(|n| libm::exp(step * n));
            assert!((value - 1.0).abs() <= off && off < 5.0 * step * step * step, "{step}: {value} {off}");
        }
    }
}
