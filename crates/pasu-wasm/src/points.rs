//! The arguments that name a part and points on it.

use js_sys::{Array, Float32Array, Float64Array};
use pasu::{Code, Error, Result};
use wasm_bindgen::{JsCast, JsValue};

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
    if let Some(array) = at.dyn_ref::<Float64Array>() {
        return Ok(array.to_vec());
    }
    if let Some(array) = at.dyn_ref::<Float32Array>() {
        return Ok(array.to_vec().into_iter().map(f64::from).collect());
    }
    let Some(array) = at.dyn_ref::<Array>() else {
        return Err(Error::new(Code::WrongType, "at", "expected a Float64Array of (u, v) pairs"));
    };
    let number = |(index, item): (usize, JsValue)| {
        item.as_f64().ok_or_else(|| Error::new(Code::WrongType, format!("at[{index}]"), "expected a number"))
    };
    array.iter().enumerate().map(number).collect()
}
