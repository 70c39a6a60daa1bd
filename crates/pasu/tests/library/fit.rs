//! What is no pot of rings, as one: a pot of another kind, and a drawn line.

use core::f64::consts::TAU;

use pasu::{
    Arg, Code, Design, Levels, MeshOptions, Profile, Rings, Scan, Shape, Surface, evaluate, fit, fit_levels, fit_scan,
    free, levels, mesh,
};

fn pot(design: &Design) -> &Rings {
    match &design.parts()[0].shape {
        Shape::Rings(pot) => pot,
        other => panic!("{other:?}"),
    }
}

fn surface(design: &Design) -> Surface {
    Surface::of_part(&design.parts()[0], 0).unwrap()
}

/// How far points of one surface are from the other at most, by walking down to the nearest point: independent of how both are run through.
fn apart(from: &Design, to: &Design) -> f64 {
    let (from, to) = (surface(from), surface(to));
    let mut most = 0.0f64;
    for i in 0..=7 {
        for j in 0..11 {
            let (u, turn) = (f64::from(i) / 7.0, f64::from(j) / 11.0);
            let point = from.at(u, turn * from.span()).position;
            let away = |u: f64, v: f64| to.at(u, v * to.span()).position.distance(point);
            // The best of a grid, then ever smaller steps about it.
            let grid = (0..=16).flat_map(|i| (0..48).map(move |j| (f64::from(i) / 16.0, f64::from(j) / 48.0)));
            let (mut u, mut v) = grid.min_by(|a, b| away(a.0, a.1).total_cmp(&away(b.0, b.1))).unwrap();
            let (mut best, mut step) = (away(u, v), 0.02);
            while step > 1e-7 {
                let tries = [(step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step)];
                let better = tries.map(|(du, dv)| ((u + du).clamp(0.0, 1.0), v + dv));
                match better.into_iter().find(|(u, v)| away(*u, *v) < best) {
                    Some(found) => ((u, v), best) = (found, away(found.0, found.1)),
                    None => step *= 0.5,
                }
            }
            most = most.max(best);
        }
    }
    most
}

#[test]
fn every_family_becomes_rings_within_the_tolerance() {
    for (link, most) in [
        ("#1/fourth-order", [2, 2]),
        ("#1/second-order", [8, 17]),
        ("#1/mixed-order", [8, 17]),
        ("#1/bloor-wilson", [2, 5]),
        ("#1/bloor-wilson?a=1&n1=3", [2, 6]),
        ("#1/second-order?r=1,0,.6,0", [3, 5]),
    ] {
        let vase = Design::parse(link).unwrap();
        for (tolerance, most) in [0.03, 0.003].into_iter().zip(most) {
            let freed = free(&vase, 0, tolerance).unwrap_or_else(|error| panic!("{link}: {error}"));
            assert!(freed.distance <= tolerance, "{link}: {}", freed.distance);
            assert!(pot(&freed.design).rings.len() <= most, "{link}: {} rings", pot(&freed.design).rings.len());
            assert!(apart(&freed.design, &vase) <= tolerance * 1.02, "{link}");
            if tolerance == 0.03 && link.contains("bloor") {
                assert!(apart(&vase, &freed.design) <= tolerance * 1.02, "{link}");
            }
        }
    }
}

/// The dint vase is made of the same equation and slopes: two rings say it, exactly but for the waves that are left out.
#[test]
fn a_dint_vase_takes_no_ring_between_its_ends() {
    let vase = Design::parse("#1/bloor-wilson?a=1&n1=3&r=1,0,0,.8&R=-3,0,0,2").unwrap();
    let freed = free(&vase, 0, 1e-6).unwrap();
    assert_eq!(pot(&freed.design).rings.len(), 2);
    assert!(freed.distance < 1e-6 && apart(&vase, &freed.design) < 1e-6, "{}", freed.distance);
}

#[test]
fn rings_are_free_already() {
    let bottle = Design::parse("#1/rings").unwrap();
    let freed = free(&bottle, 0, 0.1).unwrap();
    assert_eq!((freed.design, freed.distance), (bottle, 0.0));
}

