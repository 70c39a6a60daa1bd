//! Networks of vertex-frames against the reference corpus and against what holds of every network.

use glam::DVec3;
use pasu::{Code, Design, Error, Format, Making, MeasureOptions, MeshOptions, Product, VaseOrder};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::support::design_of;

#[derive(Deserialize)]
struct Case {
    name: String,
    shape: Value,
    points: Vec<Point>,
}

#[derive(Deserialize)]
struct Point {
    patch: usize,
    u: f64,
    v: f64,
    position: [f64; 3],
}

fn corpus() -> Vec<Case> {
    serde_json::from_str(include_str!("../reference/frames.json")).expect("the corpus is JSON")
}

/// The largest extent of the points of a network.
fn size(shape: &Value) -> f64 {
    let vertices: Vec<[f64; 3]> = serde_json::from_value(shape["vertices"].clone()).unwrap();
    let points = || vertices.iter().map(|at| DVec3::from_array(*at));
    let low = points().fold(DVec3::INFINITY, DVec3::min);
    let high = points().fold(DVec3::NEG_INFINITY, DVec3::max);
    (high - low).max_element()
}

#[test]
fn every_case_of_the_corpus() {
    let cases = corpus();
    assert_eq!(cases.len(), 7);
    for case in cases.iter().filter(|case| case.name != "sculpted") {
        let design = design_of(&case.shape.to_string());
        let at: Vec<f64> = case.points.iter().flat_map(|point| [point.patch as f64, point.u, point.v]).collect();
        let found = pasu::evaluate(&design, 0, &at).unwrap();
        for (point, found) in case.points.iter().zip(found.chunks_exact(3)) {
            let off = DVec3::from_slice(found).distance(DVec3::from_array(point.position));
            assert!(
                off <= 1e-12 * size(&case.shape),
                "{}: {off:e} at {} {} {}",
                case.name,
                point.patch,
                point.u,
                point.v
            );
        }
    }
}

/// A cube of side 2 of six frames, each begun at another corner and in another direction.
fn cube() -> Value {
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut number = |at: [f64; 3]| {
        vertices.iter().position(|known| *known == at).unwrap_or_else(|| {
            vertices.push(at);
            vertices.len() - 1
        })
    };
    let mut patches = Vec::new();
    for face in 0..6 {
        let (axis, end) = (face / 2, if face % 2 == 0 { -1.0 } else { 1.0 });
        let round =
            [[-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]];
        let mut frame: Vec<usize> = round
            .iter()
            .map(|[a, b]| {
                let mut at = [end; 3];
                (at[(axis + 1) % 3], at[(axis + 2) % 3]) = (*a, *b);
                number(at)
            })
            .collect();
        frame.rotate_left(2 * (face % 4));
        if face % 3 == 0 {
            frame.reverse();
            // A corner first again.
            frame.rotate_left(1);
        }
        patches.push(json!({ "frame": frame }));
    }
    json!({ "kind": "vertex-frame", "vertices": vertices, "patches": patches })
}

fn measured(design: &Design) -> pasu::Measures {
    let options = MeasureOptions { product: Product::Solid, ..MeasureOptions::default() };
    pasu::measure(design, &options).unwrap()
}

#[test]
fn a_cube_of_frames_is_a_solid() {
    let design = design_of(&cube().to_string());
    let body = &measured(&design).parts[0].body;
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-10, "{found}, expected {expected}");
    near(body.area.value, 24.0);
    near(body.clay.unwrap().volume.value, 8.0);
    body.centre.empty.unwrap().at.iter().for_each(|x| near(*x, 0.0));
    let making = Making { product: Product::Solid, ..Making::default() };
    let file = String::from_utf8(pasu::write(&design, Format::Step, &making).unwrap()).unwrap();
    let count = |entity: &str| file.matches(&format!("={entity}(")).count();
    assert_eq!((count("MANIFOLD_SOLID_BREP"), count("ADVANCED_FACE")), (1, 6));
    assert_eq!((count("VERTEX_POINT"), count("EDGE_CURVE")), (8, 12));
}

#[test]
fn normals_point_outwards_however_a_frame_is_numbered() {
    for place in [json!({}), json!({ "scale": [1, -2, 1], "axis": [1, 2, 2], "angle": 0.8, "shift": [3, -2, 5] })] {
        let document = json!({ "pasu": 1, "parts": [{ "shape": cube(), "place": place }] });
        let design = Design::parse(&document.to_string()).unwrap();
        let mesh = pasu::mesh(&design, &MeshOptions { tolerance: Some(0.01), ..MeshOptions::default() }).unwrap();
        mesh.validate().unwrap();
        let middle = DVec3::from_array(design.parts()[0].place.shift);
        let at = |array: &[f32], vertex: u32| {
            let from = 3 * vertex as usize;
            DVec3::new(f64::from(array[from]), f64::from(array[from + 1]), f64::from(array[from + 2]))
        };
        for triangle in mesh.indices.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|corner| at(&mesh.positions, triangle[corner]) - middle);
            let normal = (b - a).cross(c - a);
            assert!(normal.dot(a) > 0.0);
            for vertex in triangle {
                assert!(at(&mesh.normals, *vertex).dot(normal.normalize()) > 1.0 - 1e-6, "edges of a cube are creases");
            }
        }
    }
}

