//! Planes across the axes of the scene and of both of two parts, and across the way between them: whether one leaves room between them, and whether one part stands on the other there.
//!
//! What stands over something else is apart from it by such a plane. A gap along all of a rim takes more pairs of tiles than two parts are given; how far both reach towards each other takes few.

use glam::DVec3;

use super::budget::Budget;
use super::space::Space;
use crate::numeric::gilbert::gilbert;

/// What it counts for to look along all axes, in pairs of tiles.
const LOOKED: u64 = 12;

/// Axes that are turned by less than this are one.
const ONE_AXIS: f64 = 1e-9;

/// What rounding adds at most to how far a part reaches, as a part of the largest coordinate.
const ROUNDING: f64 = 1e-14;

/// The most steps towards the direction in which there is most room,
const STEPS: usize = 32;

/// what each counts for, in pairs of tiles,
const STEP: u64 = 2;

/// and the part of that room that is enough.
const WELL: f64 = 0.75;

/// Of the places of a part that are as far as it reaches, but for the slack, so many are asked whether they are at the other.
const ASKED: usize = 8;

/// How one part stands on another, or leans on it.
#[derive(Debug, Clone, Copy)]
pub(super) enum Resting {
    /// There is this much room between them at least, more than the slack.
    Apart { least: f64 },
    /// They touch there, and neither goes beyond where the other ends.
    Contact { at: DVec3 },
    /// That place of one is so deep in the other at least.
    Deep { at: DVec3, depth: f64 },
}

