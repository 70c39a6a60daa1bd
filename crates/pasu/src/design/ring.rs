//! Rings and free ends as a document gives them.

use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::limits::RINGS;
use super::list;
use super::number::plain;
use super::quantity::{any, or_default};
use crate::error::{Code, Error, Result};
pub use crate::mode::{Free, Ring};

impl Serialize for Ring {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Ring", 1 + usize::from(self.sharp))?;
        fields.serialize_field("u", &self.u)?;
        match self.sharp {
            true => fields.serialize_field("sharp", &true)?,
            false => fields.skip_field("sharp")?,
        }
        fields.end()
    }
}

impl<'de> Deserialize<'de> for Ring {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Ring", expecting = "a ring with its u")]
        struct Given {
            #[serde(deserialize_with = "any")]
            u: f64,
            #[serde(deserialize_with = "or_default")]
            sharp: bool,
        }
        Given::deserialize(deserializer).map(|Given { u, sharp }| Ring { u, sharp })
    }
}

/// Reads rings between the two ends, none when they are left out.
pub(super) fn rings<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Vec<Ring>, D::Error> {
    #[derive(Default)]
    struct Rings(Vec<Ring>);

    impl<'de> Deserialize<'de> for Rings {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
            let most = format!("at most {RINGS} rings");
            list::read(deserializer, "a list of rings", Some((RINGS, &most))).map(Rings)
        }
    }

    or_default(deserializer).map(|Rings(rings)| rings)
}

/// Refuses places that are not inside (0, 1), each beyond the one before it. The path begins at the list, of which they are the items from number `first` on.
///
/// # Errors
/// `out-of-range`.
#[inline]
pub(super) fn ascending(places: impl Iterator<Item = f64>, first: usize) -> Result<()> {
    let mut before = 0.0;
    for (index, u) in places.enumerate() {
        if !(u > before && u < 1.0) {
            let message =
                format!("expected a number greater than {} and less than 1, found {}", plain(before), plain(u));
            let error = Error::new(Code::OutOfRange, "u", message).inside_item(first + index);
            return Err(error.with("above", before).with("below", 1.0).with("found", u));
        }
        before = u;
    }
    Ok(())
}

/// The ends that are free, by the names that a document has for them.
#[derive(serde::Serialize, serde::Deserialize)]
enum Named {
    #[serde(rename = "start")]
    Start,
    #[serde(rename = "end")]
    End,
    #[serde(rename = "both")]
    Both,
}

/// Writes what is not empty: left out where no end is free.
impl Serialize for Free {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match self {
            Free { start: true, end: true } => Named::Both.serialize(serializer),
            Free { start: true, end: false } => Named::Start.serialize(serializer),
            Free { start: false, end: true } => Named::End.serialize(serializer),
            Free { start: false, end: false } => serializer.serialize_none(),
        }
    }
}

impl<'de> Deserialize<'de> for Free {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        Named::deserialize(deserializer).map(|named| match named {
            Named::Start => Free { start: true, end: false },
            Named::End => Free { start: false, end: true },
            Named::Both => Free { start: true, end: true },
        })
    }
}
