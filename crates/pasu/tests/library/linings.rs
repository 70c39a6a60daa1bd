//! Walls with a lining of their own: round inside, carved outside.
//!
//! What its time buys: the thickness of many random pots, sought between points of both sides by a search that shares nothing with that of the library.

use std::cell::Cell;
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;
use std::rc::Rc;

use glam::DVec3;
use pasu::{
    Code, Design, Face, FaceKind, FaceWalk, Format, Making, MeasureOptions, Piece, Pot, Product, Solution, check,
    watched,
};
use serde_json::{Value, json};

use crate::support::gallery;
use crate::support::networks::cube;
use crate::support::random::{Random, drawn};

fn parsed(shape: &Value, wall: &Value) -> Design {
    let document = json!({ "pasu": 1, "parts": [{ "shape": shape, "wall": wall }] });
    Design::parse(&document.to_string()).unwrap_or_else(|error| panic!("{error}: {document}"))
}

/// A pot of three rings with so many flutes, this deep at foot, belly and rim.
fn fluted(n: u32, depths: [f64; 3], radii: [f64; 3], wall: &Value) -> Design {
    petalled(n, depths, radii, 0.0, wall)
}

/// The same with a rim that goes up and down.
fn petalled(n: u32, depths: [f64; 3], radii: [f64; 3], rise: f64, wall: &Value) -> Design {
    let ring = |i: usize, u: f64, z: f64| {
        let waves = json!([{ "n": n, "cos": depths[i] }]);
        let heights = json!([{ "n": n, "cos": if i == 2 { rise } else { 0.0 } }]);
        json!({ "u": u, "r": { "mean": radii[i], "waves": waves }, "z": { "mean": z, "waves": heights } })
    };
    let rings = [ring(0, 0.0, 0.0), ring(1, 0.5, 5.0), ring(2, 1.0, 10.0)];
    parsed(&json!({ "kind": "rings", "rings": rings }), wall)
}

fn pot(design: &Design) -> Pot {
    Pot::new(design, 0, Product::Pot).unwrap_or_else(|error| panic!("{error}\n{}", design.to_json()))
}

fn face(pot: &Pot, kind: FaceKind) -> &Piece {
    pot.faces().iter().rfind(|face| face.kind() == kind).expect("there is one")
}

/// The least distance of points of the lining from the outside: of each the nearest of many, and from there along the tangents.
fn thinnest(pot: &Pot, [rows, columns]: [usize; 2]) -> f64 {
    let outer: Vec<&Piece> =
        pot.faces().iter().filter(|face| face.kind() == FaceKind::Outer && !face.is_level()).collect();
    let lining = pot.faces().iter().find(|face| face.kind() == FaceKind::Lining).expect("a lining");
    let at = |j: usize, n: usize| TAU * j as f64 / n as f64;
    let (n, m) = (3 * rows, 3 * columns);
    let mut places = Vec::new();
    for (number, face) in outer.iter().enumerate() {
        let mut walk = face.walk();
        for i in 0..=n {
            for j in 0..m {
                let (a, v) = (i as f64 / n as f64, at(j, m));
                places.push((walk.jet(a, v).position, number, a, v));
            }
        }
    }
    let mut walk = lining.walk();
    let mut walks: Vec<Box<dyn FaceWalk + '_>> = outer.iter().map(|face| face.walk()).collect();
    let mut least = f64::INFINITY;
    for i in 0..=rows {
        for j in 0..columns {
            let point = walk.jet(i as f64 / rows as f64, at(j, columns) + 0.37).position;
            let nearest =
                places.iter().min_by(|p, q| p.0.distance_squared(point).total_cmp(&q.0.distance_squared(point)));
            let &(near, number, mut a, mut v) = nearest.expect("a place");
            let mut distance = near.distance(point);
            for _ in 0..8 {
                let jet = walks[number].jet(a, v);
                let way = point - jet.position;
                let (e, f, g) = (jet.da.length_squared(), jet.da.dot(jet.dv), jet.dv.length_squared());
                let (p, q) = (way.dot(jet.da), way.dot(jet.dv));
                let area = e * g - f * f;
                a = (a + 0.7 * (g * p - f * q) / area).clamp(0.0, 1.0);
                v = (v + 0.7 * (e * q - f * p) / area).rem_euclid(TAU);
                distance = distance.min(walks[number].jet(a, v).position.distance(point));
            }
            least = least.min(distance);
        }
    }
    least
}

