//! A point is pulled and comes along.

use std::f64::consts::TAU;

use pasu::{Arg, Code, Design, Hand, Shape, evaluate, pull};
use proptest::prelude::*;

const FAMILIES: [&str; 4] = ["second-order", "mixed-order", "fourth-order", "bloor-wilson"];

fn family(index: usize) -> Design {
    Design::parse(&format!("#1/{}", FAMILIES[index])).unwrap()
}

fn size(design: &Design) -> f64 {
    let at: Vec<f64> = (0..=8).flat_map(|i| [f64::from(i) / 8.0, 0.0]).collect();
    evaluate(design, 0, &at).unwrap().iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// In the plane of the profile, and not at an end that a family has fixed.
    #[test]
    fn a_point_of_a_profile_arrives(index in 0usize..4, u in 0.05f64..0.95, out in -0.15f64..0.15, up in -0.1f64..0.1) {
        let vase = family(index);
        let at = [u, 0.0];
        let size = size(&vase);
        let from = evaluate(&vase, 0, &at).unwrap();
        let to = [from[0] + out * size, from[1], from[2] + up * size];
        let pulled = pull(&vase, 0, &Hand::new(at, to)).unwrap();
        let moved = evaluate(&pulled.design, 0, &at).unwrap();
        let off = moved.iter().zip(to).fold(0.0f64, |off, (a, b)| off.max((a - b).abs()));
        prop_assert!(off < 1e-9 * size, "{} at {u}: {off}", FAMILIES[index]);
        prop_assert!(pulled.behind < 2e-9 * size);
    }
}

#[test]
fn what_is_kept_stays_to_the_bit() {
    let vase = family(2);
    let from = evaluate(&vase, 0, &[0.3, 0.0]).unwrap();
    let hand = Hand {
        keep: vec!["r0".into(), "eta".into(), "dz[1]".into()],
        ..Hand::new([0.3, 0.0], [from[0] + 0.2, 0.0, from[2] - 0.1])
    };
    let pulled = pull(&vase, 0, &hand).unwrap();
    let (Shape::FourthOrder(before), Shape::FourthOrder(after)) =
        (&vase.parts()[0].shape, &pulled.design.parts()[0].shape)
    else {
        panic!()
    };
    assert_eq!((before.r0, before.eta, before.dz[1]), (after.r0, after.eta, after.dz[1]));
    assert!(after.dz[0] != before.dz[0] && after.rm != before.rm, "{before:?} {after:?}");
    assert!(pulled.behind < 1e-9);
}

/// The equations of x and y were the same, and a round pot stays round.
#[test]
fn a_round_pot_stays_round() {
    for (v, along) in [(0.0, [1.0, 0.0]), (std::f64::consts::FRAC_PI_2, [0.0, 1.0])] {
        let vase = family(2);
        let from = evaluate(&vase, 0, &[0.3, v]).unwrap();
        let to = [from[0] + 0.2 * along[0], from[1] + 0.2 * along[1], from[2]];
        let pulled = pull(&vase, 0, &Hand::new([0.3, v], to)).unwrap();
        let round: Vec<f64> = [0.0, 1.0, 2.0]
            .iter()
            .map(|v| {
                let p = evaluate(&pulled.design, 0, &[0.7, *v]).unwrap();
                p[0].hypot(p[1])
            })
            .collect();
        assert!(round.iter().all(|radius| (radius - round[0]).abs() < 1e-12), "{round:?}");
    }
}

/// A round family has no number that would bring a point out of the plane through the axis: it comes along within that plane and stays behind by the rest.
#[test]
fn how_far_a_point_stays_behind_is_told() {
    let vase = family(2);
    let from = evaluate(&vase, 0, &[0.5, 0.0]).unwrap();
    let pulled = pull(&vase, 0, &Hand::new([0.5, 0.0], [from[0] + 0.1, 0.25, from[2]])).unwrap();
    let moved = evaluate(&pulled.design, 0, &[0.5, 0.0]).unwrap();
    assert!((moved[0] - from[0] - 0.1).abs() < 1e-9, "{moved:?}");
    assert!((pulled.behind - 0.25).abs() < 1e-9, "{}", pulled.behind);
}

/// A vase of the fourth order by its numbers: lengths, then those of the equation, which are the same for `x` and `y`.
fn fourth_order([r0, r1, rm, h1, eta, other_eta, dz, other_dz, s, t, w]: [f64; 11]) -> Design {
    let shape = format!(
        r#""kind": "fourth-order", "r0": {r0}, "r1": {r1}, "rm": {rm}, "h1": {h1}, "eta": [{eta}, {other_eta}], "dz": [{dz}, {other_dz}], "s": [{s}, {s}], "t": [{t}, {t}], "w": [{w}, {w}]"#
    );
    Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {{ {shape} }} }}] }}"#)).unwrap()
}

