//! What is asked of a shape by itself, before it is a design.

use pasu::{Shape, VaseOrder};
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::{plain_object, source};

/// A vase in another order, and what it had to leave behind: `{ shape, lost }`.
///
/// # Errors
/// When the shape or the order is none, the shape is boundary data written out, or its numbers leave the range of numbers.
#[wasm_bindgen]
pub fn convert(shape: &JsValue, order: &JsValue) -> Result<JsValue, JsValue> {
    let converted = || source::shape(shape)?.convert(source::argument::<VaseOrder>(order, "order")?);
    plain_object(&converted().map_err(|error| thrown(&error))?)
}

/// What of a shape a hand can drag, and which of its numbers move then: `{ rim, list }`. Paths are those of the shape as it is given.
///
/// # Errors
/// When the shape is none.
#[wasm_bindgen]
pub fn handles(shape: &JsValue) -> Result<JsValue, JsValue> {
    let shape: Shape = source::shape(shape).map_err(|error| thrown(&error))?;
    plain_object(&shape.handles())
}
