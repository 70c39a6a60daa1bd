//! One number or a list of them, within a range: how `serde` reads the numbers of a document.

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::{Deserializer, Error, IgnoredAny, SeqAccess, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};

/// The range of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Range {
    Any,
    NotZero,
    Positive,
    NotNegative,
    Share,
    /// An exponent of a supersphere.
    Exponent,
}

impl Range {
    pub(crate) fn contains(self, x: f64) -> bool {
        match self {
            Range::Any => true,
            Range::NotZero => x != 0.0,
            Range::Positive => x > 0.0,
            Range::NotNegative => x >= 0.0,
            Range::Share => (0.0..=1.0).contains(&x),
            Range::Exponent => (0.05..=50.0).contains(&x),
        }
    }

    /// "a number", with the range.
    fn words(self) -> &'static str {
        match self {
            Range::Any => "a number",
            Range::NotZero => "a number other than 0",
            Range::Positive => "a number greater than 0",
            Range::NotNegative => "0 or a number greater than 0",
            Range::Share => "a number from 0 to 1",
            Range::Exponent => "a number from 0.05 to 50",
        }
    }

    /// The range that such words tell of: all that `serde` hands on of what was expected are its words.
    pub(super) fn told(words: &str) -> Option<Range> {
        [Range::NotZero, Range::Positive, Range::NotNegative, Range::Share, Range::Exponent]
            .into_iter()
            .find(|range| range.words() == words)
    }

    /// What an error that expected this names: the bounds, and whether they are among those allowed.
    pub(super) fn arguments(self) -> &'static [(&'static str, f64)] {
        match self {
            Range::Any => &[],
            Range::NotZero => &[("not", 0.0)],
            Range::Positive => &[("above", 0.0)],
            Range::NotNegative => &[("least", 0.0)],
            Range::Share => &[("least", 0.0), ("greatest", 1.0)],
            Range::Exponent => &[("least", 0.05), ("greatest", 50.0)],
        }
    }
}

/// One number, or a list of so many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Size {
    One,
    List(usize),
}

impl Size {
    pub(crate) fn words(self) -> String {
        match self {
            Size::One => "a number".into(),
            Size::List(length) => format!("a list of {length} numbers"),
        }
    }
}

/// One number or an array of them.
pub(crate) trait Quantity {
    const SIZE: Size;
    const ZERO: Self;
    fn as_numbers(&self) -> &[f64];
    fn as_numbers_mut(&mut self) -> &mut [f64];
}

impl Quantity for f64 {
    const SIZE: Size = Size::One;
    const ZERO: Self = 0.0;

    fn as_numbers(&self) -> &[f64] {
        std::slice::from_ref(self)
    }

    fn as_numbers_mut(&mut self) -> &mut [f64] {
        std::slice::from_mut(self)
    }
}

impl<const N: usize> Quantity for [f64; N] {
    const SIZE: Size = Size::List(N);
    const ZERO: Self = [0.0; N];

    fn as_numbers(&self) -> &[f64] {
        self
    }

    fn as_numbers_mut(&mut self) -> &mut [f64] {
        self
    }
}

/// Reads as many numbers as there are places.
pub(super) fn read_into<'de, D: Deserializer<'de>>(
    deserializer: D,
    size: Size,
    range: Range,
    places: &mut [f64],
) -> Result<(), D::Error> {
    match (size, places) {
        (Size::One, [place]) => *place = deserializer.deserialize_f64(One(range))?,
        (_, places) => deserializer.deserialize_seq(Many { range, places })?,
    }
    Ok(())
}

fn read<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D, range: Range) -> Result<Q, D::Error> {
    let mut quantity = Q::ZERO;
    read_into(deserializer, Q::SIZE, range, quantity.as_numbers_mut())?;
    Ok(quantity)
}

/// Any finite numbers.
pub(super) fn any<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D) -> Result<Q, D::Error> {
    read(deserializer, Range::Any)
}

/// Numbers other than 0.
pub(super) fn not_zero<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D) -> Result<Q, D::Error> {
    read(deserializer, Range::NotZero)
}

/// Numbers greater than 0.
pub(super) fn positive<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D) -> Result<Q, D::Error> {
    read(deserializer, Range::Positive)
}

/// The exponents of a supersphere, 0.05 to 50.
#[cfg(feature = "patchwork")]
pub(super) fn exponents<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D) -> Result<Q, D::Error> {
    read(deserializer, Range::Exponent)
}

/// 0 or greater.
pub(super) fn not_negative<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D) -> Result<Q, D::Error> {
    read(deserializer, Range::NotNegative)
}

/// Any finite number; 0 when it is left out.
pub(super) fn or_zero<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    deserializer.deserialize_option(Maybe(Range::Any, PhantomData)).map(Option::unwrap_or_default)
}

/// 0 or greater; 0 when it is left out.
pub(super) fn not_negative_or_zero<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    deserializer.deserialize_option(Maybe(Range::NotNegative, PhantomData)).map(Option::unwrap_or_default)
}

/// 0 to 1; 0 when it is left out.
pub(super) fn share_or_zero<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    deserializer.deserialize_option(Maybe(Range::Share, PhantomData)).map(Option::unwrap_or_default)
}

