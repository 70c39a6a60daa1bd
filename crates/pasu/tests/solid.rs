//! Pots and solids: volumes and walls against formulas, closed meshes, and refusals.

#[path = "support/mod.rs"]
mod support;

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use pasu::{Design, Face, FaceKind, Making, Pot, Product, SolidMesh, check, solid};
use support::{design, gallery};

/// A cylinder of radius 2 and height 5 with a wall.
fn cylinder(wall: &str) -> Design {
    straight(2.0, 2.0, wall)
}

/// A frustum of height 5 with a wall.
fn straight(foot: f64, rim: f64, wall: &str) -> Design {
    placed(foot, rim, wall, "{}")
}

fn placed(foot: f64, rim: f64, wall: &str, place: &str) -> Design {
    let shape =
        format!(r#"{{ "kind": "second-order", "r": [{rim}, 0, {foot}, 0], "t": [0, 0], "n": [1, 2], "height": 5 }}"#);
    design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall}, "place": {place} }}] }}"#))
}

fn made(design: &Design, making: &Making) -> SolidMesh {
    let mut meshes = solid(design, making).unwrap_or_else(|error| panic!("{error}\n{}", design.to_json()));
    assert_eq!(meshes.len(), 1);
    let mesh = meshes.remove(0);
    closed(&mesh);
    mesh
}

/// Asserts that a mesh is closed and covers its faces, and gives its Euler characteristic.
fn closed(mesh: &SolidMesh) -> i64 {
    let mut edges = HashMap::new();
    for triangle in mesh.indices.chunks(3) {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            *edges.entry((triangle[a], triangle[b])).or_insert(0) += 1;
        }
    }
    for (&(a, b), &n) in &edges {
        assert_eq!((n, edges.get(&(b, a))), (1, Some(&1)), "edge {a} {b}");
    }
    let mut next = 0;
    for (_, first, count) in &mesh.faces {
        assert_eq!(*first, next);
        next += count;
    }
    assert_eq!(next as usize, mesh.indices.len());
    mesh.n_vertices() as i64 - edges.len() as i64 / 2 + mesh.n_triangles() as i64
}

fn corner(mesh: &SolidMesh, vertex: u32) -> [f64; 3] {
    [0, 1, 2].map(|i| f64::from(mesh.positions[3 * vertex as usize + i]))
}

/// The enclosed volume in cubic millimetres.
fn volume(mesh: &SolidMesh) -> f64 {
    let volume = |t: &[u32]| {
        let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [0, 1, 2].map(|i| corner(mesh, t[i]));
        ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    };
    mesh.indices.chunks(3).map(volume).sum::<f64>() / 6.0
}

/// The volume from the faces by quadrature that is good for round pots.
fn exact_volume(pot: &Pot) -> f64 {
    let (n, m) = (24, 64);
    let mut sum = 0.0;
    for face in pot.faces() {
        for i in 0..n {
            // Composite Gauss rule of two points.
            for node in [-1.0, 1.0] {
                let a = (i as f64 + 0.5 + node / 12f64.sqrt()) / n as f64;
                for j in 0..m {
                    let jet = face.jet(a, TAU * j as f64 / m as f64);
                    sum += face.outward() * jet.position.dot(jet.da.cross(jet.dv)) / 3.0 * TAU / (2 * n * m) as f64;
                }
            }
        }
    }
    sum
}

fn near(found: f64, expected: f64, relative: f64) {
    assert!((found / expected - 1.0).abs() < relative, "{found} is not {expected}");
}

const POT: Making = Making { product: Product::Pot, size: None, shrinkage: 0.0, tolerance: None };
const SOLID: Making = Making { product: Product::Solid, ..POT };

