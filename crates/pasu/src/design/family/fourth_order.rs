//! ZY01 equations 13 to 17 and Table 1: a round vase with a waist or a belly.

use super::{cos, datum, fourth, sin};
use crate::design::boundary_value::{BoundaryValue, Span};
use crate::design::described::Expanded;
use crate::design::fields::fields;

fields! {
    /// The fourth order vase of ZY01 eqs 13-17. `u = 0` is the foot, `u = 1` the rim.
    ///
    /// `x` is `q(u) cos v` with `q` going from `r0` to `r1` and slopes `eta_i (4 rm - r1 - 3 r0)`; `y` the same with
    /// `sin v`; `z` is the cubic from 0 to `h1` with slopes `dz`. A link starts from figure 5a.
    pub struct FourthOrder, "a shape" {
        /// The radius of the foot.
        r0: f64 = 0.4, Required, Any;
        /// The radius of the rim.
        r1: f64 = 0.3, Required, Any;
        /// The radius at mid-height towards which the wall is bent.
        rm: f64 = 0.8, Required, Any;
        /// The height of the rim above the foot.
        h1: f64 = 2.0, Required, Any;
        /// How strongly the wall leaves the foot and meets the rim: eta1, eta2.
        eta: [f64; 2] = [0.5, 0.5], Required, Any;
        /// The slope of the height at the foot and at the rim: h0', h1'.
        dz: [f64; 2] = [6.0, 6.0], Required, Any;
        /// Shape control parameters of the fourth derivative along the profile, for x and for y.
        s: [f64; 2] = [1.0, 1.0], Required, NotZero;
        /// Shape control parameters of the mixed derivative, for x and for y.
        t: [f64; 2] = [3.0, 3.0], Required, Any;
        /// Shape control parameters of the fourth derivative round the pot, for x and for y.
        w: [f64; 2] = [1.0, 1.0], Required, Any;
    }
}

impl Expanded for FourthOrder {
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str = "ZY01 equations 13 to 17";
    #[cfg(feature = "typescript")]
    const NAME: &'static str = "FourthOrder";

    fn boundary_value(&self) -> BoundaryValue {
        let bend = 4.0 * self.rm - self.r1 - 3.0 * self.r0;
        let wall = datum((self.r0, self.eta[0] * bend), (self.r1, self.eta[1] * bend));
        BoundaryValue {
            span: Span::Tau,
            x: fourth([self.s[0], self.t[0], self.w[0]], vec![cos(1.0, wall.clone())]),
            y: fourth([self.s[1], self.t[1], self.w[1]], vec![sin(1.0, wall)]),
            z: fourth([1.0; 3], vec![cos(0.0, datum((0.0, self.dz[0]), (self.h1, self.dz[1])))]),
        }
    }
}
