//! One patch of a network.

use glam::DVec3;

use super::bump::Bump;
use super::network::{SIDES, along};
use crate::patch::{Breaks, Cell, Patch, Row, SAME_LINE, Side, Suprema, SurfaceJet};

/// `C0 + C1 u + C2 u^2 + C3 u^3 + C4 v + C5 v^2 + C6 v^3 + C7 u v + C8 u^2 v + C9 u v^2` through eight points (W22 eq 3), and what sculpts it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FourSided {
    points: [DVec3; 8],
    coefficients: [DVec3; 10],
    sides: [Side; 4],
    bumps: Vec<Bump>,
}

/// The coefficients of `u v^2` and of `u^2 v`, which the points decide alone.
pub(super) fn mixed(p: &[DVec3; 8]) -> [DVec3; 2] {
    let bend = |from: usize, middle: usize, to: usize| (p[from] - p[middle]) + (p[to] - p[middle]);
    [2.0 * (bend(2, 3, 4) - bend(0, 7, 6)), 2.0 * (bend(6, 5, 4) - bend(0, 1, 2))]
}

/// `t (t - 1/2) (t - 1)`, which is 0 at the points of an edge and the negative of itself from the other end: what a cubic term adds to every curve along it.
fn cubic(t: f64) -> f64 {
    let s = 1.0 - t;
    -0.5 * (t * s) * (t - s)
}

impl FourSided {
    /// Through these points, with the coefficients of `u^3` and of `v^3`.
    pub(super) fn new(points: [DVec3; 8], [c3, c6]: [DVec3; 2], sides: [Side; 4]) -> FourSided {
        let p = &points;
        let [c9, c8] = mixed(p);
        // Along the two sides through the first corner: from there, by way of the middle.
        let along = |middle: DVec3, to: DVec3, cubic: DVec3| {
            let (middle, to) = (middle - p[0], to - p[0]);
            (4.0 * middle - to + 0.5 * cubic, 2.0 * to - 4.0 * middle - 1.5 * cubic)
        };
        let ((c1, c2), (c4, c5)) = (along(p[1], p[2], c3), along(p[7], p[6], c6));
        // Across: what is left at the far corner.
        let c7 = ((p[4] - p[2]) - (p[6] - p[0])) - c8 - c9;
        FourSided { points, coefficients: [p[0], c1, c2, c3, c4, c5, c6, c7, c8, c9], sides, bumps: Vec::new() }
    }

    /// Sculpts it.
    pub(super) fn add(&mut self, bump: Bump) {
        self.bumps.push(bump);
    }

    /// Where along `u` or along `v` a derivative of it jumps, and how many waves it has at most.
    fn breaks_along(&self, direction: usize) -> Breaks {
        let rims = self.bumps.iter().flat_map(|bump| bump.sides[direction]);
        let mut knots: Vec<f64> = rims.filter(|rim| SAME_LINE < *rim && *rim < 1.0 - SAME_LINE).collect();
        knots.sort_by(f64::total_cmp);
        knots.dedup_by(|next, kept| *next - *kept <= SAME_LINE);
        // Half the degree.
        let waves = self.bumps.iter().map(|bump| bump.waves(direction)).fold(1.5, f64::max);
        Breaks { knots, ..Breaks::smooth(waves) }
    }

    /// The coefficients of `u^3` and of `v^3`.
    pub(super) fn cubic(&self) -> [DVec3; 2] {
        [self.coefficients[3], self.coefficients[6]]
    }

    /// The same forces on other points and with other cubic terms.
    pub(super) fn moved(&self, points: [DVec3; 8], cubic: [DVec3; 2]) -> FourSided {
        FourSided { bumps: self.bumps.clone(), ..FourSided::new(points, cubic, self.sides) }
    }

    /// The same with what its sides meet.
    pub(super) fn between(&self, sides: [Side; 4]) -> FourSided {
        FourSided { sides, ..self.clone() }
    }

    /// The points of its frame.
    pub(super) fn points(&self) -> [DVec3; 8] {
        self.points
    }

    /// Whether every number of it is one.
    pub(super) fn is_finite(&self) -> bool {
        let bumps = self.bumps.iter().map(|bump| bump.amplitude);
        self.coefficients.iter().copied().chain(bumps).all(DVec3::is_finite)
    }

    /// A point of a side. It depends on the points and the cubic term of that side alone, so that whoever has the same from the other end has the same bits, and is exact at the points.
    fn on_side(&self, side: usize, t: f64) -> DVec3 {
        let [from, middle, to] = SIDES[side].map(|place| self.points[place]);
        let (s, c) = (1.0 - t, self.coefficients[[3, 6][along(side)]]);
        let ends = from * (s * (s - t)) + to * (t * (t - s));
        ends + middle * (4.0 * (t * s)) + c * cubic(t)
    }

    /// `X_uu`, `X_uv`, `X_vv`, all of which are linear in `u` and in `v`.
    fn second(&self, u: f64, v: f64) -> [DVec3; 3] {
        let [_, _, c2, c3, _, c5, c6, c7, c8, c9] = self.coefficients;
        [2.0 * (c2 + v * c8) + 6.0 * u * c3, c7 + 2.0 * (u * c8 + v * c9), 2.0 * (c5 + u * c9) + 6.0 * v * c6]
    }

