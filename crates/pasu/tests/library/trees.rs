//! Trees of scenes: one for every scene, and one scene for all trees that say the same.

use std::f64::consts::PI;

use pasu::{Code, Content, Design, Node, Tree, connectivity, fingerprint, flat, tree};
use serde_json::{Value, json};

use crate::scenes::{below, numbers, part, rotation, scene, shuffled};
use crate::support::networks::Dice;

type Rows = [[f64; 3]; 3];

/// Where something stands: rotation and shift.
#[derive(Clone, Copy)]
struct Frame {
    rows: Rows,
    shift: [f64; 3],
}

const STILL: Frame = Frame { rows: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0; 3] };

impl Frame {
    fn of(place: &Value) -> Frame {
        Frame { rows: rotation(place), shift: numbers(&place["shift"]) }
    }

    /// This one as it is seen from another.
    fn seen_from(&self, frame: &Frame) -> Frame {
        let back = |v: [f64; 3]| [0, 1, 2].map(|i| (0..3).map(|k| frame.rows[k][i] * v[k]).sum::<f64>());
        let columns = [0, 1, 2].map(|j| back([0, 1, 2].map(|i| self.rows[i][j])));
        let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[j][i]));
        Frame { rows, shift: back([0, 1, 2].map(|i| self.shift[i] - frame.shift[i])) }
    }

    fn written(&self) -> Value {
        let rows = &self.rows;
        let vector = [rows[2][1] - rows[1][2], rows[0][2] - rows[2][0], rows[1][0] - rows[0][1]];
        let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
        let angle = length.atan2(rows[0][0] + rows[1][1] + rows[2][2] - 1.0);
        let axis = if length < 1e-12 { [0.0, 0.0, 1.0] } else { vector };
        json!({ "axis": axis, "angle": angle, "shift": self.shift })
    }
}

fn leaf(part: &Value) -> Value {
    let mut leaf = part.clone();
    let fields = leaf.as_object_mut().unwrap();
    fields.remove("object");
    let place = fields.remove("place").unwrap();
    fields.insert("scale".to_owned(), place["scale"].clone());
    leaf
}

/// Some tree of some of the nodes, each with where it stands: taken together two or more at a time, in any order.
fn grown(dice: &mut Dice, mut nodes: Vec<(Value, Frame)>, union: &str) -> (Value, Frame) {
    while nodes.len() > 1 {
        shuffled(dice, &mut nodes);
        let n = 2 + below(dice, nodes.len() - 1);
        let members: Vec<(Value, Frame)> = nodes.drain(..n).collect();
        let first = members[0].1;
        let placed = |(index, (mut node, frame)): (usize, (Value, Frame))| {
            if index > 0 {
                node["place"] = frame.seen_from(&first).written();
            }
            node
        };
        let members: Vec<Value> = members.into_iter().enumerate().map(placed).collect();
        nodes.push((json!({ union: members }), first));
    }
    nodes.pop().unwrap()
}

/// Some tree of a scene.
fn random_tree(dice: &mut Dice, parts: &[Value]) -> Value {
    let mut objects: Vec<(u64, Vec<(Value, Frame)>)> = Vec::new();
    for part in parts {
        let object = part["object"].as_u64().unwrap();
        let node = (leaf(part), Frame::of(&part["place"]));
        match objects.iter_mut().find(|(number, _)| *number == object) {
            Some((_, nodes)) => nodes.push(node),
            None => objects.push((object, vec![node])),
        }
    }
    let glued = objects.into_iter().map(|(_, nodes)| grown(dice, nodes, "connected")).collect();
    let (mut root, frame) = grown(dice, glued, "unconnected");
    root["place"] = frame.seen_from(&STILL).written();
    json!({ "pasu": 1, "tree": root })
}

fn read(tree: &Value) -> Tree {
    Tree::parse(&tree.to_string()).unwrap()
}

#[test]
fn a_scene_is_the_flat_list_of_its_tree() {
    let mut dice = Dice(61);
    for round in 0..150 {
        let n = 1 + below(&mut dice, 8);
        let parts: Vec<Value> = (0..n).map(|index| part(&mut dice, index)).collect();
        let design = scene(&parts);
        let tree = tree(&design);
        let again = flat(&tree).unwrap();
        assert_eq!(again.ordered().to_json(), design.ordered().to_json(), "{}", tree.to_json());
        assert_eq!(again.link(), design.link());
        if round % 10 == 0 {
            assert_eq!(fingerprint(&again), fingerprint(&design));
        }
        assert_eq!(pasu::tree(&again), tree);
        assert_eq!(Tree::parse(&tree.to_json()).unwrap(), tree);
        // However the parts were ordered and their objects numbered, it is the same tree.
        let mut mixed = parts.clone();
        mixed.iter_mut().for_each(|part| part["object"] = json!(9 - part["object"].as_u64().unwrap()));
        shuffled(&mut dice, &mut mixed);
        assert_eq!(pasu::tree(&scene(&mixed)), tree);
    }
}

