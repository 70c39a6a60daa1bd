//! How bodies of revolution about one axis meet, against polygons through many places of their profiles.

use glam::{DQuat, DVec2, DVec3};
use pasu::{Breach, Design, Face, Pot, Product, Severity, constraints};
use serde_json::{Value, json};

use crate::support::design;
use crate::support::networks::Dice;

/// How many random pairs are judged.
fn pairs() -> usize {
    std::env::var("PAIRS").ok().and_then(|text| text.parse().ok()).unwrap_or(60)
}

fn between(dice: &mut Dice, least: f64, greatest: f64) -> f64 {
    least + (greatest - least) * (0.5 + 0.5 * dice.number())
}

fn one_of<T: Copy>(dice: &mut Dice, all: &[T]) -> T {
    all[(between(dice, 0.0, all.len() as f64) as usize).min(all.len() - 1)]
}

fn rings(radii: &[f64], heights: &[f64]) -> Value {
    let height = heights[heights.len() - 1];
    let all: Vec<Value> = radii
        .iter()
        .zip(heights)
        .map(|(r, z)| json!({ "u": z / height, "r": { "mean": r }, "z": { "mean": z } }))
        .collect();
    json!({ "kind": "rings", "rings": all })
}

/// All but a cone: straight to 1e-6.
fn cone(low: f64, high: f64, height: f64) -> Value {
    json!({ "kind": "second-order", "r": [low, 0, high, 0], "t": [0, 0], "n": [1, 2], "height": height, "s": [1e-7, 1e-7] })
}

/// Where a scene stands: scaled, then turned, then moved.
struct Stand {
    scale: f64,
    turn: DQuat,
    shift: DVec3,
}

impl Stand {
    fn upright() -> Stand {
        Stand { scale: 1.0, turn: DQuat::IDENTITY, shift: DVec3::ZERO }
    }

    /// A part that stands at a height on the axis, upside down or not.
    fn place(&self, height: f64, is_upside_down: bool) -> Value {
        let own = if is_upside_down { DQuat::from_rotation_x(std::f64::consts::PI) } else { DQuat::IDENTITY };
        let (axis, angle) = (self.turn * own).to_axis_angle();
        let shift = self.shift + self.turn * DVec3::new(0.0, 0.0, self.scale * height);
        json!({ "scale": [self.scale, self.scale, self.scale], "axis": axis.to_array(), "angle": angle, "shift": shift.to_array() })
    }
}

struct Piece {
    shape: Value,
    wall: Value,
    height: f64,
    is_upside_down: bool,
}

fn scene(pieces: &[Piece], stand: &Stand) -> Design {
    let part = |(object, piece): (usize, &Piece)| {
        let mut wall = piece.wall.clone();
        for field in ["thickness", "base", "drain"] {
            if let Some(length) = wall.get(field).and_then(Value::as_f64) {
                wall[field] = json!(length * stand.scale);
            }
        }
        json!({ "object": object, "shape": piece.shape, "wall": wall, "place": stand.place(piece.height, piece.is_upside_down) })
    };
    let parts: Vec<Value> = pieces.iter().enumerate().map(part).collect();
    design(&json!({ "pasu": 1, "parts": parts }).to_string())
}

/// Places of the profile of a part, in order, about an axis.
fn profile(design: &Design, part: usize, origin: DVec3, axis: DVec3) -> Vec<DVec2> {
    const N: usize = 350;
    let pot = Pot::new(design, part, Product::Pot).unwrap();
    let mut all = Vec::new();
    for face in pot.faces() {
        for i in 0..N {
            let from = face.jet(i as f64 / N as f64, 0.7).position - origin;
            let z = from.dot(axis);
            all.push(DVec2::new((from - axis * z).length(), z));
        }
    }
    let last = pot.faces().last().unwrap().jet(1.0, 0.7).position - origin;
    all.push(DVec2::new((last - axis * last.dot(axis)).length(), last.dot(axis)));
    all
}

