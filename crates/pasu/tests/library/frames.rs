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

/// The case whose values are those of least squares on 9 x 7 points of each patch, along its own `u` and `v`. There the cubic terms of `v` count for 16/15 of those of `u`, so that they depend on how frames are numbered.
const UNEVEN: &str = "2 x 4, global, every direction";

#[test]
fn every_case_of_the_corpus() {
    let cases = corpus();
    assert_eq!(cases.len(), 7);
    for case in &cases {
        let design = design_of(&case.shape.to_string());
        let at: Vec<f64> = case.points.iter().flat_map(|point| [point.patch as f64, point.u, point.v]).collect();
        let found = pasu::evaluate(&design, 0, &at).unwrap();
        let [even, uneven] = [1.0, 16.0 / 15.0].map(|of_v| ByHand::new(&case.shape, of_v));
        for (point, found) in case.points.iter().zip(found.chunks_exact(3)) {
            let (found, expected) = (DVec3::from_slice(found), DVec3::from_array(point.position));
            let least = 1e-12 * size(&case.shape);
            let mut off = found.distance(expected);
            if case.name == UNEVEN {
                assert!(uneven.position(point).distance(expected) <= least, "{} {}", point.u, point.v);
                off = found.distance(even.position(point));
            }
            assert!(off <= least, "{}: {off:e} at {} {} {}", case.name, point.patch, point.u, point.v);
        }
    }
}

/// A network solved once more, as math.md has it, by the global rule: strips by walking from edge to edge, patches as Coons patches between curves.
struct ByHand {
    points: Vec<[DVec3; 8]>,
    cubic: Vec<[DVec3; 2]>,
}

impl ByHand {
    /// `of_v` is how much the residual of a cubic term of `v` counts, as against one of `u`.
    fn new(shape: &Value, of_v: f64) -> ByHand {
        const SIDES: [[usize; 3]; 4] = [[0, 7, 6], [2, 3, 4], [0, 1, 2], [6, 5, 4]];
        let vertices: Vec<[f64; 3]> = serde_json::from_value(shape["vertices"].clone()).unwrap();
        let patches = shape["patches"].as_array().unwrap();
        let frames: Vec<[usize; 8]> =
            patches.iter().map(|patch| serde_json::from_value(patch["frame"].clone()).unwrap()).collect();
        let three =
            |patch: usize, name: &str| DVec3::from_array(serde_json::from_value(patches[patch][name].clone()).unwrap());
        let points: Vec<[DVec3; 8]> =
            frames.iter().map(|frame| frame.map(|vertex| DVec3::from_array(vertices[vertex]))).collect();
        let mut cubic = vec![[DVec3::ZERO; 2]; frames.len()];
        let mut is_done = vec![[false; 2]; frames.len()];
        for start in (0..2 * frames.len()).map(|k| (k / 2, k % 2)) {
            if is_done[start.0][start.1] {
                continue;
            }
            is_done[start.0][start.1] = true;
            let mut strip = vec![(start, 1.0)];
            let mut next = 0;
            while let Some(&((patch, direction), sign)) = strip.get(next) {
                next += 1;
                for side in [2 - 2 * direction, 3 - 2 * direction] {
                    let edge = SIDES[side].map(|place| frames[patch][place]);
                    for (other, others) in
                        (0..4 * frames.len()).map(|k| (k / 4, k % 4)).filter(|there| *there != (patch, side))
                    {
                        let [a, b, c] = SIDES[others].map(|place| frames[other][place]);
                        let turn = if [a, b, c] == edge { 1.0 } else { -1.0 };
                        let there = usize::from(others < 2);
                        if ([a, b, c] == edge || [c, b, a] == edge) && !is_done[other][there] {
                            is_done[other][there] = true;
                            strip.push(((other, there), turn * sign));
                        }
                    }
                }
            }
            let (mut above, mut below) = (DVec3::ZERO, DVec3::ZERO);
            for ((patch, direction), sign) in &strip {
                let p = &points[*patch];
                let bend = |i: usize, j: usize, k: usize| p[i] - 2.0 * p[j] + p[k];
                let (a, b, g, weight) = match direction {
                    0 => (three(*patch, "a1"), three(*patch, "a2"), bend(2, 3, 4) - bend(0, 7, 6), 1.0),
                    _ => (three(*patch, "a2"), three(*patch, "a1"), bend(6, 5, 4) - bend(0, 1, 2), of_v),
                };
                above += *sign * weight * a * b * (2.0 * g) / 3.0;
                below += weight * a * a;
            }
            for ((patch, direction), sign) in strip {
                cubic[patch][direction] = -sign * above / below;
            }
        }
        ByHand { points, cubic }
    }

