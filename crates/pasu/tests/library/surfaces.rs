//! Two-sided surfaces against the reference corpus and against the properties that make them solutions.

use crate::support::{Point, corpus, digits, problem_of, rate, shape, surface, surface_of};
use glam::DVec3;
use pasu::{BoundaryValue, Component, Datum, Equation, Free, Mode, ModeData, Order, Span, Surface, Unsolvable};
use proptest::prelude::*;

/// Positions within 1e-13 of the scale of the case, derivatives within 1e-12 of the largest of the same kind in the case: stricter than
/// 1e-12 of what they may grow to, `scale * max(1, k sqrt(t/s))`. Found are 7e-15 and 1.2e-13.
#[test]
fn every_case_of_the_corpora() {
    let (cases, digits) = (corpus(), digits());
    assert!(cases.len() >= 60 && digits.len() >= 80);
    let (mut worst, mut failures) = ([0.0f64; 3], Vec::new());
    for case in cases.iter().chain(&digits) {
        let largest = |of: fn(&Point) -> [f64; 3]| case.points.iter().flat_map(of).map(f64::abs).fold(0.0, f64::max);
        let sizes = [case.scale, largest(|point| point.du), largest(|point| point.dv)];
        for given in case.family.iter().chain([&case.shape]) {
            let surface = surface(given);
            for point in &case.points {
                let jet = surface.at(point.u, point.v);
                let pairs = [(jet.position, point.position), (jet.du, point.du), (jet.dv, point.dv)];
                for (i, (found, expected)) in pairs.into_iter().enumerate() {
                    let error = (found - DVec3::from(expected)).abs().max_element() / sizes[i];
                    if !(error <= [1e-13, 1e-12, 1e-12][i]) {
                        let what = ["position", "du", "dv"][i];
                        failures
                            .push(format!("{} at ({}, {}): {what} is off by {error:e}", case.name, point.u, point.v));
                    }
                    worst[i] = worst[i].max(error);
                }
            }
        }
    }
    println!("{} cases, worst errors {worst:?}", cases.len() + digits.len());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn families_are_the_shapes_of_the_corpus() {
    for case in corpus() {
        if let Some(family) = &case.family {
            let (found, expected) = (problem_of(family), problem_of(&case.shape));
            for (v, u) in [(0.1, 0.2), (0.9, 0.7)] {
                let [a, b] = [&found, &expected].map(|s| Surface::solve(s, "").unwrap().at(u, v).position);
                assert!((a - b).length() < 1e-14 * case.scale, "{}", case.name);
            }
        }
    }
}

#[test]
fn resonance_names_component_and_mode() {
    let resonant = |t: f64| {
        let shape = BoundaryValue {
            span: Span::Tau,
            rings: Vec::new(),
            x: component(Order::Second, 1.0, 1.0, 0.0, 1.0),
            y: component(Order::Second, 1.0, t, 0.0, 2.0),
            z: component(Order::Second, 1.0, 1.0, 0.0, 0.0),
        };
        Surface::solve(&shape, "parts[3].shape")
            .map_err(|e| (e.code().as_str(), e.path().to_owned(), e.message().to_owned()))
    };
    // k sqrt(-t/s) = 2 sqrt(-t) = 3 pi
    let t = -(1.5 * std::f64::consts::PI) * (1.5 * std::f64::consts::PI);
    let (code, path, message) = resonant(t).unwrap_err();
    assert_eq!((code, path.as_str()), ("resonant-problem", "parts[3].shape.y.modes[0]"));
    assert!(message.contains("component y") && message.contains("n = 2"), "{message}");
    assert!(resonant(t * 1.01).is_ok());
    assert_eq!(resonant(f64::NAN).unwrap_err().0, "overflow");
}

#[test]
fn order_4_resonance_is_refused() {
    // A beam clamped at both ends vibrates by itself where cos(beta) cosh(beta) = 1.
    for beta in [4.730_040_744_862_704, 7.853_204_624_095_838, 10.995_607_838_001_67] {
        let beam = |beta: f64| Equation::new(Order::Fourth, 1.0, 0.0, -1.0, beta);
        assert_eq!(beam(beta), Err(Unsolvable::Resonant), "beta = {beta}");
        assert!(beam(beta * 1.001).is_ok() && beam(beta * 0.999).is_ok());
    }
    // Within the reach of the power series.
    assert_eq!(Equation::new(Order::Fourth, 1.0, -1.0, 0.0, 2.0 * std::f64::consts::PI), Err(Unsolvable::Resonant));
}

fn component(order: Order, s: f64, t: f64, w: f64, n: f64) -> Component {
    let cos = Datum { start: 1.0, end: 0.5, start_u: 0.0, end_u: 0.0, ..Datum::default() };
    Component { order, s, t, w, free: Free::default(), modes: vec![Mode { n, cos, sin: Datum::default() }] }
}

/// Equations biased to the hard places: near-equal roots, vanishing parameters, slow and fast rates.
fn equation() -> impl Strategy<Value = (Order, f64, f64, f64, f64)> {
    let rate = prop_oneof![Just(0.0), (-8.0..3.0f64).prop_map(|e| 10f64.powf(e)), 0.5..40.0f64, 3.9..4.1f64];
    let near = prop_oneof![
        Just(0.0),
        (-16.0..0.0f64).prop_map(|e| 10f64.powf(e)),
        (-16.0..0.0f64).prop_map(|e| -10f64.powf(e))
    ];
    let ratio = prop_oneof![
        Just(1.0),
        Just(0.0),
        0.0..1.0f64,
        near.clone().prop_map(|d| (1.0 + d).clamp(0.0, 2.0)),
        near.prop_map(f64::abs)
    ];
    let s = prop_oneof![Just(1.0), Just(-1.0), 0.01..100.0f64];
    (any::<bool>(), rate, ratio, s, prop_oneof![Just(0), Just(0), 1..3u8]).prop_map(|(second, k, ratio, s, kind)| {
        if second {
            (Order::Second, s, s, 0.0, k)
        } else {
            // Squared roots k^2 and ratio k^2; or complex with the same product; or one of them imaginary.
            let (t, w) = match kind {
                0 => (1.0 + ratio, ratio),
                1 => (2.0 * ratio.sqrt() * 0.9, ratio),
                _ => (1.0 - ratio, -ratio),
            };
            (Order::Fourth, s, s * t, s * w, k)
        }
    })
}

fn data() -> impl Strategy<Value = ([f64; 4], Vec<f64>)> {
    (prop::array::uniform4(-1.0..1.0f64), prop::collection::vec(-2.0..2.0f64, 0..8))
}

fn polynomial(force: &[f64], u: f64) -> f64 {
    force.iter().rev().fold(0.0, |sum, f| sum * u + f)
}

/// Steps that move the coefficients t k^2 and w k^4 by 1e-11 at most; near a resonance q is as large as it is sensitive.
fn moved_by_little(
    (order, s, t, w, k): (Order, f64, f64, f64, f64),
    [start, end, start_u, end_u]: [f64; 4],
    force: &[f64],
    u: f64,
    nudge: f64,
) -> core::result::Result<(), TestCaseError> {
    let solve = |t: f64, w: f64| {
        let equation = Equation::new(order, s, t, w, k).ok()?;
        let solution = equation.solve(&ModeData { start, end, start_u, end_u, force }).ok()?;
        let [[q, q_u]] = equation.jets::<2, 1>([&solution], u);
        Some((q, q_u, equation.largest_rate().max(1.0)))
    };
    let step = 1e-11 * nudge * s / k.max(1.0).powi(2);
    if let (Some((q, q_u, rate)), Some((p, p_u, _))) = (solve(t, w), solve(t + step, w - step / k.max(1.0).powi(2))) {
        let size = (1.0 + q * q).max(1.0 + q_u * q_u / (rate * rate));
        prop_assert!((q - p).abs() < 1e-9 * size, "{q} {p}");
        prop_assert!((q_u - p_u).abs() < 1e-9 * rate * size, "{q_u} {p_u}");
    }
    Ok(())
}

#[test]
fn two_double_roots_at_zero_of_a_high_wave_move_continuously() {
    let (ends, nudge) = ([0.0, 0.0, 0.0, -0.8409718125269074], 0.6105018846974329);
    moved_by_little((Order::Fourth, 1.0, 0.0, 0.0, 190.18504592672312), ends, &[], 0.5660018323569019, nudge).unwrap();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// The PDE holds in the interior, by exact second and fourth derivatives, and the boundary data are met.
    #[test]
    fn equation_and_boundary_data_hold((order, s, t, w, k) in equation(), (ends, force) in data(), u in 0.0..1.0f64) {
        let Ok(equation) = Equation::new(order, s, t, w, k) else { return Ok(()) };
        let force: Vec<f64> = force.iter().map(|f| f * s * (1.0 + k * k)).collect();
        let [start, end, start_u, end_u] = ends;
        let solution = equation.solve(&ModeData { start, end, start_u, end_u, force: &force }).unwrap();
        let [jet] = equation.jets::<5, 1>([&solution], u);
        let [at_start] = equation.jets::<2, 1>([&solution], 0.0);
        let [at_end] = equation.jets::<2, 1>([&solution], 1.0);
        let rate = equation.largest_rate().max(1.0);
        let size = jet[0].abs().max(10.0);
        prop_assert!((at_start[0] - start).abs() < 1e-11 * size && (at_end[0] - end).abs() < 1e-11 * size, "{at_start:?} {at_end:?}");
        let residual = match order {
            Order::Second => (s * jet[2] - t * k * k * jet[0] - polynomial(&force, u)) / (s * rate * rate),
            Order::Fourth => {
                prop_assert!((at_start[1] - start_u).abs() < 1e-11 * size * rate && (at_end[1] - end_u).abs() < 1e-11 * size * rate, "{at_start:?} {at_end:?}");
                (s * jet[4] - t * k * k * jet[2] + w * k.powi(4) * jet[0] - polynomial(&force, u)) / (s * rate.powi(4))
            }
        };
        prop_assert!(residual.abs() < 1e-10 * size, "residual {residual:e} of {size}");
    }

    /// A small change of the parameters changes the solution little, through every regime.
    #[test]
    fn moves_continuously(of in equation(), (ends, force) in data(), u in 0.0..1.0f64, nudge in -1.0..1.0f64) {
        moved_by_little(of, ends, &force, u, nudge)?;
    }

    /// Affine images of the boundary data give the affine image of the surface: the problem is linear, and a constant solves it.
    #[test]
    fn affine_invariance(scale in -3.0..3.0f64, shift in -5.0..5.0f64, u in 0.0..=1.0f64, v in 0.0..6.3f64) {
        let made = |a: f64, b: f64| {
            let datum = |start: f64, end: f64, plus: f64| Datum {
                start: a * start + plus, end: a * end + plus, start_u: a * 0.4, end_u: a * -0.2, force: vec![a * 0.3, a * 2.0],
                ..Datum::default()
            };
            let modes = vec![
                Mode { n: 0.0, cos: datum(1.0, 0.2, b), sin: Datum::default() },
                Mode { n: 3.0, cos: datum(0.2, 0.1, 0.0), sin: datum(0.3, 0.5, 0.0) },
            ];
            let component = Component { order: Order::Fourth, s: 1.0, t: 3.0, w: 1.5, free: Free::default(), modes };
            let shape = BoundaryValue { span: Span::Tau, rings: Vec::new(), x: component.clone(), y: component.clone(), z: component };
            Surface::solve(&shape, "").unwrap().at(u, v).position.x
        };
        let (given, image) = (made(1.0, 0.0), made(scale, shift));
        prop_assert!((image - (scale * given + shift)).abs() < 1e-12 * (1.0 + shift.abs() + scale.abs()));
    }
}

#[test]
fn k_zero_is_a_polynomial() {
    let surface = surface_of(
        r#"{ "kind": "boundary-value", "span": 1,
             "x": { "order": 2, "s": 1, "t": 5, "modes": [{ "n": 0, "cos": { "start": 1, "end": 3, "force": [2] } }] },
             "y": { "order": 4, "s": 1, "t": 5, "w": 2, "modes": [{ "n": 0, "cos": { "start_u": 1 } }] },
             "z": { "order": 4, "s": 24, "t": 5, "w": 2, "modes": [{ "n": 0, "cos": { "force": [24] } }] } }"#,
    );
    for u in [0.0, 0.25, 0.5, 0.8, 1.0] {
        let position = surface.at(u, 0.3).position;
        let expected = DVec3::new(1.0 + u + u * u, u * (1.0 - u) * (1.0 - u), u * u * (1.0 - u) * (1.0 - u) / 24.0);
        assert!((position - expected).length() < 1e-15, "{position} {expected}");
    }
}

