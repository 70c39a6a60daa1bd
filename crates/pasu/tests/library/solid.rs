//! Pots and solids: volumes and walls against formulas, closed meshes, and refusals.
//!
//! What its time buys: the crossings of all triangles of closed meshes, counted exactly, for walls of every form.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use crate::support::{Exhibit, design, gallery, table};
use pasu::{Design, Face, FaceKind, Making, Pot, Product, SolidMesh, Solution, check, solid};
use serde_json::{Value, json};

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
pub(crate) fn volume(mesh: &SolidMesh) -> f64 {
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

const POT: Making =
    Making { product: Product::Pot, size: None, shrinkage: 0.0, tolerance: None, craft: None, union: false };
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
fn walled(exhibit: &Exhibit) -> (Design, Making) {
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
        let solution = Solution::of(&design);
        for product in [Product::Pot, Product::Solid] {
            let making = Making { product, ..making };
            let meshes = solution.solid(&making).unwrap_or_else(|error| panic!("{}: {error}", exhibit.name));
            assert_eq!(meshes.iter().map(closed).collect::<Vec<_>>(), [2], "{}", exhibit.name);
            let report = solution.check(&making).unwrap();
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

/// Where a wall is looked into more closely some of the places are those of before but for rounding, which is no neighbour that stops it: a crest of the rim, where the outside bends by a radius of 0.0083, is where it is thinnest.
#[test]
fn a_wall_that_is_looked_into_has_no_pinholes() {
    for height in [18.2, 18.2002, 18.21] {
        let wave = |sign: f64| json!({ "start": -0.321 * sign, "end": 0.213 * sign });
        let component = |name: &str, turn: Value, wave: Value| json!({ "order": 2, "s": 1, "t": 0.5, "modes": [{ "n": 1, name: turn }, { "n": 9, name: wave }] });
        let shape = json!({
            "kind": "boundary-value",
            "span": "2pi",
            "x": component("cos", json!({ "start": 7.44, "end": 2.94 }), wave(1.0)),
            "y": component("sin", json!({ "start": 5.88504, "end": 2.32554 }), wave(-1.0)),
            "z": { "order": 2, "s": 1, "t": 0.5, "modes": [{ "n": 0, "cos": { "start": 0, "end": height } }] },
        });
        let wall = json!({ "thickness": 0.659, "base": 0.741 });
        let json = json!({ "pasu": 1, "parts": [{ "shape": shape, "wall": wall }] }).to_string();
        let pot = Pot::new(&design(&json), 0, Product::Pot).unwrap();
        let (least, _) = pot.thickness();
        // `y'^2 / |x''|` at `v = 0`.
        let bend = (2.325_54f64 - 9.0 * 0.213).powi(2) / (2.94 + 81.0 * 0.213);
        assert!(least > 0.78 * bend && least < 0.82 * bend, "{height}: {least} {bend}");
    }
}

/// The wall outside is thinned between the petals, so that its thickness is a spline, whose second derivatives jump from one piece to the next.
#[test]
fn the_sides_of_a_ring_on_a_thinned_wall_have_the_derivatives_of_their_positions() {
    let design = design(
        r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [4.18, 0.333146, 2.3137, 0.17954312], "n": [1, 6], "t": [0.0047, 0.0047], "height": 13.9675 },
        "wall": { "thickness": 0.5624, "base": 0.6638, "side": "outside", "foot": [0.6034, 0.5011], "drain": 1.0477 } }] }"#,
    );
    let pot = Pot::new(&design, 0, Product::Pot).unwrap();
    assert!(pot.thickness().0 < 0.55, "{:?}", pot.thickness());
    let face = pot.faces().iter().find(|face| face.kind() == FaceKind::FootRing).unwrap();
    const H: f64 = 1e-6;
    let mut worst = 0.0f64;
    for index in 0..4000 {
        // Beside the knots, never on one.
        let v = TAU * (f64::from(index) + 0.37) / 4000.0;
        for a in [0.1, 0.9] {
            let [before, behind] = [v - H, v + H].map(|v| face.jet(a, v).position);
            worst = worst.max((face.jet(a, v).dv - (behind - before) / (2.0 * H)).length());
        }
    }
    assert!(worst < 1e-6, "{worst}");
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
    let exhibit = table("table-leaning");
    let (design, making) = walled(&exhibit);
    let mesh = made(&design, &Making { product: Product::Solid, ..making });
    let (_, first, count) = *mesh.faces.last().unwrap();
    for vertex in &mesh.indices[first as usize..(first + count) as usize] {
        assert!((corner(&mesh, *vertex)[2] - 226.0).abs() < 0.01);
    }
}

