//! What makes an open surface a pot.

use super::names::names;
use super::number::rounded;
use super::path::Path;
use super::reader::{self, Range, Record};
use super::table::{self, Entry, optional, required};
use super::value::Value;
use crate::error::Result;

/// The clay between the surface and the lining, in model units after placement.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Wall {
    /// The thickness of the wall along the normal; greater than 0.
    pub thickness: f64,
    /// The thickness of the base; 0 for a pot without one.
    pub base: f64,
    /// Which side of the wall the surface is not: where the clay goes.
    pub side: Side,
    /// How the wall ends at an opening.
    pub rim: RimForm,
    /// Width and height of a ring under the base, both greater than 0, for a pot that stands on one.
    pub foot: Option<[f64; 2]>,
    /// The diameter of a round hole through the base; 0 for none.
    pub drain: f64,
}

names! {
    /// Where the clay of a wall goes.
    pub enum Side {
        /// Inwards: the surface is the outside of the pot.
        Inside = "inside",
        /// Outwards: the surface is the lining of the pot.
        Outside = "outside",
    }
}

names! {
    /// How a wall ends at an opening.
    #[non_exhaustive]
    pub enum RimForm {
        /// Cut square across the wall.
        Flat = "flat",
        /// Half a circle as wide as the wall.
        Rounded = "rounded",
    }
}

pub(crate) const WALL: &[Entry] = &[
    required("thickness", "number", "The thickness of the wall along the normal. Greater than 0."),
    required("base", "number", "The thickness of the base; 0 for a pot without one. Not less than 0."),
    optional("side", "Side", "Which way the clay goes from the surface; inside when left out."),
    optional("rim", "RimForm", "How the wall ends at an opening; flat when left out."),
    optional(
        "foot",
        "readonly [number, number]",
        "Width and height of a ring under the base; none when left out. Greater than 0.",
    ),
    optional("drain", "number", "The diameter of a round hole through the base; 0 when left out. Not less than 0."),
];

impl Wall {
    pub(crate) fn read(value: &Value, path: Path) -> Result<Self> {
        let record = Record::open(value, path, "a wall with thickness and base")?.only(&table::names(WALL))?;
        let number = |name, range| reader::number(record.require(name, "a number")?, &record.path.field(name), range);
        Ok(Wall {
            thickness: number("thickness", Range::Positive)?,
            base: number("base", Range::NotNegative)?,
            side: Side::read(&record, "side")?,
            rim: RimForm::read(&record, "rim")?,
            foot: match record.get("foot") {
                Some(value) => {
                    let mut ring = [0.0; 2];
                    reader::numbers(value, &record.path.field("foot"), Range::Positive, &mut ring)?;
                    Some(ring)
                }
                None => None,
            },
            drain: match record.get("drain") {
                Some(value) => reader::number(value, &record.path.field("drain"), Range::NotNegative)?,
                None => 0.0,
            },
        })
    }

    /// Every number to twelve significant digits.
    pub(crate) fn canonical(self) -> Self {
        Wall {
            thickness: rounded(self.thickness),
            base: rounded(self.base),
            foot: self.foot.map(|ring| ring.map(rounded)),
            drain: rounded(self.drain),
            ..self
        }
    }

    pub(crate) fn write(&self, into: &mut Vec<(String, Value)>) {
        into.push(("thickness".to_owned(), Value::Number(self.thickness)));
        into.push(("base".to_owned(), Value::Number(self.base)));
        self.side.write("side", into);
        self.rim.write("rim", into);
        if let Some(ring) = self.foot {
            into.push(("foot".to_owned(), Value::List(ring.map(Value::Number).to_vec())));
        }
        if self.drain != 0.0 {
            into.push(("drain".to_owned(), Value::Number(self.drain)));
        }
    }
}
