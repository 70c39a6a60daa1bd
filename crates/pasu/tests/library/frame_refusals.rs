//! Networks of vertex-frames that cannot be, and what cannot be asked of one.

use pasu::{Code, Design, Error, Format, Making, MeshOptions, Product, VaseOrder};
use serde_json::{Value, json};

use crate::support::design_of;
use crate::support::networks::{cube, edges, measured};

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
    for (rule, expected) in [(json!("global"), "patches[0].a1[1]"), (json!({ "seed": 4 }), "patches[4].a2[1]")] {
        let (code, path, message) = changed(&|shape| {
            shape["rule"] = rule.clone();
            for patch in shape["patches"].as_array_mut().unwrap() {
                patch["a1"] = json!([1, 0, 1]);
                patch["a2"] = json!([1, 0, 1]);
            }
        });
        assert_eq!((code, path), (Code::OutOfRange, format!("parts[0].shape.{expected}")), "{message}");
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
fn forces_that_cannot_be_are_refused_with_their_place() {
    let refuse = |force: Value, a2: Value| {
        let mut shape = cube();
        shape["patches"][3]["forces"] = json!([{ "f0": [0, 0, 0] }, force]);
        shape["patches"][3]["a2"] = a2;
        let error = refused(&shape);
        (error.code(), error.path().to_owned(), error.message().to_owned())
    };
    let ones = || json!([1, 1, 1]);
    // A corner of a cube has three faces.
    let (code, path, message) = refuse(json!({ "f0": [1, 1, 1], "u": [0.5, 1.5], "v": [0.5, 1.5] }), ones());
    assert_eq!((code, path.as_str()), (Code::CrossesItself, "parts[0].shape.patches[3].forces[1]"), "{message}");
    let (code, path, _) = refuse(json!({ "f0": [1, 1, 1], "u": [1.5, 2.5] }), ones());
    assert_eq!((code, path.as_str()), (Code::OutOfRange, "parts[0].shape.patches[3].forces[1].u"));
    let (code, path, _) = refuse(json!({ "f0": [1, 1, 1], "v": [0.5, 0.5001] }), ones());
    assert_eq!((code, path.as_str()), (Code::OutOfRange, "parts[0].shape.patches[3].forces[1].v[1]"));
    let (code, path, message) = refuse(json!({ "f0": [0, 0, 1] }), json!([-1, -1, -1]));
    assert_eq!((code, path.as_str()), (Code::OutOfRange, "parts[0].shape.patches[3].a2[2]"), "{message}");
    assert!(message.contains("on z"), "{message}");
    let (code, ..) = refuse(json!({ "f0": [1, 1, 1], "u": [-1e9, 1e9] }), ones());
    assert!([Code::TooLarge, Code::CrossesItself].contains(&code));
    // Round a belt of four faces, and over itself, it goes on.
    let mut shape = cube();
    shape["patches"][3]["forces"] = json!([{ "f0": [1, 0, 0], "u": [0, 6], "falloff": "smooth" }]);
    let mesh = pasu::mesh(&design_of(&shape.to_string()), &MeshOptions::default()).unwrap();
    assert!(edges(&mesh).iter().all(|times| *times == 2));
}
