//! Random design documents of every kind, with numbers chosen for their awkwardness.

use std::f64::consts::TAU;

use proptest::prelude::*;

use super::value::Value;

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
        kind("rings", rings()),
    ]
}

/// So many places inside (0, 1), in ascending order.
fn places(n: usize) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.01..1.0f64, n + 1).prop_map(|gaps| {
        let total: f64 = gaps.iter().sum();
        let ends = gaps.iter().scan(0.0, |u, gap| {
            *u += gap / total;
            Some(*u)
        });
        ends.take(gaps.len() - 1).collect()
    })
}

fn sharp() -> impl Strategy<Value = Vec<Entry>> {
    some_of(vec![("sharp", any::<bool>().prop_map(Value::Bool).boxed())])
}

fn series() -> impl Strategy<Value = Value> {
    let wave = (1u32..40, some_of(vec![("cos", number(60).boxed()), ("sin", number(60).boxed())]));
    let wave = wave.prop_map(|(n, mut fields)| {
        fields.push(entry("n", Value::Number(n.into())));
        Value::Record(fields)
    });
    let waves = prop::collection::vec(wave, 0..4).prop_map(Value::List).boxed();
    (number(60), some_of(vec![("waves", waves)])).prop_map(|(mean, mut fields)| {
        fields.push(entry("mean", mean));
        Value::Record(fields)
    })
}

fn radius_and_height() -> impl Strategy<Value = Vec<Entry>> {
    all_of(vec![("r", series().boxed()), ("z", series().boxed())])
}

fn rings() -> impl Strategy<Value = Vec<Entry>> {
    let list = (0usize..5).prop_flat_map(|n| {
        let curves = prop::collection::vec((radius_and_height(), sharp()), n + 2);
        (places(n), curves).prop_map(|(places, curves)| {
            let places = [0.0].into_iter().chain(places).chain([1.0]);
            let rings = places.zip(curves).map(|(u, (mut fields, sharp))| {
                fields.extend(sharp);
                fields.push(entry("u", Value::Number(u)));
                Value::Record(fields)
            });
            Value::List(rings.collect())
        })
    });
    let slopes = || radius_and_height().prop_map(Value::Record).boxed();
    let more = some_of(vec![("a", number(60).boxed()), ("foot", slopes()), ("rim", slopes())]);
    (list, more).prop_map(|(rings, mut fields)| {
        fields.push(entry("rings", rings));
        fields
    })
}

/// Of so many rings; slopes are not given at free ends.
fn datum(order: u8, n_rings: usize, free: &str) -> impl Strategy<Value = Value> {
    let force = prop::collection::vec(awkward(200), 0..6).prop_map(numbers).boxed();
    let mut fields = vec![("force", force), ("start", number(200).boxed()), ("end", number(200).boxed())];
    if n_rings > 0 {
        fields.push(("rings", list(n_rings, 200).boxed()));
    }
    for (name, end) in [("start_u", "start"), ("end_u", "end")] {
        if order == 4 && free != end && free != "both" {
            fields.push((name, number(200).boxed()));
        }
    }
    some_of(fields).prop_map(Value::Record)
}

fn component(n_rings: usize) -> impl Strategy<Value = Value> {
    let free = prop::sample::select(vec!["", "", "start", "end", "both"]);
    (prop::sample::select(vec![2u8, 4]), free).prop_flat_map(move |(order, free)| {
        let datum = || datum(order, n_rings, free).boxed();
        let mode = (frequency(), some_of(vec![("cos", datum()), ("sin", datum())])).prop_map(|(n, mut fields)| {
            fields.push(entry("n", Value::Number(n)));
            Value::Record(fields)
        });
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
                fields.extend((!free.is_empty()).then(|| entry("free", Value::Text(free.into()))));
            }
            Value::Record(fields)
        })
    })
}

