//! Open networks of patches with a wall: a thickness along their normals.

use glam::DVec3;
use pasu::{Code, Design, Error, FaceKind, Format, Making, MeasureOptions, check, measure, solid, write};
use serde_json::{Value, json};

use crate::support::networks::{Dice, Net, Wrap, cube};

fn walled(shape: &Value, thickness: f64, more: &Value) -> Design {
    let mut part = json!({ "shape": shape, "wall": { "thickness": thickness, "base": 0 } });
    more.as_object().into_iter().flatten().for_each(|(name, value)| match (name.as_str(), value) {
        ("wall", Value::Object(fields)) => fields.iter().for_each(|(field, value)| part["wall"][field] = value.clone()),
        _ => part[name] = value.clone(),
    });
    Design::parse(&json!({ "pasu": 1, "parts": [part] }).to_string()).unwrap()
}

/// A cube of side 2 without one of its faces.
fn box_without(face: usize) -> Value {
    let mut shape = cube();
    shape["patches"].as_array_mut().unwrap().remove(face);
    shape
}

/// One patch through these points.
fn patch(points: [[f64; 3]; 8]) -> Value {
    json!({ "kind": "vertex-frame", "vertices": points, "patches": [{ "frame": [0, 1, 2, 3, 4, 5, 6, 7] }] })
}

/// Half a tube of this radius and length 2, of `n` patches round.
fn half_tube(radius: f64, n: usize) -> Value {
    let at = |i: usize, j: usize| {
        let (s, c) = (core::f64::consts::PI * i as f64 / (2 * n) as f64).sin_cos();
        [radius * c, radius * s, j as f64]
    };
    let vertices: Vec<[f64; 3]> = (0..3 * (2 * n + 1)).map(|k| at(k / 3, k % 3)).collect();
    let round = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
    let patches: Vec<Value> = (0..n).map(|k| json!({ "frame": round.map(|(i, j)| 3 * (2 * k + i) + j) })).collect();
    json!({ "kind": "vertex-frame", "vertices": vertices, "patches": patches })
}

/// Area of the surface, and area, volume and triangles of the clay.
fn clay(design: &Design) -> [f64; 4] {
    clay_within(design, 0.002)
}

/// The same with triangles within another tolerance.
fn clay_within(design: &Design, tolerance: f64) -> [f64; 4] {
    let whole = measure(design, &MeasureOptions::default()).unwrap().whole;
    let clay = whole.clay.expect("it has a body");
    let mesh = &solid(design, &Making { tolerance: Some(tolerance), ..Making::default() }).unwrap()[0];
    let at = |vertex: u32| DVec3::from_array([0, 1, 2].map(|i| f64::from(mesh.positions[3 * vertex as usize + i])));
    let corners = mesh.indices.chunks_exact(3).map(|of| [at(of[0]), at(of[1]), at(of[2])]);
    let millimetres = design.unit().millimetres();
    let volume = corners.map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum::<f64>() / millimetres.powi(3);
    [whole.area.value, clay.area.value, clay.volume.value, volume]
}

fn refusal(design: &Design) -> Error {
    let error = solid(design, &Making::default()).unwrap_err();
    // The report says the same, and what is measured is the surface.
    let report = check(design, &Making::default()).unwrap();
    assert_eq!((report.findings[0].code, report.findings[0].at), (error.code().as_str(), error.place()), "{error}");
    let part = measure(design, &MeasureOptions::default()).unwrap().parts.remove(0);
    assert!(part.body.clay.is_none() && part.reason.as_deref() == Some(error.message()), "{part:?}");
    error
}

#[test]
fn a_flat_patch_becomes_a_slab() {
    let flat = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0], [0.0, 1.0]];
    let shape = patch(flat.map(|[x, y]| [x, y, 5.0]));
    for side in ["inside", "outside"] {
        let design = walled(&shape, 0.25, &json!({ "wall": { "side": side } }));
        let part = measure(&design, &MeasureOptions::default()).unwrap().parts.remove(0);
        assert!(part.is_pot && part.reason.is_none() && part.capacity_cause.is_some_and(|why| why.code == "no-foot"));
        let [surface, area, volume, of_mesh] = clay(&design);
        assert!((surface - 4.0).abs() < 1e-9 && (area - 10.0).abs() < 1e-9, "{surface} {area}");
        assert!((volume - 1.0).abs() < 1e-9 && (of_mesh - 1.0).abs() < 1e-4, "{volume} {of_mesh}");
        let report = check(&design, &Making::default()).unwrap();
        assert!(
            report.is_ok() && report.findings.iter().all(|finding| finding.code != "too-thin"),
            "{:?}",
            report.findings
        );
        // Centimetres: a twentieth of a millimetre is no wall.
        let thin = check(&walled(&shape, 0.005, &json!({ "wall": { "side": side } })), &Making::default()).unwrap();
        let told = thin.findings.iter().find(|finding| finding.code == "too-thin").expect("too thin to be printed");
        assert_eq!(told.path.as_deref(), Some("parts[0].wall.thickness"));
        assert!(told.at.is_some_and(|at| (at[2] - 5.0).abs() < 1e-9), "{told:?}");
    }
}

