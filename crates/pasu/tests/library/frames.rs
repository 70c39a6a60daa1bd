//! Networks of vertex-frames against the reference corpus and against what holds of every network.

use glam::DVec3;
use pasu::{Code, Design, MeshOptions};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::support::design_of;
use crate::support::networks::{Dice, Net, Wrap, cube, edges, farthest, size};

#[derive(Deserialize)]
struct Case {
    name: String,
    shape: Value,
    points: Vec<Point>,
}

#[derive(Deserialize)]
struct Point {
    patch: usize,
    u: f64,
    v: f64,
    position: [f64; 3],
}

fn corpus() -> Vec<Case> {
    serde_json::from_str(include_str!("../reference/frames.json")).expect("the corpus is JSON")
}

/// The case whose values are those of least squares on 9 x 7 points of each patch, along its own `u` and `v`. There the cubic terms of `v` count for 16/15 of those of `u`, so that they depend on how frames are numbered.
const UNEVEN: &str = "2 x 4, global, every direction";

#[test]
fn every_case_of_the_corpus() {
    let cases = corpus();
    assert_eq!(cases.len(), 7);
    for case in &cases {
        let design = design_of(&case.shape.to_string());
        let at: Vec<f64> = case.points.iter().flat_map(|point| [point.patch as f64, point.u, point.v]).collect();
        let found = pasu::evaluate(&design, 0, &at).unwrap();
        let [even, uneven] = [1.0, 16.0 / 15.0].map(|of_v| ByHand::new(&case.shape, of_v));
        for (point, found) in case.points.iter().zip(found.chunks_exact(3)) {
            let (found, expected) = (DVec3::from_slice(found), DVec3::from_array(point.position));
            let least = 1e-12 * size(&case.shape);
            let mut off = found.distance(expected);
            if case.name == UNEVEN {
                assert!(uneven.position(point).distance(expected) <= least, "{} {}", point.u, point.v);
                off = found.distance(even.position(point));
            }
            assert!(off <= least, "{}: {off:e} at {} {} {}", case.name, point.patch, point.u, point.v);
        }
    }
}

/// A network solved once more, as docs/frames.md has it, by the global rule: strips by walking from edge to edge, patches as Coons patches between curves.
struct ByHand {
    points: Vec<[DVec3; 8]>,
    cubic: Vec<[DVec3; 2]>,
}

impl ByHand {
    /// `of_v` is how much the residual of a cubic term of `v` counts, as against one of `u`.
    fn new(shape: &Value, of_v: f64) -> ByHand {
        const SIDES: [[usize; 3]; 4] = [[0, 7, 6], [2, 3, 4], [0, 1, 2], [6, 5, 4]];
        let vertices: Vec<[f64; 3]> = serde_json::from_value(shape["vertices"].clone()).unwrap();
        let patches = shape["patches"].as_array().unwrap();
        let frames: Vec<[usize; 8]> =
            patches.iter().map(|patch| serde_json::from_value(patch["frame"].clone()).unwrap()).collect();
        let three =
            |patch: usize, name: &str| DVec3::from_array(serde_json::from_value(patches[patch][name].clone()).unwrap());
        let points: Vec<[DVec3; 8]> =
            frames.iter().map(|frame| frame.map(|vertex| DVec3::from_array(vertices[vertex]))).collect();
        let mut cubic = vec![[DVec3::ZERO; 2]; frames.len()];
        let mut is_done = vec![[false; 2]; frames.len()];
        for start in (0..2 * frames.len()).map(|k| (k / 2, k % 2)) {
            if is_done[start.0][start.1] {
                continue;
            }
            is_done[start.0][start.1] = true;
            let mut strip = vec![(start, 1.0)];
            let mut next = 0;
            while let Some(&((patch, direction), sign)) = strip.get(next) {
                next += 1;
                for side in [2 - 2 * direction, 3 - 2 * direction] {
                    let edge = SIDES[side].map(|place| frames[patch][place]);
                    for (other, others) in
                        (0..4 * frames.len()).map(|k| (k / 4, k % 4)).filter(|there| *there != (patch, side))
                    {
                        let [a, b, c] = SIDES[others].map(|place| frames[other][place]);
                        let turn = if [a, b, c] == edge { 1.0 } else { -1.0 };
                        let there = usize::from(others < 2);
                        if ([a, b, c] == edge || [c, b, a] == edge) && !is_done[other][there] {
                            is_done[other][there] = true;
                            strip.push(((other, there), turn * sign));
                        }
                    }
                }
            }
            let (mut above, mut below) = (DVec3::ZERO, DVec3::ZERO);
            for ((patch, direction), sign) in &strip {
                let p = &points[*patch];
                let bend = |i: usize, j: usize, k: usize| p[i] - 2.0 * p[j] + p[k];
                let (a, b, g, weight) = match direction {
                    0 => (three(*patch, "a1"), three(*patch, "a2"), bend(2, 3, 4) - bend(0, 7, 6), 1.0),
                    _ => (three(*patch, "a2"), three(*patch, "a1"), bend(6, 5, 4) - bend(0, 1, 2), of_v),
                };
                above += *sign * weight * a * b * (2.0 * g) / 3.0;
                below += weight * a * a;
            }
            for ((patch, direction), sign) in strip {
                cubic[patch][direction] = -sign * above / below;
            }
        }
        ByHand { points, cubic }
    }

