//! Limits at a pole or a cusp, from places beside it.

/// What a function tends to at 0, by the cubic through its values at 1, 2, 3 and 4; and how far that may be off, rounding apart: twice what a parabola finds otherwise.
pub(super) fn limit(near: impl Fn(f64) -> f64) -> (f64, f64) {
    let [one, two, three, four] = [1.0, 2.0, 3.0, 4.0].map(near);
    let (cubic, parabola) = (4.0 * one - 6.0 * two + 4.0 * three - four, 3.0 * one - 3.0 * two + three);
    (cubic, 2.0 * (cubic - parabola).abs())
}
