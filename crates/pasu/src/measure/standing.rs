//! What a pot stands on, and how far it can be tilted before it falls.

use core::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::integral::Accuracy;
use super::moments::area;
use super::outside::{Outside, degrees, hull, polygon_area, round};
use super::quantity::Quantity;
use super::search::least;
use crate::solid::Face;

/// Points of a pot that are less than this part of its size above the lowest one stand on the table too.
const STANDING: f64 = 1e-6;

/// Points of an edge of a face on which a pot stands.
const EDGE_POINTS: usize = 1024;

/// Points of the hull that are told.
const TOLD: usize = 128;

/// What a pot stands on.
#[derive(Debug, Clone, PartialEq)]
pub struct Footprint {
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tipping {
    /// The smallest tilt, in degrees, at which the centre of mass is above an edge of the footprint's hull; 0 where it never was above the hull.
    pub degrees: f64,
    /// The direction in which it then falls, in degrees anticlockwise from `x`.
    pub toward: f64,
}

/// Where a pot touches the table.
pub(crate) struct Standing<'a> {
    level: f64,
    points: Vec<DVec2>,
    edges: Vec<(&'a dyn Face, f64)>,
    touching: Vec<&'a dyn Face>,
    columns: usize,
}

impl<'a> Standing<'a> {
    /// Of several bodies on one table.
    pub(crate) fn new(bodies: &[&Outside<'a>], columns: usize) -> Standing<'a> {
        let level = bodies.iter().map(|body| body.heights()[0]).fold(f64::INFINITY, f64::min);
        let size = bodies.iter().fold(0.0f64, |size, body| size.max(body.size()));
        let mut standing = Standing { level, points: Vec::new(), edges: Vec::new(), touching: Vec::new(), columns };
        for body in bodies {
            let (points, whole) = body.lowest(level, STANDING * size);
            standing.points.extend(points.iter().map(|p| p.truncate()));
            for face in whole.into_iter().map(|index| body.face(index)) {
                standing.touching.push(face);
                standing.edges.extend([(face, 0.0), (face, 1.0)]);
            }
        }
        standing
    }

    fn edge(&self, n: usize) -> Vec<DVec2> {
        let mut points = self.points.clone();
        for &(face, a) in &self.edges {
            points.extend(round(n).map(|v| face.jet(a, v).position.truncate()));
        }
        points
    }

    pub(crate) fn footprint(&self, accuracy: &Accuracy) -> Footprint {
        let area = self.touching.iter().fold(Quantity::default(), |sum, face| sum + area(*face, accuracy));
        let n = EDGE_POINTS.max(4 * self.columns);
        let [coarse, middle, fine] = [n / 4, n / 2, n].map(|n| polygon_area(&hull(&self.edge(n))));
        // The hull of points of a smooth curve lacks a part that goes with 1 / n^2, and then with 1 / n^4 (Romberg).
        let [before, after] = [(coarse, middle), (middle, fine)].map(|(a, b)| b + (b - a) / 3.0);
        let hull_area = Quantity::new(after + (after - before) / 15.0, (after - before).abs() + 1e-13 * after);
        let told = hull(&self.edge(TOLD));
        Footprint { level: self.level, area, hull_area, hull: told.iter().map(|p| p.to_array()).collect() }
    }

    /// How far the hull reaches beyond a point in a direction.
    fn reach(&self, from: DVec2, angle: f64) -> f64 {
        let direction = DVec2::new(libm::cos(angle), libm::sin(angle));
        let mut most = self.points.iter().map(|p| (*p - from).dot(direction)).fold(f64::MIN, f64::max);
        for &(face, a) in &self.edges {
            let n = self.columns;
            let at = |v: f64| (face.jet(a, v).position.truncate() - from).dot(direction);
            let far = round(n)
                .map(|v| (v, at(v)))
                .fold((0.0, f64::MIN), |best, here| if here.1 > best.1 { here } else { best });
            let step = TAU / n as f64;
            let (_, refined) = least(far.0 - step, far.0 + step, 1e-9, |v| -at(v));
            most = most.max(far.1).max(-refined);
        }
        most
    }

    /// The tilt about the nearest edge of the hull.
    pub(crate) fn tipping(&self, centre: DVec3) -> Tipping {
        let from = centre.truncate();
        let corners = hull(&self.edge(4 * self.columns));
        let rise = (centre.z - self.level).max(0.0);
        let (mut reach, mut toward) = (f64::INFINITY, 0.0);
        let n = corners.len();
        if n < 3 {
            // A point or an edge holds nothing up.
            let across = corners.get(1).zip(corners.first()).map_or(from, |(p, q)| (*p - *q).perp());
            let away = corners.first().map_or(DVec2::X, |p| from - *p);
            let side = if across.dot(away) < 0.0 { -across } else { across };
            let side = if n == 2 { side } else { away };
            return Tipping { degrees: 0.0, toward: degrees(libm::atan2(side.y, side.x)) };
        }
        for i in 0..n {
            let (p, q) = (corners[i], corners[(i + 1) % n]);
            let edge = q - p;
            let normal = DVec2::new(edge.y, -edge.x) / edge.length();
            let distance = normal.dot(p - from);
            if distance < reach {
                (reach, toward) = (distance, libm::atan2(normal.y, normal.x));
            }
        }
        if !self.edges.is_empty() {
            let step = TAU / self.columns as f64;
            let (angle, refined) = least(toward - step, toward + step, 1e-10, |angle| self.reach(from, angle));
            let here = self.reach(from, toward);
            (reach, toward) = if here <= refined { (here, toward) } else { (refined, angle) };
        }
        let degrees_of = if reach > 0.0 { libm::atan2(reach, rise).to_degrees() } else { 0.0 };
        Tipping { degrees: degrees_of, toward: degrees(toward) }
    }
}
