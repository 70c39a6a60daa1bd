//! Mean and Gaussian curvature of the design surface.

use core::f64::consts::TAU;

use glam::DVec3;

use super::bare::Bare;
use super::outside::columns;
use super::search::{Grid, Place};
use crate::solid::Face;
use crate::surface::SurfaceJet;

/// A value and where it is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Located {
    /// The value.
    pub value: f64,
    /// Where, in model units after placement.
    pub at: [f64; 3],
}

/// The range of a curvature; a bound is `None` where the curvature grows without one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CurvatureRange {
    /// The least.
    pub least: Option<Located>,
    /// The greatest.
    pub greatest: Option<Located>,
}

/// Ranges of mean and Gaussian curvature.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Curvature {
    /// Half the sum of the principal curvatures, positive where the surface bends like a ball seen from outside.
    pub mean: CurvatureRange,
    /// The product of the principal curvatures.
    pub gaussian: CurvatureRange,
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
        // A parabola through three points further in.
        let limit = 3.0 * near(1.0) - 3.0 * near(2.0) + near(3.0);
        if limit.is_finite() { limit } else { 0.0 }
    }
}

/// The ranges over the whole surface.
pub(crate) fn curvature(bare: &Bare) -> Curvature {
    let grid = Grid::new(65, columns(bare.highest()), |a, v| bare.second(a, v));
    Curvature { mean: range(bare, &grid, Kind::Mean), gaussian: range(bare, &grid, Kind::Gaussian) }
}

fn range(bare: &Bare, grid: &Grid<SurfaceJet>, kind: Kind) -> CurvatureRange {
    let outward = bare.outward();
    // Ends that are poles or cusps, and the limits there.
    let mut ends = Vec::new();
    for a in [0.0, 1.0] {
        for j in 0..columns(bare.highest()) {
            let v = TAU * j as f64 / columns(bare.highest()) as f64;
            if !kind.of(&bare.second(a, v), outward).is_finite() {
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
        let mut best = grid.greatest(of, |a, v| bare.second(a.clamp(from, to), v))?;
        best.a = best.a.clamp(from, to);
        for &(a, v) in &ends {
            let inward = if a < 0.5 { STEP } else { -STEP };
            let near = [1.0, 0.1, 0.01].map(|step| sign * kind.of(&bare.second(a + step * inward, v), outward));
            if near[2] > GROWTH * near[1] && near[1] > GROWTH * near[0] && near[0] > 0.0 {
                return None;
            }
            let value = sign * kind.at(bare, a, v);
            if value > best.value {
                best = Place { a, v, value };
            }
        }
        let at: DVec3 = bare.jet(best.a, best.v).position;
        Some(Located { value: sign * best.value, at: at.to_array() })
    };
    CurvatureRange { least: extreme(-1.0), greatest: extreme(1.0) }
}
