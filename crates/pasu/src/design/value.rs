//! Any JSON or JavaScript value, kept as it came, so that one reader can refuse what is wrong and say where.

use std::fmt;

use serde::de::{self, Deserialize, DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::number::plain;
use super::path::shortened;

/// An owned tree of plain data.
///
/// JSON text and JavaScript objects are both turned into this tree first. It keeps what a stricter type would lose or
/// refuse without a path: NaN, infinities, repeated keys.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
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
    /// What was found, for a message: `-3`, `"abc"`, `a list of 2`.
    pub fn described(&self) -> String {
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
            Value::Number(x) => match whole(*x) {
                Some(integer) => serializer.serialize_i64(integer),
                None => serializer.serialize_f64(*x),
            },
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

/// A whole number that both `f64` and `i64` hold exactly, so that text formats write `1` and not `1.0`.
fn whole(x: f64) -> Option<i64> {
    const EXACT: f64 = 9_007_199_254_740_992.0; // 2^53
    (x.abs() <= EXACT && x.floor() == x).then_some(x as i64)
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Nested { depth: 0 }.deserialize(deserializer)
    }
}

#[derive(Clone, Copy)]
struct Nested {
    depth: usize,
}

impl Nested {
    fn inner<E: de::Error>(self) -> Result<Nested, E> {
        if self.depth == DEEPEST {
            return Err(E::custom(format_args!("nested more than {DEEPEST} levels deep")));
        }
        Ok(Nested { depth: self.depth + 1 })
    }
}

impl<'de> DeserializeSeed<'de> for Nested {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Nested {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a text, a list or an object")
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
        self.deserialize(deserializer)
    }

    fn visit_newtype_struct<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        self.deserialize(deserializer)
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
    fn whole_numbers_are_written_without_a_point() {
        let text = serde_json::to_string(&read("[1.0, 0.5, -3, 1e300]")).unwrap();
        assert_eq!(text, "[1,0.5,-3,1e+300]");
    }

    #[test]
    fn nesting_has_a_bottom() {
        let deep = |n: usize| format!("{}{}", "[".repeat(n), "]".repeat(n));
        assert!(serde_json::from_str::<Value>(&deep(DEEPEST)).is_ok());
        let error = serde_json::from_str::<Value>(&deep(DEEPEST + 1)).unwrap_err();
        assert!(error.to_string().starts_with("nested more than 64 levels deep"));
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
