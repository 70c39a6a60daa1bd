//! What is made of networks of vertex-frames: meshes, solids, normals.

use glam::DVec3;
use pasu::{Code, Design, Format, Making, MeshOptions, Product};
use serde_json::json;

use crate::support::design_of;
use crate::support::networks::{Dice, Net, Wrap, cube, cubes_at_random, edges, farthest, measured, polycube, torus};
use crate::support::random::drawn;

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

#[test]
fn bodies_that_branch_are_solids_of_their_volume() {
    let (mut made, mut refused) = (0, 0);
    for seed in 300..340 {
        let mut dice = Dice(seed);
        let cubes = cubes_at_random(2 + dice.below(5), &mut dice);
        let mut net = polycube(&cubes, &mut dice);
        let design = design_of(&net.shape(&json!("global")).to_string());
        let options = MeshOptions { tolerance: Some(0.02), ..MeshOptions::default() };
        if let Err(error) = pasu::mesh(&design, &options) {
            // Two cubes that touch along an edge alone have four faces there.
            assert_eq!(error.code(), Code::CrossesItself, "{seed} {error}");
            refused += 1;
            continue;
        }
        made += 1;
        let body = &measured(&design).parts[0].body;
        let (volume, area) = (body.clay.unwrap().volume.value, body.area.value);
        let expected = (8.0 * cubes.len() as f64, 4.0 * net.patches.len() as f64);
        assert!((volume - expected.0).abs() < 1e-9 && (area - expected.1).abs() < 1e-9, "{seed} {volume} {area}");
        // Bent, they are as closed.
        for at in &mut net.vertices {
            *at = at.map(|x| x + 0.15 * dice.number());
        }
        let design = design_of(&net.shape(&json!("global")).to_string());
        let mesh = pasu::mesh(&design, &options).unwrap();
        mesh.validate().unwrap();
        assert!(edges(&mesh).iter().all(|times| *times == 2), "{seed}");
        assert!(farthest(&design, &mesh) <= 0.02 && measured(&design).parts[0].body.clay.unwrap().volume.value > 0.0);
    }
    assert!(made >= 20 && refused >= 1, "{made} {refused}");
}

/// The corners at the end of a patch were not asked how far out they are, and beside steep ones no place was near enough: widths, tops and bottoms of 29 of these 400 networks were told too small, by up to 0.014.
#[test]
fn no_corner_of_a_random_network_is_beyond_what_is_told() {
    const N: usize = 24;
    for seed in 0..drawn(40, 400) {
        let mut dice = Dice(seed);
        let n_cubes = 1 + dice.below(4);
        let mut net = polycube(&cubes_at_random(n_cubes, &mut dice), &mut dice);
        for vertex in &mut net.vertices {
            *vertex = vertex.map(|x| x + 0.25 * dice.number());
        }
        let design = design_of(&net.shape(&json!("global")).to_string());
        let places = (0..net.patches.len()).flat_map(|patch| {
            (0..=N).flat_map(move |i| (0..=N).map(move |j| [patch as f64, i as f64 / N as f64, j as f64 / N as f64]))
        });
        let at: Vec<f64> = places.flatten().collect();
        let found = pasu::evaluate(&design, 0, &at).unwrap();
        let points: Vec<DVec3> = found.chunks_exact(3).map(DVec3::from_slice).collect();
        let body = &measured(&design).parts[0].body;
        let most = |direction: DVec3| points.iter().map(|p| p.dot(direction)).fold(f64::MIN, f64::max);
        for (told, reach) in [(body.top, most(DVec3::Z)), (-body.bottom, most(-DVec3::Z))] {
            assert!(reach <= told + 1e-12 && told - reach < 0.02, "seed {seed}: told {told}, there {reach}");
        }
        let across = |degrees: f64| {
            let direction = DVec3::new(degrees.to_radians().cos(), degrees.to_radians().sin(), 0.0);
            most(direction) + most(-direction)
        };
        let width = &body.width;
        for (told, direction) in [(width.least, width.least_direction), (width.greatest, width.greatest_direction)] {
            let there = across(direction);
            assert!(there <= told.value + told.error + 1e-9, "seed {seed}: told {told:?}, there {there}");
            assert!(told.value - there < 0.02, "seed {seed}: told {told:?}, there {there}");
        }
    }
}
