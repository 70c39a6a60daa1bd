//! What a ray or a point meets.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::answer::answers;
use crate::design::plain;
use crate::error::{Code, Error, Result};
use crate::face::FaceKind;

/// A ray: from a point in a direction, which need not have length 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object with origin and direction")]
pub struct Ray {
    /// Where it begins.
    pub origin: [f64; 3],
    /// Where it goes.
    pub direction: [f64; 3],
}

answers! {
    /// A place where a ray meets a part, or the place of the surface of a part that is nearest to a point in it.
    pub struct Hit as "Hit" {
        /// The number of the part.
        pub part: usize,
        /// How far it is from the origin of the ray, or how deep the point is beneath the surface.
        pub distance: f64,
        /// The place, after placement.
        pub point: [f64; 3],
        /// The unit vector out of the part there; of a surface without an inside, out of the pot.
        pub normal: [f64; 3],
        /// Of a part with a wall what it is of that; `None` where the part has none.
        pub face: Option<FaceKind>,
        /// Of a part without a wall the number of the patch, of which a surface between two curves has one; `None` where it has a wall.
        pub patch: Option<usize>,
        /// Along the patch, as in `evaluate`; `None` of a part with a wall, and of an octant.
        pub u: Option<f64>,
        /// Across the patch, as in `evaluate`; `None` where `u` is.
        pub v: Option<f64>,
    }
}

/// The largest coordinate that may be asked for.
const LARGEST: f64 = 1e100;

/// Coordinates that can be computed with.
///
/// # Errors
/// `not-finite`; `out-of-range` beyond 1e100. The path is that of the number.
pub(super) fn point(at: [f64; 3], path: &str) -> Result<DVec3> {
    for (index, number) in at.into_iter().enumerate() {
        let path = || format!("{path}[{index}]");
        if !number.is_finite() {
            let message = format!("expected a finite number, found {number}");
            return Err(Error::new(Code::NotFinite, path(), message).with("found", number));
        }
        if number.abs() > LARGEST {
            let message = format!("expected a number between -1e100 and 1e100, found {}", plain(number));
            let error = Error::new(Code::OutOfRange, path(), message).with("least", -LARGEST);
            return Err(error.with("greatest", LARGEST).with("found", number));
        }
    }
    Ok(DVec3::from_array(at))
}

impl Ray {
    /// Its origin, and its direction with length 1.
    ///
    /// # Errors
    /// As [`point`]; `out-of-range` of a direction without length.
    pub(super) fn unit(&self) -> Result<(DVec3, DVec3)> {
        let origin = point(self.origin, "ray.origin")?;
        let direction = point(self.direction, "ray.direction")?;
        let largest = direction.abs().max_element();
        if largest == 0.0 {
            let message = "expected a direction of some length, found (0, 0, 0)";
            return Err(Error::new(Code::OutOfRange, "ray.direction", message).with("found", 0.0));
        }
        // The least doubles have no inverse.
        let scaled = if largest < 1e-300 { direction * 1e200 } else { direction };
        Ok((origin, (scaled / scaled.abs().max_element()).normalize_or(DVec3::Z)))
    }
}