/// The change is the least in the sum of squares, in the units of docs/rings.md: there is no part of it that leaves the point where it is, to first order from where it arrived.
#[test]
fn the_change_of_a_family_is_the_least() {
    let vase = family(2);
    let numbers = |design: &Design| {
        let Shape::FourthOrder(vase) = &design.parts()[0].shape else { panic!("another family") };
        let [s, t, w] = [vase.s, vase.t, vase.w].map(|[x, y]| {
            assert_eq!(x, y);
            x
        });
        [vase.r0, vase.r1, vase.rm, vase.h1, vase.eta[0], vase.eta[1], vase.dz[0], vase.dz[1], s, t, w]
    };
    let before = numbers(&vase);
    let size = before[..4].iter().chain(&before[6..8]).fold(0.0f64, |size, length| size.max(length.abs()));
    let units: [f64; 11] = std::array::from_fn(|i| if i < 4 || i == 6 || i == 7 { size } else { before[i].abs() });
    for (u, out, up) in [(0.4, 0.2, -0.1), (0.7, -0.15, 0.3), (0.15, 0.05, 0.02), (0.5, 0.6, 0.0)] {
        let from = evaluate(&vase, 0, &[u, 0.0]).unwrap();
        let pulled = pull(&vase, 0, &Hand::new([u, 0.0], [from[0] + out, 0.0, from[2] + up])).unwrap();
        assert!(pulled.behind < 1e-9);
        let after = numbers(&pulled.design);
        let change: [f64; 11] = std::array::from_fn(|i| (after[i] - before[i]) / units[i]);
        // Slopes of the point by each number, by differences of the fourth order.
        let slope = |i: usize, axis: usize| {
            let at = |by: f64| {
                let mut moved = after;
                moved[i] += by * units[i];
                evaluate(&fourth_order(moved), 0, &[u, 0.0]).unwrap()[axis]
            };
            let step = 1e-3;
            (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step)
        };
        let [x, z]: [[f64; 11]; 2] = [0, 2].map(|axis| std::array::from_fn(|i| slope(i, axis)));
        let dot = |a: &[f64; 11], b: &[f64; 11]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        // What of the change is a sum of both rows of slopes.
        let (xx, xz, zz) = (dot(&x, &x), dot(&x, &z), dot(&z, &z));
        let (cx, cz) = (dot(&x, &change), dot(&z, &change));
        let determinant = xx * zz - xz * xz;
        let [along_x, along_z] = [(cx * zz - cz * xz) / determinant, (cz * xx - cx * xz) / determinant];
        let rest: [f64; 11] = std::array::from_fn(|i| change[i] - along_x * x[i] - along_z * z[i]);
        let [rest, all] = [rest, change].map(|numbers| dot(&numbers, &numbers).sqrt());
        assert!(rest < 1e-6 * all, "at {u}: {rest} of {all}");
    }
}

/// A hand that does not move changes nothing.
#[test]
fn a_pull_to_where_the_point_is_changes_nothing() {
    for index in 0..4 {
        let vase = family(index);
        let from = evaluate(&vase, 0, &[0.4, 0.2]).unwrap();
        let pulled = pull(&vase, 0, &Hand::new([0.4, 0.2], [from[0], from[1], from[2]])).unwrap();
        assert_eq!(pulled.design, vase);
        assert_eq!(pulled.behind, 0.0);
    }
}

