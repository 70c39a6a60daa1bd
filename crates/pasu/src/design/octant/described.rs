//! What there is to know of an octant beside its fields.

use super::fields::Octant;
#[cfg(feature = "typescript")]
use crate::design::declarations::interface;
use crate::design::described::{Address, Described};
use crate::design::number::rounded;
use crate::design::placement::Placement;
#[cfg(feature = "typescript")]
use crate::design::tables::OCTANT;
use crate::error::Result;

/// What goes round an octant: the curved side, and those in the planes `x = 0`, `y = 0` and `z = 0`.
const PATCHES: usize = 4;

impl Described for Octant {
    fn address(&self) -> Address {
        Address::Patches(PATCHES)
    }

    /// Numbers rounded. In which order they stand, is decided with the placement.
    fn canonical(self) -> Result<Self> {
        Ok(Octant { exponents: self.exponents.map(rounded) })
    }

    fn standing(self, given: &Placement, place: Placement) -> (Self, Placement) {
        self.in_order(given, place)
    }

    #[cfg(feature = "typescript")]
    fn typescript(_: &str, text: &mut String) {
        interface(text, "Octant", "The octant x^a + y^b + z^c <= 1 of a supersphere.", OCTANT);
    }
}