/// A bowl of a given bottom: `z` leaves a foot of this radius with slope `rise`.
fn bowl(foot: f64, rise: f64, wall: &str) -> Design {
    let round = |part: &str| {
        format!(
            r#"{{ "order": 4, "s": 1, "t": 0, "w": 0, "modes": [
                {{ "n": 1, "{part}": {{ "start": {foot}, "end": 5, "start_u": 8, "end_u": 2 }} }},
                {{ "n": 5, "{part}": {{ "end": 0.2 }} }} ] }}"#
        )
    };
    let z = format!(
        r#"{{ "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{{ "n": 0, "cos": {{ "end": 4, "start_u": {rise}, "end_u": 6 }} }}] }}"#
    );
    let (x, y) = (round("cos"), round("sin"));
    let shape = format!(r#"{{ "kind": "boundary-value", "span": "2pi", "x": {x}, "y": {y}, "z": {z} }}"#);
    design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall} }}] }}"#))
}

#[test]
fn round_bottoms_have_floors_where_the_wall_is_thinner_than_the_base() {
    for side in ["inside", "outside"] {
        for (base, drain, is_flat) in [
            (0.6, "0", true),
            (0.1, "0", false),
            (0.6, "0.8", true),
            (0.1, "0.8", false),
            (0.0, "0", false),
            (0.0, "0.8", false),
        ] {
            let wall = format!(r#"{{ "thickness": 0.25, "base": {base}, "side": "{side}", "drain": {drain} }}"#);
            let design = bowl(0.0, 0.0, &wall);
            let pot = Pot::new(&design, 0, Product::Pot).unwrap_or_else(|error| panic!("{error} {wall}"));
            follows_on(&pot);
            let kinds: Vec<FaceKind> = pot.faces().iter().map(|face| face.kind()).collect();
            // Outside, the floor is the round lining itself, and what is flat is the underside. A base thicker than the wall makes it so on the inside; a thinner one on the outside.
            let flat = if side == "inside" { FaceKind::Floor } else { FaceKind::Underside };
            assert_eq!(kinds.contains(&flat), is_flat == (side == "inside") && base > 0.0, "{wall} {kinds:?}");
            let mesh = made(&design, &Making { tolerance: Some(5e-3), ..POT });
            assert_eq!(closed(&mesh), if drain == "0" { 2 } else { 0 }, "{wall}");
            near(volume(&mesh), 1000.0 * exact_volume(&pot), 2e-2);
        }
    }
}

/// Outside of a tip, the other side of the wall begins in a ring: it once stayed open.
#[test]
fn a_tip_stands_on_a_stump_outside_and_needs_a_base_inside() {
    let outside = bowl(0.0, 6.0, r#"{ "thickness": 0.25, "base": 0.6, "side": "outside" }"#);
    assert_eq!(closed(&made(&outside, &POT)), 2);
    let inside = bowl(0.0, 6.0, r#"{ "thickness": 0.25, "base": 0.6 }"#);
    assert_eq!(closed(&made(&inside, &POT)), 2);
    for side in ["inside", "outside"] {
        let thin = bowl(0.0, 6.0, &format!(r#"{{ "thickness": 0.25, "base": 0, "side": "{side}" }}"#));
        let error = solid(&thin, &POT).unwrap_err();
        assert_eq!((error.code().as_str(), error.path()), ("no-room", "parts[0].wall.base"));
        assert!(error.message().starts_with("the bottom ends in a tip at (0, 0, 0)"), "{error}");
        assert_eq!(error.place(), Some([0.0; 3]));
    }
}

#[test]
fn shallow_bowls_are_led_down_to_the_floor() {
    for side in ["inside", "outside"] {
        let design = bowl(2.0, 1.0, &format!(r#"{{ "thickness": 0.4, "base": 0.2, "side": "{side}" }}"#));
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        follows_on(&pot);
        assert_eq!(closed(&made(&design, &Making { tolerance: Some(5e-3), ..POT })), 2);
    }
}

/// Straight down from above a foot that flares outwards was through the foot itself.
#[test]
fn the_outside_goes_round_a_foot_that_flares() {
    let shape = r#"{ "kind": "bloor-wilson", "a": 1.2, "r": [3.9, 0.1, 0.2, 4.5], "R": [-4.4, -2.2, -2.2, 5.9], "h": [7.9, 0], "H": [-7.4, 0], "n1": 1 }"#;
    let design = design(&format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ "thickness": 0.35, "base": 0.36, "side": "outside" }} }}] }}"#
    ));
    follows_on(&Pot::new(&design, 0, Product::Pot).unwrap());
    assert_eq!(closed(&made(&design, &Making { tolerance: Some(0.02), ..POT })), 2);
}

