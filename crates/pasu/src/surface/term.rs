//! One mode of one component, solved.

use std::sync::Arc;

use crate::mode::{Beam, Deflection};

/// One `n` of one component.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Term {
    pub(crate) n: f64,
    pub(super) k: f64,
    /// Index of `n` among the different ones of the surface.
    pub(super) column: usize,
    /// Shared by all components and modes with the same equation.
    pub(crate) beam: Arc<Beam>,
    pub(crate) cos: Deflection,
    pub(super) sin: Deflection,
}

impl Term {
    /// The factors of cosine and sine at `u`, each with its slope.
    pub(crate) fn slopes(&self, u: f64) -> [[f64; 2]; 2] {
        self.beam.jets::<2, 2>([&self.cos, &self.sin], u)
    }

    /// The factors of cosine and sine at `u`.
    pub(crate) fn values(&self, u: f64) -> [f64; 2] {
        let [[cos], [sin]] = self.beam.jets::<1, 2>([&self.cos, &self.sin], u);
        [cos, sin]
    }
}