#[test]
fn the_other_side_is_the_lining_and_free_edges_are_rims() {
    let flat = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0], [0.0, 1.0]];
    let shape = patch(flat.map(|[x, y]| [x, y, 5.0]));
    for (side, own, beyond) in
        [("inside", FaceKind::Outer, FaceKind::Lining), ("outside", FaceKind::Lining, FaceKind::Outer)]
    {
        let look = json!({ "wall": { "side": side }, "look": { "glaze": "celadon", "inside": "tin-white" } });
        let design = walled(&shape, 0.25, &look);
        let millimetres = design.unit().millimetres() as f32;
        let mesh = &solid(&design, &Making::default()).unwrap()[0];
        let of = |kind: FaceKind| {
            let faces = mesh.faces.iter().filter(move |face| face.0 == kind);
            let vertices = faces.flat_map(|(_, first, count)| &mesh.indices[*first as usize..(first + count) as usize]);
            vertices.map(|vertex| mesh.positions[3 * *vertex as usize + 2] / millimetres).collect::<Vec<f32>>()
        };
        let off = |heights: &[f32]| heights.iter().map(|z| (z - 5.0).abs()).fold(0.0, f32::max);
        assert!(!of(own).is_empty() && off(&of(own)) < 1e-6, "{side}");
        assert!(!of(beyond).is_empty() && of(beyond).iter().all(|z| ((z - 5.0).abs() - 0.25).abs() < 1e-5), "{side}");
        assert!(of(FaceKind::Rim).len() >= 8 * 3 && (off(&of(FaceKind::Rim)) - 0.25).abs() < 1e-5, "{side}");
        let n: u32 = mesh.faces.iter().map(|(_, _, count)| count).sum();
        assert_eq!(n as usize, mesh.indices.len());
        // So that a glaze of the inside is on it.
        let obj = String::from_utf8_lossy(&write(&design, Format::Obj, &Making::default()).unwrap()).into_owned();
        let looks: std::collections::BTreeSet<&str> = obj.lines().filter(|line| line.contains("usemtl ")).collect();
        assert_eq!(looks.len(), 2, "{side}: {looks:?}");
        // What a hand drags has the other side and the rims; the network is drawn already.
        let sketch = pasu::sketch(&design, &pasu::SketchOptions::default()).unwrap();
        assert_eq!(sketch.faces.iter().map(|face| face.kind).collect::<Vec<_>>(), [beyond, FaceKind::Rim], "{side}");
        assert!(sketch.water.is_none());
    }
}

#[test]
fn a_box_without_a_lid_is_mitred_at_its_edges() {
    for face in 0..6 {
        // The box is as wide along each axis as its face is missing along this one.
        for (scale, is_turned) in [([1.0, 1.0, 1.0], false), ([1.0, -2.0, 1.5], true)] {
            let turn = if is_turned {
                json!({ "scale": scale, "axis": [1, 2, 2], "angle": 0.8, "shift": [3, -2, 5] })
            } else {
                json!({})
            };
            let sizes = scale.map(|s: f64| 2.0 * s.abs());
            let whole: f64 = sizes.iter().product();
            let other = |by: f64| -> f64 {
                (0..3).map(|axis| sizes[axis] + by * if axis == face / 2 { 1.0 } else { 2.0 }).product()
            };
            for (side, expected) in [("inside", whole - other(-0.2)), ("outside", other(0.2) - whole)] {
                let design = walled(&box_without(face), 0.2, &json!({ "place": turn, "wall": { "side": side } }));
                let [_, _, volume, of_mesh] = clay(&design);
                assert!((volume - expected).abs() < 1e-9, "{face} {side}: {volume}, not {expected}");
                assert!((of_mesh - expected).abs() < 1e-3 * expected, "{face} {side}: {of_mesh}, not {expected}");
            }
        }
    }
}

