//! From an equation and its data to the closed form.

use super::equation::Equation;
use super::force;
use super::solution::{ModeData, ModeSolution};
use super::unsolvable::Unsolvable;

impl Equation {
    /// The solution with the given boundary data and force.
    ///
    /// Accuracy: `1e-10` of the largest datum for `q` and `1e-9 max(1, k sqrt(t/s))` of it for `q'`, for rates up to 1e3
    /// (in practice about `1e-13`; see `tests/mode.rs`).
    ///
    /// # Errors
    /// [`Unsolvable::Overflow`] if the solution leaves the range of doubles.
    pub fn solve(&self, data: &ModeData) -> Result<ModeSolution, Unsolvable> {
        if data.is_zero() {
            return Ok(ModeSolution::zero());
        }
        let force = force::particular(self, data.force);
        ModeSolution::meeting(self, data, force)
    }
}
