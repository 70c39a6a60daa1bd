//! Records made of numbers: one table of fields that reads, writes, rounds and describes them.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, Visitor};
use serde::ser::{SerializeStruct, Serializer};

use super::number::{rounded, shortest};
use super::quantity::{Range, Size, Written, read_into};
use super::value::Value;

/// One field of a record of numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Field {
    pub(crate) name: &'static str,
    pub(crate) size: Size,
    pub(crate) need: Need,
    pub(crate) range: Range,
    pub(crate) dimension: Dimension,
    /// What it means, in the lines of its doc comment.
    /// Compiled in only where the declarations are written: the texts would be a fair part of what a page loads.
    #[cfg(feature = "typescript")]
    pub(crate) about: &'static [&'static str],
}

/// What the numbers of a field measure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dimension {
    /// Nothing: a ratio, a weight, a direction.
    One,
    /// Lengths, in the unit of the design.
    Length,
    /// Waves round the axis.
    Waves,
    /// Radians.
    Angle,
}

/// Whether a document may leave the field out; it then has the value of [`Fields::START`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Need {
    Required,
    Optional,
}

/// A record all of whose fields are numbers or lists of numbers of fixed length.
///
/// `serde` reads and writes it by the table ([`read`], [`write`]) and not by a derive, which knows nothing of ranges and of what a link starts from.
pub(crate) trait Fields: Clone + PartialEq + Sized + 'static {
    /// The fields in the order of the format.
    const FIELDS: &'static [Field];
    /// Their names.
    const NAMES: &'static [&'static str];
    /// What a field has when a document may leave it out and does, and (for a family) what a link need not write.
    /// Frozen with version 1 of the format.
    const START: Self;

    /// The numbers of each field, in the order of [`Fields::FIELDS`].
    fn numbers(&self) -> Vec<&[f64]>;
    /// The same, to be changed.
    fn numbers_mut(&mut self) -> Vec<&mut [f64]>;

    /// The fields that differ from [`Fields::START`], as a link writes them: `r=1,.2,.1,.8`.
    fn link_fields(&self) -> Vec<String> {
        let start = Self::START;
        let fields = Self::FIELDS.iter().zip(self.numbers()).zip(start.numbers());
        let differing = fields.filter(|((_, numbers), start)| numbers != start);
        differing
            .map(|((field, numbers), _)| {
                let list: Vec<String> = numbers.iter().map(|x| shortest(*x)).collect();
                format!("{}={}", field.name, list.join(","))
            })
            .collect()
    }

    /// Every number to twelve significant digits.
    fn round(&mut self) {
        for numbers in self.numbers_mut() {
            for number in numbers {
                *number = rounded(*number);
            }
        }
    }
}

/// The fields of a document from the names and texts of a link: those given, and what a document may not leave out and a link may.
///
/// # Errors
/// None here: what is no number stays a text, which the reader of the document refuses and says where.
#[inline]
pub(crate) fn spelled<T: Fields>(given: &[(&str, &str)]) -> crate::error::Result<Vec<(String, Value)>> {
    let all = |size: Size, mut items: Vec<Value>| match size {
        Size::One => items.pop().unwrap_or(Value::Null),
        Size::List(_) => Value::List(items),
    };
    let mut fields = Vec::with_capacity(T::FIELDS.len());
    for (name, text) in given {
        let size = T::FIELDS.iter().find(|field| field.name == *name).map_or(Size::One, |field| field.size);
        let items = match size {
            Size::One => vec![Value::spelled(text)],
            Size::List(_) => text.split(',').map(Value::spelled).collect(),
        };
        fields.push(((*name).to_owned(), all(size, items)));
    }
    for (field, start) in T::FIELDS.iter().zip(T::START.numbers()) {
        if field.need == Need::Required && !given.iter().any(|(name, _)| *name == field.name) {
            fields.push((field.name.to_owned(), all(field.size, start.iter().copied().map(Value::Number).collect())));
        }
    }
    Ok(fields)
}

/// What [`read`] and [`write`] have to know of a record besides its numbers.
pub(crate) struct Table {
    pub(crate) record: &'static str,
    /// What it is, for a message.
    pub(crate) what: &'static str,
    pub(crate) names: &'static [&'static str],
    pub(crate) fields: &'static [Field],
}

/// Reads the fields into the places of their numbers. What is left out and may be stays as it is.
pub(crate) fn read<'de, D: Deserializer<'de>>(
    deserializer: D,
    table: &Table,
    places: Vec<&mut [f64]>,
) -> Result<(), D::Error> {
    deserializer.deserialize_struct(table.record, table.names, Places { table, places })
}