/// A wall with petals, waves at the foot and a twist of its axis by placement.
#[test]
fn a_foot_that_is_not_level_has_a_cone_under_it() {
    let shape = r#"{ "kind": "boundary-value", "span": "2pi",
        "x": { "order": 2, "s": 1, "t": 0, "modes": [{ "n": 1, "cos": { "start": 3, "end": 4 } }] },
        "y": { "order": 2, "s": 1, "t": 0, "modes": [{ "n": 1, "sin": { "start": 3, "end": 4 } }] },
        "z": { "order": 2, "s": 1, "t": 0, "modes": [{ "n": 0, "cos": { "end": 7 } }, { "n": 3, "cos": { "start": 0.3 } }] } }"#;
    for more in ["", r#", "drain": 1"#, r#", "side": "outside", "rim": "rounded""#] {
        let design = design(&format!(
            r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ "thickness": 0.3, "base": 0.3{more} }},
                "place": {{ "scale": [1, -1.5, 1], "axis": [1, 2, 3], "angle": 1, "shift": [5, 5, 5] }} }}] }}"#
        ));
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        follows_on(&pot);
        let mesh = made(&design, &Making { tolerance: Some(5e-3), ..POT });
        near(volume(&mesh), 1000.0 * exact_volume(&pot), 1e-2);
    }
    let design = design(&format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ "thickness": 0.3, "base": 0.3, "foot": [0.5, 0.5] }} }}] }}"#
    ));
    let error = solid(&design, &POT).unwrap_err();
    assert_eq!((error.code().as_str(), error.path()), ("no-room", "parts[0].wall.foot"));
}

