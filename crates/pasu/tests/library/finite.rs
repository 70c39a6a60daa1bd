//! Every number that is measured, and how far it may be off, is finite or absent: designs with numbers that nobody means.

use pasu::{Code, Design, MeasureOptions, measure};
use serde_json::Value;

/// What was measured with errors that were not numbers.
const DESIGNS: [(&str, &str); 4] = [
    (
        "an overhang whose error is not finite",
        r#"{"pasu": 1, "parts": [{"shape": {"kind": "bloor-wilson", "a": 0.258, "r": [500, 0.36042336, 0.35944128, 3.7517], "R": [5.0348, -5.887823857716922e-245, 2.5174, 3.7044], "h": [13.5958, 0.5343], "H": [-7.150031220000001, -1.0375605794287121e+79], "n1": 6}, "wall": {"thickness": 0.3088, "base": 0.4402}, "place": {"scale": [1.2517, 6.27666920988621e-264, 1.2012], "axis": [0.7619, 0.1543, 0.9625], "angle": -0.6861, "shift": [-14.2498, 1.1062, 7.321]}}]}"#,
    ),
    (
        "a curvature whose error is not finite",
        r#"{"pasu": 1, "parts": [{"shape": {"kind": "bloor-wilson", "a": 0.3577, "r": [-1.4517688155377722e-137, 0.15098451999999998, -0.21687552, 2.598], "R": [2.2825, 1.14125, 2.2250738585072014e-308, 2.929], "h": [7.021, 0.5014], "H": [-8.6561909, -0.6406], "n1": 1}, "wall": {"thickness": 0.18, "base": 0.7797}, "place": {"scale": [1.4281, 1e+16, 1.1248], "axis": [0.6081, -0.302, 16], "angle": -2.1704, "shift": [14.2078, -11.8859, -2.0993]}}]}"#,
    ),
    (
        "curvatures that are not finite",
        r#"{"pasu": 1, "parts": [{"shape": {"kind": "second-order", "r": [4.9648, 0.04120784, 2.1332, 0.10260691999999999], "n": [1, 11], "t": [0.0766, 4294967295], "height": 8.4958}, "wall": {"thickness": 3.855367387e+288, "base": 0.4827}, "place": {}}]}"#,
    ),
    (
        "a height whose error is not finite",
        r#"{"pasu": 1, "parts": [{"shape": {"kind": "bloor-wilson", "a": 1.1876, "r": [3.7507, -0.27867701, -0.30605712, 2.4803], "R": [-0.6505, -0.32525, -8.801338790689563e-246, -5.0377], "h": [10000000.0, 0.1852], "H": [-8.3846466, -0.0448], "n1": 3}, "wall": {"thickness": 0.4495, "base": 0.3117, "side": "outside"}, "place": {"scale": [1.3482, 4.099591423592555e+58, 0.8752], "axis": [0.8766, 0.4314, -0.1937], "angle": 0.7377, "shift": [-8.2389, 1e-45, 1.7976931348623157e+308]}}]}"#,
    ),
];

/// Places where a quantity has a value or an error that is not finite, which JSON writes as null.
fn not_finite(path: &str, value: &Value, found: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            for (name, field) in fields {
                let path = format!("{path}.{name}");
                if field.is_null()
                    && matches!(name.as_str(), "value" | "error" | "degrees" | "greatestError" | "thinnedError")
                {
                    found.push(path);
                } else {
                    not_finite(&path, field, found);
                }
            }
        }
        Value::Array(entries) => entries.iter().for_each(|entry| not_finite(path, entry, found)),
        _ => {}
    }
}

#[test]
fn numbers_are_finite_or_absent() {
    for (name, document) in DESIGNS {
        let design = Design::parse(document).expect("a design");
        match measure(&design, &MeasureOptions::default()) {
            Ok(measures) => {
                let json: Value = serde_json::from_str(&measures.to_json()).expect("JSON");
                let mut found = Vec::new();
                not_finite("", &json, &mut found);
                assert!(found.is_empty(), "{name}: {found:?}");
            }
            // What changes too fast to be measured is refused beforehand.
            Err(error) => assert!(matches!(error.code(), Code::Overflow | Code::TooLarge), "{name}: {error}"),
        }
    }
}