#[test]
fn a_curved_wall_is_as_thick_as_it_is_asked_to_be() {
    for (n, within) in [(2, 2e-2), (4, 2e-3), (8, 2e-4)] {
        for (side, radii) in [("inside", [0.8, 1.0f64]), ("outside", [1.0, 1.2])] {
            // Half a tube goes round its axis: inside is where that is.
            let design = walled(&half_tube(1.0, n), 0.2, &json!({ "wall": { "side": side } }));
            let [_, _, volume, of_mesh] = clay(&design);
            let expected = core::f64::consts::PI * (radii[1] * radii[1] - radii[0] * radii[0]);
            assert!((volume / expected - 1.0).abs() < within, "{n} {side}: {volume}, not {expected}");
            assert!((of_mesh / expected - 1.0).abs() < within + 0.01, "{n} {side}: {of_mesh}, not {expected}");
        }
    }
}

#[test]
fn files_of_a_shell_are_closed_solids_and_hold_its_patches() {
    let design = walled(&half_tube(1.0, 3), 0.1, &json!({}));
    let step = String::from_utf8(write(&design, Format::Step, &Making::default()).unwrap()).unwrap();
    let count = |entity: &str| step.matches(&format!("={entity}(")).count();
    // Three patches, three beside them, and a rim along each of eight free edges.
    assert_eq!((count("MANIFOLD_SOLID_BREP"), count("ADVANCED_FACE")), (1, 14));
    // Euler: as many corners and faces as edges and two.
    assert_eq!(count("VERTEX_POINT") + count("ADVANCED_FACE"), count("EDGE_CURVE") + 2);
    for format in [Format::Stl, Format::ThreeMf, Format::Glb, Format::Obj, Format::Ply] {
        assert!(!write(&design, format, &Making::default()).unwrap().is_empty());
    }
    let error = write(&design, Format::Svg, &Making::default()).unwrap_err();
    assert_eq!(error.code(), Code::UnsupportedShape, "{error}");
    // What is drawn is the network as it was, whatever its wall.
    let bare = Design::parse(&json!({ "pasu": 1, "parts": [{ "shape": half_tube(1.0, 3) }] }).to_string()).unwrap();
    let mesh = |design: &Design| pasu::mesh(design, &pasu::MeshOptions::default()).unwrap().positions;
    assert_eq!(mesh(&design), mesh(&bare));
}

#[test]
fn networks_of_any_topology_get_a_thin_wall_or_a_reason() {
    let mut n_made = 0;
    for seed in 0..15 {
        let mut dice = Dice(seed);
        let wraps = [Wrap::Free, Wrap::Joined, Wrap::Reversed];
        let round = wraps[dice.below(3)];
        let mut net = Net::grid(2 + dice.below(2), 4, Wrap::Free, round, &mut dice, false);
        for at in &mut net.vertices {
            // Not too steep; and what is joined goes round.
            at[2] *= 0.2;
            if round == Wrap::Joined {
                let (s, c) = (core::f64::consts::TAU * at[1] / 8.0).sin_cos();
                *at = [at[0], (3.0 + at[2]) * c, (3.0 + at[2]) * s];
            }
        }
        let design = walled(&net.shape(&json!("global")), 0.04, &json!({}));
        match solid(&design, &Making::default()) {
            Ok(_) => {
                n_made += 1;
                let [surface, _, volume, of_mesh] = clay_within(&design, 0.01);
                // A sheet that is bent holds as much on one side as it lacks on the other, nearly.
                assert!((volume / (0.04 * surface) - 1.0).abs() < 0.15, "{seed}: {volume} of {surface}");
                assert!((of_mesh / volume - 1.0).abs() < 0.4, "{seed}: {of_mesh}, not {volume}");
            }
            Err(_) => {
                let error = refusal(&design);
                let is_one_sided = error.code() == Code::OpenSurface;
                assert!(is_one_sided || error.place().is_some(), "{seed}: {error}");
                assert_eq!(is_one_sided, round == Wrap::Reversed, "{seed}: {error}");
            }
        }
    }
    assert!(n_made >= 6, "{n_made} made");
}

