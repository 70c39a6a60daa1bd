//! The TypeScript declarations of the design document, from the tables by which it is read.

use super::fields::{Field, Fields, Need};
use super::look::{Clay, Glaze};
use super::placement::Placement;
use super::quantity::{Range, Size};
use super::shape::KINDS;
use super::tables::{
    BOUNDARY_VALUE, DESIGN, Entry, FOURTH, FOURTH_DATUM, LOOK, MODE, PART, SECOND, SECOND_DATUM, WALL,
};
use super::unit::Unit;
use super::wall::{RimForm, Side};

/// The declarations of everything that a design document may hold, as the text of a `.d.ts` module.
///
/// `Design` fits what [`Design::parse`](crate::Design::parse) accepts and the canonical document that it gives back.
///
/// ```
/// assert!(pasu::typescript().contains("export interface Design {"));
/// ```
pub fn typescript() -> String {
    let mut text = String::from("// Generated from the field tables of the Rust crate `pasu`. Do not edit.\n");
    interface(&mut text, "Design", "A design: what a person has chosen.", DESIGN);
    interface(&mut text, "Part", "One placed surface of a design.", PART);
    union(&mut text, "Unit", "The unit of length.", Unit::NAMES);
    let kinds: Vec<&str> = KINDS.iter().map(|kind| kind.type_name).collect();
    text.push_str(&format!("\n/** A surface. */\nexport type Shape = {};\n", kinds.join(" | ")));
    for kind in KINDS {
        (kind.typescript)(kind.name, &mut text);
    }
    numbers(&mut text, "Placement", "Scaled, then turned, then moved.", None, Placement::FIELDS);
    interface(&mut text, "Wall", "The clay between the surface and the lining, in model units after placement.", WALL);
    union(&mut text, "Side", "Where the clay of a wall goes: inwards, or outwards.", Side::NAMES);
    union(&mut text, "RimForm", "How a wall ends at an opening: cut square, or half a circle.", RimForm::NAMES);
    interface(&mut text, "Look", "What a part is made of and covered with.", LOOK);
    union(&mut text, "GlazeName", "A glaze.", Glaze::NAMES);
    union(&mut text, "ClayName", "A clay body.", Clay::NAMES);
    text
}

/// The general shape, and what it is made of.
pub(super) fn boundary_value(text: &mut String) {
    interface(text, "BoundaryValue", "Fourier boundary data written out, component by component.", BOUNDARY_VALUE);
    text.push_str(
        "\n/** The equation and the boundary data of one component. */\n\
         export type Component = SecondOrderComponent | FourthOrderComponent;\n",
    );
    interface(text, "SecondOrderComponent", "A component of order 2.", SECOND);
    interface(text, "FourthOrderComponent", "A component of order 4.", FOURTH);
    interface(text, "Mode<Datum>", "One harmonic; data left out are 0.", MODE);
    interface(text, "SecondOrderDatum", "What a harmonic of order 2 is given; what is left out is 0.", SECOND_DATUM);
    interface(text, "FourthOrderDatum", "What a harmonic of order 4 is given; what is left out is 0.", FOURTH_DATUM);
}

fn union(text: &mut String, name: &str, about: &str, names: &[&str]) {
    let names: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    text.push_str(&format!("\n/** {about} */\nexport type {name} = {};\n", names.join(" | ")));
}

fn interface(text: &mut String, name: &str, about: &str, table: &[Entry]) {
    open(text, name, about);
    for entry in table {
        field(text, entry.name, entry.need, entry.typescript, entry.about);
    }
    text.push_str("}\n");
}

pub(super) fn numbers(text: &mut String, name: &str, about: &str, kind: Option<&str>, fields: &[Field]) {
    open(text, name, about);
    if let Some(kind) = kind {
        text.push_str(&format!("  readonly kind: {kind:?};\n"));
    }
    for table in fields {
        let typescript = match table.size {
            Size::One => "number".to_owned(),
            Size::List(length) => format!("readonly [{}]", vec!["number"; length].join(", ")),
        };
        let range = match table.range {
            Range::Any => "",
            Range::NotZero => " Not 0.",
            Range::Positive => " Greater than 0.",
            Range::NotNegative => " Not less than 0.",
        };
        let lines: Vec<&str> = table.about.iter().map(|line| line.trim()).collect();
        field(text, table.name, table.need, &typescript, &format!("{}{range}", lines.join(" ")));
    }
    text.push_str("}\n");
}

fn open(text: &mut String, name: &str, about: &str) {
    text.push_str(&format!("\n/** {about} */\nexport interface {name} {{\n"));
}

fn field(text: &mut String, name: &str, need: Need, typescript: &str, about: &str) {
    let mark = if need == Need::Optional { "?" } else { "" };
    text.push_str(&format!("  /** {about} */\n  readonly {name}{mark}: {typescript};\n"));
}

#[cfg(test)]
mod tests {
    use serde::de::DeserializeOwned;

    use super::*;
    use crate::design::boundary_value::{BoundaryValue, Component};
    use crate::design::{Look, Part, Value, Wall, reader};

    /// The fields that a type is read from, as its refusal of another says.
    fn fields<T: DeserializeOwned>(tag: Option<(&str, Value)>) -> String {
        let mut given = vec![("?".to_owned(), Value::Bool(true))];
        given.extend(tag.map(|(name, value)| (name.to_owned(), value)));
        let error = reader::read::<T>(&Value::Record(given)).err().unwrap();
        error.message().split_once("expected one of ").unwrap().1.to_owned()
    }

    fn check<T: DeserializeOwned>(table: &[Entry], tag: Option<(&str, Value)>) {
        let names: Vec<&str> = table.iter().map(|entry| entry.name).collect();
        assert_eq!(fields::<T>(tag), names.join(", "));
    }

    #[test]
    fn what_is_declared_is_what_is_read() {
        check::<Part>(PART, None);
        check::<Wall>(WALL, None);
        check::<Look>(LOOK, None);
        check::<BoundaryValue>(&BOUNDARY_VALUE[1..], None);
        check::<Component>(SECOND, Some(("order", Value::Number(2.0))));
        check::<Component>(FOURTH, Some(("order", Value::Number(4.0))));
    }
}