/// The volume of the triangles in model units, which are a centimetre, and Euler's characteristic.
fn enclosed(design: &Design) -> (f64, i64) {
    let meshes =
        Solution::of(design).solid(&Making::default()).unwrap_or_else(|error| panic!("{error}\n{}", design.to_json()));
    let [mesh] = &meshes[..] else { panic!("one mesh") };
    let mut edges = HashMap::new();
    let at = |vertex: u32| DVec3::from_array([0, 1, 2].map(|i| f64::from(mesh.positions[3 * vertex as usize + i])));
    let mut volume = 0.0;
    for of in mesh.indices.chunks_exact(3) {
        volume += at(of[0]).dot(at(of[1]).cross(at(of[2]))) / 6.0;
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            *edges.entry((of[a], of[b])).or_insert(0) += 1;
        }
    }
    for (&(a, b), &n) in &edges {
        assert_eq!((n, edges.get(&(b, a))), (1, Some(&1)), "edge {a} {b}");
    }
    (volume / 1e3, mesh.n_vertices() as i64 - edges.len() as i64 / 2 + mesh.n_triangles() as i64)
}

#[test]
fn a_round_pot_is_that_of_the_formulas() {
    let shape = json!({ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 });
    let design = parsed(&shape, &json!({ "thickness": 0.5, "base": 1, "lining": {} }));
    let measures = Solution::of(&design).measure(&MeasureOptions::default()).unwrap();
    let body = &measures.parts[0].body;
    let thickness = measures.parts[0].thickness.as_ref().unwrap();
    let least = thickness.least.value;
    assert!((0.4999..0.505).contains(&least) && thickness.least.error < 0.02 * 0.5, "{thickness:?}");
    let (capacity, clay) = (body.capacity.as_ref().unwrap().brim.value, body.clay.as_ref().unwrap().volume.value);
    let of_radius = |radius: f64| PI * radius * radius * 3.0;
    let range = of_radius(3.0 - thickness.greatest.value - 1e-3)..of_radius(3.0 - least + 1e-3);
    assert!(range.contains(&capacity), "{capacity} {range:?}");
    // What is not clay is water, and the rim is flat.
    assert!((capacity + clay - PI * 9.0 * 4.0).abs() < 1e-4, "{capacity} {clay}");
    let (volume, euler) = enclosed(&design);
    assert!((volume - clay).abs() < 0.01 * clay && euler == 2, "{volume} {clay} {euler}");
}

/// Where the profile of a lining goes down and up again, what of it is beneath the floor is not there, nor what comes before that.
#[test]
fn what_of_a_lining_is_beyond_the_floor_is_not_measured() {
    let ring = |u: f64, r: f64, z: f64| json!({ "u": u, "r": { "mean": r }, "z": { "mean": z } });
    let rings = [
        ring(0.0, 6.63, 0.0),
        ring(0.188, 6.33, 1.73),
        ring(0.389, 8.54, 3.03),
        ring(0.588, 3.59, 4.79),
        ring(0.789, 6.11, 6.62),
        ring(1.0, 8.17, 7.96),
    ];
    let wall = json!({ "thickness": 0.69, "base": 0.427, "lining": {} });
    let design = parsed(&json!({ "kind": "rings", "rings": rings }), &wall);
    let measured = pasu::measure(&design, &pasu::MeasureOptions::default()).unwrap();
    let greatest = measured.parts[0].thickness.as_ref().unwrap().greatest;
    // Of each place of the lining the nearest of the outside, on one meridian.
    let pot = pot(&design);
    let places = |kind: FaceKind| -> Vec<_> {
        let face = face(&pot, kind);
        (0..=3000).map(|i| face.jet(f64::from(i) / 3000.0, 0.0).position).collect()
    };
    let (outer, lining) = (places(FaceKind::Outer), places(FaceKind::Lining));
    let nearest = lining.iter().map(|p| outer.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min));
    let exact = nearest.fold(0.0, f64::max);
    assert!((greatest.value - exact).abs() < greatest.error + 1e-5 && greatest.error < 0.5, "{greatest:?} {exact}");
}