    fn position(&self, Point { patch, u, v, .. }: &Point) -> DVec3 {
        let (p, [c3, c6], u, v) = (&self.points[*patch], self.cubic[*patch], *u, *v);
        let curve = |i: usize, j: usize, k: usize, c: DVec3, t: f64| {
            let s = 1.0 - t;
            p[i] * (s * (s - t)) + p[j] * (4.0 * s * t) + p[k] * (t * (t - s)) + c * (t * (t - 0.5) * (t - 1.0))
        };
        let across = (1.0 - v) * curve(0, 1, 2, c3, u) + v * curve(6, 5, 4, c3, u);
        let along = (1.0 - u) * curve(0, 7, 6, c6, v) + u * curve(2, 3, 4, c6, v);
        across + along - (1.0 - v) * ((1.0 - u) * p[0] + u * p[2]) - v * ((1.0 - u) * p[6] + u * p[4])
    }
}

#[test]
fn designs_of_networks_are_canonical_and_have_links() {
    for case in corpus() {
        let design = design_of(&case.shape.to_string());
        let again = Design::parse(&design.to_json()).unwrap();
        assert_eq!(design, again);
        assert!(design.link().starts_with("1~"), "{}", case.name);
        assert_eq!(Design::parse(&design.link()).unwrap(), design);
        assert!(!design.to_json().contains("\"a1\":[1,1,1]") && !design.to_json().contains("global"));
    }
}

#[test]
fn points_are_told_by_patch_u_and_v() {
    let design = design_of(&cube().to_string());
    let error = |at: &[f64]| {
        let error = pasu::evaluate(&design, 0, at).unwrap_err();
        (error.code(), error.path().to_owned(), error.message().to_owned())
    };
    let refused = |at: &[f64], path: &str, message: &str| {
        assert_eq!(error(at), (Code::NoSuchPoint, path.to_owned(), message.to_owned()));
    };
    refused(&[0.0, 0.5], "at", "expected triples (patch, u, v), found 2 numbers");
    refused(&[6.0, 0.5, 0.5], "at[0]", "expected the number of a patch, 0 to 5, found 6");
    refused(&[0.5, 0.5, 0.5], "at[0]", "expected the number of a patch, 0 to 5, found 0.5");
    refused(&[0.0, 0.5, 0.5, 5.0, 0.5, 1.5], "at[5]", "expected v from 0 to 1, found 1.5");
    refused(&[0.0, f64::NAN, 0.5], "at[1]", "expected u from 0 to 1, found NaN");
    let (at, h) = ([3.0, 0.3, 0.8], 1e-6);
    let slopes = pasu::derivatives(&design, 0, &at).unwrap();
    let place = |u: f64, v: f64| DVec3::from_slice(&pasu::evaluate(&design, 0, &[3.0, u, v]).unwrap());
    let du = (place(0.3 + h, 0.8) - place(0.3 - h, 0.8)) / (2.0 * h);
    let dv = (place(0.3, 0.8 + h) - place(0.3, 0.8 - h)) / (2.0 * h);
    assert!(du.distance(DVec3::from_slice(&slopes.du)) < 1e-8 && dv.distance(DVec3::from_slice(&slopes.dv)) < 1e-8);
}