/// The distance of a point from a triangle.
fn distance(p: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> f64 {
    let sub = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let along = |a: [f64; 3], b: [f64; 3]| {
        let (ab, ap) = (sub(b, a), sub(p, a));
        let t = (dot(ap, ab) / dot(ab, ab)).clamp(0.0, 1.0);
        let off = sub(ap, ab.map(|x| x * t));
        dot(off, off)
    };
    let (ab, ac, ap) = (sub(b, a), sub(c, a), sub(p, a));
    let (d00, d01, d11, d20, d21) = (dot(ab, ab), dot(ab, ac), dot(ac, ac), dot(ap, ab), dot(ap, ac));
    let (v, w) = (d11 * d20 - d01 * d21, d00 * d21 - d01 * d20);
    let all = d00 * d11 - d01 * d01;
    if v >= 0.0 && w >= 0.0 && v + w <= all {
        let off = sub(sub(ap, ab.map(|x| x * v / all)), ac.map(|x| x * w / all));
        return dot(off, off).sqrt();
    }
    along(a, b).min(along(b, c)).min(along(c, a)).sqrt()
}

#[test]
fn faces_are_within_the_bound_of_the_mesh() {
    for name in ["own-dint", "own-twist", "own-square", "own-leaning", "own-fluted", "zhang-you-1b"] {
        let exhibit = gallery().into_iter().find(|exhibit| exhibit.name == name).unwrap();
        let (design, making) = walled(&exhibit);
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        let mesh = made(&design, &making);
        assert!(mesh.bound < 2.0 * making.tolerance.unwrap(), "{name}: {}", mesh.bound);
        let mut worst = 0.0f64;
        for face in pot.faces() {
            for i in 0..60 {
                let (a, v) = ((i as f64 * 0.618_034 + 0.1) % 1.0, i as f64 * 2.399_96 % TAU);
                let p = (face.jet(a, v).position * 10.0).to_array();
                let near = mesh
                    .indices
                    .chunks(3)
                    .map(|t| distance(p, [0, 1, 2].map(|k| corner(&mesh, t[k]))))
                    .fold(f64::INFINITY, f64::min);
                worst = worst.max(near / 10.0);
            }
        }
        assert!(worst <= mesh.bound, "{name}: {worst} beyond {}", mesh.bound);
        println!("{name}: {worst:.5} within {:.5}", mesh.bound);
    }
}

#[test]
fn the_lining_is_as_far_from_the_outside_as_the_wall_is_thick() {
    let exhibit = gallery().into_iter().find(|exhibit| exhibit.name == "own-saddle").unwrap();
    let (design, making) = walled(&exhibit);
    let pot = Pot::new(&design, 0, Product::Pot).unwrap();
    assert_eq!(pot.thickness(), (0.4, 0.4));
    let mesh = made(&design, &making);
    let (_, first, count) = *mesh.faces.iter().find(|face| face.0 == FaceKind::Outer).unwrap();
    let outside = &mesh.indices[first as usize..(first + count) as usize];
    let lining = pot.faces().iter().find(|face| face.kind() == FaceKind::Lining).unwrap();
    for i in 0..200 {
        let (a, v) = ((i as f64 * 0.618_034) % 1.0, i as f64 * 2.399_96 % TAU);
        let p = (lining.jet(a, v).position * 10.0).to_array();
        let near = outside
            .chunks(3)
            .map(|t| distance(p, [0, 1, 2].map(|k| corner(&mesh, t[k]))))
            .fold(f64::INFINITY, f64::min);
        assert!((near / 10.0 - 0.4).abs() < 2.0 * mesh.bound, "{near}");
    }
}

/// A refusal of a pot with this shape and wall: code, field and how the message begins.
fn refused(shape: &str, wall: &str, code: &str, path: &str, message: &str) {
    let json = format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall} }}] }}"#);
    let error = solid(&design(&json), &POT).expect_err(&json);
    assert_eq!((error.code().as_str(), error.path()), (code, path), "{error}");
    assert!(error.message().contains(message), "{error}");
}