#[test]
fn flutes_that_thin_an_offset_do_not_thin_a_round_inside() {
    let wall = |more: &Value| {
        let mut wall = json!({ "thickness": 0.4, "base": 0.5, "rim": "rounded" });
        more.as_object().into_iter().flatten().for_each(|(key, value)| wall[key] = value.clone());
        wall
    };
    let (depths, radii) = ([0.2, 0.3, 0.2], [3.0, 5.0, 4.0]);
    let offset = pot(&fluted(16, depths, radii, &wall(&json!({}))));
    assert!(offset.thickness().0 < 0.3, "{:?}", offset.thickness());
    let design = fluted(16, depths, radii, &wall(&json!({ "lining": {} })));
    let lined = pot(&design);
    assert!(lined.thinned().is_none() && lined.thickness().0 >= 0.4, "{:?}", lined.thickness());
    // Seen from above every row of the inside is a circle.
    let mut walk = face(&lined, FaceKind::Lining).walk();
    for a in [0.1, 0.5, 0.9] {
        let radii = (0..64).map(|j| walk.jet(a, TAU * f64::from(j) / 64.0).position.truncate().length());
        let (least, most) = radii.fold((f64::INFINITY, 0.0f64), |(least, most), r| (least.min(r), most.max(r)));
        assert!(most - least < 1e-9, "{a}: {least} {most}");
    }
    let report = check(&design, &Making::default()).unwrap();
    assert!(report.is_ok() && report.findings.iter().all(|found| found.code != "thinned"), "{:?}", report.findings);
    // An inside with the waves of the outside follows it, one with fewer does not.
    let follows = pot(&fluted(4, depths, radii, &wall(&json!({ "lining": { "waves": 4 } }))));
    let (least, most) = follows.thickness();
    assert!(least >= 0.4 && most < 0.5, "{least} {most}");
}

#[test]
fn the_wall_of_random_pots_is_as_thick_as_asked_for() {
    let n_pots = drawn(16, 100);
    let mut random = Random::new(15);
    let (mut n_made, mut refused) = (0, Vec::new());
    for number in 0..n_pots {
        let mut roll = |from: f64, to: f64| random.between(from, to);
        let n = roll(2.0, 14.0) as u32;
        let radii = [roll(2.0, 5.0), roll(3.0, 7.0), roll(2.0, 7.0)];
        let depths = [roll(0.0, 0.4), roll(0.0, 0.9), roll(0.0, 0.9)];
        let waves = if roll(0.0, 1.0) < 0.7 { 0 } else { roll(1.0, 5.0) as u32 };
        let rim = if roll(0.0, 1.0) < 0.5 { "rounded" } else { "flat" };
        let wall =
            json!({ "thickness": roll(0.2, 0.6), "base": roll(0.2, 0.8), "rim": rim, "lining": { "waves": waves } });
        let asked = wall["thickness"].as_f64().unwrap();
        // The rim of every third goes up and down as well.
        let rise = roll(-1.0, 1.0) * f64::from(u8::from(number % 3 == 0));
        let design = petalled(n, depths, radii, rise, &wall);
        let solution = Solution::of(&design);
        let made = match solution.pot(0, Product::Pot) {
            Ok(made) => made,
            Err(error) => {
                assert!(matches!(error.code(), Code::NoRoom | Code::PinchedSurface | Code::CrossesItself), "{error}");
                refused.push(error.to_string());
                continue;
            }
        };
        n_made += 1;
        let found = thinnest(&made, [24, 64]);
        // What is told is proven: it is what was asked for, and nothing was found that is less; but little more was taken.
        assert!(made.thickness().0 >= asked, "{number}: {:?} of {asked}\n{}", made.thickness(), design.to_json());
        assert!((asked..1.04 * asked).contains(&found), "{number}: {found} of {asked}\n{}", design.to_json());
        if number % 6 == 0 {
            // Between lips that go up and down a rim may have no room, whatever is inside.
            if let Err(error) = solution.solid(&Making::default()) {
                assert!(error.path() == "parts[0].wall.rim" && error.place().is_some(), "{number}: {error}");
                continue;
            }
            let clay =
                solution.measure(&MeasureOptions::default()).unwrap().parts[0].body.clay.as_ref().unwrap().volume.value;
            let (volume, euler) = enclosed(&design);
            assert!((volume - clay).abs() < 0.01 * clay && euler == 2, "{number}: {volume} {clay} {euler}");
        }
    }
    println!("{n_made} of {n_pots} {refused:#?}");
    assert!(n_made * 10 >= 9 * n_pots, "{n_made} of {n_pots}: {refused:?}");
}

