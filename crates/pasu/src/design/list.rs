//! Lists of so many items at most, said in the words of the format.

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

/// Reads a list; `expected` says of what. `most` are its items and how that is said.
pub(super) fn read<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    deserializer: D,
    expected: &str,
    most: Option<(usize, &str)>,
) -> Result<Vec<T>, D::Error> {
    deserializer.deserialize_seq(List { expected, most, item: PhantomData })
}

struct List<'a, T> {
    expected: &'a str,
    most: Option<(usize, &'a str)>,
    item: PhantomData<T>,
}

impl<'de, T: Deserialize<'de>> Visitor<'de> for List<'_, T> {
    type Value = Vec<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expected)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Vec<T>, A::Error> {
        let given = items.size_hint().unwrap_or_default();
        let mut list = Vec::new();
        let check = |length: usize| match self.most {
            Some((most, said)) if length > most => Err(A::Error::invalid_length(length, &said)),
            _ => Ok(()),
        };
        check(given)?;
        list.reserve(given.min(1 << 12));
        while let Some(item) = items.next_element()? {
            list.push(item);
            check(list.len())?;
        }
        Ok(list)
    }
}
