//! What `serde` has to say of a document, in words that a potter understands, and where.

use std::fmt::Display;

use serde::de::{self, Expected, Unexpected};

use super::number::plain;
use super::quantity::Range;
use crate::error::{Code, Error};

/// Kinds of shapes that a build without the feature `patchwork` leaves out.
const LEFT_OUT: &[&str] = if cfg!(feature = "patchwork") { &[] } else { &["vertex-frame", "blend", "octant"] };

/// By which a list of words is known to be that of all kinds of shapes: no other has this one.
const KIND: &str = "boundary-value";

/// Every refusal that a type can make while it is read: what was expected, and what was found in its place. The path begins where the error was made; what reads a
/// list or a group of fields puts its own part before it (`Error::inside_field`, `Error::inside_item`).
impl de::Error for Error {
    fn custom<T: Display>(message: T) -> Self {
        Error::new(Code::WrongType, "", message.to_string())
    }

    fn invalid_type(found: Unexpected, expected: &dyn Expected) -> Self {
        let code = match found {
            Unexpected::Unit | Unexpected::Option => Code::MissingField,
            _ => Code::WrongType,
        };
        with_found(refused(code, &expected, &described(found)), found)
    }

    fn invalid_value(found: Unexpected, expected: &dyn Expected) -> Self {
        let code = match found {
            Unexpected::Float(x) if !x.is_finite() => Code::NotFinite,
            _ => Code::OutOfRange,
        };
        let error = with_found(refused(code, &expected, &described(found)), found);
        let bounds = Range::told(&expected.to_string()).map_or(&[][..], Range::arguments);
        bounds.iter().fold(error, |error, (name, bound)| error.with(name, *bound))
    }

    fn invalid_length(found: usize, expected: &dyn Expected) -> Self {
        // "at most 500 parts", where another number, as of coordinates, is another type.
        let words = expected.to_string();
        let Some(most) = words.strip_prefix("at most ") else {
            return refused(Code::WrongType, &expected, &found).with("found", found);
        };
        let error = refused(Code::TooLarge, &expected, &found).with("found", found);
        // Not as a double: reading these takes 15 kB of every module.
        match most.split(' ').next().and_then(|most| most.parse::<usize>().ok()) {
            Some(most) => error.with("greatest", most),
            None => error,
        }
    }

    fn unknown_variant(found: &str, known: &'static [&'static str]) -> Self {
        unknown_name(found, known)
    }

    fn unknown_field(found: &str, known: &'static [&'static str]) -> Self {
        unknown_field(found, None, known)
    }

    fn missing_field(name: &'static str) -> Self {
        Error::new(Code::MissingField, name, "expected a value, found nothing")
    }

    fn duplicate_field(name: &'static str) -> Self {
        Error::new(Code::Duplicate, name, "this field is given twice; expected it once")
    }
}

impl Error {
    /// The same error, in a field of what is being read.
    pub(crate) fn inside_field(self, name: &str) -> Error {
        let path = inside_field(name, self.path());
        self.at(path)
    }

    /// The same error, in an item of what is being read.
    pub(crate) fn inside_item(self, index: usize) -> Error {
        let path = inside_item(index, self.path());
        self.at(path)
    }
}

/// `expected a number greater than 0, found -3`.
pub(super) fn refused(code: Code, expected: &dyn Display, found: &dyn Display) -> Error {
    let expected = expected.to_string();
    // The words of serde's own types.
    let expected = match expected.as_str() {
        "f64" => "a number",
        "a string" => "a text",
        "a sequence" => "a list",
        words => words,
    };
    Error::new(code, "", format!("expected {expected}, found {found}"))
}

fn with_found(error: Error, found: Unexpected) -> Error {
    match found {
        Unexpected::Float(x) => error.with("found", x),
        Unexpected::Str(text) => error.with("found", text),
        _ => error,
    }
}

