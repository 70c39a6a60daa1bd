//! Where a ray goes through the border of a part.
//!
//! Tiles that the ray may meet are halved until the map from the tile to the plane across the ray is one to one on each: by how far its derivatives are from those of the middle at most, which the suprema of the patch bound. Then Newton's
//! method finds the one place where it goes through, or that there is none. So no crossing is missed, however fine the border, but where it is all but along the ray.

use core::ops::ControlFlow;

use glam::{DMat2, DVec2, DVec3};

use super::space::{Space, TILE};
use super::tile::Tile;
use crate::watch;

/// The most tiles that one ray is held against in one part. A ray that goes along a border may meet any number of them.
const MOST: usize = 40_000;

/// What is nearer to the ray than this part of the largest number of the scene is on it.
const ON_RAY: f64 = 4e-15;

/// A tile of no more than this part of the size is a point: a pole, or a tip.
const POINT: f64 = 1e-10;

/// A ray that meets the border at an angle of less than this, in a tile that is flat to rounding, touches it and does not go through.
const TOUCHING: f64 = 1e-5;

/// A crossing this near to an edge of the border, in parameters, may be missed, or found twice.
const EDGE: f64 = 1e-7;

/// Places on the ray that are nearer than this part of the size are one.
pub(super) const SAME: f64 = 1e-9;

/// A tile on which derivatives are no further from those of the middle than this part of the least that these make of a vector is mapped one to one: and each step of Newton's method, whose derivatives are then no less than 3/4
/// and no further off than 1/2 of those, leaves at most 2/3 of the way.
const ONE_TO_ONE: f64 = 0.25;

/// Steps of Newton's method: the digits double from some step on.
const STEPS: usize = 60;

/// A place where the ray goes through a border.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing {
    pub(super) border: usize,
    pub(super) u: f64,
    pub(super) v: f64,
    /// How far along the ray.
    pub(super) t: f64,
    pub(super) position: DVec3,
    /// Whether the ray leaves the body there.
    pub(super) is_out: bool,
}

/// All that a ray meets of one part, in the order of the distance.
#[derive(Debug, Default)]
pub(super) struct Crossings {
    pub(super) found: Vec<Crossing>,
    /// Whether each is told for certain: none is at an edge or a tip, and the border is nowhere along the ray.
    pub(super) is_clear: bool,
    /// Whether there were too many tiles, so that some places may not be told.
    pub(super) is_cut: bool,
    /// How many tiles the ray was held against.
    pub(super) n_tiles: u64,
}

struct Ray<'a> {
    space: &'a Space,
    origin: DVec3,
    direction: DVec3,
    /// Two axes across it.
    across: [DVec3; 2],
    size: f64,
    n_left: usize,
    crossings: Crossings,
}

impl Space {
    /// The crossings of the ray from a point in a direction of length 1.
    pub(super) fn crossings(&self, origin: DVec3, direction: DVec3) -> Crossings {
        let mut crossings = match self.octant() {
            Some(_) => self.octant_crossings(origin, direction),
            None => self.moved_crossings(origin, direction),
        };
        crossings.found.sort_by(|one, other| one.t.total_cmp(&other.t));
        // A seam belongs to the tiles on both sides, an edge to both borders.
        let same = SAME * self.size();
        crossings.found.dedup_by(|next, kept| next.t - kept.t <= same && next.is_out == kept.is_out);
        crossings
    }

    fn octant_crossings(&self, origin: DVec3, direction: DVec3) -> Crossings {
        let (own, own_direction) = (self.own(origin), self.own_direction(direction));
        let Some(octant) = self.octant() else { return Crossings::default() };
        let through = octant.through(own, own_direction);
        let found =
            through.iter().enumerate().filter(|(_, through)| through.t >= 0.0).map(|(index, through)| Crossing {
                border: through.patch,
                u: f64::NAN,
                v: f64::NAN,
                t: through.t,
                position: origin + through.t * direction,
                is_out: index % 2 == 1,
            });
        Crossings { found: found.collect(), is_clear: true, is_cut: false, n_tiles: 0 }
    }