#[test]
fn what_is_round_a_part_stays() {
    let vase = Design::parse(
        r#"{"pasu":1,"title":"jar","unit":"mm","parts":[{"shape":{"kind":"second-order","r":[1,0.1,0.6,0.06]}},{"name":"b","object":1,"shape":{"kind":"second-order","r":[1,0,0.6,0]},
        "place":{"shift":[1,2,3]},"wall":{"thickness":0.03,"base":0.04},"look":{"glaze":"cobalt"}}]}"#,
    )
    .unwrap();
    let freed = free(&vase, 1, 0.001).unwrap().design;
    assert_eq!(freed.parts()[0], vase.parts()[0]);
    let (was, is) = (&vase.parts()[1], &freed.parts()[1]);
    assert_eq!((&was.name, &was.wall, &was.place, &was.look), (&is.name, &is.wall, &is.place, &is.look));
    assert!(matches!(is.shape, Shape::Rings(_)) && freed.to_json().contains(r#""title":"jar","unit":"mm""#));
}

/// A part ten times as large as its shape was off ten times as far as asked for, and told a tenth of it.
#[test]
fn a_part_is_off_by_so_much_where_it_stands() {
    let vase = |place: &str| {
        let shape = r#""shape": { "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] }"#;
        Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ {shape}{place} }}] }}"#)).unwrap()
    };
    let own = free(&vase(""), 0, 0.003).unwrap();
    let large = free(&vase(r#", "place": { "scale": [0.5, -10, 2] }"#), 0, 0.03).unwrap();
    assert_eq!(large.design.parts()[0].shape, own.design.parts()[0].shape);
    assert!((large.distance - 10.0 * own.distance).abs() < 1e-15 && large.distance <= 0.03);
    let error = free(&vase(r#", "place": { "scale": [10, 10, 10] }"#), 0, 1e-9).unwrap_err();
    assert_eq!((error.code(), error.arg("found")), (Code::ToleranceTooFine, Some(&Arg::Number(1e-9))));
    let Some(Arg::Number(finest)) = error.arg("reached") else { panic!("{error:?}") };
    assert!((1e-8..1e-7).contains(finest), "{finest}");
}

/// Between the four rows of each bay that rings are looked for with it is up to a fifth further off than at them.
#[test]
fn what_is_told_of_rings_is_so_between_the_places_that_are_looked_at() {
    // Round ones, whose profile is the same wherever it is looked at.
    for link in ["#1/fourth-order", "#1/fourth-order?rm=0.6", "#1/mixed-order?r=1,0,.6,0", "#1/second-order?r=1,0,.6,0"]
    {
        let vase = Design::parse(link).unwrap();
        for tolerance in [0.3, 0.05, 0.003] {
            let freed = free(&vase, 0, tolerance).unwrap();
            let dense: Vec<f64> = (0..=400).flat_map(|i| [f64::from(i) / 400.0, 0.0]).collect();
            let profile = |design: &Design| evaluate(design, 0, &dense).unwrap();
            let [one, other] = [profile(&vase), profile(&freed.design)];
            let line: Vec<[f64; 2]> = one.chunks_exact(3).map(|p| [p[0].hypot(p[1]), p[2]]).collect();
            let off = other.chunks_exact(3).map(|p| away([p[0].hypot(p[1]), p[2]], &line)).fold(0.0, f64::max);
            assert!(freed.distance <= tolerance && off <= freed.distance + 1e-5, "{link}: {off}, {}", freed.distance);
        }
    }
}

/// Boundary data may have corners, a foot that is a point, and be upside down.
#[test]
fn corners_stay_corners_and_a_point_stays_a_point() {
    let mode = |n: u32, axis: &str, [start, ring, end]: [f64; 3]| {
        format!(r#"{{"n":{n},"{axis}":{{"start":{start},"rings":[{ring}],"end":{end}}}}}"#)
    };
    let component = |modes: String| format!(r#"{{"order":4,"s":1,"t":2,"w":1,"free":"both","modes":[{modes}]}}"#);
    for [foot, rim] in [[0.0, 10.0], [10.0, 0.0]] {
        let radii = [if foot == 0.0 { 0.0 } else { 2.0 }, 4.0, if foot == 0.0 { 2.0 } else { 0.0 }];
        let x = component(mode(1, "cos", radii));
        let y = component(mode(1, "sin", radii));
        let z = component(mode(0, "cos", [foot, 5.0, rim]));
        let shape = format!(
            r#"{{"kind":"boundary-value","span":"2pi","rings":[{{"u":0.4,"sharp":true}}],"x":{x},"y":{y},"z":{z}}}"#
        );
        let vase = Design::parse(&format!(r#"{{"pasu":1,"parts":[{{"shape":{shape}}}]}}"#)).unwrap();
        let freed = free(&vase, 0, 1e-4).unwrap();
        assert!(freed.distance <= 1e-4 && apart(&vase, &freed.design) < 1.1e-4);
        let pot = pot(&freed.design);
        assert_eq!(pot.rings.iter().filter(|ring| ring.sharp).count(), 1);
        assert!(pot.rings[0].r.mean == 0.0 && pot.rings[0].r.waves.is_empty() && pot.rings[0].z.mean == 0.0);
    }
}

#[test]
fn what_rings_cannot_say_is_refused() {
    let refused = |link: &str, tolerance| {
        let error = free(&Design::parse(link).unwrap(), 0, tolerance).unwrap_err();
        (error.code(), error.path().to_owned())
    };
    assert_eq!(refused("#1/fourth-order", 0.0), (Code::OutOfRange, "tolerance".into()));
    assert_eq!(refused("#1/fourth-order", f64::NAN), (Code::OutOfRange, "tolerance".into()));
    assert_eq!(refused("#1/fourth-order", 1e-12), (Code::ToleranceTooFine, "tolerance".into()));
    assert_eq!(refused("#1/second-order?n=1,8.5", 0.01), (Code::UnsupportedShape, "parts[0].shape".into()));
    // Petals so deep that they turn back.
    assert_eq!(refused("#1/second-order?r=1,.8,.6,.5", 0.01), (Code::UnsupportedShape, "parts[0].shape".into()));
    for (link, what) in [("#1/second-order?n=1,8.5", "open"), ("#1/second-order?r=1,.8,.6,.5", "turns-back")] {
        let error = free(&Design::parse(link).unwrap(), 0, 0.01).unwrap_err();
        assert_eq!(error.arg("what"), Some(&Arg::from(what)));
    }
    let error = free(&Design::parse("#1/fourth-order").unwrap(), 3, 0.1).unwrap_err();
    assert_eq!(error.code(), Code::NoSuchPoint);
}

/// A drawn line: points at these parts of the way.
fn drawn(n: u32, at: impl Fn(f64) -> [f64; 2]) -> Vec<f64> {
    (0..=n).flat_map(|i| at(f64::from(i) / f64::from(n))).collect()
}

/// How far a point is from a line of straight pieces.
fn away(p: [f64; 2], line: &[[f64; 2]]) -> f64 {
    let to_piece = |pair: &[[f64; 2]]| {
        let ([ax, ay], [bx, by]) = (pair[0], pair[1]);
        let (wx, wy) = (bx - ax, by - ay);
        let part = (((p[0] - ax) * wx + (p[1] - ay) * wy) / (wx * wx + wy * wy)).clamp(0.0, 1.0);
        (p[0] - ax - part * wx).hypot(p[1] - ay - part * wy)
    };
    line.windows(2).map(to_piece).fold(f64::INFINITY, f64::min)
}

/// How far the profile of a pot is from a line of straight pieces, and the other way: by points of both.
fn off(design: &Design, v: f64, line: &[f64]) -> f64 {
    let at: Vec<f64> = (0..=1000).map(|i| f64::from(i) / 1000.0).collect();
    off_at(design, v, line, &at)
}

/// The same with points of the pot at these places.
fn off_at(design: &Design, v: f64, line: &[f64], at: &[f64]) -> f64 {
    let at: Vec<f64> = at.iter().flat_map(|u| [*u, v]).collect();
    let made: Vec<[f64; 2]> =
        evaluate(design, 0, &at).unwrap().chunks_exact(3).map(|p| [p[0] * v.cos(), p[2]]).collect();
    let line: Vec<[f64; 2]> = line.chunks_exact(2).map(|p| [p[0], p[1]]).collect();
    let between = |pair: &[[f64; 2]]| {
        let [from, to] = [pair[0], pair[1]];
        let steps = (1600 / line.len()).max(8) as u32;
        let part = |i: u32| f64::from(i) / f64::from(steps);
        (0..steps).map(|i| [0, 1].map(|k| from[k] + (to[k] - from[k]) * part(i))).collect::<Vec<_>>()
    };
    let dense = line.windows(2).flat_map(between).chain(line.last().copied());
    let far = made.iter().map(|p| away(*p, &line)).fold(0.0, f64::max);
    dense.map(|p| away(p, &made)).fold(far, f64::max)
}

#[test]
fn a_drawn_line_is_met_within_the_tolerance_with_few_rings() {
    let swung = drawn(100, |u| [5.0 + 2.0 * (6.0 * u).sin(), 20.0 * u]);
    let ball = drawn(80, |u| [8.0 * (2.3 * u - 1.2).cos(), 8.0 + 8.0 * (2.3 * u - 1.2).sin()]);
    let shaky =
        drawn(200, |u| [5.0 + 2.0 * (6.0 * u).sin() + 0.02 * (977.0 * u).sin(), 20.0 * u + 0.02 * (1411.0 * u).cos()]);
    for (line, tolerance, most) in [
        (vec![3.0, 0.0, 4.0, 10.0], 0.01, 2),
        (vec![4.0, 10.0, 3.0, 0.0], 0.01, 2),
        (swung.clone(), 0.1, 4),
        (swung, 0.01, 7),
        (ball.clone(), 0.1, 2),
        (ball, 0.01, 4),
        // Finer than the hand shook: the rings do not follow the shaking.
        (shaky, 0.1, 4),
        (vec![0.0, 0.0, 8.0, 0.5, 12.0, 2.0], 0.1, 4),
    ] {
        let found = fit(&Profile::new(line.clone()), tolerance).unwrap();
        let n = pot(&found.design).rings.len();
        assert!(found.distance <= tolerance && n <= most, "{n} rings, {}", found.distance);
        let off = off(&found.design, 0.0, &line);
        assert!(off <= 1.05 * tolerance + 0.001, "{off} of {tolerance}");
    }
}

#[test]
fn sharp_turns_are_sharp_rings_and_what_is_straight_stays_so() {
    let bottle = vec![4.0, 0.0, 5.0, 10.0, 2.0, 14.0, 2.0, 20.0];
    for tolerance in [0.1, 0.001, 1e-6] {
        let found = fit(&Profile::new(bottle.clone()), tolerance).unwrap();
        let pot = pot(&found.design);
        let sharp: Vec<[f64; 2]> =
            pot.rings.iter().filter(|ring| ring.sharp).map(|ring| [ring.r.mean, ring.z.mean]).collect();
        assert_eq!(sharp, [[5.0, 10.0], [2.0, 14.0]]);
        assert_eq!(pot.rings.len(), 4);
        assert!(found.distance <= tolerance && off(&found.design, 0.0, &bottle) <= tolerance + 0.01);
        assert!(found.design.link().len() < 200, "{}", found.design.link());
    }
}

#[test]
fn both_sides_may_differ() {
    let right = drawn(100, |u| [5.0 + 2.0 * (6.0 * u).sin(), 20.0 * u]);
    let left = drawn(100, |u| [5.0 + (6.0 * u).sin() + u, 22.0 * u]);
    let mut profile = Profile::new(right.clone());
    profile.left = Some(left.clone());
    let found = fit(&profile, 0.02).unwrap();
    assert!(found.distance <= 0.02);
    assert!(off(&found.design, 0.0, &right) < 0.026 && off(&found.design, 0.5 * TAU, &left) < 0.026);
    // The same on both sides is a round pot.
    profile.left = Some(right);
    let round = fit(&profile, 0.02).unwrap();
    assert!(pot(&round.design).rings.iter().all(|ring| ring.r.waves.is_empty() && ring.z.waves.is_empty()));
}

/// Round pots of rings, drawn by chance, are found again from points of their own.
#[test]
fn a_pot_is_found_again_from_its_own_profile() {
    let mut seed = 7u64;
    let mut chance = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 40) as f64 / (1u64 << 24) as f64
    };
    for _ in 0..100 {
        let n = 3 + (chance() * 4.0) as usize;
        let radii: Vec<String> = (0..n).map(|_| format!("{:.2}", 2.0 + 6.0 * chance())).collect();
        let heights: Vec<String> =
            (0..n).map(|i| format!("{:.2}", 20.0 * (i as f64 + 0.3 * chance()) / (n - 1) as f64)).collect();
        let link = format!("#1/rings?r={}&z={}", radii.join(","), heights.join(","));
        let drawn_by_chance = Design::parse(&link).unwrap();
        let at: Vec<f64> = (0..=300).flat_map(|i| [f64::from(i) / 300.0, 0.0]).collect();
        let line: Vec<f64> =
            evaluate(&drawn_by_chance, 0, &at).unwrap().chunks_exact(3).flat_map(|p| [p[0], p[2]]).collect();
        if line.iter().step_by(2).any(|r| *r < 0.0) {
            continue;
        }
        let found = fit(&Profile::new(line.clone()), 0.02).unwrap_or_else(|error| panic!("{link}: {error}"));
        let off = off(&found.design, 0.0, &line);
        assert!(found.distance <= 0.02 && off <= 0.022, "{link}: {} {off}", found.distance);
        assert!(pot(&found.design).rings.len() <= 4 * n, "{link}: {}", pot(&found.design).rings.len());
    }
}

/// Lines of few and of many points, of every size: at 480 places the fit was told to be nearer than it is in a quarter of them, and passed the tolerance in one of seven.
#[test]
fn no_drawn_line_is_further_off_than_is_told() {
    let mut seed = 11u64;
    let mut chance = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 40) as f64 / (1u64 << 24) as f64
    };
    let mut found_at_all = 0;
    for _ in 0..60 {
        let n = 3 + (chance() * 10.0) as usize;
        let size = [0.02, 1.0, 100.0][(chance() * 3.0) as usize];
        let mut height = 0.0;
        let mut corners = Vec::new();
        for _ in 0..n {
            corners.push([size * (0.2 + chance()), size * height]);
            height += 0.05 + 0.5 * chance();
        }
        let is_round = chance() < 0.5;
        let line = match is_round {
            false => corners.concat(),
            true => drawn(150, |along| {
                let at = along * (n - 1) as f64;
                let first = (at as usize).min(n - 2);
                let part = at - first as f64;
                let eased = part * part * (3.0 - 2.0 * part);
                let ([r0, z0], [r1, z1]) = (corners[first], corners[first + 1]);
                [r0 + (r1 - r0) * eased, z0 + (z1 - z0) * part]
            }),
        };
        let tolerance = size * [0.2, 0.02, 0.005, 0.001][(chance() * 4.0) as usize];
        let Ok(found) = fit(&Profile::new(line.clone()), tolerance) else { continue };
        found_at_all += 1;
        // Chords of the curve do not cut its corners.
        let mut at: Vec<f64> = (0..=3000).map(|i| f64::from(i) / 3000.0).collect();
        at.extend(pot(&found.design).rings.iter().map(|ring| ring.u));
        at.sort_by(f64::total_cmp);
        at.dedup();
        let off = off_at(&found.design, 0.0, &line, &at);
        assert!(found.distance <= tolerance && off <= found.distance * 1.0001 + 1e-6 * size, "{off} and {found:?}");
        assert!(found.distance <= 1.06 * off + 1e-6 * size + 0.03 * tolerance, "{off} and {found:?}");
    }
    assert!(found_at_all > 50, "{found_at_all}");
}

/// Every pot of the gallery, from points of its own profile: the curve is found again to the tolerance, both ways.
#[test]
fn every_pot_of_the_gallery_is_found_again_from_its_own_points() {
    const POINTS: u32 = 300;
    let gallery: Vec<serde_json::Value> =
        serde_json::from_str(include_str!("../reference/gallery.json")).expect("the gallery is JSON");
    let mut found_again = 0;
    for exhibit in gallery {
        let document = serde_json::json!({ "pasu": 1, "parts": [{ "shape": exhibit["shape"] }] });
        let design = Design::parse(&document.to_string()).unwrap();
        if design.parts()[0].shape.boundary_value().is_none() {
            continue;
        }
        let at: Vec<f64> = (0..=POINTS).flat_map(|i| [f64::from(i) / f64::from(POINTS), 0.0]).collect();
        let points = evaluate(&design, 0, &at).unwrap();
        let line: Vec<f64> = points.chunks_exact(3).flat_map(|p| [p[0].hypot(p[1]), p[2]]).collect();
        let size = line.iter().fold(0.0f64, |size, x| size.max(x.abs()));
        let tolerance = 0.003 * size;
        let found =
            fit(&Profile::new(line.clone()), tolerance).unwrap_or_else(|error| panic!("{}: {error}", exhibit["name"]));
        // Points of either line are compared with pieces between points of the other.
        let off = off(&found.design, 0.0, &line);
        assert!(found.distance <= tolerance && off <= 1.1 * tolerance, "{}: {off} of {tolerance}", exhibit["name"]);
        found_again += 1;
    }
    assert!(found_again >= 40, "{found_again}");
}

/// Two hundred corners were two hundred sharp rings, which no document may have; and thousands of points that go to and fro took minutes.
#[test]
fn what_trembles_has_no_more_rings_than_a_document_may() {
    for n in [200, 4_000] {
        let line =
            drawn(n, |along| [if (along * f64::from(n)).round() % 2.0 == 0.0 { 3.0 } else { 6.0 }, 20.0 * along]);
        let rough = fit(&Profile::new(line.clone()), 1.8).unwrap();
        assert!(rough.distance <= 1.8 && pot(&rough.design).rings.len() <= 66, "{}", rough.distance);
        assert!(Design::parse(&rough.design.link()).is_ok());
        let Err(error) = fit(&Profile::new(line.clone()), 0.01) else { panic!("{n} corners in 66 rings") };
        assert_eq!((error.code(), error.path()), (Code::ToleranceTooFine, "tolerance"));
        // The same on both sides and apart.
        if n == 200 {
            let mut both = Profile::new(line.clone());
            both.left = Some(line.iter().map(|number| 1.01 * number).collect());
            assert!(fit(&both, 2.0).is_ok_and(|found| pot(&found.design).rings.len() <= 66));
        }
    }
}

#[test]
fn what_is_no_line_is_refused() {
    let refused = |right: Vec<f64>, tolerance: f64| {
        let error = fit(&Profile::new(right), tolerance).unwrap_err();
        (error.code(), error.path().to_owned())
    };
    let cone = || vec![3.0, 0.0, 4.0, 10.0];
    assert_eq!(refused(cone(), 0.0), (Code::OutOfRange, "tolerance".into()));
    assert_eq!(refused(vec![], 0.1), (Code::WrongType, "right".into()));
    assert_eq!(refused(vec![1.0, 0.0, 1.0], 0.1), (Code::WrongType, "right".into()));
    assert_eq!(refused(vec![1.0, 0.0, 1.0, f64::NAN], 0.1), (Code::NotFinite, "right[3]".into()));
    assert_eq!(refused(vec![1.0, 0.0, -1.0, 2.0], 0.1), (Code::OutOfRange, "right[2]".into()));
    assert_eq!(refused(vec![1.0, 2.0, 1.0, 2.0], 0.1), (Code::OutOfRange, "right".into()));
    assert_eq!(refused(vec![1e300, 0.0, 1.0, 1e308], 0.1).0, Code::OutOfRange);
    assert_eq!(refused(vec![1.0; 50_000], 0.1), (Code::TooLarge, "right".into()));
    let mut profile = Profile::new(cone());
    profile.left = Some(vec![1.0]);
    assert_eq!(fit(&profile, 0.1).unwrap_err().path(), "left");
    // A hand that shakes more than the tolerance allows, for longer than 66 rings can follow.
    let shaky = drawn(2000, |u| [5.0 + 0.1 * (997.0 * u).sin(), 20.0 * u]);
    assert_eq!(refused(shaky, 0.001), (Code::ToleranceTooFine, "tolerance".into()));
}

/// The outside of a pot as a scan, turned into triangles on a grid.
fn scan_of(design: &Design) -> Scan {
    let options = MeshOptions { rows: Some(160), columns: Some(241), ..MeshOptions::default() };
    let mesh = mesh(design, &options).unwrap();
    let mut scan = Scan::new(mesh.positions);
    scan.indices = Some(mesh.indices);
    scan
}

#[test]
fn a_scan_becomes_rings_where_it_stands() {
    let shape = r#"{ "kind": "rings", "rings": [
        { "u": 0, "r": { "mean": 4, "waves": [{ "n": 5, "cos": 0.2 }] }, "z": { "mean": 0 } },
        { "u": 0.5, "r": { "mean": 6, "waves": [{ "n": 5, "cos": 0.3, "sin": 0.2 }] }, "z": { "mean": 6 } },
        { "u": 1, "r": { "mean": 3 }, "z": { "mean": 14 } }] }"#;
    let text = format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "place": {{ "shift": [3, -2, 5], "axis": [0, 0, 1], "angle": 0.3 }} }}] }}"#
    );
    let pot = Design::parse(&text).unwrap();
    let found = fit_scan(&scan_of(&pot), 0.03).unwrap();
    assert!(found.distance <= 0.03 && found.rms <= found.distance, "{} {}", found.distance, found.rms);
    assert_eq!(found.without_handle, None);
    let [x, y, z] = found.design.parts()[0].place.shift;
    assert!((x - 3.0).abs() < 0.01 && (y + 2.0).abs() < 0.01 && (z - 5.0).abs() < 1e-6, "{x} {y} {z}");
    // Independently: every 97th point of the scan, but for those within a level of its edges, is as near to some point of a fine grid on what was found, whose points are no more than 0.06 apart.
    let options = MeshOptions { rows: Some(500), columns: Some(801), ..MeshOptions::default() };
    let fine = mesh(&found.design, &options).unwrap();
    let points = |positions: &[f32]| positions.as_chunks::<3>().0.iter().map(|p| p.map(f64::from)).collect::<Vec<_>>();
    let (fine, scanned) = (points(&fine.positions), points(&scan_of(&pot).positions));
    for point in scanned.iter().step_by(97).filter(|point| (5.2..18.8).contains(&point[2])) {
        let away = |other: &[f64; 3]| (0..3).map(|i| (other[i] - point[i]).powi(2)).sum::<f64>();
        let nearest = fine.iter().map(away).fold(f64::INFINITY, f64::min).sqrt();
        assert!(nearest < 0.03 + 0.05, "{point:?}: {nearest}");
    }
    assert!(self::pot(&found.design).rings.len() <= 14, "{}", self::pot(&found.design).rings.len());
}