fn distance(at: DVec2, polygon: &[DVec2]) -> f64 {
    let mut best = f64::INFINITY;
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let on_axis = 1e-9 * a.y.abs().max(b.y.abs());
        if a.x <= on_axis && b.x <= on_axis {
            continue;
        }
        if (at.y - a.y.max(b.y)).max(a.y.min(b.y) - at.y) > best {
            continue;
        }
        let along = b - *a;
        let square = along.length_squared();
        let share = if square > 0.0 { ((at - *a).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        best = best.min((*a + along * share - at).length());
    }
    best
}

fn is_inside(at: DVec2, polygon: &[DVec2]) -> bool {
    let mut is_in = false;
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        if (a.y <= at.y) != (b.y <= at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y) {
            is_in = !is_in;
        }
    }
    is_in
}

/// How near two profiles come, and how deep a place of one is in the other at most, of the places that there are of them.
fn met(one: &[DVec2], other: &[DVec2]) -> (f64, f64) {
    let (mut near, mut deep) = (f64::INFINITY, 0.0f64);
    for (of, against) in [(one, other), (other, one)] {
        for at in of {
            let away = distance(*at, against);
            near = near.min(away);
            if away > deep && is_inside(*at, against) {
                deep = away;
            }
        }
    }
    (near, deep)
}

/// Two bodies about one axis, made to come near to each other.
fn random(dice: &mut Dice, gap: f64) -> [Piece; 2] {
    let (height, thickness) = (between(dice, 3.0, 9.0), between(dice, 0.15, 0.4));
    let rim = one_of(dice, &["flat", "rounded"]);
    let wall = |side: &str| json!({ "thickness": thickness, "base": thickness, "rim": rim, "side": side });
    let piece = |shape: Value, side: &str, height: f64, is_upside_down: bool| Piece {
        shape,
        wall: wall(side),
        height,
        is_upside_down,
    };
    let top = between(dice, 1.5, 3.0);
    match between(dice, 0.0, 5.0) as usize {
        // A lid over a rim, rim on rim or nearly so.
        0 => {
            let jar = rings(
                &[top * between(dice, 0.6, 1.2), top * between(dice, 0.8, 1.4), top],
                &[0.0, 0.5 * height, height],
            );
            let lid =
                rings(&[0.4 * top, top * between(dice, 0.6, 1.1), top * between(dice, 0.98, 1.02)], &[0.0, 0.6, 1.2]);
            let reach = if rim == "rounded" { thickness } else { 0.0 };
            [
                piece(jar, "inside", 0.0, false),
                piece(lid, "inside", height + 1.2 + gap + reach * between(dice, 0.0, 1.2), true),
            ]
        }
        // A cap round a neck: its lining along the outside, its base on the rim or above it.
        1 => {
            let lean = between(dice, -0.2, 0.3);
            let jar = cone(top + lean * height, top, height);
            let cap = cone(top + gap, top + gap + lean * 0.3 * height, 0.3 * height);
            let above = one_of(dice, &[0.0, 0.1, 1.0]) * 0.3 + gap.max(0.0);
            let reach = if rim == "rounded" { 0.5 * thickness } else { 0.0 };
            [piece(jar, "inside", 0.0, false), piece(cap, "outside", height + above + reach, true)]
        }
        // A plug in a neck, cone in cone.
        2 => {
            let low = top * between(dice, 0.4, 1.0);
            let at = |share: f64| low + (top - low) * share - gap;
            let [from, to] = [between(dice, 0.3, 0.6), between(dice, 0.8, 1.2)];
            [
                piece(cone(low, top, height), "outside", 0.0, false),
                piece(cone(at(from), at(to), (to - from) * height), "inside", from * height, false),
            ]
        }
        // Something round in a neck.
        3 => {
            let low = top * between(dice, 0.5, 0.9);
            let r = 0.5 * (low + top);
            let plug = rings(&[0.4 * r, 0.85 * r, r, 0.8 * r], &[0.0, 0.3 * r, r, 1.7 * r]);
            [
                piece(cone(low, top, height), "outside", 0.0, false),
                piece(plug, "inside", height * between(dice, -0.1, 0.9), false),
            ]
        }
        // The same pots in each other, or one on the other.
        _ => {
            let pot = cone(top, top * between(dice, 1.0, 1.4), height);
            let stacked = one_of(dice, &[thickness, 0.5 * height, height]);
            [piece(pot.clone(), "inside", 0.0, false), piece(pot, "inside", stacked + gap, false)]
        }
    }
}

