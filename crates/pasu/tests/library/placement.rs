//! Placements: the unique form of ASB88 against the reference, and by its properties.

use std::f64::consts::{PI, TAU};

use crate::support::value::Value;
use pasu::{Design, Placement};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

fn record<const N: usize>(fields: [(&str, Value); N]) -> Value {
    Value::Record(fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
}

fn list<const N: usize>(numbers: [f64; N]) -> Value {
    Value::List(numbers.into_iter().map(Value::Number).collect())
}

fn parsed(place: Value) -> pasu::Result<Placement> {
    // Neither a turn nor a mirror makes this vase its own image: its two rings wave differently.
    let wave = |n: f64, cos: f64, sin: f64| {
        record([("n", Value::Number(n)), ("cos", Value::Number(cos)), ("sin", Value::Number(sin))])
    };
    let ring = |u: f64, waves: Vec<Value>| {
        let radius = record([("mean", Value::Number(1.0)), ("waves", Value::List(waves))]);
        record([("u", Value::Number(u)), ("r", radius), ("z", record([("mean", Value::Number(u))]))])
    };
    let rings = vec![ring(0.0, vec![wave(1.0, 0.1, 0.0), wave(2.0, 0.1, 0.05)]), ring(1.0, vec![wave(3.0, 0.0, 0.1)])];
    let shape = record([("kind", Value::Text("rings".into())), ("rings", Value::List(rings))]);
    let part = record([("shape", shape), ("place", place)]);
    let design = record([("pasu", Value::Number(1.0)), ("parts", Value::List(vec![part]))]);
    Ok(design.design()?.parts()[0].place)
}

fn canonical(place: Value) -> Placement {
    parsed(place).unwrap_or_else(|e| panic!("{e}"))
}

fn given(place: &Placement) -> Value {
    record([
        ("scale", list(place.scale)),
        ("axis", list(place.axis)),
        ("angle", Value::Number(place.angle)),
        ("shift", list(place.shift)),
    ])
}

fn field<'a>(value: &'a Value, name: &str) -> Option<&'a Value> {
    let Value::Record(fields) = value else { panic!("{value:?}") };
    fields.iter().find(|(field, _)| field == name).map(|(_, value)| value)
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(x) => vec![*x],
        Value::List(items) => items.iter().flat_map(numbers).collect(),
        other => panic!("{other:?}"),
    }
}

/// An affine map: the columns of its matrix, then its shift.
type Map = [[f64; 3]; 4];

/// The map of a placement as given, by the textbook: scale, turn by Rodrigues' formula, move.
fn given_map(place: &Value) -> Map {
    let get = |name: &str, default: Vec<f64>| field(place, name).map_or(default, numbers);
    let scale = get("scale", vec![1.0; 3]);
    let axis = get("axis", vec![0.0, 0.0, 1.0]);
    let angle = get("angle", vec![0.0])[0];
    let shift = get("shift", vec![0.0; 3]);
    let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    let a: Vec<f64> = axis.iter().map(|x| x / length).collect();
    let (sin, cos) = angle.sin_cos();
    let turned = |p: [f64; 3]| {
        let dot = a[0] * p[0] + a[1] * p[1] + a[2] * p[2];
        let cross = [a[1] * p[2] - a[2] * p[1], a[2] * p[0] - a[0] * p[2], a[0] * p[1] - a[1] * p[0]];
        [0, 1, 2].map(|i| p[i] * cos + cross[i] * sin + a[i] * dot * (1.0 - cos))
    };
    let column = |i: usize| {
        let mut p = [0.0; 3];
        p[i] = scale[i];
        turned(p)
    };
    [column(0), column(1), column(2), [shift[0], shift[1], shift[2]]]
}

fn map(place: &Placement) -> Map {
    let rows = place.matrix();
    let column = |i: usize| [rows[0][i], rows[1][i], rows[2][i]];
    [column(0), column(1), column(2), place.shift]
}

fn distance(a: Map, b: Map) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |largest, (a, b)| largest.max((a - b).abs()))
}

fn bits(place: &Placement) -> Vec<u64> {
    numbers(&Value::List(vec![list(place.scale), list(place.axis), Value::Number(place.angle), list(place.shift)]))
        .into_iter()
        .map(f64::to_bits)
        .collect()
}

#[test]
fn every_reference_placement() {
    let text = include_str!("../reference/placements.json");
    let Value::List(cases) = Value::of_json(text) else { panic!("a list of cases") };
    assert!(cases.len() >= 25);
    for case in &cases {
        let given = field(case, "given").unwrap();
        let expected = field(case, "canonical").unwrap();
        let found = canonical(given.clone());
        let pairs =
            numbers(&list(found.scale)).into_iter().chain(found.axis).chain([found.angle]).chain(found.shift).zip(
                ["scale", "axis", "angle", "shift"].iter().flat_map(|name| numbers(field(expected, name).unwrap())),
            );
        for (found_number, expected_number) in pairs {
            assert!((found_number - expected_number).abs() < 1e-9, "{given:?}\n{found:?}\n{expected:?}");
        }
        assert!(distance(given_map(given), map(&found)) < 1e-9, "{given:?}\n{found:?}");
    }
}