#[test]
fn a_cup_has_the_volume_of_its_formula() {
    for side in ["inside", "outside"] {
        let design = cylinder(&format!(r#"{{ "thickness": 0.25, "base": 0.5, "side": "{side}" }}"#));
        let expected =
            if side == "inside" { 5.0 * 4.0 - 4.5 * 1.75 * 1.75 } else { 5.5 * 2.25 * 2.25 - 5.0 * 4.0 } * PI;
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        near(exact_volume(&pot), expected, 1e-6);
        let mesh = made(&design, &POT);
        assert_eq!(closed(&mesh), 2);
        near(volume(&mesh), 1000.0 * expected, 0.02);
        let fine = made(&design, &Making { tolerance: Some(1e-4), ..POT });
        near(volume(&fine), 1000.0 * expected, 1e-3);
    }
}

#[test]
fn a_solid_is_closed_by_discs() {
    let design = straight(1.5, 2.5, r#"{ "thickness": 0.25, "base": 0.5 }"#);
    let mesh = made(&design, &SOLID);
    assert_eq!(closed(&mesh), 2);
    let expected = PI * 5.0 / 3.0 * (1.5 * 1.5 + 1.5 * 2.5 + 2.5 * 2.5);
    near(volume(&mesh), 1000.0 * expected, 2e-3);
    near(exact_volume(&Pot::new(&design, 0, Product::Solid).unwrap()), expected, 1e-6);
    let kinds: Vec<FaceKind> = mesh.faces.iter().map(|face| face.0).collect();
    assert_eq!(kinds, [FaceKind::Underside, FaceKind::Outer, FaceKind::Lid]);
}

/// Thick enough for clay, and coarse enough for a test.
fn walled(exhibit: &support::Exhibit) -> (Design, Making) {
    let shape = serde_json::to_string(&exhibit.shape).unwrap();
    let is_paper = !exhibit.name.starts_with("own");
    let (thickness, tolerance) = if is_paper { (0.06, 0.006) } else { (0.4, 0.04) };
    let wall = format!(r#"{{ "thickness": {thickness}, "base": {thickness} }}"#);
    let design = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall} }}] }}"#));
    (design, Making { tolerance: Some(tolerance), ..POT })
}

#[test]
fn every_gallery_design_can_be_made() {
    for exhibit in gallery() {
        let (design, making) = walled(&exhibit);
        for product in [Product::Pot, Product::Solid] {
            let mesh = made(&design, &Making { product, ..making });
            assert_eq!(closed(&mesh), 2, "{}", exhibit.name);
            let report = check(&design, &Making { product, ..making }).unwrap();
            assert!(report.is_ok() && report.meshes[0].genus == Some(0), "{}", report.to_json());
        }
    }
}

