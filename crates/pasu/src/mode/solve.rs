//! From an equation and its data to the closed form.

use super::equation::Equation;
use super::force;
use super::solution::{ModeData, ModeSolution};
use super::unsolvable::Unsolvable;

impl Equation {
    /// The solution with the given boundary data and force.
    ///
    /// Accuracy: `1e-10` of the largest datum for `q` and `1e-9 max(1, k sqrt(t/s))` of it for `q'`, for rates up to 1e3
    /// (in practice about `1e-13`; see `tests/library/mode.rs`).
    ///
    /// # Errors
    /// [`Unsolvable::Overflow`] if the solution leaves the range of doubles.
    ///
    /// ```
    /// use pasu::{Equation, ModeData, Order};
    ///
    /// // q'' - 4 q = 0 from 1 to 0: sinh(2 (1 - u)) / sinh(2)
    /// let equation = Equation::new(Order::Second, 1.0, 1.0, 0.0, 2.0)?;
    /// let solution = equation.solve(&ModeData { start: 1.0, end: 0.0, start_u: 0.0, end_u: 0.0, force: &[] })?;
    /// let [[q]] = equation.jets::<1, 1>([&solution], 0.5);
    /// assert!((q - 1.0f64.sinh() / 2.0f64.sinh()).abs() < 1e-15);
    /// # Ok::<(), pasu::Unsolvable>(())
    /// ```
    pub fn solve(&self, data: &ModeData) -> Result<ModeSolution, Unsolvable> {
        if data.is_zero() {
            return Ok(ModeSolution::zero());
        }
        let force = force::particular(self, data.force);
        ModeSolution::meeting(self, data, force)
    }
}
