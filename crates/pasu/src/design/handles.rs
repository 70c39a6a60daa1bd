//! What of a shape a hand can drag: the boundary data of its profile, and which numbers of the document each of them moves by how much.

use super::names::names;
use crate::answer::answers;

names! {
    /// A point of the profile that can be dragged.
    #[non_exhaustive]
    pub enum HandleId {
        /// The upper end.
        Rim = "rim",
        /// The tip of the slope `X_u` at the upper end.
        RimSlope = "rim-slope",
        /// The tip of the slope `X_u` at the lower end.
        FootSlope = "foot-slope",
        /// The lower end.
        Foot = "foot",
    }
}

names! {
    /// An end of the profile.
    pub enum End {
        /// `u = 0`.
        Start = "start",
        /// `u = 1`.
        End = "end",
    }
}

names! {
    /// Why a handle does not move, or moves one way only.
    #[non_exhaustive]
    pub enum Restraint {
        /// The foot of the family stands at height 0.
        FootHeight = "foot-height",
        /// The equation of second order leaves the slopes to itself.
        SecondOrderSlope = "second-order-slope",
        /// The mixed order prescribes the rise at the rim, and leaves the lean to the equation.
        MixedOrderLean = "mixed-order-lean",
        /// The wall of mixed order ends level at the foot.
        MixedOrderFoot = "mixed-order-foot",
        /// The factor `4 rm - r1 - 3 r0` of both flares of the fourth order is 0.
        NoSwell = "no-swell",
        /// The dint vase ends level at the foot.
        LevelFoot = "level-foot",
        /// No first harmonic goes round, so that there is no radius.
        NoRadius = "no-radius",
        /// The lean can be prescribed where `x` and `y` are of order 4.
        LeanOrder = "lean-order",
        /// The rise can be prescribed where `z` is of order 4.
        RiseOrder = "rise-order",
        /// The end of a pot of rings is free: no slope is given there.
        FreeEnd = "free-end",
    }
}

answers! {
    /// What of a shape a hand can drag: the rim and the foot of its profile at `v = 0`, and the slopes of the wall there. All before placement.
    ///
    /// What is prescribed is linear in the numbers of every kind, so that one answer is good for a whole drag: moving one handle leaves its own steps as they are, and the data
    /// of all others.
    pub struct Handles as "Handles" {
        /// Which end of `u` is the rim, that is the higher one.
        pub rim: End,
        /// All four, from the rim to the foot; none of a shape that has no profile.
        pub list: Vec<Handle>,
    }

    /// One handle.
    pub struct Handle as "Handle" {
        /// Which.
        pub id: HandleId,
        /// What moves it away from the axis by 1, a slope `X_u` as a point; empty where it cannot be moved so.
        pub radial: Vec<Step>,
        /// What moves it upwards by 1; empty where it cannot be moved so.
        pub axial: Vec<Step>,
        /// Why it cannot be moved one way or at all.
        pub restraints: Vec<Restraint>,
    }

    /// A number of the document that moves with a handle.
    pub struct Step as "Step" {
        /// Where it stands within the shape, such as `r[0]` or `x.modes[2].cos.start`. What is left out counts as its default; a mode behind the last is a new one.
        pub path: String,
        /// By how much it changes for 1; 0 of a number that has to be written and does not change.
        pub by: f64,
    }
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(HandleId, "HandleId");
#[cfg(feature = "typescript")]
crate::answer::known_as!(End, "End");
#[cfg(feature = "typescript")]
crate::answer::known_as!(Restraint, "Restraint");

impl Handles {
    /// Those of a shape whose rim is at `u = 0`, or at `u = 1`.
    #[inline]
    pub(super) fn new(is_start: bool, list: [Handle; 4]) -> Handles {
        Handles { rim: if is_start { End::Start } else { End::End }, list: list.into() }
    }
}

impl Handles {
    /// Those of a shape that has no profile.
    #[inline]
    pub(super) fn none() -> Handles {
        Handles { rim: End::End, list: Vec::new() }
    }
}

impl Handle {
    /// One that is moved by these steps.
    #[inline]
    pub(super) fn new(id: HandleId, radial: Vec<Step>, axial: Vec<Step>) -> Handle {
        Handle { id, radial, axial, restraints: Vec::new() }
    }

    /// The same, and why it is not free.
    #[inline]
    pub(super) fn held(mut self, by: impl IntoIterator<Item = Restraint>) -> Handle {
        self.restraints.extend(by);
        self
    }
}

/// Numbers that move together; none is no way to move.
#[inline]
pub(super) fn steps<const N: usize>(steps: [(&str, f64); N]) -> Vec<Step> {
    steps.map(|(path, by)| Step { path: path.to_owned(), by }).into()
}
