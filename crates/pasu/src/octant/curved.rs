//! The curved side of an octant.

use glam::DVec3;

use super::climb::{Climb, Share, power};
use crate::patch::{Breaks, Cell, Patch, Row, Side, Suprema, SurfaceJet};

/// `X(u, v)` on `x^a + y^b + z^c = 1`: `u` from the tip `z = 1` to the plane `z = 0`, `v` from the plane `x = 0` to the plane `y = 0`.
///
/// `1 - z^c` is a share of `u`, of which `x^a` is a share of `v`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curved {
    exponents: [f64; 3],
    down: Share,
    round: Share,
    /// What `x`, `y` and `z` are along `u`.
    along: [Climb; 3],
    /// What `x` and `y` are round `v`.
    across: [Climb; 2],
}

impl Curved {
    pub(super) fn new(exponents: [f64; 3]) -> Curved {
        let [a, b, c] = exponents;
        let down = Share { k: power(&[a, b]), l: power(&[c]) };
        let round = Share { k: power(&[a]), l: power(&[b]) };
        Curved {
            exponents,
            down,
            round,
            along: [down.rising(a), down.rising(b), down.falling(c)],
            across: [round.rising(a), round.falling(b)],
        }
    }

    /// What `x`, `y` and `z` are along `u` on the edges, and `x` and `y` along `v` on the third.
    pub(super) fn edges(&self) -> ([Climb; 3], [Climb; 2]) {
        (self.along, self.across)
    }

    /// How many waves resolve it along `u` and along `v`.
    pub(super) fn waves(&self) -> [f64; 2] {
        [self.down.waves(), self.round.waves()]
    }

    /// Every coordinate rises or falls all along `u` and all along `v`. So of a cell and of its triangles each has the same range, and for a point of one there is one of the other that agrees in it: they are no further apart than
    /// the two other coordinates range. Where an octant has a tip like a needle that is far less than what its second derivatives say.
    fn ranging(&self, cell: Cell, stretch: [f64; 3]) -> f64 {
        let [x, y, z] = self.along.map(|climb| cell.u.map(|u| climb.value(u)));
        let [across, falling] = self.across.map(|climb| cell.v.map(|v| climb.value(v)));
        let ranges = [x[1] * across[1] - x[0] * across[0], y[1] * falling[0] - y[0] * falling[1], z[0] - z[1]];
        let squares: [f64; 3] = core::array::from_fn(|i| (ranges[i] * stretch[i]) * (ranges[i] * stretch[i]));
        let [p, q, r] = squares;
        libm::sqrt((p + q).min(q + r).min(r + p))
    }

    fn jet_of(&self, along: &[[f64; 3]; 3], v: f64) -> SurfaceJet {
        let [x, y] = self.across.map(|climb| climb.jet(v));
        let product = |i: usize, j: usize| {
            DVec3::new(along[0][i] * x[j], along[1][i] * y[j], if j == 0 { along[2][i] } else { 0.0 })
        };
        SurfaceJet {
            position: product(0, 0),
            du: product(1, 0),
            dv: product(0, 1),
            duu: product(2, 0),
            duv: product(1, 1),
            dvv: product(0, 2),
        }
    }
}

/// A curve of one height.
struct Level<'a> {
    patch: &'a Curved,
    along: [[f64; 3]; 3],
}

impl Row for Level<'_> {
    fn length(&self) -> f64 {
        1.0
    }

    fn jet(&self, v: f64) -> SurfaceJet {
        self.patch.jet_of(&self.along, v)
    }
}

impl Patch for Curved {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        self.jet_of(&self.along.map(|climb| climb.jet(u)), v)
    }

    fn row(&self, u: f64) -> Box<dyn Row + '_> {
        Box::new(Level { patch: self, along: self.along.map(|climb| climb.jet(u)) })
    }

    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        let along = self.along.map(|climb| climb.suprema(cell.u));
        let [x, y] = self.across.map(|climb| climb.suprema(cell.v));
        let length = |i: usize, j: usize| {
            let z = if j == 0 { along[2][i] } else { 0.0 };
            (DVec3::new(along[0][i] * x[j], along[1][i] * y[j], z) * DVec3::from_array(stretch)).length()
        };
        Suprema { size: length(0, 0), uu: length(2, 0), uv: length(1, 1), vv: length(0, 2) }
    }

    fn position(&self, u: f64, v: f64) -> DVec3 {
        let [along, other, z] = self.along.map(|climb| climb.value(u));
        let [x, y] = self.across.map(|climb| climb.value(v));
        DVec3::new(along * x, other * y, z)
    }

    fn deviation(&self, cell: Cell, stretch: [f64; 3]) -> f64 {
        self.enclosed(cell, stretch).1
    }

    fn enclosed(&self, cell: Cell, stretch: [f64; 3]) -> (Suprema, f64) {
        let suprema = self.suprema(cell, stretch);
        (suprema, suprema.deviation(cell.lengths()).min(self.ranging(cell, stretch)))
    }

    fn breaks(&self) -> [Breaks; 2] {
        self.waves().map(Breaks::smooth)
    }

    fn sides(&self) -> [Side; 4] {
        let met = |patch: usize| Side::Shared { patch, side: 1, is_reversed: false };
        [Side::Pole, met(3), met(1), met(2)]
    }

    /// Along the gradient of `x^a + y^b + z^c`, against which `X_u x X_v` is. On an edge one of its components may have no bound, and at a tip two: by their logarithms, at the next place inside, the largest is known.
    fn normal_limit(&self, u: f64, v: f64) -> Option<DVec3> {
        let [below, z] = self.down.logarithms(u);
        let [x, y] = self.round.logarithms(v);
        let powers = [below + x, below + y, z];
        // a x^(a - 1) = a (x^a)^(1 - 1/a).
        let gradient: [f64; 3] = core::array::from_fn(|i| {
            let exponent = self.exponents[i];
            libm::log(exponent) + (1.0 - 1.0 / exponent) * powers[i]
        });
        let largest = gradient.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let direction = DVec3::from_array(gradient.map(|component| libm::exp(component - largest)));
        Some(-direction.normalize_or(DVec3::Z))
    }
}