/// What the lining meets at the rim goes up and down with it.
#[test]
fn a_rim_that_goes_up_and_down_is_level_across() {
    let wall = json!({ "thickness": 0.3, "base": 0.4, "lining": {} });
    let made = pot(&petalled(5, [0.1, 0.3, 0.4], [3.0, 4.0, 5.0], 0.8, &wall));
    let [mut outer, mut lining] = [FaceKind::Outer, FaceKind::Lining].map(|kind| face(&made, kind).walk());
    for j in 0..40 {
        let v = TAU * f64::from(j) / 40.0;
        // A wall is walked up outside and down inside.
        let [out, back] = [outer.jet(1.0, v), lining.jet(0.0, v)].map(|jet| jet.position.z);
        let mean = [outer.jet(1.0, 0.0), lining.jet(0.0, 0.0)].map(|jet| jet.position.z);
        assert!(((out - back) - (mean[0] - mean[1])).abs() < 1e-9, "{v}: {out} {back}");
    }
}

/// Where the inside begins above the floor, what leads there keeps its distance as well.
#[test]
fn a_foot_that_is_all_but_flat_has_a_wall_as_thick_down_to_the_floor() {
    for (base, thickness) in [(0.1, 0.3), (0.3, 0.3), (0.2, 0.4)] {
        let ring = |u: f64, r: f64, z: f64, depth: f64| json!({ "u": u, "r": { "mean": r, "waves": [{ "n": 7, "cos": depth }] }, "z": { "mean": z } });
        let rings =
            [ring(0.0, 2.0, 0.0, 0.0), ring(0.3, 4.0, 0.3, 0.1), ring(0.6, 5.0, 3.0, 0.3), ring(1.0, 5.0, 7.0, 0.2)];
        let wall = json!({ "thickness": thickness, "base": base, "lining": {} });
        let document = json!({ "pasu": 1, "parts": [{ "shape": { "kind": "rings", "rings": rings }, "wall": wall }] });
        let design = Design::parse(&document.to_string()).unwrap();
        let made = match Solution::of(&design).pot(0, Product::Pot) {
            Ok(made) => made,
            Err(error) => {
                println!("refused: {error}");
                assert_eq!((error.code(), error.path()), (Code::NoRoom, "parts[0].wall.lining"), "{error}");
                assert!(error.place().is_some(), "{error}");
                continue;
            }
        };
        println!("made {base} {thickness}: {:?}", made.thickness());
        // All of the inside that is neither the floor nor the rim.
        let mut outer: Vec<Box<dyn FaceWalk + '_>> =
            made.faces().iter().filter(|face| face.kind() == FaceKind::Outer).map(|face| face.walk()).collect();
        let at = |j: usize| TAU * j as f64 / 140.0;
        let outside: Vec<DVec3> = outer
            .iter_mut()
            .flat_map(|walk| {
                (0..=300)
                    .flat_map(move |i| (0..140).map(move |j| (i as f64 / 300.0, at(j))))
                    .map(|(a, v)| walk.jet(a, v).position)
                    .collect::<Vec<_>>()
            })
            .collect();
        let mut least = f64::INFINITY;
        for face in made.faces().iter().filter(|face| face.kind() == FaceKind::Lining) {
            let mut walk = face.walk();
            for (i, j) in (0..=60).flat_map(|i| (0..70).map(move |j| (i, j))) {
                let point = walk.jet(f64::from(i) / 60.0, at(2 * j)).position;
                least = outside.iter().fold(least, |least, p| least.min(p.distance(point)));
            }
        }
        assert!(least >= thickness, "{base} {thickness}: {least}");
    }
}

