//! The place of the border of a part that is nearest to a point.

use std::collections::BinaryHeap;

use glam::{DVec2, DVec3};

use super::border::Jet;
use super::boxes::Within;
use super::open::Open;
use super::space::{Space, TILE};
use super::tile::Tile;
use crate::watch;

/// The most tiles that are looked at: from the middle of a ball all of its border is as near.
const MOST: usize = 1500;

/// What is found is no further than this part of the size from what is nearest, unless there are too many places as near.
const ENOUGH: f64 = 1e-9;

/// Steps by which a place is brought nearer.
const STEPS: usize = 24;

/// The nearest place that was found, and how far all of the border is at least.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearest {
    pub(super) border: usize,
    pub(super) u: f64,
    pub(super) v: f64,
    pub(super) position: DVec3,
    pub(super) distance: f64,
    /// No place is nearer than this.
    pub(super) least: f64,
    /// How many tiles were looked at for it.
    pub(super) n_looked_at: u64,
}

/// What is still to be looked at.
enum What {
    Node(u32),
    Tile(Box<Tile>),
}

impl Space {
    /// The place of the border that is nearest to a point.
    pub(super) fn nearest(&self, point: DVec3) -> Nearest {
        self.nearest_within(point, 0.0)
    }

    /// The same; a place that is known to be further than `enough` at least, or no further at most, is near enough.
    pub(super) fn nearest_within(&self, point: DVec3, enough: f64) -> Nearest {
        if let Some((still, motion)) = self.still() {
            let nearest = still.nearest_within(motion.point_before(point), enough);
            return Nearest { position: motion.point(nearest.position), ..nearest };
        }
        let mut best = Nearest {
            border: 0,
            u: 0.0,
            v: 0.0,
            position: DVec3::ZERO,
            distance: f64::INFINITY,
            least: 0.0,
            n_looked_at: 0,
        };
        // Of a point in an octant the nearest places of the flat sides are known, and often that the curved one is no nearer.
        let flat = if enough > 0.0 { None } else { self.nearest_flat(point) };
        if let Some(flat) = flat {
            best = Nearest {
                border: flat.border,
                u: f64::NAN,
                v: f64::NAN,
                position: flat.position,
                distance: flat.distance,
                ..best
            };
            if flat.is_nearest {
                return Nearest { least: flat.distance, ..best };
            }
        }
        let tiles = self.tiles();
        let mut open = BinaryHeap::new();
        open.extend(tiles.boxes.root().map(|root| Open { least: 0.0, rank: 0.0, of: What::Node(root) }));
        let mut n_left = MOST;
        while let Some(Open { least, of, .. }) = open.pop() {
            best.least = least.min(best.distance);
            let is_told = enough > 0.0 && (least > enough || best.distance <= enough);
            if least >= best.distance - ENOUGH * self.size() || is_told || n_left == 0 || watch::is_stopped() {
                return best;
            }
            let mut look = |tile: Tile| {
                if flat.is_some() && tile.border > 0 {
                    return;
                }
                best.n_looked_at += 1;
                let least = tile.distance_to(point).max(least);
                if least < best.distance {
                    let [u, v] = tile.middle();
                    let (at, jet) = self.nearer(&tile, DVec2::new(u, v), point);
                    let position = jet.position;
                    let distance = (position - point).length();
                    if distance < best.distance {
                        best = Nearest { border: tile.border, u: at.x, v: at.y, position, distance, ..best };
                    }
                    // Where the distance has one lowest place, all of the tile is as near as what is found at most.
                    let least = least.max(self.least_if_convex(&tile, at, &jet, point));
                    if least < best.distance {
                        open.push(Open { least, rank: 0.0, of: What::Tile(Box::new(tile)) });
                    }
                }
            };
            match of {
                What::Node(node) => match tiles.boxes.within(node) {
                    Within::Thing(tile) => look(tiles.all[tile]),
                    Within::Halves(halves) => open.extend(halves.map(|half| {
                        let away = tiles.boxes.bounds(half).distance_to(point);
                        Open { least: away.max(least), rank: 0.0, of: What::Node(half) }
                    })),
                },
                What::Tile(tile) => {
                    n_left -= 1;
                    watch::work(2 * TILE);
                    match self.halvings.of(&tile, &self.borders) {
                        Some(halves) => halves.into_iter().for_each(look),
                        None => return best,
                    }
                }
            }
        }
        best.least = best.distance;
        best
    }