    fn position(&self, Point { patch, u, v, .. }: &Point) -> DVec3 {
        let (p, [c3, c6], u, v) = (&self.points[*patch], self.cubic[*patch], *u, *v);
        let curve = |i: usize, j: usize, k: usize, c: DVec3, t: f64| {
            let s = 1.0 - t;
            p[i] * (s * (s - t)) + p[j] * (4.0 * s * t) + p[k] * (t * (t - s)) + c * (t * (t - 0.5) * (t - 1.0))
        };
        let across = (1.0 - v) * curve(0, 1, 2, c3, u) + v * curve(6, 5, 4, c3, u);
        let along = (1.0 - u) * curve(0, 7, 6, c6, v) + u * curve(2, 3, 4, c6, v);
        across + along - (1.0 - v) * ((1.0 - u) * p[0] + u * p[2]) - v * ((1.0 - u) * p[6] + u * p[4])
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

/// A network on a grid of `m x n` patches, joined to itself or not along either direction, as it stands or reversed.
struct Net {
    vertices: Vec<[f64; 3]>,
    patches: Vec<Value>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Wrap {
    Free,
    Joined,
    Reversed,
}

/// Numbers that look random.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// From -1 to 1.
    fn number(&mut self) -> f64 {
        // Six digits, which every form of a document holds.
        (self.below(2_000_001) as f64 - 1e6) / 1e6
    }

    fn three(&mut self, of: impl Fn(f64) -> f64) -> [f64; 3] {
        [(); 3].map(|()| of(self.number()))
    }

    fn shuffled(&mut self, n: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            order.swap(i, self.below(i + 1));
        }
        order
    }
}

impl Net {
    fn grid(m: usize, n: usize, along: Wrap, round: Wrap, dice: &mut Dice, has_forces: bool) -> Net {
        // The first of all places of the lattice that are one point.
        let first = |i: usize, j: usize| {
            let mut orbit = vec![(i, j)];
            let mut next = 0;
            while let Some(&(i, j)) = orbit.get(next) {
                next += 1;
                let mirror = |wrap: Wrap, x: usize, most: usize| if wrap == Wrap::Reversed { most - x } else { x };
                let mut same = Vec::new();
                if along != Wrap::Free && (i == 0 || i == 2 * m) {
                    same.push((2 * m - i, mirror(along, j, 2 * n)));
                }
                if round != Wrap::Free && (j == 0 || j == 2 * n) {
                    same.push((mirror(round, i, 2 * m), 2 * n - j));
                }
                for place in same {
                    if !orbit.contains(&place) {
                        orbit.push(place);
                    }
                }
            }
            orbit.into_iter().min().unwrap()
        };
        let mut number = std::collections::HashMap::new();
        let mut vertices = Vec::new();
        let mut patches = Vec::new();
        for i in 0..m {
            for j in 0..n {
                let places = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
                let frame = places.map(|(a, b)| {
                    let (x, y) = (2 * i + a, 2 * j + b);
                    *number.entry(first(x, y)).or_insert_with(|| {
                        let jitter = dice.three(|x| 0.2 * x);
                        let at = [x as f64, y as f64, (x * y % 5) as f64 * 0.3];
                        vertices.push([0, 1, 2].map(|k: usize| at[k] + jitter[k]));
                        vertices.len() - 1
                    })
                });
                let (a1, a2) = (dice.three(|x| 2.0 + x), dice.three(|x| 2.0 + x));
                let mut patch = json!({ "frame": frame, "a1": a1, "a2": a2 });
                if has_forces {
                    let side = |dice: &mut Dice| {
                        [0.25 + 0.2 * dice.number(), 0.75 + 0.2 * dice.number()].map(|x| (x * 1e6).round() / 1e6)
                    };
                    let (u, v) = (side(dice), side(dice));
                    let falloff = ["sine", "smooth"][dice.below(2)];
                    patch["forces"] = json!([{ "f0": dice.three(|x| 9.0 * x), "u": u, "v": v, "falloff": falloff }]);
                }
                patches.push(patch);
            }
        }
        Net { vertices, patches }
    }

