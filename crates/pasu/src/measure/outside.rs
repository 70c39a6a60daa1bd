//! What a maker measures on the outside of a pot: height, widths, overhang.

use core::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use super::moments::element;
use super::quantity::Quantity;
use super::touching::{self, Touching};
use super::widths::{self, Contact, Widths};
use crate::face::{Face, FaceJet, FaceKind, FaceWalk, Seams};
use crate::numeric::ascend::ascend;
use crate::numeric::climb::{Place, climb};
use crate::numeric::greatest::{Sought, greatest};
use crate::numeric::grid::Grid;
use crate::numeric::limit::limit;
use crate::numeric::trapezoid::round;

/// Faces seen from outside, each sampled on a grid from which searches begin.
pub(crate) struct Outside<'a> {
    faces: Vec<(&'a dyn Face, Grid<FaceJet>)>,
    /// These grids from above.
    plans: Vec<Plan>,
    /// The largest coordinate, whatever its sign.
    size: f64,
    /// From the middle of the box to its corners, wherever it stands.
    extent: f64,
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
        farthest(self.boxes[row], direction)
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

/// How far a box reaches in a direction.
fn farthest([low, high]: [DVec2; 2], direction: DVec2) -> f64 {
    let far = |low: f64, high: f64, along: f64| if along > 0.0 { high * along } else { low * along };
    far(low.x, high.x, direction.x) + far(low.y, high.y, direction.y)
}

/// The largest coordinate of some grids, whatever its sign.
fn largest(faces: &[(&dyn Face, Grid<FaceJet>)]) -> f64 {
    let points = faces.iter().flat_map(|(_, grid)| grid.points());
    points.fold(0.0f64, |size, jet| size.max(jet.position.abs().max_element()))
}

/// Where a body is lowest: single points, curves on its faces, and faces that lie at that level as a whole.
pub(crate) struct Lowest<'a> {
    pub(crate) points: Vec<DVec3>,
    pub(crate) edges: Vec<Touching<'a>>,
    pub(crate) faces: Vec<&'a dyn Face>,
}

/// How far a face may reach beyond the points of its grid, as a part of the extent.
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

/// Normals that turn by less than a quarter of a radian between points do no more there than the points tell: the square of its cosine.
const LITTLE: f64 = 0.94;

/// How far they may sway aside meanwhile, as a part of the square of what they turn.
const SWAY: f64 = 0.125;

/// What of an angle is not sought any more between the points of a grid, as a part of it.
const SMALL: f64 = 1e-6;

/// So many cells of a grid are cut before it is left as it is.
const CUTS: usize = 1_000;

/// The most rows and columns of a grid over a wall that had to be thinned.
const MOST_SEAMED: (usize, usize) = (401, 301);

/// The most places from which heights are sought: more than these are of what is level.
const FOLLOWED: usize = 24;

/// In so many directions faces are held against each other.
const DIRECTIONS: usize = 32;

/// The rows and columns of a grid that meets every bump between the knots of a wall that had to be thinned.
fn seamed(seams: &Seams) -> [usize; 2] {
    [seams.along.len(), seams.round.len()].map(|n| 2 * n + 1)
}

/// Columns of a grid that meets every petal.
pub(crate) fn columns(highest: f64) -> usize {
    (4 * highest.abs().clamp(1.0, 1e4) as usize + 1).max(49)
}

/// Columns of another grid over the same face: an even number, so that one of them is right across, where something symmetric may be at its end between two of an odd number.
pub(crate) fn besides(columns: usize) -> usize {
    (columns + columns / 3).next_multiple_of(2)
}