    /// A place of a tile that is nearer than its middle: by steps to the foot of the perpendicular on the tangent plane, each as long as it brings it nearer.
    fn nearer(&self, tile: &Tile, from: DVec2, point: DVec3) -> (DVec2, Jet) {
        let border = &self.borders[tile.border];
        let ([u0, u1], [v0, v1]) = (tile.cell.u, tile.cell.v);
        let (low, high) = (DVec2::new(u0, v0), DVec2::new(u1, v1));
        let mut at = from;
        let mut jet = border.jet(at.x, at.y);
        for (corner, (u, v)) in tile.corners.into_iter().zip([(u0, v0), (u1, v0), (u0, v1), (u1, v1)]) {
            if (corner - point).length_squared() < (jet.position - point).length_squared() {
                (at, jet) = (DVec2::new(u, v), border.jet(u, v));
            }
        }
        for _ in 0..STEPS {
            let away = point - jet.position;
            let full = jet.towards(away);
            let mut length = 1.0;
            let moved = loop {
                let next = (at + full * length).clamp(low, high);
                if !next.is_finite() || next == at || length < 1e-3 {
                    break None;
                }
                let found = border.jet(next.x, next.y);
                if (found.position - point).length_squared() < away.length_squared() {
                    break Some((next, found));
                }
                length *= 0.25;
            };
            let Some((next, found)) = moved else { break };
            let gained = away.length() - (found.position - point).length();
            (at, jet) = (next, found);
            if gained <= 1e-13 * self.size() {
                break;
            }
        }
        (at, jet)
    }

    /// How far a point is at least from a tile on which the square of the distance is convex in the parameters; 0 where that is not known.
    ///
    /// Its second derivatives are those of the tangents, `X_u^2` and so on, and `(X - p) X_uu`. Where the least stretch of the tangents outdoes what `|X - p|` times the bends may be, it is nowhere below its tangent plane at any place.
    fn least_if_convex(&self, tile: &Tile, at: DVec2, jet: &Jet, point: DVec3) -> f64 {
        let middle = tile.middle_jet(&self.borders);
        let [p, q] = tile.cell.lengths();
        let [along, round] = [middle.du * p, middle.dv * q];
        // The smaller eigenvalue of the matrix of their products, from its trace and determinant.
        let half = 0.5 * (along.length_squared() + round.length_squared());
        let area = along.cross(round).length_squared();
        let larger = half + libm::sqrt((half * half - area).max(0.0));
        let stretch = if larger > 0.0 { libm::sqrt(area / larger) } else { 0.0 };
        let [u, v] = tile.turns();
        let stretch = stretch - libm::sqrt(u * u + v * v);
        let farthest =
            tile.corners.into_iter().map(|corner| (corner - point).length()).fold(0.0, f64::max) + tile.deviation;
        let [uu, uv, vv] = tile.bends;
        if !(stretch > 0.0 && stretch * stretch > farthest * (uu.max(vv) + uv)) {
            return 0.0;
        }
        let away = jet.position - point;
        let ([u0, u1], [v0, v1]) = (tile.cell.u, tile.cell.v);
        let falls = |slope: f64, to_low: f64, to_high: f64| (slope * to_low).min(slope * to_high);
        let least = away.length_squared()
            + 2.0 * (falls(away.dot(jet.du), u0 - at.x, u1 - at.x) + falls(away.dot(jet.dv), v0 - at.y, v1 - at.y));
        libm::sqrt(least.max(0.0)) * (1.0 - 1e-12)
    }
}