    fn shape(&self, rule: &Value) -> Value {
        json!({ "kind": "vertex-frame", "vertices": self.vertices, "patches": self.patches, "rule": rule })
    }
}

/// A frame begun one corner later: its new `u` is the old `v`, and its new `v` runs against the old `u`.
fn turned(patch: &Value) -> Value {
    let mut patch = patch.clone();
    let frame = patch["frame"].as_array_mut().unwrap();
    frame.rotate_left(2);
    swapped(&mut patch);
    for force in forces(&mut patch) {
        let side: [f64; 2] = serde_json::from_value(force["v"].clone()).unwrap();
        force["v"] = json!([1.0 - side[1], 1.0 - side[0]]);
    }
    patch
}

/// A frame run through the other way round: `u` and `v` change places.
fn mirrored(patch: &Value) -> Value {
    let mut patch = patch.clone();
    let frame = patch["frame"].as_array_mut().unwrap();
    frame.reverse();
    frame.rotate_right(1);
    swapped(&mut patch);
    patch
}

/// The forces of a patch, if it has any: indexing would make them.
fn forces(patch: &mut Value) -> impl Iterator<Item = &mut Value> {
    patch.get_mut("forces").and_then(Value::as_array_mut).into_iter().flatten()
}

fn swapped(patch: &mut Value) {
    let (a1, a2) = (patch["a1"].clone(), patch["a2"].clone());
    (patch["a1"], patch["a2"]) = (a2, a1);
    for force in forces(patch) {
        let (u, v) = (force["u"].clone(), force["v"].clone());
        (force["u"], force["v"]) = (v, u);
    }
}

#[test]
fn the_surface_does_not_depend_on_how_frames_are_numbered_and_patches_ordered() {
    let wraps = [Wrap::Free, Wrap::Joined, Wrap::Reversed];
    for seed in 0..60 {
        let mut dice = Dice(seed);
        let (m, n) = (3 + dice.below(3), 3 + dice.below(3));
        let (along, round) = (wraps[dice.below(3)], wraps[dice.below(3)]);
        let net = Net::grid(m, n, along, round, &mut dice, seed % 2 == 0);
        // Every frame begun anywhere, every patch anywhere, every vertex by another number.
        let order = dice.shuffled(net.patches.len());
        let numbers = dice.shuffled(net.vertices.len());
        let mut other = Net { vertices: net.vertices.clone(), patches: Vec::new() };
        for (vertex, number) in numbers.iter().enumerate() {
            other.vertices[*number] = net.vertices[vertex];
        }
        let mut ways = Vec::new();
        for patch in &order {
            let (turns, is_mirrored) = (dice.below(4), dice.below(2) == 1);
            let mut renumbered = net.patches[*patch].clone();
            for vertex in renumbered["frame"].as_array_mut().unwrap() {
                *vertex = json!(numbers[vertex.as_u64().unwrap() as usize]);
            }
            for _ in 0..turns {
                renumbered = turned(&renumbered);
            }
            if is_mirrored {
                renumbered = mirrored(&renumbered);
            }
            other.patches.push(renumbered);
            ways.push((turns, is_mirrored));
        }
        let designs =
            [net.shape(&json!("global")), other.shape(&json!("global"))].map(|shape| design_of(&shape.to_string()));
        let size = size(&net.shape(&json!("global")));
        for (index, patch) in order.iter().enumerate() {
            let (turns, is_mirrored) = ways[index];
            for _ in 0..6 {
                let (u, v) = (0.5 + 0.5 * dice.number(), 0.5 + 0.5 * dice.number());
                let (mut x, mut y) = (u, v);
                for _ in 0..turns {
                    (x, y) = (y, 1.0 - x);
                }
                if is_mirrored {
                    (x, y) = (y, x);
                }
                let one = pasu::evaluate(&designs[0], 0, &[*patch as f64, u, v]).unwrap();
                let same = pasu::evaluate(&designs[1], 0, &[index as f64, x, y]).unwrap();
                let off = DVec3::from_slice(&one).distance(DVec3::from_slice(&same));
                assert!(off <= 1e-12 * size, "{seed} {along:?} {round:?}: {off:e}");
            }
        }
    }
}

/// How often each edge of a mesh is passed, edges told by the bits of their ends.
fn edges(mesh: &pasu::Mesh) -> Vec<usize> {
    let at = |vertex: u32| {
        let from = 3 * vertex as usize;
        [0, 1, 2].map(|axis| (mesh.positions[from + axis] + 0.0).to_bits())
    };
    let mut count = std::collections::HashMap::new();
    for triangle in mesh.indices.chunks_exact(3) {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let (a, b) = (at(triangle[a]), at(triangle[b]));
            assert_ne!(a, b, "a triangle without width");
            *count.entry((a.min(b), a.max(b))).or_insert(0) += 1;
        }
    }
    count.into_values().collect()
}

