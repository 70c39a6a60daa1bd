//! The motions about its axis that make a surface between two ends its own image, read from its modes.
//!
//! With `F = x + iy = sum c_n(u) exp(i k_n v)` and `z = sum d_n(u) exp(i k_n v)`, a turn by `alpha` is a symmetry when some step `beta` along `v` does the same: `n beta = alpha` for every `n` with `c_n`, and `n beta = 0` for every `n` with `d_n` (modulo `2 pi`).
//! A mirror whose plane stands at `phi` is one when `v` run backwards from some `gamma` does the same: `c_n exp(i n gamma) = exp(2 i phi) conj(c_n)` and `d_n exp(i n gamma) = conj(d_n)`.
//! The coefficients are functions of `u` that follow from boundary data in one way for all of one mode, so that data are compared and nothing is solved.

use std::f64::consts::{PI, TAU};

use super::boundary_value::{BoundaryValue, Component, Datum};
use super::limits::WAVES;

/// Data count as 0 below this share of the largest: what is left of twelve digits when they are added up.
const SLACK: f64 = 1e-11;

/// The turns about the axis and the mirrors in planes through it that leave a surface as it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Symmetry {
    /// Turns by this part of a turn; `None` where any turn does.
    pub(crate) fold: Option<f64>,
    /// The angle at which the plane of one mirror stands; the others follow by half turns of the fold.
    pub(crate) mirror: Option<f64>,
}

impl Symmetry {
    /// No motion but to stay.
    pub(crate) const NONE: Symmetry = Symmetry { fold: Some(1.0), mirror: None };

    /// Of a surface that closes round the axis; of any other none is known.
    pub(crate) fn of(problem: &BoundaryValue) -> Symmetry {
        let Some(waves) = waves(problem) else { return Symmetry::NONE };
        let Some(first) = waves.iter().find(|wave| wave.is_planar) else { return Symmetry::NONE };
        // What every wave asks of a step along v, against the first.
        let steps = || waves.iter().map(|wave| if wave.is_planar { wave.n - first.n } else { wave.n });
        let common = steps().fold(0.0, greatest_common_divisor);
        if common == 0.0 {
            // One wave that is not the middle: a circle at every level.
            let is_round = first.n != 0.0;
            return if is_round { Symmetry { fold: None, mirror: Some(0.0) } } else { Symmetry::NONE };
        }
        let fold = common / greatest_common_divisor(common, first.n);
        Symmetry { fold: Some(fold), mirror: mirror(&waves, first, common) }
    }

    /// Whether a turn by so many quarters is one of them.
    pub(crate) fn has_quarters(&self, quarters: f64) -> bool {
        self.fold.is_none_or(|fold| is_whole(quarters * fold / 4.0))
    }

    /// Whether the mirror whose plane stands at so many eighths of a turn is one of them.
    pub(crate) fn has_mirror(&self, eighths: f64) -> bool {
        let away = |mirror: f64| (eighths / 4.0 - mirror / PI) * self.fold.unwrap_or_default();
        self.mirror.is_some_and(|mirror| self.fold.is_none() || is_whole(away(mirror)))
    }
}

/// One coefficient of the outline or of the height, by its boundary data.
struct Wave {
    n: f64,
    is_planar: bool,
    data: Vec<[f64; 2]>,
}

impl Wave {
    fn size(&self) -> f64 {
        self.data.iter().flatten().fold(0.0, |size, number| size.max(number.abs()))
    }

    /// The angle of the line through 0 on which all data lie, if there is one.
    fn angle(&self, slack: f64) -> Option<f64> {
        let square = |[re, im]: &[f64; 2]| re * re + im * im;
        let [re, im] = self.data.iter().max_by(|one, other| square(one).total_cmp(&square(other)))?;
        let angle = libm::atan2(*im, *re);
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        self.data.iter().all(|[re, im]| (im * cos - re * sin).abs() <= slack).then_some(angle)
    }
}

