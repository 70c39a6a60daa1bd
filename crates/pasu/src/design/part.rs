//! One placed surface of a design.

use super::fields::{self, Fields};
use super::look::Look;
use super::path::Path;
use super::placement::Placement;
use super::reader::{self, Record};
use super::shape::Shape;
use super::table::{self, Entry, optional, required};
use super::value::Value;
use super::wall::Wall;
use crate::error::Result;

/// A part of a [`Design`](crate::Design).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Part {
    /// Its name, different from that of every other part.
    pub name: Option<String>,
    /// The discrete object that it is glued into.
    pub object: u32,
    /// Its surface, before placement.
    pub shape: Shape,
    /// Where it stands.
    pub place: Placement,
    /// The wall that makes its surface a pot.
    pub wall: Option<Wall>,
    /// Its clay and glaze.
    pub look: Look,
}

pub(crate) const PART: &[Entry] = &[
    optional("name", "string", "A name that no other part has."),
    optional("object", "number", "The discrete object that it is glued into; 0 when left out."),
    required("shape", "Shape", "Its surface, before placement."),
    optional("place", "Placement", "Where it stands."),
    optional("wall", "Wall", "The wall that makes its surface a pot."),
    optional("look", "Look", "Its clay and glaze."),
];

impl Part {
    pub(crate) fn read(value: &Value, path: Path) -> Result<Self> {
        let record = Record::open(value, path, "a part")?.only(&table::names(PART))?;
        let path = |name| record.path.field(name);
        Ok(Part {
            name: match record.get("name") {
                Some(value) => reader::label(value, &path("name"))?,
                None => None,
            },
            object: match record.get("object") {
                Some(value) => reader::whole(value, &path("object"))?,
                None => 0,
            },
            shape: Shape::read(record.require("shape", "a shape")?, path("shape"))?,
            place: match record.get("place") {
                Some(value) => fields::read_record(value, path("place"), "a placement")?,
                None => Placement::default(),
            },
            wall: match record.get("wall") {
                Some(value) => Some(Wall::read(value, path("wall"))?),
                None => None,
            },
            look: match record.get("look") {
                Some(value) => Look::read(value, path("look"))?,
                None => Look::default(),
            },
        })
    }

    pub(crate) fn canonical(self, path: &Path) -> Result<Self> {
        Ok(Part {
            shape: self.shape.canonical(&path.field("shape"))?,
            place: self.place.canonical(&path.field("place"))?,
            wall: self.wall.map(Wall::canonical),
            ..self
        })
    }

    pub(crate) fn value(&self) -> Value {
        let mut into = Vec::new();
        if let Some(name) = &self.name {
            into.push(("name".to_owned(), Value::Text(name.clone())));
        }
        if self.object != 0 {
            into.push(("object".to_owned(), Value::Number(f64::from(self.object))));
        }
        into.push(("shape".to_owned(), self.shape.value()));
        push_group(&mut into, "place", |fields| self.place.write(fields));
        if let Some(wall) = &self.wall {
            push_group(&mut into, "wall", |fields| wall.write(fields));
        }
        push_group(&mut into, "look", |fields| self.look.write(fields));
        Value::Record(into)
    }
}

/// A group of fields, unless all of them have their defaults.
fn push_group(into: &mut Vec<(String, Value)>, name: &str, write: impl FnOnce(&mut Vec<(String, Value)>)) {
    let mut fields = Vec::new();
    write(&mut fields);
    if !fields.is_empty() {
        into.push((name.to_owned(), Value::Record(fields)));
    }
}