#[test]
fn what_is_joined_has_the_same_bits_and_tolerances_are_held() {
    let wraps = [Wrap::Free, Wrap::Joined, Wrap::Reversed];
    for seed in 100..130 {
        let mut dice = Dice(seed);
        let (along, round) = (wraps[dice.below(3)], wraps[dice.below(3)]);
        let net = Net::grid(3, 4, along, round, &mut dice, seed % 2 == 0);
        let rule = [json!("global"), json!({ "seed": dice.below(12) })][dice.below(2)].clone();
        let design = design_of(&net.shape(&rule).to_string());
        for options in [
            MeshOptions { tolerance: Some(0.05), ..MeshOptions::default() },
            MeshOptions { tolerance: Some(0.004), ..MeshOptions::default() },
            MeshOptions { rows: Some(4), columns: Some(7), ..MeshOptions::default() },
            MeshOptions { rows: Some(5), ..MeshOptions::default() },
        ] {
            let mesh = pasu::mesh(&design, &options).unwrap();
            mesh.validate().unwrap();
            let edges = edges(&mesh);
            // A projective plane on a grid has two points at which two patches alone meet: cells that have both corners there may be cut off by one edge.
            let is_folded = [along, round] == [Wrap::Reversed; 2];
            assert!(edges.iter().all(|times| *times <= 2 || is_folded && *times == 4), "{seed} {along:?} {round:?}");
            if along != Wrap::Free && round != Wrap::Free {
                let is_watertight = edges.iter().all(|times| times % 2 == 0);
                assert!(is_watertight, "{seed} {along:?} {round:?} is not watertight");
            }
            let bound = mesh.bound.unwrap_or_else(|| pasu::bound(&design, &options).unwrap());
            let found = farthest(&design, &mesh);
            assert!(
                found <= bound && options.tolerance.is_none_or(|asked| bound <= asked),
                "{seed} {options:?}: {found} of {bound}"
            );
        }
    }
}

