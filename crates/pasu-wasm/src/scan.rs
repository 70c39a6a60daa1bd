//! Triangles as JavaScript hands them over.

use js_sys::{Float32Array, Reflect, Uint32Array};
use pasu::{Code, Error, Result, Scan};
use wasm_bindgen::prelude::*;

use crate::plain;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(extends = Uint32Array, js_name = Uint32Array)]
    type Counts;

    /// Throws of an array whose buffer was transferred, and of a proxy of an array.
    #[wasm_bindgen(catch, constructor, js_class = "Uint32Array")]
    fn new(array: &JsValue) -> core::result::Result<Counts, JsValue>;
}

/// The scan that an object is; nothing where it has no `positions`.
pub(crate) fn read(from: &JsValue) -> Result<Option<Scan>> {
    let Some(positions) = field(from, "positions")? else { return Ok(None) };
    let mut scan = Scan::new(coordinates(&positions).map_err(|error| error.at("positions"))?);
    scan.indices = match field(from, "indices")? {
        Some(indices) => Some(counts(&indices).map_err(|error| error.at("indices"))?),
        None => None,
    };
    Ok(Some(scan))
}

/// What an object has under a name; nothing where that is undefined, and of what is no object.
fn field(object: &JsValue, name: &str) -> Result<Option<JsValue>> {
    if !object.is_object() {
        return Ok(None);
    }
    let value = Reflect::get(object, &name.into()).map_err(|thrown| plain::unreadable(thrown).at(name))?;
    Ok((!value.is_undefined()).then_some(value))
}

/// The most coordinates, or numbers of points, of a scan: nine for each of its triangles. They are copied into the memory of the module before anybody looks at them.
const MOST_OF_A_SCAN: u32 = 36_000_000;

fn no_longer_than_a_scan(length: u32) -> Result<()> {
    if length <= MOST_OF_A_SCAN {
        return Ok(());
    }
    let message = format!("expected at most {MOST_OF_A_SCAN} numbers, found {length}");
    let error = Error::new(Code::TooLarge, "", message).with("greatest", f64::from(MOST_OF_A_SCAN));
    Err(error.with("found", f64::from(length)))
}

/// Coordinates: a typed array of floats.
fn coordinates(value: &JsValue) -> Result<Vec<f32>> {
    let Some(numbers) = plain::numbers(value)? else {
        return Err(Error::new(Code::WrongType, "", "expected a Float32Array"));
    };
    no_longer_than_a_scan(numbers.length())?;
    Ok(Float32Array::new(&numbers).to_vec())
}

/// Numbers of points: a typed array of unsigned integers.
fn counts(value: &JsValue) -> Result<Vec<u32>> {
    if !value.is_instance_of::<Uint32Array>() {
        return Err(Error::new(Code::WrongType, "", "expected a Uint32Array"));
    }
    let counts: Uint32Array = Counts::new(value).map_err(plain::unreadable)?.into();
    no_longer_than_a_scan(counts.length())?;
    Ok(counts.to_vec())
}