impl Space {
    /// How far two parts are apart at least, where a plane across an axis leaves more than the slack between them. `None` also where some other plane does.
    pub(super) fn divided(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<f64> {
        if !budget.take(LOOKED) {
            return None;
        }
        let room_across = |axis: DVec3, budget: &mut Budget| {
            // Corners are places of the borders: of most axes they tell that there is no room.
            self.room_across(other, axis, self.room(other, axis), slack, budget)
        };
        let found = self.axes(other).into_iter().find_map(|axis| room_across(axis, budget));
        // Of two octants their formulas have told that already.
        let are_octants = self.octant().is_some() && other.octant().is_some();
        found.or_else(|| if are_octants { None } else { room_across(self.way(other, slack, budget)?, budget) })
    }

    /// The same across the axes of the scene alone, where boxes round their corners tell without a look at these that there may be room: what stands beside something else.
    pub(super) fn divided_at_once(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<f64> {
        let sides = [(other.corners.low - self.corners.high, 1.0), (self.corners.low - other.corners.high, -1.0)];
        sides.into_iter().find_map(|(rooms, sign)| {
            let axes = rooms.to_array().into_iter().zip(DVec3::AXES);
            let (room, axis) = axes.max_by(|(one, _), (other, _)| one.total_cmp(other))?;
            self.room_across(other, sign * axis, room, slack, budget)
        })
    }

    /// How much room there is between two parts along an axis at least, if that is more than the slack, where their corners leave this.
    fn room_across(&self, other: &Space, axis: DVec3, room: f64, slack: f64, budget: &mut Budget) -> Option<f64> {
        let rounding = ROUNDING * self.bounds.far().max(other.bounds.far());
        let room = room - rounding;
        if !(room > slack) {
            return None;
        }
        let enough = 0.25 * (room - slack);
        let least = -self.reach(axis, enough, budget).0 - other.reach(-axis, enough, budget).0 - rounding;
        (least > slack).then_some(least)
    }

    /// The direction towards another part in which there is most room between the corners of both, about, if there is more than the slack: by [Gilbert's steps](gilbert).
    fn way(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<DVec3> {
        let mut found: Option<(f64, DVec3)> = None;
        gilbert(self.bounds.middle() - other.bounds.middle(), STEPS, |direction, length| {
            if !budget.take(STEP) {
                return None;
            }
            let [(near, p), (far, q)] = [self.furthest_corner(-direction), other.furthest_corner(direction)];
            let room = -near - far;
            if room > slack && found.is_none_or(|(most, _)| room > most) {
                found = Some((room, -direction));
            }
            (room < WELL * length).then_some(p - q)
        });
        found.map(|(_, direction)| direction)
    }

    /// Where two parts come as near as the slack, with a plane across an axis between them that neither passes by more: what stands on something else, or leans on it, along more than pairs of tiles can follow.
    /// Where one passes the plane by which the other ends, a place of it that is deep in the other.
    pub(super) fn resting(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<Resting> {
        if !budget.take(LOOKED) {
            return None;
        }
        let rounding = ROUNDING * self.bounds.far().max(other.bounds.far());
        // Corners are places of the borders: of most axes they tell that one passes the other. Of these the one along which it passes least is asked, for what is deep.
        let rooms: Vec<(f64, DVec3)> =
            self.axes(other).into_iter().map(|axis| (self.room(other, axis) - rounding, axis)).collect();
        let most = rooms.iter().map(|(room, _)| *room).fold(f64::NEG_INFINITY, f64::max);
        rooms.into_iter().filter(|(room, _)| *room >= most.min(-slack)).find_map(|(room, axis)| {
            let enough = 0.125 * slack.max(-room);
            let [(one, at), (another, place)] = [self.reach(axis, enough, budget), other.reach(-axis, enough, budget)];
            let least = -one - another - rounding;
            if least > slack {
                return Some(Resting::Apart { least });
            }
            let furthest = [(self, other, axis, at), (other, self, -axis, place)];
            if !(-least + 2.0 * rounding <= slack) {
                return furthest.into_iter().find_map(|(_, outer, _, at)| {
                    let depth = budget.take(outer.asked_for()).then(|| outer.depth_beyond(at, slack, budget));
                    Some(Resting::Deep { at, depth: depth.flatten()? })
                });
            }
            furthest.into_iter().find_map(|(part, on, axis, at)| {
                let level = at.dot(axis) - slack;
                let corners = part.tiles().all.iter().flat_map(|tile| tile.corners);
                let beside: Vec<DVec3> = corners.filter(|corner| corner.dot(axis) > level).collect();
                let step = beside.len().div_ceil(ASKED).max(1);
                core::iter::once(at).chain(beside.into_iter().step_by(step)).find_map(|at| {
                    if !budget.take(on.asked_for()) {
                        return None;
                    }
                    let nearest = on.nearest_within(at, slack);
                    (nearest.distance <= slack).then_some(Resting::Contact { at: 0.5 * at + 0.5 * nearest.position })
                })
            })
        })
    }

    /// The axes of the scene and of both parts, of both signs, each once.
    fn axes(&self, other: &Space) -> Vec<DVec3> {
        let own = [self, other].map(|space| {
            let matrix = space.placed().matrix();
            [matrix.z_axis, matrix.x_axis, matrix.y_axis]
        });
        let mut axes: Vec<DVec3> = Vec::with_capacity(18);
        for axis in [DVec3::Z, DVec3::X, DVec3::Y].into_iter().chain(own.into_iter().flatten()) {
            let axis = axis.normalize_or_zero();
            if axis != DVec3::ZERO && axes.iter().all(|known| known.cross(axis).length() > ONE_AXIS) {
                axes.extend([axis, -axis]);
            }
        }
        axes
    }

    /// What the corners of both leave between them in a direction; less than 0 where they pass each other.
    fn room(&self, other: &Space, axis: DVec3) -> f64 {
        -self.corners_reach(axis) - other.corners_reach(-axis)
    }

    /// How far the corners of its tiles reach in a direction; all of an octant, which needs no tiles for that.
    pub(super) fn corners_reach(&self, direction: DVec3) -> f64 {
        self.furthest_corner(direction).0
    }

    /// The same, and a corner that is as far.
    fn furthest_corner(&self, direction: DVec3) -> (f64, DVec3) {
        if let Some(reach) = self.reach_by_formula(direction) {
            return reach;
        }
        let corners = self.tiles().all.iter().flat_map(|tile| tile.corners);
        corners.fold((f64::NEG_INFINITY, self.bounds.middle()), |most, corner| {
            let reach = corner.dot(direction);
            if reach > most.0 { (reach, corner) } else { most }
        })
    }
}