/// A vessel between two sections, which are four lobes and a circle.
#[test]
fn a_vessel_between_two_sections_can_be_round_inside() {
    let wall = json!({ "thickness": 0.2, "base": 0.3, "lining": {} });
    let petals = json!({
        "form": "outline", "x": [{ "n": 1, "sin": 2 }, { "n": 4, "sin": -0.2 }, { "n": 6, "sin": 0.2 }],
        "y": [{ "n": 1, "cos": 2 }, { "n": 4, "cos": 0.2 }, { "n": 6, "cos": 0.2 }], "z": 0, "taper": 0.2, "dz": 3
    });
    let round = json!({ "form": "disc", "radius": [2, 2], "z": 4, "taper": -0.1, "dz": 3 });
    let shape = json!({ "kind": "blend", "start": petals, "end": round, "weights": [1, 0.005, 1] });
    let document = json!({ "pasu": 1, "parts": [{ "shape": shape, "wall": wall }] });
    let design = Design::parse(&document.to_string()).unwrap_or_else(|error| panic!("{error}"));
    let made = pot(&design);
    assert!(made.thickness().0 >= 0.2 && thinnest(&made, [24, 64]) >= 0.2, "{:?}", made.thickness());
    let (volume, euler) = enclosed(&design);
    let body = Solution::of(&design).measure(&MeasureOptions::default()).unwrap();
    let clay = body.parts[0].body.clay.as_ref().unwrap().volume.value;
    assert!((volume - clay).abs() < 0.01 * clay && euler == 2, "{volume} {clay} {euler}");
}

/// Where a surface has no foot and no rim there is no inside of its own.
#[test]
fn networks_are_refused_with_their_place() {
    let mut shape = cube();
    shape["patches"].as_array_mut().unwrap().remove(0);
    let design = parsed(&shape, &json!({ "thickness": 0.05, "base": 0, "lining": {} }));
    let error = Solution::of(&design).solid(&Making::default()).expect_err("it has no foot");
    assert_eq!((error.code(), error.path()), (Code::UnsupportedShape, "parts[0].wall.lining"), "{error}");
}

/// A wall of a hundredth of the width is proven as well.
#[test]
fn a_thin_wall_is_proven() {
    for thickness in [0.2, 0.1, 0.05] {
        let wall = json!({ "thickness": thickness, "base": 0.3, "lining": {} });
        let made = pot(&fluted(12, [0.1, 0.3, 0.2], [3.0, 5.0, 4.0], &wall));
        assert!(made.thickness().0 >= thickness, "{:?}", made.thickness());
    }
}

#[test]
fn exhibits_whose_wall_is_made_can_have_a_round_inside() {
    // All of them with `EXHIBITS=1`.
    let step = std::env::var("EXHIBITS").ok().and_then(|n| n.parse().ok()).unwrap_or(8);
    let (mut n_made, mut refused) = (0, Vec::new());
    for exhibit in gallery().into_iter().step_by(step) {
        let size = Solution::of(&exhibit.design()).measure(&MeasureOptions::default()).unwrap().whole.height.value;
        let wall = |lining: bool| {
            let mut wall = json!({ "thickness": 0.03 * size, "base": 0.03 * size });
            if lining {
                wall["lining"] = json!({});
            }
            wall
        };
        let design = |lining: bool| {
            let document = json!({ "pasu": 1, "parts": [{ "shape": exhibit.shape, "wall": wall(lining) }] });
            Design::parse(&document.to_string()).unwrap()
        };
        if exhibit.shape["kind"] == "vertex-frame" || !check(&design(false), &Making::default()).unwrap().is_ok() {
            continue;
        }
        let solution = Solution::of(&design(true));
        let report = solution.check(&Making::default()).unwrap();
        if !report.is_ok() {
            // One that leans out of itself, or is no wider than its waves, has no room for another inside.
            let finding = &report.findings[0];
            assert_eq!((finding.code, finding.path.as_deref()), ("no-room", Some("parts[0].wall.lining")));
            assert!(finding.at.is_some(), "{finding:?}");
            refused.push(format!("{}: {finding:?}", exhibit.name));
            continue;
        }
        solution.measure(&MeasureOptions::default()).unwrap();
        for format in [Format::Stl, Format::ThreeMf, Format::Glb, Format::Obj, Format::Ply, Format::Step] {
            solution
                .write(format, &Making::default())
                .unwrap_or_else(|error| panic!("{} {format:?}: {error}", exhibit.name));
        }
        n_made += 1;
    }
    println!("{n_made} made; {refused:#?}");
    assert!(n_made >= 3 && n_made > refused.len(), "{n_made}: {refused:?}");
}

