//! Mean and Gaussian curvature of the design surface.

use core::f64::consts::TAU;

use glam::DVec3;

use super::bare::Bare;
use super::outside::{besides, columns};
use crate::answer::answers;
use crate::face::Face;
use crate::numeric::climb::{Place, climb};
use crate::numeric::greatest::{Sought, greatest, usual};
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

/// What the fundamental forms of a surface tell at a point; NaN where its tangents are parallel.
struct Forms {
    position: DVec3,
    /// The outward normal, of unit length.
    normal: DVec3,
    mean: f64,
    gaussian: f64,
    /// The sine of the angle between the tangents.
    sine: f64,
}

impl Forms {
    /// `H = (e G - 2 f F + g E) / 2 (E G - F^2)` and `K = (e g - f^2) / (E G - F^2)`.
    ///
    /// `outward` is 1 where `X_u x X_v` points outwards. Against the outward normal a ball bends with a negative second form; the sign of `H` is turned.
    fn of(jet: &SurfaceJet, outward: f64) -> Forms {
        let SurfaceJet { position, du, dv, duu, duv, dvv, .. } = *jet;
        let cross = du.cross(dv);
        let length = cross.length();
        // Tangents of unit length keep the products within the range of numbers.
        let (p, q) = (du.length(), dv.length());
        let sine = length / (p * q);
        if !(length > VANISHED * p * q) {
            return Forms { position, normal: DVec3::NAN, mean: f64::NAN, gaussian: f64::NAN, sine };
        }
        let normal = cross / length * outward;
        let f = du.dot(dv) / (p * q);
        let (l, m, n) = (duu.dot(normal) / (p * p), duv.dot(normal) / (p * q), dvv.dot(normal) / (q * q));
        let determinant = sine * sine;
        let (mean, gaussian) = (-0.5 * (l - 2.0 * m * f + n) / determinant, (l * n - m * m) / determinant);
        Forms { position, normal, mean, gaussian, sine }
    }

    /// The principal curvature that is larger in size.
    fn largest(&self) -> f64 {
        self.mean.abs() + libm::sqrt((self.mean * self.mean - self.gaussian).max(0.0))
    }
}

impl Kind {
    fn told(self, forms: &Forms) -> f64 {
        match self {
            Kind::Mean => forms.mean,
            Kind::Gaussian => forms.gaussian,
        }
    }