/// A frame begun one corner later: its new `u` is the old `v`, and its new `v` runs against the old `u`.
fn turned(patch: &Value) -> Value {
    let mut patch = patch.clone();
    let frame = patch["frame"].as_array_mut().unwrap();
    frame.rotate_left(2);
    swapped(&mut patch);
    for force in forces(&mut patch) {
        let side: [f64; 2] = serde_json::from_value(force["v"].clone()).unwrap();
        force["v"] = json!([1.0 - side[1], 1.0 - side[0]]);
    }
    patch
}

/// A frame run through the other way round: `u` and `v` change places.
fn mirrored(patch: &Value) -> Value {
    let mut patch = patch.clone();
    let frame = patch["frame"].as_array_mut().unwrap();
    frame.reverse();
    frame.rotate_right(1);
    swapped(&mut patch);
    patch
}

/// The forces of a patch, if it has any: indexing would make them.
fn forces(patch: &mut Value) -> impl Iterator<Item = &mut Value> {
    patch.get_mut("forces").and_then(Value::as_array_mut).into_iter().flatten()
}

fn swapped(patch: &mut Value) {
    let (a1, a2) = (patch["a1"].clone(), patch["a2"].clone());
    (patch["a1"], patch["a2"]) = (a2, a1);
    for force in forces(patch) {
        let (u, v) = (force["u"].clone(), force["v"].clone());
        (force["u"], force["v"]) = (v, u);
    }
}

#[test]
fn the_surface_does_not_depend_on_how_frames_are_numbered_and_patches_ordered() {
    let wraps = [Wrap::Free, Wrap::Joined, Wrap::Reversed];
    for seed in 0..60 {
        let mut dice = Dice(seed);
        let (m, n) = (3 + dice.below(3), 3 + dice.below(3));
        let (along, round) = (wraps[dice.below(3)], wraps[dice.below(3)]);
        let net = Net::grid(m, n, along, round, &mut dice, seed % 2 == 0);
        // Every frame begun anywhere, every patch anywhere, every vertex by another number.
        let order = dice.shuffled(net.patches.len());
        let numbers = dice.shuffled(net.vertices.len());
        let mut other = Net { vertices: net.vertices.clone(), patches: Vec::new() };
        for (vertex, number) in numbers.iter().enumerate() {
            other.vertices[*number] = net.vertices[vertex];
        }
        let mut ways = Vec::new();
        for patch in &order {
            let (turns, is_mirrored) = (dice.below(4), dice.below(2) == 1);
            let mut renumbered = net.patches[*patch].clone();
            for vertex in renumbered["frame"].as_array_mut().unwrap() {
                *vertex = json!(numbers[vertex.as_u64().unwrap() as usize]);
            }
            for _ in 0..turns {
                renumbered = turned(&renumbered);
            }
            if is_mirrored {
                renumbered = mirrored(&renumbered);
            }
            other.patches.push(renumbered);
            ways.push((turns, is_mirrored));
        }
        let designs =
            [net.shape(&json!("global")), other.shape(&json!("global"))].map(|shape| design_of(&shape.to_string()));
        let size = size(&net.shape(&json!("global")));
        for (index, patch) in order.iter().enumerate() {
            let (turns, is_mirrored) = ways[index];
            for _ in 0..6 {
                let (u, v) = (0.5 + 0.5 * dice.number(), 0.5 + 0.5 * dice.number());
                let (mut x, mut y) = (u, v);
                for _ in 0..turns {
                    (x, y) = (y, 1.0 - x);
                }
                if is_mirrored {
                    (x, y) = (y, x);
                }
                let one = pasu::evaluate(&designs[0], 0, &[*patch as f64, u, v]).unwrap();
                let same = pasu::evaluate(&designs[1], 0, &[index as f64, x, y]).unwrap();
                let off = DVec3::from_slice(&one).distance(DVec3::from_slice(&same));
                assert!(off <= 1e-12 * size, "{seed} {along:?} {round:?}: {off:e}");
            }
        }
    }
}

