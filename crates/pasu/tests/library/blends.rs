//! Blends: against the reference corpus, against formulas, and against what holds of every solid.

use core::f64::consts::PI;

use glam::DVec3;
use pasu::{
    CellShape, CellsOptions, Code, Design, Format, Making, MeasureOptions, Mesh, MeshOptions, Product, Solution,
};
use proptest::prelude::*;
use serde_json::{Value, json};

fn design(shape: &Value) -> Design {
    read(shape, &json!({})).unwrap_or_else(|error| panic!("{error}: {shape}"))
}

/// A part with this shape and these other fields.
fn read(shape: &Value, rest: &Value) -> pasu::Result<Design> {
    let mut part = rest.clone();
    part["shape"] = shape.clone();
    Design::parse(&json!({ "pasu": 1, "parts": [part] }).to_string())
}

fn section(form: &str, radius: [f64; 2], [z, taper, dz]: [f64; 3]) -> Value {
    json!({ "form": form, "radius": radius, "z": z, "taper": taper, "dz": dz })
}

fn blend(start: Value, end: Value) -> Value {
    json!({ "kind": "blend", "start": start, "end": end })
}

fn petals([z, taper, dz]: [f64; 3]) -> Value {
    json!({ "form": "outline", "x": [{ "n": 1, "sin": 2 }, { "n": 4, "sin": -0.2 }, { "n": 6, "sin": 0.2 }], "y": [{ "n": 1, "cos": 2 }, { "n": 4, "cos": 0.2 }, { "n": 6, "cos": 0.2 }],
        "z": z, "taper": taper, "dz": dz })
}

/// The same with little weight round the solid, so that it has no neck.
fn weighted(mut shape: Value) -> Value {
    shape["weights"] = json!([1, 0.005, 1]);
    shape
}

/// Blends of every form that are solids, drawn straight up.
fn solids() -> Vec<(&'static str, Value)> {
    let (low, high) = ([0.0, 0.2, 3.0], [4.0, -0.1, 3.0]);
    vec![
        ("rectangles", blend(section("rectangle", [1.0, 1.0], low), section("rectangle", [1.5, 2.0], high))),
        (
            "rectangles reversed",
            blend(
                section("rectangle-reversed", [1.0, 1.0], [4.0, 0.1, -3.0]),
                section("rectangle-reversed", [1.5, 2.0], [0.0, -0.2, -3.0]),
            ),
        ),
        // With the weights of the paper a round solid has a neck that is next to nothing.
        ("discs", weighted(blend(section("disc", [2.0, 3.0], low), section("disc", [1.0, 1.0], high)))),
        ("petals", weighted(blend(section("disc", [1.0, 1.5], low), petals(high)))),
        (
            "disc in a square to rectangle",
            blend(section("disc-in-square", [1.0, 1.0], low), section("rectangle-reversed", [2.0, 1.25], high)),
        ),
        (
            "rectangle to disc in a square",
            blend(section("rectangle-reversed", [2.0, 1.25], low), section("disc-in-square", [1.0, 1.0], high)),
        ),
        (
            "discs in squares",
            blend(section("disc-in-square", [1.0, 1.0], low), section("disc-in-square", [2.0, 1.25], high)),
        ),
    ]
}

#[test]
fn positions_are_those_of_the_reference() {
    let cases: Vec<Value> = serde_json::from_str(include_str!("../reference/blends.json")).unwrap();
    assert_eq!(cases.len(), 8);
    for case in &cases {
        let within = if case["shape"]["method"] == "exact" { 1e-12 } else { 1e-9 };
        let points = case["points"].as_array().unwrap();
        let at: Vec<f64> =
            points.iter().flat_map(|point| ["u", "v", "w"].map(|name| point[name].as_f64().unwrap())).collect();
        let found = pasu::evaluate(&design(&case["shape"]), 0, &at).unwrap();
        for (point, found) in points.iter().zip(found.chunks_exact(3)) {
            let expected: [f64; 3] = serde_json::from_value(point["position"].clone()).unwrap();
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() <= within, "{}: {found}, not {expected}", case["name"]);
            }
        }
    }
}