    /// At a place where the tangents are not parallel, otherwise NaN.
    pub(crate) fn of(self, jet: &SurfaceJet, outward: f64) -> f64 {
        self.told(&Forms::of(jet, outward))
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

/// What is not sought any more between the points of a grid, as a part of a curvature.
const SMALL: f64 = 1e-6;

/// So many cells of a grid are cut before it is left as it is.
const CUTS: usize = 5_000;

/// The ranges over the whole surface.
pub(crate) fn curvature(bare: &Bare) -> Curvature {
    let columns = columns(bare.waves());
    let grids = grids(bare, [65, 65], [columns, besides(columns)]);
    let mut wild = Vec::new();
    Curvature {
        mean: range(bare, &grids, Kind::Mean, &mut wild),
        gaussian: range(bare, &grids, Kind::Gaussian, &mut wild),
    }
}

/// What is known at the points of an even grid and of a graded one.
fn grids(bare: &Bare, rows: [usize; 2], columns: [usize; 2]) -> [Grid<Forms>; 2] {
    let mut walk = bare.second_walk();
    let mut at = |a: f64, v: f64| Forms::of(&walk.at(a, v), bare.outward());
    [Grid::new(rows[0], columns[0], &mut at), Grid::graded(rows[1], columns[1], &mut at)]
}

/// How many times as much as at the corners of a cell a surface may bend on the way between them before it is said to do so.
const MORE: f64 = 1.25;

/// The cosine of an angle by which normals may turn whatever is between them: a tenth of a radian.
const LITTLE: f64 = 0.995;

/// How much more than at the corners of a cell a curvature may be between them, along `a` and round `v`: normals do not turn as much as they do there without it.
fn turning(kind: Kind, [one, two, three, four]: [&Forms; 4]) -> [f64; 2] {
    let between = |one: &Forms, other: &Forms| {
        let cosine = one.normal.dot(other.normal);
        if !(cosine < LITTLE) {
            return 0.0;
        }
        let turn = libm::atan2(one.normal.cross(other.normal).length(), cosine);
        let bend = turn / (other.position - one.position).length();
        if !(bend > MORE * one.largest().max(other.largest()) && bend.is_finite()) {
            return 0.0;
        }
        if kind == Kind::Mean { bend } else { bend * bend }
    };
    [between(one, three).max(between(two, four)), between(one, two).max(between(three, four))]
}

/// So many times as large as usual, where tangents are all but parallel, it has no bound.
const WILD: f64 = 1e4;

/// The sine of the angle between tangents that are all but parallel.
const PARALLEL: f64 = 1e-3;

/// How near to a place another is looked for, as a part of the step of a grid.
const NEAREST: f64 = 1e-3;

/// The greatest of places in rings about one.
fn ring(about: Place, (step_a, step_v): (f64, f64), mut of: impl FnMut(f64, f64) -> f64) -> Place {
    const DIRECTIONS: u32 = 16;
    let mut best = Place { value: f64::NEG_INFINITY, ..about };
    for far in [100.0 * NEAREST, 10.0 * NEAREST, NEAREST] {
        for i in 0..DIRECTIONS {
            let (y, x) = libm::sincos(TAU * f64::from(i) / f64::from(DIRECTIONS));
            let (a, v) = ((about.a + far * step_a * x).clamp(0.0, 1.0), about.v + far * step_v * y);
            let value = of(a, v);
            if value > best.value {
                best = Place { a, v, value };
            }
        }
    }
    best
}

/// The range of one curvature. `wild` are places at which another has no bound, to which those are added where this one has none.
fn range(bare: &Bare, [grid, other]: &[Grid<Forms>; 2], kind: Kind, wild: &mut Vec<Place>) -> CurvatureRange {
    let outward = bare.outward();
    // Ends that are poles or cusps, and the limits there.
    let mut ends = Vec::new();
    let n = grid.points().len();
    for index in (0..grid.columns()).chain(n - grid.columns()..n) {
        if !kind.told(&grid.points()[index]).is_finite() {
            ends.push(grid.place(index));
        }
    }
    let is_singular = |a: f64| ends.iter().any(|end| end.0 == a);
    let bounds = [0.0, 1.0].map(is_singular);
    // Towards a pole second derivatives are divided by what vanishes; the limit stands for what is nearer.
    let (from, to) = (if bounds[0] { STEP } else { 0.0 }, if bounds[1] { 1.0 - STEP } else { 1.0 });
    let usual = usual(grid.points().iter().map(|forms| kind.told(forms)));
    let mut extreme = |sign: f64| {
        let of = |forms: &Forms| sign * kind.told(forms);
        let mut walk = bare.second_walk();
        let mut at = |a: f64, v: f64| Forms::of(&walk.at(a.clamp(from, to), v), outward);
        let more = |corners: [&Forms; 4]| turning(kind, corners);
        let sought = Sought { of, more, most: f64::INFINITY, small: SMALL, cuts: CUTS };
        let (mut best, mut error) = greatest([grid, other], &sought, &mut at)?;
        // Where another has no bound, this one may have none either.
        let (step_a, step_v) = grid.steps();
        for place in wild.iter() {
            let about = ring(*place, (step_a, step_v), |a, v| of(&at(a, v)));
            if about.value > best.value {
                let known = best.value;
                best = climb(about, NEAREST * step_a, NEAREST * step_v, |a, v| of(&at(a, v)));
                error += 2.0 * (best.value - known);
            }
        }
        best.a = best.a.clamp(from, to);
        if best.value > WILD * usual && at(best.a, best.v).sine < PARALLEL {
            wild.push(best);
            return None;
        }
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
            error += (best.value - of(&at(if best.a < 0.5 { 2.0 * STEP } else { 1.0 - 2.0 * STEP }, best.v))).abs();
        }
        // Either is a sum of principal curvatures or of their products, of which little may be left.
        let largest = at(best.a, best.v).largest();
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
            let columns = columns(bare.waves());
            let grids = grids(&bare, [301, 257], [5 * columns, 4 * columns]);
            let found = curvature(&bare);
            for (kind, found) in [(Kind::Mean, found.mean), (Kind::Gaussian, found.gaussian)] {
                let fine = range(&bare, &grids, kind, &mut Vec::new());
                for (one, other) in [(found.least, fine.least), (found.greatest, fine.greatest)] {
                    let (one, other) = (one.unwrap(), other.unwrap());
                    let off = (one.value - other.value).abs();
                    assert!(off <= one.error, "{shape} {kind:?}: {one:?} {other:?}");
                    assert!(one.error <= 1e-6 * one.value.abs().max(1.0), "{shape} {kind:?}: {one:?}");
                }
            }
        }
    }

