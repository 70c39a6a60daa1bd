//! Designs as scenes.

use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::{plain_object, source};

/// How a scene differs from another, as a plain object.
///
/// # Errors
/// When one of them is not a design.
#[wasm_bindgen]
pub fn compare(before: &JsValue, after: &JsValue) -> Result<JsValue, JsValue> {
    let compared = || Ok(pasu::compare(&source::design(before)?, &source::design(after)?));
    plain_object(&compared().map_err(|error| thrown(&error))?)
}
