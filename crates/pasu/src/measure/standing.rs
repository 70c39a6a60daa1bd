//! What a pot stands on, and how far it can be tilted before it falls.

use core::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::accuracy::Accuracy;
use super::hull_area::hull_area;
use super::moments::area;
use super::outside::{Lowest, Outside, degrees, hull};
use super::quantity::Quantity;
use super::touching::Touching;
use crate::answer::answers;
use crate::face::Face;
use crate::numeric::{brent, minima};

/// Points of a pot that are less than this part of its size above the lowest one stand on the table too.
const STANDING: f64 = 1e-6;

/// Points of an edge of a face on which a pot stands.
const EDGE_POINTS: usize = 1024;

/// Points of the hull that are told.
const TOLD: usize = 128;

answers! {
    /// What a pot stands on.
    pub struct Footprint as "Footprint" {
        /// The `z` of the table.
        pub level: f64,
        /// The area that touches the table: 0 where the pot stands on points or edges.
        pub area: Quantity,
        /// The area of the convex hull of what touches.
        pub hull_area: Quantity,
        /// The hull, anticlockwise: all its corners, or a polygon of up to 128 where it is round.
        pub hull: Vec<[f64; 2]>,
    }

    /// How far a pot can be tilted.
    #[derive(Copy)]
    pub struct Tipping as "Tipping" {
        /// The smallest tilt, in degrees, at which the centre of mass is above an edge of the footprint's hull; 0 where it never was above the hull.
        pub degrees: f64,
        /// How far that may be off.
        pub error: f64,
        /// The direction in which it then falls, in degrees anticlockwise from `x`.
        pub toward: f64,
    }
}

/// Where a pot touches the table.
pub(crate) struct Standing<'a> {
    level: f64,
    points: Vec<DVec2>,
    edges: Vec<Edge<'a>>,
    touching: Vec<&'a dyn Face>,
    columns: usize,
    /// The largest coordinate of the bodies.
    size: f64,
}

/// A curve on which a pot stands.
struct Edge<'a> {
    curve: Touching<'a>,
    /// Points at even parts of the way.
    points: Vec<DVec2>,
    /// More of them, with how they change.
    slopes: Option<Vec<[DVec2; 2]>>,
}

