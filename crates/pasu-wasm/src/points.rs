//! The arguments that name a part and points on it.

use pasu::{Code, Error, Result};
use wasm_bindgen::JsValue;

use crate::plain::{self, Items};

/// The index of a part. Whether the design has it is `pasu`'s to say.
pub(crate) fn part(part: &JsValue) -> Result<usize> {
    match part.as_f64() {
        Some(index) if index >= 0.0 && index <= f64::from(u32::MAX) && index.fract() == 0.0 => Ok(index as usize),
        Some(index) => {
            Err(Error::new(Code::NoSuchPoint, "part", format!("expected the index of a part, found {index}")))
        }
        None => Err(Error::new(Code::WrongType, "part", "expected the index of a part, a number")),
    }
}

/// Parameter values: a `Float64Array`, or a plain array of numbers.
pub(crate) fn read(at: &JsValue) -> Result<Vec<f64>> {
    numbers(at, "at", "a Float64Array of (u, v) pairs")
}

/// Numbers of which a refusal says what was expected.
pub(crate) fn numbers(at: &JsValue, name: &str, expected: &str) -> Result<Vec<f64>> {
    let unreadable = |error: Error| error.at(name);
    if let Some(numbers) = plain::numbers(at).map_err(unreadable)? {
        return Ok(numbers.to_vec());
    }
    let Some(items) = Items::if_list(at).map_err(unreadable)? else {
        return Err(Error::new(Code::WrongType, name, format!("expected {expected}")));
    };
    let number = |(index, item): (usize, core::result::Result<JsValue, JsValue>)| {
        let path = || format!("{name}[{index}]");
        let item = item.map_err(|thrown| plain::unreadable(thrown).at(path()))?;
        item.as_f64().ok_or_else(|| Error::new(Code::WrongType, path(), "expected a number"))
    };
    items.enumerate().map(number).collect()
}