/// As many columns as directions are looked at in: corners lie in these, to rounding.
#[test]
fn a_scan_whose_corners_lie_in_the_directions_is_seen_all_round() {
    let shape = r#"{ "kind": "rings", "rings": [
        { "u": 0, "r": { "mean": 3, "waves": [{ "n": 6, "cos": 0.2 }] }, "z": { "mean": 0 } },
        { "u": 1, "r": { "mean": 4 }, "z": { "mean": 8 } }] }"#;
    for shift in ["[0, 0, 0]", "[5, 0, 1]", "[-37.1, 12.3, 100]"] {
        let text = format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "place": {{ "shift": {shift} }} }}] }}"#);
        let options = MeshOptions { rows: Some(120), columns: Some(181), ..MeshOptions::default() };
        let found = mesh(&Design::parse(&text).unwrap(), &options).unwrap();
        let mut scan = Scan::new(found.positions);
        scan.indices = Some(found.indices);
        let scanned = fit_scan(&scan, 0.05).unwrap_or_else(|error| panic!("{shift}: {error}"));
        assert!(scanned.distance <= 0.05, "{shift}: {}", scanned.distance);
    }
}

#[test]
fn what_a_ring_cannot_say_of_a_scan_is_told() {
    let pot = Design::parse("#1/fourth-order?r0=2&r1=2&rm=3&h1=6").unwrap();
    let mut scan = scan_of(&pot);
    // A handle: what is within 8 degrees of the x axis, half-way up, stands out by 2.
    for point in scan.positions.as_chunks_mut::<3>().0 {
        let [x, y, z] = *point;
        if (1.5..4.5).contains(&z) && y.atan2(x).abs() < 0.14 {
            point[0] += 2.0;
        }
    }
    let found = fit_scan(&scan, 0.05).unwrap();
    let without = found.without_handle.unwrap();
    assert!(found.distance > 1.0 && without.distance < 0.3 && without.rms < 0.06, "{} {without:?}", found.distance);
}

