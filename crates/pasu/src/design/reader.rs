//! Reading values strictly: every refusal says where, what was found and what was expected.

use super::limits::CHARACTERS;
use super::path::{Path, shortened};
use super::value::Value;
use crate::error::{Code, Error, Result};

/// The range of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Range {
    Any,
    NotZero,
    Positive,
    NotNegative,
}

impl Range {
    fn contains(self, x: f64) -> bool {
        match self {
            Range::Any => true,
            Range::NotZero => x != 0.0,
            Range::Positive => x > 0.0,
            Range::NotNegative => x >= 0.0,
        }
    }

    /// "a number", with the range.
    fn words(self) -> &'static str {
        match self {
            Range::Any => "a number",
            Range::NotZero => "a number other than 0",
            Range::Positive => "a number greater than 0",
            Range::NotNegative => "0 or a number greater than 0",
        }
    }
}

/// The fields of an object, each known and given at most once.
#[derive(Clone, Copy)]
pub(crate) struct Record<'a> {
    fields: &'a [(String, Value)],
    pub(crate) path: Path<'a>,
}

impl<'a> Record<'a> {
    /// An object whose fields have yet to be compared with what the format knows ([`Record::only`]).
    #[inline(never)]
    pub(crate) fn open(value: &'a Value, path: Path<'a>, what: &str) -> Result<Self> {
        match value {
            Value::Record(fields) => Ok(Record { fields, path }),
            _ => Err(wrong_type(value, &path, what)),
        }
    }

    /// Refuses repeated fields and fields not among `known`.
    #[inline(never)]
    pub(crate) fn only(self, known: &[&str]) -> Result<Self> {
        for (index, (name, value)) in self.fields.iter().enumerate() {
            let path = self.path.field(name);
            if !known.contains(&name.as_str()) {
                // A JavaScript field that is there and undefined is not there.
                if *value == Value::Null {
                    continue;
                }
                let message = format!("unknown field {:?}; expected one of {}", shortened(name), known.join(", "));
                return Err(path.error(Code::UnknownField, message));
            }
            if self.fields[..index].iter().any(|(earlier, _)| earlier == name) {
                return Err(path.error(Code::Duplicate, "this field is given twice; expected it once"));
            }
        }
        Ok(self)
    }

    /// The value of a field; `None` when it is absent, null or undefined.
    #[inline(never)]
    pub(crate) fn get(&self, name: &str) -> Option<&'a Value> {
        self.fields.iter().find(|(field, _)| field == name).map(|(_, value)| value).filter(|v| **v != Value::Null)
    }

    /// The value of a field that must be there.
    #[inline(never)]
    pub(crate) fn require(&self, name: &str, expected: &str) -> Result<&'a Value> {
        self.get(name).ok_or_else(|| {
            self.path.field(name).error(Code::MissingField, format!("expected {expected}, found nothing"))
        })
    }
}

/// A finite number within its range.
#[inline(never)]
pub(crate) fn number(value: &Value, path: &Path, range: Range) -> Result<f64> {
    match *value {
        Value::Number(x) if !x.is_finite() => {
            Err(path.error(Code::NotFinite, format!("expected {}, found {}", range.words(), value.described())))
        }
        Value::Number(x) if !range.contains(x) => {
            Err(path.error(Code::OutOfRange, format!("expected {}, found {}", range.words(), value.described())))
        }
        Value::Number(x) => Ok(x),
        _ => Err(wrong_type(value, path, range.words())),
    }
}

/// Exactly as many numbers as there are places in `into`.
#[inline(never)]
pub(crate) fn numbers(value: &Value, path: &Path, range: Range, into: &mut [f64]) -> Result<()> {
    let expected = format!("a list of {} numbers", into.len());
    let items = list(value, path, &expected)?;
    if items.len() != into.len() {
        return Err(path.error(Code::WrongType, format!("expected {expected}, found {}", value.described())));
    }
    for (index, (item, place)) in items.iter().zip(into).enumerate() {
        *place = number(item, &path.item(index), range)?;
    }
    Ok(())
}

/// A whole number from 0 to `u32::MAX`.
#[inline(never)]
pub(crate) fn whole(value: &Value, path: &Path) -> Result<u32> {
    const EXPECTED: &str = "a whole number, 0 or greater";
    match *value {
        Value::Number(x) if !x.is_finite() => {
            Err(path.error(Code::NotFinite, format!("expected {EXPECTED}, found {}", value.described())))
        }
        Value::Number(x) if x.floor() == x && (0.0..=f64::from(u32::MAX)).contains(&x) => Ok(x as u32),
        Value::Number(_) => {
            Err(path.error(Code::OutOfRange, format!("expected {EXPECTED}, found {}", value.described())))
        }
        _ => Err(wrong_type(value, path, EXPECTED)),
    }
}

/// An array of any length.
#[inline(never)]
pub(crate) fn list<'a>(value: &'a Value, path: &Path, expected: &str) -> Result<&'a [Value]> {
    match value {
        Value::List(items) => Ok(items),
        _ => Err(wrong_type(value, path, expected)),
    }
}

/// A title or a name: plain text, one line. An empty one is none.
#[inline(never)]
pub(crate) fn label(value: &Value, path: &Path) -> Result<Option<String>> {
    let text = text(value, path, "a text")?;
    let count = text.chars().count();
    if count > CHARACTERS {
        let message = format!("expected at most {CHARACTERS} characters, found {count}");
        return Err(path.error(Code::TooLarge, message));
    }
    if let Some(c) = text.chars().find(|c| c.is_control()) {
        let message = format!("expected plain text on one line, found the control character U+{:04X}", u32::from(c));
        return Err(path.error(Code::OutOfRange, message));
    }
    Ok((!text.is_empty()).then(|| text.to_owned()))
}

/// A string.
#[inline(never)]
pub(crate) fn text<'a>(value: &'a Value, path: &Path, expected: &str) -> Result<&'a str> {
    match value {
        Value::Text(text) => Ok(text),
        _ => Err(wrong_type(value, path, expected)),
    }
}

/// One of a closed set of names, by its index.
#[inline(never)]
pub(crate) fn name(value: &Value, path: &Path, names: &[&str]) -> Result<usize> {
    let expected = alternatives(names);
    let found = text(value, path, &expected)?;
    names
        .iter()
        .position(|known| *known == found)
        .ok_or_else(|| path.error(Code::UnknownName, format!("expected {expected}, found {}", value.described())))
}

/// `"mm", "cm" or "in"`.
pub(crate) fn alternatives(names: &[&str]) -> String {
    let mut words = String::new();
    for (index, name) in names.iter().enumerate() {
        let before = match index {
            0 => "",
            _ if index + 1 == names.len() => " or ",
            _ => ", ",
        };
        words.push_str(before);
        words.push_str(&format!("{name:?}"));
    }
    words
}

/// Refuses a tree with a null in it.
pub(crate) fn without_null(value: &Value, path: &Path) -> Result<()> {
    match value {
        Value::Null => Err(path.error(Code::WrongType, "expected a value, found null")),
        Value::List(items) => items.iter().enumerate().try_for_each(|(i, item)| without_null(item, &path.item(i))),
        Value::Record(fields) => fields.iter().try_for_each(|(name, value)| without_null(value, &path.field(name))),
        Value::Bool(_) | Value::Number(_) | Value::Text(_) => Ok(()),
    }
}

/// A value of another type than the format has at this place.
#[inline(never)]
pub(crate) fn wrong_type(value: &Value, path: &Path, expected: &str) -> Error {
    path.error(Code::WrongType, format!("expected {expected}, found {}", value.described()))
}