#[test]
fn what_is_read_is_canonical_and_reads_back() {
    let outline =
        |x: Value| json!({ "form": "outline", "x": x, "y": [{ "n": 1, "cos": 1 }], "z": 0, "taper": 0, "dz": 1 });
    let same = [
        outline(json!([{ "n": 1, "sin": 1 }])),
        outline(json!([{ "n": 3, "cos": 0 }, { "n": 1, "sin": 0.75 }, { "n": 0, "sin": 5 }, { "n": 1, "sin": 0.25 }])),
    ];
    let disc = section("disc", [1.0, 1.0], [2.0, 0.0, 1.0]);
    let mut texts = same.map(|start| {
        let mut shape = blend(start, disc.clone());
        (shape["method"], shape["terms"], shape["weights"]) = (json!("exact"), json!([9, 9, 9]), json!([1, 1, 1]));
        design(&shape).to_json()
    });
    assert_eq!(texts[0], texts[1]);
    assert!(
        !texts[0].contains("method") && !texts[0].contains("terms") && !texts[0].contains("weights"),
        "{}",
        texts[0]
    );
    // A link brings all of it back.
    let mut shape = blend(disc.clone(), section("rectangle", [1.0, 2.0], [4.0, 0.5, -1.0]));
    (shape["method"], shape["terms"], shape["weights"]) = (json!("collocation"), json!([5, 6, 7]), json!([1, 2, 0.5]));
    texts[0] = design(&shape).to_json();
    let link = design(&shape).link();
    assert_eq!(Design::parse(&format!("#{link}")).unwrap().to_json(), texts[0]);
    for word in [r#""method":"collocation""#, r#""terms":[5,6,7]"#, r#""weights":[1,2,0.5]"#] {
        assert!(texts[0].contains(word), "{}", texts[0]);
    }
}

#[test]
fn bad_input_is_refused_with_its_path() {
    let good = || blend(section("disc", [1.0, 1.0], [0.0, 0.0, 1.0]), section("disc", [1.0, 1.0], [2.0, 0.0, 1.0]));
    let with = |path: &[&str], value: Value| {
        let mut shape = good();
        let place = path.iter().fold(&mut shape, |place, name| &mut place[*name]);
        *place = value;
        shape
    };
    let long: Vec<Value> = (1..5000).map(|n| json!({ "n": n, "sin": 1e-6 })).collect();
    let outline = |x: Value, y: Value| json!({ "form": "outline", "x": x, "y": y, "z": 0, "taper": 0, "dz": 1 });
    let round = || json!([{ "n": 1, "sin": 1 }]);
    for (shape, code, path) in [
        (with(&["start", "form"], json!("cone")), Code::UnknownName, "start.form"),
        (with(&["start", "radius"], json!([1, 0])), Code::OutOfRange, "start.radius[1]"),
        (with(&["start", "radius"], json!([1])), Code::WrongType, "start.radius"),
        (with(&["start", "z"], json!(null)), Code::MissingField, "start.z"),
        (with(&["end", "taper"], json!("x")), Code::WrongType, "end.taper"),
        (with(&["end", "x"], json!([])), Code::UnknownField, "end.x"),
        (with(&["method"], json!("guess")), Code::UnknownName, "method"),
        (with(&["terms"], json!([4, 4])), Code::WrongType, "terms"),
        (with(&["terms"], json!([4, 0, 4])), Code::OutOfRange, "terms"),
        (with(&["terms"], json!([4, 4, 2.5])), Code::OutOfRange, "terms"),
        (with(&["terms"], json!([1e9, 4, 4])), Code::OutOfRange, "terms"),
        (with(&["weights"], json!([1, 1, 0])), Code::OutOfRange, "weights[2]"),
        (with(&["weights"], json!([1, -1, 1])), Code::OutOfRange, "weights[1]"),
        (with(&["start"], outline(json!([]), round())), Code::OutOfRange, "start.x"),
        (with(&["start"], outline(json!([{ "n": 1.5, "sin": 1 }]), round())), Code::OutOfRange, "start.x[0].n"),
        (with(&["start"], outline(json!([{ "n": -1, "sin": 1 }]), round())), Code::OutOfRange, "start.x[0].n"),
        (with(&["start"], outline(json!(long), round())), Code::TooLarge, "start.x"),
        (with(&["start", "radius"], json!([1e308, 1])), Code::Overflow, "start"),
    ] {
        let error = read(&shape, &json!({})).unwrap_err();
        let expected = ["parts[0].shape", path].map(str::to_owned).into_iter().filter(|part| !part.is_empty());
        let expected = expected.collect::<Vec<_>>().join(".");
        assert_eq!((error.code(), error.path()), (code, expected.as_str()), "{error}");
    }
    // Terms beyond what is solved at once.
    let mut shape = with(&["method"], json!("modal"));
    shape["terms"] = json!([256, 256, 1]);
    let error = read(&shape, &json!({})).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::TooLarge, "parts[0].shape"));
    // What is only seen when it is solved.
    let loops = outline(
        json!([{ "n": 1, "sin": 1 }, { "n": 2, "sin": 1 }]),
        json!([{ "n": 1, "cos": 1 }, { "n": 2, "cos": 1 }]),
    );
    let eight = outline(json!([{ "n": 2, "sin": 1 }]), json!([{ "n": 1, "cos": 1 }]));
    let line = outline(json!([{ "n": 1, "sin": 1 }]), json!([{ "n": 1, "sin": 2 }]));
    for (shape, code, path) in [
        (with(&["start"], loops), Code::CrossesItself, "parts[0].shape.start"),
        (with(&["start"], eight), Code::CrossesItself, "parts[0].shape.start"),
        (with(&["end"], line), Code::PinchedSurface, "parts[0].shape.end"),
        (with(&["end", "z"], json!(0)), Code::CrossesItself, "parts[0].shape.end.z"),
    ] {
        let error = pasu::mesh(&design(&shape), &MeshOptions::default()).unwrap_err();
        assert_eq!((error.code(), error.path()), (code, path), "{error}");
    }
    // Sections of one height that lie beside each other are an arch.
    let mut beside = with(&["end", "z"], json!(0));
    beside["start"] = json!({ "form": "outline", "x": [{ "n": 0, "cos": 4 }, { "n": 1, "sin": 1 }], "y": [{ "n": 1, "cos": 1 }], "z": 0, "taper": 0, "dz": 9 });
    beside["end"]["dz"] = json!(-9);
    pasu::mesh(&design(&beside), &MeshOptions::default()).unwrap();
}