/// One missing triangle ended the pot below it, and what was lost was told nowhere.
#[test]
fn holes_in_a_scan_are_bridged() {
    // Six waves go round, and it is 6 high.
    let pot = Design::parse("#1/fourth-order?r0=2&r1=2&rm=3&h1=6").unwrap();
    let whole = scan_of(&pot);
    let sound = levels(&whole).unwrap();
    assert_eq!(sound.holes, 0.0);
    let without = |is_gone: &dyn Fn([f64; 3]) -> bool| {
        let mut scan = whole.clone();
        let middle = |corners: &[u32; 3]| {
            [0, 1, 2].map(|axis| {
                corners.iter().map(|at| f64::from(whole.positions[3 * *at as usize + axis])).sum::<f64>() / 3.0
            })
        };
        let (kept, gone): (Vec<[u32; 3]>, Vec<[u32; 3]>) =
            whole.indices.as_ref().unwrap().as_chunks::<3>().0.iter().partition(|corners| !is_gone(middle(corners)));
        assert!(!gone.is_empty());
        scan.indices = Some(kept.concat());
        levels(&scan).unwrap()
    };
    let about = |z: f64, most: f64, [from, to]: [f64; 2]| {
        move |at: [f64; 3]| (at[2] - z).abs() < most && (from..to).contains(&at[1].atan2(at[0]))
    };
    let tiny = about(3.0, 0.03, [0.5, 0.54]);
    let [low, high] = [about(0.6, 0.05, [-2.0, -1.9]), about(4.5, 0.05, [1.0, 1.1])];
    // A fifth of the turn and of the height, and from foot to rim.
    let (wide, slit) = (about(3.0, 0.6, [0.3, 1.55]), about(3.0, 9.0, [-1.0, -0.9]));
    let bitten = about(6.0, 1.0, [0.0, 3.1]);
    for (found, holes) in [
        (without(&tiny), 0.001),
        (without(&|at| low(at) || high(at)), 0.002),
        (without(&wide), 0.06),
        (without(&slit), 0.03),
    ] {
        assert_eq!((found.heights.len(), &found.heights), (sound.heights.len(), &sound.heights));
        assert!((found.axis[0] - sound.axis[0]).abs() < 0.02 && (found.axis[1] - sound.axis[1]).abs() < 0.02);
        assert!(found.holes > 0.0 && found.holes < holes, "{} {holes}", found.holes);
        let fitted = fit_levels(&found, 0.05).unwrap().scanned;
        assert!(fitted.distance <= 0.05, "{}", fitted.distance);
        let rings = self::pot(&fitted.design).rings.clone();
        let height = rings.last().unwrap().z.mean - rings[0].z.mean;
        assert!((height - 6.0).abs() < 0.05, "{height}");
    }
    // What is missing at the rim is no hole: the pot ends below.
    let found = without(&bitten);
    assert!((4.9..5.1).contains(found.heights.last().unwrap()) && found.holes == 0.0, "{:?}", found.heights.last());
}