    /// Suprema of the second derivatives on a cell: what is linear is longest at a corner.
    fn seconds(&self, cell: Cell, stretch: DVec3) -> [f64; 3] {
        let mut longest = [0.0f64; 3];
        for u in cell.u {
            for v in cell.v {
                for (longest, second) in longest.iter_mut().zip(self.second(u, v)) {
                    *longest = longest.max((second * stretch).length_squared());
                }
            }
        }
        longest.map(libm::sqrt)
    }

    /// No point is longer than the longest of the control points of the patch in Bernstein's form, within whose hull it lies.
    fn size(&self, stretch: DVec3) -> f64 {
        const RISING: [[f64; 4]; 4] =
            [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0 / 3.0, 0.0, 0.0], [1.0, 2.0 / 3.0, 1.0 / 3.0, 0.0], [1.0; 4]];
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = self.coefficients;
        let monomials = [
            [c0, c4, c5, c6],
            [c1, c7, c9, DVec3::ZERO],
            [c2, c8, DVec3::ZERO, DVec3::ZERO],
            [c3, DVec3::ZERO, DVec3::ZERO, DVec3::ZERO],
        ];
        let mut longest = 0.0f64;
        for along in RISING {
            let row: [DVec3; 4] = core::array::from_fn(|l| (0..4).map(|k| along[k] * monomials[k][l]).sum());
            for across in RISING {
                let point: DVec3 = (0..4).map(|l| across[l] * row[l]).sum();
                longest = longest.max((point * stretch).length_squared());
            }
        }
        libm::sqrt(longest)
    }
}

/// A curve of constant `u`: polynomials in `v`.
pub(super) struct Curve<'a> {
    patch: &'a FourSided,
    u: f64,
    position: [DVec3; 4],
    du: [DVec3; 3],
    duu: [DVec3; 2],
    /// The bumps that this curve runs over, with their waves along `u`.
    bumps: Vec<(&'a Bump, [f64; 3])>,
}

impl Row for Curve<'_> {
    fn length(&self) -> f64 {
        1.0
    }

    fn jet(&self, v: f64) -> SurfaceJet {
        let ([a0, a1, a2, a3], [b0, b1, b2], [c0, c1]) = (self.position, self.du, self.duu);
        let position = match (self.u, v) {
            (0.0, _) => self.patch.on_side(0, v),
            (1.0, _) => self.patch.on_side(1, v),
            (u, 0.0) => self.patch.on_side(2, u),
            (u, 1.0) => self.patch.on_side(3, u),
            _ => a0 + v * (a1 + v * (a2 + v * a3)),
        };
        let mut jet = SurfaceJet {
            position,
            du: b0 + v * (b1 + v * b2),
            dv: a1 + v * (2.0 * a2 + v * (3.0 * a3)),
            duu: c0 + v * c1,
            duv: b1 + v * (2.0 * b2),
            dvv: 2.0 * a2 + v * (6.0 * a3),
        };
        for (bump, along) in &self.bumps {
            if let Some(across) = bump.wave(1, v) {
                bump.add(along, &across, &mut jet);
            }
        }
        jet
    }
}

impl Patch for FourSided {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        self.curve(u).jet(v)
    }

    fn row(&self, u: f64) -> Box<dyn Row + '_> {
        Box::new(self.curve(u))
    }

    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        let stretch = DVec3::from_array(stretch);
        let [uu, uv, vv] = self.seconds(cell, stretch);
        let smooth = Suprema { size: self.size(stretch), uu, uv, vv };
        self.bumps.iter().map(|bump| bump.suprema(cell, stretch)).fold(smooth, |sum, bump| Suprema {
            size: sum.size + bump.size,
            uu: sum.uu + bump.uu,
            uv: sum.uv + bump.uv,
            vv: sum.vv + bump.vv,
        })
    }

    fn deviation(&self, cell: Cell, stretch: [f64; 3]) -> f64 {
        let stretch = DVec3::from_array(stretch);
        let [uu, uv, vv] = self.seconds(cell, stretch);
        let smooth = Suprema { size: 0.0, uu, uv, vv }.deviation(cell.lengths());
        self.bumps.iter().map(|bump| bump.deviation(cell, stretch)).fold(smooth, |sum, deviation| sum + deviation)
    }

    fn breaks(&self) -> [Breaks; 2] {
        [0, 1].map(|direction| self.breaks_along(direction))
    }

    fn sides(&self) -> [Side; 4] {
        self.sides
    }
}

