//! Joints: which numbers of placements are sliders of the scene.

use pasu::{Design, compare, fingerprint, flat, tree};

const VASE: &str = r#""shape": { "kind": "second-order", "r": [1, 0, 2, 0], "height": 8 }"#;

fn with(joints: &str) -> pasu::Result<Design> {
    Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ {VASE}, "joints": {joints} }}] }}"#))
}

/// Where a joint is refused, and the whole sentence.
fn refusal(joints: &str) -> (String, String) {
    let error = with(joints).unwrap_err();
    (error.path().to_owned(), error.to_string())
}

#[test]
fn they_travel_in_documents_and_links() {
    let all = r#"{ "x": { "limits": [-3, -1] }, "y": { "limits": [0, 1e-3], "axis": [0, 0, 1] }, "z": { "label": "Lid", "limits": [-0.0, 4], "glued": true },
        "turn": { "axis": [0, 5, 0], "limits": [-6.283185307179586, 6.283185307179586], "glued": false } }"#;
    let design = with(all).unwrap();
    let written = r#""joints":{"x":{"limits":[-3,-1]},"y":{"limits":[0,0.001]},"z":{"label":"Lid","limits":[0,4],"glued":true},"turn":{"limits":[-6.28318530718,6.28318530718],"axis":[0,1,0]}}"#;
    assert!(design.to_json().contains(written), "{}", design.to_json());
    assert!(design.link().starts_with("1~"));
    for again in [design.to_json(), design.link()] {
        assert_eq!(Design::parse(&again).unwrap(), design);
    }
    assert_eq!(flat(&tree(&design)).unwrap(), design);
    let upright = with(r#"{ "turn": { "axis": [0, 0, 2], "limits": [-1, 1] } }"#).unwrap();
    assert!(upright.to_json().ends_with(r#""joints":{"turn":{"limits":[-1,1]}}}]}"#), "{}", upright.to_json());
}

#[test]
fn none_are_not_written() {
    let bare = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{{ {VASE} }}] }}"#)).unwrap();
    let empty = with("{}").unwrap();
    assert_eq!(empty, bare);
    assert_eq!(empty.to_json(), bare.to_json());
    assert_eq!(empty.link(), bare.link());
    assert!(bare.link().starts_with("1/second-order"));
}

#[test]
fn they_do_not_say_what_a_scene_is() {
    let bare = with("{}").unwrap();
    let jointed = with(r#"{ "z": { "limits": [-1, 1] } }"#).unwrap();
    assert_ne!(bare.link(), jointed.link());
    assert_eq!(fingerprint(&bare).unwrap(), fingerprint(&jointed).unwrap());
    let difference = compare(&bare, &jointed);
    assert!(difference.is_same);
    assert_eq!(difference.kept.len(), 1);
}

#[test]
fn links_do_not_depend_on_the_order_of_parts_that_are_alike_but_for_joints() {
    let [one, other] =
        ["1", "2"].map(|end| format!(r#"{{ {VASE}, "joints": {{ "z": {{ "limits": [0, {end}] }} }} }}"#));
    let scene = |first: &str, second: &str| {
        Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{first}, {second}] }}"#)).unwrap()
    };
    assert_eq!(scene(&one, &other).link(), scene(&other, &one).link());
    // What tells parts apart comes before what they can be moved by.
    let bare = format!(r#"{{ {VASE}, "object": 1 }}"#);
    assert_eq!(scene(&one, &bare).link(), scene(&bare, &one).link());
}

#[test]
fn a_value_outside_the_limits_stays() {
    let json = format!(
        r#"{{ "pasu": 1, "parts": [{{ {VASE}, "place": {{ "shift": [0, 0, 9] }}, "joints": {{ "z": {{ "limits": [0, 4] }} }} }}] }}"#
    );
    let design = Design::parse(&json).unwrap();
    assert_eq!(design.parts()[0].place.shift, [0.0, 0.0, 9.0]);
    assert_eq!(design.parts()[0].joints.z.as_ref().unwrap().limits, [0.0, 4.0]);
}

#[test]
fn refusals_name_path_value_and_expectation() {
    let at = |path: &str| format!("parts[0].joints{path}");
    for (joints, path, words) in [
        ("[]", "", "expected joints by the numbers that they move: x, y, z or turn, found an empty list"),
        (r#"{ "w": { "limits": [0, 1] } }"#, ".w", "expected one of x, y, z, turn"),
        (r#"{ "x": 3 }"#, ".x", "expected a joint with its limits, found 3"),
        (r#"{ "x": {} }"#, ".x.limits", "found nothing"),
        (r#"{ "x": { "limits": [0] } }"#, ".x.limits", "expected a list of 2 numbers"),
        (r#"{ "x": { "limits": [0, 1, 2] } }"#, ".x.limits", "expected a list of 2 numbers"),
        (r#"{ "x": { "limits": [0, "1"] } }"#, ".x.limits[1]", "expected a number, found \"1\""),
        (r#"{ "x": { "limits": [0, 1e999] } }"#, ".x.limits[1]", ""),
        (r#"{ "x": { "limits": [1, 0] } }"#, ".x.limits[1]", "expected a number greater than 1, found 0"),
        (r#"{ "x": { "limits": [1, 1.0000000000001] } }"#, ".x.limits[1]", "expected a number greater than 1, found 1"),
        (
            r#"{ "turn": { "limits": [-7, 0] } }"#,
            ".turn.limits[0]",
            "expected an angle from -6.28318530718 to 6.28318530718, found -7",
        ),
        (r#"{ "turn": { "limits": [0, 1], "axis": [0, 0, 0] } }"#, ".turn.axis", "expected the direction of an axis"),
        (r#"{ "z": { "limits": [0, 1], "axis": [1, 0, 0] } }"#, ".z.axis", "only a turn has an axis"),
        (r#"{ "z": { "limits": [0, 1], "glued": 1 } }"#, ".z.glued", "found 1"),
        (r#"{ "z": { "limits": [0, 1], "label": "a\nb" } }"#, ".z.label", "plain text on one line"),
        (r#"{ "z": { "limits": [0, 1] }, "z": { "limits": [0, 1] } }"#, ".z", "given twice"),
    ] {
        let (found, sentence) = refusal(joints);
        let expected = if joints.contains("1e999") { found.clone() } else { at(path) };
        assert_eq!(found, expected, "{joints}: {sentence}");
        assert!(sentence.contains(words), "{joints}: {sentence}");
    }
    let long = "a".repeat(201);
    let (path, _) = refusal(&format!(r#"{{ "x": {{ "limits": [0, 1], "label": "{long}" }} }}"#));
    assert_eq!(path, at(".x.label"));
    let union = r#"{ "pasu": 1, "tree": { "joints": {}, "connected": [{}, {}] } }"#;
    assert_eq!(pasu::Tree::parse(union).unwrap_err().path(), "tree.joints");
}
