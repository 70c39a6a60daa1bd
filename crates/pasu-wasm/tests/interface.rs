//! What JavaScript may pass, what it gets back and how it is refused, in Node.

use js_sys::{Array, Float32Array, Float64Array, JSON, Object, Reflect, Uint32Array};
use pasu_wasm::{convert, derivatives, evaluate, fingerprint, handles, link, mesh, parse};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

const DINT_VASE: &str = r#"{ "pasu": 1, "title": "Dint vase", "parts": [{ "name": "body",
    "shape": { "kind": "bloor-wilson", "a": 0.01, "r": [1, 0.1, 0.1, 0.8], "R": [-3, -0.5, -0.5, 2],
               "h": [3, 0.3], "H": [-0.5, -0.7], "n1": 5 } }] }"#;

const OPEN_SHEET: &str = r#"{ "pasu": 1, "unit": "mm", "parts": [{
    "shape": { "kind": "boundary-value", "span": 1,
               "x": { "order": 2, "s": 1, "t": 1, "modes": [{ "n": 1, "cos": { "start": 1, "end": 2 } }] },
               "y": { "order": 2, "s": 1, "t": 1, "modes": [{ "n": 1, "sin": { "start": 1, "end": 2 } }] },
               "z": { "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{ "n": 0, "cos": { "start": 3, "start_u": -1 } }] } },
    "place": { "scale": [1, 1, 2], "axis": [0, 0, 1], "angle": 0.5, "shift": [0, 0, 1] },
    "look": { "glaze": "cobalt" } }] }"#;

#[wasm_bindgen_test]
fn a_design_comes_as_text_as_object_and_as_link() {
    for text in [DINT_VASE, OPEN_SHEET] {
        let canonical = stringified(&parse(&text.into()).expect("text"));
        assert_eq!(stringified(&parse(&js(text)).expect("object")), canonical);
        let short = link(&text.into()).expect("link");
        assert!(short.starts_with("1/") || short.starts_with("1~"), "{short}");
        for address in [short.clone(), format!("#{short}"), format!("https://example.org/pot/#{short}")] {
            assert_eq!(stringified(&parse(&address.as_str().into()).expect("address")), canonical, "{address}");
        }
        assert_eq!(link(&js(&canonical)).expect("link again"), short);
        assert_eq!(fingerprint(&short.as_str().into()), fingerprint(&js(text)));
    }
}

