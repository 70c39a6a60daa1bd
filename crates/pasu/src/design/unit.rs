//! What the number 1 means in a design.

use super::names::names;

names! {
    /// The unit of length of a design.
    pub enum Unit {
        /// Centimetres.
        Cm = "cm",
        /// Millimetres.
        Mm = "mm",
        /// Inches.
        In = "in",
    }
}

impl Unit {
    /// How many millimetres one model unit has; exact.
    ///
    /// ```
    /// assert_eq!(pasu::Unit::In.millimetres(), 25.4);
    /// ```
    pub fn millimetres(self) -> f64 {
        match self {
            Unit::Cm => 10.0,
            Unit::Mm => 1.0,
            Unit::In => 25.4,
        }
    }
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(Unit, "Unit");
