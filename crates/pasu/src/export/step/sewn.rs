//! What a part has become in an exchange structure.

use super::exchange::Id;
use crate::face::FaceKind;

/// The faces of one part, sewn together.
pub(super) struct Sewn {
    /// The `MANIFOLD_SOLID_BREP`, or the `SHELL_BASED_SURFACE_MODEL` of a surface that is not closed.
    pub(super) shape: Id,
    pub(super) is_closed: bool,
    /// Every `ADVANCED_FACE` with what it is of.
    pub(super) faces: Vec<(FaceKind, Id)>,
    /// The largest distance from the exact faces at the points compared, millimetres.
    pub(super) deviation: f64,
    /// What it may be between these.
    pub(super) bound: f64,
    /// The number of points compared.
    pub(super) n_samples: usize,
}

/// A logical value as the format has it.
pub(super) fn boolean(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}