#[cfg(target_arch = "wasm32")]
#[wasm_bindgen_test]
fn memory_is_there_before_it_is_wanted() {
    let pages = core::arch::wasm32::memory_size::<0>;
    fingerprint(&DINT_VASE.into()).expect("a hash");
    let before = pages();
    // What is asked for beforehand, and more than the tests themselves take.
    assert!(before >= if cfg!(feature = "making") { 1024 } else { 64 }, "{before}");
    for n1 in 2..60 {
        fingerprint(&DINT_VASE.replace(r#""n1": 5"#, &format!(r#""n1": {n1}"#)).as_str().into()).expect("a hash");
    }
    assert_eq!(pages(), before);
}

#[wasm_bindgen_test]
fn a_mesh_is_typed_arrays_of_the_grid_that_was_asked_for() {
    let made = mesh(&DINT_VASE.into(), &js(r#"{ "rows": 5, "columns": 9 }"#), &JsValue::UNDEFINED).expect("a mesh");
    let field = |name: &str| Reflect::get(&made, &name.into()).expect("a field");
    assert_eq!(field("positions").unchecked_into::<Float32Array>().length(), 3 * 5 * 9);
    assert_eq!(field("normals").unchecked_into::<Float32Array>().length(), 3 * 5 * 9);
    assert_eq!(field("uvs").unchecked_into::<Float32Array>().length(), 2 * 5 * 9);
    let indices = field("indices").unchecked_into::<Uint32Array>();
    assert_eq!(indices.length() % 3, 0);
    assert!(indices.to_vec().iter().all(|&index| index < 5 * 9));
    assert_eq!(field("groups").unchecked_into::<Uint32Array>().to_vec(), [0, indices.length(), 0]);
    for options in [JsValue::UNDEFINED, JsValue::NULL, js("{}"), js(r#"{ "tolerance": 0.05 }"#)] {
        mesh(&DINT_VASE.into(), &options, &JsValue::UNDEFINED).expect("a mesh by default or by tolerance");
    }
}

#[wasm_bindgen_test]
fn arrays_that_are_long_enough_are_written_over() {
    let options = js(r#"{ "rows": 5, "columns": 9 }"#);
    let fresh = mesh(&DINT_VASE.into(), &options, &JsValue::UNDEFINED).expect("a mesh");
    let positions =
        |of: &Object| Reflect::get(of, &"positions".into()).expect("a field").unchecked_into::<Float32Array>();
    let expected = positions(&fresh).to_vec();
    for (length, is_used) in [(3 * 5 * 9, true), (3 * 5 * 9 + 100, true), (3 * 5 * 9 - 1, false), (0, false)] {
        let given = Float32Array::new_with_length(length);
        let into = Object::new();
        Reflect::set(&into, &"positions".into(), &given).expect("set");
        let found = positions(&mesh(&DINT_VASE.into(), &options, &into).expect("a mesh"));
        assert_eq!(found.to_vec(), expected, "{length}");
        assert_eq!(JsValue::from(found.buffer()) == JsValue::from(given.buffer()), is_used, "{length}");
        assert_eq!(JsValue::from(&found) == JsValue::from(&given), length == 3 * 5 * 9, "{length}");
        assert_eq!(found.byte_offset(), 0);
    }
}

#[wasm_bindgen_test]
fn points_come_as_typed_or_plain_arrays() {
    let pairs = [0.0, 0.0, 0.25, 1.0, 1.0, 3.0];
    let typed = JsValue::from(Float64Array::from(pairs.as_slice()));
    let plain: Array = pairs.iter().map(|&number| JsValue::from(number)).collect();
    let vase = JsValue::from(DINT_VASE);
    let from_typed = evaluate(&vase, &0.into(), &typed).expect("typed").to_vec();
    assert_eq!(from_typed.len(), 9);
    assert_eq!(evaluate(&vase, &0.into(), &plain).expect("plain").to_vec(), from_typed);
}

#[wasm_bindgen_test]
fn refusals_carry_code_and_path() {
    let changed = |path: &[&str], value: JsValue| {
        let design = js(DINT_VASE);
        let mut at = design.clone();
        for key in &path[..path.len() - 1] {
            at = Reflect::get(&at, &JsValue::from(*key)).expect("a field");
        }
        Reflect::set(&at, &JsValue::from(path[path.len() - 1]), &value).expect("set");
        design
    };
    let shape = |field: &'static str, value: JsValue| changed(&["parts", "0", "shape", field], value);
    let circular = js(DINT_VASE);
    Reflect::set(&circular, &"parts".into(), &Array::of1(&circular)).expect("set");
    let cases: Vec<(JsValue, &str, &str)> = vec![
        (changed(&["parts", "0", "shape", "r", "2"], f64::NAN.into()), "not-finite", "parts[0].shape.r[2]"),
        (shape("a", f64::INFINITY.into()), "not-finite", "parts[0].shape.a"),
        (shape("a", f64::NEG_INFINITY.into()), "not-finite", "parts[0].shape.a"),
        (shape("a", "six".into()), "wrong-type", "parts[0].shape.a"),
        (shape("a", JsValue::UNDEFINED), "missing-field", "parts[0].shape.a"),
        (shape("b", 1.into()), "unknown-field", "parts[0].shape.b"),
        (shape("kind", "teapot".into()), "unknown-name", "parts[0].shape.kind"),
        (shape("a", js_sys::Function::new_no_args("").into()), "wrong-type", "parts[0].shape.a"),
        (shape("a", js_sys::Symbol::iterator().into()), "wrong-type", "parts[0].shape.a"),
        (changed(&["pasu"], 2.into()), "unknown-version", "pasu"),
        (changed(&["parts"], Array::new().into()), "out-of-range", "parts"),
        (changed(&["unit"], "furlong".into()), "unknown-name", "unit"),
        (circular, "too-large", ""),
        ("{ \"pasu\": 1".into(), "not-json", ""),
        ("#1~damaged".into(), "damaged-link", ""),
        ("#2/bloor-wilson".into(), "unknown-version", ""),
        ("a teapot".into(), "damaged-link", ""),
        (JsValue::UNDEFINED, "wrong-type", ""),
        (5.into(), "wrong-type", ""),
    ];
    for (source, code, path) in &cases {
        expect(parse(source), code, path);
        expect(link(source), code, path);
        expect(fingerprint(source), code, path);
        expect(mesh(source, &JsValue::UNDEFINED, &JsValue::UNDEFINED), code, path);
        expect(evaluate(source, &0.into(), &Array::new()), code, path);
        expect(derivatives(source, &0.into(), &Array::new()), code, path);
    }
}

#[wasm_bindgen_test]
fn wrong_arguments_are_refused_by_name() {
    let vase = JsValue::from(DINT_VASE);
    let options = |text: &str| mesh(&vase, &js(text), &JsValue::UNDEFINED);
    expect(options(r#"{ "rows": 2.5 }"#), "out-of-range", "rows");
    expect(options(r#"{ "columns": -1 }"#), "out-of-range", "columns");
    expect(options(r#"{ "rows": "many" }"#), "wrong-type", "rows");
    expect(options(r#"{ "row": 5 }"#), "unknown-field", "row");
    expect(mesh(&vase, &5.into(), &JsValue::UNDEFINED), "wrong-type", "options");

    let origin = JsValue::from(Float64Array::new_with_length(2));
    for part in [JsValue::from(-1), 0.5.into(), f64::NAN.into()] {
        expect(evaluate(&vase, &part, &origin), "no-such-point", "part");
    }
    expect(evaluate(&vase, &"0".into(), &origin), "wrong-type", "part");
    expect(evaluate(&vase, &0.into(), &JsValue::UNDEFINED), "wrong-type", "at");
    expect(derivatives(&vase, &0.into(), &js(r#"[0, "1"]"#)), "wrong-type", "at[1]");
}

#[wasm_bindgen_test]
fn a_typed_array_is_looked_at_before_it_is_copied() {
    // A document with a list of this many numbers, 80 MB, which would stay the memory of the module for good.
    let design = js(r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order" } }] }"#);
    let parts = Reflect::get(&design, &"parts".into()).expect("parts");
    let part = Reflect::get(&parts, &0.into()).expect("a part");
    let shape = Reflect::get(&part, &"shape".into()).expect("a shape");
    Reflect::set(&shape, &"r".into(), &Float64Array::new_with_length(10_000_000)).expect("set");
    expect(parse(&design), "too-large", "parts[0].shape.r");
    // It is one list that is too long, not the document.
    let message = Reflect::get(&parse(&design).expect_err("too long"), &"message".into()).expect("a message");
    assert_eq!(message.as_string().as_deref(), Some("expected at most 1048576 numbers in a list, found 10000000"));
}

/// What a script returns.
fn made(script: &str) -> JsValue {
    js_sys::Function::new_no_args(script).call0(&JsValue::UNDEFINED).expect("a script that returns")
}

/// Values of which nothing can be had, but that they throw.
fn unreadable() -> Vec<JsValue> {
    [
        "const array = new Float64Array(4); structuredClone(array, { transfer: [array.buffer] }); return array",
        "const array = new Float32Array(4); structuredClone(array, { transfer: [array.buffer] }); return array",
        "const { proxy, revoke } = Proxy.revocable({}, {}); revoke(); return proxy",
        "const { proxy, revoke } = Proxy.revocable([1, 2], {}); revoke(); return proxy",
        "return new Proxy(new Float64Array(4), {})",
        "return Object.create(Float64Array.prototype)",
        "return new Proxy({}, { ownKeys() { throw new Error('mine') } })",
        "return new Proxy([], { get() { throw new Error('mine') } })",
    ]
    .into_iter()
    .map(made)
    .collect()
}

#[wasm_bindgen_test]
fn what_cannot_be_read_is_the_callers_mistake() {
    let vase = JsValue::from(DINT_VASE);
    for value in unreadable() {
        expect(parse(&value), "wrong-type", "");
        expect(mesh(&vase, &value, &JsValue::UNDEFINED), "wrong-type", "options");
        expect(evaluate(&vase, &0.into(), &value), "wrong-type", "at");
        // And at every depth of a design.
        for path in [&["parts"][..], &["parts", "0"], &["parts", "0", "shape"], &["parts", "0", "shape", "r"]] {
            let design = js(DINT_VASE);
            let (last, above) = path.split_last().expect("a path");
            let of = above.iter().fold(design.clone(), |at, key| Reflect::get(&at, &(*key).into()).expect("a field"));
            Reflect::set(&of, &(*last).into(), &value).expect("set");
            let path = ["parts", "[0]", ".shape", ".r"][..path.len()].concat();
            expect(parse(&design), "wrong-type", &path);
        }
    }
}

#[wasm_bindgen_test]
fn a_getter_may_throw_whatever_it_likes() {
    let thrown = [
        "throw new Error('mine')",
        "throw new RangeError('mine')",
        "throw undefined",
        "const { proxy, revoke } = Proxy.revocable({}, {}); revoke(); throw proxy",
        "throw { get message() { throw new Error('mine') } }",
        "throw Object.create(null)",
    ];
    for statement in thrown {
        let list = made(&format!("return Object.defineProperty([1, 2, 3, 4], 2, {{ get() {{ {statement} }} }})"));
        expect(evaluate(&DINT_VASE.into(), &0.into(), &list), "wrong-type", "at[2]");
        let design = js(DINT_VASE);
        Reflect::set(&design, &"title".into(), &JsValue::UNDEFINED).expect("set");
        Reflect::set(&design, &"parts".into(), &list).expect("set");
        expect(parse(&design), "wrong-type", "parts[2]");
        // Where there is no array to write over, there is a new one.
        let into = made(&format!("return {{ get positions() {{ {statement} }} }}"));
        mesh(&DINT_VASE.into(), &js(r#"{ "rows": 5, "columns": 9 }"#), &into).expect("a mesh");
    }
}

#[wasm_bindgen_test]
fn half_a_letter_is_refused_and_does_not_become_another_one() {
    for half in ["'a\\ud800'", "'\\udc00b'", "'\\udc00\\ud800'", "'\u{fffd}\\ud83d'"] {
        let broken = made(&format!("return {half}"));
        let design = js(DINT_VASE);
        Reflect::set(&design, &"title".into(), &broken).expect("set");
        expect(parse(&design), "wrong-type", "title");
        let design = js(DINT_VASE);
        let part = Reflect::get(&design, &"parts".into()).and_then(|parts| Reflect::get(&parts, &"0".into()));
        Reflect::set(&part.expect("a part"), &"name".into(), &broken).expect("set");
        expect(parse(&design), "wrong-type", "parts[0].name");
        expect(parse(&broken), "wrong-type", "");
        expect(mesh(&broken, &JsValue::UNDEFINED, &JsValue::UNDEFINED), "wrong-type", "");
    }
    // Whole ones stay what they are, the letter that stands for others among them.
    for whole in ["a\u{fffd}", "\u{1f3fa} \u{fffd}", ""] {
        let design = js(DINT_VASE);
        Reflect::set(&design, &"title".into(), &whole.into()).expect("set");
        let title = Reflect::get(&parse(&design).expect("a design"), &"title".into()).expect("a title");
        assert_eq!(title.as_string().unwrap_or_default(), whole);
    }
}

#[wasm_bindgen_test]
fn what_is_no_array_is_not_written_over() {
    let options = js(r#"{ "rows": 5, "columns": 9 }"#);
    for script in [
        "const a = new Float32Array(999); structuredClone(a, { transfer: [a.buffer] }); return a",
        "const { proxy, revoke } = Proxy.revocable(new Float32Array(999), {}); revoke(); return proxy",
        "return new Proxy(new Float32Array(999), {})",
        "return new Proxy(new Float32Array(999), { get: (_, key) => key === 'length' ? 999 : undefined })",
        "return Object.create(Float32Array.prototype)",
    ] {
        let into = Object::new();
        let given = made(script);
        Reflect::set(&into, &"positions".into(), &given).expect("set");
        let found = mesh(&DINT_VASE.into(), &options, &into).expect("a mesh");
        let positions = Reflect::get(&found, &"positions".into()).expect("a field");
        assert!(positions != given, "{script}");
        assert_eq!(positions.unchecked_into::<Float32Array>().length(), 3 * 5 * 9, "{script}");
    }
}

#[wasm_bindgen_test]
fn a_proxy_of_plain_data_is_plain_data() {
    let design = js(DINT_VASE);
    let watched = js_sys::Function::new_with_args(
        "value",
        "const watched = (value) => typeof value !== 'object' ? value
            : new Proxy(value, { get: (of, key) => watched(Reflect.get(of, key)) });
        return watched(value)",
    )
    .call1(&JsValue::UNDEFINED, &design)
    .expect("a proxy");
    assert_eq!(stringified(&parse(&watched).expect("read")), stringified(&parse(&design).expect("read")));
}

#[wasm_bindgen_test]
fn every_kind_of_number_is_one() {
    let r = |script: &str| {
        let design = js(DINT_VASE);
        let list = made(script);
        let parts = Reflect::get(&design, &"parts".into()).expect("parts");
        let part = Reflect::get(&parts, &0.into()).expect("a part");
        Reflect::set(&Reflect::get(&part, &"shape".into()).expect("a shape"), &"r".into(), &list).expect("set");
        stringified(&parse(&design).unwrap_or_else(|error| panic!("{script}: {error:?}")))
    };
    let plain = r("return [2, 0.5, 0, 1]");
    for script in [
        "return new Float64Array([2, 0.5, 0, 1])",
        "return new Float32Array([2, 0.5, -0, 1])",
        "return [2n, 0.5, -0, 1n]",
        "return new Float64Array([9, 2, 0.5, 0, 1]).subarray(1)",
    ] {
        assert_eq!(r(script), plain, "{script}");
    }
}

fn expect<T: std::fmt::Debug>(outcome: Result<T, impl Into<JsValue>>, code: &str, path: &str) {
    let error: JsValue = match outcome {
        Ok(value) => panic!("expected {code} at `{path}`, got {value:?}"),
        Err(error) => error.into(),
    };
    let text = |key: &str| Reflect::get(&error, &key.into()).ok().and_then(|value| value.as_string());
    let found = (text("name"), text("code"), text("path"));
    assert_eq!(
        found,
        (Some("PasuError".into()), Some(code.into()), Some(path.into())),
        "with the message {:?}",
        text("message")
    );
    assert!(text("message").is_some_and(|message| message.len() > 10), "a message for a person");
}

const SECOND: &str = r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "height": 10 }"#;

/// What JavaScript sees, which writes whole numbers as such.
fn read(value: &JsValue) -> serde_json::Value {
    serde_json::from_str(&stringified(value)).expect("JSON")
}

/// What the crate answers, as JavaScript would see it.
fn as_json(value: &impl serde::Serialize) -> JsValue {
    js(&serde_json::to_string(value).expect("JSON"))
}

#[wasm_bindgen_test]
fn a_vase_comes_in_another_order_as_the_crate_says() {
    let made = convert(&js(SECOND), &"fourth-order".into()).expect("a conversion");
    let native =
        pasu::Shape::parse(SECOND).and_then(|vase| vase.convert(pasu::VaseOrder::Fourth)).expect("a conversion");
    assert_eq!(read(&made), read(&as_json(&native)));
    assert_eq!(read(&made)["lost"], serde_json::json!(["petals"]));
    let design = format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {} }}] }}"#, read(&made)["shape"]);
    link(&design.as_str().into()).expect("a design of it");
}

#[wasm_bindgen_test]
fn handles_are_those_of_the_crate_with_the_paths_of_the_given_shape() {
    let found = handles(&js(SECOND)).expect("handles");
    let native = pasu::Shape::parse(SECOND).expect("a shape").handles();
    assert_eq!(read(&found), read(&as_json(&native)));
    // Not in ascending order of n, as no canonical design has it.
    let free = r#"{ "kind": "boundary-value", "span": "2pi",
        "x": { "order": 2, "s": 1, "t": 1, "modes": [{ "n": 4, "cos": { "end": 1 } }, { "n": 1, "cos": { "start": 1, "end": 2 } }] },
        "y": { "order": 2, "s": 1, "t": 1, "modes": [{ "n": 1, "sin": { "start": 1, "end": 2 } }] },
        "z": { "order": 2, "s": 1, "t": 1, "modes": [] } }"#;
    let list = &read(&handles(&js(free)).expect("handles"))["list"];
    assert_eq!(list[0]["radial"][0], serde_json::json!({ "path": "x.modes[1].cos.start", "by": 1 }));
}

#[wasm_bindgen_test]
fn what_is_no_shape_and_no_order_is_refused_by_its_path() {
    let refused = |made: Result<JsValue, JsValue>| {
        let error = made.expect_err("a refusal");
        ["code", "path"].map(|key| Reflect::get(&error, &key.into()).expect("a field").as_string().expect("a text"))
    };
    assert_eq!(refused(convert(&js(SECOND), &"fifth-order".into())), ["unknown-name", "order"]);
    assert_eq!(refused(convert(&js(SECOND), &JsValue::UNDEFINED)), ["wrong-type", "order"]);
    assert_eq!(refused(convert(&JsValue::NULL, &"fourth-order".into())), ["wrong-type", "shape"]);
    assert_eq!(refused(handles(&js(r#"{ "kind": "second-order", "r": [1, 0] }"#))), ["wrong-type", "r"]);
    assert_eq!(refused(handles(&js(r#"{ "kind": "jug" }"#))), ["unknown-name", "kind"]);
    let free = js(r#"{ "kind": "boundary-value", "span": 1, "x": { "order": 2, "s": 1, "t": 1, "modes": [] },
        "y": { "order": 2, "s": 1, "t": 1, "modes": [] }, "z": { "order": 2, "s": 1, "t": 1, "modes": [] } }"#);
    assert_eq!(refused(convert(&free, &"second-order".into())), ["unsupported-shape", ""]);
}

fn js(text: &str) -> JsValue {
    JSON::parse(text).expect("JSON")
}

fn stringified(value: &JsValue) -> String {
    JSON::stringify(value.unchecked_ref::<Object>()).expect("plain data").into()
}