#[test]
fn designs_of_networks_are_canonical_and_have_links() {
    for case in corpus() {
        let design = design_of(&case.shape.to_string());
        let again = Design::parse(&design.to_json()).unwrap();
        assert_eq!(design, again);
        assert!(design.link().starts_with("1~"), "{}", case.name);
        assert_eq!(Design::parse(&design.link()).unwrap(), design);
        assert!(!design.to_json().contains("\"a1\":[1,1,1]") && !design.to_json().contains("global"));
    }
}

fn refused(shape: &Value) -> Error {
    match Design::parse(&json!({ "pasu": 1, "parts": [{ "shape": shape }] }).to_string()) {
        Ok(design) => pasu::mesh(&design, &MeshOptions::default()).unwrap_err(),
        Err(error) => error,
    }
}

#[test]
fn what_is_no_network_is_refused_with_patch_and_component() {
    let changed = |change: &dyn Fn(&mut Value)| {
        let mut shape = cube();
        change(&mut shape);
        let error = refused(&shape);
        (error.code(), error.path().to_owned(), error.message().to_owned())
    };
    let (code, path, message) = changed(&|shape| shape["patches"][2]["frame"][3] = json!(20));
    assert_eq!((code, path.as_str()), (Code::OutOfRange, "parts[0].shape.patches[2].frame[3]"), "{message}");
    let (code, path, message) = changed(&|shape| shape["patches"][1]["frame"] = json!([1, 2, 3]));
    assert_eq!((code, path.as_str()), (Code::WrongType, "parts[0].shape.patches[1].frame"), "{message}");
    assert_eq!(message, "expected a list of 8 numbers of vertices, found a list of 3");
    let (code, path, _) = changed(&|shape| shape["patches"][1]["frame"][0] = json!(1.5));
    assert_eq!((code, path.as_str()), (Code::OutOfRange, "parts[0].shape.patches[1].frame[0]"));
    let (code, path, _) = changed(&|shape| shape["rule"] = json!({ "seed": 6 }));
    assert_eq!((code, path.as_str()), (Code::OutOfRange, "parts[0].shape.rule.seed"));
    let (code, path, _) = changed(&|shape| shape["rule"] = json!({ "seed": 1, "walk": 2 }));
    assert_eq!((code, path.as_str()), (Code::UnknownField, "parts[0].shape.rule.walk"));
    let (code, path, _) = changed(&|shape| shape["rule"] = json!("local"));
    assert_eq!((code, path.as_str()), (Code::UnknownName, "parts[0].shape.rule"));
    let (code, path, message) = changed(&|shape| {
        let first = shape["patches"][0].clone();
        shape["patches"].as_array_mut().unwrap().push(first);
    });
    assert_eq!((code, path.as_str()), (Code::CrossesItself, "parts[0].shape.patches[6].frame"), "{message}");
    let (code, path, message) = changed(&|shape| {
        let corner = shape["patches"][3]["frame"][2].as_u64().unwrap() as usize;
        let other = shape["patches"][3]["frame"][6].as_u64().unwrap() as usize;
        shape["vertices"][corner] = shape["vertices"][other].clone();
    });
    assert_eq!(code, Code::PinchedSurface, "{message}");
    assert!(path.starts_with("parts[0].shape.patches["), "{path}");
    for (rule, expected) in [(json!("global"), 0), (json!({ "seed": 4 }), 4)] {
        let (code, path, message) = changed(&|shape| {
            shape["rule"] = rule.clone();
            for patch in shape["patches"].as_array_mut().unwrap() {
                patch["a1"] = json!([1, 0, 1]);
                patch["a2"] = json!([1, 0, 1]);
            }
        });
        assert_eq!((code, path), (Code::OutOfRange, format!("parts[0].shape.patches[{expected}].a1[1]")), "{message}");
    }
    assert_eq!(changed(&|shape| shape["patches"] = json!([])).0, Code::OutOfRange);
    assert_eq!(changed(&|shape| shape["vertices"][0] = json!([1, 2])).0, Code::WrongType);
    assert_eq!(changed(&|shape| shape["continuity"] = json!("G1")).0, Code::UnknownName);
    assert_eq!(changed(&|shape| shape["crease"] = json!(-1)).0, Code::OutOfRange);
    assert_eq!(
        changed(&|shape| shape["patches"][0]["forces"] = json!([{ "f0": [1, 1, 1], "u": [1, 0] }])).0,
        Code::OutOfRange
    );
}

