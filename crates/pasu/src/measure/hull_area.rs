//! The area of the convex hull of curves and points.

use core::f64::consts::{PI, TAU};

use glam::DVec2;

use super::outside::{self, hull_of, polygon_area};
use super::touching::{Touching, TouchingWalk};
use crate::numeric::romberg;
use crate::numeric::turn;

/// How often the places where the hull leaves a curve are looked at more closely, and by how much: then they are known to a ten-thousandth of the distance of two points.
const ROUNDS: usize = 5;
const CLOSER: usize = 8;

/// The area and how far it may be off, from `n` points of each curve, half and a quarter of them.
///
/// First it is found where the hull leaves a curve, as from petal to petal. Of the points of what is between two such places the hull lacks a part that goes with `1 / n^2`, and then with `1 / n^4`; of points of the whole curve
/// it would lack besides what depends on how near one of them happens to be to these places.
///
/// Where it leaves them all the time, as from one curve to another in the same place, the area is told by points of whole curves, and the error is larger.
pub(super) fn hull_area(points: &[DVec2], curves: &[&Touching], n: usize) -> (f64, f64) {
    let mut hull = Hull { curves, walks: curves.iter().map(|curve| curve.walk()).collect(), step: TAU / n as f64 };
    let areas = match hull.corners(points, n) {
        Some(corners) => {
            let runs = hull.runs(&corners);
            [1, 2, 4].map(|finer| polygon_area(&hull.polygon(&runs, n / 4, finer)))
        }
        None => [n / 4, n / 2, n].map(|n| {
            let on_curves = curves.iter().flat_map(|curve| curve.points(n));
            polygon_area(&outside::hull(&points.iter().copied().chain(on_curves).collect::<Vec<_>>()))
        }),
    };
    romberg::romberg(areas)
}

/// So many such places there may be, or a quarter as many as points of a curve: petals have two each, and more points.
const FEW: usize = 64;

/// A point, and of which curve at which turn.
#[derive(Clone, Copy)]
struct Place {
    at: DVec2,
    on: Option<(usize, f64)>,
}

/// What the hull has in common with a curve, from one turn to another, or a single point.
enum Run {
    Along { curve: usize, from: f64, to: f64 },
    At(DVec2),
}

struct Hull<'a> {
    curves: &'a [&'a Touching<'a>],
    walks: Vec<TouchingWalk<'a>>,
    step: f64,
}

impl Hull<'_> {
    /// The corners of the hull, close to each other where it leaves a curve; `None` where that is everywhere.
    fn corners(&mut self, points: &[DVec2], n: usize) -> Option<Vec<Place>> {
        let mut places: Vec<Place> = points.iter().map(|at| Place { at: *at, on: None }).collect();
        for (index, curve) in self.curves.iter().enumerate() {
            let place = |(i, at): (usize, DVec2)| Place { at, on: Some((index, i as f64 * self.step)) };
            places.extend(curve.points(n).into_iter().enumerate().map(place));
        }
        let mut corners = corners_of(&places);
        let mut width = self.step;
        for _ in 0..ROUNDS {
            let ends: Vec<(usize, f64)> = sides(&corners)
                .filter(|(one, other)| self.way(one, other).is_none())
                .flat_map(|(one, other)| [one.on, other.on])
                .flatten()
                .collect();
            if ends.len() > FEW.max(n / 4) {
                return None;
            }
            for (curve, from) in ends {
                let about = (1..=CLOSER).flat_map(|k| [k as f64, -(k as f64)]);
                for place in about.map(|k| from + width * k / CLOSER as f64) {
                    let place = if self.curves[curve].is_closed() { turn::within(place) } else { place };
                    if (0.0..=TAU).contains(&place) {
                        corners.push(Place { at: self.walks[curve].point(place), on: Some((curve, place)) });
                    }
                }
            }
            corners = corners_of(&corners);
            width /= CLOSER as f64;
        }
        Some(corners)
    }

    /// By which turn the hull goes along a curve from one corner to the next, if it does: those of one curve that are no further apart than two of the even points.
    fn way(&self, one: &Place, other: &Place) -> Option<f64> {
        let ((curve, from), (same, to)) = (one.on?, other.on?);
        let way = match self.curves[curve].is_closed() {
            true => turn::within(to - from + PI) - PI,
            false => to - from,
        };
        (curve == same && way.abs() <= 1.5 * self.step).then_some(way)
    }

    fn runs(&self, corners: &[Place]) -> Vec<Run> {
        // From where it leaves a curve, if it does.
        let first = sides(corners).position(|(one, other)| self.way(one, other).is_none()).map_or(0, |last| last + 1);
        let mut runs: Vec<Run> = Vec::new();
        let mut is_on = false;
        for (one, other) in sides(corners).cycle().skip(first).take(corners.len()) {
            let way = self.way(one, other);
            match (way, runs.last_mut(), one.on) {
                (Some(way), Some(Run::Along { from, to, .. }), _) if is_on && way * (*to - *from) > 0.0 => *to += way,
                (Some(way), _, Some((curve, from))) => runs.push(Run::Along { curve, from, to: from + way }),
                _ if !is_on => runs.push(Run::At(one.at)),
                _ => {}
            }
            is_on = way.is_some();
        }
        runs
    }

    /// The polygon of points of all runs, of which so many would go round a whole curve, each times so many.
    fn polygon(&mut self, runs: &[Run], n: usize, finer: usize) -> Vec<DVec2> {
        let mut polygon = Vec::new();
        for run in runs {
            match *run {
                Run::At(point) => polygon.push(point),
                Run::Along { curve, from, to } => {
                    let n_steps = finer * (libm::round(n as f64 * (to - from).abs() / TAU) as usize).max(1);
                    for i in 0..=n_steps {
                        let share = i as f64 / n_steps as f64;
                        let place = from * (1.0 - share) + to * share;
                        let place = if self.curves[curve].is_closed() { turn::within(place) } else { place };
                        polygon.push(self.walks[curve].point(place));
                    }
                }
            }
        }
        polygon
    }
}

fn sides(corners: &[Place]) -> impl Iterator<Item = (&Place, &Place)> + Clone {
    corners.iter().zip(corners.iter().cycle().skip(1))
}

/// Those on the convex hull, anticlockwise.
fn corners_of(places: &[Place]) -> Vec<Place> {
    let points: Vec<DVec2> = places.iter().map(|place| place.at).collect();
    hull_of(&points).into_iter().map(|index| places[index]).collect()
}
