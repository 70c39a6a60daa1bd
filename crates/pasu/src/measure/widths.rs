//! The least and the greatest caliper width of a body seen from above, over all directions.
//!
//! The width in a direction is how far the body reaches in it and in the opposite one. Where it reaches to is known for a few directions, and with it two bounds for all directions between two of
//! them: the points that were met are of the body, so that it is no narrower than they are apart; and it lies within the lines that touch it there, which meet in corners. Where the outline is smooth
//! the width is nearly the cubic with the values and slopes at both ends; how nearly, one more direction between tells. Whatever stretch may hold something better than the best width is
//! cut, until there is none or there were too many. What is left that may is the error.

use core::f64::consts::PI;

use glam::DVec2;

use super::quantity::{Quantity, ROUNDING};
use crate::numeric::cubic;

/// Caliper widths of a silhouette, and the directions in which they are measured, in radians from 0 to pi.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Widths {
    pub(crate) least: Quantity,
    pub(crate) greatest: Quantity,
    pub(crate) least_direction: f64,
    pub(crate) greatest_direction: f64,
}

/// How far a body reaches in a direction, and a point where it does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Contact {
    pub(crate) reach: f64,
    pub(crate) point: DVec2,
}

/// The fewest and the most directions to begin with.
const DIRECTIONS: (usize, usize) = (48, 240);

/// Directions for each wave of the highest harmonic.
const FOR_A_WAVE: f64 = 4.0;

/// What is left may be better by this part of the size.
const ENOUGH: f64 = 1e-10;

/// The most directions that are added for either of the two widths.
const ADDED: usize = 320;

/// A cubic that misses a value between its ends may miss others by so many times as much.
const MISSED: f64 = 4.0;

/// Stretches are cut no nearer to their ends than by this part.
const LEAST_PART: f64 = 0.05;

/// The width in one direction.
#[derive(Debug, Clone, Copy)]
struct Knot {
    angle: f64,
    width: f64,
    /// The derivative by the angle.
    slope: f64,
    /// How far the body reaches both ways.
    reaches: [f64; 2],
    /// From where it is met on one side to where on the other.
    across: DVec2,
}

/// The directions between two knots.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    from: Knot,
    to: Knot,
    /// By how much the cubic missed a direction between the ends, or of the stretch that this is a part of; nothing is known at first.
    missed: f64,
}

