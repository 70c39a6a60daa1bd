//! Points of space and ways in it.

/// A point of space, or a way in it.
pub(super) type Point = [f64; 3];

pub(super) fn plus(one: Point, other: Point, times: f64) -> Point {
    core::array::from_fn(|k| one[k] + times * other[k])
}

pub(super) fn minus(one: Point, other: Point) -> Point {
    plus(one, other, -1.0)
}

/// The sum of points, each so many times.
pub(super) fn sum(weights: &[f64], points: impl IntoIterator<Item = Point>) -> Point {
    weights.iter().zip(points).fold([0.0; 3], |sum, (weight, point)| plus(sum, point, *weight))
}

pub(super) fn dot(one: Point, other: Point) -> f64 {
    one.iter().zip(&other).map(|(one, other)| one * other).sum()
}

pub(super) fn length(of: Point) -> f64 {
    dot(of, of).sqrt()
}
