//! What an octant holds, and where a line goes through its border.

use glam::DVec3;

/// Halvings after which an interval of a line is no wider than rounding.
const HALVINGS: usize = 60;

/// A place at which a line goes through the border of an octant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Through {
    /// How many times the direction it is from the origin of the line.
    pub(crate) t: f64,
    /// The patch: 0 the curved one, 1 to 3 those in the planes `x = 0`, `y = 0`, `z = 0`.
    pub(crate) patch: usize,
}

/// `x^a + y^b + z^c - 1` at a point of which no coordinate is negative: at most 0 in the octant.
pub(super) fn excess(exponents: [f64; 3], at: DVec3) -> f64 {
    let powers = at.to_array().into_iter().zip(exponents).map(|(x, exponent)| libm::pow(x.max(0.0), exponent));
    powers.sum::<f64>() - 1.0
}

/// What the excess is wrong by at most where it is near 0: powers are, by a unit of the last place or two.
const ROUNDING: f64 = 1e-14;

/// Whether an octant holds all of a box along its axes: with a point it holds all whose coordinates are less.
pub(super) fn holds_box(exponents: [f64; 3], low: DVec3, high: DVec3) -> bool {
    low.min_element() >= 0.0 && excess(exponents, high) <= -ROUNDING
}

/// Whether no point of a box along its axes is in an octant.
pub(super) fn misses_box(exponents: [f64; 3], low: DVec3, high: DVec3) -> bool {
    high.min_element() < 0.0 || excess(exponents, low) > ROUNDING
}

/// The exponent of a convex octant that holds all of one with a lesser exponent: a coordinate is 1 at most, and its power falls as the exponent rises. Of 1 itself what is furthest in a direction may be a whole side.
const CONVEX: f64 = 1.02;

/// Steps towards the number by which the furthest place in a direction is found: few are needed, and a bound holds after any.
const STEPS: usize = 30;

/// From how near to 1 the sum of the powers is taken for 1: what the bound is wrong by is the square of that.
const ENOUGH: f64 = 1e-8;

/// How far an octant reaches in a direction at most, with a place of the least convex octant about it that is all but as far.
///
/// Where `d x` is to be largest with `sum x^a <= 1`, it is `m + sum (d x - m x^a)` at most, whatever `m > 0` is, with each `x` from 0 to 1 where its own term is largest; and no more than that where `sum x^a` is 1 (Lagrange's dual).
///
/// With `t = log m` the powers are `exp(p (l - t))`, where `l = log(d / a)` and `p = a / (a - 1)`, and the logarithm of their sum is convex and falls. From the largest `l` on, where the sum is 1 or more, Newton's steps towards the place at which it is 1 never go too far.
pub(super) fn reach(exponents: [f64; 3], direction: DVec3) -> (f64, DVec3) {
    let d = direction.max(DVec3::ZERO).to_array();
    let most = d.iter().sum::<f64>();
    if !(most > 0.0) {
        return (0.0, DVec3::ZERO);
    }
    let a = exponents.map(|exponent| exponent.max(CONVEX));
    let logarithms: [f64; 3] = core::array::from_fn(|i| libm::log(d[i] / (most * a[i])));
    let rates = a.map(|a| a / (a - 1.0));
    let mut t = logarithms.into_iter().fold(f64::NEG_INFINITY, f64::max);
    for _ in 0..STEPS {
        let (mut sum, mut fall) = (0.0, 0.0);
        for i in 0..3 {
            let power = libm::exp(rates[i] * (logarithms[i] - t));
            sum += power;
            fall += rates[i] * power;
        }
        if !(sum > 1.0 + ENOUGH) {
            break;
        }
        t += libm::log(sum) * sum / fall;
    }
    let m = most * libm::exp(t);
    let x: [f64; 3] = core::array::from_fn(|i| libm::exp((logarithms[i] - t) / (a[i] - 1.0)).min(1.0));
    let bound = m + (0..3).map(|i| d[i] * x[i] - m * libm::pow(x[i], a[i])).sum::<f64>();
    let corner = || DVec3::from_array(d.map(|d| if d > 0.0 { 1.0 } else { 0.0 }));
    let (bound, at) = if bound <= most { (bound, DVec3::from_array(x)) } else { (most, corner()) };
    (bound * (1.0 + ROUNDING), at)
}

