//! Scenes: one link and one fingerprint for a set of parts, however they were written.

use std::f64::consts::PI;

use pasu::{Design, Format, Making, Placement, Product, Shape, Size, Solution, compare, fingerprint, open};
use serde_json::{Value, json};

use crate::support::design;
use crate::support::networks::Dice;

pub(crate) fn scene(parts: &[Value]) -> Design {
    design(&json!({ "pasu": 1, "parts": parts }).to_string())
}

/// A whole number below `n`.
pub(crate) fn below(dice: &mut Dice, n: usize) -> usize {
    (((0.5 + 0.5 * dice.number()) * n as f64) as usize).min(n - 1)
}

/// A number of four decimals between two others.
fn between(dice: &mut Dice, least: f64, greatest: f64) -> f64 {
    ((least + (greatest - least) * (0.5 + 0.5 * dice.number())) * 1e4).round() / 1e4
}

pub(crate) fn shuffled<T>(dice: &mut Dice, items: &mut [T]) {
    for last in (1..items.len()).rev() {
        let other = below(dice, last + 1);
        items.swap(last, other);
    }
}

pub(crate) fn part(dice: &mut Dice, index: usize) -> Value {
    let number = |dice: &mut Dice| between(dice, 0.5, 3.0);
    let shape = match below(dice, 4) {
        0 => {
            // Round, or with petals of two, four or seven.
            let n = [0, 3, 5, 8][below(dice, 4)];
            let [rim, foot] = if n == 0 { [0.0; 2] } else { [0.1, 0.06] };
            let r = [number(dice), rim, number(dice), foot];
            json!({ "kind": "second-order", "r": r, "n": [1, n], "height": number(dice) })
        }
        1 => json!({ "kind": "rings", "rings": [
            { "u": 0, "r": { "mean": number(dice) }, "z": { "mean": 0 } },
            { "u": 0.5, "r": { "mean": number(dice), "waves": [{ "n": 5, "cos": 0.1 }] }, "z": { "mean": 2 } },
            { "u": 1, "r": { "mean": number(dice) }, "z": { "mean": 4 } },
        ] }),
        // Exponents and factors that are often equal.
        _ => {
            let exponents = [(); 3].map(|()| [0.5, 2.0, 8.0][below(dice, 3)]);
            json!({ "kind": "octant", "exponents": exponents })
        }
    };
    let scale = [(); 3].map(|()| [1.0, 1.0, 2.0, -1.0, -1.5][below(dice, 5)]);
    let axis = [(); 3].map(|()| between(dice, -1.0, 1.0) + 1e-3);
    let shift = [(); 3].map(|()| between(dice, -9.0, 9.0));
    let place = json!({ "scale": scale, "axis": axis, "angle": between(dice, -3.0, 3.0), "shift": shift });
    let object = below(dice, 3);
    let mut part = json!({ "shape": shape, "place": place, "object": object });
    if below(dice, 2) == 0 {
        part["name"] = json!(format!("part {index}"));
    }
    part
}

pub(crate) fn numbers(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|index| value[index].as_f64().unwrap())
}

/// The same turn about the opposite axis of another length, and whole turns besides.
fn placed_otherwise(dice: &mut Dice, part: &mut Value) {
    let place = &mut part["place"];
    let (length, turns) = (between(dice, 0.2, 3.0), below(dice, 3) as f64 - 1.0);
    let angle = place["angle"].as_f64().unwrap();
    // Whole turns on top of an angle that needs all its digits take some of them away.
    let turns = if (angle * 1e6).fract() == 0.0 { turns } else { 0.0 };
    place["axis"] = json!(numbers(&place["axis"]).map(|c| -c * length));
    place["angle"] = json!(2.0 * PI * turns - angle);
}

/// The rotation of a placement, as rows.
pub(crate) fn rotation(place: &Value) -> [[f64; 3]; 3] {
    let axis = numbers(&place["axis"]);
    let length = axis.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [h, k, l] = axis.map(|c| c / length);
    let (sin, cos) = place["angle"].as_f64().unwrap().sin_cos();
    let t = 1.0 - cos;
    [
        [cos + h * h * t, h * k * t - l * sin, h * l * t + k * sin],
        [h * k * t + l * sin, cos + k * k * t, k * l * t - h * sin],
        [h * l * t - k * sin, k * l * t + h * sin, cos + l * l * t],
    ]
}

