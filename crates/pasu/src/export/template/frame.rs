//! Where a pot stands, for drawings of it.

use glam::{DVec2, DVec3};

/// Where a part stands in space, in millimetres.
#[derive(Clone, Copy)]
pub(in crate::export) struct Frame {
    /// A point of the axis.
    pub(in crate::export) origin: DVec3,
    /// The unit vector from the foot to the rim.
    pub(in crate::export) axis: DVec3,
    /// The unit vector across the axis that a section runs along.
    pub(in crate::export) across: DVec3,
}

impl Frame {
    /// Distance along [`Self::across`] and height.
    pub(super) fn plan(&self, point: DVec3) -> DVec2 {
        DVec2::new((point - self.origin).dot(self.across), self.height(point))
    }

    pub(super) fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.axis)
    }

    /// As seen from above, [`Self::across`] to the right.
    pub(super) fn above(&self, point: DVec3) -> DVec2 {
        let from = point - self.origin;
        DVec2::new(from.dot(self.across), from.dot(self.axis.cross(self.across)))
    }

    /// The same with heights counted from so high.
    pub(super) fn raised(&self, height: f64) -> Frame {
        Frame { origin: self.origin + self.axis * height, ..*self }
    }

    /// The same turned, so that `across` runs along a direction seen from above, a unit vector.
    pub(super) fn towards(&self, seen: DVec2) -> Frame {
        let across = seen.x * self.across + seen.y * self.axis.cross(self.across);
        Frame { across: across.normalize_or(self.across), ..*self }
    }
}