fn codes(found: &[Breach]) -> Vec<&'static str> {
    found.iter().map(|breach| breach.code).collect()
}

/// No verdict is wrong, by the size of the polygons' own error, and nearly all are told.
#[test]
fn bodies_about_one_axis_meet_as_their_profiles_do() {
    let mut dice = Dice(53);
    let mut counts = std::collections::BTreeMap::<&str, usize>::new();
    for round in 0..pairs() {
        let gap = one_of(&mut dice, &[0.02, 1e-3, 1e-5, 0.0, 0.0, 0.0, -1e-5, -1e-3]);
        let pieces = random(&mut dice, gap);
        let stand = match round % 3 {
            0 => Stand::upright(),
            _ => Stand {
                scale: 10f64.powf(if round % 3 == 1 { 0.0 } else { between(&mut dice, -4.0, 5.0) }),
                turn: DQuat::from_axis_angle(
                    DVec3::new(dice.number(), dice.number(), dice.number()).normalize_or(DVec3::X),
                    between(&mut dice, -3.0, 3.0),
                ),
                shift: DVec3::new(dice.number(), dice.number(), dice.number()) * between(&mut dice, 0.0, 5.0),
            },
        };
        let stand = Stand { shift: stand.shift * stand.scale, ..stand };
        let design = scene(&pieces, &stand);
        let report = constraints(&design, None).unwrap();
        let found = &report.breaches;
        let axis = stand.turn * DVec3::Z;
        let [one, other] = [0, 1].map(|part| profile(&design, part, stand.shift, axis));
        let (near, deep) = met(&one, &other);
        // What the polygons are off: chords of arcs and of bent walls.
        let off = 2.4e-5 * stand.scale + 1e-9;
        let slack = report.slack;
        let told =
            format!("{round}: gap {gap} near {near:e} deep {deep:e} slack {slack:e} {found:?}\n{}", design.to_json());
        let code = match codes(found)[..] {
            [] => {
                assert!(near > slack - off && deep <= off, "{told}");
                "apart"
            }
            ["contact"] => {
                assert!(near <= slack + off && deep <= slack + off, "{told}");
                assert_eq!(found[0].severity, Severity::Note);
                "contact"
            }
            ["interference"] => {
                let breach = &found[0];
                assert!(deep > slack - off, "{told}");
                // The witness is a place of both: in one, as deep as is said, and of the other's border or inside.
                let from = DVec3::from_array(breach.at.unwrap()) - stand.shift;
                // Beside the axis, along which the polygon is closed.
                let beside = (from - axis * from.dot(axis)).length().max(1e-7 * stand.scale);
                let at = DVec2::new(beside, from.dot(axis));
                let depths = [&one, &other].map(|polygon| {
                    let away = distance(at, polygon);
                    if is_inside(at, polygon) { away } else { -away }
                });
                let depth = breach.distance.unwrap();
                assert!(
                    depths[0].max(depths[1]) >= depth - off && depths[0].min(depths[1]) >= -off,
                    "{depths:?} {told}"
                );
                assert!(depth > slack, "{told}");
                "interference"
            }
            ["undecided-interference"] => {
                println!("{told}");
                "undecided"
            }
            _ => panic!("{told}"),
        };
        *counts.entry(code).or_default() += 1;
    }
    println!("{counts:?}");
    let n = |code: &str| counts.get(code).copied().unwrap_or(0);
    assert!(["apart", "contact", "interference"].into_iter().all(|code| 60 * n(code) >= pairs()), "{counts:?}");
    assert!(30 * n("undecided") <= pairs(), "{counts:?}");
}

