//! The shape of one part, solved.

use crate::design::Part;
use crate::error::Result;
use crate::patch::{Patch, Side};
use crate::surface::Surface;

/// The closed form of a shape: patches, whatever its kind. A new kind of shape is one more variant.
#[derive(Debug)]
#[cfg_attr(test, expect(clippy::large_enum_variant, reason = "the other is for tests"))]
pub(crate) enum Solved {
    /// A surface between two curves.
    TwoSided(Surface),
    /// Patches that stand for a kind yet to come: what the contract is tested with.
    #[cfg(test)]
    Patches(Vec<Box<dyn Patch>>),
}

impl Solved {
    /// Solves the shape of part number `index` of a design.
    ///
    /// # Errors
    /// As [`Surface::of_part`].
    pub(crate) fn of(part: &Part, index: usize) -> Result<Solved> {
        Surface::of_part(part, index).map(Solved::TwoSided)
    }

    /// The patches, of which there is at least one.
    pub(crate) fn patches(&self) -> Vec<&dyn Patch> {
        (0..self.n_patches()).map(|index| self.patch(index)).collect()
    }

    /// One of the patches; the first in place of one that there is not.
    pub(crate) fn patch(&self, #[cfg_attr(not(test), expect(unused_variables))] index: usize) -> &dyn Patch {
        match self {
            Solved::TwoSided(surface) => surface,
            #[cfg(test)]
            Solved::Patches(patches) => &**patches.get(index).unwrap_or(&patches[0]),
        }
    }

    /// The number of patches.
    pub(crate) fn n_patches(&self) -> usize {
        match self {
            Solved::TwoSided(_) => 1,
            #[cfg(test)]
            Solved::Patches(patches) => patches.len(),
        }
    }

    /// Whether the patches have no free side, so that they go round a body.
    pub(crate) fn is_closed(&self) -> bool {
        self.patches().iter().all(|patch| patch.sides().iter().all(|side| *side != Side::Free))
    }

    /// The patch that runs from one end to the other and closes round between them: what can carry a wall. It is one also where it fails to close, which whoever needs that has to ask.
    pub(crate) fn wall(&self) -> Option<&dyn Patch> {
        match self {
            Solved::TwoSided(surface) => Some(surface),
            #[cfg(test)]
            Solved::Patches(_) => None,
        }
    }

    /// The Fourier series in `v` that the single precision kernel sums, if it is one: the door to `mesh/fourier`.
    pub(crate) fn fourier(&self) -> Option<&Surface> {
        match self {
            Solved::TwoSided(surface) => Some(surface),
            #[cfg(test)]
            Solved::Patches(_) => None,
        }
    }
}
