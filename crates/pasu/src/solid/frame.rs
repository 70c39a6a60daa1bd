//! The axis on which a pot stands, with levels and a plan.

use glam::{DVec2, DVec3};

/// Coordinates along and across the pot's own axis, which is the placed local z axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    origin: DVec3,
    axis: DVec3,
    across: [DVec3; 2],
}

impl Frame {
    /// The frame along a unit vector, with level 0 at the origin.
    pub(crate) fn new(origin: DVec3, axis: DVec3) -> Frame {
        let (x, y) = axis.any_orthonormal_pair();
        Frame { origin, axis, across: [x, y] }
    }

    /// The unit vector from foot to rim, roughly.
    pub(crate) fn axis(&self) -> DVec3 {
        self.axis
    }

    /// The height of a point above the origin.
    pub(crate) fn level(&self, point: DVec3) -> f64 {
        self.axis.dot(point - self.origin)
    }

    /// Where a point is seen from above.
    pub(crate) fn plan(&self, point: DVec3) -> DVec2 {
        self.turned(point - self.origin)
    }

    /// As [`Self::plan`], of a direction.
    pub(crate) fn turned(&self, direction: DVec3) -> DVec2 {
        DVec2::new(self.across[0].dot(direction), self.across[1].dot(direction))
    }

    /// The point at a place of the plan and a level.
    pub(crate) fn point(&self, plan: DVec2, level: f64) -> DVec3 {
        self.origin + self.lifted(plan) + self.axis * level
    }

    /// A direction of the plan in space.
    pub(crate) fn lifted(&self, plan: DVec2) -> DVec3 {
        self.across[0] * plan.x + self.across[1] * plan.y
    }

    /// A direction without its part along the axis.
    pub(crate) fn flattened(&self, direction: DVec3) -> DVec3 {
        direction - self.axis * self.axis.dot(direction)
    }
}