#[test]
fn points_outside_and_numbers_that_are_no_triples_are_refused() {
    let design = design(&solids()[0].1);
    for (at, path) in [(vec![0.5, 0.5], "at"), (vec![0.5, 1.5, 0.5], "at[1]"), (vec![0.5, 0.5, f64::NAN], "at[2]")] {
        let error = pasu::evaluate(&design, 0, &at).unwrap_err();
        assert_eq!((error.code(), error.path()), (Code::NoSuchPoint, path));
    }
    assert!(pasu::evaluate(&design, 0, &[]).unwrap().is_empty());
}

#[test]
fn the_skin_is_closed_and_holds_its_tolerance() {
    for (name, shape) in solids() {
        let design = design(&shape);
        for tolerance in [0.05, 0.002] {
            let mesh =
                pasu::mesh(&design, &MeshOptions { tolerance: Some(tolerance), ..MeshOptions::default() }).unwrap();
            mesh.validate().unwrap_or_else(|broken| panic!("{name}: {broken}"));
            assert!(mesh.bound.unwrap() <= tolerance, "{name}");
            assert!(mesh.n_triangles() < 200_000, "{name} {tolerance}: {}", mesh.n_triangles());
            assert_closed(name, &mesh);
            // Triangles of a finer mesh lie as near to those of the coarse one as both promise.
            let away = farthest(&design, &shape, &mesh);
            assert!(away <= tolerance, "{name}: {away}");
        }
        let mesh = pasu::mesh(&design, &MeshOptions { rows: Some(9), columns: Some(9), tolerance: None }).unwrap();
        mesh.validate().unwrap_or_else(|broken| panic!("{name}: {broken}"));
        assert_closed(name, &mesh);
    }
}

/// Every edge of the triangles, by the bits of its ends, is passed once in either direction.
fn assert_closed(name: &str, mesh: &Mesh) {
    let point = |vertex: &u32| {
        let from = 3 * *vertex as usize;
        [0, 1, 2].map(|axis| (mesh.positions[from + axis] + 0.0).to_bits())
    };
    let mut edges = std::collections::HashMap::new();
    for triangle in mesh.indices.chunks_exact(3) {
        let corners: Vec<_> = triangle.iter().map(point).collect();
        if (0..3).all(|i| corners[i] != corners[(i + 1) % 3]) {
            (0..3).for_each(|i| *edges.entry((corners[i], corners[(i + 1) % 3])).or_insert(0) += 1);
        }
    }
    assert!(edges.iter().all(|((a, b), n)| *n == 1 && edges.get(&(*b, *a)) == Some(&1)), "{name} is open");
}

