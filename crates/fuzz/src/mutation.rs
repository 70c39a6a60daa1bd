//! Inputs like others: numbers that are extreme and still numbers, lists that are longer, fields from elsewhere, bytes that are damaged.

use std::f64::consts::{PI, TAU};

use serde_json::{Map, Value, json};

use crate::calls::CALLS;
use crate::random::Random;

/// Numbers at which something ends: ranges of the format, of counts, of what can be computed with.
const NUMBERS: [f64; 56] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    3.0,
    4.0,
    5.0,
    7.0,
    8.0,
    12.0,
    16.0,
    17.0,
    32.0,
    64.0,
    65.0,
    100.0,
    127.0,
    128.0,
    129.0,
    500.0,
    1000.0,
    4096.0,
    65536.0,
    1e6,
    1e9,
    4294967295.0,
    4294967296.0,
    1e12,
    1e15,
    9007199254740992.0,
    1e16,
    1e30,
    1e60,
    1e100,
    1e150,
    1e200,
    1e300,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    1e-300,
    1e-200,
    1e-100,
    1e-30,
    1e-15,
    1e-12,
    1e-9,
    1e-6,
    1e-3,
    0.1 + 0.2,
    PI,
    TAU,
    1.0 / 3.0,
    0.999_999_999_999,
];

/// Words of the format, and some that are none.
const WORDS: [&str; 38] = [
    "second-order",
    "mixed-order",
    "fourth-order",
    "bloor-wilson",
    "boundary-value",
    "rings",
    "vertex-frame",
    "global",
    "sine",
    "smooth",
    "start",
    "end",
    "both",
    "octant",
    "2pi",
    "mm",
    "cm",
    "in",
    "inside",
    "outside",
    "flat",
    "rounded",
    "celadon",
    "bare",
    "black",
    "stoneware",
    "",
    " ",
    "é\u{301}",
    "\u{0}",
    "\u{202e}",
    "#1/second-order?n=1,8",
    "&lt;",
    "100 %",
    "a=b&c",
    "\"",
    "]]>",
    "--",
];

/// Fields of the format.
const FIELDS: [&str; 53] = [
    "vertices",
    "patches",
    "frame",
    "a1",
    "forces",
    "f0",
    "seed",
    "pasu",
    "title",
    "unit",
    "parts",
    "name",
    "object",
    "shape",
    "place",
    "wall",
    "look",
    "joints",
    "limits",
    "turn",
    "glued",
    "kind",
    "r",
    "n",
    "height",
    "s",
    "t",
    "w",
    "force",
    "rise",
    "r0",
    "r1",
    "rm",
    "h1",
    "eta",
    "dz",
    "a",
    "R",
    "h",
    "H",
    "n1",
    "span",
    "x",
    "modes",
    "cos",
    "start_u",
    "thickness",
    "base",
    "foot",
    "drain",
    "lining",
    "waves",
    "scale",
];

/// How often a number is looked for.
const TRIES: usize = 2;

/// Lists are made this long: more than any limit of a design's parts and modes but the largest.
const LONG: usize = 70;

/// A document as text, or a link.
pub(crate) fn of_document(input: &[u8], others: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    match serde_json::from_slice::<Value>(input) {
        Ok(mut value) if !random.chance(8) => {
            for _ in 0..1 + random.below(2) {
                change(&mut value, others, random);
            }
            value.to_string().into_bytes()
        }
        _ if input.starts_with(b"#") => of_link(input, others, random),
        _ => of_bytes(input, random),
    }
}

/// A link: its numbers, names and signs, or its bytes.
fn of_link(input: &[u8], others: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let text = String::from_utf8_lossy(input).into_owned();
    let Some((kind, fields)) = text.split_once('?').filter(|_| !random.chance(6)) else {
        return of_bytes(input, random);
    };
    let mut fields: Vec<String> = fields.split('&').map(str::to_owned).collect();
    let at = random.below(fields.len());
    match random.below(5) {
        0 => fields.push(fields[at].clone()),
        1 => drop(fields.remove(at)),
        2 => fields.push(format!("{}={}", random.one_of(&FIELDS), number(1.0, random))),
        3 => {
            let other: &Vec<u8> = random.one_of(others);
            let other = String::from_utf8_lossy(other).into_owned();
            fields.extend(other.split_once('?').map(|(_, fields)| fields.to_owned()));
        }
        _ => {
            let (name, numbers) = fields[at].split_once('=').unwrap_or((&fields[at], ""));
            let mut numbers: Vec<String> = numbers.split(',').map(str::to_owned).collect();
            let k = random.below(numbers.len());
            numbers[k] = number(numbers[k].parse().unwrap_or(1.0), random).to_string();
            fields[at] = format!("{name}={}", numbers.join(","));
        }
    }
    format!("{kind}?{}", fields.join("&")).into_bytes()
}

/// A call and its design.
pub(crate) fn of_call(input: &[u8], others: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let text = String::from_utf8_lossy(input).into_owned();
    let (call, design) = text.split_once('\n').unwrap_or(("", &text));
    let call = if random.chance(4) { random.one_of(&CALLS).0 } else { call };
    let mut changed = format!("{call}\n").into_bytes();
    changed.extend(of_document(design.as_bytes(), others, random));
    changed
}

