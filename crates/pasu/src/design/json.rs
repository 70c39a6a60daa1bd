//! JSON text in and out.

use serde::Deserialize;
use serde_json::error::Category;
use serde_path_to_error::Segment;

use super::limits::BYTES;
use super::number::plain;
use super::path::Path;
use super::value::Value;
use crate::error::{Code, Error, Result};

/// Reads JSON text, whose faults are told by their place.
pub(crate) fn read(text: &str) -> Result<Value> {
    if text.len() > BYTES {
        let message = format!("expected a design of at most {BYTES} bytes of JSON, found {}", text.len());
        return Err(Error::new(Code::TooLarge, "", message));
    }
    let mut source = serde_json::Deserializer::from_str(text);
    let mut track = serde_path_to_error::Track::new();
    let read = Value::deserialize(serde_path_to_error::Deserializer::new(&mut source, &mut track));
    let value = read.map_err(|error| refused(&error, path_text(&track.path())))?;
    source.end().map_err(|error| refused(&error, String::new()))?;
    Ok(value)
}

/// The path as every other error writes it; a place that has no name yet is that of its record.
fn path_text(path: &serde_path_to_error::Path) -> String {
    path.iter().fold(String::new(), |text, segment| {
        let parent = Path::Start(&text);
        match segment {
            Segment::Seq { index } => parent.item(*index).to_string(),
            Segment::Map { key } => parent.field(key).to_string(),
            Segment::Enum { .. } | Segment::Unknown => text,
        }
    })
}

fn refused(error: &serde_json::Error, path: String) -> Error {
    let what = error.to_string();
    // serde_json ends its messages with the place, which is said here in words.
    let what = what.split(" at line ").next().unwrap_or_default();
    if what == "number out of range" {
        return Error::new(Code::NotFinite, path, "expected a number, found one too large to be computed with");
    }
    let (line, column) = (error.line(), error.column());
    let message = match error.classify() {
        Category::Eof => {
            format!("This JSON text ends in the middle, at line {line}, column {column}; is it cut short?")
        }
        _ => format!("This is not JSON: {what} at line {line}, column {column}."),
    };
    Error::new(Code::NotJson, path, message)
}

/// Writes a tree on one line, exactly as JavaScript's `JSON.stringify` would.
pub(crate) fn write(value: &Value) -> String {
    let mut text = String::new();
    write_value(value, &mut text);
    text
}

fn write_value(value: &Value, into: &mut String) {
    match value {
        Value::Null => into.push_str("null"),
        Value::Bool(b) => into.push_str(if *b { "true" } else { "false" }),
        Value::Number(x) if x.is_finite() => into.push_str(&plain(*x)),
        Value::Number(_) => into.push_str("null"),
        Value::Text(text) => write_text(text, into),
        Value::List(items) => {
            into.push('[');
            for (index, item) in items.iter().enumerate() {
                if index > 0 {
                    into.push(',');
                }
                write_value(item, into);
            }
            into.push(']');
        }
        Value::Record(fields) => {
            into.push('{');
            for (index, (name, value)) in fields.iter().enumerate() {
                if index > 0 {
                    into.push(',');
                }
                write_text(name, into);
                into.push(':');
                write_value(value, into);
            }
            into.push('}');
        }
    }
}

fn write_text(text: &str, into: &mut String) {
    into.push('"');
    for c in text.chars() {
        match c {
            '"' => into.push_str("\\\""),
            '\\' => into.push_str("\\\\"),
            '\u{8}' => into.push_str("\\b"),
            '\t' => into.push_str("\\t"),
            '\n' => into.push_str("\\n"),
            '\u{c}' => into.push_str("\\f"),
            '\r' => into.push_str("\\r"),
            c if c < ' ' => into.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => into.push(c),
        }
    }
    into.push('"');
}