/// Makes a pot of every form on these straight walls, and holds its mesh against its faces.
fn forms(foot: f64, rim: f64) {
    for side in ["inside", "outside"] {
        for rounding in ["flat", "rounded"] {
            for (more, genus) in [
                ("", 0),
                (r#", "foot": [0.4, 0.3]"#, 0),
                (r#", "drain": 0.7"#, 1),
                (r#", "foot": [0.4, 0.3], "drain": 0.7"#, 1),
            ] {
                let wall =
                    format!(r#"{{ "thickness": 0.2, "base": 0.3, "side": "{side}", "rim": "{rounding}"{more} }}"#);
                let design = straight(foot, rim, &wall);
                let pot = Pot::new(&design, 0, Product::Pot).unwrap_or_else(|error| panic!("{error} {wall}"));
                let mesh = made(&design, &Making { tolerance: Some(3e-3), ..POT });
                assert_eq!(closed(&mesh), 2 - 2 * genus, "{wall}");
                near(volume(&mesh), 1000.0 * exact_volume(&pot), 1e-2);
                follows_on(&pot);
            }
        }
    }
}

/// Asserts that every face begins where the one before ended, and that its derivatives are those of its positions.
fn follows_on(pot: &Pot) {
    let faces = pot.faces();
    let step = 1e-5;
    for (i, face) in faces.iter().enumerate() {
        for v in [0.0, 0.4, 2.0, 5.1] {
            let next = faces.get(i + 1).or(if pot.is_ring() { faces.first() } else { None });
            if let Some(next) = next {
                let gap = face.jet(1.0, v).position.distance(next.jet(0.0, v).position);
                assert!(gap < 1e-12, "{:?} {v}: {gap}", face.kind());
            }
            for a in [0.2, 0.7] {
                let jet = face.jet(a, v);
                let along = (face.jet(a + step, v).position - face.jet(a - step, v).position) / (2.0 * step);
                let round = (face.jet(a, v + step).position - face.jet(a, v - step).position) / (2.0 * step);
                let (da, dv) = (jet.da.distance(along), jet.dv.distance(round));
                let size = 1.0 + along.length() + round.length();
                assert!(da < 1e-7 * size && dv < 1e-7 * size, "{:?} {a} {v}: {da} {dv}", face.kind());
            }
        }
    }
}

#[test]
fn every_form_of_straight_walls_is_made() {
    forms(2.0, 2.0);
    forms(1.5, 3.0);
    forms(2.5, 1.5);
}

#[test]
fn a_rounded_rim_adds_half_a_ring() {
    let volume = |rim: &str| {
        let wall = format!(r#"{{ "thickness": 0.2, "base": 0.3, "rim": "{rim}" }}"#);
        exact_volume(&Pot::new(&cylinder(&wall), 0, Product::Pot).unwrap())
    };
    // Pappus: the centroid of a half disc set upright over the middle of the wall stays over it.
    near(volume("rounded") - volume("flat"), PI * 0.1 * 0.1 / 2.0 * TAU * 1.9, 1e-3);
}

#[test]
fn a_tube_has_a_handle_and_two_rims() {
    for (rim, expected) in [("flat", 0.0), ("rounded", PI * 0.1 * 0.1 * TAU * 1.9)] {
        let design = cylinder(&format!(r#"{{ "thickness": 0.2, "base": 0, "rim": "{rim}" }}"#));
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        near(exact_volume(&pot), 5.0 * PI * (4.0 - 1.8 * 1.8) + expected, 1e-5);
        follows_on(&pot);
        let mesh = made(&design, &POT);
        assert_eq!(closed(&mesh), 0);
        let kinds: Vec<FaceKind> = mesh.faces.iter().map(|face| face.0).collect();
        assert_eq!(kinds, [FaceKind::Outer, FaceKind::Rim, FaceKind::Lining, FaceKind::Rim]);
    }
}

#[test]
fn ring_and_drain_take_away_what_formulas_say() {
    let volume = |more: &str| {
        let wall = format!(r#"{{ "thickness": 0.2, "base": 0.3{more} }}"#);
        exact_volume(&Pot::new(&cylinder(&wall), 0, Product::Pot).unwrap())
    };
    let plain = volume("");
    near(plain - volume(r#", "drain": 0.7"#), PI * 0.35 * 0.35 * 0.3, 1e-3);
    // The floor rises by the height of the ring: a disc of the lining more, a recess less.
    near(volume(r#", "foot": [0.4, 0.3]"#) - plain, PI * 0.3 * (1.8 * 1.8 - 1.6 * 1.6), 1e-3);
}

#[test]
fn a_wall_is_as_thick_along_the_normal_as_asked_for() {
    for exhibit in gallery().iter().filter(|exhibit| exhibit.name.starts_with("own")) {
        let (design, _) = walled(exhibit);
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        let (least, most) = pot.thickness();
        assert!(0.0 < least && least <= most && most <= 0.4, "{}", exhibit.name);
        match pot.thinned() {
            Some((share, _)) => assert!(share > 0.0 && share <= 1.0, "{}: {share}", exhibit.name),
            None => assert_eq!((least, most), (0.4, 0.4)),
        }
        follows_on_if_exact(&pot);
    }
}

fn follows_on_if_exact(pot: &Pot) {
    if pot.thinned().is_none() {
        follows_on(pot);
    }
}

/// The highest point of a rim lies between the columns at which curves are looked at.
#[test]
fn a_solid_with_a_tilted_rim_reaches_its_highest_point() {
    let exhibit = gallery().into_iter().find(|exhibit| exhibit.name == "own-leaning").unwrap();
    let (design, making) = walled(&exhibit);
    let mesh = made(&design, &Making { product: Product::Solid, ..making });
    let (_, first, count) = *mesh.faces.last().unwrap();
    for vertex in &mesh.indices[first as usize..(first + count) as usize] {
        assert!((corner(&mesh, *vertex)[2] - 226.0).abs() < 0.01);
    }
}
