//! What makes an open surface a pot.

use super::fields::fields;

fields! {
    /// The clay between the surface and the lining, in model units.
    pub struct Wall {
        /// The thickness of the wall.
        thickness: f64 = 0.3, Required, Positive;
        /// The thickness of the base; 0 for a pot without one.
        base: f64 = 0.3, Required, NotNegative;
    }
}
