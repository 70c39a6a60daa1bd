//! Where a pot stands, for drawings of it.

use glam::{DVec2, DVec3};

/// Where a part stands in space, in millimetres.
pub(in crate::export) struct Frame {
    /// A point of the axis.
    pub(in crate::export) origin: DVec3,
    /// The unit vector from the foot to the rim.
    pub(in crate::export) axis: DVec3,
    /// The unit vector across the axis that the section runs along.
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

    /// As seen from above, the section's plane across.
    pub(super) fn above(&self, point: DVec3) -> DVec2 {
        let from = point - self.origin;
        DVec2::new(from.dot(self.across), from.dot(self.axis.cross(self.across)))
    }
}