/// Far beyond everything, at infinity, at an end that is fixed: an answer or a refusal, never nonsense.
#[test]
fn hostile_hands_are_answered_or_refused() {
    for index in 0..4 {
        let vase = family(index);
        for to in [[1e6, 0.0, -1e6], [1e150, 1e150, 1e150], [0.0; 3], [-1e308, 1e308, 0.0]] {
            for at in [[0.0, 0.0], [1.0, 0.3], [0.5, 1e9]] {
                if let Ok(pulled) = pull(&vase, 0, &Hand::new(at, to)) {
                    assert!(pulled.behind.is_finite(), "{at:?} to {to:?}");
                    assert!(evaluate(&pulled.design, 0, &at).unwrap().iter().all(|x| x.is_finite()));
                }
            }
        }
    }
    let vase = family(0);
    let refusal = |hand: Hand| {
        let error = pull(&vase, 0, &hand).unwrap_err();
        (error.code(), error.path().to_owned())
    };
    let hand = Hand::new([0.5, 0.0], [1.0, 0.0, 1.0]);
    assert_eq!(refusal(Hand { at: [1.5, 0.0], ..hand.clone() }), (Code::NoSuchPoint, "at[0]".into()));
    assert_eq!(refusal(Hand { to: [1.0, f64::NAN, 0.0], ..hand.clone() }), (Code::NotFinite, "to[1]".into()));
    assert_eq!(refusal(Hand { width: Some(0.0), ..hand.clone() }), (Code::OutOfRange, "width".into()));
    assert_eq!(refusal(Hand { width: Some(f64::NAN), ..hand.clone() }), (Code::OutOfRange, "width".into()));
    assert_eq!(refusal(Hand { width: Some(1e-9), ..hand.clone() }), (Code::OutOfRange, "width".into()));
    assert_eq!(refusal(Hand { petals: Some(0), ..hand.clone() }), (Code::OutOfRange, "petals".into()));
    assert_eq!(refusal(Hand { petals: Some(257), ..hand.clone() }), (Code::OutOfRange, "petals".into()));
    let unknown = Hand { keep: vec!["r".into(), "belly".into()], ..hand.clone() };
    assert_eq!(refusal(unknown.clone()), (Code::UnknownName, "keep[1]".into()));
    let refused = pull(&vase, 0, &unknown).unwrap_err();
    assert_eq!(refused.arg("found"), Some(&Arg::from("belly")));
    assert!(
        matches!(refused.arg("words"), Some(Arg::Words(words)) if words.contains(&"height".to_owned())),
        "{refused:?}"
    );
    assert_eq!(pull(&vase, 7, &hand).unwrap_err().code(), Code::NoSuchPoint);
}

/// A jug: an oval belly with waves, a tilted neck, a sharp shoulder, and slopes at the foot.
fn jug() -> Design {
    let document = serde_json::json!({ "pasu": 1, "parts": [{ "shape": { "kind": "rings", "a": 1.2, "foot": { "r": { "mean": 4 }, "z": { "mean": 9 } }, "rings": [
        { "u": 0, "r": { "mean": 3 }, "z": { "mean": 0 } },
        { "u": 0.3, "r": { "mean": 5, "waves": [{ "n": 2, "cos": 0.6 }, { "n": 7, "cos": 0.1, "sin": 0.2 }] }, "z": { "mean": 5 } },
        { "u": 0.6, "sharp": true, "r": { "mean": 4.4 }, "z": { "mean": 9, "waves": [{ "n": 1, "cos": 0.3 }] } },
        { "u": 0.8, "r": { "mean": 2 }, "z": { "mean": 11, "waves": [{ "n": 1, "sin": 0.2 }] } },
        { "u": 1, "r": { "mean": 2.6, "waves": [{ "n": 1, "cos": 0.3 }] }, "z": { "mean": 14 } },
    ] } }] });
    Design::parse(&document.to_string()).unwrap()
}

/// The same written out.
fn written(design: &Design) -> Design {
    let shape = Shape::BoundaryValue(design.parts()[0].shape.boundary_value().unwrap());
    let document = serde_json::json!({ "pasu": 1, "parts": [{ "shape": serde_json::to_value(shape).unwrap() }] });
    Design::parse(&document.to_string()).unwrap()
}

fn point(design: &Design, at: [f64; 2]) -> [f64; 3] {
    evaluate(design, 0, &at).unwrap().try_into().unwrap()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum: f64, (a, b)| sum.hypot(a - b))
}

