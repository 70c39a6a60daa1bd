//! Surfaces through rings, against the reference corpus and against the properties that make them what they are.

use crate::support::{Point, problem_of, ring_cases, ring_regimes, surface, surface_of};
use glam::DVec3;
use pasu::{
    BoundaryValue, Code, Component, Datum, Design, Format, Free, Making, MeasureOptions, MeshOptions, Mode, Order,
    Ring, Span, Surface, check, fingerprint, measure, mesh, solid, write,
};
use proptest::prelude::*;

/// Positions within 1e-12 of the scale of the case, over the smallest gap between rings where these crowd; derivatives the same of the largest of the same kind.
#[test]
fn every_case_of_the_corpora() {
    let (cases, regimes) = (ring_cases(), ring_regimes());
    assert!(cases.len() >= 14 && regimes.len() >= 60);
    let mut failures = Vec::new();
    for case in cases.iter().chain(&regimes) {
        let largest = |of: fn(&Point) -> [f64; 3]| case.points.iter().flat_map(of).map(f64::abs).fold(0.0, f64::max);
        let sizes = [case.scale, largest(|point| point.du).max(case.scale), largest(|point| point.dv).max(case.scale)];
        for given in case.family.iter().chain([&case.shape]) {
            let (surface, crowding) = (surface(given), 1.0 / gap(&problem_of(given)));
            let mut worst = [0.0f64; 3];
            for point in &case.points {
                let jet = surface.at(point.u, point.v);
                let pairs = [(jet.position, point.position), (jet.du, point.du), (jet.dv, point.dv)];
                for (i, (found, expected)) in pairs.into_iter().enumerate() {
                    let error = (found - DVec3::from(expected)).abs().max_element() / sizes[i];
                    worst[i] = worst[i].max(error);
                    let crowding = if i == 1 || crowding > 100.0 { crowding } else { 1.0 };
                    if !(error <= 1e-12 * crowding) {
                        let what = ["position", "du", "dv"][i];
                        let place = format!("({}, {})", point.u, point.v);
                        failures.push(format!("{} at {place}: {what} is off by {error:e}", case.name));
                    }
                }
            }
            println!("{}: {worst:?}", case.name);
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// The smallest distance between two neighbours among rings and ends.
fn gap(shape: &BoundaryValue) -> f64 {
    let places: Vec<f64> = [0.0].into_iter().chain(shape.rings.iter().map(|ring| ring.u)).chain([1.0]).collect();
    places.windows(2).map(|pair| pair[1] - pair[0]).fold(1.0, f64::min)
}

/// One harmonic: what holds of it at rings, and of the equation.
#[derive(Debug, Clone)]
struct Problem {
    order: Order,
    equation: [f64; 3],
    n: f64,
    rings: Vec<Ring>,
    free: Free,
    datum: Datum,
}

impl Problem {
    fn shape(&self) -> BoundaryValue {
        let [s, t, w] = self.equation;
        let component = |modes: Vec<Mode>| Component { order: self.order, s, t, w, free: self.free, modes };
        let mode = Mode { n: self.n, cos: self.datum.clone(), sin: Datum::default() };
        BoundaryValue {
            span: Span::Tau,
            rings: self.rings.clone(),
            x: component(vec![mode]),
            y: component(Vec::new()),
            z: component(Vec::new()),
        }
    }

    fn solved(&self) -> Option<Surface> {
        Surface::solve(&self.shape(), "").ok()
    }

    /// The size of what it is given.
    fn scale(&self) -> f64 {
        let Datum { start, end, start_u, end_u, rings, force } = &self.datum;
        let all = [start, end, start_u, end_u].into_iter().chain(rings).chain(force);
        all.fold(1.0, |most, x| most.max(x.abs()))
    }

    fn places(&self) -> Vec<f64> {
        [0.0].into_iter().chain(self.rings.iter().map(|ring| ring.u)).chain([1.0]).collect()
    }

    /// How much slopes grow where rings crowd.
    fn crowding(&self) -> f64 {
        1.0 / gap(&self.shape())
    }

    fn rate(&self) -> f64 {
        let [s, t, w] = self.equation;
        1.0 + self.n * (t / s).abs().sqrt() + self.n * (w / s).abs().sqrt().sqrt()
    }

    /// Whether oscillations can make it as sensitive as they like.
    fn can_swing(&self) -> bool {
        let [s, t, w] = self.equation;
        t / s < 0.0 || w / s < 0.0
    }
}

/// `q`, `q'`, `q''`.
fn along(surface: &Surface, u: f64) -> [f64; 3] {
    let jet = surface.at(u, 0.0);
    [jet.position.x, jet.du.x, jet.duu.x]
}

/// Problems of every regime: rings anywhere, near each other and evenly spaced, sharp and smooth.
fn problem() -> impl Strategy<Value = Problem> {
    let parameter = prop_oneof![Just(0.0), Just(1.0), -2.0..0.0f64, 0.0..60.0f64, 1e-9..1e-6f64];
    let second = prop_oneof![Just(0.0), Just(1.0), -2.0..0.0f64, 0.0..60.0f64];
    let equation = prop_oneof![
        (prop_oneof![Just(1.0), 0.1..5.0f64], parameter, second).prop_map(|(s, t, w)| [s, t, w]),
        // Bloor and Wilson's, and next to it.
        (0.0..9.0f64, prop_oneof![Just(0.0), 1e-15..1e-6f64]).prop_map(|(a, d)| [
            1.0,
            2.0 * a * a * (1.0 + d),
            a * a * a * a
        ]),
    ];
    let n = prop_oneof![Just(0.0), Just(1.0), Just(5.0), 0.0..40.0f64];
    let rings =
        proptest::collection::vec((prop_oneof![0.001..0.9f64, 1e-4..2e-3f64], proptest::bool::weighted(0.3)), 0..9);
    let data = proptest::collection::vec(-1.0..1.0f64, 16);
    let order = prop_oneof![Just(Order::Fourth), Just(Order::Fourth), Just(Order::Fourth), Just(Order::Second)];
    (order, equation, n, rings, any::<[bool; 2]>(), data, any::<bool>()).prop_map(
        |(order, equation, n, gaps, [start, end], data, is_forced)| {
            let total: f64 = gaps.iter().map(|(gap, _)| gap).sum::<f64>() + 0.1;
            let mut u = 0.0;
            let rings: Vec<Ring> = gaps
                .into_iter()
                .map(|(gap, sharp)| {
                    u += gap / total.max(0.5);
                    Ring { u, sharp }
                })
                .filter(|ring| ring.u < 0.999)
                .collect();
            let is_fourth = order == Order::Fourth;
            let free = Free { start: start && is_fourth, end: end && is_fourth };
            let slope = |index: usize, is_free: bool| if is_fourth && !is_free { 3.0 * data[index] } else { 0.0 };
            let datum = Datum {
                start: data[0],
                end: data[1],
                start_u: slope(2, free.start),
                end_u: slope(3, free.end),
                rings: data[4..4 + rings.len()].to_vec(),
                force: if is_forced { data[13..16].iter().map(|x| 20.0 * x).collect() } else { Vec::new() },
            };
            Problem { order, equation, n, rings, free, datum }
        },
    )
}

/// Gauss' rule of ten points on [-1, 1]: half of its nodes and weights.
const GAUSS: [(f64, f64); 5] = [
    (0.148_874_338_981_631_21, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

fn integral(from: f64, to: f64, n: usize, f: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * (to - from) / n as f64;
    let piece = |i: usize| {
        let middle = from + (2 * i + 1) as f64 * half;
        GAUSS.iter().map(|(x, weight)| weight * half * (f(middle - half * x) + f(middle + half * x))).sum::<f64>()
    };
    (0..n).map(piece).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// A ring put where the surface already is changes nothing: the problem has one solution.
    #[test]
    fn a_ring_where_the_surface_is_changes_nothing(problem in problem(), at in 0.01..0.99f64) {
        let Some(surface) = problem.solved() else { return Ok(()) };
        let mut more = problem.clone();
        let index = more.rings.partition_point(|ring| ring.u < at);
        // Rings are smooth where order 2 has no corner of its own.
        prop_assume!(more.places().iter().all(|u| (u - at).abs() > 1e-4) && more.rings.len() < 12);
        more.rings.insert(index, Ring { u: at, sharp: false });
        more.datum.rings.insert(index, along(&surface, at)[0]);
        let Some(same) = more.solved() else {
            prop_assert!(problem.can_swing(), "{more:?}");
            return Ok(());
        };
        let largest = (0..=40).map(|i| along(&surface, f64::from(i) / 40.0)[0].abs()).fold(problem.scale(), f64::max);
        let sensitive = if problem.can_swing() { 1e4 } else { 1.0 };
        for i in 0..=40 {
            let u = f64::from(i) / 40.0;
            let ([p, p_u, _], [q, q_u, _]) = (along(&surface, u), along(&same, u));
            prop_assert!((p - q).abs() < 1e-12 * sensitive * largest, "{u}: {p} {q}");
            let slopes = 1e-12 * sensitive * largest * more.crowding() * problem.rate();
            prop_assert!((p_u - q_u).abs() < slopes, "{u}: {p_u} {q_u}");
        }
    }

    /// It passes through what it is given, to the bit, and has the slopes that it is given.
    #[test]
    fn it_passes_through_its_rings(problem in problem()) {
        let Some(surface) = problem.solved() else { return Ok(()) };
        let Datum { start, end, start_u, end_u, rings, .. } = &problem.datum;
        for (ring, value) in problem.rings.iter().zip(rings) {
            prop_assert_eq!(along(&surface, ring.u)[0], *value);
        }
        let ([q0, q0_u, _], [q1, q1_u, _]) = (along(&surface, 0.0), along(&surface, 1.0));
        prop_assert_eq!([q0, q1], [*start, *end]);
        if problem.order == Order::Fourth {
            prop_assert!(problem.free.start || q0_u == *start_u);
            prop_assert!(problem.free.end || q1_u == *end_u);
        }
    }

    /// Its equation holds between rings, against functions that vanish with their slopes at both: `s <q'', f''> + t k^2 <q', f'> + w k^4 <q, f> = <p, f>`. At a smooth ring this holds for those as well that
    /// vanish there and have a slope, which is what continuity of `q''` means; at a free end, and on either side of a sharp ring, for those that have a slope at it.
    #[test]
    fn the_equation_holds_between_rings(problem in problem()) {
        let Some(surface) = problem.solved() else { return Ok(()) };
        let (places, [s, t, w], k) = (problem.places(), problem.equation, problem.n);
        let force = |u: f64| problem.datum.force.iter().rev().fold(0.0, |sum, f| sum * u + f);
        let n = 4 + problem.rate() as usize;
        // The work of the beam on a function with its first and second derivatives, and its size.
        let work = |from: f64, to: f64, f: &dyn Fn(f64) -> [f64; 3]| {
            let terms = |u: f64| {
                let ([q, q_u, q_uu], [f, f_u, f_uu]) = (along(&surface, u), f(u));
                match problem.order {
                    Order::Fourth => [s * q_uu * f_uu, t * k * k * q_u * f_u, w * k.powi(4) * q * f, -force(u) * f],
                    Order::Second => [-s * q_u * f_u, -t * k * k * q * f, 0.0, -force(u) * f],
                }
            };
            (integral(from, to, n, |u| terms(u).iter().sum()), integral(from, to, n, |u| terms(u).iter().map(|x| x.abs()).sum()))
        };
        // x^3 (1 - x)^3, and x (1 - x)^3, in parts of the interval.
        let bump = |x: f64, h: f64| {
            let y = 1.0 - x;
            [x.powi(3) * y.powi(3), 3.0 * x * x * y * y * (y - x) / h, 6.0 * x * y * (y * y - 3.0 * x * y + x * x) / (h * h)]
        };
        let hinge = |x: f64, h: f64| {
            let y = 1.0 - x;
            [x * y.powi(3), y * y * (y - 3.0 * x) / h, (-6.0 * y * y + 6.0 * x * y) / (h * h)]
        };
        let mirrored = |[f, f_u, f_uu]: [f64; 3]| [-f, f_u, -f_uu];
        let sensitive = if problem.can_swing() { 1e3 } else { 1.0 };
        let within = 1e-10 * sensitive;
        for pair in places.windows(2) {
            let (from, h) = (pair[0], pair[1] - pair[0]);
            let (sum, size) = work(pair[0], pair[1], &|u| bump((u - from) / h, h));
            prop_assert!(sum.abs() <= within * size + 1e-13 * problem.scale() / h.powi(3), "{pair:?}: {sum:e} of {size:e}");
        }
        if problem.order == Order::Second {
            return Ok(());
        }
        for (index, u) in places.iter().copied().enumerate() {
            let before = index.checked_sub(1).map(|i| u - places[i]);
            let after = places.get(index + 1).map(|next| next - u);
            // Slope 1 at the place from either side.
            let left = before.map(|h| work(u - h, u, &|x| mirrored(hinge((u - x) / h, h)).map(|f| f * h)));
            let right = after.map(|h| work(u, u + h, &|x| hinge((x - u) / h, h).map(|f| f * h)));
            let (sums, is_held): (Vec<(f64, f64)>, bool) = match (left, right) {
                (Some(left), Some(right)) if problem.rings[index - 1].sharp => (vec![left, right], true),
                (Some(left), Some(right)) => (vec![(left.0 + right.0, left.1 + right.1)], true),
                (None, Some(right)) => (vec![right], problem.free.start),
                (Some(left), None) => (vec![left], problem.free.end),
                (None, None) => unreachable!(),
            };
            let least = before.into_iter().chain(after).fold(1.0, f64::min);
            for (sum, size) in sums.into_iter().filter(|_| is_held) {
                let rounding = 1e-13 * problem.scale() / (least * least);
                prop_assert!(sum.abs() <= within * size + rounding, "at {u}: {sum:e} of {size:e}, {problem:?}");
            }
        }
    }

    /// `q''` is the same on both sides of a smooth ring, and 0 on both sides of a sharp one; so it is at free ends.
    #[test]
    fn bending_is_continuous_or_none(problem in problem()) {
        let Some(surface) = problem.solved() else { return Ok(()) };
        prop_assume!(problem.order == Order::Fourth && !problem.can_swing());
        let crowding = problem.crowding() * problem.rate();
        let within = 1e-12 * problem.scale() * crowding * crowding;
        for (index, ring) in problem.rings.iter().enumerate() {
            let step = 1e-9 * gap(&problem.shape());
            let (before, after) = (along(&surface, ring.u - step), along(&surface, ring.u));
            let drift = 100.0 * step * crowding.powi(3) * problem.scale();
            if ring.sharp {
                prop_assert!(before[2].abs() < within + drift && after[2].abs() < within, "{index}: {before:?} {after:?}");
            } else {
                prop_assert!((before[2] - after[2]).abs() < within + drift, "{index}: {before:?} {after:?}");
                // A step beside the ring the slope has changed by the bending.
                let bent = step * crowding * crowding * problem.scale();
                let apart = (before[1] - after[1]).abs();
                prop_assert!(apart < 1e-8 * problem.scale() * crowding + 10.0 * bent, "{index}: {before:?} {after:?}");
            }
        }
        for (u, is_free) in [(0.0, problem.free.start), (1.0, problem.free.end)] {
            prop_assert!(!is_free || along(&surface, u)[2].abs() < within);
        }
    }

    /// Affine images of the data give the affine image of the surface.
    #[test]
    fn affine_invariance(problem in problem(), scale in -3.0..3.0f64, shift in -5.0..5.0f64, u in 0.0..=1.0f64) {
        let Some(surface) = problem.solved() else { return Ok(()) };
        let mut image = problem.clone();
        // A constant solves the equation only where nothing draws it back.
        let shift = if problem.n == 0.0 { shift } else { 0.0 };
        let Datum { start, end, start_u, end_u, rings, force } = &mut image.datum;
        for value in [start, end].into_iter().chain(rings) {
            *value = scale * *value + shift;
        }
        for value in [start_u, end_u].into_iter().chain(force) {
            *value *= scale;
        }
        let [given, moved] = [along(&surface, u), along(&image.solved().unwrap(), u)];
        let within = 1e-11 * (1.0 + shift.abs() + scale.abs()) * problem.scale() * if problem.can_swing() { 1e3 } else { 1.0 };
        prop_assert!((moved[0] - (scale * given[0] + shift)).abs() < within, "{given:?} {moved:?}");
    }
}

/// Without rates it is the cubic spline: every cubic is its own, and with free ends every straight line.
#[test]
fn without_rates_it_is_the_cubic_spline() {
    let cubic = |u: f64| 0.3 - 2.0 * u + 5.0 * u * u - 4.0 * u * u * u;
    let slope = |u: f64| -2.0 + 10.0 * u - 12.0 * u * u;
    let places = [0.1, 0.1001, 0.35, 0.36, 0.8];
    let rings: Vec<Ring> = places.iter().map(|&u| Ring { u, sharp: false }).collect();
    for (t, w, n) in [(0.0, 0.0, 7.0), (3.0, 2.0, 0.0)] {
        let datum = Datum {
            start: cubic(0.0),
            end: cubic(1.0),
            start_u: slope(0.0),
            end_u: slope(1.0),
            rings: places.map(cubic).to_vec(),
            force: Vec::new(),
        };
        let problem = Problem {
            order: Order::Fourth,
            equation: [1.0, t, w],
            n,
            rings: rings.clone(),
            free: Free::default(),
            datum,
        };
        let surface = problem.solved().unwrap();
        for i in 0..=100 {
            let u = f64::from(i) / 100.0;
            let [q, q_u, _] = along(&surface, u);
            assert!((q - cubic(u)).abs() < 1e-13 && (q_u - slope(u)).abs() < 1e-11, "{u}: {q} {q_u}");
        }
        // The natural spline through 0, 1, 0: 3 u - 4 u^3 on its first half.
        let datum = Datum { rings: vec![1.0], ..Datum::default() };
        let (rings, free) = (vec![Ring { u: 0.5, sharp: false }], Free { start: true, end: true });
        let natural = Problem { rings, free, datum, ..problem }.solved().unwrap();
        for u in [0.0f64, 0.1, 0.25, 0.5] {
            let expected = 3.0 * u - 4.0 * u * u * u;
            assert!(
                (along(&natural, u)[0] - expected).abs() < 1e-15
                    && (along(&natural, 1.0 - u)[0] - expected).abs() < 1e-15
            );
        }
    }
}

/// Sharp rings one behind the other leave straight lines of what has no rates.
#[test]
fn sharp_rings_are_corners() {
    let surface = surface_of(
        r#"{ "kind": "boundary-value", "span": "2pi", "rings": [{ "u": 0.25, "sharp": true }, { "u": 0.5, "sharp": true }, { "u": 0.75, "sharp": true }],
             "x": { "order": 4, "s": 1, "t": 0, "w": 0, "free": "both", "modes": [{ "n": 1, "cos": { "start": 1, "end": 1, "rings": [2, 1, 3] } }] },
             "y": { "order": 2, "s": 1, "t": 0, "modes": [{ "n": 1, "sin": { "start": 1, "end": 1, "rings": [2, 1, 3] } }] },
             "z": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{ "n": 0, "cos": { "end": 4, "rings": [1, 2, 3] } }] } }"#,
    );
    for (u, q) in [(0.0, 1.0), (0.125, 1.5), (0.25, 2.0), (0.4, 1.4), (0.5, 1.0), (0.625, 2.0), (0.75, 3.0), (1.0, 1.0)]
    {
        let (x, y) = (surface.at(u, 0.0).position.x, surface.at(u, std::f64::consts::FRAC_PI_2).position.y);
        assert!((x - q).abs() < 1e-14 && (y - q).abs() < 1e-14, "{u}: {x} {y}, not {q}");
    }
}

/// What refuses a shape: code, path and sentence.
fn refusal(json: &str) -> (Code, String, String) {
    let error = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {json} }}] }}"#)).unwrap_err();
    (error.code(), error.path().to_owned(), error.message().to_owned())
}

