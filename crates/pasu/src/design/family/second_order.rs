//! ZY01 equations 1 to 8: a round mouth with petals that fade towards the foot.

use std::f64::consts::TAU;

use super::{cos, datum, second, sin};
use crate::design::boundary_value::{BoundaryValue, Datum, Mode, Span};
use crate::design::described::Expanded;
use crate::design::fields::fields;
use crate::design::handles::{Handle, HandleId, Handles, Restraint, steps};
#[cfg(feature = "typescript")]
use crate::design::slider::{Group, Slider};

fields! {
    /// The second order vase of ZY01 eqs 1-8. `u = 0` is the rim, `u = 1` the foot.
    ///
    /// `x(0, v) = r1 cos(a1 v) + r2 cos(a2 v)`, `x(1, v) = r3 cos(a1 v) + r4 cos(a2 v)`, `a_i = 2 pi n_i`; `y` the same
    /// with `sin`; `z` falls in a straight line from `height` to 0. A link starts from figure 1a.
    pub struct SecondOrder, "a shape" {
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
    }
}

impl Expanded for SecondOrder {
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str = "ZY01 equations 1 to 8";
    #[cfg(feature = "typescript")]
    const NAME: &'static str = "SecondOrder";

    #[cfg(feature = "typescript")]
    fn sliders() -> Vec<Slider> {
        PLANAR_SLIDERS.into()
    }

    fn boundary_value(&self) -> BoundaryValue {
        let [x, y] = walls(self.r, self.n, self.force);
        BoundaryValue {
            span: Span::Length(1.0),
            rings: Vec::new(),
            x: second(self.s[0], self.t[0], x),
            y: second(self.s[1], self.t[1], y),
            z: second(1.0, 1.0, vec![cos(0.0, datum((self.height, 0.0), (0.0, 0.0)))]),
        }
    }

    #[inline]
    fn handles(&self) -> Handles {
        let slope = |id| Handle::new(id, Vec::new(), Vec::new()).held([Restraint::SecondOrderSlope]);
        let [rim, foot] = planar_ends();
        Handles::new(self.height >= 0.0, [rim, slope(HandleId::RimSlope), slope(HandleId::FootSlope), foot])
    }
}

/// Rim and foot, shared with the mixed order vase.
#[inline]
pub(super) fn planar_ends() -> [Handle; 2] {
    [
        Handle::new(HandleId::Rim, steps([("r[0]", 1.0)]), steps([("height", 1.0)])),
        Handle::new(HandleId::Foot, steps([("r[2]", 1.0)]), Vec::new()).held([Restraint::FootHeight]),
    ]
}

/// Shared with the mixed order vase, which differs in `z` alone.
#[cfg(feature = "typescript")]
pub(super) const PLANAR_SLIDERS: [Slider; 11] = [
    Slider::of("r", "r_1", Group::Rim, [0.0, 3.0], 0.01).at(0),
    Slider::of("r", "r_2", Group::Rim, [-0.5, 0.5], 0.005).at(1),
    Slider::of("r", "r_3", Group::Foot, [0.0, 3.0], 0.01).at(2),
    Slider::of("r", "r_4", Group::Foot, [-0.5, 0.5], 0.005).at(3),
    Slider::of("height", "h_0", Group::Height, [0.2, 10.0], 0.05),
    Slider::of("n", "n_2", Group::Wall, [0.0, 24.0], 1.0).at(1),
    Slider::of("n", "n_1", Group::Wall, [1.0, 4.0], 1.0).at(0),
    Slider::of("t", "t", Group::Equation, [0.0, 2.0], 0.01).both(),
    Slider::of("s", "s", Group::Equation, [0.1, 10.0], 0.05).both(),
    Slider::of("force", "p_0", Group::Force, [-5.0, 5.0], 0.05).at(0),
    Slider::of("force", "p_1", Group::Force, [-5.0, 5.0], 0.05).at(1),
];

/// The modes of `x` and `y`, shared with the mixed order vase.
///
/// ZY01 eqs 7-8 hold only with the force scaled by `a1^2`, as in its figures: `a1^2 (p0 + p1 u) cos(a1 v)`.
pub(super) fn walls([r1, r2, r3, r4]: [f64; 4], [n1, n2]: [f64; 2], force: [f64; 2]) -> [Vec<Mode>; 2] {
    let a1 = TAU * n1;
    let outline = Datum { force: force.map(|p| a1 * a1 * p).to_vec(), ..datum((r1, 0.0), (r3, 0.0)) };
    let petals = datum((r2, 0.0), (r4, 0.0));
    [vec![cos(n1, outline.clone()), cos(n2, petals.clone())], vec![sin(n1, outline), sin(n2, petals)]]
}
