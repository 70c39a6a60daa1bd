//! The mesh contract, orientation, poles and tolerance.

use std::collections::HashMap;

use crate::support::{corpus, design, design_of, design_of_case};
use glam::{DVec3, Vec3};
use pasu::{Design, Mesh, MeshOptions, Surface, mesh};

fn grid(rows: usize, columns: usize) -> MeshOptions {
    MeshOptions { rows: Some(rows), columns: Some(columns), tolerance: None }
}

fn vertex(mesh: &Mesh, i: u32) -> DVec3 {
    Vec3::from_slice(&mesh.positions[3 * i as usize..]).as_dvec3()
}

fn normal(mesh: &Mesh, i: u32) -> DVec3 {
    Vec3::from_slice(&mesh.normals[3 * i as usize..]).as_dvec3()
}

/// A wall of order 2 through circles of two radii, heights 0 and 2, `u` from foot to rim or from rim to foot.
fn lathe(start: f64, end: f64, heights: [f64; 2]) -> String {
    let circle = |part: &str| {
        format!(
            r#"{{ "order": 2, "s": 1, "t": 0, "modes": [{{ "n": 1, "{part}": {{ "start": {start}, "end": {end} }} }}] }}"#
        )
    };
    format!(
        r#"{{ "kind": "boundary-value", "span": "2pi", "x": {}, "y": {},
              "z": {{ "order": 2, "s": 1, "t": 0, "modes": [{{ "n": 0, "cos": {{ "start": {}, "end": {} }} }}] }} }}"#,
        circle("cos"),
        circle("sin"),
        heights[0],
        heights[1]
    )
}

#[test]
fn every_figure_keeps_the_contract() {
    for case in corpus() {
        let design = design_of_case(&case);
        for options in [grid(2, 4), grid(17, 31), MeshOptions::default()] {
            let mesh = mesh(&design, &options).unwrap_or_else(|e| panic!("{}: {e}", case.name));
            mesh.validate().unwrap_or_else(|e| panic!("{}: {e}", case.name));
        }
    }
}

#[test]
fn positions_are_the_surface() {
    for case in corpus() {
        let design = design_of_case(&case);
        let surface = Surface::of_part(&design.parts()[0], 0).unwrap();
        let (rows, columns) = (9, 14);
        let rounded_once = MeshOptions { tolerance: Some(1e30), ..grid(rows, columns) };
        for (options, in_parts) in [(grid(rows, columns), 5e-7), (rounded_once, 6e-8)] {
            let mesh = mesh(&design, &options).unwrap();
            let largest = mesh.positions.iter().fold(0.0f32, |m, x| m.max(x.abs()));
            for i in 0..rows {
                for j in 0..columns {
                    let (u, v) = (i as f64 / (rows - 1) as f64, surface.span() * j as f64 / (columns - 1) as f64);
                    let exact = surface.at(u, v).position;
                    let found = vertex(&mesh, (i * columns + j) as u32);
                    let allowed = in_parts * f64::from(largest) + 1e-12 * case.scale;
                    assert!((found - exact).abs().max_element() <= allowed, "{} row {i} column {j}", case.name);
                }
            }
        }
    }
}

#[test]
fn the_seam_has_the_same_bits() {
    for case in corpus() {
        let design = design_of_case(&case);
        assert!(Surface::of_part(&design.parts()[0], 0).unwrap().is_closed());
        let columns = 37;
        let mesh = mesh(&design, &grid(11, columns)).unwrap();
        for i in 0..11 {
            let (a, b) = (3 * i * columns, 3 * (i * columns + columns - 1));
            assert_eq!(mesh.positions[a..a + 3], mesh.positions[b..b + 3], "{} row {i}", case.name);
            assert_eq!(mesh.normals[a..a + 3], mesh.normals[b..b + 3], "{} row {i}", case.name);
        }
    }
}