/// An octant with its exponents in another order, and its axes with them: a third of a turn about (1, 1, 1) of its own first.
fn permuted(part: &mut Value) {
    let [a, b, c] = numbers(&part["shape"]["exponents"]);
    part["shape"]["exponents"] = json!([b, c, a]);
    let place = &mut part["place"];
    let [sx, sy, sz] = numbers(&place["scale"]);
    place["scale"] = json!([sy, sz, sx]);
    let rows = rotation(place).map(|[x, y, z]| [y, z, x]);
    turned(place, rows);
}

/// Turns a placement as this rotation does, by its rows.
fn turned(place: &mut Value, rows: [[f64; 3]; 3]) {
    let vector = [rows[2][1] - rows[1][2], rows[0][2] - rows[2][0], rows[1][0] - rows[0][1]];
    let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
    place["axis"] = json!(vector);
    place["angle"] = json!(length.atan2(rows[0][0] + rows[1][1] + rows[2][2] - 1.0));
}

/// A vase that was turned about its own axis first, or mirrored in a plane through it, so that it is the same solid.
fn moved_within_itself(dice: &mut Dice, part: &mut Value, fold: Option<usize>) {
    let place = &mut part["place"];
    let [sx, sy, sz] = numbers(&place["scale"]);
    let is_even = sx.abs() == sy.abs();
    let quarters = match fold {
        _ if is_even => 0,
        None => below(dice, 4),
        Some(fold) if fold % 4 == 0 => below(dice, 4),
        Some(fold) if fold % 2 == 0 => 2 * below(dice, 2),
        Some(_) => 0,
    };
    let (sin, cos) = match (is_even, fold) {
        (true, None) => between(dice, -3.0, 3.0).sin_cos(),
        (true, Some(fold)) => (2.0 * PI * below(dice, fold) as f64 / fold as f64).sin_cos(),
        (false, _) => [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarters],
    };
    // The columns of the placement, of which the second may change its sense.
    let columns = rotation(place).map(|[x, y, z]| [x * sx.signum(), y * sy.signum(), z * sz.signum()]);
    let sense = if below(dice, 2) == 0 { 1.0 } else { -1.0 };
    let columns = columns.map(|[x, y, z]| [x * cos + y * sin, sense * (y * cos - x * sin), z]);
    let hand = sense * (sx * sy * sz).signum();
    let lengths = if quarters % 2 == 1 { [sy.abs(), sx.abs()] } else { [sx.abs(), sy.abs()] };
    place["scale"] = json!([lengths[0], hand * lengths[1], sz.abs()]);
    turned(place, columns.map(|[x, y, z]| [x, hand * y, z]));
}

/// By how many turns a vase is its own image; any where there is no number.
fn fold_of(shape: &Value) -> Option<usize> {
    match shape["kind"].as_str().unwrap() {
        "rings" => Some(5),
        _ if shape["r"][1] == 0.0 => None,
        _ => shape["n"][1].as_u64().map(|n| n as usize - 1),
    }
}

/// The same scene in other words.
fn rewritten(dice: &mut Dice, parts: &[Value]) -> Vec<Value> {
    let mut numbers: Vec<usize> = (0..9).collect();
    shuffled(dice, &mut numbers);
    let mut parts = parts.to_vec();
    for part in &mut parts {
        part["object"] = json!(numbers[part["object"].as_u64().unwrap() as usize]);
        if part["shape"]["kind"] == "octant" {
            (0..below(dice, 3)).for_each(|_| permuted(part));
        }
        if below(dice, 2) == 0 {
            placed_otherwise(dice, part);
        }
    }
    shuffled(dice, &mut parts);
    parts
}