impl<'a> Outside<'a> {
    pub(crate) fn new(faces: impl IntoIterator<Item = &'a dyn Face>, highest: f64) -> Outside<'a> {
        let faces: Vec<&'a dyn Face> = faces.into_iter().collect();
        // Of a network of many patches each is a small part.
        let share = if faces.len() > FEW_FACES { MOST_PLACES / faces.len() } else { usize::MAX };
        let most_rows = (libm::sqrt(share as f64) as usize).max(LEAST_LINES);
        let columns = columns(highest).min((share / most_rows).max(LEAST_LINES));
        let rows = |face: &dyn Face| match face.kind() {
            FaceKind::Outer | FaceKind::Lining => 49.min(most_rows),
            FaceKind::Rim => 9,
            // Straight from one curve to another.
            _ => 3,
        };
        let sampled = |face: &'a dyn Face, rows: usize, columns: usize| {
            let mut walk = face.walk();
            (face, Grid::new(rows, columns, |a, v| walk.jet(a, v)))
        };
        // What goes to an end and back has that right across, and the corners of a patch are as far out as anything.
        let round = |face: &dyn Face| if face.goes_back(1.5 * PI) { columns.next_multiple_of(2) } else { columns };
        let faces: Vec<_> = faces.into_iter().map(|face| sampled(face, rows(face), round(face))).collect();
        let points = || faces.iter().flat_map(|(_, grid)| grid.points()).map(|jet| jet.position);
        let [low, high] =
            points().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], p| [low.min(p), high.max(p)]);
        let plans = faces.iter().map(|(_, grid)| Plan::of(grid)).collect();
        let extent = 0.5 * (high - low).length();
        let mut outside = Outside { size: largest(&faces), faces, plans, extent, highest };
        // A wall that had to be thinned has bumps between its knots, which matter where it is outermost.
        for (index, rows, columns) in outside.too_coarse() {
            let finer = sampled(outside.faces[index].0, rows, columns);
            (outside.plans[index], outside.faces[index]) = (Plan::of(&finer.1), finer);
        }
        outside
    }

    /// The same, moved; these are the faces of the one that was.
    pub(crate) fn moved<'b>(&self, faces: impl Iterator<Item = &'b dyn Face>, by: DVec3) -> Outside<'b> {
        let moved = |jet: &FaceJet| FaceJet { position: jet.position + by, ..*jet };
        let faces: Vec<_> = faces.zip(&self.faces).map(|(face, (_, grid))| (face, grid.map(moved))).collect();
        let plans = faces.iter().map(|(_, grid)| Plan::of(grid)).collect();
        Outside { size: largest(&faces), faces, plans, extent: self.extent, highest: self.highest }
    }

    /// The faces whose knots are nearer to each other than the points of their grids, of those that reach about as far as any other in some direction; with the rows and columns that see them.
    fn too_coarse(&self) -> Vec<(usize, usize, usize)> {
        let finer = self.faces.iter().enumerate().filter_map(|(index, (face, grid))| {
            let [rows, columns] = seamed(&face.seams()?);
            // Along what is straight, or an arc, nothing is seen that is between few rows.
            let rows =
                if matches!(face.kind(), FaceKind::Outer | FaceKind::Lining) { rows.min(MOST_SEAMED.0) } else { 0 };
            let finer = (index, rows.max(grid.rows()), columns.min(MOST_SEAMED.1).max(grid.columns()));
            (finer.1 > grid.rows() || finer.2 > grid.columns()).then_some(finer)
        });
        let mut finer: Vec<_> = finer.collect();
        if !finer.is_empty() {
            let is_outermost = self.outermost();
            finer.retain(|(index, ..)| is_outermost[*index]);
        }
        finer
    }

    /// Whether each face reaches about as far as any other in some direction.
    fn outermost(&self) -> Vec<bool> {
        let level = (0..DIRECTIONS).map(|i| direction(TAU * i as f64 / DIRECTIONS as f64).extend(0.0));
        let mut found = vec![false; self.faces.len()];
        for direction in level.chain([DVec3::Z, -DVec3::Z]) {
            let reach = |grid: &Grid<FaceJet>| {
                grid.points().iter().map(|jet| jet.position.dot(direction)).fold(f64::MIN, f64::max)
            };
            let reaches: Vec<f64> = self.faces.iter().map(|(_, grid)| reach(grid)).collect();
            let near = reaches.iter().copied().fold(f64::MIN, f64::max) - BETWEEN * self.extent;
            found.iter_mut().zip(reaches).for_each(|(found, reach)| *found |= reach >= near);
        }
        found
    }

    /// How far it reaches in a direction: from the best places of the grids, climbed.
    fn reach(&self, direction: DVec3) -> f64 {
        let of = |jet: &FaceJet| jet.position.dot(direction);
        let end =
            |grid: &Grid<FaceJet>| grid.points().iter().map(of).filter(|x| x.is_finite()).fold(f64::MIN, f64::max);
        let ends: Vec<f64> = self.faces.iter().map(|(_, grid)| end(grid)).collect();
        let most = ends.iter().copied().fold(f64::MIN, f64::max);
        let near = most - BETWEEN * self.extent;
        let mut tops: Vec<(&dyn Face, &Grid<FaceJet>, Place)> = Vec::new();
        for ((face, grid), _) in self.faces.iter().zip(&ends).filter(|(_, end)| **end >= near) {
            let found = tops_of(*face, grid, direction, near, |_| true);
            tops.extend(found.into_iter().map(|top| (*face, grid, top)));
        }
        tops.sort_by(|(.., x), (.., y)| y.value.total_cmp(&x.value));
        tops.iter().take(FOLLOWED).fold(most, |best, (face, grid, top)| {
            let (mut walk, (step_a, step_v)) = (face.walk(), grid.steps());
            let here = walk.jet(top.a, top.v);
            // A hill is nowhere above its slopes: of what is level one place is enough.
            let gain = (here.da.dot(direction) * step_a).abs() + (here.dv.dot(direction) * step_v).abs();
            if of(&here) + gain <= best {
                return best;
            }
            // Step by step: networks have edges all over.
            let start = Place { value: of(&here), ..*top };
            best.max(climb(start, step_a, step_v, |a, v| of(&walk.jet(a, v))).value)
        })
    }

    /// Bottom and top.
    pub(crate) fn heights(&self) -> [f64; 2] {
        let [low, high] = [-DVec3::Z, DVec3::Z].map(|up| if self.faces.is_empty() { 0.0 } else { self.reach(up) });
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

    /// Least and greatest caliper width of all of them together.
    pub(crate) fn widths_of(all: &[Outside]) -> Widths {
        let [highest, size] = all
            .iter()
            .fold([0.0f64; 2], |[highest, size], outside| [highest.max(outside.highest.abs()), size.max(outside.size)]);
        let boxes: Vec<[DVec2; 2]> = all.iter().map(Outside::plan_box).collect();
        widths::widths(highest, size, |angle| {
            let direction = direction(angle);
            // Whatever is between the points of a grid does not reach much further than its box does.
            let most = |(outside, ends): (&Outside, &[DVec2; 2])| farthest(*ends, direction) + BETWEEN * outside.extent;
            let mut order: Vec<(f64, usize)> = all.iter().zip(&boxes).map(most).zip(0..).collect();
            order.sort_by(|x, y| y.0.total_cmp(&x.0));
            let mut best = Contact { reach: f64::MIN, point: DVec2::ZERO };
            for (most, index) in order {
                if most < best.reach {
                    break;
                }
                let here = all[index].contact(direction);
                if here.reach > best.reach {
                    best = here;
                }
            }
            best
        })
    }

    /// The box round the points of its grids from above.
    fn plan_box(&self) -> [DVec2; 2] {
        let boxes = self.plans.iter().flat_map(|plan| &plan.boxes);
        boxes.fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], own| [low.min(own[0]), high.max(own[1])])
    }

    /// How far it reaches in a level direction: from the best points of the grids, climbed.
    fn contact(&self, direction: DVec2) -> Contact {
        let of = |p: &DVec2| p.dot(direction);
        let ends: Vec<f64> = self.plans.iter().map(|plan| plan.reach(direction)).collect();
        let most = ends.iter().copied().fold(f64::MIN, f64::max);
        // What ends far from where another reaches cannot overtake it between the points of its grid; petals that reach about as far are all climbed.
        let near = most - BETWEEN * self.extent;
        let mut best = Contact { reach: f64::MIN, point: DVec2::ZERO };
        for (((face, grid), plan), _) in self.faces.iter().zip(&self.plans).zip(ends).filter(|(_, end)| *end >= near) {
            let mut walk = face.walk();
            let may_have = |row: usize| !(plan.most(row, direction) <= near);
            let outwards = direction.extend(0.0);
            for top in tops_of(*face, grid, outwards, near, may_have) {
                let Place { a, v, value } = follow(*face, &mut *walk, outwards, &top, grid.steps());
                if value > best.reach {
                    best = Contact { reach: value, point: walk.jet(a, v).position.truncate() };
                }
            }
        }
        // At a corner the points of the grids may be further out than what is climbed to.
        if best.reach < most {
            let all = self.plans.iter().flat_map(|plan| plan.points.points());
            best = all.map(|p| Contact { reach: of(p), point: *p }).find(|here| here.reach == most).unwrap_or(best);
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
            let other = match face.seams() {
                Some(seams) => {
                    let [rows, columns] = seamed(&seams);
                    let columns = columns.min(MOST_SEAMED.1.max(besides(grid.columns())));
                    Grid::new(rows.min(MOST_SEAMED.0), columns, &mut at)
                }
                None => Grid::graded(grid.rows(), besides(grid.columns()), &mut at),
            };
            let more = |corners: [&FaceJet; 4]| turning(corners.map(|jet| element(*face, jet)));
            let sought = Sought { of: lean, more, most: 0.5 * PI, small: SMALL, cuts: CUTS };
            let Some((mut place, mut error)) = greatest([grid, &other], &sought, at) else { continue };
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

    /// Where it is lowest, to within a tolerance.
    pub(crate) fn lowest(&self, bottom: f64, tolerance: f64) -> Lowest<'a> {
        let mut lowest = Lowest { points: Vec::new(), edges: Vec::new(), faces: Vec::new() };
        let level = bottom + tolerance;
        for (face, grid) in &self.faces {
            if grid.points().iter().all(|jet| jet.position.z <= level) {
                lowest.faces.push(*face);
                continue;
            }
            let of = |jet: &FaceJet| -jet.position.z;
            let near = -bottom - 0.05 * self.extent;
            if grid.points().iter().map(of).fold(f64::MIN, f64::max) < near {
                continue;
            }
            let point = 1e-9 * self.size;
            let edges = touching::level_ends(*face, grid, level, point);
            let is_edge = |a: f64| edges.iter().any(|edge| edge.is_end(a));
            let (mut walk, (step_a, step_v)) = (face.walk(), grid.steps());
            if edges.is_empty()
                && let Some(crest) = touching::level_crest(*face, grid, level, -near, point)
            {
                lowest.edges.push(crest);
                continue;
            }
            for start in grid.tops(of, near, |_| true).into_iter().filter(|start| !is_edge(start.a)) {
                let Place { a, v, value } = climb(start, step_a, step_v, |a, v| of(&walk.jet(a, v)));
                if -value > level {
                    continue;
                }
                match touching::level_ridge(*face, v, level) {
                    Some(ridge) => lowest.edges.push(ridge),
                    None => lowest.points.push(face.jet(a, v).position),
                }
            }
            lowest.edges.extend(edges);
        }
        lowest
    }

    pub(crate) fn size(&self) -> f64 {
        self.size
    }
}