/// All that are there, those of negative `n` among them; `None` where one does not go round a whole number of times, or more often than anything is measured of.
fn waves(problem: &BoundaryValue) -> Option<Vec<Wave>> {
    let [x, y, z] = [&problem.x, &problem.y, &problem.z];
    let mut numbers: Vec<f64> = Vec::new();
    for n in [x, y, z].into_iter().flat_map(|component| component.modes.iter().map(|mode| mode.n.abs())) {
        // A mirror is sought among as many steps as there are waves.
        if n != libm::trunc(n) || n > WAVES {
            return None;
        }
        if !numbers.contains(&n) {
            numbers.push(n);
        }
    }
    // Different equations make different functions of equal data: they are told apart by where they stand.
    let is_one_equation = x.order == y.order && (x.s, x.t, x.w, x.free) == (y.s, y.t, y.w, y.free);
    let length = 4 + problem.rings.len() + most_force(problem);
    let mut found = Vec::new();
    for n in numbers {
        let [[xc, xs], [yc, ys], [zc, zs]] = [x, y, z].map(|component| data(component, n, length));
        let mut planar = |n: f64, sign: f64| {
            // x is half of (xc - i xs) here, and i y half of (ys + i yc); the other way round for the wave of -n.
            let along_x = xc.iter().zip(&xs).map(|(c, s)| [*c, -sign * s]);
            let along_y = yc.iter().zip(&ys).map(|(c, s)| [sign * s, *c]);
            let data = match is_one_equation {
                true => along_x.zip(along_y).map(|(one, other)| [one[0] + other[0], one[1] + other[1]]).collect(),
                false => along_x.chain(along_y).collect(),
            };
            found.push(Wave { n, is_planar: true, data });
        };
        planar(n, 1.0);
        if n > 0.0 {
            planar(-n, -1.0);
            let data = zc.iter().zip(&zs).map(|(c, s)| [*c, -s]).collect();
            found.push(Wave { n, is_planar: false, data });
        }
    }
    let slack = slack(&found);
    found.retain(|wave| wave.size() > slack);
    Some(found)
}

fn slack(waves: &[Wave]) -> f64 {
    SLACK * waves.iter().map(Wave::size).fold(0.0, f64::max)
}

fn most_force(problem: &BoundaryValue) -> usize {
    let data = problem.components().into_iter().flat_map(|component| &component.modes);
    data.flat_map(|mode| [mode.cos.force.len(), mode.sin.force.len()]).max().unwrap_or_default()
}

/// What a component has of `cos` and `sin` of `n`, each as one list.
fn data(component: &Component, n: f64, length: usize) -> [Vec<f64>; 2] {
    let mut both = [vec![0.0; length], vec![0.0; length]];
    for mode in component.modes.iter().filter(|mode| mode.n.abs() == n) {
        add(&mut both[0], &mode.cos, 1.0, length);
        // sin(0) is 0, and sin(-v) the negative of sin(v).
        let sign = if mode.n > 0.0 { 1.0 } else { -1.0 };
        add(&mut both[1], &mode.sin, if n == 0.0 { 0.0 } else { sign }, length);
    }
    both
}

fn add(sum: &mut [f64], datum: &Datum, factor: f64, length: usize) {
    let Datum { start, end, start_u, end_u, rings, force } = datum;
    let values = [start, end, start_u, end_u].into_iter().chain(rings);
    sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += factor * value);
    // From the end, where no ring is in the way.
    sum[..length].iter_mut().rev().zip(force).for_each(|(sum, value)| *sum += factor * value);
}

/// The angle of the plane of a mirror, if there is one.
fn mirror(waves: &[Wave], first: &Wave, common: f64) -> Option<f64> {
    let slack = slack(waves);
    let angles = waves.iter().map(|wave| wave.angle(slack)).collect::<Option<Vec<f64>>>()?;
    let at_first = first.angle(slack)?;
    // The turn that each wave asks for, twice its angle, against a step gamma along v.
    let asked = || {
        waves.iter().zip(&angles).map(|(wave, angle)| match wave.is_planar {
            true => (wave.n - first.n, 2.0 * (angle - at_first), wave.size()),
            false => (wave.n, 2.0 * angle, wave.size()),
        })
    };
    let (n, turn, _) =
        asked().filter(|(n, ..)| *n != 0.0).min_by(|one, other| one.0.abs().total_cmp(&other.0.abs()))?;
    let holds = |gamma: f64| asked().all(|(n, turn, size)| size * within(turn + n * gamma).abs() <= 1e2 * slack);
    // Steps that differ by a part of the fold make the same mirrors.
    let n_steps = (n / common).abs();
    let gammas = (0..n_steps as usize).map(|step| (TAU * step as f64 - turn) / n);
    gammas.into_iter().find(|gamma| holds(*gamma)).map(|gamma| at_first + first.n * gamma / 2.0)
}