#[test]
fn a_force_goes_on_over_joined_patches() {
    for seed in 200..220 {
        let mut dice = Dice(seed);
        let net = Net::grid(3, 3, Wrap::Free, Wrap::Free, &mut dice, false);
        let falloff = ["sine", "smooth"][dice.below(2)];
        let f0 = dice.three(|x| 5.0 * x);
        // Over all nine patches, from the one in the middle.
        let (from, to) = ([-0.5, -0.75], [1.25, 1.875]);
        let force = json!({ "f0": f0, "u": [from[0], to[0]], "v": [from[1], to[1]], "falloff": falloff });
        let mut sculpted = Net { vertices: net.vertices.clone(), patches: net.patches.clone() };
        sculpted.patches[4]["forces"] = json!([force]);
        // The others lie in any way.
        let mut ways = [0; 9];
        for patch in (0..9).filter(|patch| *patch != 4) {
            ways[patch] = dice.below(4);
            for _ in 0..ways[patch] {
                sculpted.patches[patch] = turned(&sculpted.patches[patch]);
            }
        }
        let [plain, design] = [&net, &sculpted].map(|net| design_of(&net.shape(&json!("global")).to_string()));
        let a = |name: &str| -> [f64; 3] { serde_json::from_value(net.patches[4][name].clone()).unwrap() };
        let (a1, a2) = (a("a1"), a("a2"));
        for _ in 0..60 {
            let (i, j) = (dice.below(3), dice.below(3));
            let (u, v) = (0.5 + 0.5 * dice.number(), 0.5 + 0.5 * dice.number());
            let wave = |at: f64, k: usize| {
                let p = (at - from[k]) / (to[k] - from[k]);
                let sine = if (0.0..=1.0).contains(&p) { (std::f64::consts::PI * p).sin() } else { 0.0 };
                if falloff == "sine" { sine } else { sine * sine }
            };
            let height = wave(u + i as f64 - 1.0, 0) * wave(v + j as f64 - 1.0, 1) / std::f64::consts::PI.powi(2);
            let expected = DVec3::from_array([0, 1, 2].map(|k| -f0[k] / (a1[k] + a2[k]) * height));
            let patch = 3 * i + j;
            let (mut x, mut y) = (u, v);
            for _ in 0..ways[patch] {
                (x, y) = (y, 1.0 - x);
            }
            let flat = DVec3::from_slice(&pasu::evaluate(&plain, 0, &[patch as f64, u, v]).unwrap());
            let found = DVec3::from_slice(&pasu::evaluate(&design, 0, &[patch as f64, x, y]).unwrap());
            assert!((found - flat).distance(expected) < 1e-12, "{seed} {patch}");
        }
        let mesh = pasu::mesh(&design, &MeshOptions { tolerance: Some(0.01), ..MeshOptions::default() }).unwrap();
        assert!(edges(&mesh).iter().all(|times| *times <= 2) && farthest(&design, &mesh) <= 0.01);
    }
}