fn general() -> impl Strategy<Value = Value> {
    let span =
        prop_oneof![Just(Value::Text("2pi".into())), Just(Value::Number(TAU)), (0.1..9.0).prop_map(Value::Number)];
    let fields = (prop::sample::select(vec![0usize, 0, 1, 3]), span.boxed()).prop_flat_map(|(n, span)| {
        let rings = (places(n), prop::collection::vec(sharp(), n)).prop_map(|(places, sharp)| {
            let rings = places.into_iter().zip(sharp).map(|(u, mut fields)| {
                fields.push(entry("u", Value::Number(u)));
                Value::Record(fields)
            });
            Value::List(rings.collect())
        });
        all_of(vec![
            ("span", Just(span).boxed()),
            ("rings", rings.boxed()),
            ("x", component(n).boxed()),
            ("y", component(n).boxed()),
            ("z", component(n).boxed()),
        ])
    });
    kind("boundary-value", fields)
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

fn lining() -> impl Strategy<Value = Value> {
    some_of(vec![("waves", (0u32..=128).prop_map(|waves| Value::Number(waves.into())).boxed())]).prop_map(Value::Record)
}

fn part() -> impl Strategy<Value = Vec<Entry>> {
    let place = some_of(vec![
        ("scale", not_zero(3, 200).boxed()),
        ("axis", list(3, 200).prop_filter("an axis", |axis| *axis != numbers([0.0; 3])).boxed()),
        ("angle", number(200).boxed()),
        ("shift", list(3, 200).boxed()),
    ]);
    let forms = some_of(vec![
        ("side", name(&["inside", "outside"]).boxed()),
        ("rim", name(&["flat", "rounded"]).boxed()),
        ("foot", [0.001..9.0f64, 0.001..9.0f64].prop_map(numbers).boxed()),
        ("drain", prop_oneof![Just(0.0), 0.0..9.0f64].prop_map(Value::Number).boxed()),
        ("lining", lining().boxed()),
    ]);
    let wall = ((0.001..9.0f64), (0.0..9.0f64), forms).prop_map(|(thickness, base, mut fields)| {
        // Outwards there is no other inside.
        if fields.contains(&entry("side", Value::Text("outside".into()))) {
            fields.retain(|(name, _)| name != "lining");
        }
        fields.push(entry("base", Value::Number(base)));
        fields.push(entry("thickness", Value::Number(thickness)));
        Value::Record(fields)
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
        ("joints", joints().boxed()),
    ]);
    // Often nothing but the shape, which is what readable links are for.
    let optional = prop_oneof![Just(Vec::new()), optional];
    (prop_oneof![2 => family(), 1 => general()], optional).prop_map(|(shape, mut fields)| {
        fields.push(entry("shape", shape));
        fields
    })
}

/// Joints within the limits of the format, often none.
fn joints() -> impl Strategy<Value = Value> {
    let joint = |limits: BoxedStrategy<[f64; 2]>, axis: BoxedStrategy<Vec<(String, Value)>>| {
        let beside = some_of(vec![("label", label().boxed()), ("glued", any::<bool>().prop_map(Value::Bool).boxed())]);
        (limits, axis, beside).prop_map(|(limits, axis, mut fields)| {
            fields.push(entry("limits", numbers(limits)));
            fields.extend(axis);
            Value::Record(fields)
        })
    };
    let shift = || {
        joint(
            (-9.0..9.0f64, 0.001..9.0f64).prop_map(|(least, far)| [least, least + far]).boxed(),
            Just(Vec::new()).boxed(),
        )
    };
    let axis = [-2.0..2.0f64, -2.0..2.0f64, 0.1..2.0f64].prop_map(numbers);
    let turn = joint(
        (-6.2..0.0f64, 0.001..6.2f64).prop_map(|(least, most)| [least, most]).boxed(),
        some_of(vec![("axis", axis.boxed())]).boxed(),
    );
    some_of(vec![("x", shift().boxed()), ("y", shift().boxed()), ("z", shift().boxed()), ("turn", turn.boxed())])
        .prop_map(Value::Record)
}

/// A whole document that the format allows.
pub(crate) fn document() -> impl Strategy<Value = Value> {
    let parts = prop_oneof![prop::collection::vec(part(), 1), prop::collection::vec(part(), 1..4)];
    let beside = some_of(vec![("title", label().boxed()), ("unit", name(&["mm", "cm", "in"]).boxed())]);
    (beside, parts).prop_map(|(mut fields, parts)| {
        fields.push(entry("parts", Value::List(parts.into_iter().map(Value::Record).collect())));
        fields.push(entry("pasu", Value::Number(1.0)));
        Value::Record(fields)
    })
}
