//! Canonical form: one document and one link for one design, and never another solid.

use std::f64::consts::TAU;

use crate::support::documents::document;
use crate::support::value::Value;
use pasu::{BoundaryValue, Component, Datum, Design, Part, Shape, Span};
use proptest::prelude::*;

#[test]
fn written_in_the_order_of_the_format_without_defaults() {
    let given = r#"{
        "parts": [{
            "look": { "clay": "black", "glaze": "celadon" },
            "wall": { "base": 0, "thickness": 0.30000000000000004 },
            "place": { "shift": [0, 0, 0.1], "angle": 0, "axis": [0, 3, 0], "scale": [1, 1, 1] },
            "shape": {
                "kind": "boundary-value", "span": 6.283185307179586,
                "z": { "order": 2, "s": 1, "t": 1, "modes": [] },
                "y": { "order": 2, "s": 1, "t": 1, "modes": [
                    { "n": 0, "sin": { "start": 3 } }, { "n": 4, "cos": { "start": -0.0, "force": [0, 0] } }
                ] },
                "x": { "order": 4, "w": 1, "t": 2, "s": 1, "modes": [
                    { "n": 2, "sin": { "end_u": 4, "force": [1, 2, 0], "end": 1 }, "cos": {} },
                    { "n": 1, "cos": { "start": 0.1 } },
                    { "n": 1, "cos": { "start": 0.2 } },
                    { "n": -1, "cos": { "start": 1e21 } }
                ] }
            },
            "object": 0, "name": "body"
        }],
        "unit": "cm", "title": "", "pasu": 1
    }"#;
    assert_eq!(
        Design::parse(given).unwrap().to_json(),
        concat!(
            r#"{"pasu":1,"parts":[{"name":"body","shape":{"kind":"boundary-value","span":"2pi","#,
            r#""x":{"order":4,"s":1,"t":2,"w":1,"modes":[{"n":-1,"cos":{"start":1e+21}},{"n":1,"cos":{"start":0.3}},"#,
            r#"{"n":2,"sin":{"end":1,"end_u":4,"force":[1,2]}}]},"y":{"order":2,"s":1,"t":1,"modes":[]},"#,
            r#""z":{"order":2,"s":1,"t":1,"modes":[]}},"place":{"shift":[0,0,0.1]},"#,
            r#""wall":{"thickness":0.3,"base":0},"look":{"clay":"black"}}]}"#
        )
    );
}

#[test]
fn a_wall_is_written_without_its_defaults() {
    let wall = |given: &str| {
        let shape = r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] }"#;
        let json = format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {given} }}] }}"#);
        let design = Design::parse(&json).unwrap();
        assert_eq!(Design::parse(&design.link()).unwrap(), design);
        design.to_json().split_once(r#""wall":"#).unwrap().1.trim_end_matches("}]}").to_owned()
    };
    assert_eq!(
        wall(r#"{ "drain": 0, "rim": "flat", "side": "inside", "base": 0.2, "thickness": 0.1 }"#),
        r#"{"thickness":0.1,"base":0.2}"#
    );
    assert_eq!(
        wall(
            r#"{ "drain": 0.1, "foot": [0.2, 0.30000000000000004], "rim": "rounded", "side": "outside", "base": 0.2, "thickness": 0.1 }"#
        ),
        r#"{"thickness":0.1,"base":0.2,"side":"outside","rim":"rounded","foot":[0.2,0.3],"drain":0.1}"#
    );
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

/// Twelve digits of such an angle hold any number of turns: the parts of a turn were read from it in two ways, and of the two turns of an oval that make the same solid now one was taken and now the other.
#[test]
fn a_turn_of_very_many_turns_has_one_form() {
    let shape = concat!(
        r#"{ "kind": "rings", "rings": ["#,
        r#"{ "u": 0, "r": { "mean": 3, "waves": [{ "n": 2, "cos": 1 }] }, "z": { "mean": 0 } }, "#,
        r#"{ "u": 1, "r": { "mean": 4 }, "z": { "mean": 5 } }] }"#
    );
    for angle in ["-4.2350980405218554e86", "-8.821967180262477e49", "3e12", "-1e15", "7.3e9", "1e300"] {
        for scale in ["[1, 1, 1]", "[-2, 1, 1]", "[1, 3, -1]"] {
            let place = format!(r#"{{ "scale": {scale}, "axis": [0.3, 0.2, 0.9], "angle": {angle} }}"#);
            let json = format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "place": {place} }}] }}"#);
            let design = Design::parse(&json).unwrap();
            assert_eq!(Design::parse(&design.to_json()).unwrap(), design, "{place}");
        }
    }
}

/// The same object with its fields in another order, deep down.
fn reversed(value: &Value) -> Value {
    match value {
        Value::Record(fields) => {
            Value::Record(fields.iter().rev().map(|(name, value)| (name.clone(), reversed(value))).collect())
        }
        Value::List(items) => Value::List(items.iter().map(reversed).collect()),
        other => other.clone(),
    }
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
    parts.iter().map(|part| field(part, "shape").unwrap().shape()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn canonical_form_and_links_are_exact(document in document()) {
        let design = document.design().unwrap_or_else(|e| panic!("{e}\n{document:?}"));

        // Canonical form is its own canonical form, as text and as a tree.
        let text = design.to_json();
        let again = Design::parse(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        prop_assert_eq!(&again, &design);
        prop_assert_eq!(again.to_json(), text.clone());
        let serialized = serde_json::to_string(&design).unwrap();
        prop_assert_eq!(&Design::parse(&serialized), &Ok(design.clone()));
        prop_assert_eq!(&serde_json::from_str::<Design>(&serialized).unwrap(), &design);

        // A link brings back the same design with its parts in order, and the same link.
        let link = design.link();
        let ordered = design.ordered();
        prop_assert_eq!(&Design::parse(&link), &Ok(ordered.clone()), "{}", link);
        prop_assert_eq!(&Design::parse(&format!("https://example.org/#{link}")), &Ok(ordered.clone()), "{}", link);
        prop_assert_eq!(&ordered.ordered(), &ordered);
        prop_assert_eq!(ordered.link(), link);

        // The problem to be solved is the one that was given.
        for (given, Part { shape, .. }) in given_shapes(&document).iter().zip(design.parts()) {
            assert_same_problem(&given.boundary_value().unwrap(), &shape.boundary_value().unwrap());
        }
    }

    #[test]
    fn the_order_of_fields_has_no_meaning(document in document()) {
        prop_assert_eq!(document.design(), reversed(&document).design());
    }
}
