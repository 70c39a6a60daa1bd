//! Types of a document from a tree of plain data: strictly, and every refusal says where.

use serde::de::value::{BorrowedStrDeserializer, StrDeserializer};
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Expected, IgnoredAny, MapAccess, SeqAccess, VariantAccess, Visitor,
};
use serde::{Deserialize, forward_to_deserialize_any};

use super::number::plain;
use super::refusal::{alternatives, are_numerals, inside_field, refused, unknown_field};
use super::value::Value;
use crate::error::{Code, Error, Result};

/// The fields that say which of several groups of fields this is. A type that is told by one is an enum with its name.
const TAGS: [&str; 3] = ["kind", "order", "form"];

/// Reads a type from a tree.
pub(crate) fn read<'de, T: Deserialize<'de>>(value: &'de Value) -> Result<T> {
    T::deserialize(Source { value, is_field: false, tag: None })
}

/// Reads options, or whatever else is plain data, as strictly as a design: fields that `T` does not have are refused, what is null is not there, and every refusal
/// names path, value and expectation.
///
/// ```
/// use pasu::Error;
/// use serde::de::value::MapDeserializer;
///
/// #[derive(serde::Deserialize)]
/// struct Options {
///     tolerance: Option<f64>,
/// }
///
/// let given = MapDeserializer::<_, Error>::new([("tolerance", "fine")].into_iter());
/// let error = pasu::read::<Options, _>(given).err().unwrap();
/// assert_eq!(error.to_string(), "tolerance: expected a number, found \"fine\"");
/// ```
///
/// # Errors
/// What `T` and the source refuse.
pub fn read_from<'de, T: for<'a> Deserialize<'a>, D: Deserializer<'de, Error = Error>>(source: D) -> Result<T> {
    read(&buffered(source)?)
}

/// The tree of any plain data whose reader refuses with our error.
pub(crate) fn buffered<'de, D: Deserializer<'de, Error = Error>>(source: D) -> Result<Value> {
    Value::read(source).map_err(|(path, error)| error.at(path))
}

/// A value to be read.
///
/// A group of fields is read as a struct of which every field is given: one that is absent, null or undefined as nothing. So the type that is missing says what was
/// expected, and what may be left out is read as an option. Fields that the struct does not have are refused, and repeated ones.
#[derive(Clone, Copy)]
struct Source<'de> {
    value: &'de Value,
    /// Whether it is a field, which is missing when it is null; in a list null is of the wrong type.
    is_field: bool,
    /// A field that has been read already.
    tag: Option<&'static str>,
}

impl Source<'_> {
    fn wrong_type(&self, expected: &dyn Expected) -> Error {
        let is_missing = self.is_field && matches!(self.value, Value::Null);
        let code = if is_missing { Code::MissingField } else { Code::WrongType };
        let error = refused(code, &expected, &self.value.described());
        match self.value {
            Value::Number(found) => error.with("found", *found),
            Value::Text(found) => error.with("found", found.as_str()),
            _ => error,
        }
    }
}