/// A boundary-value shape with these rings and this `x`.
fn written(rings: &str, x: &str) -> String {
    format!(
        r#"{{ "kind": "boundary-value", "span": "2pi", "rings": {rings}, "x": {x},
              "y": {{ "order": 2, "s": 1, "t": 1, "modes": [] }}, "z": {{ "order": 2, "s": 1, "t": 1, "modes": [] }} }}"#
    )
}

fn fourth(fields: &str, cos: &str) -> String {
    format!(r#"{{ "order": 4, "s": 1, "t": 2, "w": 1, {fields} "modes": [{{ "n": 1, "cos": {{ {cos} }} }}] }}"#)
}

#[test]
fn what_does_not_fit_together_is_refused_in_words() {
    let two = r#"[{ "u": 0.25 }, { "u": 0.5, "sharp": true }]"#;
    let cases = [
        (written(two, &fourth("", r#""rings": [1, 2, 3]"#)), Code::WrongType, "x.modes[0].cos.rings", "expected a list of 2 numbers, one for each ring, found a list of 3"),
        (written("[]", &fourth("", r#""rings": [1]"#)), Code::WrongType, "x.modes[0].cos.rings", "expected no values, as there are no rings"),
        (written(two, &fourth("", r#""rings": [1, "a"]"#)), Code::WrongType, "x.modes[0].cos.rings[1]", "expected a number, found \"a\""),
        (written(r#"[{ "u": 0.5 }, { "u": 0.5 }]"#, &fourth("", "")), Code::OutOfRange, "rings[1].u", "expected a number greater than 0.5 and less than 1, found 0.5"),
        (written(r#"[{ "u": 0 }]"#, &fourth("", "")), Code::OutOfRange, "rings[0].u", "expected a number greater than 0 and less than 1, found 0"),
        (written(r#"[{ "u": 1 }]"#, &fourth("", "")), Code::OutOfRange, "rings[0].u", "expected a number greater than 0 and less than 1, found 1"),
        (written(r#"[{ "u": 0.5, "sharp": 1 }]"#, &fourth("", "")), Code::WrongType, "rings[0].sharp", "expected a boolean, found 1"),
        (written(r#"[{ "u": 0.5, "v": 1 }]"#, &fourth("", "")), Code::UnknownField, "rings[0].v", "unknown field \"v\"; expected one of u, sharp"),
        (written(r#"[{ "sharp": true }]"#, &fourth("", "")), Code::MissingField, "rings[0].u", "expected a number, found nothing"),
        (written(r#"[0.5]"#, &fourth("", "")), Code::WrongType, "rings[0]", "expected a ring with its u, found 0.5"),
        (written(two, &fourth(r#""free": "start","#, r#""start_u": 3"#)), Code::OutOfRange, "x.modes[0].cos.start_u", "expected no slope at a free end, found 3"),
        (written(two, &fourth(r#""free": "both","#, r#""end_u": -1"#)), Code::OutOfRange, "x.modes[0].cos.end_u", "expected no slope at a free end, found -1"),
        (written(two, &fourth(r#""free": "none","#, "")), Code::UnknownName, "x.free", "expected \"start\", \"end\" or \"both\", found \"none\""),
        (written(two, r#"{ "order": 2, "s": 1, "t": 1, "free": "both", "modes": [] }"#), Code::UnknownField, "x.free", "unknown field \"free\"; expected one of order, s, t, modes"),
        (r#"{ "kind": "rings", "rings": [{ "u": 0, "r": { "mean": 1 }, "z": { "mean": 0 } }] }"#.to_owned(), Code::OutOfRange, "rings", "expected a list of 2 to 66 rings, found a list of 1"),
        (pot(&[0.1, 0.5, 1.0], ""), Code::OutOfRange, "rings[0].u", "expected 0, the foot, found 0.1"),
        (pot(&[0.0, 0.5, 0.9], ""), Code::OutOfRange, "rings[2].u", "expected 1, the rim, found 0.9"),
        (pot(&[0.0, 0.5, 0.4, 1.0], ""), Code::OutOfRange, "rings[2].u", "expected a number greater than 0.5 and less than 1, found 0.4"),
        (pot(&[0.0, 1.0], r#", "waves": [{ "n": 1.5, "cos": 1 }]"#), Code::OutOfRange, "rings[0].r.waves[0].n", "expected a whole number, 1 or greater, found 1.5"),
        (pot(&[0.0, 1.0], r#", "waves": [{ "n": 0, "cos": 1 }]"#), Code::OutOfRange, "rings[0].r.waves[0].n", "expected a whole number, 1 or greater, found 0"),
        (r#"{ "kind": "rings", "rings": [{ "u": 0, "r": { "mean": 1 } }, { "u": 1, "r": { "mean": 1 }, "z": { "mean": 1 } }] }"#.to_owned(), Code::MissingField, "rings[0].z", "expected a mean with waves, found nothing"),
    ];
    for (json, code, path, message) in cases {
        assert_eq!(refusal(&json), (code, format!("parts[0].shape.{path}"), message.to_owned()));
    }
    let many: Vec<String> = (1..=65).map(|i| format!(r#"{{ "u": {} }}"#, f64::from(i) / 66.0)).collect();
    let (code, path, message) = refusal(&written(&format!("[{}]", many.join(",")), &fourth("", "")));
    assert_eq!(
        (code, path.as_str(), message.as_str()),
        (Code::TooLarge, "parts[0].shape.rings", "expected at most 64 rings, found 65")
    );
}

/// A plain pot of rings at these places; `more` stands in its first radius.
fn pot(places: &[f64], more: &str) -> String {
    let rings = places.iter().enumerate().map(|(index, u)| {
        let more = if index == 0 { more } else { "" };
        format!(r#"{{ "u": {u}, "r": {{ "mean": 4{more} }}, "z": {{ "mean": {index} }} }}"#)
    });
    format!(r#"{{ "kind": "rings", "rings": [{}] }}"#, rings.collect::<Vec<String>>().join(","))
}

#[test]
fn rings_too_near_each_other_and_resonance_are_refused_by_ring_and_mode() {
    let solve = |shape: &BoundaryValue| {
        Surface::solve(shape, "shape").map(drop).map_err(|e| (e.code(), e.path().to_owned(), e.message().to_owned()))
    };
    let problem = Problem {
        order: Order::Fourth,
        equation: [1.0, 2.0, 1.0],
        n: 3.0,
        rings: vec![Ring { u: 0.25, sharp: false }, Ring { u: 0.250_000_5, sharp: false }],
        free: Free::default(),
        datum: Datum { rings: vec![1.0, 1.0], ..Datum::default() },
    };
    let (code, path, message) = solve(&problem.shape()).unwrap_err();
    assert_eq!((code, path.as_str()), (Code::OutOfRange, "shape.rings[1].u"));
    assert!(message.contains("u = 0.25 and u = 0.2500005") && message.contains("n = 3"), "{message}");
    // Half a wave from ring to ring, without tension: sin(2 pi u) passes through all of them by itself.
    let rings = vec![Ring { u: 0.5, sharp: false }];
    let squared = std::f64::consts::TAU * std::f64::consts::TAU;
    let swinging = |order: Order, t: f64| Problem {
        order,
        equation: [1.0, t, 0.0],
        n: 1.0,
        rings: rings.clone(),
        free: Free { start: order == Order::Fourth, end: order == Order::Fourth },
        datum: Datum { rings: vec![1.0], ..Datum::default() },
    };
    for (order, place) in [(Order::Second, "from u = 0 to u = 0.5"), (Order::Fourth, "from u = 0 to u = 1")] {
        let (code, path, message) = solve(&swinging(order, -squared).shape()).unwrap_err();
        assert_eq!((code, path.as_str()), (Code::ResonantProblem, "shape.x.modes[0]"));
        assert!(message.contains("n = 1") && message.contains(place), "{message}");
        assert!(solve(&swinging(order, -1.01 * squared).shape()).is_ok());
    }
}

/// With `t < 0` what is between two corners swings by itself where whole half waves fit in: refused with the mode and the rings between which they do, at every such `t`, and solved a little beside it.
#[test]
fn what_swings_between_two_rings_is_refused_by_them_and_its_mode() {
    let places = [0.0, 0.2, 0.55, 1.0];
    for order in [Order::Second, Order::Fourth] {
        for (bay, pair) in places.windows(2).enumerate() {
            for half_waves in 1..=3 {
                let n = 2.0;
                let rate = f64::from(half_waves) * std::f64::consts::PI / (n * (pair[1] - pair[0]));
                let problem = |t: f64| Problem {
                    order,
                    equation: [1.0, t, 0.0],
                    n,
                    rings: [0.2, 0.55].map(|u| Ring { u, sharp: true }).to_vec(),
                    free: Free { start: order == Order::Fourth, end: order == Order::Fourth },
                    datum: Datum { start: 0.3, rings: vec![1.0, -0.5], ..Datum::default() },
                };
                let error = Surface::solve(&problem(-rate * rate).shape(), "shape").unwrap_err();
                let between = format!("from u = {} to u = {}", pair[0], pair[1]);
                assert_eq!((error.code(), error.path()), (Code::ResonantProblem, "shape.x.modes[0]"));
                assert!(
                    error.message().contains("n = 2") && error.message().contains(&between),
                    "{order:?} {bay}: {error}"
                );
                let beside = problem(-1.003 * rate * rate).solved().unwrap();
                // It still passes through what it is given, and is no larger than a swing so near its own can be.
                assert_eq!(along(&beside, 0.2)[0], 1.0);
                let largest = (0..=200).map(|i| along(&beside, f64::from(i) / 200.0)[0].abs()).fold(0.0, f64::max);
                assert!(largest < 1e4, "{order:?} {bay}: {largest}");
            }
        }
    }
}

/// Whatever `t < 0` and the rings: refused by mode and rings, or so well decided that a change of the data by a millionth of a millionth is not seen in the ninth digit.
#[test]
fn with_negative_t_there_is_a_sound_answer_or_a_refusal() {
    let (mut solved, mut refused) = (0, 0);
    for order in [Order::Second, Order::Fourth] {
        for sharp in [false, true] {
            for step in 1..=2000 {
                let t = -0.05 * f64::from(step);
                let problem = |by: f64| Problem {
                    order,
                    equation: [1.0, t, 0.0],
                    n: 3.0,
                    rings: vec![Ring { u: 0.3, sharp }, Ring { u: 0.45, sharp: false }, Ring { u: 0.8, sharp }],
                    free: Free { start: order == Order::Fourth, end: false },
                    datum: Datum { start: 1.0, end: 0.4, rings: vec![0.7 + by, -0.2, 0.9], ..Datum::default() },
                };
                let (one, other) = match (Surface::solve(&problem(0.0).shape(), ""), problem(1e-12).solved()) {
                    (Ok(one), Some(other)) => (one, other),
                    (Err(error), None) => {
                        assert_eq!(error.code(), Code::ResonantProblem, "{error}");
                        assert!(error.message().contains("n = 3") && error.message().contains("from u = "), "{error}");
                        refused += 1;
                        continue;
                    }
                    (first, _) => panic!("one of two neighbours is refused: {first:?}"),
                };
                solved += 1;
                for i in 0..=20 {
                    let u = f64::from(i) / 20.0;
                    let [q, p] = [&one, &other].map(|surface| along(surface, u)[0]);
                    assert!(q.is_finite() && (q - p).abs() < 1e-6, "{order:?} t = {t} at {u}: {q} {p}");
                }
            }
        }
    }
    assert!(solved > 7900 && solved + refused == 8000, "{solved} solved, {refused} refused");
}

#[test]
fn a_shape_without_rings_is_written_as_it_was() {
    let text = |rings: &str, free: &str| {
        let x = fourth(free, r#""start": 1, "end": 2, "rings": []"#);
        format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {} }}] }}"#, written(rings, &x))
    };
    let json = Design::parse(&text("[]", "")).unwrap().to_json();
    assert!(!json.contains("rings") && !json.contains("free"), "{json}");
    let free = Design::parse(&text(r#"[{ "u": 0.5, "sharp": false }]"#, r#""free": "end","#)).unwrap().to_json();
    assert!(free.contains(r#""rings":[{"u":0.5}]"#) && free.contains(r#""w":1,"free":"end","modes""#), "{free}");
    assert_eq!(Design::parse(&free).unwrap().to_json(), free);
}

#[test]
fn canonical_rings_are_written_in_one_way() {
    let shape = r#"{ "kind": "rings", "a": 1, "rings": [
        { "u": 0, "sharp": true, "r": { "mean": 4, "waves": [] }, "z": { "mean": 0 } },
        { "u": 0.50000000000001, "r": { "mean": 6, "waves": [{ "n": 3, "sin": 0.5 }, { "n": 1, "cos": 0.25 }, { "n": 3, "cos": 1 }, { "n": 2 }] }, "z": { "mean": 7 }, "sharp": false },
        { "u": 1, "r": { "mean": 4.5 }, "z": { "mean": 14 } }], "rim": { "r": { "mean": 0 }, "z": { "mean": 3 } } }"#;
    let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#)).unwrap();
    assert_eq!(
        design.to_json(),
        r#"{"pasu":1,"parts":[{"shape":{"kind":"rings","rings":[{"u":0,"r":{"mean":4},"z":{"mean":0}},{"u":0.5,"r":{"mean":6,"waves":[{"n":1,"cos":0.25},{"n":3,"cos":1,"sin":0.5}]},"z":{"mean":7}},{"u":1,"r":{"mean":4.5},"z":{"mean":14}}],"rim":{"r":{"mean":0},"z":{"mean":3}}}}]}"#
    );
    assert_eq!(design.link(), "1/rings?r=4,6~1:.25~3:1:.5,4.5&z=0,7,14&rim=0,3");
    assert_eq!(Design::parse(&design.link()).unwrap(), design);
}

#[test]
fn a_plain_bottle_of_five_rings_has_a_short_link() {
    let link =
        "1/rings?r=3.5,6.25,5.75,1.6,2.35&z=0,5.5,11,17.25,22.5&u=.275,.55,.825&sharp=3&a=.5&title=Bottle&glaze=shino";
    let design = Design::parse(link).unwrap();
    assert_eq!(design.link(), link);
    assert!(design.link().len() < 200);
    assert_eq!(Design::parse(&design.to_json()).unwrap().link(), link);
}

#[test]
fn links_of_rings_say_what_differs_from_the_bottle() {
    for (given, canonical) in [
        ("rings", "rings"),
        ("rings?a=1", "rings"),
        ("rings?u=.35,.7", "rings"),
        ("rings?r=3,6,1.6,2.2", "rings?u=.333333333333,.666666666667"),
        ("rings?u=.333333333333,.666666666667", "rings?u=.333333333333,.666666666667"),
        ("rings?r=3,6,1.6,2.2&z=0,6,15,21", "rings?r=3,6,1.6,2.2&z=0,6,15,21"),
        ("rings?r=3,6,1.6,2.2&z=0,6,15,21&u=.35,.7", "rings?r=3,6,1.6,2.2&z=0,6,15,21&u=.35,.7"),
        ("rings?r=3,4&z=0,9&foot=1~2:.5,6&rim=0,3~4:0:.5", "rings?r=3,4&z=0,9&foot=1~2:.5,6&rim=0,3~4:0:.5"),
        ("rings?sharp=1,2&a=2", "rings?sharp=1,2&a=2"),
        ("rings?sharp=0", "rings"),
    ] {
        let design = Design::parse(&format!("#1/{given}")).unwrap_or_else(|error| panic!("{given}: {error}"));
        assert_eq!(design.link(), format!("1/{canonical}"), "{given}");
        assert_eq!(Design::parse(&design.link()).unwrap(), design);
        assert_eq!(Design::parse(&design.to_json()).unwrap(), design);
    }
    for (given, code, path) in [
        ("rings?r=3,4", Code::MissingField, "rings[2].r"),
        ("rings?r=3,4&z=0,1,2", Code::MissingField, "rings[2].r"),
        ("rings?r=3,x&z=0,1", Code::WrongType, "rings[1].r.mean"),
        ("rings?r=3,4~1.5:2&z=0,1", Code::OutOfRange, "rings[1].r.waves[0].n"),
        ("rings?r=3,4~1:2:3:4&z=0,1", Code::UnknownField, "rings[1].r.waves[0].3"),
        ("rings?r=3,4&z=0,1&u=.5", Code::WrongType, "rings"),
        ("rings?sharp=4", Code::OutOfRange, "rings"),
        ("rings?sharp=x", Code::OutOfRange, "rings"),
        ("rings?foot=3", Code::MissingField, "foot.z"),
        ("rings?foot=3,4,5", Code::UnknownField, "foot.2"),
        ("rings?a=1&a=2", Code::Duplicate, "a"),
        ("rings?b=1", Code::UnknownField, "b"),
    ] {
        let error = Design::parse(&format!("#1/{given}")).unwrap_err();
        assert_eq!((error.code(), error.path()), (code, format!("parts[0].shape.{path}").as_str()), "{given}: {error}");
    }
}

/// The products of waves, against `r(v) cos v` and `r(v) sin v` themselves.
#[test]
fn a_pot_passes_through_its_rings() {
    for case in ring_cases().iter().filter_map(|case| case.family.as_ref()) {
        let surface = surface(case);
        let series = |of: &serde_json::Value, v: f64| {
            let waves = of["waves"].as_array().into_iter().flatten().map(|wave| {
                let [n, cos, sin] = ["n", "cos", "sin"].map(|name| wave[name].as_f64().unwrap_or(0.0));
                cos * (n * v).cos() + sin * (n * v).sin()
            });
            of["mean"].as_f64().unwrap() + waves.sum::<f64>()
        };
        let near = |found: DVec3, expected: DVec3| assert!((found - expected).length() < 1e-13, "{found} {expected}");
        let at = |of: &serde_json::Value, v: f64| {
            let (r, z) = (series(&of["r"], v), series(&of["z"], v));
            DVec3::new(r * v.cos(), r * v.sin(), z)
        };
        for i in 0..29 {
            let v = f64::from(i) * 0.23;
            for ring in case["rings"].as_array().unwrap() {
                near(surface.at(ring["u"].as_f64().unwrap(), v).position, at(ring, v));
            }
            for (name, u) in [("foot", 0.0), ("rim", 1.0)] {
                let jet = surface.at(u, v);
                match case.get(name) {
                    Some(slopes) => near(jet.du, at(slopes, v)),
                    None => assert!(jet.duu.length() < 1e-10, "{}", jet.duu),
                }
            }
        }
    }
}

const SMOOTH: &str = r#"{ "kind": "rings", "rings": [{ "u": 0, "r": { "mean": 3 }, "z": { "mean": 0 } }, { "u": 0.35, "r": { "mean": 6, "waves": [{ "n": 3, "cos": 0.4 }] }, "z": { "mean": 6 } },
    { "u": 0.7, "r": { "mean": 2 }, "z": { "mean": 15 } }, { "u": 1, "r": { "mean": 2.6 }, "z": { "mean": 20 } }] }"#;

/// A cone on a cone on a cone: straight between corners, because nothing draws at the wall.
const CORNERED: &str = r#"{ "kind": "rings", "a": 0, "rings": [{ "u": 0, "r": { "mean": 3 }, "z": { "mean": 0 } }, { "u": 0.3, "sharp": true, "r": { "mean": 6 }, "z": { "mean": 4 } },
    { "u": 0.55, "sharp": true, "r": { "mean": 2 }, "z": { "mean": 9 } }, { "u": 1, "r": { "mean": 3 }, "z": { "mean": 11 } }] }"#;

fn design_with(shape: &str, more: &str) -> Design {
    Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}{more} }}] }}"#)).unwrap()
}

/// The triangles of a grid against the surface: at the middles of both triangles' sides and of each triangle, which are where they are farthest from it.
#[test]
fn meshes_keep_their_bound_and_have_rows_on_rings() {
    let shapes: Vec<String> =
        ring_cases().iter().map(|case| case.family.as_ref().unwrap_or(&case.shape).to_string()).collect();
    for shape in shapes.iter().map(String::as_str).chain([SMOOTH, CORNERED]) {
        let design = design_with(shape, "");
        let problem = design.parts()[0].shape.boundary_value().unwrap();
        let surface = Surface::of_part(&design.parts()[0], 0).unwrap();
        let has_corners = |component: &Component| component.order == Order::Second && !component.modes.is_empty();
        let is_cornered = [&problem.x, &problem.y, &problem.z].into_iter().any(has_corners);
        for options in [
            MeshOptions { tolerance: Some(0.02), ..MeshOptions::default() },
            MeshOptions { rows: Some(80), columns: Some(96), tolerance: None },
            MeshOptions { rows: Some(80), ..MeshOptions::default() },
            MeshOptions { columns: Some(96), ..MeshOptions::default() },
        ] {
            let mesh = mesh(&design, &options).unwrap();
            let bound = pasu::bound(&design, &options).unwrap();
            assert!(options.tolerance.is_none_or(|tolerance| bound <= tolerance));
            let columns = mesh.uvs.chunks_exact(2).take_while(|uv| uv[0] == 0.0).count();
            let rows: Vec<f32> = mesh.uvs.chunks_exact(2 * columns).map(|row| row[0]).collect();
            assert!(options.rows.is_none_or(|n| n == rows.len()) && rows.is_sorted());
            let corners = problem.rings.iter().filter(|ring| ring.sharp || is_cornered).count();
            for ring in &problem.rings {
                let n = rows.iter().filter(|row| **row == ring.u as f32).count();
                assert_eq!(n, if ring.sharp || is_cornered { 2 } else { 1 }, "{shape}: {rows:?}");
            }
            assert_eq!(mesh.n_triangles(), 2 * (rows.len() - 1 - corners) * (columns - 1));
            let vertex = |index: u32| {
                DVec3::from_slice(
                    &mesh.positions[3 * index as usize..][..3].iter().map(|x| f64::from(*x)).collect::<Vec<f64>>(),
                )
            };
            let place = |index: u32| [0, 1].map(|i| f64::from(mesh.uvs[2 * index as usize + i]));
            let mut worst = 0.0f64;
            for triangle in mesh.indices.chunks_exact(3).step_by(23) {
                for weights in [[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [1.0 / 3.0; 3]] {
                    let point: DVec3 =
                        triangle.iter().zip(weights).map(|(index, weight)| vertex(*index) * weight).sum();
                    // Nearest in the parameters, by a few steps of Newton's: surface and triangles are compared where they are nearest.
                    let [mut u, mut v] = [0, 1].map(|i| {
                        triangle.iter().zip(weights).map(|(index, weight)| place(*index)[i] * weight).sum::<f64>()
                    });
                    let [least, most] =
                        [f64::min, f64::max].map(|of| triangle.iter().map(|index| place(*index)[0]).fold(u, of));
                    let mut distance = f64::INFINITY;
                    for _ in 0..6 {
                        let jet = surface.at(u, v * surface.span());
                        let (du, dv) = (jet.du, jet.dv * surface.span());
                        let away = point - jet.position;
                        distance = distance.min(away.length());
                        let (a, b, c) = (du.dot(du), du.dot(dv), dv.dot(dv));
                        let (p, q) = (away.dot(du), away.dot(dv));
                        let determinant = a * c - b * b;
                        if !(determinant > 1e-12 * a * c) {
                            break;
                        }
                        u = (u + (c * p - b * q) / determinant).clamp(least, most);
                        v += (a * q - b * p) / determinant;
                    }
                    worst = worst.max(distance);
                }
            }
            assert!(worst <= bound * 1.001 + 1e-5, "{shape} {options:?}: {worst} beyond {bound}");
            if shape == CORNERED {
                for row in (0..rows.len() - 1).filter(|row| rows[*row] == rows[row + 1]) {
                    let [before, after] = [0, 1].map(|next| 3 * (row + next) * columns);
                    assert_eq!(mesh.positions[before..][..3 * columns], mesh.positions[after..][..3 * columns]);
                    let [one, other] =
                        [before, after].map(|at| DVec3::new(mesh.normals[at].into(), 0.0, mesh.normals[at + 2].into()));
                    assert!(one.dot(other) < 0.7, "{one} {other}");
                }
            }
        }
        // Single precision and double say the same to what is promised of a picture.
        let rough = mesh(&design, &MeshOptions { rows: Some(60), columns: Some(61), tolerance: None }).unwrap();
        let size = rough.positions.iter().fold(0.0f32, |most, x| most.max(x.abs()));
        for (uv, position) in rough.uvs.chunks_exact(2).zip(rough.positions.chunks_exact(3)).step_by(7) {
            let exact = surface.at(uv[0].into(), f64::from(uv[1]) * surface.span()).position;
            let found = DVec3::new(position[0].into(), position[1].into(), position[2].into());
            // The places of rows are rounded for a picture's texture.
            assert!((found - exact).length() < 3e-5 * f64::from(size), "{shape}: {found} {exact} at {uv:?}");
        }
    }
}

#[test]
fn rows_given_are_too_few_for_the_rings() {
    let many: Vec<f64> = (0..=65).map(|i| f64::from(i) / 65.0).collect();
    let design = design_with(&pot(&many, ""), "");
    let mesh = mesh(&design, &MeshOptions { rows: Some(9), columns: Some(9), tolerance: None }).unwrap();
    assert_eq!(mesh.n_triangles(), 128);
    assert_eq!(fingerprint(&design).unwrap().len(), 16);
    let sharp = design_with(&pot(&many, "").replace(r#""z""#, r#""sharp": true, "z""#), "");
    assert_eq!(fingerprint(&design).unwrap(), fingerprint(&sharp).unwrap(), "a straight line has no corners");
}

#[test]
fn a_cone_on_a_cone_measures_as_it_does_by_formula() {
    let cones = [(3.0, 0.0), (6.0, 4.0), (2.0, 9.0), (3.0, 11.0f64)];
    let (mut area, mut volume) = (0.0, 0.0);
    for pair in cones.windows(2) {
        let [(r, z), (s, y)] = [pair[0], pair[1]];
        let slant = f64::hypot(s - r, y - z);
        area += std::f64::consts::PI * (r + s) * slant;
        volume += std::f64::consts::PI / 3.0 * (y - z) * (r * r + r * s + s * s);
    }
    // The order of the equation, and which end is the foot, make no difference.
    let second = r#"{ "kind": "boundary-value", "span": 1, "rings": [{ "u": 0.2 }, { "u": 0.7 }],
        "x": { "order": 2, "s": 1, "t": 0, "modes": [{ "n": 1, "cos": { "start": 3, "rings": [2, 6], "end": 3 } }] },
        "y": { "order": 2, "s": 1, "t": 0, "modes": [{ "n": 1, "sin": { "start": 3, "rings": [2, 6], "end": 3 } }] },
        "z": { "order": 2, "s": 1, "t": 0, "modes": [{ "n": 0, "cos": { "start": 11, "rings": [9, 4] } }] } }"#;
    for shape in [CORNERED, second] {
        let measures = measure(&design_with(shape, ""), &MeasureOptions::default()).unwrap();
        let found = measures.whole.area;
        assert!((found.value - area).abs() < 1e-10 * area && found.error < 1e-8 * area, "{found:?} {area}");
        let brim = measures.whole.capacity.unwrap().brim;
        assert!((brim.value - volume).abs() < 1e-9 * volume && brim.error < 1e-7 * volume, "{brim:?} {volume}");
    }
}

/// The area of a bottle and what it holds against dense sums between its rings.
#[test]
fn a_bottle_measures_as_it_does_by_dense_sums() {
    let design = design_with(SMOOTH, "");
    let surface = Surface::of_part(&design.parts()[0], 0).unwrap();
    let (columns, places) = (64, [0.0, 0.35, 0.7, 1.0]);
    let round = |of: &dyn Fn(&pasu::SurfaceJet) -> f64, u: f64| {
        let step = std::f64::consts::TAU / f64::from(columns);
        (0..columns).map(|j| of(&surface.at(u, f64::from(j) * step))).sum::<f64>() * step
    };
    let sum = |of: &dyn Fn(&pasu::SurfaceJet) -> f64| {
        places.windows(2).map(|pair| integral(pair[0], pair[1], 24, |u| round(of, u))).sum::<f64>()
    };
    let area = sum(&|jet| jet.du.cross(jet.dv).length());
    // All rows are level: the area that each goes round, times its rise.
    let volume = sum(&|jet| 0.5 * (jet.position.x * jet.dv.y - jet.position.y * jet.dv.x) * jet.du.z);
    let measures = measure(&design, &MeasureOptions::default()).unwrap();
    let (found, brim) = (measures.whole.area, measures.whole.capacity.unwrap().brim);
    assert!((found.value - area).abs() < 1e-10 * area, "{found:?} {area}");
    assert!((brim.value - volume).abs() < 1e-9 * volume, "{brim:?} {volume}");
}

/// A bottle with a wall passes every check, and all formats write it; its triangles go round the clay that is measured.
#[test]
fn a_bottle_of_rings_is_made() {
    let design = design_with(SMOOTH, r#", "wall": { "thickness": 0.3, "base": 0.4 }"#);
    let report = check(&design, &Making::default()).unwrap();
    assert!(report.is_ok(), "{:?}", report.findings);
    let clay = measure(&design, &MeasureOptions::default()).unwrap().whole.clay.unwrap().volume;
    let meshes = solid(&design, &Making::default()).unwrap();
    let volume: f64 = meshes
        .iter()
        .map(|mesh| {
            let at = |index: u32| {
                DVec3::from_slice(
                    &mesh.positions[3 * index as usize..][..3]
                        .iter()
                        .map(|x| f64::from(*x) / 10.0)
                        .collect::<Vec<f64>>(),
                )
            };
            mesh.indices.chunks_exact(3).map(|t| at(t[0]).cross(at(t[1])).dot(at(t[2])) / 6.0).sum::<f64>()
        })
        .sum();
    assert!((volume - clay.value).abs() < 2e-3 * clay.value, "{volume} {clay:?}");
    for format in Format::ALL {
        assert!(!write(&design, format, &Making::default()).unwrap().is_empty(), "{format:?}");
    }
}
