//! ZY01 equations 1 to 8: a round mouth with petals that fade towards the foot.

use std::f64::consts::TAU;

use super::{cos, datum, second, sin};
use crate::design::boundary_value::{BoundaryValue, Datum, Mode, Span};
use crate::design::described::Expanded;
use crate::design::fields::fields;

fields! {
    /// The second order vase of ZY01 eqs 1-8. `u = 0` is the rim, `u = 1` the foot.
    ///
    /// `x(0, v) = r1 cos(a1 v) + r2 cos(a2 v)`, `x(1, v) = r3 cos(a1 v) + r4 cos(a2 v)`, `a_i = 2 pi n_i`; `y` the same
    /// with `sin`; `z` falls in a straight line from `height` to 0. A link starts from figure 1a.
    pub struct SecondOrder, "a shape" {
        /// Radius and petals of the rim, radius and petals of the foot: r1, r2, r3, r4.
        r: [f64; 4] = [1.0, 0.1, 0.6, 0.06], Required, Any;
        /// How often the outline and its petals go round: n1, n2. The surface closes when both are whole.
        n: [f64; 2] = [1.0, 8.0], Optional, Any;
        /// The height of the rim above the foot.
        height: f64 = 3.6, Optional, Any;
        /// Shape control parameters of the second derivative along the profile, for x and for y.
        s: [f64; 2] = [1.0, 1.0], Optional, NotZero;
        /// Shape control parameters of the second derivative round the pot, for x and for y.
        t: [f64; 2] = [0.5, 0.5], Optional, Any;
        /// Sculpting force on the outline: p0 + p1 u.
        force: [f64; 2] = [0.0, 0.0], Optional, Any;
    }
}

impl Expanded for SecondOrder {
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str = "ZY01 equations 1 to 8";
    #[cfg(feature = "typescript")]
    const NAME: &'static str = "SecondOrder";

    fn boundary_value(&self) -> BoundaryValue {
        let [x, y] = walls(self.r, self.n, self.force);
        BoundaryValue {
            span: Span::Length(1.0),
            x: second(self.s[0], self.t[0], x),
            y: second(self.s[1], self.t[1], y),
            z: second(1.0, 1.0, vec![cos(0.0, datum((self.height, 0.0), (0.0, 0.0)))]),
        }
    }
}

/// The modes of `x` and `y`, shared with the mixed order vase.
///
/// ZY01 eqs 7-8 hold only with the force scaled by `a1^2`, as in its figures: `a1^2 (p0 + p1 u) cos(a1 v)`.
pub(super) fn walls([r1, r2, r3, r4]: [f64; 4], [n1, n2]: [f64; 2], force: [f64; 2]) -> [Vec<Mode>; 2] {
    let a1 = TAU * n1;
    let outline = Datum { force: force.map(|p| a1 * a1 * p).to_vec(), ..datum((r1, 0.0), (r3, 0.0)) };
    let petals = datum((r2, 0.0), (r4, 0.0));
    [vec![cos(n1, outline.clone()), cos(n2, petals.clone())], vec![sin(n1, outline), sin(n2, petals)]]
}