/// Writes the fields of the canonical document: without those that may be left out and have their default.
pub(crate) fn write<S: Serializer>(
    serializer: S,
    table: &Table,
    numbers: &[&[f64]],
    start: &[&[f64]],
) -> Result<S::Ok, S::Error> {
    let fields = || table.fields.iter().zip(numbers).zip(start);
    let written = || fields().filter(|((field, numbers), start)| field.need == Need::Required || numbers != start);
    let mut record = serializer.serialize_struct(table.record, written().count())?;
    for ((field, numbers), _) in written() {
        record.serialize_field(field.name, &Written(field.size, numbers))?;
    }
    record.end()
}

struct Places<'a, 'b> {
    table: &'a Table,
    places: Vec<&'b mut [f64]>,
}

impl<'de> Visitor<'de> for Places<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.table.what)
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut given: A) -> Result<(), A::Error> {
        let fields = self.table.fields;
        let mut is_given = vec![false; fields.len()];
        while let Some(index) = given.next_key_seed(Index(self.table))? {
            if std::mem::replace(&mut is_given[index], true) {
                return Err(A::Error::duplicate_field(fields[index].name));
            }
            given.next_value_seed(Place { field: &fields[index], numbers: self.places[index] })?;
        }
        match fields.iter().zip(is_given).find(|(field, is_given)| field.need == Need::Required && !is_given) {
            Some((field, _)) => Err(A::Error::missing_field(field.name)),
            None => Ok(()),
        }
    }
}

/// Reads the name of a field as its index.
struct Index<'a>(&'a Table);

impl<'de> DeserializeSeed<'de> for Index<'_> {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<usize, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Index<'_> {
    type Value = usize;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a field")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<usize, E> {
        let index = self.0.names.iter().position(|known| *known == name);
        index.ok_or_else(|| E::unknown_field(name, self.0.names))
    }
}

/// Reads one field.
struct Place<'a> {
    field: &'static Field,
    numbers: &'a mut [f64],
}

impl<'de> DeserializeSeed<'de> for Place<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        match self.field.need {
            Need::Required => self.visit_some(deserializer),
            Need::Optional => deserializer.deserialize_option(self),
        }
    }
}

impl<'de> Visitor<'de> for Place<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.field.size.words())
    }

    fn visit_none<E>(self) -> Result<(), E> {
        Ok(())
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        Ok(())
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        read_into(deserializer, self.field.size, self.field.range, self.numbers)
    }
}

/// Declares a struct of numbers together with its table of fields, so that the two cannot disagree.
///
/// After its name stands what it is, for a message. A field reads `name: type = start, Need, Range, Dimension;`. The document knows it by the same name.
macro_rules! fields {
    (
        $(#[$about:meta])*
        pub struct $record:ident, $what:literal {
            $( $(#[doc = $doc:literal])+ $field:ident: $type:ty = $start:expr, $need:ident, $range:ident, $dimension:ident; )+
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[non_exhaustive]
        #[allow(non_snake_case, reason = "quantities are named as in the papers")]
        pub struct $record {
            $( $(#[doc = $doc])+ pub $field: $type, )+
        }

        impl $crate::design::fields::Fields for $record {
            const FIELDS: &'static [$crate::design::fields::Field] = &[
                $( $crate::design::fields::Field {
                    name: stringify!($field),
                    size: <$type as $crate::design::quantity::Quantity>::SIZE,
                    need: $crate::design::fields::Need::$need,
                    range: $crate::design::quantity::Range::$range,
                    dimension: $crate::design::fields::Dimension::$dimension,
                    #[cfg(feature = "typescript")]
                    about: &[$($doc),+],
                }, )+
            ];
            const NAMES: &'static [&'static str] = &[$( stringify!($field) ),+];
            const START: Self = $record { $( $field: $start, )+ };

            fn numbers(&self) -> Vec<&[f64]> {
                vec![$( $crate::design::quantity::Quantity::as_numbers(&self.$field), )+]
            }

            fn numbers_mut(&mut self) -> Vec<&mut [f64]> {
                vec![$( $crate::design::quantity::Quantity::as_numbers_mut(&mut self.$field), )+]
            }
        }

        impl $record {
            const TABLE: $crate::design::fields::Table = $crate::design::fields::Table {
                record: stringify!($record),
                what: $what,
                names: <Self as $crate::design::fields::Fields>::NAMES,
                fields: <Self as $crate::design::fields::Fields>::FIELDS,
            };
        }

        impl<'de> serde::Deserialize<'de> for $record {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> ::std::result::Result<Self, D::Error> {
                use $crate::design::fields::{Fields, read};
                let mut record = Self::START;
                read(deserializer, &Self::TABLE, record.numbers_mut())?;
                Ok(record)
            }
        }

        impl serde::Serialize for $record {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> ::std::result::Result<S::Ok, S::Error> {
                use $crate::design::fields::{Fields, write};
                write(serializer, &Self::TABLE, &self.numbers(), &Self::START.numbers())
            }
        }
    };
}
pub(crate) use fields;
