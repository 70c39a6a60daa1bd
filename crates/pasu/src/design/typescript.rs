//! The TypeScript declarations of the design document, from the tables by which it is read.

use super::document::DESIGN;
use super::fields::{Field, Fields, Need, Size};
use super::look::{Clay, Glaze, LOOK};
use super::modes::{BOUNDARY_VALUE, FOURTH, FOURTH_DATUM, MODE, SECOND, SECOND_DATUM};
use super::part::PART;
use super::placement::Placement;
use super::reader::Range;
use super::shape::Kind;
use super::table::Entry;
use super::unit::Unit;
use super::wall::{RimForm, Side, WALL};

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
    text.push_str(
        "\n/** A surface. */\nexport type Shape = SecondOrder | MixedOrder | FourthOrder | BloorWilson | BoundaryValue;\n",
    );
    for (kind, name, source) in [
        (Kind::SecondOrder, "SecondOrder", "ZY01 equations 1 to 8"),
        (Kind::MixedOrder, "MixedOrder", "ZY01 equations 9 to 12"),
        (Kind::FourthOrder, "FourthOrder", "ZY01 equations 13 to 17"),
        (Kind::BloorWilson, "BloorWilson", "IA equations 15 to 18"),
    ] {
        numbers(&mut text, name, &format!("The vase of {source}."), Some(kind), kind.fields());
    }
    interface(&mut text, "BoundaryValue", "Fourier boundary data written out, component by component.", BOUNDARY_VALUE);
    text.push_str(
        "\n/** The equation and the boundary data of one component. */\n\
         export type Component = SecondOrderComponent | FourthOrderComponent;\n",
    );
    interface(&mut text, "SecondOrderComponent", "A component of order 2.", SECOND);
    interface(&mut text, "FourthOrderComponent", "A component of order 4.", FOURTH);
    interface(&mut text, "Mode<Datum>", "One harmonic; data left out are 0.", MODE);
    interface(
        &mut text,
        "SecondOrderDatum",
        "What a harmonic of order 2 is given; what is left out is 0.",
        SECOND_DATUM,
    );
    interface(
        &mut text,
        "FourthOrderDatum",
        "What a harmonic of order 4 is given; what is left out is 0.",
        FOURTH_DATUM,
    );
    numbers(&mut text, "Placement", "Scaled, then turned, then moved.", None, Placement::FIELDS);
    interface(&mut text, "Wall", "The clay between the surface and the lining, in model units after placement.", WALL);
    union(&mut text, "Side", "Where the clay of a wall goes: inwards, or outwards.", Side::NAMES);
    union(&mut text, "RimForm", "How a wall ends at an opening: cut square, or half a circle.", RimForm::NAMES);
    interface(&mut text, "Look", "What a part is made of and covered with.", LOOK);
    union(&mut text, "GlazeName", "A glaze.", Glaze::NAMES);
    union(&mut text, "ClayName", "A clay body.", Clay::NAMES);
    text
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

fn numbers(text: &mut String, name: &str, about: &str, kind: Option<Kind>, fields: &[Field]) {
    open(text, name, about);
    if let Some(kind) = kind {
        text.push_str(&format!("  readonly kind: {:?};\n", kind.name()));
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
