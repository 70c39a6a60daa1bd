//! How a part is turned and moved once it is scaled, as what is done to points.

use glam::{DMat3, DVec3};

use super::bounds::Bounds;
use crate::design::Placement;

/// A turn, then a shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Isometry {
    turn: DMat3,
    shift: DVec3,
}

impl Isometry {
    /// What leaves everything where it is: to the bit.
    pub(super) const NONE: Isometry = Isometry { turn: DMat3::IDENTITY, shift: DVec3::ZERO };

    /// That of a placement, but for its scale.
    pub(super) fn of(place: &Placement) -> Isometry {
        let rows = Placement { scale: [1.0; 3], ..*place }.matrix();
        Isometry { turn: DMat3::from_cols_array_2d(&rows).transpose(), shift: DVec3::from_array(place.shift) }
    }

    /// Where a point comes to be.
    pub(super) fn point(&self, point: DVec3) -> DVec3 {
        self.turn * point + self.shift
    }

    pub(super) fn vector(&self, vector: DVec3) -> DVec3 {
        self.turn * vector
    }

    /// Where a point was before.
    pub(super) fn point_before(&self, point: DVec3) -> DVec3 {
        self.vector_before(point - self.shift)
    }

    pub(super) fn vector_before(&self, vector: DVec3) -> DVec3 {
        self.turn.transpose() * vector
    }

    /// The box round a box where that comes to be.
    pub(super) fn bounds(&self, bounds: &Bounds) -> Bounds {
        let bounds = Bounds::of(&bounds.corners().map(|corner| self.point(corner)));
        bounds.wider(1e-14 * bounds.far())
    }
}