fn tapered(r: &str, n: &str) -> String {
    format!(r#"{{ "kind": "second-order", "r": {r}, "t": [0, 0], "n": {n}, "height": 5 }}"#)
}

#[test]
fn what_cannot_be_a_pot_says_why_and_where() {
    let wall = r#"{ "thickness": 0.2, "base": 0.3 }"#;
    let shape = "parts[0].shape";
    let cup = tapered("[2, 0, 2, 0]", "[1, 2]");
    let open = tapered("[2, 0.3, 2, 0.3]", "[1, 2.5]");
    refused(&open, wall, "open-surface", shape, "does not meet itself after one turn");
    let pinched = tapered("[2, 0, -2, 0]", "[1, 2]");
    refused(&pinched, wall, "pinched-surface", shape, "is pinched to a point at (0, 0, 2.5)");
    let closed = tapered("[0, 0, 2, 0]", "[1, 2]");
    refused(&closed, wall, "no-opening", shape, "closes to a point at (0, 0, 5), where the opening of a pot is");
    // Three turns of a flower that is larger than the round it is on.
    let flower = tapered("[2, 3, 2, 3]", "[1, 4]");
    refused(&flower, wall, "crosses-itself", shape, "the surface runs through itself near (");
    refused(&cup, r#"{ "thickness": 0.2, "base": 6 }"#, "no-room", "parts[0].wall.base", "the rim is lower than");
    // Rings and drains that are only too large are fitted: `fitted.rs`.
    let base = r#"{ "thickness": 0.2, "base": 0, "foot": [0.3, 0.3] }"#;
    refused(&cup, base, "no-room", "parts[0].wall.foot", "expected a base greater than 0");
    let base = r#"{ "thickness": 0.2, "base": 0, "drain": 0.3 }"#;
    refused(&cup, base, "no-room", "parts[0].wall.drain", "expected a base greater than 0");
    // So narrow on a wall that leans inwards that none that is near to it stands under it.
    let leaning = tapered("[0.5, 0, 4, 0]", "[1, 2]");
    let high = r#"{ "thickness": 0.2, "base": 0.3, "foot": [0.01, 2] }"#;
    refused(&leaning, high, "no-room", "parts[0].wall.foot", "has no room: it runs through the outside near (");
    let bare = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {cup} }}] }}"#));
    let error = solid(&bare, &POT).unwrap_err();
    assert_eq!((error.code().as_str(), error.path()), ("no-wall", "parts[0].wall"));
    assert!(solid(&bare, &SOLID).is_ok());
}

