//! What is said of the constraints of a scene.

use crate::answer::answers;
use crate::error::Args;
use crate::make::Severity;

answers! {
    /// Whether a scene keeps its constraints.
    pub struct Constraints as "Constraints" {
        /// Whether all three are kept: nothing is broken, and nothing undecided.
        pub is_kept: bool,
        /// The slack within which parts touch, in the unit of the design.
        pub slack: f64,
        /// What breaks a constraint, what could not be decided, and which discrete objects touch.
        pub breaches: Vec<Breach>,
        /// How many more there are than are told.
        pub left_out: usize,
    }

    /// What two parts are to each other, where that is to be known.
    pub struct Breach as "Breach" {
        /// A stable kebab-case word: `interference` of parts of different objects, `not-connected` of parts that touch none of the others of their object, `within` of a part wholly inside another, `same-place` of one body twice; `contact` of objects that touch; `undecided-interference`, `undecided-connection` and `undecided-within` where the limit of work was not enough.
        pub code: &'static str,
        /// An error breaks a constraint, a warning is undecided, a note is a contact.
        pub severity: Severity,
        /// The part that it is about.
        pub part: usize,
        /// The other part.
        pub other: usize,
        /// All parts that it is about, in the order of the document: of `not-connected` and `undecided-connection` those that hang together with `part`, of all else `part` alone.
        pub group: Vec<usize>,
        /// One sentence.
        pub message: String,
        /// What the sentence names, as [`Error::args`](crate::Error::args) has it: the names of both parts, and of a group of several how many they are.
        pub args: Args,
        /// A witness: of interference a place of one part in the other, of contact where they touch, of what is not connected a place of `part` towards the other, in model units after placement.
        pub at: Option<[f64; 3]>,
        /// How deep the witness is beneath the surface at least of that one of the two parts within which it lies (it may be on the surface of the other), or how far what is not connected is away at least.
        pub distance: Option<f64>,
        /// Whether it rests on proved bounds alone. Bounds of the faces of walls are measured.
        pub is_proved: bool,
    }
}