#[test]
fn a_scene_has_one_link_and_one_fingerprint_however_it_is_written() {
    let mut dice = Dice(41);
    for _ in 0..60 {
        let n = 1 + below(&mut dice, 6);
        let parts: Vec<Value> = (0..n).map(|index| part(&mut dice, index)).collect();
        let first = scene(&parts);
        let link = first.link();
        assert_eq!(Design::parse(&link).unwrap(), first.ordered());
        assert_eq!(Design::parse(&link).unwrap().link(), link);
        for _ in 0..3 {
            let other = scene(&rewritten(&mut dice, &parts));
            assert_eq!(other.ordered().to_json(), first.ordered().to_json());
            assert_eq!((other.link(), fingerprint(&other)), (link.clone(), fingerprint(&first)));
        }
        // Any change of one part is another scene.
        let mut changed = parts.clone();
        let index = below(&mut dice, n);
        let factor = changed[index]["place"]["scale"][0].as_f64().unwrap();
        changed[index]["place"]["scale"][0] = json!(factor * 1.01);
        let changed = scene(&changed);
        assert_ne!(changed.link(), link);
        assert_ne!(fingerprint(&changed), fingerprint(&first));
        let fewer = &parts[1..];
        if !fewer.is_empty() {
            assert_ne!(scene(fewer).link(), link);
            assert_ne!(fingerprint(&scene(fewer)), fingerprint(&first));
        }
    }
}

/// A file tells the link of its design, and whoever opens that and writes it again has the same file.
#[test]
fn a_scene_has_one_file_however_its_parts_are_ordered() {
    let mut dice = Dice(43);
    let vase = |index: usize, height: f64| {
        let shape = json!({ "kind": "second-order", "r": [3.0 + index as f64, 0, 2, 0], "height": height });
        json!({ "shape": shape, "wall": { "thickness": 0.4, "base": 0.5 }, "place": { "shift": [9 * index, 0, 0] } })
    };
    for round in 0..6 {
        let n = 2 + below(&mut dice, 3);
        let mut parts: Vec<Value> = (0..n).map(|index| vase(index, between(&mut dice, 3.0, 9.0))).collect();
        parts.extend((0..round % 3).map(|index| part(&mut dice, index)));
        let size = [None, Some(Size::Capacity(1.0)), Some(Size::Width(200.0)), Some(Size::Height(80.0))][round % 4];
        let product = if round < 4 { Product::Pot } else { Product::Solid };
        let making = Making { size, product, tolerance: Some(0.1), ..Making::default() };
        let making = if product == Product::Solid { Making { size: None, ..making } } else { making };
        let first = Solution::of(&scene(&parts));
        shuffled(&mut dice, &mut parts);
        let other = Solution::of(&scene(&parts));
        let mut opened: Vec<(String, Solution)> = Vec::new();
        for format in Format::ALL {
            let file = first.write(format, &making);
            let Ok(bytes) = file else {
                assert_eq!(other.write(format, &making).unwrap_err().code(), file.unwrap_err().code());
                continue;
            };
            assert!(other.write(format, &making).unwrap() == bytes, "{format:?} in round {round}");
            let Some(link) = open(&bytes) else { continue };
            // Files of one making tell one link, mostly.
            if opened.last().is_none_or(|(last, _)| *last != link) {
                opened.push((link.clone(), Solution::of(&Design::parse(&link).unwrap())));
            }
            let (_, again) = opened.last().unwrap();
            assert!(again.write(format, &making).unwrap() == bytes, "{format:?} of {link}");
        }
    }
}

/// Where points of a part stand, at so many places round its axis.
fn points(design: &Design, place: &Placement, n: usize) -> Vec<[f64; 3]> {
    let is_unit = matches!(design.parts()[0].shape, Shape::SecondOrder(_));
    let round = if is_unit { 1.0 } else { 2.0 * PI };
    let at: Vec<f64> = (0..n).flat_map(|i| [0.3, round * i as f64 / n as f64]).collect();
    let (rows, shift) = (place.matrix(), place.shift);
    let placed = |p: &[f64]| [0, 1, 2].map(|i| (0..3).map(|j| rows[i][j] * p[j]).sum::<f64>() + shift[i]);
    pasu::evaluate(design, 0, &at).unwrap().chunks_exact(3).map(placed).collect()
}