fn described(found: Unexpected) -> String {
    match found {
        Unexpected::Unit | Unexpected::Option => "nothing".into(),
        Unexpected::Bool(b) => b.to_string(),
        Unexpected::Unsigned(x) => x.to_string(),
        Unexpected::Signed(x) => x.to_string(),
        Unexpected::Float(x) => plain(x),
        Unexpected::Str("") => "an empty text".into(),
        Unexpected::Str(text) => format!("{:?}", shortened(text)),
        Unexpected::Seq => "a list".into(),
        Unexpected::Map => "a group of fields".into(),
        other => other.to_string(),
    }
}

/// A word that is none of those that may stand here.
pub(crate) fn unknown_name(found: &str, known: &[&str]) -> Error {
    // Whoever is told what kinds there are can have the whole.
    let left_out = if known.contains(&KIND) { LEFT_OUT } else { &[] };
    let all: Vec<&str> = known.iter().chain(left_out).copied().collect();
    let known = all.as_slice();
    let expected = alternatives(known);
    if LEFT_OUT.contains(&found) {
        let message =
            format!("the shape {found:?} is left out of this build, which draws pots: it takes the whole library");
        return Error::new(Code::UnsupportedShape, "", message).with("what", "left-out").with("found", found);
    }
    let error = match are_numerals(known) {
        true => refused(Code::OutOfRange, &expected, &found),
        false => refused(Code::UnknownName, &expected, &described(Unexpected::Str(found))),
    };
    error.with("words", known).with("found", found)
}

/// A field that is none of those that may stand here; `tag` is read before the others and comes before them.
pub(super) fn unknown_field(found: &str, tag: Option<&str>, known: &[&str]) -> Error {
    let known: Vec<&str> = tag.iter().chain(known).copied().collect();
    let message = format!("unknown field {:?}; expected one of {}", shortened(found), known.join(", "));
    Error::new(Code::UnknownField, inside_field(found, ""), message)
        .with("words", known.as_slice())
        .with("found", found)
}

/// `"mm", "cm" or "in"`; `2 or 4`, where names are numerals and a document gives numbers.
pub(super) fn alternatives(names: &[&str]) -> String {
    let mut words = String::new();
    for (index, name) in names.iter().enumerate() {
        let before = match index {
            0 => "",
            _ if index + 1 == names.len() => " or ",
            _ => ", ",
        };
        words.push_str(before);
        words.push_str(&if are_numerals(names) { (*name).to_owned() } else { format!("{name:?}") });
    }
    words
}

/// Whether a document gives a number in place of these names.
pub(super) fn are_numerals(names: &[&str]) -> bool {
    names.iter().all(|name| name.bytes().all(|byte| byte.is_ascii_digit()))
}

/// The path of something in a field: `shape` before `s[0]` is `shape.s[0]`.
pub(super) fn inside_field(name: &str, rest: &str) -> String {
    let dot = if rest.is_empty() || rest.starts_with('[') { "" } else { "." };
    let is_word = (1..=40).contains(&name.len()) && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    match is_word {
        true => format!("{name}{dot}{rest}"),
        // A field that no design has; its name came from outside and may be anything.
        false => format!("[{:?}]{dot}{rest}", shortened(name)),
    }
}

/// The path of something in an item of a list.
pub(super) fn inside_item(index: usize, rest: &str) -> String {
    let dot = if rest.is_empty() || rest.starts_with('[') { "" } else { "." };
    format!("[{index}]{dot}{rest}")
}

/// Foreign text short enough to stand inside a message.
pub(crate) fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_read_like_code() {
        let error = |name: &str| Error::new(Code::OutOfRange, "", "no").inside_item(0).inside_field(name);
        let path =
            |name: &str| error(name).inside_field("shape").inside_item(2).inside_field("parts").path().to_owned();
        assert_eq!(path("s"), "parts[2].shape.s[0]");
        assert_eq!(path("a b"), "parts[2].shape[\"a b\"][0]");
        assert_eq!(error("a b").inside_field("x").path(), "x[\"a b\"][0]");
        assert!(error(&"x".repeat(1000)).path().len() < 60);
    }
}
