//! What a sculpting force adds to a patch: a swelling on a rectangle of its parameters (W22 eq 4, and one without a crease).

use core::f64::consts::PI;

use glam::DVec3;

use crate::design::Falloff;
use crate::patch::{Cell, SAME_LINE, Suprema, SurfaceJet};

/// `amplitude f(p) f(q)`, `p` and `q` from 0 to 1 across the rectangle, and 0 outside it. Both forms of `f` are the same from either end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bump {
    pub(super) amplitude: DVec3,
    /// From where to where along `u` and along `v` of the patch, of which a rectangle that spans several has but a part within (0, 1).
    pub(super) sides: [[f64; 2]; 2],
    pub(super) falloff: Falloff,
}

/// `f` and its first and second derivatives by the parameter of the patch, where it is not 0 all round.
type Wave = [f64; 3];

impl Bump {
    /// How many waves it has from one end of its patch to the other, along `u` or along `v`.
    pub(super) fn waves(&self, along: usize) -> f64 {
        let [from, to] = self.sides[along];
        match self.falloff {
            Falloff::Sine => 0.5 / (to - from),
            Falloff::Smooth => 1.0 / (to - from),
        }
    }

    /// Whether the surface has a crease along its rim.
    pub(super) fn has_crease(&self) -> bool {
        self.falloff == Falloff::Sine
    }

    /// `f` along `u` or along `v`; `None` beyond the rectangle. At the rim the side within counts.
    pub(super) fn wave(&self, along: usize, at: f64) -> Option<Wave> {
        let [from, to] = self.sides[along];
        let rate = PI / (to - from);
        let p = (at - from) / (to - from);
        if !(0.0..=1.0).contains(&p) {
            return None;
        }
        // From the nearer end: 0 there without rounding.
        let (s, c) = libm::sincos(PI * p.min(1.0 - p));
        let c = if p > 0.5 { -c } else { c };
        Some(match self.falloff {
            Falloff::Sine => [s, rate * c, -rate * rate * s],
            Falloff::Smooth => [s * s, 2.0 * rate * s * c, 2.0 * rate * rate * (c * c - s * s)],
        })
    }

    /// Adds itself to a jet, by its waves along `u` and along `v`.
    pub(super) fn add(&self, u: &Wave, v: &Wave, jet: &mut SurfaceJet) {
        jet.position += self.amplitude * (u[0] * v[0]);
        jet.du += self.amplitude * (u[1] * v[0]);
        jet.dv += self.amplitude * (u[0] * v[1]);
        jet.duu += self.amplitude * (u[2] * v[0]);
        jet.duv += self.amplitude * (u[1] * v[1]);
        jet.dvv += self.amplitude * (u[0] * v[2]);
    }

    /// Suprema of `|f|`, `|f'|` and `|f''|` between two parameters; `None` where the rectangle does not reach.
    fn suprema_along(&self, along: usize, [low, high]: [f64; 2]) -> Option<Wave> {
        let [from, to] = self.sides[along];
        let (rate, width) = (PI / (to - from), to - from);
        let [p, q] = [(low - from) / width, (high - from) / width].map(|p| p.clamp(0.0, 1.0));
        if !(p < q) {
            return None;
        }
        let ends = [p, q].map(|p| libm::sincos(PI * p));
        // The largest of a sine between its ends, unless a crest lies between them.
        let most = |crests: &[f64], of: fn((f64, f64)) -> f64| {
            let is_crest = crests.iter().any(|crest| (p..=q).contains(crest));
            if is_crest { 1.0 } else { ends.map(of).into_iter().map(f64::abs).fold(0.0, f64::max) }
        };
        Some(match self.falloff {
            Falloff::Sine => {
                let (s, c) = (most(&[0.5], |(s, _)| s), most(&[], |(_, c)| c));
                [s, rate * c, rate * rate * s]
            }
            Falloff::Smooth => {
                let s = most(&[0.5], |(s, _)| s);
                let (sine, cosine) = (most(&[0.25, 0.75], |(s, c)| 2.0 * s * c), most(&[0.5], |(s, c)| c * c - s * s));
                [s * s, rate * sine, 2.0 * rate * rate * cosine]
            }
        })
    }

    /// Suprema on a cell of what it adds, with the axes stretched.
    pub(super) fn suprema(&self, cell: Cell, stretch: DVec3) -> Suprema {
        let (Some(u), Some(v)) = (self.suprema_along(0, cell.u), self.suprema_along(1, cell.v)) else {
            return Suprema::default();
        };
        let size = (self.amplitude * stretch).length();
        Suprema { size: size * u[0] * v[0], uu: size * u[2] * v[0], uv: size * u[1] * v[1], vv: size * u[0] * v[2] }
    }

    /// How far what it adds and its linear interpolants on the two triangles of a cell are apart at most.
    ///
    /// It is nowhere negative along its amplitude and nowhere more than its supremum, and so are they. Where it has no crease inside the cell, its second derivatives say it more closely.
    pub(super) fn deviation(&self, cell: Cell, stretch: DVec3) -> f64 {
        let suprema = self.suprema(cell, stretch);
        let mut slack = 0.0;
        if self.has_crease() {
            for (along, [low, high]) in [cell.u, cell.v].into_iter().enumerate() {
                let [from, to] = self.sides[along];
                // A rim that is nearer to a line than lines are to each other is on it: what the slope turns by there acts on no more than that.
                let inside = |rim: f64| (rim - low).min(high - rim);
                let nearest = inside(from).max(inside(to));
                if nearest > SAME_LINE {
                    return suprema.size;
                }
                if nearest > 0.0 {
                    slack += (self.amplitude * stretch).length() * PI / (to - from) * SAME_LINE;
                }
            }
        }
        suprema.size.min(suprema.deviation(cell.lengths()) + slack)
    }
}
