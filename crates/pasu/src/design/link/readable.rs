//! The readable link: `bloor-wilson?a=6&n1=5`, which a teacher can type.

use super::damage::damaged;
use super::wrapping::encoded;
use crate::design::described::Spelling;
use crate::design::document::Design;
use crate::design::joint::Joints;
use crate::design::limits::VERSION;
use crate::design::look::{Choice, Named, is_hexadecimal};
use crate::design::number::shortest;
use crate::design::part::Part;
use crate::design::placement::Placement;
use crate::design::refusal::{self, shortened};
use crate::design::shape::KINDS;
use crate::design::unit::Unit;
use crate::design::value::Value;
use crate::error::{Error, Result};

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
    let [Part { name: None, object: 0, shape, place, wall: None, look, joints }] = design.parts() else { return None };
    if *place != Placement::default() || *joints != Joints::default() {
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
    let spelling = spelling(kind)?;
    let mut document = vec![("pasu".to_owned(), Value::Number(f64::from(VERSION)))];
    let mut spelled = Vec::new();
    let mut look = Vec::new();
    for pair in query.split('&').filter(|_| !query.is_empty()) {
        let Some((name, text)) = pair.split_once('=') else {
            return Err(damaged(&format!("expected a name, = and a value, found {:?}", shortened(pair))));
        };
        let name = name.trim();
        let word = || Value::Text(text.trim().to_owned());
        if spelling.names.contains(&name) {
            spelled.push((name, text));
        } else if name == TITLE {
            document.push((name.to_owned(), Value::Text(text.to_owned())));
        } else if name == UNIT {
            document.push((name.to_owned(), word()));
        } else if name == LINE {
            look.push((name.to_owned(), Value::spelled(text)));
        } else if LOOK.contains(&name) {
            let text = text.trim();
            let colour = if is_hexadecimal(text) { "#" } else { "" };
            look.push((name.to_owned(), Value::Text(format!("{colour}{text}"))));
        } else {
            let known = spelling.names.iter().copied().chain([TITLE, UNIT]).chain(LOOK);
            let error = refusal::unknown_field(name, None, &known.collect::<Vec<_>>());
            return Err(inside_shape(error));
        }
    }
    let mut shape = vec![("kind".to_owned(), Value::Text(kind.to_owned()))];
    shape.extend((spelling.read)(&spelled).map_err(inside_shape)?);
    let part = vec![("shape".to_owned(), Value::Record(shape)), ("look".to_owned(), Value::Record(look))];
    document.push(("parts".to_owned(), Value::List(vec![Value::Record(part)])));
    Design::from_value(&Value::Record(document))
}

fn inside_shape(error: Error) -> Error {
    error.inside_field("shape").inside_item(0).inside_field("parts")
}

/// What was chosen of glazes or clays; a colour without its `#`, which would begin another fragment.
fn chosen<N: Named>(field: &str, choice: Option<Choice<N>>) -> Option<String> {
    choice.map(|choice| format!("{field}={}", choice.to_string().trim_start_matches('#')))
}

/// How links of this kind are read.
fn spelling(name: &str) -> Result<Spelling> {
    let found = KINDS.iter().find(|kind| kind.name == name).and_then(|kind| kind.spelling);
    found.ok_or_else(|| {
        let readable: Vec<&str> = KINDS.iter().filter(|kind| kind.spelling.is_some()).map(|kind| kind.name).collect();
        refusal::unknown_name(name, &readable).at("parts[0].shape.kind")
    })
}
