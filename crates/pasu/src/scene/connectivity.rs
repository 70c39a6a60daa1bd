//! Which parts of a design are glued.

use crate::answer::answers;
use crate::design::Design;

answers! {
    /// Which parts of a design are glued to which, and to which discrete object each belongs; parts by their number in the document.
    pub struct Connectivity as "Connectivity" {
        /// The discrete object of each part; objects are numbered 0, 1, 2 as they first appear.
        pub objects: Vec<usize>,
        /// Row by row, for each pair of parts whether both are glued into one object. Symmetric; each part is glued to itself.
        pub glued: Vec<Vec<bool>>,
    }
}

/// The connectivity matrix of a design (ASB88).
///
/// A document says which object a part is glued into, and not along which pairs: all parts of one object are glued to each other here, whether they touch or not.
///
/// ```
/// let three = r#"{ "pasu": 1, "parts": [
///     { "object": 4, "shape": { "kind": "octant", "exponents": [2, 2, 2] } },
///     { "object": 1, "shape": { "kind": "octant", "exponents": [8, 8, 8] } },
///     { "object": 4, "shape": { "kind": "octant", "exponents": [1, 1, 1] } }
/// ] }"#;
/// let found = pasu::connectivity(&pasu::Design::parse(three)?);
/// assert_eq!(found.objects, [0, 1, 0]);
/// assert_eq!(found.glued, [[true, false, true], [false, true, false], [true, false, true]]);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn connectivity(design: &Design) -> Connectivity {
    let mut numbers: Vec<u32> = Vec::new();
    let numbered = |part: &crate::design::Part| {
        numbers.iter().position(|number| *number == part.object).unwrap_or_else(|| {
            numbers.push(part.object);
            numbers.len() - 1
        })
    };
    let objects: Vec<usize> = design.parts().iter().map(numbered).collect();
    let glued = objects.iter().map(|one| objects.iter().map(|other| one == other).collect()).collect();
    Connectivity { objects, glued }
}
