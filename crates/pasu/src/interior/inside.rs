//! What is known of the inside of a solid, as numbers.

use crate::blend::{Inside, InsideMap, Volume};
use crate::design::Design;
use crate::error::{Code, Error, Result};
use crate::solution::{Placed, Solution};

/// How well the inside of part number `part` solves its equation, and whether it is turned over anywhere, by samples; before placement.
///
/// # Errors
/// `no-such-point` for a part that does not exist; `unsupported-shape` for one that is no blend; `overflow` where weights are so large that no number tells what is left of the equation; what solving refuses.
///
/// ```
/// # let text = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "blend",
/// #   "start": { "form": "disc", "radius": [1, 1], "z": 0, "taper": 0, "dz": 2 }, "end": { "form": "disc", "radius": [2, 2], "z": 2, "taper": 0, "dz": 2 } } }] }"#;
/// let exact = pasu::Design::parse(text)?;
/// let inside = pasu::inside(&exact, 0)?;
/// // Nothing is approximated between two discs.
/// assert!(inside.residual < 1e-6 && !inside.is_folded());
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn inside(design: &Design, part: usize) -> Result<Inside> {
    Solution::of(design).inside(part)
}

/// The values of a map at triples `(u, v, w)` of the inside of part number `part`, before placement.
///
/// # Errors
/// As [`inside`]; `no-such-point` for numbers that are no triples, or a point outside; `overflow` where a value is beyond all numbers, as on the border of a disc in a square.
pub fn inside_values(design: &Design, part: usize, map: InsideMap, at: &[f64]) -> Result<Vec<f64>> {
    Solution::of(design).inside_values(part, map, at)
}

impl Solution {
    /// As [`inside`].
    ///
    /// # Errors
    /// As [`inside`].
    pub fn inside(&self, part: usize) -> Result<Inside> {
        let placed = self.part(part)?;
        let inside = volume_of(placed)?.inside();
        if inside.residual.is_finite() && inside.residual_rms.is_finite() && inside.jacobian_mean.is_finite() {
            return Ok(inside);
        }
        let message = "what these weights leave of the equation is beyond all numbers";
        Err(Error::new(Code::Overflow, placed.path("shape.weights"), message))
    }

    /// As [`inside_values`].
    ///
    /// # Errors
    /// As [`inside_values`].
    pub fn inside_values(&self, part: usize, map: InsideMap, at: &[f64]) -> Result<Vec<f64>> {
        self.existing(part)?;
        let volume = volume_of(self.part(part)?)?;
        self.check_points(part, at)?;
        let values = volume.mapped(map, at);
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(values),
            Some(point) => {
                let message = "the derivatives are beyond all numbers there";
                Err(Error::new(Code::Overflow, format!("at[{}]", 3 * point), message))
            }
        }
    }
}

fn volume_of(placed: &Placed) -> Result<&Volume> {
    placed.solved().volume().ok_or_else(|| {
        let message = "expected a blend: a shape of another kind has no inside that is known";
        Error::new(Code::UnsupportedShape, placed.path("shape"), message).with("what", "no-inside")
    })
}