    /// The crossings of what is turned and moved, by those of what it is before.
    fn moved_crossings(&self, origin: DVec3, direction: DVec3) -> Crossings {
        let largest = self.bounds.far().max(origin.abs().max_element());
        let Some((still, motion)) = self.still() else { return self.tile_crossings(origin, direction, largest) };
        let (from, along) = (motion.point_before(origin), motion.vector_before(direction));
        let mut crossings = still.tile_crossings(from, along, largest);
        crossings.found.iter_mut().for_each(|crossing| crossing.position = motion.point(crossing.position));
        crossings
    }

    /// What is nearer to the ray than rounding of `largest` is on it.
    fn tile_crossings(&self, origin: DVec3, direction: DVec3, largest: f64) -> Crossings {
        let (one, other) = direction.any_orthonormal_pair();
        let tiles = self.tiles();
        let mut ray = Ray {
            space: self,
            origin,
            direction,
            across: [one, other],
            size: self.size(),
            n_left: MOST,
            crossings: Crossings { found: Vec::new(), is_clear: true, is_cut: false, n_tiles: 0 },
        };
        let (inverse, on_ray) = (direction.recip(), ON_RAY * largest);
        let mut is_over = false;
        tiles.boxes.each(
            |bounds| bounds.is_met(origin, inverse),
            |tile| is_over = is_over || ray.meet(&tiles.all[tile], on_ray).is_break(),
        );
        if is_over {
            (ray.crossings.is_clear, ray.crossings.is_cut) = (false, true);
        }
        ray.crossings.n_tiles = (MOST - ray.n_left) as u64;
        ray.crossings
    }
}