/// Bytes: one or a few changed, taken out, doubled or moved.
pub(crate) fn of_bytes(input: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = input.to_vec();
    for _ in 0..1 + random.below(4) {
        if bytes.is_empty() {
            bytes.push(random.bits() as u8);
        }
        let at = random.below(bytes.len());
        let end = (at + 1 + random.below(16)).min(bytes.len());
        match random.below(7) {
            0 => bytes[at] = random.bits() as u8,
            1 => bytes[at] ^= 1 << random.below(8),
            2 => drop(bytes.drain(at..end)),
            3 => bytes.truncate(at),
            4 => bytes.insert(at, *random.one_of(b"\0\xff\"<>&=,.-+#~0'\n{}[]")),
            5 => {
                let piece = bytes[at..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, piece);
            }
            // Lengths and counts, as files have them.
            _ => bytes[at..end.min(at + 4)].fill(*random.one_of(&[0, 0xff, 0x7f, 0x80])),
        }
    }
    bytes
}

/// Changes one value of a tree.
fn change(tree: &mut Value, others: &[Vec<u8>], random: &mut Random) {
    let n = nodes(tree);
    let mut at = random.below(n);
    // Rather a number: it leaves a design more often, and what is no design is soon refused.
    for _ in 0..TRIES {
        if !node(tree, &mut at.clone()).is_some_and(|node| node.is_number()) {
            at = random.below(n);
        }
    }
    let place = node(tree, &mut at).expect("as many nodes as were counted");
    if random.chance(6) {
        // What stands at the same place of another design, as far as one can go there.
        let other = random.one_of(others);
        let text = other.iter().position(|&byte| byte == b'{').map_or(&[][..], |start| &other[start..]);
        if let Ok(mut other) = serde_json::from_slice::<Value>(text) {
            let mut at = random.below(nodes(&other));
            let lent = node(&mut other, &mut at).expect("as many nodes as were counted");
            if lent.is_object() == place.is_object() && lent.is_array() == place.is_array() {
                *place = lent.take();
                return;
            }
        }
    }
    match place {
        Value::Number(x) => *place = json!(number(x.as_f64().unwrap_or_default(), random)),
        Value::Array(items) => change_list(items, random),
        Value::Object(fields) => change_fields(fields, random),
        _ => *place = json!(random.one_of(&WORDS)),
    }
}

/// Another number, often not far from this one.
fn number(x: f64, random: &mut Random) -> f64 {
    let changed = match random.below(10) {
        0..3 => *random.one_of(&NUMBERS),
        3 => -x,
        4 => x * (0.5 + 1.5 * random.unit()),
        5 => x + random.unit() - 0.5,
        6 => x.round() + random.below(5) as f64 - 2.0,
        7 => x * 10f64.powi(random.below(25) as i32 - 12),
        8 => x * (1.0 + 1e-9 * random.unit()),
        _ => (20.0 * random.unit() - 10.0) * 10f64.powi(random.below(4) as i32 - 2),
    };
    if changed.is_finite() { changed } else { x }
}

fn change_list(items: &mut Vec<Value>, random: &mut Random) {
    if items.is_empty() {
        return items.push(json!(number(1.0, random)));
    }
    let at = random.below(items.len());
    match random.below(5) {
        0 => drop(items.remove(at)),
        1 => items.insert(at, items[at].clone()),
        2 => {
            let other = random.below(items.len());
            items.swap(at, other);
        }
        3 => {
            for item in items {
                if let Value::Number(x) = item {
                    *item = json!(number(x.as_f64().unwrap_or_default(), random));
                }
            }
        }
        _ => items.resize(1 + random.below(LONG), items[at].clone()),
    }
}

fn change_fields(fields: &mut Map<String, Value>, random: &mut Random) {
    let names: Vec<String> = fields.keys().cloned().collect();
    if names.is_empty() || random.chance(4) {
        let value = match random.below(3) {
            0 => json!(number(1.0, random)),
            1 => json!([number(1.0, random), number(1.0, random)]),
            _ => json!(random.one_of(&WORDS)),
        };
        fields.insert((*random.one_of(&FIELDS)).to_owned(), value);
        return;
    }
    let name = random.one_of(&names);
    let value = fields.remove(name).unwrap_or_default();
    if random.chance(2) {
        // Under the name of another, which may be of the same kind: x and y, start and end.
        let other = random.one_of(&names).clone();
        let theirs = fields.insert(other, value.clone());
        fields.insert(name.clone(), theirs.unwrap_or(value));
    }
}

/// How many values are in a tree, itself among them.
fn nodes(tree: &Value) -> usize {
    1 + match tree {
        Value::Array(items) => items.iter().map(nodes).sum(),
        Value::Object(fields) => fields.values().map(nodes).sum(),
        _ => 0,
    }
}

/// The value of this number, counted from the root down; what is left of `at` if there are fewer.
fn node<'a>(tree: &'a mut Value, at: &mut usize) -> Option<&'a mut Value> {
    if *at == 0 {
        return Some(tree);
    }
    *at -= 1;
    match tree {
        Value::Array(items) => items.iter_mut().find_map(|item| node(item, at)),
        Value::Object(fields) => fields.values_mut().find_map(|value| node(value, at)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_of_a_tree_has_its_number() {
        let mut tree = json!({ "a": [1, { "b": 2 }], "c": [] });
        assert_eq!(nodes(&tree), 6);
        let found: Vec<String> = (0..6).map(|at| node(&mut tree, &mut at.clone()).unwrap().to_string()).collect();
        assert_eq!(found[1..], ["[1,{\"b\":2}]", "1", "{\"b\":2}", "2", "[]"]);
        assert_eq!(node(&mut tree, &mut 6), None);
    }

    #[test]
    fn numbers_stay_numbers() {
        let mut random = Random::new(3);
        for _ in 0..10_000 {
            let x = *random.one_of(&NUMBERS);
            assert!(number(x, &mut random).is_finite());
        }
    }
}