impl<'a> Edge<'a> {
    fn new(curve: Touching<'a>, columns: usize) -> Edge<'a> {
        Edge { points: curve.points(columns), curve, slopes: None }
    }

    /// How far it reaches in a direction, if that is further than `most`; else that.
    fn reach(&self, direction: DVec2, most: f64) -> f64 {
        match &self.slopes {
            Some(slopes) => self.reach_by_slopes(slopes, direction, most),
            None => self.reach_by_points(direction, most),
        }
    }

    /// By every stretch on which it first goes further and then less far: no further than where the tangents at both ends of it meet, as long as it does not turn back and forth there.
    fn reach_by_slopes(&self, slopes: &[[DVec2; 2]], direction: DVec2, most: f64) -> f64 {
        let places: Vec<[f64; 2]> = slopes.iter().map(|both| both.map(|each| each.dot(direction))).collect();
        let mut most = places.iter().map(|[reach, _]| *reach).fold(most, f64::max);
        let n = if self.curve.is_closed() { places.len() } else { places.len() - 1 };
        let step = TAU / n as f64;
        let mut walk = self.curve.walk();
        for i in 0..n {
            let ([from, rising], [to, falling]) = (places[i], places[(i + 1) % places.len()]);
            if rising > 0.0 && falling < 0.0 {
                let meeting = from + rising * (to - from - falling * step) / (rising - falling);
                if meeting >= most {
                    let [low, high] = [i, i + 1].map(|k| k as f64 * step);
                    most = most.max(walk.top((low, rising), (high, falling), direction));
                }
            }
        }
        most
    }

    /// By every point that reaches further than both beside it: a parabola that is highest beside the middle of three points rises from there by an eighth of what it falls at most.
    fn reach_by_points(&self, direction: DVec2, most: f64) -> f64 {
        let reaches: Vec<f64> = self.points.iter().map(|p| p.dot(direction)).collect();
        let mut most = reaches.iter().copied().fold(most, f64::max);
        let (n, last) = (reaches.len(), reaches.len() - 1);
        let step = TAU / if self.curve.is_closed() { n } else { last } as f64;
        let mut walk = self.curve.walk();
        for (i, here) in reaches.iter().enumerate() {
            let is_end = !self.curve.is_closed() && (i == 0 || i == last);
            let beside = [(i + last) % n, (i + 1) % n].map(|k| if is_end { *here } else { reaches[k] });
            let gain = (here - beside[0].min(beside[1])) * GAIN;
            if beside.iter().all(|other| other <= here) && here + gain >= most {
                most = most.max(walk.farthest(i as f64 * step, step, direction));
            }
        }
        most
    }
}

/// How closely a single point of contact is found, as a part of the size: the place of a lowest point is known to half of the digits of its height.
const PLACE: f64 = 1e-7;

/// How closely the nearest edge of the hull is found, in radians, and what its distance is off by, as a part of the size.
const NEAREST: f64 = 1e-10;

/// Points that are as near, as a part of the size, are one.
const SAME: f64 = 1e-12;

/// For each column so many places of a curve at which it is known how it changes: petals that touch the hull beside an inflection are seen.
const SLOPES: usize = 4;

/// By which part of what a curve falls to the next of its points it may rise between them.
const GAIN: f64 = 0.25;

/// Edges of the hull that are looked at again: its corners on a round edge are a little off.
const LOOKED_AT: usize = 6;

impl<'a> Standing<'a> {
    /// Of several bodies on one table.
    pub(crate) fn new(bodies: &[&Outside<'a>], columns: usize) -> Standing<'a> {
        let level = bodies.iter().map(|body| body.heights()[0]).fold(f64::INFINITY, f64::min);
        let size = bodies.iter().fold(0.0f64, |size, body| size.max(body.size()));
        let mut standing =
            Standing { level, points: Vec::new(), edges: Vec::new(), touching: Vec::new(), columns, size };
        for body in bodies {
            let Lowest { points, edges, faces } = body.lowest(level, STANDING * size);
            standing.points.extend(points.iter().map(|p| p.truncate()));
            let curves = faces.iter().flat_map(|face| Touching::all(*face)).chain(edges);
            standing.edges.extend(curves.map(|curve| Edge::new(curve, columns)));
            standing.touching.extend(faces);
        }
        standing.leave_out();
        standing
    }

    /// Leaves out curves that are plainly within the hull, and those that are there already, as where two faces meet, which may pass them either way.
    fn leave_out(&mut self) {
        let same = SAME * self.size;
        let all: Vec<DVec2> = self.edges.iter().flat_map(|edge| &edge.points).chain(&self.points).copied().collect();
        let hull = hull(&all);
        let depth = |p: &DVec2| {
            let sides = hull.iter().zip(hull.iter().cycle().skip(1));
            sides.map(|(a, b)| (*b - *a).perp_dot(*p - *a) / a.distance(*b)).fold(f64::INFINITY, f64::min)
        };
        let is_near = |edge: &Edge| {
            let step = edge.points.windows(2).map(|pair| pair[0].distance(pair[1])).fold(same, f64::max);
            hull.len() < 3 || edge.points.iter().any(|p| depth(p) <= step)
        };
        let mut edges: Vec<Edge> = Vec::new();
        for edge in self.edges.drain(..).filter(is_near) {
            // The first point of a closed one is the first the other way round too.
            let first = usize::from(edge.curve.is_closed());
            let back = edge.points[..first].iter().chain(edge.points[first..].iter().rev());
            let is_there = |other: &Edge| {
                let is_same = |(p, q): (&DVec2, &DVec2)| p.distance(*q) <= same;
                other.points.len() == edge.points.len()
                    && other.curve.is_closed() == edge.curve.is_closed()
                    && (other.points.iter().zip(&edge.points).all(is_same)
                        || other.points.iter().zip(back.clone()).all(is_same))
            };
            if !edges.iter().any(is_there) {
                edges.push(edge);
            }
        }
        for edge in &mut edges {
            edge.slopes = edge.curve.slopes(SLOPES * self.columns);
        }
        self.edges = edges;
    }

    fn edge(&self, n: usize) -> Vec<DVec2> {
        let on_edges = self.edges.iter().flat_map(|edge| edge.curve.points(n));
        self.points.iter().copied().chain(on_edges).collect()
    }

    pub(crate) fn footprint(&self, accuracy: &Accuracy) -> Footprint {
        let area_of = |face: &dyn Face| area(face.passed_once().unwrap_or(face), accuracy);
        let area = self.touching.iter().fold(Quantity::default(), |sum, face| sum + area_of(*face));
        let curves: Vec<&Touching> = self.edges.iter().map(|edge| &edge.curve).collect();
        let (area_of_hull, off) = hull_area(&self.points, &curves, EDGE_POINTS.max(4 * self.columns));
        let hull_area = Quantity::new(area_of_hull, off + 1e-13 * area_of_hull);
        let told = hull(&self.edge(TOLD));
        Footprint { level: self.level, area, hull_area, hull: told.iter().map(|p| p.to_array()).collect() }
    }

    /// How far the hull reaches beyond a point in a direction.
    fn reach(&self, from: DVec2, angle: f64) -> f64 {
        self.reach_of_points(from, angle).max(self.reach_of_edges(from, angle))
    }

    fn reach_of_points(&self, from: DVec2, angle: f64) -> f64 {
        let direction = DVec2::new(libm::cos(angle), libm::sin(angle));
        self.points.iter().map(|p| (*p - from).dot(direction)).fold(f64::MIN, f64::max)
    }

    fn reach_of_edges(&self, from: DVec2, angle: f64) -> f64 {
        let direction = DVec2::new(libm::cos(angle), libm::sin(angle));
        self.edges.iter().fold(f64::MIN, |most, edge| edge.reach(direction, most)) - from.dot(direction)
    }

    /// The tilt about the nearest edge of the hull; `error` is that of the coordinates of the centre.
    pub(crate) fn tipping(&self, centre: DVec3, error: f64) -> Tipping {
        let from = centre.truncate();
        let corners = hull(&self.edge(4 * self.columns));
        let rise = (centre.z - self.level).max(0.0);
        let n = corners.len();
        if n < 3 {
            // A point or an edge holds nothing up.
            let across = corners.get(1).zip(corners.first()).map_or(from, |(p, q)| (*p - *q).perp());
            let away = corners.first().map_or(DVec2::X, |p| from - *p);
            let side = if across.dot(away) < 0.0 { -across } else { across };
            let side = if n == 2 { side } else { away };
            return Tipping { degrees: 0.0, error: 0.0, toward: degrees(libm::atan2(side.y, side.x)) };
        }
        let edge = |i: usize| {
            let (p, q) = (corners[i % n], corners[(i + 1) % n]);
            let normal = DVec2::new((q - p).y, -(q - p).x) / (q - p).length();
            (normal.dot(p - from), libm::atan2(normal.y, normal.x))
        };
        let edges: Vec<(f64, f64)> = (0..n).map(edge).collect();
        let reaches: Vec<f64> = edges.iter().map(|edge| edge.0).collect();
        let mut near: Vec<(f64, f64)> = minima::round(&reaches).into_iter().map(|i| edges[i]).collect();
        // Of equal ones, which a regular foot has, that with the smallest angle.
        near.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.total_cmp(&y.1)));
        let (mut reach, mut toward) = near.first().copied().unwrap_or_default();
        if !self.edges.is_empty() {
            reach = f64::INFINITY;
            let step = TAU / self.columns as f64;
            for &(_, start) in near.iter().take(LOOKED_AT) {
                let (angle, refined) =
                    brent::least(start - step, start + step, NEAREST, |angle| self.reach(from, angle));
                for (here, angle) in [(self.reach(from, start), start), (refined, angle)] {
                    if here < reach {
                        (reach, toward) = (here, angle);
                    }
                }
            }
        }
        let tilt = |reach: f64, rise: f64| {
            if reach > 0.0 { libm::atan2(reach, rise.max(0.0)).to_degrees() } else { 0.0 }
        };
        // The centre is off by as much in x and y, and edges by what is left of their search.
        let is_edge = self.reach_of_edges(from, toward) >= self.reach_of_points(from, toward) - NEAREST * self.size;
        let of_place = if is_edge { 0.0 } else { PLACE * self.size };
        let off = core::f64::consts::SQRT_2 * error + of_place + NEAREST * self.size;
        let of_height = error + STANDING_ROUNDING * self.size;
        let here = tilt(reach, rise);
        let ends = [tilt(reach + off, rise - of_height), tilt(reach - off, rise + of_height)];
        let error = ends.iter().fold(0.0f64, |most, end| most.max((end - here).abs())) + ANGLE_ROUNDING;
        Tipping { degrees: here, error, toward: degrees(toward) }
    }
}

/// The rounding of a height as a part of the size, and of an angle in degrees.
const STANDING_ROUNDING: f64 = 1e-13;
const ANGLE_ROUNDING: f64 = 1e-12;
