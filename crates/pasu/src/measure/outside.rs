//! What a maker measures on the outside of a pot: height, widths, overhang.

use core::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::moments::element;
use super::quantity::Quantity;
use super::widths::{self, Contact, Widths};
use crate::face::{Face, FaceJet, FaceKind};
use crate::numeric::ascend::ascend;
use crate::numeric::climb::{Place, climb};
use crate::numeric::grid::Grid;
use crate::numeric::limit::limit;
use crate::numeric::trapezoid::round;

/// Faces seen from outside, each sampled on a grid from which searches begin.
pub(crate) struct Outside<'a> {
    faces: Vec<(&'a dyn Face, Grid<FaceJet>)>,
    /// These grids from above.
    plans: Vec<Plan>,
    size: f64,
    /// The highest harmonic.
    highest: f64,
}

/// A grid from above. Thousands of directions are asked of it, and of points without their derivatives many more are in the cache.
struct Plan {
    points: Grid<DVec2>,
    /// The least and the greatest coordinates of each row.
    boxes: Vec<[DVec2; 2]>,
}

impl Plan {
    fn of(grid: &Grid<FaceJet>) -> Plan {
        let points = grid.map(|jet| jet.position.truncate());
        let extent = |row: &[DVec2]| {
            let low = row.iter().fold(DVec2::INFINITY, |low, p| DVec2::new(low.x.min(p.x), low.y.min(p.y)));
            let high = row.iter().fold(DVec2::NEG_INFINITY, |high, p| DVec2::new(high.x.max(p.x), high.y.max(p.y)));
            [low, high]
        };
        let boxes = points.by_rows().map(extent).collect();
        Plan { points, boxes }
    }

    /// No point of a row reaches further in a direction: products and sums that are rounded are in the order of what is rounded.
    fn most(&self, row: usize, direction: DVec2) -> f64 {
        let [low, high] = self.boxes[row];
        let far = |low: f64, high: f64, along: f64| if along > 0.0 { high * along } else { low * along };
        far(low.x, high.x, direction.x) + far(low.y, high.y, direction.y)
    }

    /// How far the points reach in a direction.
    fn reach(&self, direction: DVec2) -> f64 {
        self.points.by_rows().enumerate().fold(f64::MIN, |most, (index, row)| {
            if self.most(index, direction) <= most {
                most
            } else {
                row.iter().map(|p| p.dot(direction)).fold(most, f64::max)
            }
        })
    }
}

/// How far a face may reach beyond the points of its grid, as a part of the size.
const BETWEEN: f64 = 0.01;

/// An extreme of some quantity on a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spot {
    pub(crate) value: f64,
    /// How far the value may be off; 0 where nobody asked.
    pub(crate) error: f64,
    pub(crate) at: DVec3,
    pub(crate) face: FaceKind,
}

/// More faces than any pot has are those of a network: together they are sampled at so many places at most, each along no fewer lines than see the curve of a polynomial.
const FEW_FACES: usize = 16;
const MOST_PLACES: usize = 400_000;
const LEAST_LINES: usize = 5;

/// How far from an end the places are from which a limit is taken.
const BESIDE: f64 = 1e-4;

/// The rounding of a normal's angle, in radians.
const LEAN_ROUNDING: f64 = 1e-12;

/// The most rows and columns of a grid over a wall that had to be thinned.
const MOST_SEAMED: (usize, usize) = (401, 301);

/// Columns of a grid that meets every petal.
pub(crate) fn columns(highest: f64) -> usize {
    (4 * highest.abs().clamp(1.0, 1e4) as usize + 1).max(49)
}

impl<'a> Outside<'a> {
    pub(crate) fn new(faces: impl IntoIterator<Item = &'a dyn Face>, highest: f64) -> Outside<'a> {
        let faces: Vec<&'a dyn Face> = faces.into_iter().collect();
        // Of a network of many patches each is a small part.
        let share = if faces.len() > FEW_FACES { MOST_PLACES / faces.len() } else { usize::MAX };
        let most_rows = (libm::sqrt(share as f64) as usize).max(LEAST_LINES);
        let columns = columns(highest).min((share / most_rows).max(LEAST_LINES));
        let sampled = |face: &'a dyn Face| {
            let rows = match face.kind() {
                FaceKind::Outer | FaceKind::Lining => 49.min(most_rows),
                FaceKind::Rim => 9,
                // Straight from one curve to another.
                _ => 3,
            };
            let mut walk = face.walk();
            (face, Grid::new(rows, columns, |a, v| walk.jet(a, v)))
        };
        let faces: Vec<_> = faces.into_iter().map(sampled).collect();
        let points = faces.iter().flat_map(|(_, grid)| grid.points());
        let size = points.fold(0.0f64, |size, jet| size.max(jet.position.abs().max_element()));
        let plans = faces.iter().map(|(_, grid)| Plan::of(grid)).collect();
        Outside { faces, plans, size, highest }
    }

    /// The greatest extent in a direction, and where.
    fn support(&self, direction: DVec3) -> Option<Spot> {
        let of = |jet: &FaceJet| jet.position.dot(direction);
        self.best(of, |_| true, 3)
    }