/// Places all over a part, about an axis: of its profile with so many places to a face, at so many angles.
fn cloud(design: &Design, part: usize) -> Vec<DVec3> {
    const ROUND: usize = 24;
    let pot = Pot::new(design, part, Product::Pot).unwrap();
    let along = |i: usize| i as f64 / 80.0;
    let places = pot.faces().iter().flat_map(|face| (0..=80).map(move |i| (face, along(i))));
    places
        .flat_map(|(face, u)| {
            (0..ROUND).map(move |i| face.jet(u, i as f64 / ROUND as f64 * std::f64::consts::TAU).position)
        })
        .collect()
}

/// As a hand puts a lid on a jar: nearly, but not quite, about one axis. No verdict is wrong, and what has room enough all round is known to be apart.
#[test]
fn bodies_beside_one_axis_meet_as_they_would_about_it_but_for_how_far_they_are_off() {
    let mut dice = Dice(59);
    let mut counts = std::collections::BTreeMap::<&str, usize>::new();
    for round in 0..pairs() {
        let gap = one_of(&mut dice, &[0.1, 0.1, 0.02, 1e-3, 0.0, -1e-3]);
        let mut pieces = random(&mut dice, gap);
        // Not even round.
        if round % 5 == 4 && pieces[1].shape["kind"] == "second-order" {
            pieces[1].shape["r"][1] = json!(0.02 * dice.number());
            pieces[1].shape["n"] = json!([1, 3]);
        }
        let aside = 10f64.powf(between(&mut dice, -5.0, -1.0));
        let tilt = if round % 4 == 3 { 0.1 * aside } else { 0.0 };
        let way = DVec2::from_angle(between(&mut dice, 0.0, 6.0));
        let flush = scene(&pieces, &Stand::upright());
        let mut json: Value = serde_json::from_str(&flush.to_json()).unwrap();
        let place = &mut json["parts"][1]["place"];
        let number = |value: &Value| value.as_f64().unwrap_or(0.0);
        let height = number(&place["shift"][2]);
        let own = if pieces[1].is_upside_down { DQuat::from_rotation_x(std::f64::consts::PI) } else { DQuat::IDENTITY };
        let turn = DQuat::from_rotation_y(tilt) * own;
        let (axis, angle) = turn.to_axis_angle();
        let shift = DVec3::new(aside * way.x, aside * way.y, height);
        *place = json!({ "axis": axis.to_array(), "angle": angle, "shift": shift.to_array() });
        let design = design(&json.to_string());
        let report = constraints(&design, None).unwrap();
        let slack = report.slack;
        let frames = [(DVec3::ZERO, DQuat::IDENTITY), (shift, turn)];
        let is_round = pieces[1].shape["n"] != json!([1, 3]);
        let profiles = [0, 1].map(|part| profile(&design, part, frames[part].0, frames[part].1 * DVec3::Z));
        let seen = |part: usize, at: DVec3| {
            let from = frames[part].1.inverse() * (at - frames[part].0);
            let at = DVec2::new(DVec2::new(from.x, from.y).length().max(1e-7), from.z);
            (distance(at, &profiles[part]), is_inside(at, &profiles[part]))
        };
        // What a profile is off, by its chords, and where it is not round.
        let off = [4e-4, if is_round { 4e-4 } else { 0.045 }];
        let told = format!(
            "{round}: gap {gap} aside {aside} tilt {tilt} slack {slack:e} {:?}\n{}",
            report.breaches,
            design.to_json()
        );
        let code = match codes(&report.breaches)[..] {
            [] => {
                for (part, other) in [(0, 1), (1, 0)] {
                    for at in cloud(&design, part) {
                        let (away, is_inside) = seen(other, at);
                        assert!(!is_inside || away <= off[other], "{at} {away} {told}");
                    }
                }
                "apart"
            }
            ["contact"] => "contact",
            ["interference"] => {
                let breach = &report.breaches[0];
                let at = DVec3::from_array(breach.at.unwrap());
                let depth = breach.distance.unwrap();
                let depths = [0, 1].map(|part| {
                    let (away, is_inside) = seen(part, at);
                    off[part] + if is_inside { away } else { -away }
                });
                assert!(depths[0].max(depths[1]) >= depth && depths[0].min(depths[1]) >= 0.0, "{depths:?} {told}");
                assert!(depth > slack, "{told}");
                "interference"
            }
            ["undecided-interference"] => "undecided",
            _ => panic!("{told}"),
        };
        // What they are off in all: tilted by the reach of the second, beside how far its axis is away.
        let in_all = aside + 12.0 * tilt + if is_round { 0.0 } else { 0.2 };
        let [one, other] = [0, 1].map(|part| profile(&flush, part, DVec3::ZERO, DVec3::Z));
        let (near, deep) = met(&one, &other);
        if deep == 0.0 && near > in_all + slack + 1e-3 {
            assert_eq!(code, "apart", "near {near} {told}");
        } else if deep > in_all + slack + 1e-3 {
            assert_eq!(code, "interference", "deep {deep} {told}");
        }
        *counts.entry(code).or_default() += 1;
    }
    println!("{counts:?}");
    let n = |code: &str| counts.get(code).copied().unwrap_or(0);
    assert!(["apart", "interference"].into_iter().all(|code| 20 * n(code) >= pairs()), "{counts:?}");
    assert!(6 * n("undecided") <= pairs(), "{counts:?}");
}