fn widths() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![Just(None), (0.6f64..3.0).prop_map(Some)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    /// Anywhere, beside a ring too, all round or on one side.
    #[test]
    fn a_point_of_a_pot_of_rings_arrives(
        u in 0.0f64..=1.0, v in -7.0f64..7.0, out in -1.0f64..1.0, up in -1.0f64..1.0, round in -0.5f64..0.5, width in widths(), petals in 1u32..6,
    ) {
        let pot = jug();
        let from = point(&pot, [u, v]);
        let away = from[0].hypot(from[1]);
        let angle = from[1].atan2(from[0]) + round;
        let to = [(away + out) * angle.cos(), (away + out) * angle.sin(), from[2] + up];
        let width = width.map(|width| width / f64::from(petals));
        let pulled = pull(&pot, 0, &Hand { width, petals: Some(petals), ..Hand::new([u, v], to) }).unwrap();
        prop_assert_eq!(pulled.at[0], u);
        prop_assert!((pulled.at[1] - v).abs() < 1.0, "{:?}", pulled.at);
        let off = distance(point(&pulled.design, pulled.at), to);
        prop_assert!(off < 1e-9 && pulled.behind < 1e-9, "off by {off}");
        let (Shape::Rings(before), Shape::Rings(after)) = (&pot.parts()[0].shape, &pulled.design.parts()[0].shape) else { panic!() };
        // What was not pulled is what it was, to the bit.
        let is_there = |hoop| after.rings.contains(hoop);
        let n_changed = before.rings.iter().filter(|hoop| !is_there(*hoop)).count();
        prop_assert_eq!((&before.foot, &before.rim, before.a), (&after.foot, &after.rim, after.a));
        prop_assert!(n_changed + after.rings.len() - before.rings.len() <= 1);
    }

    #[test]
    fn a_point_of_data_that_are_written_out_arrives(
        u in 0.0f64..=1.0, v in -7.0f64..7.0, to in prop::array::uniform3(-8.0f64..8.0), width in widths(),
    ) {
        let pot = written(&jug());
        let pulled = pull(&pot, 0, &Hand { width, ..Hand::new([u, v], to) }).unwrap();
        prop_assert_eq!(pulled.at, [u, v]);
        let off = distance(point(&pulled.design, [u, v]), to);
        prop_assert!(off < 1e-9 && pulled.behind < 1e-9, "off by {off}");
    }

    /// Everywhere, with waves and corners: the new ring holds the surface where it is, to the twelve digits of a document.
    #[test]
    fn a_ring_that_is_put_into_data_written_out_changes_nothing(u in 0.0f64..=1.0, v in 0.0f64..7.0, elsewhere in 0.0f64..=1.0, there in 0.0f64..7.0) {
        let pot = written(&jug());
        let from = point(&pot, [u, v]);
        let pulled = pull(&pot, 0, &Hand::new([u, v], from)).unwrap();
        let moved = distance(point(&pulled.design, [elsewhere, there]), point(&pot, [elsewhere, there]));
        prop_assert!(moved < 1e-9, "{moved}");
    }
}

/// Rings without waves of the radius keep every point when another is put between them.
#[test]
fn a_ring_that_is_put_between_round_ones_changes_nothing() {
    let bottle = Design::parse("#1/rings").unwrap();
    let from = point(&bottle, [0.5, 1.0]);
    let pulled = pull(&bottle, 0, &Hand::new([0.5, 1.0], from)).unwrap();
    let Shape::Rings(pot) = &pulled.design.parts()[0].shape else { panic!() };
    assert_eq!(pot.rings.len(), 5);
    for i in 0..=40 {
        let at = [f64::from(i) / 40.0, 0.3 * f64::from(i)];
        let moved = distance(point(&pulled.design, at), point(&bottle, at));
        assert!(moved < 1e-10, "{at:?}: {moved}");
    }
}

/// A spout: what is far round the axis stays as it was.
#[test]
fn a_narrow_pull_leaves_the_other_side_alone() {
    let bottle = Design::parse("#1/rings").unwrap();
    let from = point(&bottle, [1.0, 0.0]);
    let hand = Hand { width: Some(0.6), ..Hand::new([1.0, 0.0], [from[0] + 1.0, 0.0, from[2] + 0.5]) };
    let pulled = pull(&bottle, 0, &hand).unwrap();
    for u in [0.0, 0.4, 0.8, 1.0] {
        for v in [2.2, 3.1, 4.0] {
            let moved = distance(point(&pulled.design, [u, v]), point(&bottle, [u, v]));
            assert!(moved < 1e-4, "{u}, {v}: {moved}");
        }
    }
}

#[test]
fn petals_are_pulled_together() {
    let bottle = Design::parse("#1/rings").unwrap();
    let at = [0.35, 0.4];
    let from = point(&bottle, at);
    let away = from[0].hypot(from[1]) + 1.0;
    let hand =
        Hand { width: Some(0.5), petals: Some(5), ..Hand::new(at, [away * at[1].cos(), away * at[1].sin(), from[2]]) };
    let pulled = pull(&bottle, 0, &hand).unwrap();
    for petal in 0..5 {
        let [x, y, _] = point(&pulled.design, [0.35, 0.4 + TAU * f64::from(petal) / 5.0]);
        assert!((x.hypot(y) - away).abs() < 1e-9, "petal {petal}");
        let [x, y, _] = point(&pulled.design, [0.35, 0.4 + TAU * (f64::from(petal) + 0.5) / 5.0]);
        assert!(x.hypot(y) < away - 0.9, "between petals {petal}");
    }
}

