//! Smooth curves over the edges of a network.

use super::edges::{Chain, Edges};
use super::point::{Point, length, minus, plus};

/// The curve over one edge, from its first point by way of its middle to its last: two cubics, joined as the whole spline is.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    places: [Point; 3],
    /// Derivatives there by the length of the chords.
    slopes: [Point; 3],
    /// From the first point to the middle, and on.
    chords: [f64; 2],
}

/// A chord is no shorter than this part of both of its edge: else the middle would pull the parameter over itself.
const LEAST_CHORD: f64 = 0.3;

impl Curve {
    fn through(places: [Point; 3]) -> Curve {
        let [first, second] = [0, 1].map(|k| length(minus(places[k + 1], places[k])));
        let (whole, part) = (first + second, first / (first + second));
        let part = part.clamp(LEAST_CHORD, 1.0 - LEAST_CHORD);
        Curve { places, slopes: [[0.0; 3]; 3], chords: [part * whole, (1.0 - part) * whole] }
    }

    /// Along both chords.
    pub(super) fn length(&self) -> f64 {
        self.chords[0] + self.chords[1]
    }

    /// How much of the length lies before the middle.
    pub(super) fn middle(&self) -> f64 {
        self.chords[0] / self.length()
    }

    /// The point at a parameter that is 1/2 in the middle.
    pub(super) fn at(&self, s: f64) -> Point {
        let x = self.length() * along(self.middle(), s);
        let half = usize::from(x > self.chords[0]);
        let h = self.chords[half];
        let t = if half == 1 { (x - self.chords[0]) / h } else { x / h };
        let (s, p, q) = (1.0 - t, half, half + 1);
        let from = plus(self.places[p].map(|x| x * s * s * (1.0 + 2.0 * t)), self.slopes[p], h * t * s * s);
        plus(plus(from, self.places[q], t * t * (1.0 + 2.0 * s)), self.slopes[q], -h * t * t * s)
    }

    /// At the beginning, or the end, the derivative by the length of the chords, and by how much that length grows with the parameter.
    pub(super) fn slope(&self, is_end: bool) -> (Point, f64) {
        let part = if is_end { 3.0 - 4.0 * self.middle() } else { 4.0 * self.middle() - 1.0 };
        (self.slopes[if is_end { 2 } else { 0 }], part * self.length())
    }
}

/// How much of an edge lies before a parameter that is 1/2 in its middle, where that is not half way.
pub(super) fn along(middle: f64, s: f64) -> f64 {
    s + (4.0 * middle - 2.0) * s * (1.0 - s)
}

/// The curves over all edges: along every chain one cubic spline with continuous curvature through corners and middles, by the length of chords, which ends as the parabola through its last three points does.
pub(super) fn curves(edges: &Edges, vertices: &[Point]) -> Vec<Curve> {
    let mut curves: Vec<Curve> =
        edges.points.iter().map(|points| Curve::through(points.map(|vertex| vertices[vertex]))).collect();
    edges.chains().iter().for_each(|chain| smooth(&mut curves, chain));
    curves
}

/// Sweeps over the equations of a spline: each halves what is left at least.
const SWEEPS: usize = 60;

/// Gives a chain of curves the slopes of the cubic spline through its points.
fn smooth(curves: &mut [Curve], Chain { links, is_round }: &Chain) {
    let mut points = Vec::new();
    let mut chords = Vec::new();
    for (edge, is_against) in links {
        let Curve { places: [from, middle, to], chords: [first, second], .. } = &curves[*edge];
        let (from, first, second) = if *is_against { (to, second, first) } else { (from, first, second) };
        points.extend([*from, *middle]);
        chords.extend([*first, *second]);
    }
    if !is_round {
        let (edge, is_against) = links[links.len() - 1];
        points.push(curves[edge].places[if is_against { 0 } else { 2 }]);
    }
    let n = points.len();
    let rate = |i: usize| minus(points[(i + 1) % n], points[i]).map(|x| x / chords[i]);
    let end = |near: Point, far: Point, h: f64, next: f64| -> Point {
        core::array::from_fn(|k| ((2.0 * h + next) * near[k] - h * far[k]) / (h + next))
    };
    let mut slopes = vec![[0.0; 3]; n];
    if !is_round {
        let m = chords.len();
        slopes[0] = end(rate(0), rate(1), chords[0], chords[1]);
        slopes[n - 1] = end(rate(m - 1), rate(m - 2), chords[m - 1], chords[m - 2]);
    }
    let inner = if *is_round { 0..n } else { 1..n - 1 };
    for _ in 0..SWEEPS {
        for i in inner.clone() {
            let before = (i + n - 1) % n;
            let (h, next) = (chords[before], chords[i]);
            let (one, other) = (rate(before), rate(i));
            let (left, right) = (slopes[before], slopes[(i + 1) % n]);
            slopes[i] = core::array::from_fn(|k| {
                (3.0 * (h * other[k] + next * one[k]) - next * left[k] - h * right[k]) / (2.0 * (h + next))
            });
        }
    }
    for (place, (edge, is_against)) in links.iter().enumerate() {
        let own = [0, 1, 2].map(|k| slopes[(2 * place + k) % n]);
        let turned = [own[2], own[1], own[0]].map(|slope| slope.map(|x| -x));
        curves[*edge].slopes = if *is_against { turned } else { own };
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::Model;
    use super::*;

    #[test]
    fn curves_go_through_their_points_and_on_without_a_corner() {
        let models = Model::all(super::super::MODELS).unwrap();
        for model in &models {
            let edges = Edges::of(&model.frames);
            let curves = curves(&edges, &model.vertices);
            for (curve, points) in curves.iter().zip(&edges.points) {
                for (s, vertex) in [0.0, 0.5, 1.0].into_iter().zip(points) {
                    assert!(length(minus(curve.at(s), model.vertices[*vertex])) < 1e-9, "{}", model.name);
                }
            }
            for Chain { links, .. } in edges.chains() {
                for pair in links.windows(2) {
                    let slope = |(edge, is_against): (usize, bool), is_end: bool| {
                        let (slope, _) = curves[edge].slope(is_end ^ is_against);
                        if is_against { slope.map(|x| -x) } else { slope }
                    };
                    let corner = length(minus(slope(pair[0], true), slope(pair[1], false)));
                    assert!(corner < 1e-9, "{} {pair:?}", model.name);
                }
            }
        }
        // Through the points of a circle goes nearly one: sixteen of them, round the mug above its foot.
        let mug = models.iter().find(|model| model.name == "own-mug").unwrap();
        let edges = Edges::of(&mug.frames);
        let radius = |[x, y, _]: Point| x.hypot(y);
        let is_on =
            |vertex: &usize| mug.vertices[*vertex][2] == 0.5 && (radius(mug.vertices[*vertex]) - 3.95).abs() < 1e-3;
        let curves = curves(&edges, &mug.vertices);
        let rim: Vec<&Curve> = curves
            .iter()
            .zip(&edges.points)
            .filter(|(_, points)| points.iter().all(is_on))
            .map(|(curve, _)| curve)
            .collect();
        assert_eq!(rim.len(), 8);
        for curve in rim {
            for s in 0..=10 {
                let off = (radius(curve.at(s as f64 / 10.0)) - 3.95).abs();
                assert!(off < 1e-3, "{off}");
            }
        }
    }
}