/// The largest distance between points of triangles and those of the surface with the same parameters.
fn farthest(design: &Design, mesh: &pasu::Mesh) -> f64 {
    // Each patch begins with its corner (0, 0), which no other vertex of it has.
    let corners: Vec<usize> = (0..mesh.n_vertices()).filter(|i| mesh.uvs[2 * i..2 * i + 2] == [0.0, 0.0]).collect();
    let (mut at, mut points) = (Vec::new(), Vec::new());
    for triangle in mesh.indices.chunks_exact(3) {
        let patch = corners.partition_point(|corner| *corner <= triangle[0] as usize) - 1;
        for weights in [[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.3, 0.3, 0.4], [0.1, 0.2, 0.7]] {
            let mean = |array: &[f32], n: usize, k: usize| {
                triangle
                    .iter()
                    .zip(weights)
                    .map(|(vertex, weight)| f64::from(array[n * *vertex as usize + k]) * weight)
                    .sum::<f64>()
            };
            at.extend([patch as f64, mean(&mesh.uvs, 2, 0).min(1.0), mean(&mesh.uvs, 2, 1).min(1.0)]);
            points.push(DVec3::from_array([0, 1, 2].map(|k| mean(&mesh.positions, 3, k))));
        }
    }
    let exact = pasu::evaluate(design, 0, &at).unwrap();
    points
        .iter()
        .zip(exact.chunks_exact(3))
        .map(|(point, exact)| point.distance(DVec3::from_slice(exact)))
        .fold(0.0, f64::max)
}

