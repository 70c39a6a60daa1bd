//! The first argument of every function: a design as an object, as JSON text or as a link.

use pasu::{Design, Result};
use wasm_bindgen::JsValue;

use crate::value;

/// Reads a design from whatever JavaScript has.
pub(crate) fn design(source: &JsValue) -> Result<Design> {
    match source.as_string() {
        Some(text) => Design::parse(&text),
        None => Design::from_value(&value::read(source)?),
    }
}