#[test]
fn what_is_only_of_pots_is_refused_in_words() {
    let mut open = cube();
    open["patches"].as_array_mut().unwrap().pop();
    for (shape, is_closed) in [(cube(), true), (open, false)] {
        let document = json!({ "pasu": 1, "parts": [{ "shape": shape, "wall": { "thickness": 0.1, "base": 0.1 } }] });
        let design = Design::parse(&document.to_string()).unwrap();
        let shape = &design.parts()[0].shape;
        assert!(shape.handles().list.is_empty() && shape.boundary_value().is_none());
        let codes = [
            shape.convert(VaseOrder::Fourth).unwrap_err(),
            pasu::free(&design, 0, 0.01).unwrap_err(),
            pasu::pull(&design, 0, &pasu::Hand::new([0.5, 0.5], [1.0, 1.0, 1.0])).unwrap_err(),
            pasu::Surface::of_part(&design.parts()[0], 0).unwrap_err(),
            pasu::water(&design, 0.5).unwrap_err(),
            pasu::Pot::new(&design, 0, Product::Pot).unwrap_err(),
            pasu::paint(&design, pasu::Map::Thickness, &MeshOptions::default()).unwrap_err(),
            pasu::write(&design, Format::Svg, &Making::default()).unwrap_err(),
            pasu::sketch(&design, &pasu::SketchOptions::default()).unwrap_err(),
            pasu::drawn(&design, &Making::default()).unwrap_err(),
        ]
        .map(|error| {
            assert!(!error.message().is_empty() && error.code() != Code::Bug, "{error}");
            error.code()
        });
        assert_eq!(codes[..4], [Code::UnsupportedShape; 4]);
        let report = pasu::check(&design, &Making::default()).unwrap();
        assert!(!report.is_ok() && !report.findings.is_empty());
        // What is not only of pots is there.
        for map in [pasu::Map::MeanCurvature, pasu::Map::GaussianCurvature, pasu::Map::Overhang] {
            let options = MeshOptions { tolerance: Some(0.1), ..MeshOptions::default() };
            let (mesh, values) = (pasu::mesh(&design, &options).unwrap(), pasu::paint(&design, map, &options).unwrap());
            assert_eq!(values.len(), mesh.n_vertices());
        }
        let body = measured(&design).parts.remove(0).body;
        assert_eq!(body.clay.is_some(), is_closed);
        assert!((body.height.value - 2.0).abs() < 1e-12 && body.capacity.is_none());
        assert_eq!(pasu::fingerprint(&design).unwrap().len(), 16);
    }
}

#[test]
fn points_are_told_by_patch_u_and_v() {
    let design = design_of(&cube().to_string());
    let error = |at: &[f64]| {
        let error = pasu::evaluate(&design, 0, at).unwrap_err();
        (error.code(), error.path().to_owned(), error.message().to_owned())
    };
    let refused = |at: &[f64], path: &str, message: &str| {
        assert_eq!(error(at), (Code::NoSuchPoint, path.to_owned(), message.to_owned()));
    };
    refused(&[0.0, 0.5], "at", "expected triples (patch, u, v), found 2 numbers");
    refused(&[6.0, 0.5, 0.5], "at[0]", "expected a patch from 0 to 5, found 6");
    refused(&[0.5, 0.5, 0.5], "at[0]", "expected a patch from 0 to 5, found 0.5");
    refused(&[0.0, 0.5, 0.5, 5.0, 0.5, 1.5], "at[5]", "expected v from 0 to 1, found 1.5");
    refused(&[0.0, f64::NAN, 0.5], "at[1]", "expected u from 0 to 1, found NaN");
    let (at, h) = ([3.0, 0.3, 0.8], 1e-6);
    let slopes = pasu::derivatives(&design, 0, &at).unwrap();
    let place = |u: f64, v: f64| DVec3::from_slice(&pasu::evaluate(&design, 0, &[3.0, u, v]).unwrap());
    let du = (place(0.3 + h, 0.8) - place(0.3 - h, 0.8)) / (2.0 * h);
    let dv = (place(0.3, 0.8 + h) - place(0.3, 0.8 - h)) / (2.0 * h);
    assert!(du.distance(DVec3::from_slice(&slopes.du)) < 1e-8 && dv.distance(DVec3::from_slice(&slopes.dv)) < 1e-8);
}