#[test]
fn welded_at_the_seam_a_wall_is_a_cylinder() {
    let mesh = mesh(&design_of(&lathe(1.0, 0.5, [0.0, 2.0])), &grid(12, 25)).unwrap();
    let mut vertices = HashMap::new();
    let mut welded = Vec::new();
    for i in 0..mesh.n_vertices() {
        let key: Vec<u32> = mesh.positions[3 * i..3 * i + 3].iter().map(|x| x.to_bits()).collect();
        let next = vertices.len();
        welded.push(*vertices.entry(key).or_insert(next));
    }
    let mut edges: HashMap<(usize, usize), i32> = HashMap::new();
    for triangle in mesh.indices.chunks_exact(3) {
        for k in 0..3 {
            let (a, b) = (welded[triangle[k] as usize], welded[triangle[(k + 1) % 3] as usize]);
            *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
        }
    }
    let characteristic = vertices.len() as i64 - edges.len() as i64 + mesh.n_triangles() as i64;
    assert_eq!(characteristic, 0, "an annulus");
    // Edges inside the wall are walked once each way; 24 at rim and 24 at foot are walked once.
    assert_eq!(edges.values().filter(|&&n| n != 0).count(), 48);
}

#[test]
fn outside_is_outside() {
    let out = |design: &Design, what: &str| {
        let mesh = mesh(design, &grid(9, 40)).unwrap();
        for triangle in mesh.indices.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|k| vertex(&mesh, triangle[k]));
            let facing = (b - a).cross(c - a);
            for &corner in triangle {
                assert!(facing.dot(normal(&mesh, corner)) > 0.0, "{what}: winding against the normal");
            }
            let arm = (a + b + c) / 3.0;
            assert!(facing.x * arm.x + facing.y * arm.y > 0.0, "{what}: inward");
        }
    };
    for (name, shape) in [
        ("foot first", lathe(1.0, 1.5, [0.0, 2.0])),
        ("rim first", lathe(1.5, 1.0, [2.0, 0.0])),
        ("negative radius", lathe(-1.5, -1.0, [2.0, 0.0])),
    ] {
        out(&design_of(&shape), name);
        let mirrored =
            format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "place": {{ "scale": [1, -2, 3] }} }}] }}"#);
        out(&design(&mirrored), &format!("{name}, mirrored"));
    }
}

#[test]
fn normals_are_exact() {
    // Cone: the normal leans by the slope of the wall.
    let mesh = mesh(&design_of(&lathe(1.0, 2.0, [0.0, 2.0])), &grid(5, 33)).unwrap();
    for i in 0..mesh.n_vertices() as u32 {
        let (position, normal) = (vertex(&mesh, i), normal(&mesh, i));
        let radius = position.truncate().length();
        let expected = DVec3::new(2.0 * position.x / radius, 2.0 * position.y / radius, -1.0).normalize();
        assert!((normal - expected).length() < 1e-6, "{normal} {expected}");
    }
}

