//! ZY01 equations 13 to 17 and Table 1: a round vase with a waist or a belly.

use super::{cos, datum, fourth, sin};
use crate::design::boundary_value::{BoundaryValue, Span};
use crate::design::described::Expanded;
use crate::design::fields::fields;
use crate::design::handles::{Handle, HandleId, Handles, Restraint, steps};
#[cfg(feature = "typescript")]
use crate::design::slider::{Group, Slider};

fields! {
    /// The fourth order vase of ZY01 eqs 13-17. `u = 0` is the foot, `u = 1` the rim.
    ///
    /// `x` is `q(u) cos v` with `q` going from `r0` to `r1` and slopes `eta_i (4 rm - r1 - 3 r0)`; `y` the same with
    /// `sin v`; `z` is the cubic from 0 to `h1` with slopes `dz`. A link starts from figure 5a.
    pub struct FourthOrder, "a shape" {
        /// The radius of the foot.
        r0: f64 = 0.4, Required, Any, Length;
        /// The radius of the rim.
        r1: f64 = 0.3, Required, Any, Length;
        /// The radius at mid-height towards which the wall is bent.
        rm: f64 = 0.8, Required, Any, Length;
        /// The height of the rim above the foot.
        h1: f64 = 2.0, Required, Any, Length;
        /// How strongly the wall leaves the foot and meets the rim: eta1, eta2.
        eta: [f64; 2] = [0.5, 0.5], Required, Any, One;
        /// The slope of the height at the foot and at the rim: h0', h1'.
        dz: [f64; 2] = [6.0, 6.0], Required, Any, Length;
        /// Shape control parameters of the fourth derivative along the profile, for x and for y.
        s: [f64; 2] = [1.0, 1.0], Required, NotZero, One;
        /// Shape control parameters of the mixed derivative, for x and for y.
        t: [f64; 2] = [3.0, 3.0], Required, Any, One;
        /// Shape control parameters of the fourth derivative round the pot, for x and for y.
        w: [f64; 2] = [1.0, 1.0], Required, Any, One;
    }
}

impl Expanded for FourthOrder {
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str = "ZY01 equations 13 to 17";
    #[cfg(feature = "typescript")]
    const NAME: &'static str = "FourthOrder";

    #[cfg(feature = "typescript")]
    fn sliders() -> Vec<Slider> {
        vec![
            Slider::of("r1", "r_1", Group::Rim, [0.0, 3.0], 0.01),
            Slider::of("eta", "η_2", Group::Rim, [-5.0, 5.0], 0.05).at(1),
            Slider::of("dz", "h_1'", Group::Rim, [-15.0, 15.0], 0.1).at(1),
            Slider::of("r0", "r_0", Group::Foot, [0.0, 3.0], 0.01),
            Slider::of("eta", "η_1", Group::Foot, [-5.0, 5.0], 0.05).at(0),
            Slider::of("dz", "h_0'", Group::Foot, [-15.0, 15.0], 0.1).at(0),
            Slider::of("h1", "h_1", Group::Height, [0.2, 10.0], 0.05),
            Slider::of("rm", "r_m", Group::Wall, [0.0, 3.0], 0.01),
            Slider::of("t", "t", Group::Equation, [0.0, 60.0], 0.5).both(),
            Slider::of("w", "w", Group::Equation, [0.0, 200.0], 1.0).both(),
            Slider::of("s", "s", Group::Equation, [0.1, 10.0], 0.05).both(),
        ]
    }

    fn boundary_value(&self) -> BoundaryValue {
        let bend = self.swell();
        let wall = datum((self.r0, self.eta[0] * bend), (self.r1, self.eta[1] * bend));
        BoundaryValue {
            span: Span::Tau,
            rings: Vec::new(),
            x: fourth([self.s[0], self.t[0], self.w[0]], vec![cos(1.0, wall.clone())]),
            y: fourth([self.s[1], self.t[1], self.w[1]], vec![sin(1.0, wall)]),
            z: fourth([1.0; 3], vec![cos(0.0, datum((0.0, self.dz[0]), (self.h1, self.dz[1])))]),
        }
    }

    /// Moving an end keeps both slopes: the belly radius follows, so that the factor of the flares stays as it was.
    #[inline]
    fn handles(&self) -> Handles {
        let lean = 1.0 / self.swell();
        let is_start = self.h1 < 0.0;
        let slope = |id, end: usize| {
            let axial = steps([(["dz[0]", "dz[1]"][end], 1.0)]);
            match lean.is_finite() {
                true => Handle::new(id, steps([(["eta[0]", "eta[1]"][end], lean)]), axial),
                false => Handle::new(id, Vec::new(), axial).held([Restraint::NoSwell]),
            }
        };
        Handles::new(
            is_start,
            [
                Handle::new(HandleId::Rim, steps([("r1", 1.0), ("rm", 0.25)]), steps([("h1", 1.0)])),
                slope(HandleId::RimSlope, usize::from(!is_start)),
                slope(HandleId::FootSlope, usize::from(is_start)),
                Handle::new(HandleId::Foot, steps([("r0", 1.0), ("rm", 0.75)]), Vec::new())
                    .held([Restraint::FootHeight]),
            ],
        )
    }
}

impl FourthOrder {
    /// `4 rm - r1 - 3 r0`, the factor of both flares (ZY01 eq 13).
    pub(crate) fn swell(&self) -> f64 {
        4.0 * self.rm - self.r1 - 3.0 * self.r0
    }
}
