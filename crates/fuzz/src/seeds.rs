//! What inputs are made of: designs that people draw, those that once took too long, and what is written of them.

use miniz_oxide::deflate::compress_to_vec_zlib;
use pasu::{Design, Format, Making, Product, open, write};
use serde_json::{Value, json};

use crate::calls::CALLS;

const BLENDS: &str = include_str!("../../../tests/reference/blends.json");
const FRAMES: &str = include_str!("../../../tests/reference/frames.json");
const GALLERY: &str = include_str!("../../../tests/reference/gallery.json");
const HOSTILE: &str = include_str!("../../../tests/reference/hostile.json");
const RINGS: &str = include_str!("../../../tests/reference/rings.json");
const SURFACES: &str = include_str!("../../../tests/reference/surfaces.json");

/// The beginning of a file, which has the link, but in 3MF.
const BEGINNING: usize = 4096;

fn read(text: &str) -> Vec<Value> {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}"))
}

/// Designs as JSON: the gallery, every other one a pot, the shapes of the corpora, several parts, and the hostile ones.
fn designs() -> Vec<String> {
    let walls = [
        json!({ "thickness": 0.3, "base": 0.4 }),
        json!({ "thickness": 0.2, "base": 0.3, "side": "outside", "rim": "rounded" }),
        json!({ "thickness": 0.3, "base": 0.5, "foot": [0.4, 0.3], "drain": 0.8 }),
        json!({ "thickness": 0.1, "base": 0 }),
        json!({ "thickness": 0.2, "base": 0.3, "lining": { "waves": 2 } }),
    ];
    let place = json!({ "scale": [1, 2, -1], "axis": [1, 1, 0], "angle": 0.3, "shift": [4, 0, -2] });
    let mut designs = Vec::new();
    for (i, exhibit) in read(GALLERY).iter().enumerate() {
        let mut part = json!({ "shape": exhibit["shape"] });
        if i % 2 == 0 {
            part["wall"] = walls[i / 2 % walls.len()].clone();
        }
        if i % 3 == 0 {
            part["place"] = place.clone();
        }
        designs.push(json!({ "pasu": 1, "parts": [part] }));
    }
    for case in read(SURFACES).into_iter().chain(read(RINGS)).chain(read(FRAMES)).chain(read(BLENDS)) {
        let shape = if case["family"].is_null() { &case["shape"] } else { &case["family"] };
        designs.push(json!({ "pasu": 1, "unit": "mm", "parts": [{ "shape": shape }] }));
    }
    designs.push(json!({ "pasu": 1, "parts": [{ "shape": closed_network(), "place": place }] }));
    for exponents in [[2.0, 2.0, 2.0], [0.05, 1.0, 50.0]] {
        let shape = json!({ "kind": "octant", "exponents": exponents });
        designs.push(json!({ "pasu": 1, "parts": [{ "shape": shape, "place": place }] }));
    }
    let joints = json!({ "z": { "label": "Lift", "limits": [-1, 2], "glued": true }, "turn": { "limits": [-1, 1], "axis": [1, 1, 0] } });
    let (one, other) = (designs[0]["parts"][0].clone(), designs[3]["parts"][0].clone());
    designs.push(json!({ "pasu": 1, "title": "Two", "unit": "in", "parts": [
        { "name": "a", "shape": one["shape"], "look": { "glaze": "celadon", "clay": "black" }, "joints": joints },
        { "name": "b", "shape": other["shape"], "object": 1, "place": place, "wall": walls[0] },
    ] }));
    let hostile = read(HOSTILE).into_iter().map(|case| case["input"].clone()).filter(|input| !input.is_string());
    designs.into_iter().chain(hostile).map(|design| design.to_string()).collect()
}

/// A box of six frames, one of them pushed in over its edges.
fn closed_network() -> Value {
    let mut vertices: Vec<[i32; 3]> = Vec::new();
    let mut patches = Vec::new();
    for face in 0..6 {
        let round = [[-1, -1], [0, -1], [1, -1], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]];
        let frame = round.map(|[a, b]| {
            let mut at = [if face % 2 == 0 { -1 } else { 1 }; 3];
            (at[(face / 2 + 1) % 3], at[(face / 2 + 2) % 3]) = (a, b);
            vertices.iter().position(|known| *known == at).unwrap_or_else(|| {
                vertices.push(at);
                vertices.len() - 1
            })
        });
        patches.push(json!({ "frame": frame, "a1": [1, 2, 3] }));
    }
    patches[5]["forces"] = json!([{ "f0": [0, 0, 3], "u": [0.25, 0.75], "v": [-0.5, 1.25], "falloff": "smooth" }]);
    json!({ "kind": "vertex-frame", "vertices": vertices, "patches": patches, "rule": { "seed": 2 }, "crease": 0.25 })
}

/// The designs, and their links.
pub(crate) fn documents() -> Vec<Vec<u8>> {
    let mut seeds: Vec<Vec<u8>> = designs().into_iter().map(String::into_bytes).collect();
    seeds.extend(links());
    seeds
}

/// Links, and what is packed in them, as text and as the stream that it becomes.
pub(crate) fn links_and_contents() -> Vec<Vec<u8>> {
    let mut seeds = documents();
    seeds.extend(designs().iter().step_by(8).map(|design| compress_to_vec_zlib(design.as_bytes(), 1)));
    seeds
}

/// The links of the designs, of the hostile ones among them those that came as links.
fn links() -> Vec<Vec<u8>> {
    let known = designs().into_iter().filter_map(|design| Some(format!("#{}", Design::parse(&design).ok()?.link())));
    let hostile = read(HOSTILE).into_iter().filter_map(|case| case["input"].as_str().map(str::to_owned));
    known.chain(hostile).map(String::into_bytes).collect()
}

/// Files of every format: of a pot, and of a solid whose link is short enough for STL.
pub(crate) fn files() -> Vec<Vec<u8>> {
    let cup = r#"{ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 }"#;
    let pot = format!(
        r#"{{ "pasu": 1, "title": "é & <b>", "parts": [{{ "shape": {cup}, "wall": {{ "thickness": 0.5, "base": 1 }} }}] }}"#
    );
    let mut seeds = Vec::new();
    for (design, product) in [(pot.as_str(), Product::Pot), ("#1/second-order?r=3,0,3,0&t=0,0", Product::Solid)] {
        let design = Design::parse(design).unwrap_or_else(|error| panic!("{error}"));
        for format in Format::ALL {
            let making = Making { product, tolerance: Some(0.5), ..Making::default() };
            let mut bytes = write(&design, format, &making).unwrap_or_else(|error| panic!("{error}"));
            if format != Format::ThreeMf {
                bytes.truncate(BEGINNING);
            }
            if open(&bytes).is_some() {
                seeds.push(bytes);
            }
        }
    }
    assert_eq!(seeds.len(), 2 * Format::ALL.len() - 1, "a file of every format but STL has its link");
    seeds
}

/// Every design with one call, in turn.
pub(crate) fn calls() -> Vec<Vec<u8>> {
    let designs = designs();
    let turns = designs.iter().zip((0..).step_by(5));
    turns.map(|(design, i)| format!("{}\n{design}", CALLS[i % CALLS.len()].0).into_bytes()).collect()
}