/// Numbers greater than 0, which may be left out.
pub(super) fn maybe_positive<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D) -> Result<Option<Q>, D::Error> {
    deserializer.deserialize_option(Maybe(Range::Positive, PhantomData))
}

/// Numbers other than 0, which may be left out.
#[cfg(feature = "patchwork")]
pub(crate) fn maybe_not_zero<'de, D: Deserializer<'de>, Q: Quantity>(deserializer: D) -> Result<Option<Q>, D::Error> {
    deserializer.deserialize_option(Maybe(Range::NotZero, PhantomData))
}

/// Numbers of a range; when they are left out, these.
pub(super) fn or<'de, D: Deserializer<'de>, Q: Quantity>(
    deserializer: D,
    range: Range,
    start: Q,
) -> Result<Q, D::Error> {
    deserializer.deserialize_option(Maybe(range, PhantomData)).map(|given| given.unwrap_or(start))
}

/// Whatever may be left out and then has its default.
pub(crate) fn or_default<'de, D: Deserializer<'de>, T: Deserialize<'de> + Default>(
    deserializer: D,
) -> Result<T, D::Error> {
    Option::deserialize(deserializer).map(Option::unwrap_or_default)
}

/// A whole number from 0 to `u32::MAX`; 0 when it is left out.
pub(crate) fn whole<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u32, D::Error> {
    deserializer.deserialize_option(Whole)
}

/// A whole number from 0 to `u32::MAX` in a list.
#[derive(Clone, Copy)]
pub(super) struct Index(pub(super) u32);

impl<'de> Deserialize<'de> for Index {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_f64(Whole).map(Index)
    }
}

/// Whether a number need not be written.
pub(super) fn is_zero(x: &f64) -> bool {
    *x == 0.0
}

/// Whether something need not be written.
pub(crate) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A finite number in a list.
#[derive(Clone, Copy)]
pub(super) struct Finite(pub(super) f64);

impl<'de> Deserialize<'de> for Finite {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        any(deserializer).map(Finite)
    }
}

/// One number.
pub(super) struct One(pub(super) Range);

impl Visitor<'_> for One {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.words())
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<f64, E> {
        self.visit_f64(x as f64)
    }

    fn visit_u64<E: Error>(self, x: u64) -> Result<f64, E> {
        self.visit_f64(x as f64)
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<f64, E> {
        if x.is_finite() && self.0.contains(x) { Ok(x) } else { Err(E::invalid_value(Unexpected::Float(x), &self)) }
    }
}

/// Exactly as many numbers as there are places.
struct Many<'a> {
    range: Range,
    places: &'a mut [f64],
}

impl Many<'_> {
    fn wrong_length<E: Error>(&self, found: usize) -> E {
        let found = if found == 0 { "an empty list".to_owned() } else { format!("a list of {found}") };
        E::invalid_type(Unexpected::Other(&found), self)
    }
}

impl<'de> Visitor<'de> for Many<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Size::List(self.places.len()).words())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        if let Some(length) = items.size_hint().filter(|length| *length != self.places.len()) {
            return Err(self.wrong_length(length));
        }
        for index in 0..self.places.len() {
            match items.next_element_seed(Item(self.range))? {
                Some(x) => self.places[index] = x,
                None => return Err(self.wrong_length(index)),
            }
        }
        match items.next_element::<IgnoredAny>()? {
            Some(_) => Err(self.wrong_length(self.places.len() + 1)),
            None => Ok(()),
        }
    }
}

struct Item(Range);

impl<'de> serde::de::DeserializeSeed<'de> for Item {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f64, D::Error> {
        deserializer.deserialize_f64(One(self.0))
    }
}

/// What may be left out.
struct Maybe<Q>(Range, PhantomData<Q>);

impl<'de, Q: Quantity> Visitor<'de> for Maybe<Q> {
    type Value = Option<Q>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.words())
    }

    fn visit_none<E>(self) -> Result<Option<Q>, E> {
        Ok(None)
    }

    fn visit_unit<E>(self) -> Result<Option<Q>, E> {
        Ok(None)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Option<Q>, D::Error> {
        read(deserializer, self.0).map(Some)
    }
}

struct Whole;

impl<'de> Visitor<'de> for Whole {
    type Value = u32;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a whole number, 0 or greater")
    }

    fn visit_none<E>(self) -> Result<u32, E> {
        Ok(0)
    }

    fn visit_unit<E>(self) -> Result<u32, E> {
        Ok(0)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<u32, D::Error> {
        deserializer.deserialize_f64(self)
    }

    fn visit_u64<E: Error>(self, x: u64) -> Result<u32, E> {
        self.visit_f64(x as f64)
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<u32, E> {
        let found = Unexpected::Float(x);
        match x.floor() == x && x >= 0.0 && x.is_finite() {
            true if x <= f64::from(u32::MAX) => Ok(x as u32),
            true => Err(E::invalid_value(found, &"a whole number, 4294967295 or less")),
            false => Err(E::invalid_value(found, &self)),
        }
    }
}

/// The numbers of a field as a document writes them.
pub(super) struct Written<'a>(pub(super) Size, pub(super) &'a [f64]);

impl Serialize for Written<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Written(Size::One, [number]) => serializer.serialize_f64(*number),
            Written(_, numbers) => serializer.collect_seq(*numbers),
        }
    }
}