#[test]
fn a_wall_that_is_too_thick_for_a_sheet_is_no_fault_of_the_sheet() {
    let sheet = patch([
        [0.0, 0.0, 0.0],
        [0.5, 0.0, 0.2],
        [1.0, 0.0, 0.0],
        [1.0, 0.5, 0.0],
        [1.0, 1.0, 0.0],
        [0.5, 1.0, 0.2],
        [0.0, 1.0, 0.0],
        [0.0, 0.5, 0.3],
    ]);
    let narrow = json!({ "place": { "scale": [0.5586846733931452, 0.12785151733551173, 0.7365652267821133] } });
    assert!(solid(&walled(&sheet, 0.055, &narrow), &Making::default()).is_ok());
    let refused = |design: &Design| solid(design, &Making::default()).unwrap_err();
    let thick = refused(&walled(&sheet, 0.06, &narrow));
    assert_eq!((thick.code(), thick.path()), (Code::NoRoom, "parts[0].wall.thickness"), "{thick}");
    assert!(thick.place().is_some() && thick.to_string().contains("has no room"), "{thick}");

    // Two sheets that go through each other do so with any wall, on either side.
    let across = [(0.0, -1.0), (0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (2.0, 1.0), (2.0, 0.0), (2.0, -1.0), (1.0, -1.0)];
    let vertices: Vec<[f64; 3]> =
        across.iter().map(|(x, y)| [*x, *y, 0.0]).chain(across.iter().map(|(x, z)| [*x + 0.3, 0.1, *z])).collect();
    let crossing = json!({ "kind": "vertex-frame", "vertices": vertices,
        "patches": [{ "frame": [0, 1, 2, 3, 4, 5, 6, 7] }, { "frame": [8, 9, 10, 11, 12, 13, 14, 15] }] });
    for side in ["inside", "outside"] {
        let error = refused(&walled(&crossing, 0.05, &json!({ "wall": { "side": side } })));
        assert_eq!((error.code(), error.path()), (Code::CrossesItself, "parts[0].shape"), "{error}");
    }
}

#[test]
fn where_a_wall_cannot_be_made_one_is_offered_that_can() {
    let offered = |design: &Design| {
        let report = check(design, &Making::default()).unwrap();
        let remedy = report.findings[0].remedy.clone().unwrap_or_else(|| panic!("{:?}", report.findings));
        assert_eq!(remedy.path, "parts[0].wall");
        let mut document: Value = serde_json::from_str(&design.to_json()).unwrap();
        document["parts"][0]["wall"] = serde_json::to_value(remedy.wall).unwrap();
        let mended = check(&Design::parse(&document.to_string()).unwrap(), &Making::default()).unwrap();
        assert!(mended.is_ok() && mended.findings.iter().all(|found| found.remedy.is_none()), "{:?}", mended.findings);
        (remedy.wall, remedy.message)
    };
    // Inside of a tube there is room up to its axis, outside there is.
    let (wall, message) = offered(&walled(&half_tube(1.0, 4), 1.2, &json!({})));
    assert_eq!((wall.side, wall.thickness), (pasu::Side::Outside, 1.2), "{message}");
    // Two sheets are in each other's way on both sides.
    let mut vertices = Vec::new();
    let places = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0), (0.0, 2.0), (0.0, 1.0)];
    for z in [0.0, 0.1, 0.2] {
        vertices.extend(places.map(|(x, y)| [x, y, z]));
    }
    let stack = |n: usize| {
        let patches: Vec<Value> = (0..n).map(|k| json!({ "frame": (8 * k..8 * k + 8).collect::<Vec<_>>() })).collect();
        json!({ "kind": "vertex-frame", "vertices": vertices[..8 * n], "patches": patches })
    };
    let (wall, message) = offered(&walled(&stack(3), 0.12, &json!({})));
    assert_eq!(
        (wall.side, wall.thickness, &*message),
        (pasu::Side::Inside, 0.09, "it can be made with a wall of 0.09")
    );
    // What belongs to a foot goes.
    let footed = json!({ "wall": { "base": 0.3, "foot": [0.1, 0.1], "drain": 0.2, "rim": "rounded" } });
    let (wall, message) = offered(&walled(&stack(1), 0.12, &footed));
    assert_eq!((wall.base, wall.foot, wall.drain, wall.rim), (0.0, None, 0.0, pasu::RimForm::Flat));
    assert_eq!(message, "it can be made with a base of 0 and a flat rim and no ring and no drain");
    // Where the sheet itself is at fault no wall helps.
    let report = check(&walled(&cube(), 0.1, &json!({})), &Making::default()).unwrap();
    assert!(report.findings[0].remedy.is_none(), "{:?}", report.findings);
}

