//! An octant with what goes round it.

use glam::DVec3;

use super::curved::Curved;
use super::flat::Flat;
use super::inside::{self, Through};
use super::moments::moments;
use crate::design::Octant;
use crate::patch::{Patch, Side};

/// A solved octant of a supersphere.
#[derive(Debug)]
pub(crate) struct Supersphere {
    exponents: [f64; 3],
    curved: Curved,
    flat: [Flat; 3],
}

/// For the curved side and those in the planes `x = 0`, `y = 0` and `z = 0` whether `X_u x X_v` points away from the inside.
const IS_OUTWARD: [bool; 4] = [false, true, false, true];

impl Supersphere {
    pub(crate) fn new(octant: &Octant) -> Supersphere {
        let curved = Curved::new(octant.exponents);
        let ([x, y, z], [across, other]) = curved.edges();
        let [along, round] = curved.waves();
        let met = |patch: usize, side: usize| Side::Shared { patch, side, is_reversed: false };
        let flat = [
            Flat::new([1, 2], [y, z], along, [Side::Pole, met(0, 2), met(2, 2), met(3, 2)], DVec3::NEG_X),
            Flat::new([0, 2], [x, z], along, [Side::Pole, met(0, 3), met(1, 2), met(3, 3)], DVec3::Y),
            Flat::new([0, 1], [across, other], round, [Side::Pole, met(0, 1), met(1, 3), met(2, 3)], DVec3::NEG_Z),
        ];
        Supersphere { exponents: octant.exponents, curved, flat }
    }

    /// One of the patches; the first in place of one that there is not.
    pub(crate) fn patch(&self, index: usize) -> &dyn Patch {
        match index {
            1..=3 => &self.flat[index - 1],
            _ => &self.curved,
        }
    }

    /// The number of patches.
    pub(crate) fn n_patches(&self) -> usize {
        1 + self.flat.len()
    }

    /// For each patch whether `X_u x X_v` points away from the inside.
    pub(crate) fn is_outward(&self) -> Vec<bool> {
        IS_OUTWARD.to_vec()
    }

    /// Its volume and its first moments.
    pub(crate) fn moments(&self) -> (f64, DVec3) {
        let (volume, first) = moments(self.exponents);
        (volume, DVec3::from_array(first))
    }

    /// Whether a point is in it, its border included.
    pub(crate) fn holds(&self, at: DVec3) -> bool {
        at.min_element() >= 0.0 && self.excess(at) <= 0.0
    }

    /// Where the line `origin + t direction` goes through its border, in the order of `t`.
    pub(crate) fn through(&self, origin: DVec3, direction: DVec3) -> Vec<Through> {
        inside::through(self.exponents, origin, direction)
    }

    /// The unit normal out of it at a point of one of its patches.
    pub(crate) fn normal(&self, at: DVec3, patch: usize) -> DVec3 {
        inside::normal(self.exponents, at, patch)
    }

    /// A point well inside.
    pub(crate) fn core(&self) -> DVec3 {
        inside::core(self.exponents)
    }

    /// Whether all of a box along its axes is in it.
    pub(crate) fn holds_box(&self, low: DVec3, high: DVec3) -> bool {
        inside::holds_box(self.exponents, low, high)
    }

    /// Whether no point of a box along its axes is in it.
    pub(crate) fn misses_box(&self, low: DVec3, high: DVec3) -> bool {
        inside::misses_box(self.exponents, low, high)
    }

    /// How far it reaches in a direction at most, with a place about it that is all but as far.
    pub(crate) fn reach(&self, direction: DVec3) -> (f64, DVec3) {
        inside::reach(self.exponents, direction)
    }

    /// Whether it thins out towards an edge like a blade, as it does where an exponent is below 1.
    pub(crate) fn has_blades(&self) -> bool {
        self.exponents.iter().any(|exponent| *exponent < 1.0)
    }

    /// A place of it that is near to a point.
    pub(crate) fn place_near(&self, at: DVec3) -> DVec3 {
        inside::place_near(self.exponents, at)
    }

    /// The place of the curved side where `x^a`, `y^b` and `z^c` are these shares of 1.
    pub(crate) fn shared(&self, shares: [f64; 3]) -> DVec3 {
        DVec3::from_array(core::array::from_fn(|i| libm::pow(shares[i], 1.0 / self.exponents[i])))
    }

