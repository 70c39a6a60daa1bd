//! The readable link: `bloor-wilson?a=6&n1=5`, which a teacher can type.

use super::damage::damaged;
use super::wrapping::encoded;
use crate::design::described::Family;
use crate::design::document::Design;
use crate::design::fields::{Field, Need};
use crate::design::limits::VERSION;
use crate::design::look::{Choice, Named, is_hexadecimal};
use crate::design::number::{parse, shortest};
use crate::design::part::Part;
use crate::design::placement::Placement;
use crate::design::quantity::Size;
use crate::design::refusal::{self, shortened};
use crate::design::shape::KINDS;
use crate::design::unit::Unit;
use crate::design::value::Value;
use crate::error::Result;

/// What a readable link may say beside the parameters of its shape.
const TITLE: &str = "title";
const UNIT: &str = "unit";
const GLAZE: &str = "glaze";
const INSIDE: &str = "inside";
const LINE: &str = "line";
const CLAY: &str = "clay";
const LOOK: [&str; 4] = [GLAZE, INSIDE, LINE, CLAY];

/// What follows `1/`; `None` when the design is more than one part of a named family.
pub(super) fn write(design: &Design) -> Option<String> {
    let [Part { name: None, object: 0, shape, place, wall: None, look }] = design.parts() else { return None };
    if *place != Placement::default() {
        return None;
    }
    let mut query = shape.link()?;
    if let Some(title) = design.title() {
        // A link may be decoded more than once on its way; these would not survive it.
        if title.contains(['%', '&', '#']) {
            return None;
        }
        query.push(format!("{TITLE}={}", encoded(title)));
    }
    if design.unit() != Unit::default() {
        query.push(format!("{UNIT}={}", design.unit().name()));
    }
    query.extend(chosen(GLAZE, (look.glaze != Choice::default()).then_some(look.glaze)));
    query.extend(chosen(INSIDE, look.inside));
    if look.line != 0.0 {
        query.push(format!("{LINE}={}", shortest(look.line)));
    }
    query.extend(chosen(CLAY, (look.clay != Choice::default()).then_some(look.clay)));
    let kind = shape.kind();
    Some(if query.is_empty() { kind.to_owned() } else { format!("{kind}?{}", query.join("&")) })
}

/// Reads what follows `1/` by writing out the document that it stands for: its reader refuses what is wrong.
#[inline]
pub(super) fn read(text: &str) -> Result<Design> {
    let (kind, query) = text.split_once('?').unwrap_or((text, ""));
    let kind = kind.trim();
    let family = family(kind)?;
    let mut document = vec![("pasu".to_owned(), Value::Number(f64::from(VERSION)))];
    let mut shape = vec![("kind".to_owned(), Value::Text(kind.to_owned()))];
    let mut look = Vec::new();
    for pair in query.split('&').filter(|_| !query.is_empty()) {
        let Some((name, text)) = pair.split_once('=') else {
            return Err(damaged(&format!("expected a name, = and a value, found {:?}", shortened(pair))));
        };
        let name = name.trim();
        let word = || Value::Text(text.trim().to_owned());
        if let Some(field) = family.fields.iter().find(|field| field.name == name) {
            shape.push((name.to_owned(), value(field, text)));
        } else if name == TITLE {
            document.push((name.to_owned(), Value::Text(text.to_owned())));
        } else if name == UNIT {
            document.push((name.to_owned(), word()));
        } else if name == LINE {
            look.push((name.to_owned(), number(text)));
        } else if LOOK.contains(&name) {
            let text = text.trim();
            let colour = if is_hexadecimal(text) { "#" } else { "" };
            look.push((name.to_owned(), Value::Text(format!("{colour}{text}"))));
        } else {
            let known = family.fields.iter().map(|field| field.name).chain([TITLE, UNIT]).chain(LOOK);
            let error = refusal::unknown_field(name, None, &known.collect::<Vec<_>>());
            return Err(error.inside_field("shape").inside_item(0).inside_field("parts"));
        }
    }
    // What a document may leave out, a link may as well.
    for (field, start) in family.fields.iter().zip((family.start)()) {
        if field.need == Need::Required && !shape.iter().any(|(given, _)| *given == field.name) {
            let mut start = start.into_iter().map(Value::Number);
            let start = match field.size {
                Size::One => start.next().unwrap_or(Value::Null),
                Size::List(_) => Value::List(start.collect()),
            };
            shape.push((field.name.to_owned(), start));
        }
    }
    let part = vec![("shape".to_owned(), Value::Record(shape)), ("look".to_owned(), Value::Record(look))];
    document.push(("parts".to_owned(), Value::List(vec![Value::Record(part)])));
    Design::from_value(&Value::Record(document))
}

/// The family of this name.
fn family(name: &str) -> Result<Family> {
    let found = KINDS.iter().find(|kind| kind.name == name).and_then(|kind| kind.family);
    found.ok_or_else(|| {
        let families: Vec<&str> = KINDS.iter().filter(|kind| kind.family.is_some()).map(|kind| kind.name).collect();
        refusal::unknown_name(name, &families).at("parts[0].shape.kind")
    })
}

/// What was chosen of glazes or clays; a colour without its `#`, which would begin another fragment.
fn chosen<N: Named>(field: &str, choice: Option<Choice<N>>) -> Option<String> {
    choice.map(|choice| format!("{field}={}", choice.to_string().trim_start_matches('#')))
}

/// What is not a number stays a text: the reader refuses it and says where.
fn number(text: &str) -> Value {
    match parse(text.trim()) {
        Some(number) => Value::Number(number),
        None => Value::Text(text.trim().to_owned()),
    }
}

fn value(field: &Field, text: &str) -> Value {
    match field.size {
        Size::One => number(text),
        Size::List(_) => Value::List(text.split(',').map(number).collect()),
    }
}
