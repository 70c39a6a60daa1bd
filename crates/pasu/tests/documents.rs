//! Canonical form and links over random designs of every kind, with numbers chosen for their awkwardness.

use pasu::{BoundaryValue, Component, Datum, Design, Part, Shape, Span, Value};
use proptest::prelude::*;
use std::f64::consts::TAU;

type Entry = (String, Value);

fn entry(name: &str, value: Value) -> Entry {
    (name.to_owned(), value)
}

fn numbers(list: impl IntoIterator<Item = f64>) -> Value {
    Value::List(list.into_iter().map(Value::Number).collect())
}

/// Zeros of both signs, defaults, numbers with too many digits, tiny and huge ones. `largest` keeps the products of a
/// family within the range of numbers.
fn awkward(largest: i32) -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -20.0..20.0f64,
        2 => (-50i32..50).prop_map(f64::from),
        2 => prop::sample::select(vec![0.0, -0.0, 0.5, 1.0, 8.0, 3.6, 0.1 + 0.2, 1.0 / 3.0, -0.5, 0.3, TAU]),
        1 => (-9.9..9.9f64, -largest..largest).prop_map(|(x, power)| x * 10f64.powi(power)),
        1 => prop::sample::select(vec![5e-324, -1e-310, 1e-300, 123456789012345680.0]),
    ]
}

/// Within which twelve digits still fix the phase.
fn frequency() -> impl Strategy<Value = f64> {
    awkward(2).prop_map(|n| n % 100.0)
}

fn number(largest: i32) -> impl Strategy<Value = Value> {
    awkward(largest).prop_map(Value::Number)
}

fn list(length: usize, largest: i32) -> impl Strategy<Value = Value> {
    prop::collection::vec(awkward(largest), length).prop_map(numbers)
}

fn not_zero(length: usize, largest: i32) -> impl Strategy<Value = Value> {
    prop::collection::vec(awkward(largest).prop_map(|x| if x == 0.0 { 1.0 } else { x }), length).prop_map(numbers)
}

