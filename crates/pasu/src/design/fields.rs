//! Records made of numbers: one table of fields that reads, writes, rounds and describes them.

use super::number::{rounded, shortest};
use super::path::Path;
use super::reader::{self, Range, Record};
use super::value::Value;
use crate::error::Result;

/// One field of a record of numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Field {
    pub(crate) name: &'static str,
    pub(crate) size: Size,
    pub(crate) need: Need,
    pub(crate) range: Range,
    /// What it means, in the lines of its doc comment.
    /// Compiled in only where the declarations are written: the texts would be a fair part of what a page loads.
    #[cfg(feature = "typescript")]
    pub(crate) about: &'static [&'static str],
}

/// One number, or a list of so many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Size {
    One,
    List(usize),
}

/// Whether a document may leave the field out; it then has the value of [`Fields::START`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Need {
    Required,
    Optional,
}

/// A record all of whose fields are numbers or lists of numbers of fixed length.
pub(crate) trait Fields: Clone + PartialEq + Sized + 'static {
    /// The fields in the order of the format.
    const FIELDS: &'static [Field];
    /// What a field has when a document may leave it out and does, and (for a family) what a link need not write.
    /// Frozen with version 1 of the format.
    const START: Self;

    /// The numbers of each field, in the order of [`Fields::FIELDS`].
    fn numbers(&self) -> Vec<&[f64]>;
    /// The same, to be changed.
    fn numbers_mut(&mut self) -> Vec<&mut [f64]>;

    /// Reads the fields from an object that may have others as well.
    fn read(record: &Record) -> Result<Self> {
        let mut read = Self::START;
        for (field, numbers) in Self::FIELDS.iter().zip(read.numbers_mut()) {
            let value = match field.need {
                Need::Required => record.require(field.name, &field.size.words())?,
                Need::Optional => match record.get(field.name) {
                    Some(value) => value,
                    None => continue,
                },
            };
            let path = record.path.field(field.name);
            match (field.size, numbers) {
                (Size::One, [number]) => *number = reader::number(value, &path, field.range)?,
                (_, numbers) => reader::numbers(value, &path, field.range, numbers)?,
            }
        }
        Ok(read)
    }

    /// The fields of the canonical document: without those that may be left out and have their default.
    fn write(&self, into: &mut Vec<(String, Value)>) {
        for ((field, numbers), start) in Self::FIELDS.iter().zip(self.numbers()).zip(Self::START.numbers()) {
            if field.need == Need::Required || numbers != start {
                into.push((field.name.to_owned(), field.size.value(numbers)));
            }
        }
    }

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

impl Size {
    fn words(self) -> String {
        match self {
            Size::One => "a number".into(),
            Size::List(length) => format!("a list of {length} numbers"),
        }
    }

    fn value(self, numbers: &[f64]) -> Value {
        match (self, numbers) {
            (Size::One, [number]) => Value::Number(*number),
            (_, numbers) => Value::List(numbers.iter().map(|x| Value::Number(*x)).collect()),
        }
    }
}

/// The names of the fields, for [`Record::only`].
pub(crate) fn names<T: Fields>() -> Vec<&'static str> {
    T::FIELDS.iter().map(|field| field.name).collect()
}

/// An object that has the fields of `T` and no others.
pub(crate) fn read_record<T: Fields>(value: &Value, path: Path, what: &str) -> Result<T> {
    T::read(&Record::open(value, path, what)?.only(&names::<T>())?)
}

/// One number or an array of them.
pub(crate) trait Quantity {
    const SIZE: Size;
    fn as_numbers(&self) -> &[f64];
    fn as_numbers_mut(&mut self) -> &mut [f64];
}

impl Quantity for f64 {
    const SIZE: Size = Size::One;

    fn as_numbers(&self) -> &[f64] {
        std::slice::from_ref(self)
    }

    fn as_numbers_mut(&mut self) -> &mut [f64] {
        std::slice::from_mut(self)
    }
}

impl<const N: usize> Quantity for [f64; N] {
    const SIZE: Size = Size::List(N);

    fn as_numbers(&self) -> &[f64] {
        self
    }

    fn as_numbers_mut(&mut self) -> &mut [f64] {
        self
    }
}

/// Declares a struct of numbers together with its table of fields, so that the two cannot disagree.
///
/// A field reads `name: type = start, Need, Range;`. The document knows it by the same name.
macro_rules! fields {
    (
        $(#[$about:meta])*
        pub struct $record:ident {
            $( $(#[doc = $doc:literal])+ $field:ident: $type:ty = $start:expr, $need:ident, $range:ident; )+
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
                    size: <$type as $crate::design::fields::Quantity>::SIZE,
                    need: $crate::design::fields::Need::$need,
                    range: $crate::design::reader::Range::$range,
                    #[cfg(feature = "typescript")]
                    about: &[$($doc),+],
                }, )+
            ];
            const START: Self = $record { $( $field: $start, )+ };

            fn numbers(&self) -> Vec<&[f64]> {
                vec![$( $crate::design::fields::Quantity::as_numbers(&self.$field), )+]
            }

            fn numbers_mut(&mut self) -> Vec<&mut [f64]> {
                vec![$( $crate::design::fields::Quantity::as_numbers_mut(&mut self.$field), )+]
            }
        }
    };
}
pub(crate) use fields;