impl Ray<'_> {
    fn project(&self, vector: DVec3) -> DVec2 {
        DVec2::new(self.across[0].dot(vector), self.across[1].dot(vector))
    }

    fn meet(&mut self, tile: &Tile, on_ray: f64) -> ControlFlow<()> {
        let mut open = vec![*tile];
        while let Some(tile) = open.pop() {
            if self.n_left == 0 || watch::is_stopped() {
                return ControlFlow::Break(());
            }
            self.n_left -= 1;
            watch::work(TILE);
            let corners = tile.corners.map(|corner| self.project(corner - self.origin));
            if distance_to_origin(&corners) > tile.deviation + on_ray || self.is_behind(&tile) {
                continue;
            }
            let jet = tile.middle_jet(&self.space.borders);
            let [p, q] = tile.cell.lengths();
            let [along, round] = [jet.du * p, jet.dv * q];
            let matrix = DMat2::from_cols(self.project(along), self.project(round));
            let [u, v] = tile.turns();
            let turn = libm::sqrt(u * u + v * v);
            if turn <= ONE_TO_ONE * least_stretch(&matrix) {
                self.newton(&tile, matrix, on_ray);
                continue;
            }
            let size = tile.size();
            if size <= POINT * self.size {
                self.crossings.is_clear = false;
                let [u, v] = tile.middle();
                self.push(&tile, u, v);
                continue;
            }
            // Flat to rounding, and along the ray: it is touched.
            let normal = along.cross(round);
            let slope = normal.dot(self.direction).abs();
            if tile.deviation <= 4.0 * on_ray && slope <= TOUCHING * normal.length() {
                self.crossings.is_clear = false;
                continue;
            }
            match self.space.halvings.of(&tile, &self.space.borders) {
                Some(halves) => open.extend(halves),
                None => self.crossings.is_clear = false,
            }
        }
        ControlFlow::Continue(())
    }

    fn is_behind(&self, tile: &Tile) -> bool {
        let most = tile.corners.map(|corner| (corner - self.origin).dot(self.direction));
        most.into_iter().fold(f64::NEG_INFINITY, f64::max) + tile.deviation < 0.0
    }

    /// The one place of a tile that is on the ray, if it has one: steps are kept within the tile, which brings them no further from it.
    fn newton(&mut self, tile: &Tile, matrix: DMat2, on_ray: f64) {
        let ([u0, u1], [v0, v1]) = (tile.cell.u, tile.cell.v);
        let border = &self.space.borders[tile.border];
        let miss = |at: DVec2| {
            let jet = border.jet(u0 + (u1 - u0) * at.x, v0 + (v1 - v0) * at.y);
            let matrix = DMat2::from_cols(self.project(jet.du * (u1 - u0)), self.project(jet.dv * (v1 - v0)));
            (self.project(jet.position - self.origin), matrix)
        };
        let mut inverse = matrix.inverse();
        let mut at = DVec2::splat(0.5);
        let (mut left, _) = miss(at);
        // Further from the middle than half as far again as the corners: what is one to one has no root there.
        if (inverse * left).length() > 1.5 * core::f64::consts::FRAC_1_SQRT_2 {
            return;
        }
        for _ in 0..STEPS {
            let next = (at - inverse * left).clamp(DVec2::ZERO, DVec2::ONE);
            if next == at || !next.is_finite() {
                break;
            }
            let (found, matrix) = miss(next);
            let is_rounding = (next - at).length() < 1e-13 && found.length() >= left.length();
            if is_rounding {
                break;
            }
            (at, left) = (next, found);
            if matrix.determinant() != 0.0 {
                inverse = matrix.inverse();
            }
        }
        // What is left of the way, in the plane across: within rounding, or the root is in a neighbour.
        if left.length() > 16.0 * on_ray + 1e-12 * self.size {
            return;
        }
        self.push(tile, u0 + (u1 - u0) * at.x, v0 + (v1 - v0) * at.y);
    }

    fn push(&mut self, tile: &Tile, u: f64, v: f64) {
        let border = &self.space.borders[tile.border];
        let position = border.jet(u, v).position;
        let t = (position - self.origin).dot(self.direction);
        if t < 0.0 {
            return;
        }
        let is_edge = |x: f64| !(EDGE..=1.0 - EDGE).contains(&x);
        if is_edge(u) || is_edge(v) {
            self.crossings.is_clear = false;
        }
        let is_out = border.normal(u, v).dot(self.direction) > 0.0;
        self.crossings.found.push(Crossing { border: tile.border, u, v, t, position, is_out });
    }
}

/// The least length that a matrix makes of a unit vector: its smaller singular value.
fn least_stretch(matrix: &DMat2) -> f64 {
    let [a, b, c, d] = matrix.to_cols_array();
    let (sum, difference) = (libm::hypot(a + d, b - c), libm::hypot(a - d, b + c));
    0.5 * (sum - difference).abs()
}

/// How far the origin of the plane is from the hull of four points.
fn distance_to_origin(points: &[DVec2; 4]) -> f64 {
    const TRIANGLES: [[usize; 3]; 4] = [[0, 1, 2], [1, 2, 3], [0, 1, 3], [0, 2, 3]];
    const SIDES: [[usize; 2]; 6] = [[0, 1], [2, 3], [0, 2], [1, 3], [0, 3], [1, 2]];
    let turn = |i: usize, j: usize| points[i].perp_dot(points[j]);
    let is_in = |[i, j, k]: [usize; 3]| {
        let turns = [turn(i, j), turn(j, k), turn(k, i)];
        turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
    };
    // A triangle without area is as good as its sides.
    let has_area = |[i, j, k]: [usize; 3]| (points[j] - points[i]).perp_dot(points[k] - points[i]) != 0.0;
    if TRIANGLES.into_iter().any(|triangle| has_area(triangle) && is_in(triangle)) {
        return 0.0;
    }
    let to_side = |[i, j]: [usize; 2]| {
        let (from, along) = (points[i], points[j] - points[i]);
        let square = along.length_squared();
        let share = if square > 0.0 { (-from.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        (from + along * share).length()
    };
    SIDES.into_iter().map(to_side).fold(f64::INFINITY, f64::min)
}