/// A round vase may be turned about its axis as one likes, one with petals by as many parts of a turn, and either may be mirrored.
/// Rounding to twelve digits leaves the last one open: two descriptions of one placement that were turned into each other by computing differ in it now and then.
#[test]
fn a_vase_has_one_placement_of_those_that_make_the_same_solid() {
    let mut dice = Dice(47);
    let (mut n_vases, mut n_equal) = (0, 0);
    while n_vases < 600 {
        let mut part = part(&mut dice, 0);
        if part["shape"]["kind"] == "octant" {
            continue;
        }
        n_vases += 1;
        let first = scene(std::slice::from_ref(&part));
        let found = first.parts()[0].place;
        assert_eq!(scene(&[serde_json::from_str(&part_json(&first)).unwrap()]), first, "not its own canonical form");
        let given = place_of(&part["place"]);
        // Every sixtieth of a turn and every seventh is there: petals come to petals.
        let (before, after) = (points(&first, &given, 840), points(&first, &found, 840));
        if part["shape"]["r"][1] != 0.0 {
            for point in before.iter().step_by(97) {
                let distance = |other: &[f64; 3]| (0..3).map(|i| (point[i] - other[i]).powi(2)).sum::<f64>().sqrt();
                let nearest = after.iter().map(distance).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-9, "{nearest} in {part}\n{found:?}");
            }
        }
        let fold = fold_of(&part["shape"]);
        moved_within_itself(&mut dice, &mut part, fold);
        let second = scene(std::slice::from_ref(&part));
        let other = second.parts()[0].place;
        assert_eq!(other.scale, found.scale, "{part}");
        let numbers = |place: &Placement| [place.axis[0], place.axis[1], place.axis[2], place.angle];
        for (one, other) in numbers(&found).into_iter().zip(numbers(&other)) {
            // One in the last place; of an angle beyond 1 that is ten times as much.
            assert!((one - other).abs() < 1.1e-11, "{part}\n{found:?}\n{other:?}");
        }
        if first.link() == second.link() {
            n_equal += 1;
            if n_vases % 10 == 0 {
                assert_eq!(fingerprint(&first), fingerprint(&second));
            }
        }
    }
    assert!(n_equal > 590, "{n_equal} of {n_vases}");
}

/// A blend, and by how many turns it is its own image.
fn blend(dice: &mut Dice) -> (Value, Option<usize>) {
    let size = |dice: &mut Dice| between(dice, 0.5, 2.0);
    let disc = |[x, y]: [f64; 2]| json!({ "form": "disc", "radius": [x, y] });
    let (start, end, fold) = match below(dice, 5) {
        0 => {
            let [one, other] = [size(dice), size(dice)];
            (disc([one; 2]), disc([other; 2]), None)
        }
        1 => (disc([1.0, size(dice) + 1.0]), disc([2.0; 2]), Some(2)),
        2 => {
            let petals = |size: f64| {
                json!({ "form": "outline",
                "x": [{ "n": 1, "cos": 2 }, { "n": 4, "cos": size }], "y": [{ "n": 1, "sin": 2 }, { "n": 4, "sin": -size }] })
            };
            (petals(between(dice, 0.1, 0.3)), disc([0.0; 2]), Some(5))
        }
        3 => {
            let square = |size: f64| json!({ "form": "rectangle", "radius": [size, size] });
            (square(size(dice)), square(size(dice)), Some(4))
        }
        _ => {
            let form = ["rectangle", "disc-in-square"][below(dice, 2)];
            let rectangle = json!({ "form": "rectangle", "radius": [size(dice), 1.5 + size(dice)] });
            (json!({ "form": form, "radius": [1, size(dice)] }), rectangle, Some(2))
        }
    };
    let [mut start, mut end] = [start, end];
    if end["radius"][0] == 0.0 {
        end = start.clone();
    }
    for (section, z) in [(&mut start, 0.0), (&mut end, 3.0)] {
        let [taper, dz] = [between(dice, -0.2, 0.2), between(dice, 1.0, 3.0)];
        for (name, value) in [("z", z), ("taper", taper), ("dz", dz)] {
            section[name] = json!(value);
        }
    }
    (json!({ "kind": "blend", "start": start, "end": end }), fold)
}