#[test]
fn what_is_no_scan_is_refused() {
    let refused = |scan: &Scan, tolerance: f64, code: Code, path: &str| {
        let error = fit_scan(scan, tolerance).unwrap_err();
        assert_eq!((error.code(), error.path()), (code, path), "{error}");
    };
    refused(&Scan::new(Vec::new()), 1.0, Code::WrongType, "positions");
    refused(&Scan::new(vec![0.0; 10]), 1.0, Code::WrongType, "positions");
    refused(&Scan::new(vec![0.0; 9]), 1.0, Code::UnsupportedShape, "positions");
    refused(&Scan::new(vec![0.0; 9]), 0.0, Code::OutOfRange, "tolerance");
    let mut scan = Scan::new(vec![0.0, 0.0, f32::NAN, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0]);
    refused(&scan, 1.0, Code::NotFinite, "positions[2]");
    scan.positions[2] = 0.0;
    scan.indices = Some(vec![0, 1, 3]);
    refused(&scan, 1.0, Code::OutOfRange, "indices[2]");
    scan.indices = Some(vec![0, 1]);
    refused(&scan, 1.0, Code::WrongType, "indices");
    // The largest numbers there are.
    let far = Scan::new([f32::MAX, -f32::MAX, 0.0].repeat(300));
    assert!(fit_scan(&far, 1.0).is_err());
}