#[test]
fn derivatives_are_those_of_the_position() {
    for case in corpus().iter().step_by(3) {
        let surface = surface(&case.shape);
        let (u, v, h) = (0.37, 0.21 * surface.span(), 1e-5);
        let jet = surface.at(u, v);
        let difference =
            |a: pasu::SurfaceJet, b: pasu::SurfaceJet, f: fn(&pasu::SurfaceJet) -> DVec3| (f(&a) - f(&b)) / (2.0 * h);
        let (up, down) = (surface.at(u + h, v), surface.at(u - h, v));
        let (left, right) = (surface.at(u, v + h), surface.at(u, v - h));
        let rate = rate(&shape(&case.shape)).max(50.0);
        for (what, exact, approximate, order) in [
            ("du", jet.du, difference(up, down, |j| j.position), 1),
            ("dv", jet.dv, difference(left, right, |j| j.position), 1),
            ("duu", jet.duu, difference(up, down, |j| j.du), 2),
            ("duv", jet.duv, difference(left, right, |j| j.du), 2),
            ("dvv", jet.dvv, difference(left, right, |j| j.dv), 2),
        ] {
            let error = (exact - approximate).length();
            assert!(error < 1e-9 * case.scale * rate.powi(order + 2), "{} {what}: off by {error:e}", case.name);
        }
    }
}
