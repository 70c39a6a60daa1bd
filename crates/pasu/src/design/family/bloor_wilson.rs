//! IA equations 15 to 18: the dint vase, "pasu berlekuk".

use super::{cos, datum, fourth, sin};
use crate::design::boundary_value::{BoundaryValue, Mode, Span};
use crate::design::described::Expanded;
use crate::design::fields::fields;

fields! {
    /// The Bloor-Wilson vase of IA eqs 15-18, `(d2/du2 + a^2 d2/dv2)^2 X = 0`. `u = 0` is the rim, `u = 1` the foot.
    ///
    /// A link starts from figure 2 with one dint, `n1 = 1`.
    pub struct BloorWilson, "a shape" {
        /// The smoothing parameter: how strongly the wall is drawn towards a round tube.
        a: f64 = 0.01, Required, Any;
        /// Radius of the rim, the two parts of its skew, radius of the foot: r1, r2, r3, r4.
        r: [f64; 4] = [1.0, 0.1, 0.1, 0.8], Required, Any;
        /// The slopes that go with r: R1, R2, R3, R4.
        R: [f64; 4] = [-3.0, -0.5, -0.5, 2.0], Required, Any;
        /// The height of the rim and how far its waves rise and fall: h0, h1.
        h: [f64; 2] = [3.0, 0.3], Required, Any;
        /// The slopes that go with h: H0, H1.
        H: [f64; 2] = [-0.5, -0.7], Required, Any;
        /// The number of waves of the rim. The surface closes when it is whole.
        n1: f64 = 1.0, Required, Any;
    }
}

impl Expanded for BloorWilson {
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str = "IA equations 15 to 18";
    #[cfg(feature = "typescript")]
    const NAME: &'static str = "BloorWilson";

    fn boundary_value(&self) -> BoundaryValue {
        let (r, slope) = (self.r, self.R);
        let square = self.a * self.a;
        let equation = [1.0, 2.0 * square, square * square];
        let round = datum((r[0], slope[0]), (r[3], slope[3]));
        let skew = datum((r[1] + r[2], slope[1] + slope[2]), (0.0, 0.0));
        BoundaryValue {
            span: Span::Tau,
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
}