fn unit(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

impl Knot {
    fn new(angle: f64, contact: &mut impl FnMut(f64) -> Contact) -> Knot {
        let [here, there] = [angle, angle + PI].map(contact);
        let across = here.point - there.point;
        let (width, slope) = (here.reach + there.reach, across.dot(unit(angle).perp()));
        Knot { angle, width, slope, reaches: [here.reach, there.reach], across }
    }

    /// The same half a turn further.
    fn opposite(self) -> Knot {
        let [here, there] = self.reaches;
        Knot { angle: self.angle + PI, reaches: [there, here], across: -self.across, ..self }
    }
}

impl Stretch {
    fn length(&self) -> f64 {
        self.to.angle - self.from.angle
    }

    /// The cubic with the values and slopes at both ends, from 0 to 1.
    fn cubic(&self) -> [f64; 4] {
        let (from, to, length) = (self.from, self.to, self.length());
        cubic::through([from.width, to.width], [from.slope * length, to.slope * length])
    }

    /// The extreme of the cubic: the least for a `sign` of 1, the greatest for -1; with the share of the stretch where it is.
    fn extreme_of_cubic(&self, sign: f64) -> (f64, f64) {
        let cubic = self.cubic();
        let inner = cubic::level(cubic).map(|x| (cubic::at(cubic, x), x));
        let all = inner.chain([(self.from.width, 0.0), (self.to.width, 1.0)]);
        all.min_by(|x, y| (sign * x.0).total_cmp(&(sign * y.0))).unwrap_or((self.from.width, 0.0))
    }

    /// No width of the stretch is less, and the share of the stretch where it would be: either the points of one end or those of the other are at least as far apart as that.
    fn floor(&self) -> (f64, f64) {
        let (from, to) = (self.from, self.to);
        let ends = if from.width <= to.width { (from.width, 0.0) } else { (to.width, 1.0) };
        // Where both pairs of points are equally far apart.
        let apart = (from.across - to.across).perp();
        let apart = if apart.dot(unit(0.5 * (from.angle + to.angle))) < 0.0 { -apart } else { apart };
        let angle = from.angle + libm::atan2(unit(from.angle).perp_dot(apart), unit(from.angle).dot(apart));
        if !(angle > from.angle && angle < to.angle) {
            return ends;
        }
        let width = from.across.dot(unit(angle)).max(to.across.dot(unit(angle)));
        if width < ends.0 { (width, (angle - from.angle) / self.length()) } else { ends }
    }

    /// No width of the stretch is greater: the corners in which the touching lines meet are as far apart.
    fn ceiling(&self) -> (f64, f64) {
        let (from, to) = (self.from, self.to);
        let (s, c) = (libm::sin(self.length()), libm::cos(self.length()));
        let corner = |turn: f64, side: usize| {
            let normal = unit(from.angle) * turn;
            normal * from.reaches[side] + normal.perp() * ((to.reaches[side] - from.reaches[side] * c) / s)
        };
        let across = corner(1.0, 0) - corner(-1.0, 1);
        let turn = libm::atan2(unit(from.angle).perp_dot(across), unit(from.angle).dot(across));
        if turn > 0.0 && turn < self.length() {
            (across.length(), turn / self.length())
        } else if from.width >= to.width {
            (from.width, 0.0)
        } else {
            (to.width, 1.0)
        }
    }

    /// What the best width of the stretch may be, and where.
    fn promise(&self, sign: f64) -> (f64, f64) {
        let outer = if sign > 0.0 { self.floor() } else { self.ceiling() };
        let (cubic, share) = self.extreme_of_cubic(sign);
        let cubic = cubic - sign * MISSED * self.missed;
        if sign * cubic > sign * outer.0 { (cubic, share) } else { outer }
    }
}

/// The least and the greatest width of a body of `size`, of which `contact` tells how far it reaches at an angle, and where; an outline with so many waves.
pub(crate) fn widths(waves: f64, size: f64, mut contact: impl FnMut(f64) -> Contact) -> Widths {
    let n = (FOR_A_WAVE * waves).clamp(DIRECTIONS.0 as f64, DIRECTIONS.1 as f64) as usize;
    let mut knots: Vec<Knot> = (0..n).map(|i| Knot::new(PI * i as f64 / n as f64, &mut contact)).collect();
    knots.extend(knots.first().map(|first| first.opposite()));
    let stretches: Vec<Stretch> =
        knots.windows(2).map(|pair| Stretch { from: pair[0], to: pair[1], missed: f64::INFINITY }).collect();
    let mut extreme = |sign: f64| -> (Quantity, f64) {
        let mut stretches = stretches.clone();
        let knots = stretches.iter().map(|stretch| stretch.from);
        let Some(mut best) = knots.min_by(|x, y| (sign * x.width).total_cmp(&(sign * y.width))) else {
            return (Quantity::default(), 0.0);
        };
        let mut promises: Vec<(f64, f64)> = stretches.iter().map(|stretch| stretch.promise(sign)).collect();
        let mut added = 0;
        loop {
            let first = (0..promises.len()).min_by(|&i, &j| (sign * promises[i].0).total_cmp(&(sign * promises[j].0)));
            let left = first.map_or(0.0, |first| sign * (best.width - promises[first].0));
            let Some(first) = first.filter(|_| left > ENOUGH * size && added < ADDED) else {
                let error = left.max(0.0) + 4.0 * ROUNDING * size;
                let angle = if best.angle >= PI { best.angle - PI } else { best.angle };
                return (Quantity::new(best.width, error), angle);
            };
            added += 1;
            let stretch = stretches[first];
            let share = promises[first].1.clamp(LEAST_PART, 1.0 - LEAST_PART);
            let knot = Knot::new(stretch.from.angle + share * stretch.length(), &mut contact);
            if sign * knot.width < sign * best.width {
                best = knot;
            }
            let missed = (knot.width - cubic::at(stretch.cubic(), share)).abs();
            let halves =
                [Stretch { from: stretch.from, to: knot, missed }, Stretch { from: knot, to: stretch.to, missed }];
            stretches[first] = halves[0];
            promises[first] = halves[0].promise(sign);
            stretches.push(halves[1]);
            promises.push(halves[1].promise(sign));
        }
    };
    let (least, least_direction) = extreme(1.0);
    let (greatest, greatest_direction) = extreme(-1.0);
    Widths { least, greatest, least_direction, greatest_direction }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The contact of a few points.
    fn polygon(corners: Vec<DVec2>) -> impl FnMut(f64) -> Contact {
        move |angle| {
            let far = corners.iter().max_by(|p, q| p.dot(unit(angle)).total_cmp(&q.dot(unit(angle))));
            let point = far.copied().unwrap_or_default();
            Contact { reach: point.dot(unit(angle)), point }
        }
    }

    #[test]
    fn a_box_a_triangle_and_a_disc() {
        let corners = [(-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
        let found = widths(1.0, 2.0, polygon(corners.to_vec()));
        assert!((found.least.value - 2.0).abs() <= found.least.error && found.least.error < 1e-9, "{found:?}");
        assert!((found.greatest.value - libm::hypot(4.0, 2.0)).abs() <= found.greatest.error, "{found:?}");
        assert!((found.least_direction - 0.5 * PI).abs() < 1e-6, "{found:?}");
        let corners: Vec<DVec2> = (0..3).map(|i| unit(0.1 + 2.0 * PI * f64::from(i) / 3.0)).collect();
        let found = widths(1.0, 1.0, polygon(corners));
        assert!((found.least.value - 1.5).abs() <= found.least.error && found.least.error < 1e-9, "{found:?}");
        assert!((found.greatest.value - libm::sqrt(3.0)).abs() <= found.greatest.error, "{found:?}");
        let found = widths(1.0, 3.0, |angle| Contact { reach: 3.0, point: unit(angle) * 3.0 });
        assert!((found.least.value - 6.0).abs() < 1e-12 && (found.greatest.value - 6.0).abs() < 1e-12, "{found:?}");
        assert!(found.least.error < 1e-9 && found.greatest.error < 1e-9, "{found:?}");
    }

    #[test]
    fn the_least_of_many_that_are_nearly_as_narrow() {
        // Eleven tips, of which one is a little short: between its neighbours there is one direction narrower than all others.
        let tip = |i: i32| unit(0.07 + 2.0 * PI * f64::from(i) / 11.0) * if i == 4 { 0.9995 } else { 1.0 };
        let corners: Vec<DVec2> = (0..11).map(tip).collect();
        let mut contact = polygon(corners.clone());
        let found = widths(11.0, 1.0, &mut contact);
        let fine = (0..400_000).map(|i| Knot::new(PI * f64::from(i) / 4e5, &mut contact).width);
        let least = fine.fold(f64::INFINITY, f64::min);
        assert!(found.least.value <= least + 1e-12, "{found:?} {least}");
        assert!(least - found.least.value < 1e-5 && found.least.error < 1e-9, "{found:?} {least}");
    }
}