/// A round pot with a belly, level by level.
fn bellied() -> Levels {
    let heights: Vec<f64> = (0..80).map(|i| 0.25 * f64::from(i)).collect();
    let radii = heights.iter().map(|at| vec![6.0 + 2.0 * (at / 6.0).sin(); Levels::DIRECTIONS]).collect();
    Levels::new(heights, radii)
}

#[test]
fn levels_say_where_a_scan_stands_and_fit_as_it_does() {
    let pot = Design::parse("#1/fourth-order?r0=2&r1=2&rm=3&h1=6").unwrap();
    let scan = scan_of(&pot);
    let found = levels(&scan).unwrap();
    let points = scan.positions.as_chunks::<3>().0;
    let (low, high) = points.iter().fold((f32::MAX, f32::MIN), |(low, high), at| (low.min(at[2]), high.max(at[2])));
    assert_eq!((found.bottom, found.height), (f64::from(low), f64::from(high) - f64::from(low)));
    assert_eq!(found.heights.len(), found.radii.len());
    assert!(found.radii.iter().all(|section| section.len() == Levels::DIRECTIONS));
    // The outermost point of each level is one of the scan's, which are that near.
    for (height, section) in found.heights.iter().zip(&found.radii) {
        let near = points.iter().filter(|at| (f64::from(at[2]) - f64::from(low) - height).abs() < 0.05);
        let widest = near.map(|at| f64::from(at[0].hypot(at[1]))).fold(0.0, f64::max);
        assert!((section[0] - widest).abs() < 0.06, "{height}: {} {widest}", section[0]);
    }
    let (whole, by_levels) = (fit_scan(&scan, 0.02).unwrap(), fit_levels(&found, 0.02).unwrap());
    assert_eq!(whole, by_levels.scanned);
}