#[test]
fn poles_and_cusps_have_normals() {
    // A cone closed in a point: the limit of each meridian.
    let cone = mesh(&design_of(&lathe(0.0, 1.0, [0.0, 1.0])), &grid(4, 9)).unwrap();
    for j in 0..9 {
        let turn = std::f64::consts::TAU * f64::from(j) / 8.0;
        let expected = DVec3::new(turn.cos(), turn.sin(), -1.0) / 2f64.sqrt();
        assert!((normal(&cone, j) - expected).length() < 1e-6);
    }
    // A bowl with a smooth bottom: the wall leaves the pole level.
    let bowl = r#"{ "kind": "boundary-value", "span": "2pi",
        "x": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{ "n": 1, "cos": { "start": 0, "start_u": 1, "end": 1, "end_u": 1 } }] },
        "y": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{ "n": 1, "sin": { "start": 0, "start_u": 1, "end": 1, "end_u": 1 } }] },
        "z": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{ "n": 0, "cos": { "start": 0, "start_u": 0, "end": 1, "end_u": 2 } }] } }"#;
    let bowl = mesh(&design_of(bowl), &grid(4, 9)).unwrap();
    for j in 0..9 {
        assert!((normal(&bowl, j) + DVec3::Z).length() < 1e-6, "{}", normal(&bowl, j));
    }
    // A plate with petals whose modes meet 0 only by cancellation: the pole is still one point, and its normal that of the rows beside it.
    let datum = |n: u32, start_u: f64, end: f64| format!(r#""start_u": {start_u}, "end": {end}, "end_u": {n}"#);
    let component = |part: &str| {
        let modes: Vec<String> = [(1, 20.0, 13.0), (11, 0.0, 0.4), (13, 0.0, -0.4)]
            .map(|(n, start_u, end)| format!(r#"{{ "n": {n}, "{part}": {{ {} }} }}"#, datum(n, start_u, end)))
            .to_vec();
        format!(r#"{{ "order": 4, "s": 1, "t": 2, "w": 1, "modes": [{}] }}"#, modes.join(","))
    };
    let plate = format!(
        r#"{{ "kind": "boundary-value", "span": "2pi", "x": {}, "y": {},
              "z": {{ "order": 4, "s": 1, "t": 2, "w": 1, "modes": [{{ "n": 0, "cos": {{ "end": 2, "end_u": 5 }} }}] }} }}"#,
        component("cos"),
        component("sin")
    );
    let plate = mesh(&design_of(&plate), &grid(33, 97)).unwrap();
    for j in 0..97 {
        assert_eq!(vertex(&plate, j), DVec3::ZERO);
        assert!((normal(&plate, j) + DVec3::Z).length() < 1e-6, "{}", normal(&plate, j));
    }
    // A cusp: the wall stands still at the rim (X_u = 0), and the normal is that of the wall below it.
    let cusp = bowl_with_cusp();
    let cusp = mesh(&design_of(&cusp), &grid(4, 9)).unwrap();
    cusp.validate().unwrap();
    for j in 0..9 {
        let at = vertex(&cusp, j).truncate();
        assert!(normal(&cusp, j).truncate().dot(at) > 0.9, "{}", normal(&cusp, j));
    }
    // Nothing but a point, and nothing but a circle.
    for shape in [lathe(0.0, 0.0, [1.0, 1.0]), lathe(1.0, 1.0, [1.0, 1.0]), lathe(0.0, 0.0, [0.0, 1.0])] {
        mesh(&design_of(&shape), &grid(4, 9)).unwrap().validate().unwrap();
    }
}

fn bowl_with_cusp() -> String {
    let wall = |part: &str| {
        format!(
            r#"{{ "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{{ "n": 1, "{part}": {{ "start": 1, "end": 1 }} }}] }}"#
        )
    };
    format!(
        r#"{{ "kind": "boundary-value", "span": "2pi", "x": {}, "y": {},
              "z": {{ "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{{ "n": 0, "cos": {{ "start": 2 }} }}] }} }}"#,
        wall("cos"),
        wall("sin")
    )
}

#[test]
fn options_out_of_range_are_refused() {
    let design = design_of(&lathe(1.0, 1.5, [0.0, 2.0]));
    let refused = |options: MeshOptions| {
        let error = mesh(&design, &options).expect_err("refused");
        (error.code().as_str(), error.path().to_owned(), error.message().to_owned())
    };
    let tolerance = |tolerance: f64| MeshOptions { tolerance: Some(tolerance), ..MeshOptions::default() };
    assert_eq!(refused(grid(1, 10)).0, "out-of-range");
    assert_eq!(refused(grid(10, 3)).1, "columns");
    assert_eq!(refused(grid(usize::MAX, 10)).0, "out-of-range");
    assert_eq!(refused(grid(4001, 4001)).0, "too-large");
    for nonsense in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refused(tolerance(nonsense)).0, "out-of-range");
    }
    assert_eq!(refused(tolerance(1e-9)).0, "tolerance-too-fine");
    assert_eq!(refused(tolerance(1e-300)).0, "tolerance-too-fine");
    assert_eq!(refused(MeshOptions { tolerance: Some(0.01), ..grid(2, 6) }).0, "tolerance-too-fine");
    let huge = design_of(&lathe(1e39, 1e39, [0.0, 2.0]));
    assert_eq!(mesh(&huge, &grid(4, 9)).unwrap_err().code().as_str(), "overflow");
    assert!(mesh(&huge, &MeshOptions::default()).is_err());
}

#[test]
fn rows_or_columns_alone_are_completed() {
    let design = design_of(&lathe(1.0, 1.5, [0.0, 2.0]));
    let rows = mesh(&design, &MeshOptions { rows: Some(7), ..MeshOptions::default() }).unwrap();
    assert_eq!(rows.n_vertices() % 7, 0);
    let columns = mesh(&design, &MeshOptions { columns: Some(50), ..MeshOptions::default() }).unwrap();
    assert_eq!(columns.n_vertices() % 50, 0);
}