/// As a vase, between sections of any form.
#[test]
fn a_blend_has_one_placement_of_those_that_make_the_same_solid() {
    let mut dice = Dice(48);
    let n_blends = 300;
    let mut n_equal = 0;
    for index in 0..n_blends {
        let mut part = part(&mut dice, 0);
        let (shape, fold) = blend(&mut dice);
        part["shape"] = shape;
        let first = scene(std::slice::from_ref(&part));
        let found = first.parts()[0].place;
        assert_eq!(scene(&[serde_json::from_str(&part_json(&first)).unwrap()]), first, "not its own canonical form");
        if index % 10 == 0 {
            // Every fortieth of u and of v is there: of the square that they run over, its images, and every fifth and half of a turn.
            let at: Vec<f64> =
                (0..41 * 41).flat_map(|k| [f64::from(k / 41) / 40.0, f64::from(k % 41) / 40.0, 0.3]).collect();
            let points = |place: &Placement| -> Vec<[f64; 3]> {
                let (rows, shift) = (place.matrix(), place.shift);
                let placed = |p: &[f64]| [0, 1, 2].map(|i| (0..3).map(|j| rows[i][j] * p[j]).sum::<f64>() + shift[i]);
                pasu::evaluate(&first, 0, &at).unwrap().chunks_exact(3).map(placed).collect()
            };
            let (before, after) = (points(&place_of(&part["place"])), points(&found));
            for point in before.iter().step_by(13).filter(|_| fold.is_some()) {
                let distance = |other: &[f64; 3]| (0..3).map(|i| (point[i] - other[i]).powi(2)).sum::<f64>().sqrt();
                let nearest = after.iter().map(distance).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-9, "{nearest} in {part}\n{found:?}");
            }
        }
        moved_within_itself(&mut dice, &mut part, fold);
        let second = scene(std::slice::from_ref(&part));
        let other = second.parts()[0].place;
        assert_eq!(other.scale, found.scale, "{part}");
        let numbers = |place: &Placement| [place.axis[0], place.axis[1], place.axis[2], place.angle];
        for (one, other) in numbers(&found).into_iter().zip(numbers(&other)) {
            assert!((one - other).abs() < 1.1e-11, "{part}\n{found:?}\n{other:?}");
        }
        n_equal += usize::from(first.link() == second.link());
    }
    assert!(n_equal > 290, "{n_equal} of {n_blends}");
}

fn part_json(design: &Design) -> String {
    let document: Value = serde_json::from_str(&design.to_json()).unwrap();
    document["parts"][0].to_string()
}

fn place_of(place: &Value) -> Placement {
    let [scale, axis, shift] = ["scale", "axis", "shift"].map(|name| numbers(&place[name]));
    let mut found = Placement::default();
    (found.scale, found.axis, found.shift) = (scale, axis, shift);
    found.angle = place["angle"].as_f64().unwrap();
    found
}

#[test]
fn which_parts_are_glued_is_part_of_the_link() {
    let octant = |x: f64, object: usize| json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "shift": [x, 0, 0] }, "object": object });
    let of = |objects: [usize; 3]| scene(&[octant(0.0, objects[0]), octant(1.0, objects[1]), octant(2.0, objects[2])]);
    assert_eq!(of([0, 0, 1]).link(), of([5, 5, 2]).link());
    assert_ne!(of([0, 0, 1]).link(), of([0, 1, 1]).link());
    assert_eq!(fingerprint(&of([0, 0, 1])), fingerprint(&of([0, 1, 1])));
    // Parts in one place, of objects that only the others in them tell apart.
    let twins = |parts: &[(f64, usize)]| {
        scene(&parts.iter().map(|(x, object)| octant(*x, *object)).collect::<Vec<Value>>()).link()
    };
    let link = twins(&[(0.0, 0), (0.0, 1), (1.0, 0), (2.0, 1)]);
    assert_eq!(twins(&[(2.0, 0), (0.0, 3), (0.0, 0), (1.0, 3)]), link);
    assert_ne!(twins(&[(0.0, 0), (0.0, 1), (1.0, 0), (2.0, 0)]), link);
}

/// ASB88's sphere: eight octants, by mirror images or by turns.
#[test]
fn a_ball_of_octants_has_one_link() {
    let octant = |place: Value| json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": place });
    let signs = || (0..8).map(|corner| [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { 1.0 } else { -1.0 }));
    let mirrored: Vec<Value> = signs().map(|scale| octant(json!({ "scale": scale }))).collect();
    let mut turned: Vec<Value> = (0..4)
        .map(|quarter| octant(json!({ "angle": f64::from(quarter) * PI / 2.0 })))
        .chain((0..4).map(|quarter| octant(json!({ "scale": [1, 1, -1], "angle": f64::from(quarter) * PI / 2.0 }))))
        .collect();
    turned.reverse();
    assert_eq!(scene(&mirrored).link(), scene(&turned).link());
    assert_eq!(fingerprint(&scene(&mirrored)), fingerprint(&scene(&turned)));
}

