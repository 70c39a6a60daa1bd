//! ZY01 equations 9 to 12: the second order vase with a fourth order height.

#[cfg(feature = "typescript")]
use super::second_order::PLANAR_SLIDERS;
use super::second_order::{planar_ends, walls};
use super::{cos, datum, fourth, second};
use crate::design::boundary_value::{BoundaryValue, Span};
use crate::design::described::Expanded;
use crate::design::fields::fields;
use crate::design::handles::{Handle, HandleId, Handles, Restraint, steps};
#[cfg(feature = "typescript")]
use crate::design::slider::{Group, Slider};

fields! {
    /// The mixed order vase of ZY01 eqs 9-12: as [`SecondOrder`](crate::SecondOrder), but `z` solves the fourth order
    /// equation with `z(0) = height`, `z_u(0) = rise`, `z(1) = 0`, `z_u(1) = 0`. A link starts from figure 4a.
    pub struct MixedOrder, "a shape" {
        /// Radius and petals of the rim, radius and petals of the foot: r1, r2, r3, r4.
        r: [f64; 4] = [1.0, 0.1, 0.6, 0.06], Required, Any, Length;
        /// How often the outline and its petals go round: n1, n2. The surface closes when both are whole.
        n: [f64; 2] = [1.0, 8.0], Optional, Any, Waves;
        /// The height of the rim above the foot.
        height: f64 = 3.6, Optional, Any, Length;
        /// Shape control parameters of the second derivative along the profile, for x and for y.
        s: [f64; 2] = [1.0, 1.0], Optional, NotZero, One;
        /// Shape control parameters of the second derivative round the pot, for x and for y.
        t: [f64; 2] = [0.5, 0.5], Optional, Any, One;
        /// Sculpting force on the outline: p0 + p1 u.
        force: [f64; 2] = [0.0, 0.0], Optional, Any, One;
        /// The slope of the height at the rim: h0'.
        rise: f64 = -10.0, Required, Any, Length;
    }
}

impl Expanded for MixedOrder {
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str = "ZY01 equations 9 to 12";
    #[cfg(feature = "typescript")]
    const NAME: &'static str = "MixedOrder";

    #[cfg(feature = "typescript")]
    fn sliders() -> Vec<Slider> {
        let rise = Slider::of("rise", "h_0'", Group::Rim, [-20.0, 20.0], 0.1);
        PLANAR_SLIDERS.into_iter().chain([rise]).collect()
    }

    fn boundary_value(&self) -> BoundaryValue {
        let [x, y] = walls(self.r, self.n, self.force);
        BoundaryValue {
            span: Span::Length(1.0),
            rings: Vec::new(),
            x: second(self.s[0], self.t[0], x),
            y: second(self.s[1], self.t[1], y),
            z: fourth([1.0; 3], vec![cos(0.0, datum((self.height, self.rise), (0.0, 0.0)))]),
        }
    }

    #[inline]
    fn handles(&self) -> Handles {
        let [rim, foot] = planar_ends();
        let rim_slope = Handle::new(HandleId::RimSlope, Vec::new(), steps([("rise", 1.0)]));
        let foot_slope = Handle::new(HandleId::FootSlope, Vec::new(), Vec::new());
        Handles::new(
            self.height >= 0.0,
            [rim, rim_slope.held([Restraint::MixedOrderLean]), foot_slope.held([Restraint::MixedOrderFoot]), foot],
        )
    }
}
