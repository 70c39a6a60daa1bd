//! The ground truth of a model: what its network is a sample of.

use pasu::Result;

use super::curve::{Curve, curves};
use super::edges::{Edges, Link};
use super::model::Model;
use super::point::{Point, dot, length, minus, plus};

/// Over every frame the patch of Gregory between smooth curves through its edges and given slopes across them, with what sculpts the model.
pub(super) struct Truth<'a> {
    pub(super) model: &'a Model,
    pub(super) edges: Edges,
    pub(super) curves: Vec<Curve>,
    patches: Vec<Gregory>,
    /// Of the bounding box.
    diagonal: f64,
}

/// Points of all patches at which a distance is measured, at least, and points of each.
const SAMPLES: [usize; 2] = [4000, 64];
/// Steps of Gauss and Newton towards the nearest point.
const STEPS: usize = 6;
/// The step of a difference.
const STEP: f64 = 1e-5;

/// A surface whose points are known by patch and parameters.
pub(super) type Surface<'a> = dyn FnMut(usize, &[[f64; 2]]) -> Result<Vec<Point>> + 'a;

impl<'a> Truth<'a> {
    pub(super) fn of(model: &'a Model) -> Result<Truth<'a>> {
        let edges = Edges::of(&model.frames);
        let curves = curves(&edges, &model.vertices);
        let patches = edges.of_patch.iter().map(|sides| Gregory::between(sides, &curves)).collect();
        let mut truth = Truth { model, edges, curves, patches, diagonal: 1.0 };
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        let at: Vec<[f64; 2]> = (0..81).map(|k| [k / 9, k % 9].map(|i| i as f64 / 8.0)).collect();
        for patch in 0..model.frames.len() {
            for point in truth.points(patch, &at)? {
                low = core::array::from_fn(|k| low[k].min(point[k]));
                high = core::array::from_fn(|k| high[k].max(point[k]));
            }
        }
        truth.diagonal = length(minus(high, low));
        Ok(truth)
    }

    /// Points of one patch.
    pub(super) fn points(&self, patch: usize, at: &[[f64; 2]]) -> Result<Vec<Point>> {
        let sculpted = self.model.sculpted(patch, at)?;
        let smooth = at.iter().map(|at| self.patches[patch].at(&self.curves, *at));
        Ok(smooth.zip(sculpted).map(|(point, sculpted)| plus(point, sculpted, 1.0)).collect())
    }

    /// The root of the mean square, by area, of the distance of a surface from this one, as a part of the diagonal.
    ///
    /// It is taken at points spread evenly over the parameters of each patch and on no lattice, at which a grid could have its own points. The nearest point of the truth is looked for from the same parameters on, across edges too.
    pub(super) fn rms(&self, surface: &mut Surface) -> Result<f64> {
        let (mut sum, mut area) = (0.0, 0.0);
        let n = self.model.frames.len();
        for patch in 0..n {
            let at = spread((SAMPLES[0] / n).max(SAMPLES[1]));
            let points = surface(patch, &at)?;
            for (at, point) in at.into_iter().zip(points) {
                let (distance, weight) = self.distance(patch, at, point)?;
                sum += weight * distance * distance;
                area += weight;
            }
        }
        Ok((sum / area).sqrt() / self.diagonal)
    }

    /// How far a point is away, and how much area is round the parameters from which the nearest is looked for.
    fn distance(&self, mut patch: usize, mut at: [f64; 2], point: Point) -> Result<(f64, f64)> {
        let (mut least, mut weight) = (f64::INFINITY, None);
        for _ in 0..STEPS {
            // Differences to the side on which there is more of the patch.
            let h = at.map(|x| if x > 0.5 { -STEP } else { STEP });
            let near = self.points(patch, &[at, [at[0] + h[0], at[1]], [at[0], at[1] + h[1]]])?;
            let [du, dv] = [0, 1].map(|k| minus(near[k + 1], near[0]).map(|x| x / h[k]));
            let off = minus(point, near[0]);
            least = least.min(length(off));
            let [a, b, c] = [dot(du, du), dot(du, dv), dot(dv, dv)];
            let determinant = a * c - b * b;
            weight = weight.or(Some(determinant.max(0.0).sqrt()));
            if determinant.is_nan() || determinant <= 1e-12 * a * c {
                break;
            }
            let [p, q] = [dot(du, off), dot(dv, off)];
            let by = [(c * p - b * q) / determinant, (a * q - b * p) / determinant];
            (patch, at) = self.onward(patch, [at[0] + by[0], at[1] + by[1]]);
        }
        Ok((least, weight.unwrap_or_default()))
    }

    /// The patch that has a point a little outside of another, and where it is there.
    fn onward(&self, patch: usize, at: [f64; 2]) -> (usize, [f64; 2]) {
        let out = [-at[0], at[0] - 1.0, -at[1], at[1] - 1.0];
        let inside = |at: [f64; 2]| at.map(|x| x.clamp(0.0, 1.0));
        let side = (0..4).fold(0, |most, side| if out[side] > out[most] { side } else { most });
        let (edge, is_against) = self.edges.of_patch[patch][side];
        let others = self.edges.patches[edge].iter().find(|other| **other != (patch, side));
        let Some((other, entered)) = others.filter(|_| out[side] > 0.0) else {
            return (patch, inside(at));
        };
        let along = if side < 2 { at[1] } else { at[0] };
        let along = if is_against ^ self.edges.of_patch[*other][*entered].1 { 1.0 - along } else { along };
        let into = if entered % 2 == 0 { out[side] } else { 1.0 - out[side] };
        (*other, inside(if *entered < 2 { [into, along] } else { [along, into] }))
    }
}

/// So many points spread over the unit square, by multiples of two irrational numbers.
fn spread(n: usize) -> Vec<[f64; 2]> {
    // Powers of the root of x^3 = x + 1 (M. Roberts, 2018).
    (0..n).map(|k| [0.754_877_666_246_693, 0.569_840_290_998_053].map(|by| (0.5 + k as f64 * by).fract())).collect()
}

/// A patch between four curves, with slopes across them (J. A. Gregory, Smooth interpolation without twist constraints, 1974).
///
/// The slope across a side goes in a straight line from that of the one curve at its ends to that of the other: in its direction, and in its length. Where the curves go straight on through the corners, so do patches across an edge.
struct Gregory {
    sides: [Link; 4],
    /// At each end of each side, of the curve that leaves there inwards: its derivative by its length, and how that grows with the parameter.
    across: [[(Point, f64); 2]; 4],
}

impl Gregory {
    fn between(sides: &[Link; 4], curves: &[Curve]) -> Gregory {
        let slope = |side: usize, is_end: bool| {
            let (edge, is_against) = sides[side];
            let (slope, growth) = curves[edge].slope(is_end ^ is_against);
            (if is_against { slope.map(|x| -x) } else { slope }, growth)
        };
        // Along u = 0 leave v = 0 and v = 1 at their beginnings, and so on.
        let across = [
            [slope(2, false), slope(3, false)],
            [slope(2, true), slope(3, true)],
            [slope(0, false), slope(1, false)],
            [slope(0, true), slope(1, true)],
        ];
        Gregory { sides: *sides, across }
    }

