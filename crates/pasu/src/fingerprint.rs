//! A short name for the geometry of a design.

use xxhash_rust::xxh64::Xxh64;

use crate::design::Design;
use crate::error::Result;
use crate::mesh::{Mesh, exact_mesh};
use crate::solution::Solution;

/// The grid of every part. Frozen with format version 1: another grid would be another fingerprint.
const ROWS: usize = 33;
/// As [`ROWS`].
const COLUMNS: usize = 97;
/// Into how many pieces a patch of a network is cut between its knots, both ways; frozen as [`ROWS`] is.
const PIECES: usize = 4;

/// Sixteen hexadecimal digits: xxHash64 of the mesh at a fixed resolution (33 x 97 vertices a part; of a network of patches 5 x 5 a patch, and as many more between the rims of what sculpts it), positions as little-endian `f32`, then indices and groups
/// as little-endian `u32`.
///
/// The same on every machine, because every elementary function in the solver is computed by the same code in the same order. Title, names, looks and the order of the parts do not change it;
/// placement and every number of the shape do, unless too little to move a vertex by half a unit in its last place. Nearly all vertices of an octant with an exponent of 50 are at the ends of its curves, where another exponent beside that may move none once it stands away from the origin: [`compare`](crate::compare()) and links tell all designs apart.
///
/// # Errors
/// As [`mesh`](crate::mesh).
///
/// ```
/// use pasu::{Design, fingerprint};
///
/// let vase = Design::parse("#1/bloor-wilson?n1=5")?;
/// let other = Design::parse("#1/bloor-wilson?n1=6")?;
/// assert_eq!(fingerprint(&vase)?.len(), 16);
/// assert_ne!(fingerprint(&vase)?, fingerprint(&other)?);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn fingerprint(design: &Design) -> Result<String> {
    Solution::of(design).fingerprint()
}

impl Solution {
    /// As [`fingerprint`].
    ///
    /// # Errors
    /// As [`fingerprint`].
    pub fn fingerprint(&self) -> Result<String> {
        let order = self.design().order();
        Ok(hashed(&exact_mesh(self, &order, ROWS, COLUMNS, PIECES)?, &order))
    }
}

/// Of a mesh whose parts stand in this order: which number they have in the design has no meaning.
fn hashed(mesh: &Mesh, order: &[usize]) -> String {
    let mut hash = Xxh64::new(0);
    for position in &mesh.positions {
        // Adding 0 makes 0 of -0, which is the same place.
        hash.update(&(position + 0.0).to_le_bytes());
    }
    for index in &mesh.indices {
        hash.update(&index.to_le_bytes());
    }
    for [first, count, part] in mesh.groups.as_chunks::<3>().0 {
        let place = order.iter().position(|index| *index == *part as usize).unwrap_or_default() as u32;
        for number in [*first, *count, place] {
            hash.update(&number.to_le_bytes());
        }
    }
    format!("{:016x}", hash.digest())
}