/// How far points of the skin, by the inside of the blend, are from the triangles of a mesh at most.
fn farthest(design: &Design, shape: &Value, mesh: &Mesh) -> f64 {
    let is_round =
        ["start", "end"].iter().all(|end| ["disc", "outline"].iter().any(|form| shape[*end]["form"] == *form));
    let mut at = Vec::new();
    for i in 0..4 {
        for j in 0..4 {
            let (a, b) = ((i as f64 + 0.31) / 4.0, (j as f64 + 0.43) / 4.0);
            at.extend([[1.0, a, b], [a, b, 0.0], [a, b, 1.0]]);
            if !is_round {
                at.extend([[0.0, a, b], [a, 0.0, b], [a, 1.0, b]]);
            }
        }
    }
    let points = pasu::evaluate(design, 0, &at.concat()).unwrap();
    let corner = |vertex: u32| {
        let from = 3 * vertex as usize;
        DVec3::from_array([0, 1, 2].map(|axis| f64::from(mesh.positions[from + axis])))
    };
    let triangles: Vec<[DVec3; 3]> =
        mesh.indices.chunks_exact(3).map(|t| [corner(t[0]), corner(t[1]), corner(t[2])]).collect();
    let near = |point: &[f64]| {
        let point = DVec3::from_slice(point);
        triangles.iter().map(|triangle| to_triangle(point, triangle)).fold(f64::INFINITY, f64::min)
    };
    points.chunks_exact(3).map(near).fold(0.0, f64::max)
}

/// The distance of a point from a triangle.
fn to_triangle(p: DVec3, [a, b, c]: &[DVec3; 3]) -> f64 {
    let normal = (*b - *a).cross(*c - *a);
    let squared = normal.length_squared();
    let is_inside = |from: &DVec3, to: &DVec3| (*to - *from).cross(p - *from).dot(normal) >= 0.0;
    if squared > 0.0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a) {
        return (p - *a).dot(normal).abs() / squared.sqrt();
    }
    let to_edge = |from: &DVec3, to: &DVec3| {
        let along = *to - *from;
        let share =
            if along == DVec3::ZERO { 0.0 } else { ((p - *from).dot(along) / along.length_squared()).clamp(0.0, 1.0) };
        p.distance(*from + share * along)
    };
    to_edge(a, b).min(to_edge(b, c)).min(to_edge(c, a))
}

/// Area, volume and centre of mass.
fn measured(shape: &Value, rest: &Value) -> (f64, f64, DVec3) {
    let options = MeasureOptions { product: Product::Solid, ..MeasureOptions::default() };
    let measures = pasu::measure(&read(shape, rest).unwrap(), &options).unwrap();
    let body = &measures.parts[0].body;
    let clay = body.clay.as_ref().unwrap();
    (body.area.value, clay.volume.value, DVec3::from_array(body.centre.empty.as_ref().unwrap().at))
}

#[test]
fn measures_are_those_of_formulas() {
    let near = |what: &str, found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-8 * expected.abs().max(1.0), "{what}: {found}, not {expected}");
    };
    // Straight up with the same section: a box, and a cylinder whatever the order of its sections.
    let straight = |form: &str, radius: [f64; 2], [from, to]: [f64; 2]| {
        let dz = to - from;
        blend(section(form, radius, [from, 0.0, dz]), section(form, radius, [to, 0.0, dz]))
    };
    for form in ["rectangle", "rectangle-reversed"] {
        for heights in [[0.0, 3.0], [3.0, 0.0]] {
            let (area, volume, centre) = measured(&straight(form, [1.0, 2.0], heights), &json!({}));
            near("area of a box", area, 2.0 * (8.0 + 6.0 + 12.0));
            near("volume of a box", volume, 24.0);
            assert!(centre.distance(DVec3::new(0.0, 0.0, 1.5)) < 1e-9, "{centre}");
        }
    }
    for (form, method) in [("disc", "modal"), ("disc", "collocation"), ("disc-in-square", "modal")] {
        let mut shape = straight(form, [2.0, 2.0], [1.0, 4.0]);
        shape["method"] = json!(method);
        let (area, volume, centre) = measured(&shape, &json!({}));
        near("area of a cylinder", area, 2.0 * PI * 2.0 * (2.0 + 3.0));
        near("volume of a cylinder", volume, PI * 4.0 * 3.0);
        assert!(centre.distance(DVec3::new(0.0, 0.0, 2.5)) < 1e-8, "{centre}");
    }
    // A frustum of a pyramid: width and height are both straight in w.
    let frustum =
        blend(section("rectangle", [1.0, 1.0], [0.0, 1.0, 3.0]), section("rectangle", [2.0, 2.0], [3.0, 0.5, 3.0]));
    let (_, volume, centre) = measured(&frustum, &json!({}));
    near("volume of a frustum", volume, 3.0 / 3.0 * (4.0 + 8.0 + 16.0));
    near("centre of a frustum", centre.z, 3.0 / 4.0 * (4.0 + 2.0 * 8.0 + 3.0 * 16.0) / 28.0);
    // Placed, mirrored and stretched.
    let place = json!({ "place": { "scale": [2, -1, 0.5], "axis": [0, 1, 0], "angle": 0.5, "shift": [3, 2, 1] } });
    let (_, volume, _) = measured(&frustum, &place);
    near("volume of a frustum in place", volume, 28.0);
}