#[test]
fn all_trees_of_a_scene_make_the_same_list() {
    let mut dice = Dice(62);
    let (mut n_equal, mut n_trees) = (0, 0);
    for _ in 0..120 {
        let n = 1 + below(&mut dice, 8);
        let parts: Vec<Value> = (0..n).map(|index| part(&mut dice, index)).collect();
        let design = scene(&parts);
        for _ in 0..3 {
            let made = flat(&read(&random_tree(&mut dice, &parts))).unwrap();
            let difference = pasu::compare(&design, &made);
            n_trees += 1;
            if difference.is_same {
                n_equal += 1;
                assert_eq!(made.link(), design.link());
                continue;
            }
            // Twelve digits of numbers that were computed from twelve digits may end otherwise; more is a mistake.
            assert_eq!(difference.moved.len() + difference.kept.len(), n, "{difference:?}");
            assert!(difference.reglued.is_empty());
            for pair in &difference.moved {
                let places = (design.parts()[pair.before].place, made.parts()[pair.after].place);
                let numbers = |place: &pasu::Placement| {
                    let rows = place.matrix().concat();
                    rows.into_iter().chain(place.shift).collect::<Vec<f64>>()
                };
                for (one, other) in numbers(&places.0).into_iter().zip(numbers(&places.1)) {
                    assert!((one - other).abs() < 2e-11, "{places:?}");
                }
            }
        }
    }
    assert!(n_equal > 350 && n_trees == 360, "{n_equal} of {n_trees}");
}

fn leaves(node: &Node) -> usize {
    match &node.content {
        Content::Connected { connected: members } | Content::Unconnected { unconnected: members } => {
            members.iter().map(leaves).sum()
        }
        _ => 1,
    }
}

#[test]
fn the_matrix_is_that_of_the_objects() {
    let mut dice = Dice(63);
    for _ in 0..40 {
        let n = 1 + below(&mut dice, 8);
        let parts: Vec<Value> = (0..n).map(|index| part(&mut dice, index)).collect();
        let design = scene(&parts);
        let found = connectivity(&design);
        for i in 0..n {
            for j in 0..n {
                let is_glued = parts[i]["object"] == parts[j]["object"];
                assert_eq!((found.glued[i][j], found.objects[i] == found.objects[j]), (is_glued, is_glued));
            }
        }
        // What a tree glues is what its flat list has glued.
        let tree = tree(&design);
        assert_eq!(leaves(tree.root()), n);
        let again = connectivity(&flat(&tree).unwrap());
        let count = |matrix: &[Vec<bool>]| matrix.iter().flatten().filter(|is_glued| **is_glued).count();
        assert_eq!(count(&again.glued), count(&found.glued));
        assert_eq!(again.objects.iter().max(), found.objects.iter().max());
    }
}

#[test]
#[allow(clippy::approx_constant, reason = "a quarter of a turn as a document has it")]
fn quarter_turns_and_simple_numbers_stay_what_they_are() {
    // One petal, so that no turn makes the same solid.
    let shape = json!({ "kind": "second-order", "r": [3, 0.2, 2, 0.1], "n": [1, 2], "height": 4 });
    let vase = |place: Value| json!({ "shape": shape, "place": place });
    let pillar = json!({ "connected": [vase(json!({})), vase(json!({ "shift": [0, 0, 1.1] })), vase(json!({ "angle": PI / 2.0, "shift": [0.2, 0, 0] }))] });
    let mut turned = pillar.clone();
    turned["place"] = json!({ "angle": PI / 2.0, "shift": [5, 0.7, 0] });
    let whole = json!({ "pasu": 1, "tree": { "unconnected": [pillar, turned] } });
    let design = flat(&read(&whole)).unwrap();
    let places: Vec<_> = design.parts().iter().map(|part| (part.object, part.place.angle, part.place.shift)).collect();
    let quarter = 1.57079632679;
    assert_eq!(places[..3], [(0, 0.0, [0.0; 3]), (0, 0.0, [0.0, 0.0, 1.1]), (0, quarter, [0.2, 0.0, 0.0])]);
    assert_eq!(places[3..], [(1, quarter, [5.0, 0.7, 0.0]), (1, quarter, [5.0, 0.7, 1.1]), (1, -PI, [5.0, 0.9, 0.0])]);
}

