//! How a part is turned and moved once it is scaled.

use glam::{DMat3, DVec3};

use super::bounds::Bounds;
use crate::design::Placement;

/// How something is turned, then moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Motion {
    turn: DMat3,
    shift: DVec3,
}

impl Motion {
    /// What stays where it is: to the bit.
    pub(super) const NONE: Motion = Motion { turn: DMat3::IDENTITY, shift: DVec3::ZERO };

    /// That of a placement, but for its scale.
    pub(super) fn of(place: &Placement) -> Motion {
        let rows = Placement { scale: [1.0; 3], ..*place }.matrix();
        Motion { turn: DMat3::from_cols_array_2d(&rows).transpose(), shift: DVec3::from_array(place.shift) }
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
        let corner = |i: usize| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { bounds.low[axis] } else { bounds.high[axis] };
            self.point(DVec3::new(pick(0), pick(1), pick(2)))
        };
        let bounds = Bounds::of(&core::array::from_fn::<DVec3, 8, _>(corner));
        bounds.wider(1e-14 * bounds.low.abs().max(bounds.high.abs()).max_element())
    }
}
