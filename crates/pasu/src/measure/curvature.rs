//! Mean and Gaussian curvature of the design surface.

use core::f64::consts::TAU;

use glam::DVec3;

use super::bare::Bare;
use super::outside::columns;
use crate::answer::answers;
use crate::face::Face;
use crate::numeric::climb::Place;
use crate::numeric::grid::Grid;
use crate::numeric::limit::limit;
use crate::patch::SurfaceJet;

answers! {
    /// A value and where it is.
    #[derive(Copy, Default)]
    pub struct Located as "Located" {
        /// The value.
        pub value: f64,
        /// How far it may be off; never negative.
        pub error: f64,
        /// Where, in model units after placement.
        pub at: [f64; 3],
    }

    /// The range of a curvature; a bound is `None` where the curvature grows without one.
    #[derive(Copy, Default)]
    pub struct CurvatureRange as "CurvatureRange" {
        /// The least.
        pub least: Option<Located>,
        /// The greatest.
        pub greatest: Option<Located>,
    }

    /// Ranges of mean and Gaussian curvature.
    #[derive(Copy, Default)]
    pub struct Curvature as "Curvature" {
        /// Half the sum of the principal curvatures, positive where the surface bends like a ball seen from outside.
        pub mean: CurvatureRange,
        /// The product of the principal curvatures.
        pub gaussian: CurvatureRange,
    }
}

/// Which curvature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Mean,
    Gaussian,
}

/// So small against the lengths of both tangents, their product counts as vanished.
const VANISHED: f64 = 1e-10;

/// The step by which a limit at a pole or cusp is approached.
const STEP: f64 = 1e-3;

/// At a pole whose curvature grows more than so much when it is approached ten times closer, it has no bound.
const GROWTH: f64 = 4.0;

impl Kind {
    /// From the fundamental forms, `H = (e G - 2 f F + g E) / 2 (E G - F^2)` and `K = (e g - f^2) / (E G - F^2)`; NaN where the tangents are parallel.
    ///
    /// `outward` is 1 where `X_u x X_v` points outwards. Against the outward normal a ball bends with a negative second form; the sign of `H` is turned.
    pub(crate) fn of(self, jet: &SurfaceJet, outward: f64) -> f64 {
        let SurfaceJet { du, dv, duu, duv, dvv, .. } = *jet;
        let cross = du.cross(dv);
        let length = cross.length();
        if !(length > VANISHED * du.length() * dv.length()) {
            return f64::NAN;
        }
        // Tangents of unit length keep the products within the range of numbers.
        let (p, q) = (du.length(), dv.length());
        let normal = cross / length * outward;
        let f = du.dot(dv) / (p * q);
        let (l, m, n) = (duu.dot(normal) / (p * p), duv.dot(normal) / (p * q), dvv.dot(normal) / (q * q));
        let determinant = (length / (p * q)) * (length / (p * q));
        match self {
            Kind::Mean => -0.5 * (l - 2.0 * m * f + n) / determinant,
            Kind::Gaussian => (l * n - m * m) / determinant,
        }
    }

    /// At a point of a surface, by the limit along `u` where the surface has a pole or cusp; 0 where there is none either.
    pub(crate) fn at(self, bare: &Bare, a: f64, v: f64) -> f64 {
        let here = self.of(&bare.second(a, v), bare.outward());
        if here.is_finite() {
            return here;
        }
        let inward = if a < 0.5 { STEP } else { -STEP };
        let near = |steps: f64| self.of(&bare.second(a + steps * inward, v), bare.outward());
        // A cubic through four points further in.
        let (limit, _) = limit(near);
        if limit.is_finite() { limit } else { 0.0 }
    }

    /// The limit at a pole or cusp with how far it may be off.
    fn limit(self, bare: &Bare, a: f64, v: f64) -> (f64, f64) {
        let inward = if a < 0.5 { STEP } else { -STEP };
        let near = |steps: f64| self.of(&bare.second(a + steps * inward, v), bare.outward());
        let (value, off) = limit(near);
        (value, off + POLE_ROUNDING * near(1.0).abs())
    }
}

/// The rounding of a curvature so near to a pole that second derivatives are divided by the square of a step.
const POLE_ROUNDING: f64 = 1e-9;

/// The rounding of a curvature elsewhere, as a part of its size.
const ROUNDING: f64 = 1e-11;

/// The ranges over the whole surface.
pub(crate) fn curvature(bare: &Bare) -> Curvature {
    let columns = columns(bare.waves());
    let grids = [(65, columns), (51, columns + columns / 3)];
    let mut walk = bare.second_walk();
    let grids = grids.map(|(rows, columns)| Grid::new(rows, columns, |a, v| walk.at(a, v)));
    Curvature { mean: range(bare, &grids, Kind::Mean), gaussian: range(bare, &grids, Kind::Gaussian) }
}

