//! JSON text in and out.

use std::io;

use serde::Serialize;
use serde_json::error::Category;
use serde_json::ser::Formatter;

use super::limits::{BYTES, VALUES};
use super::number::plain;
use super::value::{DEEPEST, Value};
use crate::error::{Code, Error, Result};

/// Reads JSON text, whose faults are told by their place.
#[inline]
pub(crate) fn read(text: &str) -> Result<Value> {
    if text.len() > BYTES {
        let message = format!("expected a design of at most {BYTES} bytes of JSON, found {}", text.len());
        let error = Error::new(Code::TooLarge, "", message);
        return Err(error.with("greatest", BYTES as f64).with("found", text.len() as f64));
    }
    let mut reader = serde_json::Deserializer::from_str(text);
    let value = Value::read(&mut reader).map_err(|(path, error)| fault(text, &error).at(path))?;
    match reader.end() {
        Ok(()) => Ok(value),
        Err(error) => Err(fault(text, &error)),
    }
}

fn fault(text: &str, error: &serde_json::Error) -> Error {
    let line = error.line();
    // Counted in characters, as an editor does, and not in bytes.
    let given = text.split('\n').nth(line.saturating_sub(1)).unwrap_or_default();
    let column = given.char_indices().take_while(|(at, _)| *at < error.column()).count();
    let said = error.to_string();
    let what = said.strip_suffix(&format!(" at line {line} column {}", error.column())).unwrap_or(&said);
    match error.classify() {
        Category::Eof => {
            let message =
                format!("This JSON text ends in the middle, at line {line}, column {column}; is it cut short?");
            Error::new(Code::NotJson, "", message)
        }
        Category::Data if what.starts_with(&format!("invalid length {}", VALUES + 1)) => {
            let message = format!("expected a design of at most {VALUES} values, found more");
            Error::new(Code::TooLarge, "", message).with("greatest", VALUES)
        }
        // The other refusal of the tree that text can meet.
        Category::Data => {
            let message =
                format!("This is not JSON: nested more than {DEEPEST} levels deep at line {line}, column {column}.");
            Error::new(Code::NotJson, "", message)
        }
        _ if what == "number out of range" => {
            Error::new(Code::NotFinite, "", "expected a number, found one too large to be computed with")
        }
        _ => Error::new(Code::NotJson, "", format!("This is not JSON: {what} at line {line}, column {column}.")),
    }
}

/// Writes on one line, exactly as JavaScript's `JSON.stringify` would, so that a document saved by a page and one written by this crate are equal.
pub(crate) fn write(document: &(impl Serialize + ?Sized)) -> String {
    String::from_utf8(written(document, Numbers::Written)).unwrap_or_default()
}

/// How many bytes [`write`] makes at most: numbers are not written for it, which is most of the work, but counted as the longest that there are.
pub(crate) fn longest(document: &(impl Serialize + ?Sized)) -> usize {
    written(document, Numbers::Counted).len()
}

fn written(document: &(impl Serialize + ?Sized), numbers: Numbers) -> Vec<u8> {
    let mut text = Vec::new();
    let written = document.serialize(&mut serde_json::Serializer::with_formatter(&mut text, numbers));
    // Memory takes every byte, and no type of ours refuses to be written.
    debug_assert!(written.is_ok(), "{written:?}");
    text
}

/// What becomes of numbers.
enum Numbers {
    Written,
    Counted,
}

/// As long as a number can be: `-0.0000012345678901234567`.
const LONGEST: [u8; 25] = [b'0'; 25];

impl Formatter for Numbers {
    fn write_f64<W: io::Write + ?Sized>(&mut self, writer: &mut W, x: f64) -> io::Result<()> {
        match self {
            Numbers::Written => writer.write_all(plain(x).as_bytes()),
            Numbers::Counted => writer.write_all(&LONGEST),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_document_is_longer_than_is_counted() {
        let numbers = [0.0, -1.2345678901234567e-6, f64::MIN, -f64::MIN_POSITIVE, -123456789012345680000.0, 0.1];
        for x in numbers {
            assert!(write(&[x]).len() <= longest(&[x]), "{x}");
        }
        assert_eq!(write(&[-1.2345678901234567e-6]).len(), longest(&[1.0]));
        let text = ["\u{1}\"\\ü", "𝄞"];
        assert_eq!(write(&text).len(), longest(&text));
    }
}
