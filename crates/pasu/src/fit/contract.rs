//! What is answered: a design of rings, and how near it comes.

use crate::answer::answers;
use crate::design::{Design, RINGS, plain};
use crate::error::{Code, Error, Result};

answers! {
    /// A design of rings that says what something else said.
    pub struct Ringed as "Ringed" {
        /// The design.
        pub design: Design,
        /// How far it is from what it stands for, at most. Of a drawn line a bound, both ways; of a part the largest distance that was found, where it stands: an estimate, since it is looked for at samples.
        pub distance: f64,
    }
}

pub(super) fn check_tolerance(tolerance: f64) -> Result<()> {
    if tolerance > 0.0 && tolerance.is_finite() {
        return Ok(());
    }
    let message = format!("expected a tolerance greater than 0, found {}", plain(tolerance));
    Err(Error::new(Code::OutOfRange, "tolerance", message).with("above", 0.0).with("found", tolerance))
}

/// Rings are not enough.
pub(super) fn too_fine(tolerance: f64, reached: f64) -> Error {
    let (asked, reached_text) = (plain(tolerance), plain(reached));
    let message =
        format!("expected a tolerance that {} rings can hold, found {asked}; {reached_text} was reached", RINGS + 2);
    Error::new(Code::ToleranceTooFine, "tolerance", message).with("found", tolerance).with("reached", reached)
}