#[test]
fn what_is_left_out_stays_out_and_what_is_given_comes_back() {
    let shape = json!({ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 });
    let text = |wall: Value| json!({ "pasu": 1, "parts": [{ "shape": shape, "wall": wall }] }).to_string();
    let without = Design::parse(&text(json!({ "thickness": 0.1, "base": 0.1 })));
    let without = without.unwrap_or_else(|error| panic!("{error}"));
    assert!(!without.to_json().contains("lining"));
    for (given, kept) in
        [(json!({}), json!({})), (json!({ "waves": 0 }), json!({})), (json!({ "waves": 3 }), json!({ "waves": 3 }))]
    {
        let design = Design::parse(&text(json!({ "thickness": 0.1, "base": 0.1, "lining": given }))).unwrap();
        let written: Value = serde_json::from_str(&design.to_json()).unwrap();
        assert_eq!(written["parts"][0]["wall"]["lining"], kept);
        assert_eq!(Design::parse(&format!("#{}", design.link())).unwrap(), design);
        assert_ne!(design.link(), without.link());
    }
}

#[test]
fn hostile_linings_are_refused_with_their_place() {
    let shape = json!({ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 });
    let refused = |lining: Value, more: (&str, Value)| {
        let mut wall = json!({ "thickness": 0.3, "base": 0.3, "lining": lining });
        wall[more.0] = more.1;
        let document = json!({ "pasu": 1, "parts": [{ "shape": shape, "wall": wall }] });
        match Design::parse(&document.to_string()) {
            Err(error) => error,
            Ok(design) => Pot::new(&design, 0, Product::Pot).expect_err("it has no room"),
        }
    };
    let thick = |thickness: f64| ("thickness", json!(thickness));
    for waves in [json!(-1), json!(1.5), json!(129), json!(1e300), json!("3"), json!([]), json!({})] {
        let error = refused(json!({ "waves": waves }), thick(0.3));
        assert_eq!(error.path(), "parts[0].wall.lining.waves", "{error}");
    }
    for lining in [json!(true), json!(0), json!("round"), json!([])] {
        let error = refused(lining, thick(0.3));
        assert_eq!(error.path(), "parts[0].wall.lining", "{error}");
    }
    assert_eq!(refused(json!({ "petals": 1 }), thick(0.3)).code(), Code::UnknownField);
    let error = refused(json!({}), ("side", json!("outside")));
    assert_eq!((error.code(), error.path()), (Code::OutOfRange, "parts[0].wall.lining"));
    for thickness in [2.99, 3.0, 4.0, 1e6, 1e150] {
        let error = refused(json!({}), thick(thickness));
        assert_eq!((error.code(), error.path()), (Code::NoRoom, "parts[0].wall.lining"), "{thickness}: {error}");
    }
}

#[test]
fn a_wall_as_thin_as_nothing_ends_soon() {
    let shape = json!({ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 });
    for thickness in [1e-3, 1e-9, 1e-300] {
        let design = parsed(&shape, &json!({ "thickness": thickness, "base": 0.3, "lining": {} }));
        // Made or refused: the samples are no closer together than the size allows.
        drop(Pot::new(&design, 0, Product::Pot));
    }
}

/// Cells as large as it takes to have no more than thousands of them cannot tell such flutes apart: 450 million pairs of them were looked at, for half a minute, and the lining was refused all the same.
#[test]
fn flutes_too_fine_for_a_proof_are_refused_soon() {
    let shape = json!({ "kind": "bloor-wilson", "a": 3, "r": [1, 0.06, 0.05, 0.6], "R": [-2.7, -0.3, -0.3, 0.2], "h": [2.2, 0.3], "H": [-0.1, -0.1], "n1": 20 });
    let design = parsed(&shape, &json!({ "thickness": 0.05, "base": 0.07, "lining": { "waves": 2 } }));
    let n_told = Rc::new(Cell::new(0));
    let told = Rc::clone(&n_told);
    let count = move |_| {
        told.set(told.get() + 1);
        ControlFlow::Continue(())
    };
    let error = watched(count, || Pot::new(&design, 0, Product::Pot)).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::NoRoom, "parts[0].wall.lining"));
    assert!(error.message().contains("it cannot be shown to keep far enough from the outside"), "{error}");
    // All pairs would be some 12,000.
    assert!(n_told.get() < 1000, "{}", n_told.get());
}