/// A place of an octant near to a point: the coordinates that are negative made 0, and all of them less by the share that is beyond the curved side.
pub(super) fn place_near(exponents: [f64; 3], at: DVec3) -> DVec3 {
    let at = at.max(DVec3::ZERO);
    if excess(exponents, at) <= 0.0 {
        return at;
    }
    let (mut inside, mut outside) = (0.0f64, 1.0f64);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        if excess(exponents, at * middle) > 0.0 { outside = middle } else { inside = middle }
    }
    at * inside
}

/// A line `origin + t direction` in the frame of an octant.
struct Line {
    exponents: [f64; 3],
    origin: [f64; 3],
    direction: [f64; 3],
}

impl Line {
    fn at(&self, t: f64) -> DVec3 {
        DVec3::from_array(core::array::from_fn(|i| self.origin[i] + t * self.direction[i]))
    }

    fn excess(&self, t: f64) -> f64 {
        excess(self.exponents, self.at(t))
    }

    /// Between what the excess, and its derivative, lie from one place to another. Every term of either rises or falls all the way, so that its ends bound it.
    fn range(&self, from: f64, to: f64) -> [[f64; 2]; 2] {
        let mut range = [[-1.0, -1.0], [0.0, 0.0]];
        let [one, other] = [from, to].map(|t| self.at(t).max(DVec3::ZERO));
        for (i, exponent) in self.exponents.into_iter().enumerate() {
            let speed = self.direction[i];
            let (least, most) = if one[i] < other[i] { (one[i], other[i]) } else { (other[i], one[i]) };
            range[0][0] += libm::pow(least, exponent);
            range[0][1] += libm::pow(most, exponent);
            if speed == 0.0 {
                continue;
            }
            let slopes = [least, most].map(|x| exponent * speed * libm::pow(x, exponent - 1.0));
            range[1][0] += slopes[0].min(slopes[1]);
            range[1][1] += slopes[0].max(slopes[1]);
        }
        range
    }

    /// The places between two at which the excess changes its sign.
    fn changes(&self, from: f64, to: f64, halvings: usize, found: &mut Vec<f64>) {
        let [[least, most], [falls, rises]] = self.range(from, to);
        if least > 0.0 || most < 0.0 {
            return;
        }
        let middle = 0.5 * (from + to);
        let is_monotone = falls >= 0.0 || rises <= 0.0;
        let is_over = halvings == 0 || middle <= from || middle >= to;
        if is_monotone || is_over {
            let is_outside = self.excess(from) > 0.0;
            if is_outside == (self.excess(to) > 0.0) {
                return;
            }
            let (mut low, mut high) = (from, to);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if middle <= low || middle >= high {
                    break;
                }
                if (self.excess(middle) > 0.0) == is_outside { low = middle } else { high = middle }
            }
            found.push(0.5 * (low + high));
            return;
        }
        self.changes(from, middle, halvings - 1, found);
        self.changes(middle, to, halvings - 1, found);
    }
}