/// A quarter of a turn between two placements of twelve digits was taken for one to the last digit.
#[test]
fn parts_at_right_angles_come_back_from_their_tree() {
    let vase: Value = serde_json::from_str(&Design::parse("#1/bloor-wilson?n1=5").unwrap().to_json()).unwrap();
    let shape = &vase["parts"][0]["shape"];
    let scene = json!({ "pasu": 1, "parts": [
        { "shape": shape, "place": { "scale": [2, 2, 2], "axis": [-0.594960782092, 0.452645688986, 0.66417885243], "angle": -0.06 } },
        { "shape": shape, "place": { "axis": [-0.004355305246, 0.032060169164, -0.999476451383], "angle": -1.5314621887 } },
    ] });
    let design = Design::parse(&scene.to_string()).unwrap();
    let again = flat(&tree(&design)).unwrap();
    assert_eq!(again.link(), design.link());
    assert_eq!(fingerprint(&again).unwrap(), fingerprint(&design).unwrap());
}

fn refused(tree: &Value) -> (Code, String, String) {
    let error = Tree::parse(&tree.to_string()).and_then(|tree| flat(&tree)).unwrap_err();
    (error.code(), error.path().to_owned(), error.message().to_owned())
}

#[test]
fn what_is_no_tree_is_refused_with_its_place() {
    let octant = || json!({ "shape": { "kind": "octant", "exponents": [2, 3, 4] } });
    let with = |field: &str, value: Value| {
        let mut node = octant();
        node[field] = value;
        node
    };
    let of = |root: Value| json!({ "pasu": 1, "tree": root });
    let pair = |one: Value, other: Value| json!({ "connected": [one, other] });
    let among = |mut union: Value, field: &str, value: Value| {
        union[field] = value;
        union
    };
    let both = || pair(octant(), octant());
    for (tree, code, path) in [
        (json!({ "tree": octant() }), Code::MissingField, "pasu"),
        (json!({ "pasu": 2, "tree": octant() }), Code::UnknownVersion, "pasu"),
        (json!({ "pasu": 1 }), Code::MissingField, "tree"),
        (json!({ "pasu": 1, "parts": [octant()] }), Code::UnknownField, "parts"),
        (of(json!({})), Code::MissingField, "tree"),
        (of(json!([octant()])), Code::WrongType, "tree"),
        (of(json!({ "connected": [] })), Code::OutOfRange, "tree.connected"),
        (of(json!({ "connected": [octant()] })), Code::OutOfRange, "tree.connected"),
        (of(json!({ "connected": [octant(), null] })), Code::WrongType, "tree.connected[1]"),
        (of(among(both(), "shape", octant()["shape"].clone())), Code::Duplicate, "tree"),
        (of(among(both(), "unconnected", json!([octant(), octant()]))), Code::Duplicate, "tree"),
        (of(among(both(), "scale", json!([2, 2, 2]))), Code::UnknownField, "tree.scale"),
        (of(pair(octant(), among(both(), "scale", json!([2, 2, 2])))), Code::UnknownField, "tree.connected[1].scale"),
        (of(pair(octant(), among(both(), "name", json!("pair")))), Code::UnknownField, "tree.connected[1].name"),
        (of(with("object", json!(1))), Code::UnknownField, "tree.object"),
        (of(with("place", json!({ "scale": [2, 2, 2] }))), Code::UnknownField, "tree.place.scale"),
        (of(with("place", json!({ "axis": [0, 0, 0] }))), Code::OutOfRange, "tree.place.axis"),
        (of(with("scale", json!([1, 0, 1]))), Code::OutOfRange, "tree.scale[1]"),
        (of(with("scale", json!([1, 1]))), Code::WrongType, "tree.scale"),
        (of(pair(with("place", json!({ "angle": 1 })), octant())), Code::OutOfRange, "tree.connected[0].place"),
        (
            of(pair(octant(), json!({ "unconnected": [octant(), octant()] }))),
            Code::OutOfRange,
            "tree.connected[1].unconnected",
        ),
        (of(pair(with("name", json!("a")), with("name", json!("a")))), Code::Duplicate, "tree.connected[1].name"),
        (
            of(pair(octant(), json!({ "shape": { "kind": "octant", "exponents": [2, 3, 90] } }))),
            Code::OutOfRange,
            "tree.connected[1].shape.exponents[2]",
        ),
        (
            of(among(
                pair(octant(), with("place", json!({ "shift": [1.7e308, 0, 0] }))),
                "place",
                json!({ "shift": [1.7e308, 0, 0] }),
            )),
            Code::Overflow,
            "tree.connected[1].place.shift",
        ),
    ] {
        let (found, at, message) = refused(&tree);
        assert_eq!((found, at.as_str()), (code, path), "{message}: {tree}");
        assert!(!message.is_empty());
    }
    // By what a tree has: it has no list of parts.
    let twice = of(pair(with("name", json!("a")), with("name", json!("a"))));
    let error = Tree::parse(&twice.to_string()).and_then(|tree| flat(&tree)).unwrap_err();
    let message = "expected a name that no other part has, found \"a\", which is that of tree.connected[0]";
    assert_eq!((error.message(), error.args()), (message, &[("earlier", "tree.connected[0]".into())][..]));
    // What only JavaScript can say.
    let not_finite = serde_json::from_str::<Value>(
        r#"{ "pasu": 1, "tree": { "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "angle": 1e999 } } }"#,
    );
    assert!(not_finite.is_err());
    let error = Tree::parse(r#"{ "pasu": 1, "tree": { "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "angle": 1e999 } } }"#).unwrap_err();
    assert_eq!(error.code(), Code::NotFinite);
}

#[test]
fn deep_and_large_trees_have_an_end() {
    let octant = r#"{ "shape": { "kind": "octant", "exponents": [2, 2, 2] } }"#;
    let deep = |n: usize| {
        let (open, close) = (r#"{ "connected": ["#.repeat(n), format!(", {octant}] }}").repeat(n));
        format!(r#"{{ "pasu": 1, "tree": {open}{octant}{close} }}"#)
    };
    let tree = Tree::parse(&deep(24)).unwrap();
    assert_eq!(flat(&tree).unwrap().parts().len(), 25);
    let error = Tree::parse(&deep(25)).unwrap_err();
    assert_eq!((error.code(), error.path().matches("connected[0]").count()), (Code::TooLarge, 24));
    assert!(error.path().ends_with("connected[0].connected"), "{error}");
    // Text that is deeper than any document, and text that is too long.
    assert_eq!(Tree::parse(&deep(100)).unwrap_err().code(), Code::NotJson);
    assert_eq!(Tree::parse(&deep(100_000)).unwrap_err().code(), Code::NotJson);
    let long = format!("{}{}", " ".repeat(33 << 20), deep(1));
    assert_eq!(Tree::parse(&long).unwrap_err().code(), Code::TooLarge);
    let bare = format!(r#"{{ "pasu": 1, "tree": {}"#, r#"{"connected":["#.repeat(70_000));
    assert_eq!(Tree::parse(&bare).unwrap_err().code(), Code::NotJson);
    let wide = |n: usize| format!(r#"{{ "pasu": 1, "tree": {{ "unconnected": [{}] }} }}"#, vec![octant; n].join(", "));
    let all = Tree::parse(&wide(500)).unwrap();
    let design = flat(&all).unwrap();
    assert_eq!((design.parts().len(), design.parts()[499].object), (500, 499));
    assert_eq!(pasu::tree(&design).to_json().matches("exponents").count(), 500);
    let error = Tree::parse(&wide(501)).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::TooLarge, "tree.unconnected[500]"));
}

#[test]
fn titles_units_and_all_that_a_leaf_has_come_along() {
    let vase = json!({ "name": "vase", "shape": { "kind": "second-order", "r": [3, 0, 2, 0], "height": 5 }, "wall": { "thickness": 0.3, "base": 0.4 }, "look": { "glaze": "cobalt" } });
    let document = json!({ "pasu": 1, "title": "Two", "unit": "mm", "parts": [vase, { "shape": { "kind": "octant", "exponents": [2, 2, 1] }, "place": { "scale": [1, -2, 1] } }] });
    let design = Design::parse(&document.to_string()).unwrap();
    let tree = tree(&design);
    assert_eq!((tree.title(), tree.unit()), (Some("Two"), pasu::Unit::Mm));
    assert_eq!(flat(&tree).unwrap(), design.ordered());
}
