//! What JavaScript hands over: a design as an object, as JSON text or as a link, and options.

use std::rc::Rc;

use pasu::{Design, Result, Shape, Solution};
use serde::de::DeserializeOwned;
use wasm_bindgen::JsValue;

use crate::last;
use crate::plain::{Plain, text};

/// Reads a design from whatever JavaScript has.
#[cfg(feature = "making")]
pub(crate) fn design(source: &JsValue) -> Result<Design> {
    match text(source)? {
        Some(text) => Design::parse(&text),
        None => Design::read(Plain(source.clone())),
    }
}

/// Reads a bare shape from a plain object. Paths in refusals begin at the shape.
pub(crate) fn shape(shape: &JsValue) -> Result<Shape> {
    argument(shape, "shape")
}

/// Reads a design and solves it, unless that is what the last call did.
pub(crate) fn solution(source: &JsValue) -> Result<Rc<Solution>> {
    match text(source)? {
        Some(text) => last::solution_of(&text),
        None => Ok(last::solution(&Design::read(Plain(source.clone()))?)),
    }
}

/// Reads an argument that is no design and no options: every path begins with what it is called.
#[cfg(feature = "making")]
pub(crate) fn named<T: DeserializeOwned>(value: &JsValue, name: &str) -> Result<T> {
    pasu::read(Plain(value.clone())).map_err(|error| {
        let point = if error.path().is_empty() || error.path().starts_with('[') { "" } else { "." };
        let path = format!("{name}{point}{}", error.path());
        error.at(path)
    })
}

/// Reads an argument that is no design; `path` is what it is called.
pub(crate) fn argument<T: DeserializeOwned>(value: &JsValue, path: &str) -> Result<T> {
    pasu::read(Plain(value.clone())).map_err(|error| if error.path().is_empty() { error.at(path) } else { error })
}