/// Where a line goes through the border, in the order of `t`. A line that only touches it does not.
///
/// What lies within `0 <= x, y, z <= 1` is an interval of the line; on it the excess is a sum of three powers, each of which rises or falls all the way, and so are their derivatives: intervals on which the sum has no root, or
/// no more than one, are told from their ends.
pub(super) fn through(exponents: [f64; 3], origin: DVec3, direction: DVec3) -> Vec<Through> {
    let line = Line { exponents, origin: origin.to_array(), direction: direction.to_array() };
    let mut from = (f64::NEG_INFINITY, 0);
    let mut to = (f64::INFINITY, 0);
    for axis in 0..3 {
        let (x, speed) = (line.origin[axis], line.direction[axis]);
        if speed == 0.0 {
            if !(0.0..=1.0).contains(&x) {
                return Vec::new();
            }
            continue;
        }
        // The patch of the plane, or the curved one, beyond which nothing is at 1.
        let [zero, one] = [((0.0 - x) / speed, axis + 1), ((1.0 - x) / speed, 0)];
        let (first, last) = if speed > 0.0 { (zero, one) } else { (one, zero) };
        if first.0 > from.0 {
            from = first;
        }
        if last.0 < to.0 {
            to = last;
        }
    }
    if !(from.0 < to.0) || !from.0.is_finite() || !to.0.is_finite() {
        return Vec::new();
    }
    let mut places = Vec::new();
    line.changes(from.0, to.0, HALVINGS, &mut places);
    let mut through: Vec<Through> = places.into_iter().map(|t| Through { t, patch: 0 }).collect();
    // Through a plane where that is within the curve; and where a coordinate is 1 and the others have no power, the curved side is as flat.
    for (t, patch) in [from, to] {
        if line.excess(t) <= 0.0 {
            through.push(Through { t, patch });
        }
    }
    through.sort_by(|one, other| one.t.total_cmp(&other.t));
    through
}

/// A point deep inside: half of the way to the curved side along the diagonal.
pub(super) fn core(exponents: [f64; 3]) -> DVec3 {
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if excess(exponents, DVec3::splat(middle)) > 0.0 { high = middle } else { low = middle }
    }
    DVec3::splat(0.5 * low)
}