fn pot(object: u32, shape: Value, thickness: f64, rim: &str, place: Value) -> Value {
    json!({ "object": object, "shape": shape, "wall": { "thickness": thickness, "base": thickness, "rim": rim }, "place": place })
}

fn upside_down(height: f64) -> Value {
    json!({ "axis": [1, 0, 0], "angle": std::f64::consts::PI, "shift": [0, 0, height] })
}

fn cylinder(radius: f64, height: f64) -> Value {
    json!({ "kind": "second-order", "r": [radius, 0, radius, 0], "t": [0, 0], "n": [1, 2], "height": height })
}

/// A cap over a cylinder, which it touches along all of its neck and on its rim, has no plane between them: that nothing of one is deep in the other is what makes it a contact.
#[test]
fn a_cap_that_touches_all_along_a_neck_is_in_contact() {
    let with = |gap: f64, above: f64, object: u32| {
        let parts = [
            pot(0, cylinder(2.0, 5.0), 0.3, "flat", json!({})),
            // Its lining is 2 + gap from the axis, and its ceiling on the rim.
            pot(object, cylinder(2.3 + gap, 1.5), 0.3, "flat", upside_down(5.3 + above)),
        ];
        design(&json!({ "pasu": 1, "parts": parts }).to_string())
    };
    let told = |gap: f64, above: f64| codes(&constraints(&with(gap, above, 1), None).unwrap().breaches);
    assert_eq!(told(0.0, 0.0), ["contact"]);
    assert_eq!(told(0.0, 0.5), ["contact"]);
    assert_eq!(told(1e-9, 1e-9), ["contact"]);
    assert_eq!(told(-1e-8, 0.5), ["contact"]);
    for gap in [0.02, 1e-3, 1e-4, 2e-5] {
        assert_eq!(told(gap, 0.5), Vec::<&str>::new(), "{gap}");
        assert_eq!(told(gap, gap), Vec::<&str>::new(), "{gap}");
        assert_eq!(told(-gap, 0.5), ["interference"], "{gap}");
        assert_eq!(told(gap, -gap), ["interference"], "{gap}");
    }
    // Glued they are connected where they touch, and else not.
    let glued = |gap: f64| constraints(&with(gap, 0.5, 0), None).unwrap().breaches;
    assert!(glued(0.0).iter().all(|breach| breach.code != "not-connected"));
    let loose = glued(0.02);
    assert_eq!(codes(&loose), ["not-connected"]);
    let away = loose[0].distance.unwrap();
    assert!(away > 0.018 && away <= 0.02 + 1e-9, "{away}");
}

