//! A flat side of an octant.

use glam::DVec3;

use super::climb::Climb;
use super::lines::Lines;
use crate::patch::{Breaks, Cell, Patch, Side, Suprema, SurfaceJet};

/// `X(t, s) = t (f(s), g(s))` in the plane of two axes: the rays from the origin to the curve in which the curved side meets the plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Flat {
    /// The axes of the plane.
    axes: [usize; 2],
    curve: [Climb; 2],
    waves: f64,
    sides: [Side; 4],
    /// Along `X_t x X_s`.
    normal: DVec3,
    /// What the curve is where rays meet it.
    rays: Lines<2>,
}

impl Flat {
    /// `normal` is where `X_t x X_s` points.
    pub(super) fn new(axes: [usize; 2], curve: [Climb; 2], waves: f64, sides: [Side; 4], normal: DVec3) -> Flat {
        Flat { axes, curve, waves, sides, normal, rays: Lines::default() }
    }

    fn vector(&self, [one, other]: [f64; 2]) -> DVec3 {
        let mut vector = DVec3::ZERO;
        (vector[self.axes[0]], vector[self.axes[1]]) = (one, other);
        vector
    }
}

impl Patch for Flat {
    fn jet(&self, t: f64, s: f64) -> SurfaceJet {
        let curve = self.rays.at(s, &self.curve);
        let [at, along, bend] = [0, 1, 2].map(|order| self.vector(curve.map(|jet| jet[order])));
        SurfaceJet { position: t * at, du: at, dv: t * along, duu: DVec3::ZERO, duv: along, dvv: t * bend }
    }

    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        let curve = self.curve.map(|climb| climb.suprema(cell.v));
        let t = cell.u[1];
        let length =
            |order: usize| (self.vector(curve.map(|bounds| bounds[order])) * DVec3::from_array(stretch)).length();
        Suprema { size: t * length(0), uu: 0.0, uv: length(1), vv: t * length(2) }
    }

    fn position(&self, t: f64, s: f64) -> DVec3 {
        t * self.vector(self.curve.map(|climb| climb.value(s)))
    }

    fn deviation(&self, cell: Cell, stretch: [f64; 3]) -> f64 {
        self.enclosed(cell, stretch).1
    }

    /// A cell is a quadrilateral between two rays, but for what lies between its arcs and their chords: the two triangles are all of it, wherever on it a point of theirs is that of the patch.
    ///
    /// One coordinate of an arc rises and the other falls. Where one is the same on arc and chord the other differs by no more than it ranges, which near a tip like a needle is far less than what second derivatives say.
    fn enclosed(&self, cell: Cell, stretch: [f64; 3]) -> (Suprema, f64) {
        let suprema = self.suprema(cell, stretch);
        let bent = Suprema { uv: 0.0, ..suprema }.deviation(cell.lengths());
        let range = |i: usize| {
            let [from, to] = cell.v.map(|s| self.curve[i].value(s));
            cell.u[1] * (to - from).abs() * stretch[self.axes[i]]
        };
        (suprema, bent.min(range(0)).min(range(1)))
    }

    fn breaks(&self) -> [Breaks; 2] {
        [Breaks::smooth(0.5), Breaks::smooth(self.waves)]
    }

    fn sides(&self) -> [Side; 4] {
        self.sides
    }

    fn normal_limit(&self, _: f64, _: f64) -> Option<DVec3> {
        Some(self.normal)
    }
}