    /// The greatest value of a function of the jets over the faces of some kinds; faces whose grids come close are searched.
    fn best(
        &self,
        of: impl Fn(&FaceJet) -> f64,
        is_meant: impl Fn(FaceKind) -> bool,
        most_faces: usize,
    ) -> Option<Spot> {
        let mut starts: Vec<(f64, usize)> = Vec::with_capacity(self.faces.len());
        for (index, (face, grid)) in self.faces.iter().enumerate() {
            if is_meant(face.kind()) {
                let most = grid.points().iter().map(&of).filter(|value| value.is_finite()).fold(f64::MIN, f64::max);
                starts.push((most, index));
            }
        }
        starts.sort_by(|x, y| y.0.total_cmp(&x.0).then(x.1.cmp(&y.1)));
        let mut best: Option<Spot> = None;
        for &(_, index) in starts.iter().take(most_faces) {
            let (face, grid) = &self.faces[index];
            let mut walk = face.walk();
            let Some(Place { a, v, value }) = grid.greatest(&of, |a, v| walk.jet(a, v)) else { continue };
            if best.is_none_or(|best| value > best.value) {
                best = Some(Spot { value, error: 0.0, at: face.jet(a, v).position, face: face.kind() });
            }
        }
        best
    }

    /// Bottom and top.
    pub(crate) fn heights(&self) -> [f64; 2] {
        let [low, high] = [-DVec3::Z, DVec3::Z].map(|up| self.support(up).map_or(0.0, |spot| spot.value));
        [-low, high]
    }

    /// From the lowest to the highest point.
    pub(crate) fn height(&self) -> Quantity {
        let [bottom, top] = self.heights();
        Quantity::rounded(top - bottom, 2.0 * self.size)
    }

    /// Least and greatest caliper width from above.
    pub(crate) fn widths(&self) -> Widths {
        widths::widths(self.highest, self.size, |angle| self.contact(direction(angle)))
    }

    /// How far it reaches in a level direction: from the best points of the grids, climbed.
    fn contact(&self, direction: DVec2) -> Contact {
        let of = |p: &DVec2| p.dot(direction);
        let ends: Vec<f64> = self.plans.iter().map(|plan| plan.reach(direction)).collect();
        let most = ends.iter().copied().fold(f64::MIN, f64::max);
        // What ends far from where another reaches cannot overtake it between the points of its grid; petals that reach about as far are all climbed.
        let near = most - BETWEEN * self.size;
        let mut best = Contact { reach: f64::MIN, point: DVec2::ZERO };
        for (((face, _), plan), _) in self.faces.iter().zip(&self.plans).zip(ends).filter(|(_, end)| *end >= near) {
            let mut walk = face.walk();
            let may_have = |row: usize| !(plan.most(row, direction) <= near);
            let rise = |start: Place, steps: (f64, f64)| {
                let sloped = |jet: FaceJet| [jet.position, jet.da, jet.dv].map(|x| of(&x.truncate()));
                ascend((start.a, start.v), steps, |a, v| {
                    let [value, da, dv] = sloped(walk.jet(a, v));
                    (value, [da, dv])
                })
                .unwrap_or_else(|| climb(start, steps.0, steps.1, |a, v| of(&walk.jet(a, v).position.truncate())))
            };
            for Place { a, v, value } in plan.points.tops(of, near, may_have, rise) {
                if value > best.reach {
                    best = Contact { reach: value, point: walk.jet(a, v).position.truncate() };
                }
            }
        }
        best
    }

    /// The largest angle below the horizontal of the outward normal of faces of some kinds, in radians: how far they overhang.
    pub(crate) fn overhang(&self, is_meant: impl Fn(FaceKind) -> bool) -> Option<Spot> {
        let mut best: Option<Spot> = None;
        for (face, grid) in self.faces.iter().filter(|(face, _)| is_meant(face.kind())) {
            let lean = |jet: &FaceJet| lean(element(*face, jet));
            // An end without a normal somewhere, as at a pole, is kept away from.
            let mut walk = face.walk();
            let is_singular = [0.0, 1.0].map(|a| round(grid.columns()).any(|v| !lean(&walk.jet(a, v)).is_finite()));
            let is_kept_from = |a: f64| is_singular[usize::from(a > 0.5)];
            let mut at = |a: f64, v: f64| walk.jet(if is_kept_from(a) { off_the_end(a) } else { a }, v);
            // A wall that had to be thinned has bumps between its knots.
            let (rows, columns) = match face.seams() {
                Some(seams) => {
                    let [rows, columns] = [seams.along.len(), seams.round.len()].map(|n| 2 * n + 1);
                    (rows.min(MOST_SEAMED.0), columns.min(MOST_SEAMED.1.max(grid.columns() + grid.columns() / 3)))
                }
                None => (grid.rows() - grid.rows() / 4, grid.columns() + grid.columns() / 3),
            };
            let other = Grid::new(rows, columns, &mut at);
            let Some((mut place, mut error)) = grid.greatest_and_error(&other, lean, at) else { continue };
            let end = if place.a > 0.5 { 1.0 } else { 0.0 };
            if is_kept_from(place.a) && (place.a - end).abs() < 1e-2 * BESIDE {
                // The limit at the end itself: by the cubic through four places beside it; a parabola tells how good that is.
                let inward = if end > 0.5 { -BESIDE } else { BESIDE };
                let beside = |steps: f64| lean(&face.jet(end + steps * inward, place.v));
                let (cubic, off) = limit(beside);
                let limit = cubic.min(0.5 * PI);
                if limit >= place.value {
                    error = off + (cubic - limit);
                    place = Place { a: end, value: limit, ..place };
                } else {
                    error += 2.0 * (place.value - beside(1.0)).abs();
                }
            }
            if best.is_none_or(|best| place.value > best.value) {
                let error = error + LEAN_ROUNDING;
                let at = face.jet(place.a, place.v).position;
                best = Some(Spot { value: place.value, error, at, face: face.kind() });
            }
        }
        best
    }

