//! Vases in another order: the same wall where the other order can make it, and nothing left behind unsaid.

use pasu::{Code, Conversion, Design, FourthOrder, Loss, Shape, VaseOrder, evaluate};
use serde_json::{Value, json};

const GALLERY: &str = include_str!("../reference/gallery.json");

fn gallery() -> Vec<(String, Shape)> {
    let exhibits: Vec<Value> = serde_json::from_str(GALLERY).unwrap();
    exhibits.iter().map(|exhibit| (exhibit["name"].to_string(), shape(&exhibit["shape"]))).collect()
}

fn shape(json: &Value) -> Shape {
    Shape::parse(&json.to_string()).unwrap()
}

fn converted(json: &Value, to: VaseOrder) -> Conversion {
    shape(json).convert(to).unwrap()
}

fn fourth(json: &Value) -> FourthOrder {
    let Shape::FourthOrder(fourth) = converted(json, VaseOrder::Fourth).shape else { panic!("{json}") };
    fourth
}

/// Radius of the rim, radius of the foot, height.
fn edges(shape: &Shape) -> Option<[f64; 3]> {
    match shape {
        Shape::SecondOrder(vase) => Some([vase.r[0], vase.r[2], vase.height]),
        Shape::MixedOrder(vase) => Some([vase.r[0], vase.r[2], vase.height]),
        Shape::FourthOrder(vase) => Some([vase.r1, vase.r0, vase.h1]),
        Shape::BloorWilson(vase) => Some([vase.r[0], vase.r[3], vase.h[0]]),
        _ => None,
    }
}

/// Points along the profile at `v = 0`, from the rim down.
fn profile(shape: &Shape) -> Vec<f64> {
    let design = json!({ "pasu": 1, "parts": [{ "shape": shape }] });
    let design = Design::parse(&design.to_string()).unwrap();
    let is_up = matches!(shape, Shape::FourthOrder(_));
    let at: Vec<f64> = (0..=16).flat_map(|i| [f64::from(if is_up { 16 - i } else { i }) / 16.0, 0.0]).collect();
    evaluate(&design, 0, &at).unwrap()
}

#[test]
fn every_order_keeps_rim_foot_and_height_and_can_be_drawn() {
    let mut n_vases = 0;
    for (name, shape) in gallery() {
        let Some(before) = edges(&shape) else {
            for order in VaseOrder::ALL {
                assert_eq!(shape.convert(*order).unwrap_err().code(), Code::UnsupportedShape, "{name}");
            }
            continue;
        };
        for order in VaseOrder::ALL {
            let made = shape.convert(*order).unwrap();
            assert_eq!(edges(&made.shape), Some(before), "{name} {}", order.name());
            assert_eq!(json!(made.shape)["kind"], order.name());
            assert!(profile(&made.shape).iter().all(|x| x.is_finite()), "{name} {}", order.name());
        }
        n_vases += 1;
    }
    assert!(n_vases >= 30, "{n_vases}");
}

#[test]
fn the_same_order_is_the_same_shape() {
    let vase = json!({ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] });
    assert_eq!(converted(&vase, VaseOrder::Second), converted(&vase, VaseOrder::Second));
    assert_eq!(converted(&vase, VaseOrder::Second).shape, shape(&vase));
    assert!(converted(&vase, VaseOrder::Second).lost.is_empty());
}

#[test]
fn a_wall_of_second_order_is_the_same_wall_in_fourth_order() {
    // With and without a pull, with one that makes waves, and where both ends are alike.
    let walls =
        [(1.0, 0.6, 0.5), (1.0, 0.6, 0.0), (0.7, 0.9, 3.0), (1.0, 0.5, -0.02), (1.0, 1.0, 0.0), (0.8, 0.8, 0.1)];
    for (rim, foot, t) in walls {
        let vase = json!({ "kind": "second-order", "r": [rim, 0, foot, 0], "t": [t, t], "s": [2, 2], "height": 3.6 });
        let made = converted(&vase, VaseOrder::Fourth);
        assert!(made.lost.is_empty());
        for (a, b) in profile(&shape(&vase)).iter().zip(profile(&made.shape)) {
            assert!((a - b).abs() < 1e-9, "{vase}: {a} {b}");
        }
    }
}

#[test]
fn second_to_fourth_order_and_back_is_the_vase_that_one_started_from() {
    let vase = json!({ "kind": "second-order", "r": [1, 0, 0.6, 0], "t": [0.5, 0.25], "s": [1, 1], "height": 4 });
    let there = converted(&vase, VaseOrder::Fourth);
    let back = there.shape.convert(VaseOrder::Second).unwrap();
    assert_eq!((back.shape, back.lost), (shape(&vase), vec![]));
}