impl<'de> Deserializer<'de> for Source<'de> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        match self.value {
            Value::Null => visitor.visit_unit(),
            Value::Bool(b) => visitor.visit_bool(*b),
            Value::Number(x) => visitor.visit_f64(*x),
            Value::Text(text) => visitor.visit_borrowed_str(text),
            Value::List(items) => visitor.visit_seq(Items { items, index: 0 }),
            Value::Record(given) => {
                let fields = given.iter().map(|(name, value)| (name.as_str(), value)).collect::<Vec<_>>();
                visitor.visit_map(Fields { fields: fields.into_iter(), next: None })
            }
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        match self.value {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        match self.value {
            Value::Number(x) => visitor.visit_f64(*x),
            _ => Err(self.wrong_type(&visitor)),
        }
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        match self.value {
            Value::Text(text) => visitor.visit_borrowed_str(text),
            _ => Err(self.wrong_type(&visitor)),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        match self.value {
            Value::List(items) => visitor.visit_seq(Items { items, index: 0 }),
            _ => Err(self.wrong_type(&visitor)),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        names: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value> {
        match self.value {
            Value::Record(given) => visitor.visit_map(Fields::of(given, self.tag, names)?),
            _ => Err(self.wrong_type(&visitor)),
        }
    }

    /// A name, or a group of fields told by its tag, which is the name of the enum.
    fn deserialize_enum<V: Visitor<'de>>(
        self,
        name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value> {
        let expected = alternatives(variants);
        let expected = expected.as_str();
        if !TAGS.contains(&name) {
            let Value::Text(text) = self.value else { return Err(self.wrong_type(&expected)) };
            return visitor.visit_enum(BorrowedStrDeserializer::new(text));
        }
        let Value::Record(given) = self.value else { return Err(self.wrong_type(&visitor)) };
        let tag = given.iter().find(|(field, _)| field == name).map_or(NOTHING, |(_, value)| value);
        let variant = match tag {
            Value::Text(text) if !are_numerals(variants) => text.clone(),
            Value::Number(x) if are_numerals(variants) && x.is_finite() => plain(*x),
            Value::Number(x) if !x.is_finite() => {
                return Err(refused(Code::NotFinite, &"a number", &plain(*x)).inside_field(name));
            }
            _ => return Err(Source { value: tag, is_field: true, tag: None }.wrong_type(&expected).inside_field(name)),
        };
        visitor.visit_enum(Tagged { variant, content: Source { tag: Some(name), ..self }, tag: name })
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        self.deserialize_str(visitor)
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 char bytes byte_buf unit unit_struct tuple tuple_struct map identifier ignored_any
    }
}

/// What stands where nothing is given.
const NOTHING: &Value = &Value::Null;

struct Items<'de> {
    items: &'de [Value],
    index: usize,
}

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>> {
        let Some(value) = self.items.get(self.index) else { return Ok(None) };
        let item = seed.deserialize(Source { value, is_field: false, tag: None });
        let item = item.map_err(|error| error.inside_item(self.index))?;
        self.index += 1;
        Ok(Some(item))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len() - self.index)
    }
}

struct Fields<'de> {
    fields: std::vec::IntoIter<(&'de str, &'de Value)>,
    next: Option<(&'de str, &'de Value)>,
}

impl<'de> Fields<'de> {
    /// All of these names, with their values.
    fn of(given: &'de [(String, Value)], tag: Option<&'static str>, names: &'static [&'static str]) -> Result<Self> {
        let mut fields: Vec<(&str, Option<&Value>)> = tag.iter().chain(names).map(|name| (*name, None)).collect();
        for (name, value) in given {
            match fields.iter_mut().find(|(known, _)| known == name) {
                Some((_, place @ None)) => *place = Some(value),
                Some(_) => {
                    let message = "this field is given twice; expected it once";
                    return Err(Error::new(Code::Duplicate, inside_field(name, ""), message));
                }
                // A JavaScript field that is there and undefined is not there.
                None if matches!(value, Value::Null) => {}
                None => return Err(unknown_field(name, tag, names)),
            }
        }
        fields.drain(..usize::from(tag.is_some()));
        let fields: Vec<_> = fields.into_iter().map(|(name, value)| (name, value.unwrap_or(NOTHING))).collect();
        Ok(Fields { fields: fields.into_iter(), next: None })
    }
}

impl<'de> MapAccess<'de> for Fields<'de> {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>> {
        self.next = self.fields.next();
        self.next.map(|(name, _)| seed.deserialize(BorrowedStrDeserializer::new(name))).transpose()
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value> {
        let (name, value) = self.next.unwrap_or(("", NOTHING));
        seed.deserialize(Source { value, is_field: true, tag: None }).map_err(|error| error.inside_field(name))
    }
}

/// A group of fields one of which says what the others are.
struct Tagged<'de> {
    variant: String,
    content: Source<'de>,
    tag: &'static str,
}

impl<'de> EnumAccess<'de> for Tagged<'de> {
    type Error = Error;
    type Variant = Source<'de>;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Source<'de>)> {
        let variant = seed.deserialize(StrDeserializer::new(&self.variant));
        Ok((variant.map_err(|error: Error| error.inside_field(self.tag))?, self.content))
    }
}

/// What is told by a tag is the group of fields that the tag stands in.
impl<'de> VariantAccess<'de> for Source<'de> {
    type Error = Error;

    fn unit_variant(self) -> Result<()> {
        self.deserialize_struct("", &[], IgnoredAny).map(|_| ())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value> {
        Err(self.wrong_type(&visitor))
    }

    fn struct_variant<V: Visitor<'de>>(self, names: &'static [&'static str], visitor: V) -> Result<V::Value> {
        self.deserialize_struct("", names, visitor)
    }
}
