//! Plain data as a program hands it over, which can hold what JSON cannot: NaN, infinities, nothing at all.

use pasu::{Design, Error, Result, Shape};
use serde::de::value::{MapDeserializer, SeqDeserializer};
use serde::de::{Deserializer, IntoDeserializer, Visitor};
use serde::forward_to_deserialize_any;

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Value>),
    Record(Vec<(String, Value)>),
}

impl Value {
    pub(crate) fn of_json(text: &str) -> Value {
        Value::of(&serde_json::from_str(text).expect("a test's value is JSON"))
    }

    fn of(value: &serde_json::Value) -> Value {
        match value {
            serde_json::Value::Null => Value::Null,
            serde_json::Value::Bool(b) => Value::Bool(*b),
            serde_json::Value::Number(x) => Value::Number(x.as_f64().expect("a number of JSON is finite")),
            serde_json::Value::String(text) => Value::Text(text.clone()),
            serde_json::Value::Array(items) => Value::List(items.iter().map(Value::of).collect()),
            serde_json::Value::Object(fields) => {
                Value::Record(fields.iter().map(|(name, value)| (name.clone(), Value::of(value))).collect())
            }
        }
    }

    pub(crate) fn design(&self) -> Result<Design> {
        Design::read(self)
    }

    /// A shape as it is given, from the text that `JSON.stringify` would make of it.
    pub(crate) fn shape(&self) -> Shape {
        Shape::parse(&self.json()).unwrap_or_else(|e| panic!("{e}"))
    }

    fn json(&self) -> String {
        match self {
            Value::Null => "null".into(),
            Value::Bool(b) => b.to_string(),
            Value::Number(x) => format!("{x:e}"),
            Value::Text(text) => serde_json::to_string(text).expect("a text is JSON"),
            Value::List(items) => format!("[{}]", items.iter().map(Value::json).collect::<Vec<_>>().join(",")),
            Value::Record(fields) => {
                let fields: Vec<_> = fields.iter().map(|(name, value)| format!("{name:?}:{}", value.json())).collect();
                format!("{{{}}}", fields.join(","))
            }
        }
    }
}

impl<'de> Deserializer<'de> for &Value {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        match self {
            Value::Null => visitor.visit_unit(),
            Value::Bool(b) => visitor.visit_bool(*b),
            Value::Number(x) => visitor.visit_f64(*x),
            Value::Text(text) => visitor.visit_str(text),
            Value::List(items) => visitor.visit_seq(SeqDeserializer::new(items.iter())),
            Value::Record(fields) => {
                visitor.visit_map(MapDeserializer::new(fields.iter().map(|(name, value)| (name.as_str(), value))))
            }
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

impl<'de> IntoDeserializer<'de, Error> for &Value {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}