#[test]
fn distances_from_rings_have_a_sign_and_a_place() {
    let mut levels = bellied();
    let before = fit_levels(&levels, 0.02).unwrap();
    assert!(before.away.iter().all(|away| away.abs() <= 0.02), "{:?}", before.scanned);
    // A dent and a bump, too narrow for the sixteen waves that rings have here.
    let columns = before.away.len() / levels.heights.len();
    let step = Levels::DIRECTIONS / columns;
    let (dent, bump) = ((30, 10), (50, 40));
    levels.radii[dent.0][dent.1 * step] -= 1.0;
    levels.radii[bump.0][bump.1 * step] += 1.0;
    let found = fit_levels(&levels, 0.02).unwrap();
    let at = |(level, column): (usize, usize)| found.away[level * columns + column];
    assert!((-1.0..-0.8).contains(&at(dent)) && (0.8..1.0).contains(&at(bump)), "{} {}", at(dent), at(bump));
    // What is told of the whole is of these.
    let most = found.away.iter().fold(0.0f32, |most, away| most.max(away.abs()));
    let squares: f64 = found.away.iter().map(|away| f64::from(*away).powi(2)).sum();
    assert!((f64::from(most) - found.scanned.distance).abs() < 1e-6);
    assert!(((squares / found.away.len() as f64).sqrt() - found.scanned.rms).abs() < 1e-6);
}

