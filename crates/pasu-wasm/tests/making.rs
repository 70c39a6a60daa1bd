//! Measures, checks, files and what is drawn of a pot: what JavaScript may pass, what it gets back and how it is refused, in Node.

#![cfg(feature = "making")]

use js_sys::{Array, Float32Array, JSON, Object, Reflect, Uint8Array, Uint32Array};
use pasu_wasm::{
    check, compare, connectivity, constraints, flat, link, measure, mesh, obj_materials, open, paint, parse, pick,
    provenance, sketch, solid, tree, watched, water, write,
};
use serde_json::{Map, Value};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;
use xxhash_rust::xxh64::xxh64;

/// Written and checked by the native tests: for each design its link, what is made of it, and a hash of every file.
const GOLDENS: &str = include_str!("../../../tests/goldens/files.json");

const FORMATS: [&str; 10] = ["stl", "3mf", "glb", "obj", "obj.zip", "ply", "step", "svg", "a4.svg", "letter.svg"];

const MEASURES: &[&str] = &[
    "unit",
    "product",
    "height",
    "bottom",
    "top",
    "width",
    "area",
    "clay",
    "capacity",
    "centre",
    "footprint",
    "tipping",
    "parts",
];

/// A cylinder of radius 3 and height 4 with a wall of 0.5, in inches.
const CUP: &str = r#"{ "pasu": 1, "unit": "in", "parts": [{
    "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    "wall": { "thickness": 0.5, "base": 1 } }] }"#;

#[wasm_bindgen_test]
fn files_are_those_of_the_native_build() {
    let goldens: Map<String, Value> = serde_json::from_str(GOLDENS).expect("the goldens are JSON");
    let text = |key: String| goldens[&key].as_str().expect("a text").to_owned();
    let names: Vec<&str> = goldens.keys().filter_map(|key| key.strip_suffix(": link")).collect();
    assert!(names.len() >= 5, "the goldens have lost designs");
    for name in names {
        let source = JsValue::from(text(format!("{name}: link")));
        let making = js(&text(format!("{name}: making")));
        for format in FORMATS {
            let bytes = write(&source, &format.into(), &making).unwrap_or_else(|error| panic!("{name}: {error:?}"));
            let hash = format!("{:016x}", xxh64(&bytes.to_vec(), 0));
            assert_eq!(hash, text(format!("{name}.{format}")), "{name}.{format}");
        }
    }
}

