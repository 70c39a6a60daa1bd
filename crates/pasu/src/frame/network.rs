//! Where the sides of patches meet.

use glam::DVec3;

use crate::design::{FramePatch, plain};
use crate::error::{Code, Error, Result};
use crate::patch::Side;

/// The places in a frame of the three points of each side, in the order of the parameter that runs along it.
pub(super) const SIDES: [[usize; 3]; 4] = [[0, 7, 6], [2, 3, 4], [0, 1, 2], [6, 5, 4]];

/// The places in a frame of its corners.
const CORNERS: [usize; 4] = [0, 2, 4, 6];

/// Which of the two directions of a patch runs along a side: 0 for `u`, 1 for `v`.
pub(super) fn along(side: usize) -> usize {
    usize::from(side < 2)
}

/// Refuses a patch two corners of which are the same point: of patches by their numbers with their eight points. The path begins at the patches.
///
/// # Errors
/// `pinched-surface`.
pub(super) fn refuse_coincident_corners(patches: impl Iterator<Item = (usize, [DVec3; 8])>) -> Result<()> {
    for (index, points) in patches {
        let corners = CORNERS.map(|place| points[place]);
        for (i, j) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
            if corners[i] == corners[j] {
                let [one, other] = [i, j].map(|corner| CORNERS[corner] + 1);
                let at = corners[i];
                let message = format!(
                    "points {one} and {other} of this patch are the same corner, at ({}, {}, {}): expected four corners",
                    plain(at.x),
                    plain(at.y),
                    plain(at.z)
                );
                let error = Error::new(Code::PinchedSurface, "frame", message).inside_item(index);
                return Err(error.with("what", "corners").near(at.to_array()));
            }
        }
    }
    Ok(())
}

/// For each patch what its four sides meet: sides that have their three points in common are one, in whatever direction each passes them. The path begins at the patches.
///
/// # Errors
/// `crosses-itself` for an edge that three patches have in common: no surface branches there.
pub(super) fn sides(patches: &[FramePatch]) -> Result<Vec<[Side; 4]>> {
    let mut met = vec![[Side::Free; 4]; patches.len()];
    let mut edges = Vec::with_capacity(4 * patches.len());
    for (index, patch) in patches.iter().enumerate() {
        for (side, places) in SIDES.into_iter().enumerate() {
            let [from, middle, to] = places.map(|place| patch.frame[place]);
            edges.push(([from.min(to), middle, from.max(to)], index as u32, side as u32, from > to));
        }
    }
    edges.sort_unstable();
    for same in edges.chunk_by(|one, other| one.0 == other.0) {
        match same {
            [_] => {}
            [(_, one, side, is_against), (_, other, others, are_against)] => {
                let is_reversed = is_against != are_against;
                let shared =
                    |patch: u32, side: u32| Side::Shared { patch: patch as usize, side: side as usize, is_reversed };
                met[*one as usize][*side as usize] = shared(*other, *others);
                met[*other as usize][*others as usize] = shared(*one, *side);
            }
            [(_, one, ..), (_, other, ..), ([from, middle, to], third, ..), ..] => {
                let message = format!(
                    "the edge through the vertices {from}, {middle} and {to} is also that of the patches {one} and {other}: expected an edge of no more than two patches"
                );
                let error = Error::new(Code::CrossesItself, "frame", message).inside_item(*third as usize);
                return Err(error.with("what", "edge").with("found", same.len()));
            }
            [] => {}
        }
    }
    Ok(met)
}