    fn slope_across(&self, side: usize, t: f64) -> Point {
        let [(from, growth), (to, other)] = self.across[side];
        plus(from, minus(to, from), t).map(|x| x * (growth + t * (other - growth)))
    }

    /// The derivative of it along the side, at an end.
    fn twist(&self, side: usize, is_end: bool) -> Point {
        let [(from, growth), (to, other)] = self.across[side];
        let (at, by) = if is_end { (to, other) } else { (from, growth) };
        plus(minus(to, from).map(|x| x * by), at, other - growth)
    }

    fn at(&self, curves: &[Curve], [u, v]: [f64; 2]) -> Point {
        let curve = |side: usize, t: f64| {
            let (edge, is_against) = self.sides[side];
            curves[edge].at(if is_against { 1.0 - t } else { t })
        };
        let hermite = |t: f64| {
            let s = 1.0 - t;
            [s * s * (1.0 + 2.0 * t), t * t * (1.0 + 2.0 * s), t * s * s, -t * t * s]
        };
        let (along, up) = (hermite(u), hermite(v));
        let mut point = [0.0; 3];
        for end in 0..2 {
            point = plus(point, curve(end, v), along[end]);
            point = plus(point, self.slope_across(end, v), along[2 + end]);
            point = plus(point, curve(2 + end, u), up[end]);
            point = plus(point, self.slope_across(2 + end, u), up[2 + end]);
        }
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            // How far from the corner.
            let (p, q) = (if i == 0 { u } else { 1.0 - u }, if j == 0 { v } else { 1.0 - v });
            let twist = if p + q > 0.0 {
                let (one, other) = (self.twist(i, j == 1), self.twist(2 + j, i == 1));
                plus(one.map(|x| x * p / (p + q)), other, q / (p + q))
            } else {
                [0.0; 3]
            };
            let end = |t: usize| t as f64;
            point = plus(point, curve(i, end(j)), -along[i] * up[j]);
            point = plus(point, self.slope_across(i, end(j)), -along[2 + i] * up[j]);
            point = plus(point, self.slope_across(2 + j, end(i)), -along[i] * up[2 + j]);
            point = plus(point, twist, -along[2 + i] * up[2 + j]);
        }
        point
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use serde_json::json;

