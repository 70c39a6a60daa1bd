//! Fingerprints are the same on every machine: the golden file is read by the native, the Node and the browser tests.

use std::collections::BTreeMap;

use crate::support::golden::golden;
use crate::support::{corpus, design, design_of, design_of_case};
use pasu::fingerprint;

/// After a change of results that is meant, `PASU_BLESS=1 cargo test -p pasu --test library fingerprint` writes the file anew; the CHANGELOG says why.
#[test]
fn of_the_corpus_are_golden() {
    let found: BTreeMap<String, String> =
        corpus().iter().map(|case| (case.name.clone(), fingerprint(&design_of_case(case)).unwrap())).collect();
    let golden = golden!("fingerprints.json").beside(&found);
    assert_eq!(found, golden);
}

#[test]
fn only_the_geometry_counts() {
    let shape = r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.06] }"#;
    let of = |rest: &str, part: &str| {
        fingerprint(&design(&format!(r#"{{ "pasu": 1, {rest} "parts": [{{ "shape": {shape} {part} }}] }}"#))).unwrap()
    };
    let plain = fingerprint(&design_of(shape)).unwrap();
    assert_eq!(plain.len(), 16);
    assert_eq!(plain, of(r#""title": "A vase", "unit": "mm","#, r#", "name": "body", "look": { "glaze": "cobalt" }"#));
    assert_ne!(plain, of("", r#", "place": { "shift": [0, 0, 0.001] }"#));
    assert_ne!(plain, fingerprint(&design_of(r#"{ "kind": "second-order", "r": [1, 0.1, 0.6, 0.060001] }"#)).unwrap());
}