/// The same angle from `-pi` to `pi`.
fn within(angle: f64) -> f64 {
    angle - TAU * libm::round(angle / TAU)
}

fn is_whole(number: f64) -> bool {
    (number - libm::round(number)).abs() < 1e-9
}

fn greatest_common_divisor(a: f64, b: f64) -> f64 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b > 0.0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;

    fn symmetry(shape: &str) -> Symmetry {
        let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#)).unwrap();
        let problem = design.parts()[0].shape.problem().unwrap().into_owned();
        Symmetry::of(&problem)
    }

    fn turned(fold: f64) -> Symmetry {
        Symmetry { fold: Some(fold), mirror: Some(0.0) }
    }

    #[test]
    fn families_have_those_of_their_petals() {
        assert_eq!(
            symmetry(r#"{ "kind": "second-order", "r": [1, 0, 0.6, 0], "height": 2 }"#),
            Symmetry { fold: None, mirror: Some(0.0) }
        );
        for (n, fold) in [(8, 7.0), (5, 4.0), (2, 1.0), (-1, 2.0), (-3, 4.0)] {
            let shape =
                format!(r#"{{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "n": [1, {n}], "height": 2 }}"#);
            let found = symmetry(&shape);
            assert_eq!((found.fold, found.has_mirror(0.0)), (Some(fold), true), "{n}");
        }
        // The equations of x and y are not the same: what is round at its ends is not so between them.
        let shape = r#"{ "kind": "second-order", "r": [1, 0, 0.6, 0], "s": [1, 3], "height": 2 }"#;
        let found = symmetry(shape);
        assert_eq!((found.fold, found.has_mirror(0.0), found.has_mirror(1.0)), (Some(2.0), true, false));
        // Not closed, and of more waves than anything is measured of.
        for n in ["[1, 2.5]", "[1, 129]", "[1000000001, 1000000002]"] {
            let shape = format!(r#"{{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "n": {n}, "height": 2 }}"#);
            assert_eq!(symmetry(&shape), Symmetry::NONE, "{n}");
        }
    }

    #[test]
    fn rings_have_those_of_all_their_waves() {
        let rings = |waves: [&str; 3]| {
            let ring = |(place, waves): (usize, &&str)| {
                let u = place as f64 / 2.0;
                format!(r#"{{ "u": {u}, "r": {{ "mean": 5, "waves": [{waves}] }}, "z": {{ "mean": {place} }} }}"#)
            };
            let rings: Vec<String> = waves.iter().enumerate().map(ring).collect();
            symmetry(&format!(r#"{{ "kind": "rings", "rings": [{}] }}"#, rings.join(", ")))
        };
        assert_eq!(rings([""; 3]).fold, None);
        assert_eq!(rings([r#"{ "n": 6, "cos": 0.5 }"#, r#"{ "n": 9, "cos": 0.5 }"#, ""]).fold, Some(3.0));
        let leaning = rings([r#"{ "n": 3, "cos": 0.4, "sin": 0.3 }"#, r#"{ "n": 3, "cos": -0.8, "sin": -0.6 }"#, ""]);
        assert_eq!(leaning.fold, Some(3.0));
        // Petals at the angle where 3 v has the phase of (4, 3), or a sixth of a turn on.
        let away = (leaning.mirror.unwrap() - libm::atan2(3.0, 4.0) / 3.0) * 3.0 / PI;
        assert!(is_whole(away), "{leaning:?}");
        // Twisted: each ring is turned against the next.
        let twisted = rings([r#"{ "n": 3, "cos": 0.4, "sin": 0.3 }"#, r#"{ "n": 3, "cos": 0.5 }"#, ""]);
        assert_eq!(twisted, Symmetry { fold: Some(3.0), mirror: None });
        assert_eq!(rings([r#"{ "n": 1, "cos": 0.5 }"#, "", ""]), turned(1.0));
    }
}
