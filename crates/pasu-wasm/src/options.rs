//! The options of `mesh`.

use pasu::{MeshOptions, Result};
use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use wasm_bindgen::JsValue;

use crate::source;

/// `{ tolerance, rows, columns }`.
#[derive(serde::Deserialize)]
#[serde(expecting = "an object of options")]
struct Options {
    tolerance: Option<f64>,
    rows: Option<Count>,
    columns: Option<Count>,
}

/// Reads the options; all of them may be left out.
pub(crate) fn read(options: &JsValue) -> Result<MeshOptions> {
    let given = source::argument(options, "options")?;
    let Some(Options { tolerance, rows, columns }) = given else { return Ok(MeshOptions::default()) };
    let count = |Count(count)| count;
    Ok(MeshOptions { tolerance, rows: rows.map(count), columns: columns.map(count) })
}

/// A number of rows or columns. Which grids are too fine is `pasu`'s to say.
pub(crate) struct Count(pub(crate) usize);

impl<'de> Deserialize<'de> for Count {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> core::result::Result<Self, D::Error> {
        deserializer.deserialize_f64(CountVisitor)
    }
}

struct CountVisitor;

impl Visitor<'_> for CountVisitor {
    type Value = Count;

    fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("a whole number")
    }

    fn visit_f64<E: Error>(self, number: f64) -> core::result::Result<Count, E> {
        if (0.0..=f64::from(u32::MAX)).contains(&number) && number.fract() == 0.0 {
            Ok(Count(number as usize))
        } else {
            Err(E::invalid_value(Unexpected::Float(number), &self))
        }
    }
}

/// A number that is one.
#[cfg(feature = "making")]
pub(crate) struct Finite(pub(crate) f64);

#[cfg(feature = "making")]
impl<'de> Deserialize<'de> for Finite {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> core::result::Result<Self, D::Error> {
        let number = f64::deserialize(deserializer)?;
        match number.is_finite() {
            true => Ok(Finite(number)),
            false => Err(D::Error::invalid_value(Unexpected::Float(number), &"a number")),
        }
    }
}
