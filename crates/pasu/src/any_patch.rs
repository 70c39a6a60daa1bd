//! What is made of patches asks nothing of what they are: kinds that the solver does not have are meshed within a tolerance, measured and written as STEP.

use core::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use crate::design::Design;
use crate::export::Format;
use crate::make::Making;
use crate::measure::{MeasureOptions, Measures};
use crate::mesh::{Mesh, MeshOptions};
use crate::patch::examples::{Eighth, Torus, cube, gutter, saddle};
use crate::patch::{Cell, Patch};
use crate::solid::Product;
use crate::solution::{Solution, Solved};

const TORUS: Torus = Torus { radius: 2.0, tube: 0.75 };

fn examples() -> Vec<(&'static str, Vec<Box<dyn Patch>>)> {
    vec![
        ("saddle", vec![Box::new(saddle())]),
        ("gutter", vec![Box::new(gutter())]),
        ("torus", vec![Box::new(TORUS)]),
        ("eighth of a sphere", vec![Box::new(Eighth { radius: 1.5 })]),
        ("cube", cube()),
    ]
}

/// Patches where a design has a vase, placed as its part says.
fn solution(patches: Vec<Box<dyn Patch>>, place: &str) -> Solution {
    let text = format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] }}, "place": {{ {place} }} }}] }}"#
    );
    Solution::with(&Design::parse(&text).unwrap(), vec![Solved::Patches(patches)])
}

const TURNED: &str = r#""axis": [1, 2, 2], "angle": 0.8, "shift": [3, -2, 5]"#;

#[test]
fn derivatives_are_those_of_the_patch_and_suprema_exceed_them() {
    for (name, patches) in examples() {
        for patch in &patches {
            let whole = Cell { u: [0.0, 1.0], v: [0.0, 1.0] };
            let part = Cell { u: [0.25, 0.5], v: [0.5, 1.0] };
            let (stretch, h) = ([1.0, 2.0, 0.5], 1e-5);
            let [of_whole, of_part] = [whole, part].map(|cell| patch.suprema(cell, stretch));
            assert!(of_part.uu <= of_whole.uu && of_part.uv <= of_whole.uv && of_part.vv <= of_whole.vv, "{name}");
            for k in 0..81 {
                let (u, v) = (0.05 + 0.9 * f64::from(k / 9) / 8.0, 0.05 + 0.9 * f64::from(k % 9) / 8.0);
                let jet = patch.jet(u, v);
                let along = (patch.jet(u + h, v).position - patch.jet(u - h, v).position) / (2.0 * h);
                let round = (patch.jet(u, v + h).position - patch.jet(u, v - h).position) / (2.0 * h);
                assert!((jet.du - along).length() < 1e-7 && (jet.dv - round).length() < 1e-7, "{name}");
                let twist = (patch.jet(u, v + h).du - patch.jet(u, v - h).du) / (2.0 * h);
                assert!((jet.duv - twist).length() < 1e-6, "{name}");
                let stretched = |v: DVec3| (v * DVec3::from_array(stretch)).length();
                for (length, most) in [
                    (jet.duu, of_whole.uu),
                    (jet.duv, of_whole.uv),
                    (jet.dvv, of_whole.vv),
                    (jet.position, of_whole.size),
                ] {
                    // Where a derivative is 0 everywhere, sums round.
                    assert!(stretched(length) <= most * (1.0 + 1e-12) + 1e-14, "{name}");
                }
            }
        }
    }
}

/// The largest distance between points of triangles and those of the surface with the same parameters.
fn farthest(solution: &Solution, mesh: &Mesh) -> f64 {
    let placed = solution.part(0).unwrap();
    let patches = placed.solved().patches();
    let mut largest = 0.0f64;
    // Each patch begins with its corner (0, 0), which no other vertex of it has.
    let is_corner = |uv: &[f32]| uv[0] == 0.0 && uv[1] == 0.0;
    let corners: Vec<usize> = (0..mesh.n_vertices()).filter(|i| is_corner(&mesh.uvs[2 * i..2 * i + 2])).collect();
    assert_eq!(corners.len(), patches.len());
    for triangle in mesh.indices.chunks_exact(3) {
        let patch = corners.partition_point(|corner| *corner <= triangle[0] as usize) - 1;
        let at = |array: &[f32], n: usize, vertex: u32| {
            let from = n * vertex as usize;
            DVec3::new(
                f64::from(array[from]),
                f64::from(array[from + 1]),
                if n == 3 { f64::from(array[from + 2]) } else { 0.0 },
            )
        };
        for weights in
            [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5], [0.3, 0.3, 0.4], [0.1, 0.2, 0.7]]
        {
            let mean = |array: &[f32], n: usize| {
                triangle.iter().zip(weights).map(|(vertex, weight)| at(array, n, *vertex) * weight).sum::<DVec3>()
            };
            let (point, uv) = (mean(&mesh.positions, 3), mean(&mesh.uvs, 2));
            let exact = placed.place(&patches[patch].jet(uv.x, uv.y)).position;
            largest = largest.max(point.distance(exact));
        }
    }
    largest
}

