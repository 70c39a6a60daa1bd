//! How far a mesh in single precision may be from the surface: what [`Mesh`](super::Mesh) promises.

/// Half a unit in the last place of a single, relative to the number.
pub(super) const HALF_UNIT: f64 = 1.0 / 16_777_216.0;

/// The promised largest error of a position, in parts of the largest coordinate.
pub(super) const POSITION_ERROR: f64 = 5e-7;

/// The promised largest error of a normal, less what its own arithmetic takes, in radians.
pub(super) const NORMAL_ERROR: f64 = 9.2e-7;
