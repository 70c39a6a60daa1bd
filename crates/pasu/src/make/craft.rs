//! The way in which a pot is made.

/// How a pot is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Craft {
    /// Printed layer by layer: walls of 0.8 mm, two lines of the usual nozzle of 0.4 mm, bases of three layers of 0.2 mm, and overhangs of at most 45 degrees.
    Print,
    /// Formed of clay by hand, on the wheel or by casting: walls and bases of 2 mm.
    Clay,
}

impl Craft {
    /// Every way.
    pub const ALL: [Craft; 2] = [Craft::Print, Craft::Clay];

    /// The word by which it is known: `print` or `clay`.
    ///
    /// ```
    /// assert_eq!(pasu::Craft::Clay.name(), "clay");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Craft::Print => "print",
            Craft::Clay => "clay",
        }
    }

    /// The thinnest wall in millimetres that there can be at all, and the thinnest that holds.
    ///
    /// ```
    /// assert_eq!(pasu::Craft::Print.thinnest(), [0.4, 0.8]);
    /// ```
    pub fn thinnest(self) -> [f64; 2] {
        match self {
            Craft::Print => [0.4, 0.8],
            Craft::Clay => [1.0, 2.0],
        }
    }

    /// The same of a base, which a printer lays as layers of the usual 0.2 mm: one at all, three to hold.
    ///
    /// ```
    /// assert_eq!(pasu::Craft::Print.thinnest_base(), [0.2, 0.6]);
    /// ```
    pub fn thinnest_base(self) -> [f64; 2] {
        match self {
            Craft::Print => [0.2, 0.6],
            Craft::Clay => [1.0, 2.0],
        }
    }
}
