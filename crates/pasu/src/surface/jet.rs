//! Position and derivatives of a surface at one point.

use glam::DVec3;

/// Position and first and second derivatives of `X(u, v)`, in model units, before placement.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SurfaceJet {
    /// `X`.
    pub position: DVec3,
    /// `X_u`.
    pub du: DVec3,
    /// `X_v`.
    pub dv: DVec3,
    /// `X_uu`.
    pub duu: DVec3,
    /// `X_uv`.
    pub duv: DVec3,
    /// `X_vv`.
    pub dvv: DVec3,
}