#[test]
fn what_a_pot_of_rings_keeps_stays() {
    let pot = jug();
    let from = point(&pot, [0.3, 0.0]);
    let to = [from[0] + 0.5, 0.7, from[2] + 0.25];
    let hoop = |keep: &[&str]| {
        let keep = keep.iter().map(|word| (*word).to_owned()).collect();
        let pulled = pull(&pot, 0, &Hand { keep, ..Hand::new([0.3, 0.0], to) }).unwrap();
        let Shape::Rings(after) = &pulled.design.parts()[0].shape else { panic!() };
        (after.rings[1].clone(), pulled.behind, pulled.at)
    };
    let Shape::Rings(before) = &pot.parts()[0].shape else { panic!() };
    let (free, behind, at) = hoop(&[]);
    assert!(free.r != before.rings[1].r && free.z != before.rings[1].z && at[1] > 0.05 && behind < 1e-9);
    let (kept, behind, _) = hoop(&["z"]);
    assert_eq!(kept.z, before.rings[1].z);
    assert!((behind - 0.25).abs() < 1e-9, "{behind}");
    let (kept, _, _) = hoop(&["r"]);
    assert_eq!(kept.r, before.rings[1].r);
    let (_, behind, at) = hoop(&["v"]);
    assert_eq!(at, [0.3, 0.0]);
    assert!((behind - 0.7).abs() < 1e-9, "{behind}");
    let refused = pull(&pot, 0, &Hand { keep: vec!["height".into()], ..Hand::new([0.3, 0.0], to) }).unwrap_err();
    assert_eq!((refused.code(), refused.path()), (Code::UnknownName, "keep[0]"));
    assert_eq!(refused.arg("words"), Some(&Arg::from(["r", "z", "v"].as_slice())));
}

/// 66 rings, as many as there may be: the nearest is pulled, however far it is.
#[test]
fn where_there_is_no_room_for_a_ring_the_nearest_is_pulled() {
    let rings: Vec<serde_json::Value> = (0..66)
        .map(|i| {
            // Crowded beneath, far apart above.
            let u = if i == 65 { 1.0 } else { 0.5 * f64::from(i) / 64.0 };
            serde_json::json!({ "u": u, "r": { "mean": 2.0 + u }, "z": { "mean": 10.0 * u } })
        })
        .collect();
    let document = serde_json::json!({ "pasu": 1, "parts": [{ "shape": { "kind": "rings", "rings": rings } }] });
    let pot = Design::parse(&document.to_string()).unwrap();
    let from = point(&pot, [0.7, 0.0]);
    let to = [from[0] + 0.1, 0.0, from[2]];
    let pulled = pull(&pot, 0, &Hand::new([0.7, 0.0], to)).unwrap();
    assert!(distance(point(&pulled.design, [0.7, 0.0]), to) < 1e-9);
}

/// On the axis and across it, at the other side of the world, and beyond all numbers.
#[test]
fn hostile_hands_on_rings_are_answered_or_refused() {
    for pot in [jug(), written(&jug())] {
        for to in [[0.0, 0.0, 5.0], [-9.0, 0.0, 5.0], [1e9, -1e9, 1e9], [1e160, 0.0, 0.0], [1e308, -1e308, 1e308]] {
            for at in [[0.0, 0.0], [1.0, 3.0], [0.3, 0.0], [0.55, 1e3]] {
                for width in [None, Some(0.4)] {
                    match pull(&pot, 0, &Hand { width, ..Hand::new(at, to) }) {
                        Ok(pulled) => {
                            let size = to.iter().fold(20.0, |size: f64, x| size.max(x.abs()));
                            assert!(pulled.behind <= 1e-9 * size, "{at:?} to {to:?}: {}", pulled.behind);
                        }
                        Err(error) => assert!(matches!(error.code(), Code::Overflow | Code::OutOfRange), "{error}"),
                    }
                }
            }
        }
    }
}

/// What cannot be followed does not keep the rest from arriving.
#[test]
fn a_point_that_stays_behind_arrives_in_all_that_it_can_follow() {
    let vase = family(2);
    let from = point(&vase, [0.5, 0.0]);
    for sideways in [0.2, 2.0] {
        let to = [from[0] + 0.3, from[1] + sideways, from[2]];
        let hand = Hand { keep: vec!["r0".into()], ..Hand::new([0.5, 0.0], to) };
        let pulled = pull(&vase, 0, &hand).unwrap();
        let moved = point(&pulled.design, [0.5, 0.0]);
        assert!((moved[0] - to[0]).abs() < 1e-9 && (moved[2] - to[2]).abs() < 1e-9, "{moved:?}");
        assert!((pulled.behind - sideways).abs() < 1e-9, "{}", pulled.behind);
    }
}