/// Fields that may be left out.
fn some_of(entries: Vec<(&'static str, BoxedStrategy<Value>)>) -> impl Strategy<Value = Vec<Entry>> {
    let optional: Vec<_> = entries
        .into_iter()
        .map(|(name, value)| prop::option::of(value).prop_map(move |value| value.map(|value| entry(name, value))))
        .collect();
    optional.prop_map(|entries| entries.into_iter().flatten().collect())
}

fn all_of(entries: Vec<(&'static str, BoxedStrategy<Value>)>) -> impl Strategy<Value = Vec<Entry>> {
    let entries: Vec<_> =
        entries.into_iter().map(|(name, value)| value.prop_map(move |value| entry(name, value))).collect();
    entries.prop_shuffle()
}

fn kind(name: &'static str, fields: impl Strategy<Value = Vec<Entry>>) -> impl Strategy<Value = Value> {
    fields.prop_map(move |mut fields| {
        fields.push(entry("kind", Value::Text(name.into())));
        Value::Record(fields)
    })
}

fn family() -> impl Strategy<Value = Value> {
    let walls = || {
        some_of(vec![
            ("n", prop::collection::vec(frequency(), 2).prop_map(numbers).boxed()),
            ("height", number(60).boxed()),
            ("s", not_zero(2, 60).boxed()),
            ("t", list(2, 60).boxed()),
            ("force", list(2, 60).boxed()),
        ])
    };
    let second = (walls(), list(4, 60)).prop_map(|(mut fields, r)| {
        fields.push(entry("r", r));
        fields
    });
    let mixed = (walls(), list(4, 60), number(60)).prop_map(|(mut fields, r, rise)| {
        fields.extend([entry("r", r), entry("rise", rise)]);
        fields
    });
    let fourth = all_of(vec![
        ("r0", number(60).boxed()),
        ("r1", number(60).boxed()),
        ("rm", number(60).boxed()),
        ("h1", number(60).boxed()),
        ("eta", prop::collection::vec(-20.0..20.0f64, 2).prop_map(numbers).boxed()),
        ("dz", list(2, 60).boxed()),
        ("s", not_zero(2, 60).boxed()),
        ("t", list(2, 60).boxed()),
        ("w", list(2, 60).boxed()),
    ]);
    let bloor_wilson = all_of(vec![
        ("a", number(60).boxed()),
        ("r", list(4, 60).boxed()),
        ("R", list(4, 60).boxed()),
        ("h", list(2, 60).boxed()),
        ("H", list(2, 60).boxed()),
        ("n1", frequency().prop_map(Value::Number).boxed()),
    ]);
    prop_oneof![
        kind("second-order", second),
        kind("mixed-order", mixed),
        kind("fourth-order", fourth),
        kind("bloor-wilson", bloor_wilson),
    ]
}

fn datum(order: u8) -> impl Strategy<Value = Value> {
    let force = prop::collection::vec(awkward(200), 0..6).prop_map(numbers).boxed();
    let mut fields = vec![("force", force), ("start", number(200).boxed()), ("end", number(200).boxed())];
    if order == 4 {
        fields.extend([("start_u", number(200).boxed()), ("end_u", number(200).boxed())]);
    }
    some_of(fields).prop_map(Value::Record)
}

fn component() -> impl Strategy<Value = Value> {
    prop::sample::select(vec![2u8, 4]).prop_flat_map(|order| {
        let mode = (frequency(), some_of(vec![("cos", datum(order).boxed()), ("sin", datum(order).boxed())])).prop_map(
            |(n, mut fields)| {
                fields.push(entry("n", Value::Number(n)));
                Value::Record(fields)
            },
        );
        let modes = prop::collection::vec(mode, 0..6).prop_map(Value::List);
        (not_zero(1, 200), awkward(200), awkward(200), modes).prop_map(move |(s, t, w, modes)| {
            let Value::List(s) = s else { unreachable!("a list") };
            let mut fields = vec![
                entry("modes", modes),
                entry("order", Value::Number(order.into())),
                entry("s", s[0].clone()),
                entry("t", Value::Number(t)),
            ];
            if order == 4 {
                fields.push(entry("w", Value::Number(w)));
            }
            Value::Record(fields)
        })
    })
}

fn general() -> impl Strategy<Value = Value> {
    let span =
        prop_oneof![Just(Value::Text("2pi".into())), Just(Value::Number(TAU)), (0.1..9.0).prop_map(Value::Number)];
    kind(
        "boundary-value",
        all_of(vec![
            ("span", span.boxed()),
            ("x", component().boxed()),
            ("y", component().boxed()),
            ("z", component().boxed()),
        ]),
    )
}

fn label() -> impl Strategy<Value = Value> {
    prop_oneof![
        "\\PC{0,30}",
        "[ -~]{0,30}",
        prop::sample::select(vec![
            "",
            " ",
            "100 %",
            "a&b",
            "#1/second-order?",
            "vase.",
            "\u{ad}é\u{200b} ",
            "\"\\\"",
            "+",
            "a=b?c"
        ])
        .prop_map(String::from),
    ]
    .prop_map(Value::Text)
}

fn name(names: &[&'static str]) -> impl Strategy<Value = Value> {
    prop::sample::select(names.to_vec()).prop_map(|name| Value::Text(name.into()))
}

fn part() -> impl Strategy<Value = Vec<Entry>> {
    let place = some_of(vec![
        ("scale", not_zero(3, 200).boxed()),
        ("axis", list(3, 200).prop_filter("an axis", |axis| *axis != numbers([0.0; 3])).boxed()),
        ("angle", number(200).boxed()),
        ("shift", list(3, 200).boxed()),
    ]);
    let wall = ((0.001..9.0f64), (0.0..9.0f64)).prop_map(|(thickness, base)| {
        Value::Record(vec![entry("base", Value::Number(base)), entry("thickness", Value::Number(thickness))])
    });
    let look = some_of(vec![
        ("glaze", name(&["celadon", "tin-white", "bare"]).boxed()),
        ("clay", name(&["stoneware", "black"]).boxed()),
    ]);
    let optional = some_of(vec![
        ("object", (0u32..4).prop_map(|object| Value::Number(object.into())).boxed()),
        ("place", place.prop_map(Value::Record).boxed()),
        ("wall", wall.boxed()),
        ("look", look.prop_map(Value::Record).boxed()),
    ]);
    // Often nothing but the shape, which is what readable links are for.
    let optional = prop_oneof![Just(Vec::new()), optional];
    (prop_oneof![2 => family(), 1 => general()], optional).prop_map(|(shape, mut fields)| {
        fields.push(entry("shape", shape));
        fields
    })
}

fn document() -> impl Strategy<Value = Value> {
    let parts = prop_oneof![prop::collection::vec(part(), 1), prop::collection::vec(part(), 1..4)];
    let beside = some_of(vec![("title", label().boxed()), ("unit", name(&["mm", "cm", "in"]).boxed())]);
    (beside, parts).prop_map(|(mut fields, parts)| {
        fields.push(entry("parts", Value::List(parts.into_iter().map(Value::Record).collect())));
        fields.push(entry("pasu", Value::Number(1.0)));
        Value::Record(fields)
    })
}

/// Everything that `cos(k v)` and `sin(k v)` are multiplied by: start, end, slopes, force, added up at `v`.
fn data_at(component: &Component, span: Span, v: f64) -> Vec<f64> {
    let length = match span {
        Span::Tau => TAU,
        Span::Length(length) => length,
    };
    let mut sums = vec![0.0; 4 + 64];
    for mode in &component.modes {
        let (sin, cos) = (TAU * mode.n / length * v).sin_cos();
        let mut add = |datum: &Datum, factor: f64| {
            let named = [datum.start, datum.end, datum.start_u, datum.end_u];
            for (sum, x) in sums.iter_mut().zip(named.iter().chain(&datum.force)) {
                *sum += factor * x;
            }
        };
        add(&mode.cos, cos);
        add(&mode.sin, sin);
    }
    sums
}

fn size(component: &Component) -> f64 {
    let data = component.modes.iter().flat_map(|mode| [&mode.cos, &mode.sin]);
    let numbers = data.flat_map(|d| [d.start, d.end, d.start_u, d.end_u].into_iter().chain(d.force.iter().copied()));
    numbers.fold(0.0, |size: f64, x| size.max(x.abs()))
}

fn assert_same_problem(a: &BoundaryValue, b: &BoundaryValue) {
    for (a_component, b_component) in [(&a.x, &b.x), (&a.y, &b.y), (&a.z, &b.z)] {
        // A fourth power has four times the rounding of its base.
        let near = |a: f64, b: f64| (a - b).abs() <= 2.1e-11 * a.abs() + f64::MIN_POSITIVE;
        assert_eq!(a_component.order, b_component.order);
        assert!(near(a_component.s, b_component.s) && near(a_component.t, b_component.t));
        assert!(near(a_component.w, b_component.w));
        for v in [0.0, 0.01, 0.03] {
            let (found, expected) = (data_at(b_component, b.span, v), data_at(a_component, a.span, v));
            for (found, expected) in found.iter().zip(expected) {
                let bound = 1e-9 * size(a_component);
                assert!((found - expected).abs() <= bound, "{found} is not {expected}\n{a:#?}\n{b:#?}");
            }
        }
    }
}

fn given_shapes(document: &Value) -> Vec<Shape> {
    let field = |value: &Value, name: &str| match value {
        Value::Record(fields) => fields.iter().find(|(field, _)| field == name).map(|(_, value)| value.clone()),
        _ => None,
    };
    let Some(Value::List(parts)) = field(document, "parts") else { panic!("no parts") };
    parts.iter().map(|part| Shape::from_value(&field(part, "shape").unwrap(), "shape").unwrap()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn canonical_form_and_links_are_exact(document in document()) {
        let design = Design::from_value(&document).unwrap_or_else(|e| panic!("{e}\n{document:?}"));

        // Canonical form is its own canonical form, as text and as a tree.
        let text = design.to_json();
        let again = Design::parse(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        prop_assert_eq!(&again, &design);
        prop_assert_eq!(again.to_json(), text.clone());
        prop_assert_eq!(&Design::from_value(&design.to_value()), &Ok(design.clone()));
        let serialized = serde_json::to_string(&design).unwrap();
        prop_assert_eq!(&Design::parse(&serialized), &Ok(design.clone()));

        // A link brings back the same design, and the same link.
        let link = design.link();
        prop_assert_eq!(&Design::parse(&link), &Ok(design.clone()), "{}", link);
        prop_assert_eq!(&Design::parse(&format!("https://example.org/#{link}")), &Ok(design.clone()), "{}", link);

        // The problem to be solved is the one that was given.
        for (given, Part { shape, .. }) in given_shapes(&document).iter().zip(design.parts()) {
            assert_same_problem(&given.boundary_value(), &shape.boundary_value());
        }
    }
}

#[test]
fn one_surface_has_one_document() {
    let text = |modes: &str, span: &str| {
        format!(
            r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": {span},
                "x": {{ "order": 2, "s": 1, "t": 0.5, "modes": {modes} }},
                "y": {{ "modes": [], "t": 1, "s": 1, "order": 2 }},
                "z": {{ "order": 4, "s": 1, "t": 1, "w": -0.0, "modes": [] }} }} }}] }}"#
        )
    };
    let canonical = r#"{"pasu":1,"parts":[{"shape":{"kind":"boundary-value","span":"2pi","x":{"order":2,"s":1,"t":0.5,"modes":[{"n":-1,"sin":{"end":2}},{"n":1,"cos":{"start":0.3,"force":[0,1]}}]},"y":{"order":2,"s":1,"t":1,"modes":[]},"z":{"order":4,"s":1,"t":1,"w":0,"modes":[]}}}]}"#;
    for modes in [
        r#"[{ "n": -1, "sin": { "end": 2 } }, { "n": 1, "cos": { "start": 0.3, "force": [0, 1] } }]"#,
        // Modes out of order, one of them in two halves, one without effect, data that are 0.
        r#"[{ "n": 1, "cos": { "start": 0.1, "force": [0, 1, 0, 0] } }, { "n": 0, "sin": { "start": 7 } },
            { "n": 1, "cos": { "start": 0.2, "end": 0 }, "sin": { "force": [] } }, { "n": 5, "cos": {} },
            { "n": -1, "sin": { "end": 2.0000000000001 } }, { "n": 4, "cos": { "end": 1 } },
            { "n": 4, "cos": { "end": -1 } }]"#,
    ] {
        for span in ["\"2pi\"", "6.283185307179586", "6.28318530718"] {
            assert_eq!(Design::parse(&text(modes, span)).unwrap().to_json(), canonical);
        }
    }
}
