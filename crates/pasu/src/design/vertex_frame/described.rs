//! What there is to know of a network of vertex-frames beside its fields.

use super::network::{FrameRule, VertexFrame};
#[cfg(feature = "typescript")]
use crate::design::declarations::{interface, union};
use crate::design::described::{Address, Described};
use crate::design::number::{numbers_of, plain, rounded};
#[cfg(feature = "typescript")]
use crate::design::tables::{FORCE, FRAME_PATCH, VERTEX_FRAME};
#[cfg(feature = "typescript")]
use crate::design::vertex_frame::Falloff;
use crate::error::{Code, Error, Result};

// All that leads here is compiled where it is called, for size: see `Design::from_value`.
impl Described for VertexFrame {
    fn address(&self) -> Address {
        Address::Patches(self.patches.len())
    }

    /// Numbers rounded. Vertices and patches stay in their order and stay all there, also what no patch uses: their numbers are what whoever edits a network holds on to.
    fn canonical(mut self) -> Result<Self> {
        self.numbers_mut().for_each(|number| *number = rounded(*number));
        // Rounding may close a rectangle.
        self.finite()
    }

    /// Refuses numbers of vertices and patches that there are not, and rectangles that do not ascend.
    fn finite(self) -> Result<Self> {
        let n_vertices = self.vertices.len();
        for (index, patch) in self.patches.iter().enumerate() {
            let refused = |error: Error| error.inside_item(index).inside_field("patches");
            for (place, vertex) in patch.frame.iter().enumerate() {
                if *vertex as usize >= n_vertices {
                    let error = beyond("vertex", *vertex, n_vertices).inside_item(place).inside_field("frame");
                    return Err(refused(error));
                }
            }
            for (place, force) in patch.forces.iter().enumerate() {
                for (name, [from, to]) in [("u", force.u), ("v", force.v)] {
                    if !(to - from >= NARROWEST) {
                        let message = format!(
                            "expected a second number above the first by a thousandth or more, found {} and {}",
                            plain(from),
                            plain(to)
                        );
                        let error = Error::new(Code::OutOfRange, "[1]", message).with("above", from).with("found", to);
                        let error = error.inside_field(name).inside_item(place).inside_field("forces");
                        return Err(refused(error));
                    }
                }
            }
        }
        match self.rule {
            FrameRule::Seed(patch) if patch as usize >= self.patches.len() => {
                Err(beyond("patch", patch, self.patches.len()).inside_field("seed").inside_field("rule"))
            }
            _ => Ok(self),
        }
    }

    #[cfg(feature = "typescript")]
    fn typescript(_: &str, text: &mut String) {
        interface(text, "VertexFrame", "Four-sided patches through a network of points.", VERTEX_FRAME);
        interface(text, "FramePatch", "One patch of a network.", FRAME_PATCH);
        interface(text, "Force", "A sculpting force on a patch.", FORCE);
        union(text, "Falloff", "How a force falls off.", Falloff::NAMES);
    }
}

/// The narrowest rectangle of a force, as a part of its patch.
const NARROWEST: f64 = 1e-3;

/// A number of something of which there are only so many.
fn beyond(what: &str, found: u32, n: usize) -> Error {
    let message = format!("expected the number of a {what}, {}, found {found}", numbers_of(n));
    let error = Error::new(Code::OutOfRange, "", message).with("least", 0.0);
    error.with("greatest", n as f64 - 1.0).with("found", f64::from(found))
}