#[test]
fn a_force_goes_on_over_joined_patches() {
    for seed in 200..220 {
        let mut dice = Dice(seed);
        let net = Net::grid(3, 3, Wrap::Free, Wrap::Free, &mut dice, false);
        let falloff = ["sine", "smooth"][dice.below(2)];
        let f0 = dice.three(|x| 5.0 * x);
        // Over all nine patches, from the one in the middle.
        let (from, to) = ([-0.5, -0.75], [1.25, 1.875]);
        let force = json!({ "f0": f0, "u": [from[0], to[0]], "v": [from[1], to[1]], "falloff": falloff });
        let mut sculpted = Net { vertices: net.vertices.clone(), patches: net.patches.clone() };
        sculpted.patches[4]["forces"] = json!([force]);
        // The others lie in any way.
        let mut ways = [0; 9];
        for patch in (0..9).filter(|patch| *patch != 4) {
            ways[patch] = dice.below(4);
            for _ in 0..ways[patch] {
                sculpted.patches[patch] = turned(&sculpted.patches[patch]);
            }
        }
        let [plain, design] = [&net, &sculpted].map(|net| design_of(&net.shape(&json!("global")).to_string()));
        let a = |name: &str| -> [f64; 3] { serde_json::from_value(net.patches[4][name].clone()).unwrap() };
        let (a1, a2) = (a("a1"), a("a2"));
        for _ in 0..60 {
            let (i, j) = (dice.below(3), dice.below(3));
            let (u, v) = (0.5 + 0.5 * dice.number(), 0.5 + 0.5 * dice.number());
            let wave = |at: f64, k: usize| {
                let p = (at - from[k]) / (to[k] - from[k]);
                let sine = if (0.0..=1.0).contains(&p) { (std::f64::consts::PI * p).sin() } else { 0.0 };
                if falloff == "sine" { sine } else { sine * sine }
            };
            let height = wave(u + i as f64 - 1.0, 0) * wave(v + j as f64 - 1.0, 1) / std::f64::consts::PI.powi(2);
            let expected = DVec3::from_array([0, 1, 2].map(|k| -f0[k] / (a1[k] + a2[k]) * height));
            let patch = 3 * i + j;
            let (mut x, mut y) = (u, v);
            for _ in 0..ways[patch] {
                (x, y) = (y, 1.0 - x);
            }
            let flat = DVec3::from_slice(&pasu::evaluate(&plain, 0, &[patch as f64, u, v]).unwrap());
            let found = DVec3::from_slice(&pasu::evaluate(&design, 0, &[patch as f64, x, y]).unwrap());
            assert!((found - flat).distance(expected) < 1e-12, "{seed} {patch}");
        }
        let mesh = pasu::mesh(&design, &MeshOptions { tolerance: Some(0.01), ..MeshOptions::default() }).unwrap();
        assert!(edges(&mesh).iter().all(|times| *times <= 2) && farthest(&design, &mesh) <= 0.01);
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

/// A torus of `m x n` patches through points of a true one.
fn torus(m: usize, n: usize) -> Value {
    let tau = std::f64::consts::TAU;
    let mut net = Net::grid(m, n, Wrap::Joined, Wrap::Joined, &mut Dice(7), false);
    let mut places = vec![None; net.vertices.len()];
    for (index, patch) in net.patches.iter_mut().enumerate() {
        let (i, j) = (index / n, index % n);
        let around = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        let frame: Vec<usize> = serde_json::from_value(patch["frame"].clone()).unwrap();
        for ((a, b), vertex) in around.into_iter().zip(frame) {
            places[vertex] = Some((2 * i + a, 2 * j + b));
        }
        *patch = json!({ "frame": patch["frame"] });
    }
    for (at, place) in net.vertices.iter_mut().zip(places) {
        let (i, j) = place.unwrap();
        let (p, q) = (tau * i as f64 / (2 * m) as f64, tau * j as f64 / (2 * n) as f64);
        let r = 3.0 + q.cos();
        *at = [r * p.cos(), r * p.sin(), q.sin()];
    }
    net.shape(&json!("global"))
}

/// Volume and centre by the divergence theorem, with Gauss's rule of five nodes on 16 cells of each patch: exact of polynomials of this degree.
fn enclosed(design: &Design, n_patches: usize) -> (f64, DVec3) {
    let (a, b) = ((5.0 - 2.0 * (10.0f64 / 7.0).sqrt()).sqrt() / 3.0, (5.0 + 2.0 * (10.0f64 / 7.0).sqrt()).sqrt() / 3.0);
    let (p, q) = ((322.0 + 13.0 * 70f64.sqrt()) / 900.0, (322.0 - 13.0 * 70f64.sqrt()) / 900.0);
    let rule = [(0.0, 128.0 / 225.0), (a, p), (-a, p), (b, q), (-b, q)];
    let nodes: Vec<(f64, f64)> =
        (0..4).flat_map(|cell| rule.map(|(x, w)| ((f64::from(cell) + 0.5 + 0.5 * x) / 4.0, 0.125 * w))).collect();
    let (mut volume, mut moment) = (0.0, DVec3::ZERO);
    for patch in 0..n_patches {
        let at: Vec<f64> =
            nodes.iter().flat_map(|(u, _)| nodes.iter().flat_map(move |(v, _)| [patch as f64, *u, *v])).collect();
        let weights = nodes.iter().flat_map(|(_, one)| nodes.iter().map(move |(_, other)| one * other));
        let points = pasu::evaluate(design, 0, &at).unwrap();
        let slopes = pasu::derivatives(design, 0, &at).unwrap();
        let all = points.chunks_exact(3).zip(slopes.du.chunks_exact(3).zip(slopes.dv.chunks_exact(3))).zip(weights);
        for ((point, (du, dv)), weight) in all {
            let (point, area) = (DVec3::from_slice(point), DVec3::from_slice(du).cross(DVec3::from_slice(dv)));
            volume += weight * point.dot(area) / 3.0;
            moment += weight * 0.5 * point * point * area;
        }
    }
    (volume, moment / volume)
}

#[test]
fn closed_networks_are_solids() {
    let mut shape = torus(5, 4);
    shape["patches"][7]["forces"] =
        json!([{ "f0": [3, 2, -20], "u": [0.25, 0.75], "v": [0.25, 1.5], "falloff": "smooth" }]);
    let mut creased = torus(4, 4);
    creased["patches"][2]["forces"] = json!([{ "f0": [1, 2, 9], "u": [0.3, 0.8], "v": [0.2, 0.7] }]);
    creased["patches"][9]["forces"] = json!([{ "f0": [3, 0, 1] }]);
    for (shape, is_polynomial) in [(torus(5, 4), true), (torus(3, 3), true), (shape, false), (creased, false)] {
        let n = shape["patches"].as_array().unwrap().len();
        let design = design_of(&shape.to_string());
        let body = measured(&design).parts.remove(0).body;
        let clay = body.clay.unwrap();
        if is_polynomial {
            let (volume, centre) = enclosed(&design, n);
            assert!((clay.volume.value - volume.abs()).abs() <= 1e-10 * volume.abs(), "{} {volume}", clay.volume.value);
            assert!(DVec3::from_array(body.centre.empty.unwrap().at).distance(centre) < 1e-10);
        }
        let report = pasu::check(&design, &Making::default()).unwrap();
        assert!(report.is_ok() && report.meshes[0].genus == Some(1), "{report:?}");
        let solid = pasu::solid(&design, &Making::default()).unwrap().remove(0);
        let at = |vertex: u32| {
            DVec3::from_array([0, 1, 2].map(|k| f64::from(solid.positions[3 * vertex as usize + k]) / 10.0))
        };
        let volume: f64 = solid.indices.chunks_exact(3).map(|t| at(t[0]).dot(at(t[1]).cross(at(t[2]))) / 6.0).sum();
        assert!(
            (volume - clay.volume.value).abs() <= solid.bound * body.area.value * 1.01,
            "{volume} {}",
            clay.volume.value
        );
        for format in [Format::Stl, Format::ThreeMf, Format::Glb, Format::Obj, Format::ObjZip, Format::Ply] {
            let bytes = pasu::write(&design, format, &Making::default()).unwrap();
            if format != Format::Stl {
                assert_eq!(pasu::open(&bytes).unwrap(), design.link(), "{format:?}");
            }
        }
        let file = String::from_utf8(pasu::write(&design, Format::Step, &Making::default()).unwrap()).unwrap();
        let count = |entity: &str| file.matches(&format!("={entity}(")).count();
        assert_eq!(
            (count("MANIFOLD_SOLID_BREP"), count("ADVANCED_FACE"), count("EDGE_CURVE"), count("VERTEX_POINT")),
            (1, n, 2 * n, n)
        );
        let deviation = file.split("pasu-deviation: ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
        let deviation: f64 = deviation.trim_end_matches('.').parse().unwrap();
        assert!(deviation <= if is_polynomial { 1e-6 } else { 1e-3 }, "{deviation}");
    }
}

#[test]
fn what_has_one_side_or_free_edges_is_no_solid() {
    for (along, round, what) in [
        (Wrap::Joined, Wrap::Free, "free-edge"),
        (Wrap::Reversed, Wrap::Free, "free-edge"),
        (Wrap::Reversed, Wrap::Joined, "one-sided"),
    ] {
        let net = Net::grid(4, 3, along, round, &mut Dice(3), false);
        let design = design_of(&net.shape(&json!("global")).to_string());
        let error = pasu::solid(&design, &Making::default()).unwrap_err();
        assert_eq!(error.code(), Code::OpenSurface);
        assert_eq!(error.arg("what"), Some(&pasu::Arg::Text(what.to_owned())), "{error}");
        assert!(measured(&design).parts[0].body.clay.is_none());
        let making = Making { product: Product::Solid, ..Making::default() };
        let file = String::from_utf8(pasu::write(&design, Format::Step, &making).unwrap()).unwrap();
        assert!(file.contains("SHELL_BASED_SURFACE_MODEL") && !file.contains("MANIFOLD_SOLID_BREP"));
    }
}

#[test]
fn a_handle_that_closes_is_made_beside_a_pot() {
    let pot = json!({ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 });
    let document = json!({ "pasu": 1, "parts": [
        { "shape": pot, "wall": { "thickness": 0.5, "base": 0.5 } },
        { "shape": torus(4, 4), "place": { "shift": [20, 0, 2] } },
        { "shape": pot, "place": { "shift": [40, 0, 0] } },
    ] });
    let design = Design::parse(&document.to_string()).unwrap();
    let parts: Vec<usize> = pasu::solid(&design, &Making::default()).unwrap().iter().map(|mesh| mesh.part).collect();
    assert_eq!(parts, [0, 1]);
}

#[test]
fn normals_are_the_mean_below_the_crease_angle_and_their_own_above() {
    // A roof of two flat patches that meet at 0.4 radians, with the angle of a crease on either side of that.
    let (up, out) = (0.2f64.sin(), 0.2f64.cos());
    let shape = |crease: f64| {
        let rows = [(-out, 0.0), (-0.5 * out, 0.5 * up), (0.0, up), (0.5 * out, 0.5 * up), (out, 0.0)];
        let vertices: Vec<[f64; 3]> = rows.iter().flat_map(|(x, z)| [-1.0, 0.0, 1.0].map(|y| [*x, y, *z])).collect();
        let frame = |row: usize| {
            [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)].map(|(i, j)| 3 * (row + i) + j)
        };
        json!({ "kind": "vertex-frame", "vertices": vertices, "patches": [{ "frame": frame(0) }, { "frame": frame(2) }], "crease": crease })
    };
    for (crease, is_smooth) in [(0.41, true), (0.39, false), (0.0, false), (9.0, true)] {
        let mesh = pasu::mesh(
            &design_of(&shape(crease).to_string()),
            &MeshOptions { rows: Some(3), columns: Some(4), tolerance: None },
        )
        .unwrap();
        for (at, normal) in mesh.positions.chunks_exact(3).zip(mesh.normals.chunks_exact(3)) {
            let on_ridge = at[0].abs() < 1e-6;
            let is_level = normal[0].abs() < 1e-6;
            assert_eq!(is_level, on_ridge && is_smooth, "{crease} {at:?} {normal:?}");
        }
    }
}

#[test]
fn vertices_that_are_one_point_by_two_numbers_join_nothing() {
    let mut shape = cube();
    // The first patch has points of its own, all in the same places.
    let frame: Vec<usize> = serde_json::from_value(shape["patches"][0]["frame"].clone()).unwrap();
    let n = shape["vertices"].as_array().unwrap().len();
    for vertex in frame {
        let at = shape["vertices"][vertex].clone();
        shape["vertices"].as_array_mut().unwrap().push(at);
    }
    shape["patches"][0]["frame"] = json!((n..n + 8).collect::<Vec<_>>());
    let design = design_of(&shape.to_string());
    assert_eq!(pasu::solid(&design, &Making::default()).unwrap_err().code(), Code::OpenSurface);
    assert!(pasu::mesh(&design, &MeshOptions::default()).unwrap().n_triangles() >= 12);
}

#[test]
fn ten_thousand_patches_are_solved_and_sampled() {
    let (m, n) = (100, 100);
    let mut vertices = Vec::new();
    let mut number = std::collections::HashMap::new();
    let mut patches = Vec::new();
    for (i, j) in (0..m * n).map(|k| (k / n, k % n)) {
        let around = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        let mut frame = around.map(|(a, b)| {
            let (x, y) = (2 * i + a, 2 * j + b);
            *number.entry((x, y)).or_insert_with(|| {
                // A landscape, of short numbers.
                let z = ((x as f64 / 9.0).sin() * (y as f64 / 7.0).cos() * 100.0).round() / 20.0;
                vertices.push(json!([x, y, z]));
                vertices.len() - 1
            })
        });
        frame.rotate_left(2 * ((i + 3 * j) % 4));
        patches.push(json!({ "frame": frame }));
    }
    let design = design_of(&json!({ "kind": "vertex-frame", "vertices": vertices, "patches": patches }).to_string());
    let begun = std::time::Instant::now();
    let mesh = pasu::mesh(&design, &MeshOptions { tolerance: Some(0.2), ..MeshOptions::default() }).unwrap();
    let taken = begun.elapsed();
    mesh.validate().unwrap();
    assert!(mesh.bound.unwrap() <= 0.2 && mesh.n_vertices() >= 40_000);
    println!("10,000 patches solved and sampled in {taken:?}: {} vertices", mesh.n_vertices());
    // Far more than it takes: only what grows with the square of the patches is caught.
    assert!(taken.as_secs_f64() < 10.0, "{taken:?}");
    assert_eq!(Design::parse(&design.link()).unwrap(), design);
}