/// The volume of a blend whose sections are closed, by the areas of its level curves: a rule that knows no patch.
#[test]
fn volumes_are_those_of_the_slices() {
    for (name, shape) in solids().into_iter().filter(|(name, _)| ["discs", "petals"].contains(name)) {
        let design = design(&shape);
        let (n, m) = (400, 256);
        let slices: Vec<(f64, f64)> = (0..=n)
            .map(|k| {
                let at: Vec<f64> = (0..m).flat_map(|j| [1.0, j as f64 / m as f64, k as f64 / n as f64]).collect();
                let points = pasu::evaluate(&design, 0, &at).unwrap();
                let slopes = pasu::derivatives(&design, 0, &at).unwrap().dv;
                // Green's theorem with the trapezoid rule, which is exact to rounding on a Fourier series.
                let area = points.chunks_exact(3).zip(slopes.chunks_exact(3)).map(|(p, d)| p[0] * d[1] - p[1] * d[0]);
                (points[2], 0.5 * area.sum::<f64>().abs() / m as f64)
            })
            .collect();
        // Simpson's rule in w, of the area times how fast z rises.
        let (z0, z1, d0, d1) = (slices[0].0, slices[n].0, 3.0, 3.0);
        let rise = |w: f64| {
            (6.0 * w - 6.0 * w * w) * (z1 - z0) + (1.0 - 4.0 * w + 3.0 * w * w) * d0 + (3.0 * w * w - 2.0 * w) * d1
        };
        let weight = |k: usize| {
            if k == 0 || k == n {
                1.0
            } else if k % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        let sum: f64 =
            slices.iter().enumerate().map(|(k, (_, area))| weight(k) * area * rise(k as f64 / n as f64)).sum();
        let expected = sum / (3 * n) as f64;
        let (_, volume, _) = measured(&shape, &json!({}));
        assert!((volume - expected).abs() < 1e-7 * expected, "{name}: {volume}, not {expected}");
    }
}

#[test]
fn a_solid_is_written_in_every_format_and_a_vessel_is_a_pot() {
    let making = Making::default();
    for (name, shape) in solids() {
        let solution = Solution::of(&design(&shape));
        let report = solution.check(&making).unwrap();
        assert!(report.is_ok(), "{name}: {:?}", report.findings);
        assert_eq!(report.meshes[0].genus, Some(0), "{name}");
        for format in [Format::Stl, Format::ThreeMf, Format::Glb, Format::Obj, Format::Ply] {
            assert!(solution.write(format, &making).unwrap().len() > 1000, "{name}");
        }
        let step = String::from_utf8(solution.write(Format::Step, &making).unwrap()).unwrap();
        assert!(step.contains("MANIFOLD_SOLID_BREP"), "{name}");
    }
    let wall = json!({ "wall": { "thickness": 0.2, "base": 0.3 } });
    for (name, shape) in solids() {
        let vessel = Solution::of(&read(&shape, &wall).unwrap());
        vessel.mesh(&MeshOptions::default()).unwrap().validate().unwrap();
        match name {
            "discs" | "petals" => {
                let report = vessel.check(&making).unwrap();
                assert!(report.is_ok(), "{name}: {:?}", report.findings);
                let measures = vessel.measure(&MeasureOptions::default()).unwrap();
                let (_, solid, _) = measured(&shape, &json!({}));
                let clay = measures.parts[0].body.clay.as_ref().unwrap().volume.value;
                assert!(clay > 0.05 * solid && clay < 0.6 * solid, "{name}: {clay} of {solid}");
                for format in [Format::Stl, Format::Step, Format::Svg] {
                    vessel.write(format, &making).unwrap();
                }
            }
            _ => {
                let error = vessel.write(Format::Stl, &making).unwrap_err();
                assert_eq!((error.code(), error.path()), (Code::UnsupportedShape, "parts[0].wall"), "{name}: {error}");
            }
        }
    }
}

#[test]
fn what_runs_through_itself_is_drawn_and_refused_when_it_is_made() {
    // A neck so strongly drawn together that it is turned inside out.
    let shape = blend(section("disc", [1.0, 1.0], [0.0, -12.0, 3.0]), section("disc", [1.0, 1.0], [3.0, 12.0, 3.0]));
    // And one that goes up, back below its beginning and up again, straight through itself.
    let folded =
        blend(section("rectangle", [1.0, 1.0], [0.0, 0.0, 30.0]), section("rectangle", [1.0, 1.0], [1.0, 0.0, 30.0]));
    for shape in [shape, folded] {
        let design = design(&shape);
        pasu::mesh(&design, &MeshOptions::default()).unwrap().validate().unwrap();
        let error = pasu::write(&design, Format::Stl, &Making::default()).unwrap_err();
        assert!(error.path().starts_with("parts[0].shape") && error.place().is_some(), "{error}");
        let report = pasu::check(&design, &Making::default()).unwrap();
        assert!(!report.is_ok() && report.findings[0].at.is_some());
    }
}

#[test]
fn cells_fill_the_solid_and_are_well_shaped() {
    for (name, shape) in solids().into_iter().filter(|(name, _)| *name != "discs in squares") {
        let design = design(&shape);
        let (_, volume, _) = measured(&shape, &json!({}));
        let of = |shape: CellShape, n: usize| {
            pasu::cells(&design, 0, &CellsOptions { counts: [n, 4 * n, 2 * n], shape }).unwrap()
        };
        let off = |shape: CellShape, n: usize| (of(shape, n).volume() - volume).abs() / volume;
        for shape in [CellShape::Hexahedron, CellShape::Tetrahedron] {
            let errors = [4, 8].map(|n| off(shape, n));
            // Straight edges in a round solid: an error of the second order, and of 3/2 where the width of a disc in a square grows as a root.
            assert!(errors[1] < 0.02 && errors[1] < 0.4 * errors[0] + 1e-9, "{name}: {errors:?}");
            let cells = of(shape, 4);
            // A disc in a square has two edges along which cells have no angle.
            let is_collapsed = name.contains("disc in a square");
            assert!(
                cells.least_quality() > if is_collapsed { -1e-9 } else { 0.02 },
                "{name}: {}",
                cells.least_quality()
            );
            assert_eq!(cells.bad().count() > 0, is_collapsed, "{name}");
            assert!(cells.corners.iter().all(|corner| (*corner as usize) < cells.n_points()));
        }
    }
    let error = pasu::cells(&design(&solids()[6].1), 0, &CellsOptions::default()).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::UnsupportedShape, "parts[0].shape"));
    let vase = Design::parse("#1/bloor-wilson").unwrap();
    assert_eq!(pasu::cells(&vase, 0, &CellsOptions::default()).unwrap_err().code(), Code::UnsupportedShape);
    let solid = design(&solids()[0].1);
    let with = |counts| CellsOptions { counts, ..CellsOptions::default() };
    assert_eq!(pasu::cells(&solid, 0, &with([1, 0, 1])).unwrap_err().code(), Code::OutOfRange);
    assert_eq!(pasu::cells(&solid, 0, &with([usize::MAX, 9, 9])).unwrap_err().code(), Code::TooLarge);
    assert_eq!(pasu::cells(&solid, 1, &with([1, 1, 1])).unwrap_err().code(), Code::NoSuchPoint);
}

