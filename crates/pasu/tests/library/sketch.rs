//! Pots for the screen: where they are, against the closed meshes of files, and their water, against what is measured.

use crate::support::design;
use pasu::{Design, FaceKind, Making, MeasureOptions, Sketch, SketchOptions, drawn, measure, sketch, water};

type Point = [f64; 3];

fn with_wall(shape: &str, wall: &str) -> Design {
    design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall} }}] }}"#))
}

const JAR: &str = r#"{ "kind": "fourth-order", "r0": 1.4, "r1": 1.4, "rm": 2.4, "h1": 5, "eta": [0.4, -0.5], "dz": [8, 3], "s": [1, 1], "t": [2, 2], "w": [1, 1] }"#;

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The distance of a point from a triangle (C. Ericson, *Real-time collision detection*, 2005, section 5.1.5).
fn distance(p: Point, [a, b, c]: [Point; 3]) -> f64 {
    let (ab, ac) = (minus(b, a), minus(c, a));
    let far = |q: Point| dot(minus(p, q), minus(p, q)).sqrt();
    let on = |from: Point, along: Point, share: f64| [0, 1, 2].map(|i| from[i] + share * along[i]);
    let edge = |from: Point, to: Point| {
        let along = minus(to, from);
        far(on(from, along, (dot(minus(p, from), along) / dot(along, along)).clamp(0.0, 1.0)))
    };
    let (d00, d01, d11) = (dot(ab, ab), dot(ab, ac), dot(ac, ac));
    let (d20, d21) = (dot(minus(p, a), ab), dot(minus(p, a), ac));
    let area = d00 * d11 - d01 * d01;
    let (v, w) = ((d11 * d20 - d01 * d21) / area, (d00 * d21 - d01 * d20) / area);
    if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
        return far([0, 1, 2].map(|i| a[i] + v * ab[i] + w * ac[i]));
    }
    edge(a, b).min(edge(b, c)).min(edge(c, a))
}

/// The triangles of the faces of a kind.
fn triangles(positions: &[f32], indices: &[u32], ranges: impl Iterator<Item = (usize, usize)>) -> Vec<[Point; 3]> {
    let corner = |vertex: u32| [0, 1, 2].map(|i| f64::from(positions[3 * vertex as usize + i]));
    ranges
        .flat_map(|(first, count)| indices[first..first + count].chunks(3))
        .map(|t| [0, 1, 2].map(|k| corner(t[k])))
        .collect()
}

fn of_kind(sketch: &Sketch, kind: FaceKind) -> Vec<[Point; 3]> {
    let faces = sketch.faces.iter().filter(|face| face.kind == kind).map(|face| (face.first, face.count));
    triangles(&sketch.positions, &sketch.indices, faces)
}

/// The largest distance of a corner of some triangles from the others.
fn apart(some: &[[Point; 3]], others: &[[Point; 3]]) -> f64 {
    let corners = some.iter().flatten().step_by(5);
    corners.map(|p| others.iter().map(|t| distance(*p, *t)).fold(f64::INFINITY, f64::min)).fold(0.0, f64::max)
}

