//! IA equations 15 to 18: the dint vase, "pasu berlekuk".

use super::{cos, datum, fourth, sin};
use crate::design::boundary_value::{BoundaryValue, Mode, Span};
use crate::design::described::Expanded;
use crate::design::fields::fields;
use crate::design::handles::{Handle, HandleId, Handles, Restraint, steps};
#[cfg(feature = "typescript")]
use crate::design::slider::{Group, Slider};

fields! {
    /// The Bloor-Wilson vase of IA eqs 15-18, `(d2/du2 + a^2 d2/dv2)^2 X = 0`. `u = 0` is the rim, `u = 1` the foot.
    ///
    /// A link starts from figure 2 with one dint, `n1 = 1`.
    pub struct BloorWilson, "a shape" {
        /// The smoothing parameter: how strongly the wall is drawn towards a round tube.
        a: f64 = 0.01, Required, Any, One;
        /// Radius of the rim, the two parts of its skew, radius of the foot: r1, r2, r3, r4.
        r: [f64; 4] = [1.0, 0.1, 0.1, 0.8], Required, Any, Length;
        /// The slopes that go with r: R1, R2, R3, R4.
        R: [f64; 4] = [-3.0, -0.5, -0.5, 2.0], Required, Any, Length;
        /// The height of the rim and how far its waves rise and fall: h0, h1.
        h: [f64; 2] = [3.0, 0.3], Required, Any, Length;
        /// The slopes that go with h: H0, H1.
        H: [f64; 2] = [-0.5, -0.7], Required, Any, Length;
        /// The number of waves of the rim. The surface closes when it is whole.
        n1: f64 = 1.0, Required, Any, Waves;
    }
}

impl Expanded for BloorWilson {
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str = "IA equations 15 to 18";
    #[cfg(feature = "typescript")]
    const NAME: &'static str = "BloorWilson";

    #[cfg(feature = "typescript")]
    fn sliders() -> Vec<Slider> {
        vec![
            Slider::of("r", "r_1", Group::Rim, [0.0, 3.0], 0.01).at(0),
            Slider::of("R", "R_1", Group::Rim, [-10.0, 10.0], 0.05).at(0),
            Slider::of("H", "H_0", Group::Rim, [-10.0, 10.0], 0.05).at(0),
            Slider::of("n1", "n_1", Group::Rim, [0.0, 20.0], 1.0),
            Slider::of("h", "h_1", Group::Rim, [-2.0, 2.0], 0.01).at(1),
            Slider::of("H", "H_1", Group::Rim, [-5.0, 5.0], 0.05).at(1),
            Slider::of("r", "r_2", Group::Rim, [-1.0, 1.0], 0.01).at(1),
            Slider::of("r", "r_3", Group::Rim, [-1.0, 1.0], 0.01).at(2),
            Slider::of("r", "r_4", Group::Foot, [0.0, 3.0], 0.01).at(3),
            Slider::of("R", "R_4", Group::Foot, [-10.0, 10.0], 0.05).at(3),
            Slider::of("h", "h_0", Group::Height, [0.2, 10.0], 0.05).at(0),
            Slider::of("R", "R_2", Group::Wall, [-5.0, 5.0], 0.05).at(1),
            Slider::of("R", "R_3", Group::Wall, [-5.0, 5.0], 0.05).at(2),
            Slider::of("a", "a", Group::Equation, [0.0, 15.0], 0.01),
        ]
    }

    fn boundary_value(&self) -> BoundaryValue {
        let (r, slope) = (self.r, self.R);
        let square = self.a * self.a;
        let equation = [1.0, 2.0 * square, square * square];
        let round = datum((r[0], slope[0]), (r[3], slope[3]));
        let skew = datum((r[1] + r[2], slope[1] + slope[2]), (0.0, 0.0));
        BoundaryValue {
            span: Span::Tau,
            rings: Vec::new(),
            x: fourth(equation, vec![Mode { n: 1.0, cos: round.clone(), sin: skew.clone() }]),
            y: fourth(equation, vec![Mode { n: 1.0, cos: skew, sin: round }]),
            z: fourth(
                equation,
                vec![
                    cos(0.0, datum((self.h[0], self.H[0]), (0.0, 0.0))),
                    sin(self.n1, datum((self.h[1], self.H[1]), (0.0, 0.0))),
                ],
            ),
        }
    }

    #[inline]
    fn handles(&self) -> Handles {
        Handles::new(
            self.h[0] >= 0.0,
            [
                Handle::new(HandleId::Rim, steps([("r[0]", 1.0)]), steps([("h[0]", 1.0)])),
                Handle::new(HandleId::RimSlope, steps([("R[0]", 1.0)]), steps([("H[0]", 1.0)])),
                Handle::new(HandleId::FootSlope, steps([("R[3]", 1.0)]), Vec::new()).held([Restraint::LevelFoot]),
                Handle::new(HandleId::Foot, steps([("r[3]", 1.0)]), Vec::new()).held([Restraint::FootHeight]),
            ],
        )
    }
}
