//! The closed form of a network of vertex-frames.

use glam::DVec3;

use super::four_sided::{FourSided, mixed};
use super::network::{refuse_coincident_corners, sides};
use super::orientation::{Orientation, orientation};
use super::strips::cubic;
use crate::design::VertexFrame;
use crate::error::{Code, Error, Result};
use crate::patch::{Patch, Side};

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
    /// doubles.
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
        for (index, ((points, cubic), sides)) in points.into_iter().zip(cubic).zip(sides).enumerate() {
            if let Some(place) = shape.patches[index].forces.first().map(|_| 0) {
                let message = "this version of Pasu cannot sculpt patches yet; expected no forces";
                return Err(inside(
                    Error::new(Code::UnsupportedShape, "", message)
                        .inside_item(place)
                        .inside_field("forces")
                        .inside_item(index),
                ));
            }
            let patch = FourSided::new(points, cubic, sides);
            if !patch.is_finite() {
                let message = "these numbers are so large, or so small, that the patch cannot be computed";
                return Err(inside(Error::new(Code::Overflow, "", message).inside_item(index)));
            }
            patches.push(patch);
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
