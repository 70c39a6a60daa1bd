//! How a TypeScript declaration is written.

use super::fields::{Field, Need};
use super::quantity::{Range, Size};
use super::tables::Entry;

/// The longest line that the formatter of the package leaves as it is.
const WIDTH: usize = 120;

/// One of several names.
pub(super) fn union(text: &mut String, name: &str, about: &str, names: &[&str]) {
    let names: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    alternatives(text, name, about, &names);
}

/// A type that is one of several, on one line if that is not too long.
pub(super) fn alternatives(text: &mut String, name: &str, about: &str, names: &[String]) {
    let line = format!("export type {name} = {};\n", names.join(" | "));
    let declaration = match line.len() <= WIDTH + 1 {
        true => line,
        false => format!("export type {name} =\n  | {};\n", names.join("\n  | ")),
    };
    text.push_str(&format!("\n/** {about} */\n{declaration}"));
}

/// Fields of any type.
pub(super) fn interface(text: &mut String, name: &str, about: &str, table: &[Entry]) {
    open(text, name, about);
    for entry in table {
        field(text, entry.name, entry.need, entry.typescript, entry.about);
    }
    text.push_str("}\n");
}

/// Fields that are numbers, after the kind of a shape.
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
            Range::Share => " 0 to 1.",
            Range::Exponent => " 0.05 to 50.",
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