#[test]
fn a_tolerance_is_held() {
    for (name, patches) in examples() {
        let solution = solution(patches, TURNED);
        for tolerance in [0.1, 0.01, 1e-3] {
            let mesh = solution.mesh(&MeshOptions { tolerance: Some(tolerance), ..MeshOptions::default() }).unwrap();
            mesh.validate().unwrap_or_else(|broken| panic!("{name}: {broken}"));
            let (bound, found) = (mesh.bound.unwrap(), farthest(&solution, &mesh));
            assert!(found <= bound && bound <= tolerance, "{name} {tolerance}: {found} of {bound}");
            assert!(name == "cube" || found > 0.02 * tolerance, "{name} {tolerance}: {found} is finer than was asked");
        }
        // What is finer than single precision is refused.
        let error = solution.mesh(&MeshOptions { tolerance: Some(1e-7), ..MeshOptions::default() }).unwrap_err();
        assert_eq!(error.code().to_string(), "tolerance-too-fine", "{name}");
    }
}

#[test]
fn normals_are_those_of_the_surface_and_limits_at_a_pole() {
    let mesh = solution(vec![Box::new(Eighth { radius: 1.5 })], "").mesh(&MeshOptions::default()).unwrap();
    for (position, normal) in mesh.positions.chunks_exact(3).zip(mesh.normals.chunks_exact(3)) {
        for (p, n) in position.iter().zip(normal) {
            assert!((p / 1.5 - n).abs() < 1e-6, "{position:?} {normal:?}");
        }
    }
}

#[test]
fn what_closes_is_watertight_bit_for_bit() {
    for (name, patches, genus) in [("torus", examples().swap_remove(2).1, 1), ("cube", cube(), 0)] {
        let options = MeshOptions { tolerance: Some(0.01), ..MeshOptions::default() };
        let mesh = solution(patches, TURNED).mesh(&options).unwrap();
        let mut points: Vec<[u32; 3]> = Vec::new();
        let number: Vec<u32> = mesh
            .positions
            .chunks_exact(3)
            .map(|p| [p[0], p[1], p[2]].map(f32::to_bits))
            .map(|p| {
                points.iter().position(|other| *other == p).unwrap_or_else(|| {
                    points.push(p);
                    points.len() - 1
                }) as u32
            })
            .collect();
        let triangles: Vec<[u32; 3]> =
            mesh.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(|vertex| number[vertex as usize])).collect();
        let topology = crate::check::closed(&triangles, points.len());
        assert_eq!(topology.unwrap_or_else(|at| panic!("{name} is open at {at}")).genus(), genus, "{name}");
    }
}

fn measured(patches: Vec<Box<dyn Patch>>, place: &str) -> Measures {
    let options = MeasureOptions { product: Product::Solid, ..MeasureOptions::default() };
    solution(patches, place).measure(&options).unwrap()
}