fn pairs(list: &[pasu::Counterpart]) -> Vec<(usize, usize)> {
    list.iter().map(|pair| (pair.before, pair.after)).collect()
}

#[test]
fn comparing_finds_the_same_scene_in_other_words() {
    let mut dice = Dice(18);
    for _ in 0..20 {
        let n = 1 + below(&mut dice, 12);
        let parts: Vec<Value> = (0..n).map(|index| part(&mut dice, index)).collect();
        let (first, other) = (scene(&parts), scene(&rewritten(&mut dice, &parts)));
        let difference = compare(&first, &other);
        assert!(difference.is_same && difference.reglued.is_empty(), "{difference:?}");
        assert_eq!(difference.kept.len(), n);
        for pair in &difference.kept {
            assert_eq!(first.parts()[pair.before].shape, other.parts()[pair.after].shape);
            assert_eq!(first.parts()[pair.before].place, other.parts()[pair.after].place);
        }
        // Names and titles are not compared.
        let mut nameless = parts.clone();
        nameless.iter_mut().for_each(|part| drop(part.as_object_mut().unwrap().remove("name")));
        assert!(compare(&first, &scene(&nameless)).is_same);
    }
}

#[test]
fn comparing_tells_what_became_of_each_part() {
    let octant = |exponents: [f64; 3], shift: [f64; 3]| json!({ "shape": { "kind": "octant", "exponents": exponents }, "place": { "shift": shift } });
    let named = |mut part: Value, name: &str| {
        part["name"] = json!(name);
        part
    };
    let glazed = |mut part: Value, glaze: &str| {
        part["look"] = json!({ "glaze": glaze });
        part
    };
    let turned = |mut part: Value| {
        part["place"]["axis"] = json!([1, 1, 0.2]);
        part["place"]["angle"] = json!(2.9);
        part
    };
    let before = scene(&[
        octant([2.0, 3.0, 4.0], [0.0; 3]),
        octant([1.0, 2.0, 6.0], [5.0, 0.0, 0.0]),
        named(octant([2.0; 3], [9.0, 0.0, 0.0]), "knob"),
        octant([8.0; 3], [0.0, 9.0, 0.0]),
        octant([0.5; 3], [0.0, 0.0, 9.0]),
    ]);
    let after = scene(&[
        octant([7.0; 3], [1.0; 3]),
        glazed(octant([8.0; 3], [0.0, 9.0, 0.0]), "cobalt"),
        named(octant([2.0, 2.0, 5.0], [9.0, 0.0, 1.0]), "knob"),
        turned(octant([1.0, 2.0, 6.0], [5.0, 0.0, 0.0])),
        octant([2.0, 3.0, 4.0], [0.0; 3]),
    ]);
    let difference = compare(&before, &after);
    assert!(!difference.is_same);
    assert_eq!(pairs(&difference.kept), [(0, 4)]);
    assert_eq!(pairs(&difference.moved), [(1, 3)]);
    assert_eq!(pairs(&difference.changed), [(2, 2), (3, 1)]);
    assert_eq!((difference.gone, difference.added), (vec![4], vec![0]));
    // The other way round it is the same difference.
    let back = compare(&after, &before);
    assert_eq!((pairs(&back.moved), back.gone, back.added), (vec![(3, 1)], vec![0], vec![4]));
}

#[test]
fn comparing_tells_what_is_glued_otherwise_and_other_units() {
    let octant = |x: f64, object: usize| json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "shift": [x, 0, 0] }, "object": object });
    let of = |objects: [usize; 3]| scene(&[octant(0.0, objects[0]), octant(1.0, objects[1]), octant(2.0, objects[2])]);
    assert!(compare(&of([0, 0, 1]), &of([4, 4, 0])).is_same);
    let difference = compare(&of([0, 0, 0]), &of([0, 1, 1]));
    assert!(!difference.is_same && difference.kept.len() == 3);
    assert_eq!(pairs(&difference.reglued), [(0, 0), (1, 1), (2, 2)]);
    assert_eq!(pairs(&compare(&of([0, 1, 2]), &of([0, 1, 1])).reglued), [(1, 1), (2, 2)]);
    let parts = [octant(0.0, 0)];
    let inches = design(&json!({ "pasu": 1, "unit": "in", "parts": parts }).to_string());
    let difference = compare(&scene(&parts), &inches);
    assert!(!difference.is_same && difference.kept.len() == 1);
}
