//! Any JSON or JavaScript value, kept as it came, so that what is wrong with it can be said with its place.
//!
//! `serde` reads types with a tag, `kind` and `order` here, from a tree of its own, which forgets where it came from; `serde_json::Value` knows neither NaN nor repeated
//! keys. Hence this one: text and JavaScript objects are both read into it, and the types of a document from it.

use std::cell::Cell;
use std::fmt;

use serde::de::{self, Deserialize, DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_path_to_error::{Segment, Track};

use super::limits::VALUES;
use super::number::{parse, plain};
use super::refusal::{inside_field, inside_item, shortened};

/// An owned tree of plain data.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    /// `null`, and JavaScript's `undefined`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// Any number, also one that is not finite.
    Number(f64),
    /// A string.
    Text(String),
    /// An array.
    List(Vec<Value>),
    /// An object: its fields in the order in which they came, repeated keys included.
    Record(Vec<(String, Value)>),
}

/// How deep a value may nest. A design nests nine deep; a JavaScript object that contains itself has no bottom.
pub(super) const DEEPEST: usize = 64;

impl Value {
    /// A number as a link has it. What is none stays a text: the reader refuses it and says where.
    pub(crate) fn spelled(text: &str) -> Value {
        let text = text.trim();
        parse(text).map_or_else(|| Value::Text(text.to_owned()), Value::Number)
    }

    /// Reads any plain data; where that fails, with the path of what could not be read.
    pub(super) fn read<'de, D: Deserializer<'de>>(source: D) -> Result<Value, (String, D::Error)> {
        let left = Cell::new(Some(VALUES));
        let mut track = Track::new();
        let value =
            Nested { depth: 0, left: &left }.deserialize(serde_path_to_error::Deserializer::new(source, &mut track));
        value.map_err(|error| {
            // Of a whole that is too large no part is to blame.
            if left.get().is_none() {
                return (String::new(), error);
            }
            let path = track.path().iter().rev().fold(String::new(), |path, segment| match segment {
                Segment::Seq { index } => inside_item(*index, &path),
                Segment::Map { key } => inside_field(key, &path),
                Segment::Enum { .. } | Segment::Unknown => path,
            });
            (path, error)
        })
    }

    /// What was found, for a message: `-3`, `"abc"`, `a list of 2`.
    pub(super) fn described(&self) -> String {
        match self {
            Value::Null => "nothing".into(),
            Value::Bool(b) => b.to_string(),
            Value::Number(x) => plain(*x),
            Value::Text(text) if text.is_empty() => "an empty text".into(),
            Value::Text(text) => format!("{:?}", shortened(text)),
            Value::List(items) if items.is_empty() => "an empty list".into(),
            Value::List(items) => format!("a list of {}", items.len()),
            Value::Record(_) => "a group of fields".into(),
        }
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::Null => serializer.serialize_unit(),
            Value::Bool(b) => serializer.serialize_bool(*b),
            Value::Number(x) => serializer.serialize_f64(*x),
            Value::Text(text) => serializer.serialize_str(text),
            Value::List(items) => serializer.collect_seq(items),
            Value::Record(fields) => {
                let mut map = serializer.serialize_map(Some(fields.len()))?;
                for (name, value) in fields {
                    map.serialize_entry(name, value)?;
                }
                map.end()
            }
        }
    }
}

/// Reads a value within the limits of depth and number.
#[derive(Clone, Copy)]
struct Nested<'a> {
    depth: usize,
    /// How many more values may come; none of them once the whole is too large or too deep.
    left: &'a Cell<Option<usize>>,
}

impl Nested<'_> {
    fn inner<E: de::Error>(self) -> Result<Self, E> {
        if self.depth == DEEPEST {
            self.left.set(None);
            return Err(E::invalid_length(DEEPEST + 1, &"at most 64 levels (what contains itself has no end)"));
        }
        Ok(Nested { depth: self.depth + 1, ..self })
    }
}

impl<'de> DeserializeSeed<'de> for Nested<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        self.left.set(self.left.get().and_then(|left| left.checked_sub(1)));
        match self.left.get() {
            None => Err(de::Error::invalid_length(VALUES + 1, &"at most 4194304 values in one design")),
            Some(_) => deserializer.deserialize_any(self),
        }
    }
}

impl<'de> Visitor<'de> for Nested<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("plain data (numbers, texts, lists and objects of them)")
    }

    fn visit_bool<E>(self, b: bool) -> Result<Value, E> {
        Ok(Value::Bool(b))
    }

    fn visit_i64<E>(self, x: i64) -> Result<Value, E> {
        Ok(Value::Number(x as f64))
    }

    fn visit_u64<E>(self, x: u64) -> Result<Value, E> {
        Ok(Value::Number(x as f64))
    }

    fn visit_f64<E>(self, x: f64) -> Result<Value, E> {
        Ok(Value::Number(x))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value::Text(text.to_owned()))
    }

    fn visit_string<E>(self, text: String) -> Result<Value, E> {
        Ok(Value::Text(text))
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_none<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }

    fn visit_newtype_struct<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Value, A::Error> {
        let inner = self.inner()?;
        let mut list = Vec::new();
        while let Some(item) = items.next_element_seed(inner)? {
            list.push(item);
        }
        Ok(Value::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        let inner = self.inner()?;
        let mut fields = Vec::new();
        while let Some(name) = entries.next_key::<String>()? {
            fields.push((name, entries.next_value_seed(inner)?));
        }
        Ok(Value::Record(fields))
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Nested { depth: 0, left: &Cell::new(Some(VALUES)) }.deserialize(deserializer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Value {
        serde_json::from_str(text).unwrap()
    }

    #[test]
    fn every_kind_of_json_is_kept() {
        assert_eq!(
            read(r#"{"a": [1, -2, 2.5, true, null, "x"], "a": 18446744073709551615}"#),
            Value::Record(vec![
                (
                    "a".into(),
                    Value::List(vec![
                        Value::Number(1.0),
                        Value::Number(-2.0),
                        Value::Number(2.5),
                        Value::Bool(true),
                        Value::Null,
                        Value::Text("x".into()),
                    ])
                ),
                ("a".into(), Value::Number(18446744073709551615.0)),
            ])
        );
    }

    #[test]
    fn nesting_and_number_have_an_end() {
        let deep = |n: usize| format!("{}{}", "[".repeat(n), "]".repeat(n));
        assert!(serde_json::from_str::<Value>(&deep(DEEPEST)).is_ok());
        let error = serde_json::from_str::<Value>(&deep(DEEPEST + 1)).unwrap_err();
        assert!(error.to_string().starts_with("invalid length 65, expected at most 64 levels"), "{error}");
        let many = |n: usize| format!("[{}0]", "0,".repeat(n - 2));
        assert!(serde_json::from_str::<Value>(&many(VALUES)).is_ok());
        assert!(serde_json::from_str::<Value>(&many(VALUES + 1)).is_err());
    }

    #[test]
    fn what_was_found_reads_well() {
        let found: Vec<String> = ["-3", "\"abc\"", "[1, 2]", "[]", "{}", "null", "true", "0.1"]
            .iter()
            .map(|text| read(text).described())
            .collect();
        assert_eq!(
            found,
            ["-3", "\"abc\"", "a list of 2", "an empty list", "a group of fields", "nothing", "true", "0.1"]
        );
        assert_eq!(Value::Number(f64::NAN).described(), "NaN");
        assert_eq!(Value::Number(f64::NEG_INFINITY).described(), "-Infinity");
    }
}