    /// A quarter of a torus by frames that are as good as they get: on it, and evenly.
    pub(in crate::storage) fn torus(n: usize) -> Model {
        let m = 2 * n + 1;
        let point = |k: usize| {
            let [a, b] = [k / m, k % m].map(|i| i as f64 / (m - 1) as f64 * std::f64::consts::FRAC_PI_2);
            let r = 3.0 + b.cos();
            json!([r * a.cos(), r * a.sin(), b.sin()])
        };
        let frame = |k: usize| {
            let (i, j) = (2 * (k / n), 2 * (k % n));
            let round = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
            json!({ "frame": round.map(|(a, b)| m * (i + a) + j + b) })
        };
        let shape = json!({
            "kind": "vertex-frame",
            "vertices": (0..m * m).map(point).collect::<Vec<_>>(),
            "patches": (0..n * n).map(frame).collect::<Vec<_>>(),
        });
        Model::of("torus", &shape).unwrap()
    }

    #[test]
    fn the_truth_of_frames_on_a_torus_is_nearly_that_torus() {
        let off = [2, 4, 8].map(|n| {
            let model = torus(n);
            let truth = Truth::of(&model).unwrap();
            let from_torus = |[x, y, z]: Point| ((x.hypot(y) - 3.0).hypot(z) - 1.0).abs();
            let points = (0..n * n).flat_map(|patch| truth.points(patch, &spread(50)).unwrap());
            points.map(from_torus).fold(0.0, f64::max)
        });
        assert!(off[1] < off[0] / 7.0 && off[2] < off[1] / 7.0 && off[2] < 2e-4, "{off:?}");
    }

    #[test]
    fn patches_of_the_truth_touch_along_edges_through_which_curves_go_straight_on() {
        let model = torus(3);
        let truth = Truth::of(&model).unwrap();
        let h = 1e-6;
        let mut seen = 0;
        for edge in (0..truth.edges.len()).filter(|edge| !truth.edges.is_free(*edge)) {
            for t in [0.1, 0.5, 0.8] {
                let normal = |(patch, side): (usize, usize)| {
                    let is_against = truth.edges.of_patch[patch][side].1;
                    let t = if is_against { 1.0 - t } else { t };
                    let edge = (side % 2) as f64;
                    let step = if side % 2 == 0 { h } else { -h };
                    let at = match side {
                        0 | 1 => [[edge, t], [edge + step, t], [edge, t + h]],
                        _ => [[t, edge], [t, edge + step], [t + h, edge]],
                    };
                    let [here, into, on] = truth.points(patch, &at).unwrap().try_into().unwrap();
                    let (a, b) = (minus(into, here), minus(on, here));
                    let n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                    n.map(|x| x / length(n))
                };
                let [one, other] = [0, 1].map(|k| normal(truth.edges.patches[edge][k]));
                assert!(dot(one, other).abs() > 1.0 - 1e-9, "{edge} {t} {one:?} {other:?}");
                seen += 1;
            }
        }
        assert_eq!(seen, 3 * 12);
    }

    #[test]
    fn a_distance_is_found_across_edges_and_told_in_parts_of_the_diagonal() {
        let model = torus(3);
        let truth = Truth::of(&model).unwrap();
        // The same surface, but told to be elsewhere in it: the patch next to it has it.
        let mut slid = |patch: usize, at: &[[f64; 2]]| {
            let at: Vec<[f64; 2]> = at.iter().map(|[u, v]| [u + 0.1, *v]).collect();
            let (inside, outside): (Vec<_>, Vec<_>) = (0..at.len()).partition(|k| at[*k][0] <= 1.0);
            let mut points = vec![[0.0; 3]; at.len()];
            for k in inside {
                points[k] = truth.points(patch, &[at[k]])?[0];
            }
            for k in outside {
                let (other, at) = truth.onward(patch, at[k]);
                points[k] = truth.points(other, &[at])?[0];
            }
            Ok(points)
        };
        assert!(truth.rms(&mut slid).unwrap() < 1e-9);
        // A quarter of a torus that is as much thicker.
        let mut thicker = |patch: usize, at: &[[f64; 2]]| {
            let points = truth.points(patch, at)?.into_iter().map(|[x, y, z]| {
                let r = x.hypot(y);
                let (out, up) = ((r - 3.0) * 1.01 + 3.0, 1.01 * z);
                [x * out / r, y * out / r, up]
            });
            Ok(points.collect())
        };
        let diagonal = length([4.0, 4.0, 1.0]);
        let rms = truth.rms(&mut thicker).unwrap();
        assert!((rms * diagonal - 0.01).abs() < 2e-4, "{rms}");
    }
}