/// The places of a face about which it reaches furthest in a direction, and beyond `near`.
fn tops_of(
    face: &dyn Face,
    grid: &Grid<FaceJet>,
    direction: DVec3,
    near: f64,
    may_have: impl Fn(usize) -> bool,
) -> Vec<Place> {
    // What goes to an end and back has corners there, and no petals.
    if face.goes_back(1.5 * PI) {
        return grid.tops(|jet| jet.position.dot(direction), near, may_have);
    }
    grid.crests(|jet| [jet.position, jet.dv].map(|x| x.dot(direction)), near, may_have)
}

/// From a place of a face to the nearest that reaches furthest in a direction.
fn follow(face: &dyn Face, walk: &mut dyn FaceWalk, direction: DVec3, from: &Place, steps: (f64, f64)) -> Place {
    let ascended = ascend((from.a, from.v), steps, |a, v| {
        let jet = walk.jet(a, v);
        let dv = jet.dv.dot(direction);
        (jet.position.dot(direction), [jet.da.dot(direction), if face.goes_back(v) { -dv } else { dv }])
    });
    ascended.unwrap_or_else(|| {
        let mut at = |a: f64, v: f64| walk.jet(a, v).position.dot(direction);
        climb(Place { value: at(from.a, from.v), ..*from }, steps.0, steps.1, at)
    })
}

