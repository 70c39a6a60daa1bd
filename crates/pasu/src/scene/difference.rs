//! How scenes differ.

use crate::answer::answers;

answers! {
    /// How a scene differs from another. Every part of the first is kept, moved, changed or gone, every part of the second kept, moved, changed or added. Titles and names are not compared, but what differs is looked for under its name first.
    pub struct Difference as "Difference" {
        /// Whether both are one scene: the same parts in the same places, glued in the same way, in the same unit.
        pub is_same: bool,
        /// Parts that are the same in both.
        pub kept: Vec<Counterpart>,
        /// Parts that stand elsewhere, or are of another size by their placement.
        pub moved: Vec<Counterpart>,
        /// Parts of one name, or of one kind in one place, whose shape, wall or look is another.
        pub changed: Vec<Counterpart>,
        /// Numbers of the parts that only the first scene has.
        pub gone: Vec<usize>,
        /// Numbers of the parts that only the second scene has.
        pub added: Vec<usize>,
        /// Of the parts that both have, those that are glued to others of them than before.
        pub reglued: Vec<Counterpart>,
    }

    /// A part that is in both scenes, by its number in each.
    #[derive(Copy, Eq, PartialOrd, Ord)]
    pub struct Counterpart as "Counterpart" {
        /// In the first scene.
        pub before: usize,
        /// In the second scene.
        pub after: usize,
    }
}
