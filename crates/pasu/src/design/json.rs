//! JSON text in and out.

use super::json_reader;
use super::limits::BYTES;
use super::number::plain;
use super::value::Value;
use crate::error::{Code, Error, Result};

/// Reads JSON text, whose faults are told by their place.
pub(crate) fn read(text: &str) -> Result<Value> {
    if text.len() > BYTES {
        let message = format!("expected a design of at most {BYTES} bytes of JSON, found {}", text.len());
        return Err(Error::new(Code::TooLarge, "", message));
    }
    // Some editors put a byte order mark at the start of a file.
    json_reader::read(text.strip_prefix('\u{feff}').unwrap_or(text))
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
