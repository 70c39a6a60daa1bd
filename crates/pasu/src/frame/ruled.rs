//! What goes straight from an edge of one patch to that of another: the rim of a shell.

use std::sync::Arc;

use glam::DVec3;

use super::four_sided::FourSided;
use super::network::along;
use crate::patch::{Breaks, Cell, Patch, Side, Suprema, SurfaceJet};

/// The same side of two patches.
#[derive(Debug)]
pub(super) struct Ruled {
    edges: [Arc<FourSided>; 2],
    side: usize,
    sides: [Side; 4],
}

/// A point of an edge with its first and second derivative along it.
type EdgeJet = [DVec3; 3];

impl Ruled {
    /// `(1 - v) C0(u) + v C1(u)`, with the parameter that runs along the side as `u`.
    pub(super) fn between(edges: [Arc<FourSided>; 2], side: usize, sides: [Side; 4]) -> Ruled {
        Ruled { edges, side, sides }
    }

    fn edges(&self, t: f64) -> [EdgeJet; 2] {
        let (u, v) = [(0.0, t), (1.0, t), (t, 0.0), (t, 1.0)][self.side];
        self.edges.each_ref().map(|patch| {
            let jet = patch.jet(u, v);
            if along(self.side) == 1 { [jet.position, jet.dv, jet.dvv] } else { [jet.position, jet.du, jet.duu] }
        })
    }

    /// The part of the unit square of a patch that its edge is between two places.
    fn on_edge(&self, between: [f64; 2]) -> Cell {
        let end = (self.side % 2) as f64;
        if along(self.side) == 1 { Cell { u: [end; 2], v: between } } else { Cell { u: between, v: [end; 2] } }
    }
}

impl Patch for Ruled {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        let [[p, p1, p2], [q, q1, q2]] = self.edges(u);
        let between = |from: DVec3, to: DVec3| from * (1.0 - v) + to * v;
        SurfaceJet {
            position: between(p, q),
            du: between(p1, q1),
            dv: q - p,
            duu: between(p2, q2),
            duv: q1 - p1,
            dvv: DVec3::ZERO,
        }
    }

    /// Of `X_uv`, the difference of both tangents, by its value in the middle and how far it can change from there.
    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        let edge = self.on_edge(cell.u);
        let bounds = self.edges.each_ref().map(|patch| {
            let Suprema { size, uu, vv, .. } = patch.suprema(edge, stretch);
            (size, if along(self.side) == 1 { vv } else { uu })
        });
        let [(one, bend), (other, other_bend)] = bounds;
        let [from, to] = cell.u;
        let [[_, p1, _], [_, q1, _]] = self.edges(0.5 * (from + to));
        let apart = ((q1 - p1) * DVec3::from_array(stretch)).length();
        Suprema {
            size: one.max(other),
            uu: bend.max(other_bend),
            uv: apart + 0.5 * (to - from) * (bend + other_bend),
            vv: 0.0,
        }
    }

    fn breaks(&self) -> [Breaks; 2] {
        let [one, other] = self.edges.each_ref().map(|patch| patch.breaks()[along(self.side)].clone());
        let mut knots = one.knots;
        knots.extend(other.knots);
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        [Breaks { knots, ..Breaks::smooth(one.waves.max(other.waves)) }, Breaks::smooth(0.5)]
    }

    fn sides(&self) -> [Side; 4] {
        self.sides
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from -1 to 1 that look random.
    fn dice(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(seed: &mut u64) -> DVec3 {
        DVec3::new(dice(seed), dice(seed), dice(seed))
    }

    fn four_sided(seed: &mut u64) -> Arc<FourSided> {
        let points = core::array::from_fn(|_| vector(seed));
        Arc::new(FourSided::new(points, [vector(seed), vector(seed)], [Side::Free; 4]))
    }

    #[test]
    fn it_goes_from_edge_to_edge_and_its_suprema_are_inequalities() {
        let (mut seed, stretch) = (3, DVec3::new(1.0, 2.0, 0.5));
        for round in 0..200 {
            let (one, other) = (four_sided(&mut seed), four_sided(&mut seed));
            let side = round % 4;
            let rim = Ruled::between([Arc::clone(&one), Arc::clone(&other)], side, [Side::Free; 4]);
            let at = |t: f64| [(0.0, t), (1.0, t), (t, 0.0), (t, 1.0)][side];
            let interval = |seed: &mut u64| {
                let from = 0.45 + 0.45 * dice(seed);
                [from, from + (1.0 - from) * (0.5 + 0.5 * dice(seed))]
            };
            let cell = Cell { u: interval(&mut seed), v: interval(&mut seed) };
            let bounds = rim.suprema(cell, stretch.to_array());
            for k in 0..100 {
                let (p, q) = (f64::from(k / 10) / 9.0, f64::from(k % 10) / 9.0);
                let (u, v) = (cell.u[0] + p * (cell.u[1] - cell.u[0]), cell.v[0] + q * (cell.v[1] - cell.v[0]));
                let jet = rim.jet(u, v);
                let found =
                    [(jet.position, bounds.size), (jet.duu, bounds.uu), (jet.duv, bounds.uv), (jet.dvv, bounds.vv)];
                for (vector, most) in found {
                    assert!((vector * stretch).length() <= most * (1.0 + 1e-12), "{round}: {vector} {most}");
                }
                let h = 1e-5;
                let slope = (rim.jet(u + h, v).position - rim.jet(u - h, v).position) / (2.0 * h);
                assert!((slope - jet.du).length() < 1e-6, "{round}: {slope} {}", jet.du);
                let (x, y) = at(u);
                assert_eq!(rim.jet(u, 0.0).position, one.jet(x, y).position);
                assert_eq!(rim.jet(u, 1.0).position, other.jet(x, y).position);
                assert_eq!(rim.jet(u, v).dv, other.jet(x, y).position - one.jet(x, y).position);
            }
            // Never larger on a smaller cell.
            let half = Cell { u: [cell.u[0], 0.5 * (cell.u[0] + cell.u[1])], v: cell.v };
            let smaller = rim.suprema(half, stretch.to_array());
            let pairs = [(smaller.size, bounds.size), (smaller.uu, bounds.uu), (smaller.uv, bounds.uv)];
            assert!(
                pairs.iter().all(|(small, large)| *small <= large * (1.0 + 1e-12)),
                "{round}: {smaller:?} {bounds:?}"
            );
        }
    }
}