#[test]
fn what_cannot_have_its_thickness_is_refused_with_the_place() {
    let at = |x: f64, y: f64, z: f64| [x, y, z];
    // Two flat patches along the edge x = 0, folded back on each other.
    let folded = |rise: f64| {
        let mut vertices = Vec::new();
        for (x, z) in [(2.0, rise), (1.0, rise / 2.0), (0.0, 0.0), (1.0, -rise / 2.0), (2.0, -rise)] {
            vertices.extend([0.0, 1.0, 2.0].map(|y| at(x, y, z)));
        }
        let frame = |k: usize| {
            [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)].map(|(i, j)| 3 * (2 * k + i) + j)
        };
        json!({ "kind": "vertex-frame", "vertices": vertices, "patches": [{ "frame": frame(0) }, { "frame": frame(1) }] })
    };
    let sharp = refusal(&walled(&folded(0.2), 0.05, &json!({})));
    assert_eq!((sharp.code(), sharp.path()), (Code::NoRoom, "parts[0].wall.thickness"), "{sharp}");
    assert!(sharp.place().unwrap()[0].abs() < 1e-12, "on the crease: {sharp}");
    assert!(solid(&walled(&folded(2.0), 0.05, &json!({})), &Making::default()).is_ok());

    // A tube of radius 1 with a wall that reaches beyond its axis.
    let thick = refusal(&walled(&half_tube(1.0, 4), 1.2, &json!({})));
    assert_eq!((thick.code(), thick.path()), (Code::NoRoom, "parts[0].wall.thickness"), "{thick}");
    assert!(thick.place().is_some(), "{thick}");

    // Two sheets that have one corner in common.
    let square = |x: f64, y: f64| {
        [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)]
            .map(|(i, j)| at(x + f64::from(i), y + f64::from(j), 0.0))
    };
    let mut vertices = square(0.0, 0.0).to_vec();
    vertices.extend(&square(2.0, 2.0)[1..]);
    let touching = json!({ "kind": "vertex-frame", "vertices": vertices,
        "patches": [{ "frame": [0, 1, 2, 3, 4, 5, 6, 7] }, { "frame": [4, 8, 9, 10, 11, 12, 13, 14] }] });
    let touching = refusal(&walled(&touching, 0.1, &json!({})));
    assert_eq!((touching.code(), touching.place()), (Code::CrossesItself, Some([2.0, 2.0, 0.0])), "{touching}");

    for (field, value) in
        [("base", json!(0.1)), ("rim", json!("rounded")), ("foot", json!([0.1, 0.1])), ("drain", json!(0.1))]
    {
        let error = refusal(&walled(&half_tube(1.0, 4), 0.1, &json!({ "wall": { field: value } })));
        assert_eq!(
            (error.code(), error.path()),
            (Code::UnsupportedShape, &*format!("parts[0].wall.{field}")),
            "{error}"
        );
    }
    // What closes is a solid as it is.
    let error = solid(&walled(&cube(), 0.1, &json!({})), &Making::default()).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::UnsupportedShape, "parts[0].wall"), "{error}");
    assert_eq!(error.arg("what"), Some(&"closes".into()));
}

#[test]
fn a_shell_stands_in_a_scene_as_the_body_that_it_is() {
    let scene = |x: f64| {
        let sheet = json!({ "shape": box_without(5), "wall": { "thickness": 0.2, "base": 0 } });
        let ball = json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "scale": [0.5, 0.5, 0.5], "shift": [x, 0, 0] } });
        let design = json!({ "pasu": 1, "parts": [sheet, ball] });
        pasu::constraints(&Design::parse(&design.to_string()).unwrap(), None).unwrap()
    };
    // A ball in the middle of the box is as far from its wall as that is from the outside less its thickness; without a wall it is farther.
    let breach = scene(0.0).breaches.remove(0);
    let (code, away) = (breach.code, breach.distance.expect("they do not touch"));
    assert!(code == "not-connected" && (0.2..=0.3 + 1e-9).contains(&away), "{away}");
    // And touches it where it reaches into it.
    assert!(scene(0.35).is_kept, "{:?}", scene(0.35));
}
