//! The reference corpus through the bindings, in Node: the proof that the bindings add nothing and lose nothing.

use js_sys::{Float64Array, JSON, Object, Reflect};
use pasu_wasm::{bound, derivatives, evaluate, fingerprint, mesh};
use serde_json::{Value, json};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

const CORPUS: &str = include_str!("../../../tests/reference/surfaces.json");

const DIGITS: &str = include_str!("../../../tests/reference/digits.json");

/// Written and checked by the native tests.
const GOLDENS: &str = include_str!("../../../tests/goldens/fingerprints.json");

const GALLERY: &str = include_str!("../../../tests/reference/gallery.json");

/// As [`GOLDENS`]: grid, hash of the places of the rows, bits of the bound.
const TESSELLATIONS: &str = include_str!("../../../tests/goldens/tessellations.json");

#[wasm_bindgen_test]
fn every_case_keeps_its_bounds() {
    for (text, at_least) in [(CORPUS, 62), (DIGITS, 80)] {
        let corpus: Vec<Value> = serde_json::from_str(text).expect("the corpus is JSON");
        assert!(corpus.len() >= at_least, "the corpus has lost cases");
        for case in &corpus {
            assert!(text == CORPUS || is_kept(&case["shape"]) || is_kept(&case["family"]), "{}", case["name"]);
            check(case, &case["shape"]);
            if case["family"].is_object() {
                check(case, &case["family"]);
            }
        }
    }
}

#[wasm_bindgen_test]
fn fingerprints_are_the_golden_ones() {
    let corpus: Vec<Value> = serde_json::from_str(CORPUS).expect("the corpus is JSON");
    let goldens: serde_json::Map<String, Value> = serde_json::from_str(GOLDENS).expect("the goldens are JSON");
    assert_eq!(goldens.len(), corpus.len());
    for case in &corpus {
        let shape = if case["family"].is_object() { &case["family"] } else { &case["shape"] };
        let design = js(&json!({ "pasu": 1, "parts": [{ "shape": shape }] }));
        let name = case["name"].as_str().expect("a name");
        let found = fingerprint(&design).unwrap_or_else(|error| panic!("{name}: {error:?}"));
        assert_eq!(goldens[name].as_str(), Some(found.as_str()), "{name}");
    }
}

#[wasm_bindgen_test]
fn rows_are_placed_where_the_native_ones_are() {
    let gallery: Vec<Value> = serde_json::from_str(GALLERY).expect("the gallery is JSON");
    let goldens: serde_json::Map<String, Value> = serde_json::from_str(TESSELLATIONS).expect("the goldens are JSON");
    assert_eq!(goldens.len(), gallery.len());
    for exhibit in &gallery {
        let design = js(&json!({ "pasu": 1, "parts": [{ "shape": exhibit["shape"] }] }));
        let name = exhibit["name"].as_str().expect("a name");
        let made =
            mesh(&design, &JsValue::UNDEFINED, &JsValue::UNDEFINED).unwrap_or_else(|error| panic!("{name}: {error:?}"));
        let field = |key: &str| Reflect::get(&made, &key.into()).expect("a field");
        let (topology, known) =
            (field("topology").as_string().expect("text"), field("bound").as_f64().expect("a number"));
        assert_eq!(goldens[name].as_str(), Some(format!("{topology} {:016x}", known.to_bits()).as_str()), "{name}");
        assert_eq!(bound(&design, &JsValue::UNDEFINED), Ok(known), "{name}");
    }
}

/// One case, as its boundary-value problem or as its family: positions within 1e-13 of its scale, derivatives within 1e-12 of the largest of the same
/// kind in it, as the native tests have it. Where the data have more digits than a document keeps, another surface is computed, and only nearly this one.
fn check(case: &Value, shape: &Value) {
    let name = format!("{} as {}", case["name"], shape["kind"]);
    let design = js(&json!({ "pasu": 1, "parts": [{ "shape": shape }] }));
    let points = case["points"].as_array().expect("points");
    let at: Vec<f64> = points.iter().flat_map(|point| [number(&point["u"]), number(&point["v"])]).collect();
    let at = JsValue::from(Float64Array::from(at.as_slice()));
    let part = JsValue::from(0);

    let scale = number(&case["scale"]);
    let is_kept = is_kept(shape);
    let positions = evaluate(&design, &part, &at).unwrap_or_else(|error| panic!("{name}: {error:?}"));
    compare(&name, "position", points, &positions, if is_kept { 1e-13 } else { 1e-10 } * scale);

    let slopes = derivatives(&design, &part, &at).unwrap_or_else(|error| panic!("{name}: {error:?}"));
    for field in ["du", "dv"] {
        let coordinates = points.iter().flat_map(|point| point[field].as_array().expect("triple"));
        let largest = coordinates.map(|coordinate| number(coordinate).abs()).fold(0.0, f64::max);
        let bound = if is_kept { 1e-12 * largest } else { 1e-9 * scale * rate(&case["shape"]) };
        compare(&name, field, points, &array(&slopes, field), bound);
    }
}

/// Whether a document keeps every number of a shape: it rounds them to twelve significant digits.
fn is_kept(value: &Value) -> bool {
    match value {
        Value::Number(number) => number.as_f64().is_some_and(|x| format!("{x:.11e}").parse() == Ok(x)),
        Value::Array(items) => items.iter().all(is_kept),
        Value::Object(fields) => fields.values().all(is_kept),
        Value::Null | Value::Bool(_) | Value::String(_) => true,
    }
}

fn compare(name: &str, field: &str, points: &[Value], found: &Float64Array, bound: f64) {
    assert_eq!(found.length() as usize, 3 * points.len(), "{name}: {field} has the wrong length");
    for (point, found) in points.iter().zip(found.to_vec().chunks(3)) {
        for (axis, (found, expected)) in found.iter().zip(point[field].as_array().expect("triple")).enumerate() {
            let error = (found - number(expected)).abs();
            assert!(error <= bound, "{name}: {field}[{axis}] at {point}: found {found}, off by {error:e} > {bound:e}");
        }
    }
}

/// The largest `max(1, k, k sqrt(|t / s|))` of a boundary-value problem: how steep its solutions may be.
fn rate(shape: &Value) -> f64 {
    let span = shape["span"].as_f64().unwrap_or(std::f64::consts::TAU);
    let of = |component: &Value| {
        let ratio = (number(&component["t"]) / number(&component["s"])).abs().sqrt().max(1.0);
        let modes = component["modes"].as_array().into_iter().flatten();
        modes.map(move |mode| std::f64::consts::TAU * number(&mode["n"]).abs() / span * ratio).fold(1.0, f64::max)
    };
    ["x", "y", "z"].iter().map(|axis| of(&shape[axis])).fold(1.0, f64::max)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

fn array(object: &Object, field: &str) -> Float64Array {
    Reflect::get(object, &field.into()).expect("a field").unchecked_into()
}

fn js(value: &Value) -> JsValue {
    JSON::parse(&value.to_string()).expect("JSON")
}