#[test]
fn a_part_that_is_not_there_is_refused() {
    let error = Pot::new(&cylinder(r#"{ "thickness": 0.2, "base": 0.3 }"#), 1, Product::Pot).unwrap_err();
    assert_eq!(
        (error.code().as_str(), error.message()),
        ("no-such-point", "expected the number of a part, only 0, found 1")
    );
}

/// A wall thicker than the tube is wide is thinned, never folded; the report says by how much.
#[test]
fn a_wall_that_is_too_thick_is_thinned_and_says_so() {
    let design = cylinder(r#"{ "thickness": 3, "base": 0.5 }"#);
    let pot = Pot::new(&design, 0, Product::Pot).unwrap();
    let (least, most) = pot.thickness();
    assert!((1.55..=1.6 + 1e-9).contains(&least) && (1.55..=1.6 + 1e-9).contains(&most), "{least} {most}");
    assert!(pot.thinned().is_some_and(|(share, _)| (share - 1.0).abs() < 1e-9));
    assert_eq!(closed(&made(&design, &POT)), 2);
    let report = check(&design, &POT).unwrap();
    let finding = &report.findings[0];
    assert_eq!((finding.code, finding.severity), ("thinned", pasu::Severity::Warning));
    assert!(finding.message.contains("the wall had to be thinned to 1.6 at (") && finding.at.is_some());
    assert!(report.to_json().starts_with(r#"{"ok":true,"product":"pot","triangles":"#), "{}", report.to_json());
}

/// Upright walls on a band round an arc, as a Fourier series.
fn crescent(radius: f64, half_width: f64, half_angle: f64) -> String {
    let n = 64;
    let harmonics = |axis: usize, part: &str| {
        let modes = (0..12).map(|k| {
            let sum: f64 = (0..n)
                .map(|j| TAU * j as f64 / n as f64)
                .map(|v| {
                    let (radius, angle) = (radius + half_width * v.cos(), half_angle * v.sin());
                    let point = [radius * angle.cos(), radius * angle.sin()];
                    let wave = [(k as f64 * v).cos(), (k as f64 * v).sin()];
                    point[axis] * wave[axis] * if k == 0 { 1.0 } else { 2.0 } / n as f64
                })
                .sum();
            format!(r#"{{ "n": {k}, "{part}": {{ "start": {sum}, "end": {sum} }} }}"#)
        });
        format!(r#"{{ "order": 2, "s": 1, "t": 0, "modes": [{}] }}"#, modes.collect::<Vec<_>>().join(", "))
    };
    let (x, y) = (harmonics(0, "cos"), harmonics(1, "sin"));
    let z = r#"{ "order": 2, "s": 1, "t": 0, "modes": [{ "n": 0, "cos": { "end": 7 } }] }"#;
    format!(r#"{{ "kind": "boundary-value", "span": "2pi", "x": {x}, "y": {y}, "z": {z} }}"#)
}

/// A crescent, whose middle does not see its tips: level faces are triangulated, with the hole of a drain in them.
#[test]
fn a_crescent_has_level_faces_that_are_seen_from_nowhere() {
    let shape = crescent(6.0, 2.6, 1.5);
    for (wall, euler) in [
        (r#""base": 0.4"#, 2),
        (r#""base": 0.4, "drain": 0.5, "foot": [0.15, 0.4]"#, 0),
        (r#""base": 0.4, "side": "outside", "drain": 0.5"#, 0),
    ] {
        let design = design(&format!(
            r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ "thickness": 0.2, {wall} }}, "place": {{ "axis": [1, 2, 0], "angle": 0.7 }} }}] }}"#
        ));
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        follows_on(&pot);
        let making = Making { tolerance: Some(0.01), ..POT };
        let mesh = made(&design, &making);
        assert_eq!(closed(&mesh), euler, "{wall}");
        near(volume(&mesh), 1000.0 * exact_volume(&pot), 1e-2);
        let mesh = made(&design, &Making { product: Product::Solid, ..making });
        near(volume(&mesh), 1000.0 * exact_volume(&Pot::new(&design, 0, Product::Solid).unwrap()), 1e-2);
    }
    // The middle of a longer one is not in it.
    let wall = r#"{ "thickness": 0.2, "base": 0.4, "drain": 0.5 }"#;
    refused(
        &crescent(6.0, 2.0, 2.0),
        wall,
        "no-room",
        "parts[0].wall.drain",
        "is outside of it, so no drain can be there",
    );
}

#[test]
fn a_tolerance_that_takes_too_many_points_says_that_it_is_the_tolerance() {
    let making = Making { product: Product::Solid, tolerance: Some(1e-6), ..Making::default() };
    let report = check(&Design::parse("#1/bloor-wilson?n1=5").unwrap(), &making).unwrap();
    let [finding] = &report.findings[..] else { panic!("{report:?}") };
    assert_eq!((finding.code, finding.path.as_deref()), ("too-large", Some("parts[0]")), "{finding:?}");
    assert_eq!(finding.args.get("what"), Some(&"tolerance".into()));
    assert!(report.meshes.is_empty() && finding.args.contains_key("rows"));
    // Of patches too.
    let octant = r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "octant", "exponents": [2, 2, 2] } }] }"#;
    let making = Making { tolerance: Some(3e-7), ..making };
    let report = check(&Design::parse(octant).unwrap(), &making).unwrap();
    let [finding] = &report.findings[..] else { panic!("{report:?}") };
    assert_eq!((finding.code, finding.path.as_deref()), ("too-large", Some("parts[0]")), "{finding:?}");
    assert_eq!(finding.args.get("what"), Some(&"tolerance".into()));
}

/// The bound of a file has the rounding of its positions in it, by which a tolerance was passed without a word.
#[test]
fn a_tolerance_is_kept_with_the_rounding_of_a_file() {
    let design = Design::parse(
        r#"{ "pasu": 1, "unit": "mm", "parts": [{ "shape": { "kind": "bloor-wilson", "a": 2.1354, "n1": 4,
        "r": [4.358, 0.1878298, -0.3643288, 2.6703], "R": [-2.3785, -1.18925, -1.18925, -5.1056], "h": [13.8122, 0.1276], "H": [-13.84120562, -0.4065] },
        "wall": { "thickness": 0.408, "base": 0.2278, "rim": "rounded" } }] }"#,
    )
    .unwrap();
    let tolerance = 0.00139398;
    let mesh = made(&design, &Making { product: Product::Solid, tolerance: Some(tolerance), ..POT });
    assert!(mesh.bound <= tolerance, "{}", mesh.bound);
}