impl FourSided {
    /// The curve of one `u`.
    pub(super) fn curve(&self, u: f64) -> Curve<'_> {
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = self.coefficients;
        Curve {
            patch: self,
            u,
            position: [c0 + u * (c1 + u * (c2 + u * c3)), c4 + u * (c7 + u * c8), c5 + u * c9, c6],
            du: [c1 + u * (2.0 * c2 + u * (3.0 * c3)), c7 + u * (2.0 * c8), c9],
            duu: [2.0 * c2 + u * (6.0 * c3), 2.0 * c8],
            bumps: self.bumps.iter().filter_map(|bump| Some((bump, bump.wave(0, u)?))).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Falloff;

    /// Numbers from 0 to 1 that look random.
    fn dice(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(seed: &mut u64) -> DVec3 {
        DVec3::new(dice(seed), dice(seed), dice(seed)) - 0.5
    }

    fn sculpted(seed: &mut u64) -> FourSided {
        let flat = [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0), (0.5, 1.0), (0.0, 1.0), (0.0, 0.5)];
        let points = flat.map(|(x, y)| DVec3::new(x, y, 0.0) + vector(seed));
        let mut patch = FourSided::new(points, [vector(seed), vector(seed)], [Side::Free; 4]);
        for falloff in [Falloff::Sine, Falloff::Smooth, Falloff::Sine] {
            let side = |seed: &mut u64| {
                let from = 1.5 * dice(seed) - 0.5;
                [from, from + 0.1 + dice(seed)]
            };
            patch.add(Bump { amplitude: vector(seed), sides: [side(seed), side(seed)], falloff });
        }
        patch
    }

    #[test]
    fn derivatives_are_those_of_the_position() {
        let mut seed = 1;
        for _ in 0..40 {
            let patch = sculpted(&mut seed);
            let knots = patch.breaks().map(|breaks| breaks.knots);
            for _ in 0..20 {
                let (u, v, h) = (0.01 + 0.98 * dice(&mut seed), 0.01 + 0.98 * dice(&mut seed), 1e-5);
                if [(0, u), (1, v)].iter().any(|(k, at)| knots[*k].iter().any(|knot| (knot - at).abs() < 2.0 * h)) {
                    continue;
                }
                let at = |u: f64, v: f64| patch.jet(u, v);
                let slope = |of: fn(&SurfaceJet) -> DVec3, du: f64, dv: f64| {
                    (of(&at(u + du, v + dv)) - of(&at(u - du, v - dv))) / (2.0 * h)
                };
                let jet = at(u, v);
                let near =
                    |found: DVec3, expected: DVec3| assert!(found.distance(expected) < 1e-4, "{found} {expected}");
                near(jet.du, slope(|jet| jet.position, h, 0.0));
                near(jet.dv, slope(|jet| jet.position, 0.0, h));
                near(jet.duu, slope(|jet| jet.du, h, 0.0));
                near(jet.duv, slope(|jet| jet.du, 0.0, h));
                near(jet.dvv, slope(|jet| jet.dv, 0.0, h));
            }
            for k in 0..8 {
                let at =
                    [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0), (0.5, 1.0), (0.0, 1.0), (0.0, 0.5)][k];
                let mut plain = patch.clone();
                plain.bumps.clear();
                assert_eq!(plain.jet(at.0, at.1).position, patch.points[k], "a patch goes through its points");
            }
        }
    }

    #[test]
    fn suprema_and_deviations_are_inequalities() {
        let (mut seed, stretch) = (7, [1.0, 2.0, 0.5]);
        let mut closest = 0.0f64;
        for _ in 0..300 {
            let patch = sculpted(&mut seed);
            let side = |seed: &mut u64| {
                let from = 0.9 * dice(seed);
                [from, from + (1.0 - from) * dice(seed)]
            };
            let cell = Cell { u: side(&mut seed), v: side(&mut seed) };
            let (suprema, deviation) = (patch.suprema(cell, stretch), patch.deviation(cell, stretch));
            let stretched = |v: DVec3| (v * DVec3::from_array(stretch)).length();
            let corner = |i: usize, j: usize| patch.jet(cell.u[i], cell.v[j]).position;
            let n = 24;
            for (i, j) in (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))) {
                let (p, q) = (i as f64 / n as f64, j as f64 / n as f64);
                let [u, v] = [(cell.u, p), (cell.v, q)].map(|([from, to], part)| from + part * (to - from));
                let jet = patch.jet(u, v);
                for (length, most) in
                    [(jet.position, suprema.size), (jet.duu, suprema.uu), (jet.duv, suprema.uv), (jet.dvv, suprema.vv)]
                {
                    assert!(stretched(length) <= most * (1.0 + 1e-12) + 1e-12, "{} {most}", stretched(length));
                }
                // On either diagonal.
                let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                let first = if q <= p { a + p * (b - a) + q * (c - b) } else { a + q * (d - a) + p * (c - d) };
                let second = if p + q <= 1.0 {
                    a + p * (b - a) + q * (d - a)
                } else {
                    c + (1.0 - p) * (d - c) + (1.0 - q) * (b - c)
                };
                for flat in [first, second] {
                    let off = stretched(jet.position - flat);
                    assert!(off <= deviation * (1.0 + 1e-12) + 1e-12, "{off} {deviation}");
                    closest = closest.max(off / deviation);
                }
            }
        }
        assert!(closest > 0.3, "{closest} of what was told is all that there was");
    }
}