#[test]
fn neighbouring_cells_share_whole_sides() {
    const SIDES: [[usize; 4]; 6] = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    for (name, shape) in solids().into_iter().filter(|(name, _)| *name != "discs in squares") {
        let cells =
            pasu::cells(&design(&shape), 0, &CellsOptions { counts: [3, 8, 5], shape: CellShape::Hexahedron }).unwrap();
        let mut sides = std::collections::HashMap::new();
        for cell in 0..cells.n_cells() {
            for side in SIDES {
                let mut corners = side.map(|corner| cells.cell(cell)[corner]);
                corners.sort_unstable();
                *sides.entry(corners).or_insert(0) += 1;
            }
        }
        assert!(sides.values().all(|n| *n <= 2), "{name}");
        let [rows, columns] = [3, 8];
        let round = sides.values().filter(|n| **n == 1).count();
        // The border: two sections, and what goes round.
        let per_layer = cells.n_cells() / 5;
        let border = if name == "discs" || name == "petals" { columns } else { 2 * (rows + columns) };
        assert_eq!(round, 2 * per_layer + 5 * border, "{name}");
    }
}

/// Any section of one height and any tangents.
fn any_section(z: f64) -> impl Strategy<Value = Value> {
    let forms = prop_oneof![Just("rectangle"), Just("rectangle-reversed"), Just("disc"), Just("disc-in-square")];
    let plain = (forms, 0.3..3.0, 0.3..3.0, -0.5..0.5, -3.0..3.0)
        .prop_map(move |(form, rx, ry, taper, dz)| section(form, [rx, ry], [z, taper, dz]));
    let outlined = (proptest::collection::vec((1u32..7, -0.1..0.1, -0.1..0.1), 0..4), -0.5..0.5, -3.0..3.0).prop_map(
        move |(waves, taper, dz)| {
            let of = |round: Value, is_x: bool| {
                let more = waves.iter().map(|(n, a, b)| if is_x { json!({ "n": n, "cos": a, "sin": b }) } else { json!({ "n": n, "cos": b, "sin": a }) });
                core::iter::once(round).chain(more).collect::<Vec<Value>>()
            };
            json!({ "form": "outline", "x": of(json!({ "n": 1, "sin": 1.5 }), true), "y": of(json!({ "n": 1, "cos": 1.5 }), false), "z": z, "taper": taper, "dz": dz })
        },
    );
    prop_oneof![3 => plain, 2 => outlined]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the sections: numbers that are numbers, canonical form that changes nothing, a skin that is the border of the inside.
    #[test]
    fn any_blend_is_drawn(start in any_section(0.0), end in any_section(3.0), method in 0usize..3, terms in (1u32..6, 1u32..6, 1u32..6)) {
        let mut shape = blend(start, end);
        shape["terms"] = json!([terms.0, terms.1, terms.2]);
        shape["method"] = [json!(null), json!("modal"), json!("collocation")][method].clone();
        if method == 0 {
            shape.as_object_mut().unwrap().remove("method");
        }
        let given = read(&shape, &json!({}));
        prop_assume!(given.is_ok());
        let design = given.unwrap();
        let again = Design::parse(&design.to_json()).unwrap();
        prop_assert_eq!(again.to_json(), design.to_json());
        let points = [[0.2, 0.7, 0.0], [1.0, 0.3, 0.6], [0.4, 1.0, 1.0], [0.5, 0.5, 0.5]].concat();
        let found = match pasu::evaluate(&design, 0, &points) {
            Ok(found) => found,
            // Several waves together may turn an outline through itself.
            Err(error) => {
                prop_assert_eq!(error.code(), pasu::Code::CrossesItself);
                return Ok(());
            }
        };
        prop_assert!(found.iter().all(|x| x.is_finite()));
        let mesh = pasu::mesh(&design, &MeshOptions { tolerance: Some(0.05), ..MeshOptions::default() }).unwrap();
        mesh.validate().unwrap();
        let away = farthest(&design, &shape, &mesh);
        prop_assert!(away <= 0.05, "{} away: {}", away, shape);
    }

    /// Making says yes or no in words and with a place, and a yes is a closed body.
    #[test]
    fn any_blend_is_made_or_refused(start in any_section(0.0), end in any_section(3.0)) {
        let Ok(design) = read(&blend(start, end), &json!({})) else { return Ok(()) };
        match pasu::solid(&design, &Making { tolerance: Some(0.05), ..Making::default() }) {
            Ok(meshes) => prop_assert!(meshes[0].n_triangles() > 0),
            Err(error) => prop_assert!(error.path().starts_with("parts[0].shape"), "{}", error),
        }
    }
}
