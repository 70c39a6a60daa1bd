//! Every refusal of a document: its code, its path, and a message that says what was found and what was expected.

use crate::support::value::Value;
use pasu::{Arg, Code, Design, Format, Making, MeshOptions, VERTEX_LIMIT, evaluate, mesh, write};

const SHAPE: &str = r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] }"#;
const GENERAL: &str = r#"{ "kind": "boundary-value", "span": 1, "x": X,
    "y": { "order": 2, "s": 1, "t": 1, "modes": [] },
    "z": { "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{ "n": 0, "cos": { "start": 3, "end_u": 1 } }] } }"#;

const EMPTY: &str = r#"{ "order": 2, "s": 1, "t": 1, "modes": [] }"#;

fn with_shape(shape: &str) -> String {
    format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#)
}

fn with_part(fields: &str) -> String {
    format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {SHAPE}, {fields} }}] }}"#)
}

fn with_x(component: &str) -> String {
    with_shape(&GENERAL.replace('X', component))
}

fn with_mode(mode: &str) -> String {
    with_x(&format!(r#"{{ "order": 2, "s": 1, "t": 1, "modes": [{mode}] }}"#))
}

fn check(result: pasu::Result<Design>, given: &str, (code, path, message): (&str, &str, &str)) {
    match result {
        Ok(design) => panic!("{given} was read as {}", design.to_json()),
        Err(error) => {
            assert_eq!((error.code().as_str(), error.path(), error.message()), (code, path, message), "{given}")
        }
    }
}

#[test]
fn documents() {
    let kinds = r#""second-order", "mixed-order", "fourth-order", "bloor-wilson", "boundary-value", "rings", "vertex-frame", "blend" or "octant""#;
    let part = format!(r#"{{ "shape": {SHAPE} }}"#);
    let newer = "This design was made by a newer version of Pasu (format 2); this page reads format 1.";
    let cases: Vec<(String, &str, &str, String)> = vec![
        // Not JSON.
        ("{".into(), "not-json", "", "This JSON text ends in the middle, at line 1, column 1; is it cut short?".into()),
        ("{\n  pasu: 1 }".into(), "not-json", "", "This is not JSON: key must be a string at line 2, column 3.".into()),
        (
            r#"{ "pasu": 1, "parts": [ } "#.into(),
            "not-json",
            "parts[0]",
            "This is not JSON: expected value at line 1, column 25.".into(),
        ),
        (
            format!("{} x", with_shape(SHAPE)),
            "not-json",
            "",
            "This is not JSON: trailing characters at line 1, column 93.".into(),
        ),
        (
            with_shape(r#"{ "kind": "bloor-wilson", "a": NaN }"#),
            "not-json",
            "parts[0].shape.a",
            "This is not JSON: expected value at line 1, column 66.".into(),
        ),
        (
            with_shape(r#"{ "kind": "bloor-wilson", "a": 1e999 }"#),
            "not-finite",
            "parts[0].shape.a",
            "expected a number, found one too large to be computed with".into(),
        ),
        // The version comes first.
        (r#"{ "pasu": 2, "pots": [] }"#.into(), "unknown-version", "pasu", newer.into()),
        (
            r#"{ "pasu": 0, "parts": [] }"#.into(),
            "unknown-version",
            "pasu",
            "expected 1, the version of the format, found 0".into(),
        ),
        (
            r#"{ "pasu": "1", "parts": [] }"#.into(),
            "unknown-version",
            "pasu",
            "expected 1, the version of the format, found \"1\"".into(),
        ),
        (
            r#"{ "parts": [] }"#.into(),
            "missing-field",
            "pasu",
            "expected 1, the version of the format, found nothing".into(),
        ),
        // The design.
        (
            r#"{ "pasu": 1, "parts": [] }"#.into(),
            "out-of-range",
            "parts",
            "expected a list of 1 to 500 parts, found an empty list".into(),
        ),
        (
            r#"{ "pasu": 1 }"#.into(),
            "missing-field",
            "parts",
            "expected a list of 1 to 500 parts, found nothing".into(),
        ),
        (
            r#"{ "pasu": 1, "parts": { } }"#.into(),
            "wrong-type",
            "parts",
            "expected a list of 1 to 500 parts, found a group of fields".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "parts": [{}] }}"#, vec![part.as_str(); 501].join(", ")),
            "too-large",
            "parts",
            "expected at most 500 parts, found 501".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "colour": "red", "parts": [{part}] }}"#),
            "unknown-field",
            "colour",
            "unknown field \"colour\"; expected one of pasu, title, unit, parts".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "title": "a", "title": "b", "parts": [{part}] }}"#),
            "duplicate",
            "title",
            "this field is given twice; expected it once".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "title": 7, "parts": [{part}] }}"#),
            "wrong-type",
            "title",
            "expected a text, found 7".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "title": "{}", "parts": [{part}] }}"#, "é".repeat(201)),
            "too-large",
            "title",
            "expected at most 200 characters, found 201".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "title": "a\nb", "parts": [{part}] }}"#),
            "out-of-range",
            "title",
            "expected plain text on one line, found the control character U+000A".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "unit": "m", "parts": [{part}] }}"#),
            "unknown-name",
            "unit",
            "expected \"cm\", \"mm\" or \"in\", found \"m\"".into(),
        ),
        (
            format!(r#"{{ "pasu": 1, "title": null, "parts": [{part}] }}"#),
            "wrong-type",
            "title",
            "expected a value, found null".into(),
        ),
        // Parts.
        (
            format!(r#"{{ "pasu": 1, "parts": [{part}, 3] }}"#),
            "wrong-type",
            "parts[1]",
            "expected a part, found 3".into(),
        ),
        (
            format!(
                r#"{{ "pasu": 1, "parts": [{{ "name": "a", "shape": {SHAPE} }}, {part}, {{ "name": "a", "shape": {SHAPE} }}] }}"#
            ),
            "duplicate",
            "parts[2].name",
            "expected a name that no other part has, found \"a\", which is that of parts[0]".into(),
        ),
        (
            with_part(r#""object": 0.5"#),
            "out-of-range",
            "parts[0].object",
            "expected a whole number, 0 or greater, found 0.5".into(),
        ),
        (
            with_part(r#""object": -1"#),
            "out-of-range",
            "parts[0].object",
            "expected a whole number, 0 or greater, found -1".into(),
        ),
        (
            with_part(r#""object": 4294967296"#),
            "out-of-range",
            "parts[0].object",
            "expected a whole number, 4294967295 or less, found 4294967296".into(),
        ),
        (
            with_part(r#""place": { "scale": [1, 0, 1] }"#),
            "out-of-range",
            "parts[0].place.scale[1]",
            "expected a number other than 0, found 0".into(),
        ),
        (
            with_part(r#""place": { "axis": [0, 0, 0] }"#),
            "out-of-range",
            "parts[0].place.axis",
            "expected the direction of an axis, found [0, 0, 0]".into(),
        ),
        (
            with_part(r#""wall": { "thickness": -3, "base": 0 }"#),
            "out-of-range",
            "parts[0].wall.thickness",
            "expected a number greater than 0, found -3".into(),
        ),
        (
            with_part(r#""wall": { "thickness": 1, "base": -0.5 }"#),
            "out-of-range",
            "parts[0].wall.base",
            "expected 0 or a number greater than 0, found -0.5".into(),
        ),
        (
            with_part(r#""wall": { "thickness": 1 }"#),
            "missing-field",
            "parts[0].wall.base",
            "expected 0 or a number greater than 0, found nothing".into(),
        ),
        (
            with_part(r#""wall": { "thickness": 1, "base": 1, "side": "left" }"#),
            "unknown-name",
            "parts[0].wall.side",
            "expected \"inside\" or \"outside\", found \"left\"".into(),
        ),
        (
            with_part(r#""wall": { "thickness": 1, "base": 1, "rim": "sharp" }"#),
            "unknown-name",
            "parts[0].wall.rim",
            "expected \"flat\" or \"rounded\", found \"sharp\"".into(),
        ),
        (
            with_part(r#""wall": { "thickness": 1, "base": 1, "foot": [1, 0] }"#),
            "out-of-range",
            "parts[0].wall.foot[1]",
            "expected a number greater than 0, found 0".into(),
        ),
        (
            with_part(r#""wall": { "thickness": 1, "base": 1, "drain": -2 }"#),
            "out-of-range",
            "parts[0].wall.drain",
            "expected 0 or a number greater than 0, found -2".into(),
        ),
        (
            with_part(r#""look": { "clay": "mud" }"#),
            "unknown-name",
            "parts[0].look.clay",
            "expected \"stoneware\", \"porcelain\", \"terracotta\", \"black\" or \"#rrggbb\", found \"mud\"".into(),
        ),
        // Shapes.
        (
            r#"{ "pasu": 1, "parts": [{}] }"#.into(),
            "missing-field",
            "parts[0].shape",
            "expected a shape, found nothing".into(),
        ),
        (
            with_shape(r#"{ "kind": "teapot" }"#),
            "unknown-name",
            "parts[0].shape.kind",
            format!("expected {kinds}, found \"teapot\""),
        ),
        (
            with_shape(r#"{ "kind": "octant", "exponents": [2, 60, 2] }"#),
            "out-of-range",
            "parts[0].shape.exponents[1]",
            "expected a number from 0.05 to 50, found 60".into(),
        ),
        (
            with_shape(r#"{ "kind": "second-order" }"#),
            "missing-field",
            "parts[0].shape.r",
            "expected a list of 4 numbers, found nothing".into(),
        ),
        (
            with_shape(r#"{ "kind": "second-order", "r": [1, "2", 3, 4] }"#),
            "wrong-type",
            "parts[0].shape.r[1]",
            "expected a number, found \"2\"".into(),
        ),
        (
            with_shape(r#"{ "kind": "second-order", "r": 1 }"#),
            "wrong-type",
            "parts[0].shape.r",
            "expected a list of 4 numbers, found 1".into(),
        ),
        (
            with_shape(r#"{ "kind": "second-order", "r": [1, 2, 3, 4], "s": [0, 1] }"#),
            "out-of-range",
            "parts[0].shape.s[0]",
            "expected a number other than 0, found 0".into(),
        ),
        (
            with_shape(r#"{ "kind": "second-order", "r": [1, 2, 3, 4], "n": [1e200, 1], "force": [1, 1] }"#),
            "overflow",
            "parts[0].shape",
            "these numbers are so large that their products cannot be computed".into(),
        ),
        // Boundary-value shapes.
        (
            with_x(r#"{ "order": 3, "s": 1, "t": 1, "modes": [] }"#),
            "out-of-range",
            "parts[0].shape.x.order",
            "expected 2 or 4, found 3".into(),
        ),
        (
            with_x(r#"{ "order": 2, "s": 1, "t": 1, "w": 0, "modes": [] }"#),
            "unknown-field",
            "parts[0].shape.x.w",
            "unknown field \"w\"; expected one of order, s, t, modes".into(),
        ),
        (
            with_x(r#"{ "order": 4, "s": 1, "t": 1, "modes": [] }"#),
            "missing-field",
            "parts[0].shape.x.w",
            "expected a number, found nothing".into(),
        ),
        (
            with_x(r#"{ "order": 2, "s": 0, "t": 1, "modes": [] }"#),
            "out-of-range",
            "parts[0].shape.x.s",
            "expected a number other than 0, found 0".into(),
        ),
        (
            with_x(EMPTY).replace("\"span\": 1", "\"span\": -1"),
            "out-of-range",
            "parts[0].shape.span",
            "expected a number greater than 0, found -1".into(),
        ),
        (
            with_x(EMPTY).replace("\"span\": 1", "\"span\": \"pi\""),
            "wrong-type",
            "parts[0].shape.span",
            "expected a number greater than 0 or \"2pi\", found \"pi\"".into(),
        ),
        (
            with_mode(r#"{ "cos": {} }"#),
            "missing-field",
            "parts[0].shape.x.modes[0].n",
            "expected a number, found nothing".into(),
        ),
        (
            with_mode(r#"{ "n": 1, "cos": { "start_u": 1 } }"#),
            "unknown-field",
            "parts[0].shape.x.modes[0].cos.start_u",
            "unknown field \"start_u\"; expected one of start, end, rings, force".into(),
        ),
        (
            with_mode(&format!(r#"{{ "n": 1, "sin": {{ "force": [{}] }} }}"#, vec!["1"; 513].join(", "))),
            "too-large",
            "parts[0].shape.x.modes[0].sin.force",
            "expected at most 512 coefficients, found 513".into(),
        ),
        (
            with_mode(r#"{ "n": 1, "cos": { "end": 1e308 } }, { "n": 1, "cos": { "end": 1e308 } }"#),
            "overflow",
            "parts[0].shape.x.modes",
            "the data given for n = 1 add up to more than a number can hold".into(),
        ),
        (
            with_mode(&vec![r#"{ "n": 1 }"#; 4096].join(", ")),
            "too-large",
            "parts[0].shape",
            "expected at most 4096 modes in the whole design; this part exceeds them".into(),
        ),
    ];
    for (given, code, path, message) in &cases {
        check(Design::parse(given), given, (code, path, message));
    }

    // Foreign names in paths and messages stay short.
    let (given, short) = (with_part(&format!("\"a {}\": 1", "b".repeat(60))), format!("\"a {}…\"", "b".repeat(38)));
    let message = format!("unknown field {short}; expected one of name, object, shape, place, wall, look, joints");
    check(Design::parse(&given), &given, ("unknown-field", &format!("parts[0][{short}]"), &message));
}

#[test]
fn limits_of_size() {
    let given = format!("{}{}", with_shape(SHAPE), " ".repeat(1 << 25));
    let message = format!("expected a design of at most 33554432 bytes of JSON, found {}", given.len());
    check(Design::parse(&given), "megabytes of white space", ("too-large", "", &message));

    // Neither is a tree of more values than anybody has memory for.
    let given = format!("{{ \"pasu\": 1, \"parts\": [{}1] }}", "1,".repeat(1 << 22));
    check(
        Design::parse(&given),
        "four million values",
        ("too-large", "", "expected a design of at most 4194304 values, found more"),
    );

    // A short document may have a long canonical form; what could not be opened again is not opened.
    let mode = |n: usize| format!(r#"{{"n":{n},"cos":{{"force":[{}]}}}}"#, vec!["1e20"; 64].join(","));
    let modes: Vec<String> = (0..2500).map(mode).collect();
    let given = with_mode(&modes.join(","));
    assert!(given.len() < 1 << 20);
    let error = Design::parse(&given).unwrap_err();
    assert_eq!((error.code().as_str(), error.path()), ("too-large", ""));
    assert!(error.message().starts_with("expected a design of at most 1048576 bytes of JSON, found 3"));
}

#[test]
fn values_from_javascript() {
    let read = Value::of_json;
    // Undefined fields arrive as null and are not there.
    let value = read(&with_part(r#""name": null, "wall": null, "look": { "clay": null }, "colour": null"#));
    assert_eq!(value.design(), Design::parse(&with_shape(SHAPE)));
    // What is required must be there all the same.
    let value = read(&with_shape(r#"{ "kind": "second-order", "r": null }"#));
    let expected = ("missing-field", "parts[0].shape.r", "expected a list of 4 numbers, found nothing");
    check(value.design(), "r: undefined", expected);

    fn put(value: &mut Value, number: f64) {
        match value {
            Value::Record(fields) => fields.iter_mut().for_each(|(_, value)| put(value, number)),
            Value::List(items) => items.iter_mut().for_each(|item| put(item, number)),
            Value::Number(x) if *x == 7.0 => *x = number,
            _ => {}
        }
    }
    for (number, name) in [(f64::NAN, "NaN"), (f64::INFINITY, "Infinity"), (f64::NEG_INFINITY, "-Infinity")] {
        for (text, path, expected) in [
            (with_shape(r#"{ "kind": "second-order", "r": [1, 7, 3, 4] }"#), "parts[0].shape.r[1]", "a number"),
            (with_part(r#""object": 7"#), "parts[0].object", "a whole number, 0 or greater"),
            (
                with_part(r#""wall": { "thickness": 7, "base": 1 }"#),
                "parts[0].wall.thickness",
                "a number greater than 0",
            ),
            (with_mode(r#"{ "n": 7 }"#), "parts[0].shape.x.modes[0].n", "a number"),
            (with_x(r#"{ "order": 7, "s": 1, "t": 1, "modes": [] }"#), "parts[0].shape.x.order", "a number"),
        ] {
            let mut value = read(&text);
            put(&mut value, number);
            let message = format!("expected {expected}, found {name}");
            check(value.design(), &text, ("not-finite", path, &message));
        }
    }
    check(Value::Number(3.0).design(), "3", ("wrong-type", "", "expected a design, found 3"));
}

/// What a message names is also there as data, in the order of [`pasu::Error::args`], so that it can be said in another language.
#[test]
fn arguments() {
    let number = Arg::Number;
    let vase = Design::parse(&with_shape(SHAPE)).unwrap();
    let cases = [
        (
            mesh(&vase, &MeshOptions { rows: Some(1), ..MeshOptions::default() }).unwrap_err(),
            vec![("least", number(2.0)), ("greatest", number(VERTEX_LIMIT as f64)), ("found", number(1.0))],
        ),
        (
            evaluate(&vase, 3, &[]).unwrap_err(),
            vec![("least", number(0.0)), ("greatest", number(0.0)), ("found", number(3.0))],
        ),
        (
            write(&vase, Format::Stl, &Making { shrinkage: 50.0, ..Making::default() }).unwrap_err(),
            vec![("least", number(0.0)), ("below", number(50.0)), ("found", number(50.0))],
        ),
        (Design::parse("{").unwrap_err(), vec![]),
        (
            Design::parse(&with_part(r#""wall": { "thickness": -3, "base": 0 }"#)).unwrap_err(),
            vec![("found", number(-3.0)), ("above", number(0.0))],
        ),
        (
            Design::parse(&with_shape(r#"{ "kind": "second-order", "r": [1, "2", 3, 4] }"#)).unwrap_err(),
            vec![("found", Arg::Text("2".into()))],
        ),
        (
            Design::parse("1/second-order?unit=m").unwrap_err(),
            vec![("words", Arg::from(["cm", "mm", "in"].as_slice())), ("found", Arg::Text("m".into()))],
        ),
    ];
    for (error, args) in cases {
        assert_eq!(error.args(), args, "{error}");
        for (name, arg) in &args {
            assert_eq!(error.arg(name), Some(arg));
            // The sentence says the same number.
            if let (&"found", Arg::Number(found)) = (name, arg) {
                assert!(error.message().contains(&format!("found {found}")), "{error}");
            }
        }
    }
}

#[test]
fn resonance_names_its_equation() {
    let design = with_shape(
        r#"{ "kind": "boundary-value", "span": 1, "x": { "order": 2, "s": 4, "t": -1, "modes": [{ "n": 1, "cos": { "start": 1 } }] },
             "y": { "order": 2, "s": 1, "t": 1, "modes": [] }, "z": { "order": 2, "s": 1, "t": 1, "modes": [] } }"#,
    );
    let error = evaluate(&Design::parse(&design).unwrap(), 0, &[0.0, 0.0]).unwrap_err();
    assert_eq!(error.code(), Code::ResonantProblem);
    let named = [("n", 1.0), ("s", 4.0), ("t", -1.0), ("w", 0.0)].map(|(name, number)| (name, Arg::Number(number)));
    assert_eq!(error.args()[0], ("component", Arg::Text("x".into())));
    assert_eq!(error.args()[1..], named);
}