#[test]
fn mixed_order_keeps_its_rise() {
    let vase = json!({ "kind": "mixed-order", "r": [1, 0, 0.6, 0], "rise": -10, "height": 3.6 });
    assert_eq!(fourth(&vase).dz, [0.0, 10.0]);
    let second = json!({ "kind": "second-order", "r": [1, 0, 0.6, 0], "height": 4 });
    let Shape::MixedOrder(mixed) = converted(&second, VaseOrder::Mixed).shape else { panic!() };
    assert_eq!(mixed.rise, -6.0);
}

#[test]
fn a_straight_wall_has_slopes_in_fourth_order_too() {
    let made = fourth(&json!({ "kind": "second-order", "r": [1, 0, 1, 0], "t": [0, 0], "height": 2 }));
    assert!((4.0 * made.rm - made.r1 - 3.0 * made.r0).abs() > 0.1);
    assert_eq!(made.eta, [0.0, 0.0]);
}

#[test]
fn what_is_left_behind_is_said() {
    let petals = json!({ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "force": [1, 0], "n": [2, 8] });
    assert_eq!(converted(&petals, VaseOrder::Fourth).lost, [Loss::Petals, Loss::Push, Loss::Turns]);
    let dint = Design::parse("#1/bloor-wilson").unwrap().parts()[0].shape.clone();
    let lost = |order| dint.convert(order).unwrap().lost;
    assert_eq!(lost(VaseOrder::Second), [Loss::Dints, Loss::Skew, Loss::Slopes, Loss::Rise]);
    assert_eq!(lost(VaseOrder::Mixed), [Loss::Dints, Loss::Skew, Loss::Slopes]);
    assert_eq!(lost(VaseOrder::Fourth), [Loss::Dints, Loss::Skew]);
    let mixed = json!({ "kind": "mixed-order", "r": [1, 0, 0.6, 0], "rise": -10 });
    assert_eq!(converted(&mixed, VaseOrder::Second).lost, [Loss::Rise]);
}

#[test]
fn what_leaves_the_range_of_numbers_is_refused() {
    let huge = json!({ "kind": "second-order", "r": [1, 0, 0.6, 0], "n": [1e200, 8], "t": [0.5, 0.5] });
    // Its own products leave the range already.
    assert_eq!(
        Shape::parse(&huge.to_string()).and_then(|shape| shape.convert(VaseOrder::Fourth)).unwrap_err().code(),
        Code::Overflow
    );
    let mut vase = match shape(&json!({ "kind": "second-order", "r": [1, 0, 0.6, 0] })) {
        Shape::SecondOrder(vase) => vase,
        _ => unreachable!(),
    };
    // No document can say this, but a program can.
    for s in [0.0, f64::NAN, f64::MIN_POSITIVE] {
        vase.s = [s, 1.0];
        vase.t = [1e10, 1.0];
        let error = Shape::SecondOrder(vase).convert(VaseOrder::Fourth).unwrap_err();
        assert_eq!(error.code(), Code::Overflow, "{s}");
    }
}

#[test]
fn what_leaves_the_range_of_numbers_is_refused_and_nothing_else_is_lost_to_it() {
    let extremes = [1e-300, 1e-160, 1.0, 1e160, 1e300];
    let mut n_refused = 0;
    for s in extremes {
        for t in extremes.iter().flat_map(|t| [*t, -*t]).chain([0.0]) {
            for kind in ["second-order", "mixed-order"] {
                let vase = json!({ "kind": kind, "r": [1, 0.1, 0.6, 0.06], "s": [s, 1], "t": [t, 0.5] });
                let Ok(vase) = Shape::parse(&vase.to_string()) else { continue };
                match vase.convert(VaseOrder::Fourth) {
                    Ok(made) => {
                        let Shape::FourthOrder(made) = made.shape else { panic!("{made:?}") };
                        let numbers = [made.s, made.t, made.w, made.eta, made.dz].into_iter().flatten();
                        assert!(numbers.chain([made.r0, made.r1, made.rm, made.h1]).all(f64::is_finite), "{made:?}");
                    }
                    Err(refusal) => {
                        assert_eq!(refusal.code(), Code::Overflow, "s = {s}, t = {t}: {refusal}");
                        n_refused += 1;
                    }
                }
            }
        }
    }
    assert!(n_refused > 0);
}

#[test]
fn waves_near_resonance_convert_to_a_finite_vase() {
    // With `t k^2 / s = -pi^2` the wall of second order has no solution of its own.
    let resonance = -0.25;
    for t in [resonance, resonance * (1.0 + 1e-12), resonance * (1.0 - 1e-9)] {
        let vase = json!({ "kind": "second-order", "r": [1, 0, 0.6, 0], "t": [t, t] });
        match shape(&vase).convert(VaseOrder::Fourth) {
            Ok(made) => assert!(edges(&made.shape).is_some_and(|edges| edges.iter().all(|x| x.is_finite()))),
            Err(refusal) => assert_eq!(refusal.code(), Code::Overflow, "{refusal}"),
        }
    }
}