#[test]
fn measures_are_those_of_the_formulas() {
    let near = |name: &str, found: f64, expected: f64| {
        assert!((found - expected).abs() <= 1e-10 * expected.abs().max(1.0), "{name}: {found}, expected {expected}");
    };
    for place in ["", TURNED] {
        // The integral of sqrt(1 + u^2 + v^2) over the unit square.
        let s = 3f64.sqrt();
        let saddle_area = s / 3.0 + 4.0 / 3.0 * 0.5f64.sqrt().asinh() - (1.0 / s).atan() / 3.0;
        near("saddle", measured(vec![Box::new(saddle())], place).parts[0].body.area.value, saddle_area);
        // The length of a parabola.
        let gutter_area = 5f64.sqrt() / 2.0 + 2f64.asinh() / 4.0;
        near("gutter", measured(vec![Box::new(gutter())], place).parts[0].body.area.value, gutter_area);
        let eighth = measured(vec![Box::new(Eighth { radius: 1.5 })], place);
        near("eighth", eighth.parts[0].body.area.value, FRAC_PI_2 * 1.5 * 1.5);
        assert!(eighth.parts[0].body.clay.is_none(), "a shell without thickness is no clay");
        let torus = &measured(vec![Box::new(TORUS)], place).parts[0].body;
        near("torus", torus.area.value, 4.0 * PI * PI * TORUS.radius * TORUS.tube);
        let clay = torus.clay.unwrap();
        near("torus", clay.volume.value, 2.0 * PI * PI * TORUS.radius * TORUS.tube * TORUS.tube);
        let centre = torus.centre.empty.unwrap().at;
        let expected = if place.is_empty() { [0.0; 3] } else { [3.0, -2.0, 5.0] };
        centre.iter().zip(expected).for_each(|(found, expected)| near("torus", *found, expected));
        let cube = &measured(cube(), place).parts[0].body;
        near("cube", cube.area.value, 24.0);
        near("cube", cube.clay.unwrap().volume.value, 8.0);
    }
    // Heights and widths, also of what is open.
    let eighth = &measured(vec![Box::new(Eighth { radius: 1.5 })], "").parts[0].body;
    near("eighth", eighth.height.value, 1.5);
    let saddle = &measured(vec![Box::new(saddle())], "").parts[0].body;
    near("saddle", saddle.height.value, 1.0);
    let torus = &measured(vec![Box::new(TORUS)], "").parts[0].body;
    near("torus", torus.height.value, 1.5);
    near("torus", torus.width.greatest.value, 5.5);
}

#[test]
fn step_holds_shells_and_solids() {
    for (name, patches) in examples() {
        let n = patches.len();
        let making = Making { product: Product::Solid, ..Making::default() };
        let file = String::from_utf8(solution(patches, TURNED).write(Format::Step, &making).unwrap()).unwrap();
        let count = |entity: &str| file.matches(&format!("={entity}(")).count();
        let is_closed = ["torus", "cube"].contains(&name);
        assert_eq!(count("MANIFOLD_SOLID_BREP"), usize::from(is_closed), "{name}");
        assert_eq!(count("SHELL_BASED_SURFACE_MODEL"), usize::from(!is_closed), "{name}");
        assert_eq!(count("ADVANCED_FACE"), n, "{name}");
        // Euler: V - E + F.
        let expected = match name {
            "torus" => (1, 2),
            "cube" => (8, 12),
            "eighth of a sphere" => (3, 3),
            _ => (4, 4),
        };
        assert_eq!((count("VERTEX_POINT"), count("EDGE_CURVE")), expected, "{name}");
        let deviation = file.split("pasu-deviation: ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
        let deviation: f64 = deviation.trim_end_matches('.').parse().unwrap();
        // A hundred-thousandth of a few centimetres.
        assert!(deviation <= 6e-4, "{name}: {deviation}");
    }
}

#[test]
fn what_has_no_foot_and_no_rim_is_refused_in_words_where_a_pot_is_asked_for() {
    let solution = solution(vec![Box::new(TORUS)], "");
    let error = solution.pot(0, Product::Solid).unwrap_err();
    assert_eq!((error.code().to_string().as_str(), error.path()), ("open-surface", "parts[0].shape"));
    let open = self::solution(vec![Box::new(saddle())], "");
    let error = open.write(Format::Stl, &Making { product: Product::Solid, ..Making::default() }).unwrap_err();
    assert_eq!((error.code().to_string().as_str(), error.path()), ("open-surface", "parts[0].shape.patches[0]"));
    assert!(error.message().starts_with("the side u = 0 of patch 0 is free, at (0, 0.5, 0)"), "{error}");
}

#[test]
fn what_goes_round_a_body_is_made_as_it_is() {
    for (name, patches, genus) in [("torus", examples().swap_remove(2).1, 1), ("cube", cube(), 0)] {
        let solution = solution(patches, TURNED);
        for making in [Making::default(), Making { tolerance: Some(0.01), shrinkage: 10.0, ..Making::default() }] {
            let report = solution.check(&making).unwrap();
            assert!(report.is_ok() && report.meshes[0].genus == Some(genus), "{name} {report:?}");
            assert!(making.tolerance.is_none_or(|tolerance| report.meshes[0].bound <= tolerance), "{name}");
            for format in
                [Format::Stl, Format::ThreeMf, Format::Glb, Format::Obj, Format::ObjZip, Format::Ply, Format::Step]
            {
                assert!(solution.write(format, &making).unwrap().len() > 600, "{name} {format:?}");
            }
            let error = solution.write(Format::Svg, &making).unwrap_err();
            assert_eq!(error.code().to_string(), "unsupported-shape", "{name}");
        }
    }
}