#[wasm_bindgen_test]
fn a_file_opens_the_design_that_it_was_made_of() {
    let cup = JsValue::from(CUP);
    for format in FORMATS {
        let bytes = write(&cup, &format.into(), &js(r#"{ "tolerance": 0.05 }"#)).expect("a file");
        let found = open(&bytes).expect("bytes");
        // The header of an STL file has room for a short link only.
        let expected = (format != "stl").then(|| link(&cup).expect("a link"));
        assert_eq!(found, expected, "{format}");
        found.map(|link| parse(&link.into()).expect("a design"));
    }
    let vase = JsValue::from("#1/bloor-wilson?n1=5");
    let bytes = write(&vase, &"stl".into(), &js(r#"{ "product": "solid", "tolerance": 0.1 }"#)).expect("a file");
    assert_eq!(open(&bytes), Ok(Some("1/bloor-wilson?n1=5".to_owned())));
    assert_eq!(open(&Uint8Array::new_with_length(200)), Ok(None));
    expect(open(&"stl".into()), "wrong-type", "bytes");
}

#[wasm_bindgen_test]
fn an_obj_names_its_materials() {
    let bytes = write(&CUP.into(), &"obj".into(), &js(r#"{ "tolerance": 0.2 }"#)).expect("a file").to_vec();
    let text = String::from_utf8(bytes).expect("text");
    let name = text.lines().find_map(|line| line.strip_prefix("usemtl ")).expect("a material");
    assert!(obj_materials().contains(&format!("\nnewmtl {name}\n")), "{name}");
}

#[wasm_bindgen_test]
fn a_file_says_how_it_was_made() {
    for making in [
        r#"{"product":"pot","size":{"height":2},"shrinkage":12.5,"tolerance":0.2,"craft":"clay"}"#,
        r#"{"product":"solid","size":{"width":7},"shrinkage":0,"tolerance":0.2}"#,
        r#"{"product":"pot","size":{"capacity":30},"shrinkage":0,"tolerance":0.2,"craft":"print"}"#,
        r#"{"product":"pot","shrinkage":0}"#,
    ] {
        let bytes = write(&CUP.into(), &"ply".into(), &js(making)).expect("a file");
        let found = provenance(&bytes).expect("bytes").expect("a file of ours");
        assert_eq!(JSON::stringify(&at(&found, "making")).expect("plain data"), making);
        let again = write(&at(&found, "link"), &"ply".into(), &at(&found, "making")).expect("a file");
        assert!(again.to_vec() == bytes.to_vec(), "{making}");
    }
    let bytes = write(&CUP.into(), &"ply".into(), &JsValue::UNDEFINED).expect("a file").to_vec();
    let damaged = String::from_utf8_lossy(&bytes[..2000]).replace("shrinkage: 0", "shrinkage: 99");
    let found = provenance(&Uint8Array::from(damaged.as_bytes())).expect("bytes").expect("a file of ours");
    assert!(at(&found, "making").is_null() && at(&found, "link").is_string());
    assert!(provenance(&Uint8Array::new_with_length(200)).expect("bytes").is_none());
    expect(provenance(&"stl".into()), "wrong-type", "bytes");
}

#[wasm_bindgen_test]
fn measures_are_plain_data() {
    let cup = JsValue::from(CUP);
    let measures = measure(&cup, &js(r#"{ "fill": 2, "density": 2 }"#)).expect("measures");
    let keys: Vec<String> =
        Object::keys(measures.unchecked_ref::<Object>()).iter().filter_map(|key| key.as_string()).collect();
    assert_eq!(keys, MEASURES);
    let number = |path: &str| at(&measures, path).as_f64().unwrap_or_else(|| panic!("{path} is a number"));
    let pi = std::f64::consts::PI;
    for (path, expected) in [
        ("height.value", 4.0),
        ("capacity.brim.value", pi * 2.5 * 2.5 * 3.0),
        ("capacity.fill.volume.value", pi * 2.5 * 2.5),
        ("clay.volume.value", pi * (9.0 * 4.0 - 2.5 * 2.5 * 3.0)),
        ("parts.0.thickness.asked", 0.5),
    ] {
        let found = number(path);
        assert!((found - expected).abs() <= 1e-9 * expected, "{path} is {found}, expected {expected}");
    }
    // 2 g/cm3, 16.387 cm3 to the cubic inch.
    let mass = number("clay.mass.value") / number("clay.volume.value");
    assert!((mass - 2.0 * 16.387_064).abs() < 1e-9, "{mass} g per cubic inch");
    assert!(at(&measure(&cup, &js(r#"{ "product": "solid" }"#)).expect("measures"), "capacity").is_null());
    measure(&cup, &JsValue::UNDEFINED).expect("options may be left out");
}

#[wasm_bindgen_test]
fn scenes_are_compared() {
    let part = |x: f64| {
        format!(r#"{{ "shape": {{ "kind": "octant", "exponents": [2, 2, 2] }}, "place": {{ "shift": [{x}, 0, 0] }} }}"#)
    };
    let scene = |first: f64, second: f64| {
        JsValue::from(format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, part(first), part(second)))
    };
    let same = compare(&scene(0.0, 2.0), &scene(2.0, 0.0)).expect("a difference");
    assert_eq!(at(&same, "isSame"), JsValue::TRUE);
    assert_eq!(at(&same, "kept.0.after").as_f64(), Some(1.0));
    let moved = compare(&scene(0.0, 2.0), &scene(2.0, 3.0)).expect("a difference");
    assert_eq!(at(&moved, "isSame"), JsValue::FALSE);
    assert_eq!((at(&moved, "moved.0.before").as_f64(), at(&moved, "moved.0.after").as_f64()), (Some(0.0), Some(1.0)));
    expect(compare(&scene(0.0, 2.0), &"nothing".into()), "damaged-link", "");
}

#[wasm_bindgen_test]
fn scenes_are_trees_and_lists() {
    let octant = r#""shape": { "kind": "octant", "exponents": [2, 2, 2] }"#;
    let part =
        |x: f64, object: usize| format!(r#"{{ "object": {object}, {octant}, "place": {{ "shift": [{x}, 0, 0] }} }}"#);
    let scene: JsValue =
        format!(r#"{{ "pasu": 1, "parts": [{}, {}, {}] }}"#, part(1.0, 0), part(2.0, 4), part(4.0, 0)).into();
    let found = tree(&scene).expect("a tree");
    assert_eq!(at(&found, "tree.place.shift.0").as_f64(), Some(1.0));
    assert_eq!(at(&found, "tree.unconnected.0.connected.1.place.shift.0").as_f64(), Some(3.0));
    let again = flat(&found).expect("a design");
    assert_eq!(link(&again).expect("a link"), link(&scene).expect("a link"));
    let text = js_sys::JSON::stringify(&found).expect("JSON");
    assert_eq!(link(&flat(&text).expect("a design")).expect("a link"), link(&scene).expect("a link"));
    let matrix = connectivity(&scene).expect("a matrix");
    assert_eq!(at(&matrix, "objects.1").as_f64(), Some(1.0));
    assert_eq!((at(&matrix, "glued.0.2"), at(&matrix, "glued.0.1")), (JsValue::TRUE, JsValue::FALSE));
    expect(connectivity(&"nothing".into()), "damaged-link", "");
    expect(tree(&"nothing".into()), "damaged-link", "");
    expect(flat(&"nothing".into()), "not-json", "");
    expect(
        flat(&js(&format!(
            r#"{{ "pasu": 1, "tree": {{ "connected": [{{ {octant} }}, {{ {octant} }}], "scale": [1, 1, 2] }} }}"#
        ))),
        "unknown-field",
        "tree.scale",
    );
    // What only an object can say: no number, and a union that is its own member.
    let leaf = js(&format!(r#"{{ "pasu": 1, "tree": {{ {octant}, "place": {{ "angle": 0 }} }} }}"#));
    let put = |object: &JsValue, name: &str, value: JsValue| {
        Reflect::set(object, &name.into(), &value).expect("an object");
    };
    put(&at(&leaf, "tree.place"), "angle", f64::NAN.into());
    expect(flat(&leaf), "not-finite", "tree.place.angle");
    let union = js(r#"{ "connected": [] }"#);
    let members = js_sys::Array::from(&at(&union, "connected"));
    members.push(&union);
    members.push(&union);
    put(&union, "connected", members.into());
    let cyclic = js(r#"{ "pasu": 1 }"#);
    put(&cyclic, "tree", union);
    expect(flat(&cyclic), "too-large", "");
}

#[wasm_bindgen_test]
fn what_is_where_is_told() {
    let ball = |x: f64, object: u32| {
        format!(
            r#"{{ "object": {object}, "shape": {{ "kind": "octant", "exponents": [2, 2, 2] }}, "place": {{ "shift": [{x}, 0, 0] }} }}"#
        )
    };
    let scene = JsValue::from(format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, ball(0.0, 0), ball(0.5, 1)));
    let ray = js(r#"{ "origin": [0.6, 0.1, -1], "direction": [0, 0, 2] }"#);
    let hits = pick(&scene, &ray).expect("hits");
    assert_eq!((at(&hits, "0.part").as_f64(), at(&hits, "0.distance").as_f64()), (Some(0.0), Some(1.0)));
    assert_eq!((at(&hits, "3.part").as_f64(), at(&hits, "length").as_f64()), (Some(1.0), Some(4.0)));
    assert_eq!(at(&hits, "0.normal.2").as_f64(), Some(-1.0));
    let held = pasu_wasm::at(&scene, &js("[0.6, 0.2, 0.15]")).expect("parts");
    assert_eq!((at(&held, "length").as_f64(), at(&held, "1.part").as_f64()), (Some(2.0), Some(0.0)));
    let report = constraints(&scene, &JsValue::UNDEFINED).expect("a report");
    assert_eq!((at(&report, "isKept"), at(&report, "breaches.0.code")), (JsValue::FALSE, "interference".into()));
    expect(pick(&scene, &js(r#"{ "origin": [0, 0, 0], "direction": [0, 0, 0] }"#)), "out-of-range", "ray.direction");
    expect(pick(&scene, &js(r#"{ "origin": [0, 0, 0] }"#)), "missing-field", "ray.direction");
    let nowhere = js_sys::Array::of3(&0.into(), &f64::NAN.into(), &0.into());
    expect(pasu_wasm::at(&scene, &nowhere), "not-finite", "point[1]");
    expect(constraints(&scene, &js(r#"{ "slack": -1 }"#)), "out-of-range", "slack");
}

/// It was `more`, as if the design had such a field.
#[wasm_bindgen_test]
fn what_is_wrong_in_a_ray_or_a_point_is_found_there() {
    let scene =
        JsValue::from(r##"{ "pasu": 1, "parts": [{ "shape": { "kind": "octant", "exponents": [2, 2, 2] } }] }"##);
    let ray = |fields: &str| pick(&scene, &js(fields));
    expect(ray(r#"{ "origin": [0, 0, 0], "direction": [0, 0, 1], "more": 1 }"#), "unknown-field", "ray.more");
    expect(ray(r#"{ "origin": [0, 0], "direction": [0, 0, 1] }"#), "wrong-type", "ray.origin");
    expect(ray(r#"{ "origin": [0, 0, "up"], "direction": [0, 0, 1] }"#), "wrong-type", "ray.origin[2]");
    expect(ray("3"), "wrong-type", "ray");
    expect(pasu_wasm::at(&scene, &js(r#"[0, 0, "up"]"#)), "wrong-type", "point[2]");
    expect(pasu_wasm::at(&scene, &js("[0, 0]")), "wrong-type", "point");
}

#[wasm_bindgen_test]
fn checks_say_what_cannot_be_made() {
    let good = check(&CUP.into(), &js(r#"{ "tolerance": 0.05 }"#)).expect("a report");
    assert_eq!(at(&good, "ok"), JsValue::TRUE);
    assert_eq!(at(&good, "product"), JsValue::from("pot"));
    assert_eq!(at(&good, "meshes.0.closed"), JsValue::TRUE);
    assert_eq!(at(&good, "meshes.0.crossings").as_f64(), Some(0.0));
    let bare = CUP.replace(r#""wall": { "thickness": 0.5, "base": 1 }"#, r#""object": 0"#);
    let bad = check(&bare.as_str().into(), &JsValue::UNDEFINED).expect("a report");
    assert_eq!(at(&bad, "ok"), JsValue::FALSE);
    assert_eq!(at(&bad, "findings.0.severity"), JsValue::from("error"));
    assert_eq!(at(&bad, "findings.0.part").as_f64(), Some(0.0));
    assert!(at(&bad, "findings.0.message").as_string().is_some_and(|text| text.len() > 10));
    check(&bare.as_str().into(), &js(r#"{ "product": "solid" }"#)).expect("a solid needs no wall");
}

#[wasm_bindgen_test]
fn a_sketch_is_written_over_an_earlier_one() {
    let whole = solid(&CUP.into(), &js(r#"{ "tolerance": 0.05 }"#)).expect("a solid");
    let kinds = |of: &Object| {
        let faces = at(of, "faces").unchecked_into::<Array>();
        faces.iter().map(|face| at(&face.unchecked_into(), "kind").as_string().expect("a name")).collect::<Vec<_>>()
    };
    let first =
        sketch(&CUP.into(), &js(r#"{ "tolerance": 0.01, "fill": 0.5 }"#), &JsValue::UNDEFINED).expect("a sketch");
    let mut expected = kinds(&whole);
    expected.retain(|kind| kind != "outer");
    assert_eq!(kinds(&first), expected);
    // A cup on a floor of 1, 4 high.
    let water = at(&first, "water").unchecked_into::<Object>();
    assert!((at(&water, "level").as_f64().expect("a number") - 2.5).abs() < 1e-9);
    let buffer = |of: &Object| at(of, "positions").unchecked_into::<Float32Array>().buffer();
    let into = Object::new();
    for key in ["positions", "normals"] {
        let all = Float32Array::new(&at(&first, key).unchecked_into::<Float32Array>().buffer());
        Reflect::set(&into, &key.into(), &all).expect("an object");
    }
    // What is coarser has room in the arrays of what is finer, which are handed back.
    let second = sketch(&CUP.into(), &js(r#"{ "tolerance": 0.05 }"#), &into).expect("a sketch");
    assert!(Object::is(&buffer(&first), &buffer(&second)));
    let lengths = [&first, &second].map(|of| at(of, "positions").unchecked_into::<Float32Array>().length());
    assert!(lengths[1] < lengths[0], "{lengths:?}");
    assert!(at(&second, "water").is_null());
    let fresh = sketch(&CUP.into(), &js(r#"{ "tolerance": 0.05 }"#), &JsValue::UNDEFINED).expect("a sketch");
    for key in ["positions", "normals"] {
        let numbers = [&second, &fresh].map(|of| at(of, key).unchecked_into::<Float32Array>().to_vec());
        assert_eq!(numbers[0], numbers[1], "{key}");
    }
    let error = sketch(&CUP.into(), &js(r#"{ "fill": 2 }"#), &JsValue::UNDEFINED).expect_err("no share");
    assert_eq!(at(&error.unchecked_into(), "path").as_string().as_deref(), Some("fill"));
}

#[wasm_bindgen_test]
fn a_solid_is_drawn_in_model_units() {
    let making = js(r#"{ "size": { "height": 2 }, "shrinkage": 20, "tolerance": 0.05 }"#);
    let drawn = solid(&CUP.into(), &making).expect("a solid");
    let positions = at(&drawn, "positions").unchecked_into::<Float32Array>().to_vec();
    let normals = at(&drawn, "normals").unchecked_into::<Float32Array>().to_vec();
    let indices = at(&drawn, "indices").unchecked_into::<Uint32Array>().to_vec();
    assert_eq!(positions.len(), normals.len());
    let (low, high) = positions.iter().fold((f32::MAX, f32::MIN), |(low, high), &x| (low.min(x), high.max(x)));
    assert!((low + 3.0).abs() < 1e-5 && (high - 4.0).abs() < 1e-5, "{low} to {high}");
    for normal in normals.chunks(3) {
        let length: f32 = normal.iter().map(|x| x * x).sum();
        assert!((length - 1.0).abs() < 1e-5, "{normal:?}");
    }
    let mut next = 0;
    let mut kinds = Vec::new();
    for face in at(&drawn, "faces").unchecked_into::<Array>().iter() {
        kinds.push(at(&face, "kind").as_string().expect("a word"));
        assert_eq!(at(&face, "first").as_f64(), Some(f64::from(next)));
        next += at(&face, "count").as_f64().expect("a number") as u32;
    }
    assert_eq!(next as usize, indices.len());
    kinds.sort();
    assert_eq!(kinds, ["floor", "lining", "outer", "rim", "underside"]);
    let scale = |name: &str| at(&drawn, &format!("scale.{name}")).as_f64().expect("a number");
    assert!((scale("size") - 0.5).abs() < 1e-12 && (scale("shrinkage") - 1.25).abs() < 1e-12);
    assert!((scale("millimetres") - 25.4 * 0.625).abs() < 1e-9);
}

#[wasm_bindgen_test]
fn colours_have_one_value_for_each_vertex() {
    let cup = JsValue::from(CUP);
    let grid = js(r#"{ "rows": 5, "columns": 9 }"#);
    let meshed = mesh(&cup, &grid, &JsValue::UNDEFINED).expect("a mesh");
    let n_vertices = at(&meshed, "positions").unchecked_into::<Float32Array>().length() / 3;
    for (map, expected) in
        [("mean-curvature", 1.0 / 6.0), ("gaussian-curvature", 0.0), ("thickness", 0.5), ("overhang", 0.0)]
    {
        let painted = paint(&cup, &map.into(), &grid).expect("values");
        assert_eq!(at(&painted, "values").unchecked_into::<Float32Array>().length(), n_vertices, "{map}");
        for bound in ["least", "greatest"] {
            let found = at(&painted, bound).as_f64().expect("a number");
            assert!((found - expected).abs() < 1e-5, "{map}: {bound} is {found}, expected {expected}");
        }
    }
}

#[wasm_bindgen_test]
fn water_stands_where_it_is_told() {
    let filled = water(&CUP.into(), &2.5.into()).expect("water");
    let volume = at(&filled, "volume").as_f64().expect("a number");
    assert!((volume - std::f64::consts::PI * 2.5 * 2.5 * 1.5).abs() < 1e-5, "{volume}");
    let positions = at(&filled, "positions").unchecked_into::<Float32Array>().to_vec();
    assert!(positions.chunks(3).all(|point| point[2] == 2.5));
    let indices = at(&filled, "indices").unchecked_into::<Uint32Array>().to_vec();
    assert!(indices.len() >= 30 && indices.iter().all(|&index| (index as usize) < positions.len() / 3));
}

#[wasm_bindgen_test]
fn refusals_say_where_in_space_and_what_they_name() {
    let pinched = CUP.replace("[3, 0, 3, 0]", "[3, 0, -3, 0]");
    let error = solid(&pinched.into(), &JsValue::UNDEFINED).expect_err("a pinched surface");
    assert_eq!(at(&error, "code").as_string().as_deref(), Some("pinched-surface"));
    let place: Vec<f64> = at(&error, "place").unchecked_into::<Array>().iter().filter_map(|x| x.as_f64()).collect();
    assert!(place.len() == 3 && place.iter().zip([0.0, 0.0, 2.0]).all(|(x, y)| (x - y).abs() < 1e-9), "{place:?}");
    let error = check(&CUP.into(), &js(r#"{ "shrinkage": 50 }"#)).expect_err("too much");
    let args = JSON::stringify(&at(&error, "args")).expect("plain data");
    assert_eq!(args, r#"{"least":0,"below":50,"found":50}"#);
    assert!(at(&error, "place").is_undefined());
}

#[wasm_bindgen_test]
fn wrong_arguments_are_refused_by_name() {
    let cup = JsValue::from(CUP);
    let cases = [
        (r#"{ "size": 5 }"#, "wrong-type", "size"),
        (r#"{ "size": {} }"#, "missing-field", "size"),
        (r#"{ "size": { "height": 1, "width": 1 } }"#, "duplicate", "size"),
        (r#"{ "size": { "height": "tall" } }"#, "wrong-type", "size.height"),
        (r#"{ "size": { "height": 0 } }"#, "out-of-range", "size.height"),
        (r#"{ "size": { "depth": 1 } }"#, "unknown-field", "size.depth"),
        (r#"{ "shrinkage": 50 }"#, "out-of-range", "shrinkage"),
        (r#"{ "tolerance": -1 }"#, "out-of-range", "tolerance"),
        (r#"{ "product": "mug" }"#, "unknown-name", "product"),
        (r#"{ "product": 5 }"#, "wrong-type", "product"),
        (r#"{ "colour": 5 }"#, "unknown-field", "colour"),
        (r#""large""#, "wrong-type", "making"),
    ];
    for (making, code, path) in cases {
        let making = js(making);
        expect(check(&cup, &making), code, path);
        expect(write(&cup, &"stl".into(), &making), code, path);
        expect(solid(&cup, &making), code, path);
    }
    let nan = Object::new();
    Reflect::set(&nan, &"shrinkage".into(), &f64::NAN.into()).expect("set");
    expect(check(&cup, &nan), "not-finite", "shrinkage");

    expect(write(&cup, &"doc".into(), &JsValue::UNDEFINED), "unknown-name", "format");
    expect(write(&cup, &JsValue::UNDEFINED, &JsValue::UNDEFINED), "wrong-type", "format");
    expect(paint(&cup, &"heat".into(), &JsValue::UNDEFINED), "unknown-name", "map");
    expect(paint(&cup, &"overhang".into(), &js(r#"{ "rows": 0.5 }"#)), "out-of-range", "rows");
    expect(water(&cup, &"full".into()), "wrong-type", "level");
    expect(water(&cup, &f64::NAN.into()), "not-finite", "level");
    expect(water(&cup, &100.into()), "out-of-range", "level");
    expect(measure(&cup, &js(r#"{ "fill": "full" }"#)), "wrong-type", "fill");
    expect(measure(&cup, &js(r#"{ "density": 0 }"#)), "out-of-range", "density");
    expect(measure(&cup, &js(r#"{ "size": 5 }"#)), "unknown-field", "size");
    for source in [JsValue::UNDEFINED, 5.into()] {
        expect(measure(&source, &JsValue::UNDEFINED), "wrong-type", "");
        expect(check(&source, &JsValue::UNDEFINED), "wrong-type", "");
        expect(write(&source, &"stl".into(), &JsValue::UNDEFINED), "wrong-type", "");
        expect(solid(&source, &JsValue::UNDEFINED), "wrong-type", "");
        expect(paint(&source, &"overhang".into(), &JsValue::UNDEFINED), "wrong-type", "");
        expect(water(&source, &1.into()), "wrong-type", "");
    }
}

fn expect<T: std::fmt::Debug>(outcome: Result<T, impl Into<JsValue>>, code: &str, path: &str) {
    let error: JsValue = match outcome {
        Ok(value) => panic!("expected {code} at `{path}`, got {value:?}"),
        Err(error) => error.into(),
    };
    let text = |key: &str| at(&error, key).as_string().unwrap_or_default();
    assert_eq!((text("name").as_str(), text("code").as_str(), text("path").as_str()), ("PasuError", code, path));
    assert!(text("message").len() > 10, "a message for a person, found {:?}", text("message"));
    if code == "unknown-name" {
        let words = at(&error, "args.words");
        assert!(
            Array::is_array(&words) && Array::from(&words).length() > 1,
            "the words that are known, found {words:?}"
        );
        assert!(at(&error, "args.found").is_string(), "the word that is not");
    }
}

/// A value at a path such as `parts.0.name`.
fn at(value: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(value.clone(), |value, key| Reflect::get(&value, &key.into()).expect("a field"))
}

fn js(text: &str) -> JsValue {
    JSON::parse(text).expect("JSON")
}

/// A function of JavaScript that is told how far a call is, as `body` answers.
fn listener(told: &Array, body: &str) -> js_sys::Function {
    js_sys::Function::new_with_args("told", &format!("return (done) => {{ told.push(done); {body} }}"))
        .call1(&JsValue::UNDEFINED, told)
        .expect("a function")
        .unchecked_into()
}

/// As the package does: the call goes out to JavaScript and comes back.
fn told_of_check(body: &str) -> (Array, Result<JsValue, JsValue>) {
    let told = Array::new();
    let call = Closure::<dyn FnMut() -> Result<JsValue, JsValue>>::new(|| {
        check(&CUP.into(), &js(r#"{ "tolerance": 0.002 }"#))
    });
    let answer = watched(&listener(&told, body), call.as_ref().unchecked_ref());
    (told, answer)
}

#[wasm_bindgen_test]
fn what_takes_long_tells_how_far_it_is() {
    let (told, answer) = told_of_check("");
    let alone = check(&CUP.into(), &js(r#"{ "tolerance": 0.002 }"#)).expect("a report");
    assert_eq!(JSON::stringify(&answer.expect("a report")), JSON::stringify(&alone));
    let told: Vec<f64> = told.iter().filter_map(|done| done.as_f64()).collect();
    assert!(told.len() > 2 && told[0] == 0.0 && told[told.len() - 1] == 1.0, "{told:?}");
    assert!(told.windows(2).all(|pair| pair[0] <= pair[1]), "{told:?}");
}

#[wasm_bindgen_test]
fn what_takes_long_can_be_ended() {
    for body in ["return told.length < 2", "if (told.length > 1) throw 5"] {
        let (told, answer) = told_of_check(body);
        let error = answer.expect_err("ended");
        assert_eq!(Reflect::get(&error, &"code".into()).expect("a code"), "cancelled", "{body}");
        assert_eq!(told.length(), 2, "{body}");
    }
    // What the call itself refuses is not changed.
    let refusal = js_sys::Function::new_no_args("throw 7");
    assert_eq!(watched(&listener(&Array::new(), ""), &refusal), Err(7.into()));
}
