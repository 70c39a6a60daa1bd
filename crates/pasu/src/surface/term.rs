//! One mode of one component, solved.

use crate::mode::{Equation, ModeSolution};

/// One `n` of one component.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Term {
    pub(crate) n: f64,
    pub(super) k: f64,
    pub(crate) equation: Equation,
    pub(super) cos: ModeSolution,
    pub(super) sin: ModeSolution,
}
