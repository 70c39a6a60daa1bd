//! The readable link: `bloor-wilson?a=6&n1=5`, which a teacher can type.

use super::damaged;
use super::wrapping::encoded;
use crate::design::decimal::parse;
use crate::design::document::Design;
use crate::design::fields::{Field, Size};
use crate::design::limits::VERSION;
use crate::design::look::Look;
use crate::design::part::Part;
use crate::design::path::{Path, shortened};
use crate::design::placement::Placement;
use crate::design::shape::Kind;
use crate::design::unit::Unit;
use crate::design::value::Value;
use crate::error::{Code, Result};

/// What a readable link may say beside the parameters of its shape.
const TITLE: &str = "title";
const UNIT: &str = "unit";
const LOOK: [&str; 2] = ["glaze", "clay"];

/// What follows `1/`; `None` when the design is more than one part of a named family.
pub(super) fn write(design: &Design) -> Option<String> {
    let [Part { name: None, object: 0, shape, place, wall: None, look }] = design.parts() else { return None };
    if *place != Placement::default() {
        return None;
    }
    let mut query = shape.write_link()?;
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
    let plain = Look::default();
    for (field, name, default) in
        [(LOOK[0], look.glaze.name(), plain.glaze.name()), (LOOK[1], look.clay.name(), plain.clay.name())]
    {
        if name != default {
            query.push(format!("{field}={name}"));
        }
    }
    let kind = shape.kind().name();
    Some(if query.is_empty() { kind.to_owned() } else { format!("{kind}?{}", query.join("&")) })
}

/// Reads what follows `1/` by writing out the document that it stands for: its reader refuses what is wrong.
pub(super) fn read(text: &str) -> Result<Design> {
    let (kind, query) = text.split_once('?').unwrap_or((text, ""));
    let path = Path::Start("parts[0].shape");
    let kind = Kind::read_family(kind.trim(), &path.field("kind"))?;
    let mut document = vec![("pasu".to_owned(), Value::Number(f64::from(VERSION)))];
    let (mut shape, mut look) = (Vec::new(), Vec::new());
    for pair in query.split('&').filter(|_| !query.is_empty()) {
        let Some((name, text)) = pair.split_once('=') else {
            return Err(damaged(&format!("expected a name, = and a value, found {:?}", shortened(pair))));
        };
        let name = name.trim();
        let word = || Value::Text(text.trim().to_owned());
        if let Some(field) = kind.fields().iter().find(|field| field.name == name) {
            shape.push((name.to_owned(), value(field, text)));
        } else if name == TITLE {
            document.push((name.to_owned(), Value::Text(text.to_owned())));
        } else if name == UNIT {
            document.push((name.to_owned(), word()));
        } else if LOOK.contains(&name) {
            look.push((name.to_owned(), word()));
        } else {
            let known = kind.fields().iter().map(|field| field.name).chain([TITLE, UNIT]).chain(LOOK);
            let known = known.collect::<Vec<_>>().join(", ");
            let message = format!("unknown field {:?}; expected one of {known}", shortened(name));
            return Err(path.field(name).error(Code::UnknownField, message));
        }
    }
    for (name, value) in kind.start() {
        if !shape.iter().any(|(given, _)| *given == name) {
            shape.push((name, value));
        }
    }
    let part = vec![("shape".to_owned(), Value::Record(shape)), ("look".to_owned(), Value::Record(look))];
    document.push(("parts".to_owned(), Value::List(vec![Value::Record(part)])));
    Design::from_value(&Value::Record(document))
}

/// What is not a number stays a text: the reader refuses it and says where.
fn value(field: &Field, text: &str) -> Value {
    let number = |text: &str| match parse(text.trim()) {
        Some(number) => Value::Number(number),
        None => Value::Text(text.trim().to_owned()),
    };
    match field.size {
        Size::One => number(text),
        Size::List(_) => Value::List(text.split(',').map(number).collect()),
    }
}