/// Pots with thin walls, anyhow beside and through each other: what plainly goes through another is never undecided, and what is told is so.
#[test]
fn walls_that_go_through_each_other_are_told() {
    let mut dice = Dice(67);
    let mut counts = std::collections::BTreeMap::<&str, usize>::new();
    for round in 0..pairs() {
        let mut bellied = |r: f64, h: f64| {
            let share = |dice: &mut Dice, least: f64, most: f64| r * between(dice, least, most);
            let radii = [share(&mut dice, 0.6, 0.9), share(&mut dice, 0.8, 1.1), share(&mut dice, 0.7, 0.9)];
            rings(&radii, &[0.0, 0.5 * h, h])
        };
        let shapes = [bellied(2.0, 6.0), bellied(1.4, 3.5)];
        let thickness = [0.3, 0.1][round % 2];
        let wall = |thickness: f64| json!({ "thickness": thickness, "base": thickness, "rim": "flat" });
        let shift = DVec3::new(2.0 * dice.number(), 2.0 * dice.number(), 2.0 + 3.5 * dice.number());
        let way = DVec3::new(dice.number(), dice.number(), 0.2).normalize();
        let turn = DQuat::from_axis_angle(way, if round % 3 == 0 { 0.0 } else { between(&mut dice, 0.0, 3.0) });
        let (axis, angle) = turn.to_axis_angle();
        let parts = [
            json!({ "object": 0, "shape": shapes[0], "wall": wall(thickness) }),
            json!({ "object": 1, "shape": shapes[1], "wall": wall(0.5 * thickness), "place": { "axis": axis.to_array(), "angle": angle, "shift": shift.to_array() } }),
        ];
        let design = design(&json!({ "pasu": 1, "parts": parts }).to_string());
        let report = constraints(&design, None).unwrap();
        let frames = [(DVec3::ZERO, DQuat::IDENTITY), (shift, turn)];
        let profiles = [0, 1].map(|part| profile(&design, part, frames[part].0, frames[part].1 * DVec3::Z));
        // How deep places of the one are in the other, by its profile.
        let depths = |part: usize, of: &[DVec3]| -> Vec<f64> {
            let depth = |at: &DVec3| {
                let from = frames[part].1.inverse() * (*at - frames[part].0);
                let at = DVec2::new(DVec2::new(from.x, from.y).length().max(1e-7), from.z);
                is_inside(at, &profiles[part]).then(|| distance(at, &profiles[part]))
            };
            of.iter().filter_map(depth).collect()
        };
        let deep = [depths(0, &cloud(&design, 1)), depths(1, &cloud(&design, 0))].concat();
        let n_deep = deep.iter().filter(|depth| **depth > 0.2 * thickness).count();
        let told = format!("{round}: {n_deep} {:?}\n{}", report.breaches, design.to_json());
        let code = match codes(&report.breaches)[..] {
            [] => {
                assert!(deep.iter().all(|depth| *depth < 4e-4), "{told}");
                "apart"
            }
            ["interference"] => {
                let (at, depth) =
                    (DVec3::from_array(report.breaches[0].at.unwrap()), report.breaches[0].distance.unwrap());
                let found = [0, 1].map(|part| depths(part, &[at]).first().copied().unwrap_or(0.0));
                assert!(found[0].max(found[1]) > depth - 4e-4, "{found:?} {told}");
                "interference"
            }
            ["undecided-interference"] => "undecided",
            _ => panic!("{told}"),
        };
        if n_deep > 100 {
            assert_eq!(code, "interference", "{told}");
        }
        *counts.entry(code).or_default() += 1;
    }
    println!("{counts:?}");
    let n = |code: &str| counts.get(code).copied().unwrap_or(0);
    assert!(["apart", "interference"].into_iter().all(|code| 20 * n(code) >= pairs()), "{counts:?}");
    assert!(30 * n("undecided") <= pairs(), "{counts:?}");
}