#[test]
fn a_sketch_is_within_its_tolerance_of_what_is_made() {
    for (shape, wall) in [
        (JAR, r#"{ "thickness": 0.2, "base": 0.3 }"#),
        (JAR, r#"{ "thickness": 0.2, "base": 0.3, "rim": "rounded", "foot": [0.3, 0.15], "drain": 0.4 }"#),
        (JAR, r#"{ "thickness": 0.2, "base": 0.3, "side": "outside" }"#),
        (JAR, r#"{ "thickness": 0.2, "base": 0 }"#),
        (JAR, r#"{ "thickness": 1.2, "base": 0.3 }"#),
    ] {
        let design = with_wall(shape, wall);
        let fine = drawn(&design, &Making { tolerance: Some(0.002), ..Making::default() }).expect("a pot");
        let surface = if wall.contains("outside") { FaceKind::Lining } else { FaceKind::Outer };
        for tolerance in [0.01, 0.05] {
            let options = SketchOptions { tolerance: Some(tolerance), ..SketchOptions::default() };
            let sketch = sketch(&design, &options).expect("a sketch");
            let kinds = |faces: &[pasu::DrawnFace]| faces.iter().map(|face| face.kind).collect::<Vec<_>>();
            let mut expected = kinds(&fine.faces);
            expected.retain(|kind| *kind != surface);
            assert_eq!(kinds(&sketch.faces), expected, "{wall}");
            assert!(sketch.indices.iter().all(|vertex| 3 * (*vertex as usize) < sketch.positions.len()));
            assert_eq!(sketch.normals.len(), sketch.positions.len());
            for kind in expected {
                let faces = fine.faces.iter().filter(|face| face.kind == kind).map(|face| (face.first, face.count));
                let (mine, true_) = (of_kind(&sketch, kind), triangles(&fine.positions, &fine.indices, faces));
                let (there, back) = (apart(&mine, &true_), apart(&true_, &mine));
                assert!(there <= 0.003, "{wall} {kind:?}: a corner of the sketch is {there} from the face");
                assert!(back <= 1.25 * tolerance + 0.002, "{wall} {kind:?}: the face is {back} from the sketch");
            }
        }
    }
}

#[test]
fn parts_without_a_wall_are_passed_over() {
    let wall = r#""wall": { "thickness": 0.2, "base": 0.3 }"#;
    let mixed = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {JAR} }}, {{ "shape": {JAR}, {wall} }}] }}"#));
    let found = sketch(&mixed, &SketchOptions::default()).expect("a sketch");
    assert!(!found.faces.is_empty() && found.faces.iter().all(|face| face.part == 1));
    let bare = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {JAR} }}] }}"#));
    assert_eq!(sketch(&bare, &SketchOptions::default()), Ok(Sketch::default()));
}

#[test]
fn what_cannot_be_a_pot_is_refused_as_files_are() {
    for wall in [r#"{ "thickness": 0.2, "base": 9 }"#, r#"{ "thickness": 0.2, "base": 0, "foot": [0.3, 0.3] }"#] {
        let design = with_wall(JAR, wall);
        let [sketched, made] =
            [sketch(&design, &SketchOptions::default()).map(|_| ()), drawn(&design, &Making::default()).map(|_| ())];
        let (sketched, made) = (sketched.expect_err("no sketch"), made.expect_err("no pot"));
        assert_eq!((sketched.code().as_str(), sketched.path()), (made.code().as_str(), made.path()), "{wall}");
    }
    for fill in [-0.1, 1.5, f64::NAN] {
        let options = SketchOptions { fill: Some(fill), ..SketchOptions::default() };
        let error = sketch(&with_wall(JAR, r#"{ "thickness": 0.2, "base": 0.3 }"#), &options).expect_err("no share");
        assert_eq!((error.code().as_str(), error.path()), ("out-of-range", "fill"));
    }
}

#[test]
fn water_stands_where_it_is_measured() {
    let design = with_wall(JAR, r#"{ "thickness": 0.2, "base": 0.3 }"#);
    let capacity =
        measure(&design, &MeasureOptions::default()).expect("measures").whole.capacity.expect("it holds water");
    for share in [0.0, 0.4, 1.0] {
        let options = SketchOptions { fill: Some(share), ..SketchOptions::default() };
        let found = sketch(&design, &options).expect("a sketch").water.expect("water");
        let [floor, spill] = found.range;
        assert!((floor - capacity.floor).abs() < 1e-9 && (spill - capacity.spill.level.value).abs() < 1e-9);
        assert!((found.level - (floor + share * (spill - floor))).abs() < 1e-9);
        let area: f64 = triangles(&found.positions, &found.indices, std::iter::once((0, found.indices.len())))
            .iter()
            .map(|[a, b, c]| 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])))
            .sum();
        let exact = if share == 0.0 { 0.0 } else { water(&design, found.level - 1e-9).expect("water").area };
        assert!((area - exact).abs() <= 2e-3 * exact, "{share}: {area} {exact}");
    }
    let tube = with_wall(JAR, r#"{ "thickness": 0.2, "base": 0 }"#);
    let options = SketchOptions { fill: Some(0.5), ..SketchOptions::default() };
    assert_eq!(sketch(&tube, &options).expect("a sketch").water, None);
}
