//! The closed form of a network of vertex-frames.

use core::f64::consts::PI;

use glam::DVec3;

use super::bump::Bump;
use super::four_sided::{FourSided, mixed};
use super::network::{refuse_coincident_corners, sides};
use super::orientation::{Orientation, orientation};
use super::region::pieces;
use super::strips::cubic;
use crate::design::{Force, FramePatch, VertexFrame, plain};
use crate::error::{Code, Error, Result};
use crate::patch::{Patch, Side};

/// The most pieces of forces that one network may have.
const MOST_PIECES: usize = 100_000;

/// A network of vertex-frames, solved: polynomial patches that have their edges in common.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame {
    patches: Vec<FourSided>,
    orientation: Orientation,
    crease: f64,
}

impl Frame {
    /// Solves a network. `path` is where the shape stands in its design, for the error.
    ///
    /// # Errors
    /// `pinched-surface` for a patch two corners of which are the same; `crosses-itself` for an edge of three patches; `out-of-range` where a parameter is 0 that a strip needs; `overflow` where coefficients leave the range of
    /// doubles. Of a force: `out-of-range` where `a1 + a2` is 0, or its rectangle does not meet its patch, `crosses-itself` where that cannot lie flat on the patches that it goes on to.
    pub(crate) fn solve(shape: &VertexFrame, path: &str) -> Result<Frame> {
        let inside = |error: Error| {
            let error = error.inside_field("patches");
            let place = format!("{path}.{}", error.path());
            error.at(place)
        };
        let point = |vertex: u32| shape.vertices.get(vertex as usize).map_or(DVec3::ZERO, |at| DVec3::from_array(*at));
        refuse_coincident_corners(&shape.patches, point).map_err(inside)?;
        let sides = sides(&shape.patches).map_err(inside)?;
        let points: Vec<[DVec3; 8]> = shape.patches.iter().map(|patch| patch.frame.map(point)).collect();
        let mixed: Vec<[DVec3; 2]> = points.iter().map(mixed).collect();
        let cubic = cubic(&shape.patches, &sides, &mixed, shape.rule).map_err(inside)?;
        let mut patches = Vec::with_capacity(points.len());
        for ((points, cubic), sides) in points.into_iter().zip(cubic).zip(sides.iter().copied()) {
            patches.push(FourSided::new(points, cubic, sides));
        }
        sculpt(&shape.patches, &sides, &mut patches).map_err(inside)?;
        if let Some(index) = patches.iter().position(|patch| !patch.is_finite()) {
            let message = "these numbers are so large, or so small, that the patch cannot be computed";
            return Err(inside(Error::new(Code::Overflow, "", message).inside_item(index)));
        }
        let orientation = orientation(&patches);
        Ok(Frame { patches, orientation, crease: shape.crease })
    }

    /// One of the patches; the first in place of one that there is not.
    pub(crate) fn patch(&self, index: usize) -> &dyn Patch {
        self.patches.get(index).unwrap_or(&self.patches[0])
    }

    /// The number of patches.
    pub(crate) fn n_patches(&self) -> usize {
        self.patches.len()
    }

    /// Whether it goes round a body: no side of a patch is free, and the network has an inside and an outside.
    pub(crate) fn is_closed(&self) -> bool {
        let mut sides = self.patches.iter().flat_map(|patch| patch.sides());
        self.orientation.is_two_sided && sides.all(|side| side != Side::Free)
    }

    /// For each patch whether `X_u x X_v` points outwards.
    pub(crate) fn is_outward(&self) -> &[bool] {
        &self.orientation.is_outward
    }

    /// Edges at which the surface turns by less than this angle are shown as if it were smooth, in radians.
    pub(crate) fn crease(&self) -> f64 {
        self.crease
    }
}

/// Adds to every patch what forces do there.
fn sculpt(given: &[FramePatch], sides: &[[Side; 4]], patches: &mut [FourSided]) -> Result<()> {
    let mut n_pieces = 0;
    for (index, FramePatch { a1, a2, forces, .. }) in given.iter().enumerate() {
        let inside = |place: usize, error: Error| error.inside_item(place).inside_field("forces").inside_item(index);
        for (place, Force { f0, u, v, falloff }) in forces.iter().enumerate() {
            let mut amplitude = DVec3::ZERO;
            for component in (0..3).filter(|component| f0[*component] != 0.0) {
                let sum = a1[component] + a2[component];
                if sum == 0.0 {
                    let axis = ["x", "y", "z"][component];
                    let message = format!(
                        "a force on {axis} acts on the sum of a1 and a2, which is 0 here: expected another number than {}, found {}",
                        plain(-a1[component]),
                        plain(a2[component])
                    );
                    let error = Error::new(Code::OutOfRange, "", message)
                        .inside_item(component)
                        .inside_field("a2")
                        .inside_item(index);
                    return Err(error.with("component", axis).with("not", -a1[component]).with("found", a2[component]));
                }
                amplitude[component] = -f0[component] / (PI * PI * sum);
            }
            let pieces = pieces(index, [*u, *v], sides).map_err(|error| inside(place, error))?;
            n_pieces += pieces.len();
            if n_pieces > MOST_PIECES {
                let message =
                    format!("expected forces over at most {MOST_PIECES} patches in all; this one exceeds them");
                return Err(inside(place, Error::new(Code::TooLarge, "", message).with("greatest", MOST_PIECES)));
            }
            for piece in pieces {
                if let Some(patch) = patches.get_mut(piece.patch) {
                    patch.add(Bump { amplitude, sides: piece.sides, falloff: *falloff });
                }
            }
        }
    }
    Ok(())
}