#[test]
fn quarter_and_half_turns_are_clean() {
    let turned = |axis, angle| canonical(record([("axis", list(axis)), ("angle", Value::Number(angle))]));
    let half = turned([0.0, 0.0, -2.0], PI);
    assert_eq!((half.axis, half.angle), ([0.0, 0.0, 1.0], -PI));
    assert_eq!(half.matrix(), [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(turned([1.0, 2.0, 3.0], 0.0), Placement::default());
    assert_eq!(turned([1.0, 2.0, 3.0], 2.0 * PI), Placement::default());
    assert_eq!(Placement::default().matrix(), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let mirrored = canonical(record([("scale", list([-1.0, 1.0, 1.0]))]));
    assert_eq!((mirrored.scale, mirrored.axis, mirrored.angle), ([1.0, -1.0, 1.0], [0.0, 0.0, 1.0], -PI));
}

#[test]
fn the_half_turn_is_written_exactly() {
    let json = r#"{"pasu":1,"parts":[{"shape":{"kind":"second-order","r":[1,0.1,0.6,0.06],"n":[1,2]},"place":{"angle":3.14159265359}}]}"#;
    assert!(Design::parse(json).unwrap().to_json().ends_with(r#""place":{"angle":-3.141592653589793}}]}"#));
}

#[test]
fn placements_that_are_none_are_refused() {
    let refusal = |place| parsed(place).unwrap_err();
    let axis = refusal(record([("axis", list([0.0, -0.0, 0.0]))]));
    assert_eq!((axis.code().as_str(), axis.path()), ("out-of-range", "parts[0].place.axis"));
    let scale = refusal(record([("scale", list([1.0, 1.0, 0.0]))]));
    assert_eq!((scale.code().as_str(), scale.path()), ("out-of-range", "parts[0].place.scale[2]"));
    let scale = refusal(record([("scale", list([1.0, f64::NAN, 1.0]))]));
    assert_eq!((scale.code().as_str(), scale.path()), ("not-finite", "parts[0].place.scale[1]"));
}

/// A placement, in and out of its unique form; the axis may be nearly a unit vector.
fn place() -> impl Strategy<Value = Value> {
    let angle = prop_oneof![
        4 => -4.0..4.0f64,
        2 => select(vec![0.0, -0.0, PI, -PI, TAU, -TAU, PI / 2.0, 1e-13, 1e5, PI - 1e-12]),
    ];
    let direction = vec(prop_oneof![3 => -1.0..1.0f64, 1 => select(vec![0.0, -0.0, 1.0, -1.0, 1e-14])], 3);
    let length = prop_oneof![0.01..100.0f64, (-3e-12..3e-12f64).prop_map(|noise| 1.0 + noise)];
    let axis = (direction, length).prop_map(|(mut axis, length)| {
        if axis.iter().all(|x| *x == 0.0) {
            axis[1] = 1.0;
        }
        let given = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        [0, 1, 2].map(|i| axis[i] * (length / given))
    });
    let factor = || prop_oneof![2 => 0.1..4.0f64, 1 => -4.0..-0.1f64, 1 => select(vec![1.0, -1.0])];
    ([factor(), factor(), factor()], axis, angle, [-4.0..4.0f64, -4.0..4.0f64, -4.0..4.0f64]).prop_map(
        |(scale, axis, angle, shift)| {
            record([
                ("scale", list(scale)),
                ("axis", list(axis)),
                ("angle", Value::Number(angle)),
                ("shift", list(shift)),
            ])
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn canonical_form_moves_nothing_and_is_its_own(given in place()) {
        let once = canonical(given.clone());
        prop_assert_eq!(bits(&canonical(super::placement::given(&once))), bits(&once));
        let [sx, sy, sz] = once.scale;
        prop_assert!(sx > 0.0 && sy != 0.0 && sz > 0.0);
        let [h, k, _] = once.axis;
        prop_assert!(k > 0.0 || (k == 0.0 && h > 0.0) || once.axis == [0.0, 0.0, 1.0]);
        prop_assert!((-PI..PI).contains(&once.angle));
        prop_assert!(once.angle != 0.0 || once.axis == [0.0, 0.0, 1.0]);
        let expected = given_map(&given);
        let size = expected.iter().flatten().fold(1.0_f64, |size, x| size.max(x.abs()));
        prop_assert!(distance(expected, map(&once)) <= 1e-9 * size, "{:?}\n{:?}", given, once);
    }
}