#[test]
fn a_handle_is_among_the_distances() {
    let mut levels = bellied();
    for section in &mut levels.radii[30..50] {
        section[88..93].fill(14.0);
    }
    let found = fit_levels(&levels, 0.05).unwrap();
    let without = found.scanned.without_handle.as_ref().unwrap();
    assert!(without.distance <= 0.05 && found.scanned.distance > 4.0, "{:?}", found.scanned);
    let (least, most) = found.away.iter().fold((0.0f32, 0.0f32), |(low, high), at| (low.min(*at), high.max(*at)));
    assert!((f64::from(most) - found.scanned.distance).abs() < 1e-5 && least > -0.06, "{least} {most}");
}

#[test]
fn rings_are_where_the_axis_of_levels_is() {
    let mut levels = bellied();
    (levels.axis, levels.bottom) = ([3.0, -4.0], 7.0);
    assert_eq!(fit_levels(&levels, 0.05).unwrap().scanned.design.parts()[0].place.shift, [3.0, -4.0, 7.0]);
}

#[test]
fn what_are_no_levels_is_refused() {
    let refused = |change: fn(&mut Levels), code: Code, path: &str| {
        let mut levels = bellied();
        change(&mut levels);
        let error = fit_levels(&levels, 0.05).unwrap_err();
        assert_eq!((error.code(), error.path()), (code, path), "{error}");
    };
    refused(|levels| levels.heights.clear(), Code::WrongType, "heights");
    refused(|levels| levels.radii.truncate(79), Code::WrongType, "heights");
    refused(|levels| levels.heights[5] = levels.heights[4], Code::OutOfRange, "heights[5]");
    refused(|levels| levels.heights[5] = f64::NAN, Code::NotFinite, "heights[5]");
    refused(|levels| levels.radii[7].truncate(179), Code::WrongType, "radii[7]");
    refused(|levels| levels.radii[7][3] = 0.0, Code::OutOfRange, "radii[7][3]");
    refused(|levels| levels.radii[7][3] = f64::INFINITY, Code::NotFinite, "radii[7][3]");
    refused(|levels| levels.axis[1] = f64::NAN, Code::NotFinite, "axis[1]");
    let many: Vec<f64> = (0..=Levels::MOST).map(|i| i as f64).collect();
    let radii = vec![vec![1.0; Levels::DIRECTIONS]; many.len()];
    assert_eq!(fit_levels(&Levels::new(many, radii), 0.05).unwrap_err().code(), Code::TooLarge);
    assert_eq!(fit_levels(&bellied(), f64::NAN).unwrap_err().path(), "tolerance");
}