fn range(bare: &Bare, [grid, other]: &[Grid<SurfaceJet>; 2], kind: Kind) -> CurvatureRange {
    let outward = bare.outward();
    // Ends that are poles or cusps, and the limits there.
    let mut ends = Vec::new();
    let mut walk = bare.second_walk();
    for a in [0.0, 1.0] {
        for j in 0..columns(bare.waves()) {
            let v = TAU * j as f64 / columns(bare.waves()) as f64;
            if !kind.of(&walk.at(a, v), outward).is_finite() {
                ends.push((a, v));
            }
        }
    }
    let is_singular = |a: f64| ends.iter().any(|end| end.0 == a);
    let bounds = [0.0, 1.0].map(is_singular);
    // Towards a pole second derivatives are divided by what vanishes; the limit stands for what is nearer.
    let (from, to) = (if bounds[0] { STEP } else { 0.0 }, if bounds[1] { 1.0 - STEP } else { 1.0 });
    let extreme = |sign: f64| {
        let of = |jet: &SurfaceJet| sign * kind.of(jet, outward);
        let mut walk = bare.second_walk();
        let (mut best, mut error) = grid.greatest_and_error(other, of, |a, v| walk.at(a.clamp(from, to), v))?;
        best.a = best.a.clamp(from, to);
        let is_beside = (bounds[0] && best.a == from) || (bounds[1] && best.a == to);
        let beside = best;
        for &(a, v) in &ends {
            let inward = if a < 0.5 { STEP } else { -STEP };
            let near = [1.0, 0.1, 0.01].map(|step| sign * kind.of(&bare.second(a + step * inward, v), outward));
            if near[2] > GROWTH * near[1] && near[1] > GROWTH * near[0] && near[0] > 0.0 {
                return None;
            }
            let (value, off) = kind.limit(bare, a, v);
            if sign * value > best.value {
                (best, error) = (Place { a, v, value: sign * value }, off);
            }
        }
        if is_beside && best == beside {
            // Between here and the pole it may be a little more.
            error +=
                (best.value - of(&bare.second(if best.a < 0.5 { 2.0 * STEP } else { 1.0 - 2.0 * STEP }, best.v))).abs();
        }
        // Either is a sum of principal curvatures or of their products, of which little may be left.
        let [mean, gaussian] =
            [Kind::Mean, Kind::Gaussian].map(|kind| kind.of(&bare.second(best.a.clamp(from, to), best.v), outward));
        let largest = mean.abs() + libm::sqrt((mean * mean - gaussian).max(0.0));
        let error = error + ROUNDING * if kind == Kind::Mean { largest } else { largest * largest };
        let at: DVec3 = bare.jet(best.a, best.v).position;
        // What leaves the range of numbers has no bound that could be told.
        (best.value.is_finite() && error.is_finite()).then_some(Located {
            value: sign * best.value,
            error,
            at: at.to_array(),
        })
    };
    CurvatureRange { least: extreme(-1.0), greatest: extreme(1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;

    /// What a far finer search finds is within the error that is stated.
    #[test]
    fn ranges_against_a_finer_search() {
        let own = |x: f64, n: usize| {
            format!(
                r#"{{ "kind": "bloor-wilson", "a": {x}, "r": [1, 0.1, 0.1, 0.8], "R": [-3, -0.5, -0.5, 2], "h": [3, 0.3], "H": [-0.5, -0.7], "n1": {n} }}"#
            )
        };
        let petals = r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "n": [1, 8] }"#.to_owned();
        for shape in [own(0.01, 5), own(6.0, 3), own(1.0, 10), petals] {
            let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#)).unwrap();
            let bare = Bare::new(crate::solution::Solution::of(&design).part(0).unwrap()).unwrap();
            let grids = [(301, 5 * columns(bare.waves())), (257, 4 * columns(bare.waves()))];
            let mut walk = bare.second_walk();
            let grids = grids.map(|(rows, columns)| Grid::new(rows, columns, |a, v| walk.at(a, v)));
            let found = curvature(&bare);
            for (kind, found) in [(Kind::Mean, found.mean), (Kind::Gaussian, found.gaussian)] {
                let fine = range(&bare, &grids, kind);
                for (one, other) in [(found.least, fine.least), (found.greatest, fine.greatest)] {
                    let (one, other) = (one.unwrap(), other.unwrap());
                    let off = (one.value - other.value).abs();
                    assert!(off <= one.error, "{shape} {kind:?}: {one:?} {other:?}");
                    assert!(one.error <= 1e-6 * one.value.abs().max(1.0), "{shape} {kind:?}: {one:?}");
                }
            }
        }
    }
}