    /// Holds the ranges against places all over a surface, the closer the nearer they are to its ends.
    fn holds(shape: &str, place: &str) {
        let design =
            Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "place": {place} }}] }}"#)).unwrap();
        let bare = Bare::new(crate::solution::Solution::of(&design).part(0).unwrap()).unwrap();
        let Curvature { mean, gaussian } = curvature(&bare);
        let mut walk = bare.second_walk();
        let near_ends = (1..=14).map(|k| 0.1 * 0.5f64.powi(k));
        let rows = (1..100).map(|i| f64::from(i) / 100.0).chain(near_ends.clone()).chain(near_ends.map(|a| 1.0 - a));
        for (a, j) in rows.flat_map(|a| (0..480).map(move |j| (a, j))) {
            let forms = Forms::of(&walk.at(a, TAU * f64::from(j) / 480.0), bare.outward());
            for (kind, range) in [(Kind::Mean, mean), (Kind::Gaussian, gaussian)] {
                let value = kind.told(&forms);
                let [least, greatest] = [range.least, range.greatest].map(|end| end.map(|end| (end.value, end.error)));
                let is_within = least.is_none_or(|(least, error)| value >= least - error - 1e-9 * least.abs())
                    && greatest.is_none_or(|(greatest, error)| value <= greatest + error + 1e-9 * greatest.abs());
                assert!(is_within, "{shape}: {kind:?} {value} at {a} {j}, {least:?} {greatest:?}");
            }
        }
    }

    #[test]
    fn no_place_bends_more_than_is_told_where_a_surface_bends_within_a_small_part_of_it() {
        // A petal of which two grids of odd numbers of columns see both slopes, and a place beside the foot.
        holds(
            r#"{ "kind": "second-order", "r": [4.709, 0.207196, 3.6253, 0.09353274], "n": [1, 12], "t": [0.016, 0.016], "height": 8.078 }"#,
            r#"{ "scale": [1.3756, 1.059, 0.8272] }"#,
        );
        holds(
            r#"{ "kind": "bloor-wilson", "a": 0.8659, "r": [3.8365, -0.4281534, -0.42048040000000003, 3.9], "R": [2.3831, 1.19155, 1.19155, 0.1356], "h": [7.6308, 0.091], "H": [-6.18781572, -0.5361], "n1": 1 }"#,
            "{}",
        );
    }

    #[test]
    fn what_grows_without_a_bound_where_tangents_are_parallel_has_none() {
        // Curvatures of -5.7e3, 7.4e11, -6.8e12 and 2.6e7 were told, one of which was passed by beside it.
        for (rim, foot, t, height, rise) in [
            ("2.6863, 0.01584917", "2.5437, 0.05468955", 0.0065, 9.2129, -12.62443687),
            ("4.7969, 0.02638295", "3.5017, 0.20554979", 0.0341, 9.5717, -7.41519599),
        ] {
            let shape = format!(
                r#"{{ "kind": "mixed-order", "r": [{rim}, {foot}], "n": [1, 7], "t": [{t}, {t}], "height": {height}, "rise": {rise} }}"#
            );
            holds(&shape, "{}");
            let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#)).unwrap();
            let bare = Bare::new(crate::solution::Solution::of(&design).part(0).unwrap()).unwrap();
            let Curvature { mean, gaussian } = curvature(&bare);
            assert_eq!([mean.least, mean.greatest, gaussian.least], [None; 3], "{shape}");
        }
    }
}
