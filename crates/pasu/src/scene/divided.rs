//! Planes across the axes of the scene and of both of two parts: whether one leaves room between them, and what goes through all of them.
//!
//! What stands over something else is apart from it by such a plane. A gap along all of a rim takes more pairs of tiles than two parts are given; how far both reach towards each other takes few.

use glam::DVec3;

use super::budget::Budget;
use super::space::Space;

/// What it counts for to look along all axes, in pairs of tiles.
const LOOKED: u64 = 12;

/// Axes that are turned by less than this are one.
const ONE_AXIS: f64 = 1e-9;

/// What rounding adds at most to how far a part reaches, as a part of the largest coordinate.
const ROUNDING: f64 = 1e-14;

/// Of the places of a part that go furthest beyond where the other begins so many are asked, and as many of all that do.
const ASKED: usize = 8;

impl Space {
    /// How far two parts are apart at least, where a plane across an axis leaves more than the slack between them. `None` also where some other plane does.
    pub(super) fn divided(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<f64> {
        if !budget.take(LOOKED) {
            return None;
        }
        let rounding = ROUNDING * self.far().max(other.far());
        self.axes(other).into_iter().find_map(|axis| {
            // Corners are places of the borders: of most axes they tell that there is no room.
            let room = self.room(other, axis) - rounding;
            if !(room > slack) {
                return None;
            }
            let enough = 0.25 * (room - slack);
            let mut most = |space: &Space, axis: DVec3| {
                space.reach_by_formula(axis).unwrap_or_else(|| space.reach(axis, enough, budget))
            };
            let least = -most(self, axis) - most(other, -axis) - rounding;
            (least > slack).then_some(least)
        })
    }

    /// A place of one of two parts that is deep in the other, and how deep at least: of those that go beyond where the other begins, along the axis along which the parts are nearest to being divided.
    pub(super) fn pressed(&self, other: &Space, slack: f64, budget: &mut Budget) -> Option<(DVec3, f64)> {
        if !budget.take(LOOKED) {
            return None;
        }
        let rooms = self.axes(other).into_iter().map(|axis| (self.room(other, axis), axis));
        let (_, axis) = rooms.max_by(|(one, _), (another, _)| one.total_cmp(another))?;
        [(self, other, axis), (other, self, -axis)].into_iter().find_map(|(part, outer, axis)| {
            let begins = -outer.corners_reach(-axis) + slack;
            let corners = part.tiles().all.iter().flat_map(|tile| tile.corners);
            let mut beyond: Vec<(f64, DVec3)> = corners.map(|at| (at.dot(axis) - begins, at)).collect();
            beyond.retain(|(by, _)| *by > 0.0);
            beyond.sort_by(|(one, _), (another, _)| another.total_cmp(one));
            let step = beyond.len().div_ceil(ASKED).max(1);
            let asked = beyond.iter().take(ASKED).chain(beyond.iter().skip(ASKED).step_by(step));
            asked.map(|(_, at)| *at).find_map(|at| {
                let is_asked = budget.take(outer.asked_for());
                Some((at, outer.depth_beyond(at, slack, budget).filter(|_| is_asked)?))
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

    /// How far the corners of its tiles reach in a direction.
    pub(super) fn corners_reach(&self, direction: DVec3) -> f64 {
        let corners = self.tiles().all.iter().flat_map(|tile| tile.corners);
        corners.map(|corner| corner.dot(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest coordinate.
    fn far(&self) -> f64 {
        self.bounds.low.abs().max(self.bounds.high.abs()).max_element()
    }
}