    /// Every lowest point to within a tolerance, and the faces that lie at that level as a whole.
    pub(crate) fn lowest(&self, bottom: f64, tolerance: f64) -> (Vec<DVec3>, Vec<usize>) {
        let (mut points, mut whole) = (Vec::new(), Vec::new());
        for (index, (face, grid)) in self.faces.iter().enumerate() {
            let near = |jet: &FaceJet| jet.position.z <= bottom + tolerance;
            if grid.points().iter().all(near) {
                whole.push(index);
                continue;
            }
            let of = |jet: &FaceJet| -jet.position.z;
            let mut walk = face.walk();
            let rise = |start: Place, steps: (f64, f64)| climb(start, steps.0, steps.1, |a, v| of(&walk.jet(a, v)));
            for Place { a, v, value } in grid.tops(of, -bottom - 0.05 * self.size, |_| true, rise) {
                if -value <= bottom + tolerance {
                    points.push(face.jet(a, v).position);
                }
            }
        }
        (points, whole)
    }

    /// One of the faces.
    pub(crate) fn face(&self, index: usize) -> &'a dyn Face {
        self.faces[index].0
    }

    pub(crate) fn size(&self) -> f64 {
        self.size
    }
}

/// The angle of a normal below the horizontal.
pub(crate) fn lean(normal: DVec3) -> f64 {
    let level = libm::hypot(normal.x, normal.y);
    if level == 0.0 && normal.z == 0.0 { f64::NAN } else { libm::atan2(-normal.z, level) }
}

/// A place so near to the end of a face that what it tells is the limit there, also at a pole.
pub(crate) fn off_the_end(a: f64) -> f64 {
    const NEAR: f64 = 1e-7;
    a.clamp(NEAR, 1.0 - NEAR)
}

/// The unit vector in a direction.
fn direction(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// The convex hull of points, anticlockwise, without points in between.
pub(crate) fn hull(points: &[DVec2]) -> Vec<DVec2> {
    hull_of(points).into_iter().map(|index| points[index]).collect()
}

/// The numbers of the points on the convex hull (A. M. Andrew, 1979).
fn hull_of(points: &[DVec2]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| {
        let (p, q) = (points[i], points[j]);
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(i.cmp(&j))
    });
    order.dedup_by(|i, j| points[*i] == points[*j]);
    if order.len() < 3 {
        return order;
    }
    let mut hull: Vec<usize> = Vec::with_capacity(order.len());
    for is_back in [false, true] {
        let base = hull.len();
        let mut take = |index: usize| {
            while let [.., p, q] = hull[base..] {
                if (points[q] - points[p]).perp_dot(points[index] - points[p]) > 0.0 {
                    break;
                }
                hull.pop();
            }
            hull.push(index);
        };
        if is_back {
            order.iter().rev().for_each(|index| take(*index));
        } else {
            order.iter().for_each(|index| take(*index));
        }
        hull.pop();
    }
    hull
}

/// The least width of a convex polygon: between one of its edges and the corner farthest from that (G. T. Toussaint, *Solving geometric problems with the rotating calipers*, 1983).
pub(crate) fn least_width(hull: &[DVec2]) -> f64 {
    let across = |(&p, &q): (&DVec2, &DVec2)| {
        let along = (q - p).normalize_or_zero();
        hull.iter().map(|corner| along.perp_dot(*corner - p)).fold(0.0, f64::max)
    };
    hull.iter().zip(hull.iter().cycle().skip(1)).map(across).reduce(f64::min).unwrap_or_default()
}

/// The area of a polygon, positive if anticlockwise.
pub(crate) fn polygon_area(polygon: &[DVec2]) -> f64 {
    let Some(&first) = polygon.first() else { return 0.0 };
    polygon.windows(2).map(|edge| 0.5 * (edge[0] - first).perp_dot(edge[1] - first)).sum()
}

/// A direction in degrees, from 0 to 360.
pub(crate) fn degrees(angle: f64) -> f64 {
    let degrees = angle.to_degrees();
    if angle < 0.0 { degrees + 360.0 } else { degrees }
}