    /// `x^a + y^b + z^c - 1` where no coordinate is negative: at most 0 in the octant, and 0 on its curved side.
    fn excess(&self, at: DVec3) -> f64 {
        inside::excess(self.exponents, at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::gauss_legendre::FOUR;

    fn octant(exponents: [f64; 3]) -> Supersphere {
        Supersphere::new(&Octant { exponents })
    }

    const SOME: [[f64; 3]; 8] = [
        [2.0, 2.0, 2.0],
        [1.0, 1.0, 1.0],
        [0.5, 0.7, 1.4],
        [0.05, 2.0, 50.0],
        [50.0, 50.0, 50.0],
        [3.0, 1.5, 0.9],
        [50.0, 0.05, 2.0],
        [0.05, 0.05, 0.05],
    ];

    #[test]
    fn every_patch_lies_on_its_surface() {
        for exponents in SOME {
            let octant = octant(exponents);
            for i in 0..=40 {
                for j in 0..=40 {
                    let (u, v) = (f64::from(i) / 40.0, f64::from(j) / 40.0);
                    let at = octant.patch(0).jet(u, v).position;
                    assert!(octant.excess(at).abs() < 1e-11, "{exponents:?} {u} {v} {at}");
                    for axis in 0..3 {
                        let at = octant.patch(1 + axis).jet(u, v).position;
                        assert!(at[axis] == 0.0 && octant.excess(at) < 1e-11 && at.min_element() >= 0.0);
                    }
                }
            }
        }
    }

    #[test]
    fn sides_that_are_shared_are_the_same_to_the_bit() {
        for exponents in SOME {
            let octant = octant(exponents);
            let at = |patch: usize, side: usize, w: f64| {
                let (u, v) = [(0.0, w), (1.0, w), (w, 0.0), (w, 1.0)][side];
                octant.patch(patch).jet(u, v).position
            };
            for patch in 0..octant.n_patches() {
                for (side, met) in octant.patch(patch).sides().into_iter().enumerate() {
                    for i in 0..=16 {
                        let w = f64::from(i) / 16.0;
                        match met {
                            Side::Shared { patch: other, side: others, .. } => {
                                assert_eq!(at(patch, side, w), at(other, others, w), "{exponents:?} {patch} {side}");
                            }
                            Side::Pole => assert_eq!(at(patch, side, w), at(patch, side, 0.0)),
                            other => unreachable!("{other:?}"),
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn normals_point_along_the_gradient_also_where_the_tangents_vanish() {
        for exponents in SOME {
            let octant = octant(exponents);
            for patch in 0..4 {
                for i in 0..=20 {
                    for j in 0..=20 {
                        let (u, v) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
                        let jet = octant.patch(patch).jet(u, v);
                        let limit = octant.patch(patch).normal_limit(u, v).unwrap();
                        assert!((limit.length() - 1.0).abs() < 1e-12);
                        let normal = jet.du.cross(jet.dv);
                        if normal.length() > 1e-9 * jet.du.length() * jet.dv.length() && normal.length() > 1e-200 {
                            assert!(
                                normal.normalize().dot(limit) > 1.0 - 1e-9,
                                "{exponents:?} {patch} {u} {v} {normal} {limit}"
                            );
                        }
                    }
                }
            }
        }
    }

    /// The flux of `X / 3` through all sides, along the outward normals, is the volume.
    #[test]
    fn the_patches_go_round_the_volume() {
        for exponents in [[2.0, 2.0, 2.0], [1.0, 1.0, 1.0], [0.5, 0.7, 1.4], [8.0, 3.0, 0.6]] {
            let octant = octant(exponents);
            let n = 64;
            let mut flux = 0.0;
            for (patch, is_outward) in octant.is_outward().into_iter().enumerate() {
                for i in 0..n * n {
                    for (u, p) in FOUR {
                        for (v, q) in FOUR {
                            let jet = octant
                                .patch(patch)
                                .jet(((i / n) as f64 + u) / n as f64, ((i % n) as f64 + v) / n as f64);
                            let through = p * q * jet.position.dot(jet.du.cross(jet.dv)) / (3 * n * n) as f64;
                            flux += if is_outward { through } else { -through };
                        }
                    }
                }
            }
            let (volume, _) = octant.moments();
            assert!((flux - volume).abs() < 1e-7 * volume, "{exponents:?} {flux} {volume}");
        }
    }
}