/// How much further than at the corners of a cell its normals may lean between them, along `a` and round `v`.
fn turning([one, two, three, four]: [DVec3; 4]) -> [f64; 2] {
    [beyond(one, three).max(beyond(two, four)), beyond(one, two).max(beyond(three, four))]
}

/// How much further than either of two normals one between them may lean that is turned from the one to the other.
fn beyond(one: DVec3, other: DVec3) -> f64 {
    let dot = one.dot(other);
    if dot > 0.0 && dot * dot > LITTLE * (one.length_squared() * other.length_squared()) {
        return 0.0;
    }
    let (Some(one), Some(other)) = (one.try_normalize(), other.try_normalize()) else { return 0.0 };
    let (across, along) = (one.cross(other).length(), one.dot(other));
    let turn = libm::atan2(across, along);
    // How far down a unit vector points that is turned by an angle x: first cos(x) + second sin(x).
    let (first, second) = (-one.z, -(other.z - one.z * along) / across);
    let furthest = libm::atan2(second, first);
    let straight = if furthest > 0.0 && furthest < turn {
        libm::asin(libm::hypot(first, second).min(1.0)) - lean(one).max(lean(other))
    } else {
        0.0
    };
    straight + SWAY * turn * turn
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
pub(super) fn hull_of(points: &[DVec2]) -> Vec<usize> {
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