/// The unit normal that points out of the octant, at a point of one of its patches.
pub(super) fn normal(exponents: [f64; 3], at: DVec3, patch: usize) -> DVec3 {
    match patch {
        1 => DVec3::NEG_X,
        2 => DVec3::NEG_Y,
        3 => DVec3::NEG_Z,
        _ => {
            // By logarithms: of large exponents every component may be below the least double.
            let logarithms: [f64; 3] = core::array::from_fn(|i| {
                libm::log(exponents[i]) + (exponents[i] - 1.0) * libm::log(at[i].max(f64::MIN_POSITIVE))
            });
            let largest = logarithms.into_iter().fold(f64::NEG_INFINITY, f64::max);
            DVec3::from_array(logarithms.map(|component| libm::exp(component - largest))).normalize_or(DVec3::Z)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOME: [[f64; 3]; 8] = [
        [2.0, 2.0, 2.0],
        [1.0, 1.0, 1.0],
        [0.5, 0.7, 1.4],
        [0.05, 2.0, 50.0],
        [50.0, 50.0, 50.0],
        [3.0, 1.5, 0.9],
        [50.0, 0.05, 2.0],
        [0.05, 0.05, 0.05],
    ];

    fn dice(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1u64 << 53) as f64
    }

    fn holds(exponents: [f64; 3], at: DVec3) -> bool {
        at.min_element() >= 0.0 && excess(exponents, at) <= 0.0
    }

    /// Between two places of a line that follow each other nothing changes, and at each something does.
    #[test]
    fn lines_are_inside_from_every_second_place_on() {
        let mut seed = 1;
        for exponents in SOME {
            for _ in 0..400 {
                let mut point = || DVec3::new(dice(&mut seed), dice(&mut seed), dice(&mut seed)) * 1.6 - 0.3;
                let (origin, to) = (point(), point());
                let direction = to - origin;
                let places = through(exponents, origin, direction);
                assert_eq!(places.len() % 2, 0, "{exponents:?} {origin} {direction} {places:?}");
                let mut t = -40.0;
                while t < 40.0 {
                    t += 0.37 * (0.05 + dice(&mut seed));
                    let n_before = places.iter().filter(|place| place.t < t).count();
                    let is_near = places.iter().any(|place| (place.t - t).abs() < 1e-9);
                    let is_inside = holds(exponents, origin + t * direction);
                    assert!(is_near || is_inside == (n_before % 2 == 1), "{exponents:?} {origin} {direction} {t}");
                }
            }
        }
    }

    #[test]
    fn an_eighth_of_a_ball_is_gone_through_where_the_ball_is() {
        let direction = DVec3::new(1.0, 0.5, 0.25);
        let origin = DVec3::splat(0.1) - 3.0 * direction;
        let places = through([2.0; 3], origin, direction);
        let (a, b, c) = (direction.length_squared(), origin.dot(direction), origin.length_squared() - 1.0);
        let expected = (-b + (b * b - a * c).sqrt()) / a;
        assert_eq!(places.len(), 2);
        assert!((places[1].t - expected).abs() < 1e-14 && places[1].patch == 0);
        // The last of the three planes.
        let entered = (0..3).map(|i| -origin[i] / direction[i]).fold(f64::MIN, f64::max);
        assert!((places[0].t - entered).abs() < 1e-14);
    }

    /// A line through the hollow of concave sides, in and out twice.
    #[test]
    fn concave_sides_are_gone_through_as_often_as_they_are() {
        let places = through([0.5; 3], DVec3::new(-0.1, 0.85, 0.01), DVec3::new(1.0, -1.0, 0.0));
        assert_eq!(places.len(), 4, "{places:?}");
    }

    #[test]
    fn boxes_are_held_and_missed_as_their_points_are() {
        let mut seed = 5;
        let mut n = [0; 3];
        for exponents in SOME {
            for _ in 0..2000 {
                let mut point = || DVec3::new(dice(&mut seed), dice(&mut seed), dice(&mut seed));
                let (low, sides) = (point() * 1.3 - 0.1, point() * 0.2);
                let within: Vec<bool> = (0..30).map(|_| holds(exponents, low + sides * point())).collect();
                let is_held = holds_box(exponents, low, low + sides);
                let is_missed = misses_box(exponents, low, low + sides);
                assert!(!is_held || within.iter().all(|inside| *inside), "{exponents:?} {low} {sides}");
                assert!(!is_missed || within.iter().all(|inside| !inside), "{exponents:?} {low} {sides}");
                n[usize::from(is_held) + 2 * usize::from(is_missed)] += 1;
            }
        }
        assert!(n.iter().all(|n| *n > 100), "{n:?}");
    }

    /// Nothing that an octant holds is further, and of a convex one something is all but as far.
    #[test]
    fn an_octant_reaches_no_further_than_is_said_and_hardly_less() {
        let mut seed = 9;
        for exponents in SOME {
            for _ in 0..40 {
                let mut point = || DVec3::new(dice(&mut seed), dice(&mut seed), dice(&mut seed));
                let direction = point() * 2.0 - 1.0;
                let (most, _) = reach(exponents, direction);
                let mut furthest = 0.0f64;
                for _ in 0..4000 {
                    // On the curved side, where shares of the powers sum to 1.
                    let shares = point().map(|x| x * x * x);
                    let shares = shares / shares.element_sum();
                    let at = DVec3::from_array(core::array::from_fn(|i| shares[i].powf(1.0 / exponents[i])));
                    // With a place all are inside whose coordinates are less.
                    furthest = furthest.max(direction.max(DVec3::ZERO).dot(at));
                }
                assert!(furthest <= most, "{exponents:?} {direction} {furthest} {most}");
                let is_convex = exponents.iter().all(|exponent| *exponent >= 1.0);
                assert!(!is_convex || most <= furthest + 0.06, "{exponents:?} {direction} {furthest} {most}");
            }
        }
    }

    #[test]
    fn the_core_is_inside_and_normals_are_gradients() {
        for exponents in SOME {
            assert!(holds(exponents, core(exponents)) && core(exponents).min_element() > 0.0, "{exponents:?}");
        }
        let at = DVec3::new(0.6, 0.8, 0.0);
        assert!((normal([2.0; 3], at, 0) - at).length() < 1e-15);
    }
}