/// What is not about the same axis, or not round, is apart where there is room for what it is off, and else it is where the axes are furthest apart that it runs into the other.
#[test]
fn what_is_aside_of_the_axis_is_apart_as_far_as_there_is_room() {
    let aside = |x: f64| {
        let parts = [
            pot(0, cylinder(2.0, 5.0), 0.3, "flat", json!({})),
            pot(1, cylinder(1.6, 5.0), 0.2, "flat", json!({ "shift": [x, 0, 1] })),
        ];
        codes(&constraints(&design(&json!({ "pasu": 1, "parts": parts }).to_string()), None).unwrap().breaches)
    };
    // 0.1 all round.
    for x in [0.0, 1e-6, 1e-3, 0.05, 0.09, 0.0999] {
        assert_eq!(aside(x), Vec::<&str>::new(), "{x}");
    }
    for x in [0.1001, 0.11, 0.2] {
        assert_eq!(aside(x), ["interference"], "{x}");
    }
    let petals = |a: f64| {
        let petals = json!({ "kind": "second-order", "r": [1.6, a, 1.6, a], "t": [0, 0], "n": [1, 5], "height": 5 });
        let parts = [
            pot(0, cylinder(2.0, 5.0), 0.3, "flat", json!({})),
            pot(1, petals, 0.2, "flat", json!({ "shift": [0, 0, 1] })),
        ];
        codes(&constraints(&design(&json!({ "pasu": 1, "parts": parts }).to_string()), None).unwrap().breaches)
    };
    assert_eq!(petals(0.01), Vec::<&str>::new());
    let is_met = |codes: &[&str]| [["interference"], ["undecided-interference"]].iter().any(|told| codes == told);
    assert!(is_met(&petals(0.2)), "{:?}", petals(0.2));
}

/// Foot rings and drains are of the profile, a surface without an inside may stand in a solid's hollow but not in its wall, and a pot all of which is in a plug is within it.
#[test]
fn feet_drains_bare_surfaces_and_what_is_within_are_told() {
    let told = |parts: [Value; 2]| {
        codes(&constraints(&design(&json!({ "pasu": 1, "parts": parts }).to_string()), None).unwrap().breaches)
    };
    let jar = |wall: Value| json!({ "object": 0, "shape": cylinder(2.0, 5.0), "wall": wall });
    let pin = |radius: f64, z: f64| pot(1, cylinder(radius, 2.0), 0.05, "flat", json!({ "shift": [0, 0, z] }));
    // A hole 0.4 from the axis, and a hollow 0.3 high beneath the base, 1.6 from it.
    let with_drain = || jar(json!({ "thickness": 0.3, "base": 0.3, "drain": 0.8 }));
    let with_foot = || jar(json!({ "thickness": 0.3, "base": 0.3, "foot": [0.4, 0.3] }));
    assert_eq!(told([with_drain(), pin(0.399, -1.0)]), Vec::<&str>::new());
    assert_eq!(told([with_drain(), pin(0.401, -1.0)]), ["interference"]);
    assert_eq!(told([with_foot(), pin(1.599, -1.71)]), Vec::<&str>::new());
    assert_eq!(told([with_foot(), pin(1.599, -1.69)]), ["interference"]);
    assert_eq!(told([with_foot(), pin(1.601, -1.71)]), ["interference"]);
    let bare = |radius: f64| json!({ "object": 1, "shape": cylinder(radius, 2.0), "place": { "shift": [0, 0, 1] } });
    let plain = || jar(json!({ "thickness": 0.3, "base": 0.3 }));
    assert_eq!(told([plain(), bare(1.699)]), Vec::<&str>::new());
    // All of it is in the clay then.
    assert_eq!(told([plain(), bare(1.701)]), ["interference", "within"]);
    let disc = |z: f64| json!({ "form": "disc", "radius": [3, 3], "z": z, "taper": 0, "dz": 4 });
    let plug = json!({ "object": 0, "shape": { "kind": "blend", "start": disc(0.0), "end": disc(4.0) } });
    // Its waist is 0.1374 from the axis.
    assert_eq!(told([plug.clone(), pin(0.137, 1.0)]), ["interference", "within"]);
    assert_eq!(told([plug.clone(), pin(0.138, 1.0)]), ["interference"]);
    assert_eq!(told([plug.clone(), pin(1.0, 4.001)]), Vec::<&str>::new());
    assert_eq!(told([plug.clone(), pin(1.0, 4.0)]), ["contact"]);
    assert_eq!(told([plug, pin(1.0, 3.999)]), ["interference"]);
}
