//! A point at a distance from the surface.

use glam::DVec3;

use super::skin::SkinJet;

/// Position and first derivatives of one side of a wall.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SheetJet {
    pub(crate) position: DVec3,
    pub(crate) ds: DVec3,
    pub(crate) dv: DVec3,
}

/// The jet at a distance `t` along the normal, given with its derivatives.
pub(super) fn offset(jet: &SkinJet, [t, t_s, t_v]: [f64; 3]) -> SheetJet {
    SheetJet {
        position: jet.position + jet.normal * t,
        ds: jet.ds + jet.normal_s * t + jet.normal * t_s,
        dv: jet.dv + jet.normal_v * t + jet.normal * t_v,
    }
}
