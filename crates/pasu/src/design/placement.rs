//! Where a part stands: scaled, then turned, then moved (ASB88).

use super::fields::fields;

fields! {
    /// The placement of a part: scale, then rotation, then shift.
    ///
    /// In a [`Design`](crate::Design) it is canonical, so that equal placements have equal numbers: `scale` has
    /// `Sx, Sz > 0`, and the sign of `Sy` says whether the part is mirrored; `axis = (h, k, l)` is a unit vector with
    /// `k > 0`, or `k = 0` and `h > 0`, or (0, 0, 1); `angle` lies in [-pi, pi); a turn by 0 has the axis (0, 0, 1).
    pub struct Placement {
        /// Factors along x, y and z, before turning.
        scale: [f64; 3] = [1.0, 1.0, 1.0], Optional, NotZero;
        /// The direction of the axis of rotation.
        axis: [f64; 3] = [0.0, 0.0, 1.0], Optional, Any;
        /// The angle in radians, anti-clockwise seen from where the axis points to.
        angle: f64 = 0.0, Optional, Any;
        /// The movement along x, y and z, after turning.
        shift: [f64; 3] = [0.0, 0.0, 0.0], Optional, Any;
    }
}

impl Default for Placement {
    /// Where the shape's own equations put it.
    fn default() -> Self {
        super::fields::Fields::START
    }
}

impl Placement {
    /// The rows of the matrix that scales, then turns (Rodrigues' formula; ASB88 T2, corrected).
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        let [h, k, l] = self.axis;
        let (sin, cos) = (libm::sin(self.angle), libm::cos(self.angle));
        let turned = 1.0 - cos;
        let rotation = [
            [cos + h * h * turned, h * k * turned - l * sin, h * l * turned + k * sin],
            [h * k * turned + l * sin, cos + k * k * turned, k * l * turned - h * sin],
            [h * l * turned - k * sin, k * l * turned + h * sin, cos + l * l * turned],
        ];
        rotation.map(|row| [row[0] * self.scale[0], row[1] * self.scale[1], row[2] * self.scale[2]])
    }

    pub(crate) fn canonical(mut self, _path: &super::path::Path) -> crate::error::Result<Self> {
        super::fields::Fields::round(&mut self);
        Ok(self)
    }
}
