//! Designs as scenes.

use pasu::Tree;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::plain::{Plain, text};
use crate::{last, plain_object, source};

#[derive(Deserialize, Default)]
#[serde(expecting = "an object of options")]
struct ConstraintFields {
    slack: Option<f64>,
}

/// How a scene differs from another, as a plain object.
///
/// # Errors
/// When one of them is not a design.
#[wasm_bindgen]
pub fn compare(before: &JsValue, after: &JsValue) -> Result<JsValue, JsValue> {
    let compared = || Result::Ok(pasu::compare(&source::design(before)?, &source::design(after)?));
    plain_object(&compared().map_err(|error| thrown(&error))?)
}

/// Where a ray meets the parts of a design, as a list of plain objects.
///
/// # Errors
/// When the source is not a design, or one of its parts cannot be solved; when the ray is none.
#[wasm_bindgen]
pub fn pick(source: &JsValue, ray: &JsValue) -> Result<JsValue, JsValue> {
    let picked = || source::solution(source)?.pick(source::named(ray, "ray")?);
    plain_object(&picked().map_err(|error| thrown(&error))?)
}

/// The parts of a design that hold a point, as a list of plain objects.
///
/// # Errors
/// When the source is not a design, or one of its parts cannot be solved; when the point is none.
#[wasm_bindgen]
pub fn at(source: &JsValue, point: &JsValue) -> Result<JsValue, JsValue> {
    let held = || source::solution(source)?.at(source::named(point, "point")?);
    plain_object(&held().map_err(|error| thrown(&error))?)
}

/// Marks the design of the last call by a number, for `pickAgain` and `atAgain`.
#[wasm_bindgen(js_name = markLast)]
pub fn mark_last(mark: f64) {
    last::mark(mark);
}

/// As `pick` of the design that has this mark: to read one of five hundred parts takes longer than the answer. `undefined` where its solution is no longer kept.
///
/// # Errors
/// When the ray is none.
#[wasm_bindgen(js_name = pickAgain)]
pub fn pick_again(mark: f64, ray: &JsValue) -> Result<JsValue, JsValue> {
    let Some(solution) = last::marked(mark) else { return Ok(JsValue::UNDEFINED) };
    let picked = || solution.pick(source::named(ray, "ray")?);
    plain_object(&picked().map_err(|error| thrown(&error))?)
}

/// As `at`, likewise.
///
/// # Errors
/// When the point is none.
#[wasm_bindgen(js_name = atAgain)]
pub fn at_again(mark: f64, point: &JsValue) -> Result<JsValue, JsValue> {
    let Some(solution) = last::marked(mark) else { return Ok(JsValue::UNDEFINED) };
    let held = || solution.at(source::named(point, "point")?);
    plain_object(&held().map_err(|error| thrown(&error))?)
}

/// The tree of a scene, as a plain object.
///
/// # Errors
/// When the source is not a design.
#[wasm_bindgen]
pub fn tree(source: &JsValue) -> Result<JsValue, JsValue> {
    let design = source::design(source).map_err(|error| thrown(&error))?;
    plain_object(&pasu::tree(&design))
}

/// The design of a tree, as a plain object.
///
/// # Errors
/// When this is not a tree, neither as an object nor as JSON text, or what it says is not a design.
#[wasm_bindgen]
pub fn flat(tree: &JsValue) -> Result<JsValue, JsValue> {
    let read = || match text(tree)? {
        Some(text) => Tree::parse(&text),
        None => Tree::read(Plain(tree.clone())),
    };
    let design = read().and_then(|tree| pasu::flat(&tree)).map_err(|error| thrown(&error))?;
    plain_object(&design)
}

/// Which parts are glued, as a plain object.
///
/// # Errors
/// When the source is not a design.
#[wasm_bindgen]
pub fn connectivity(source: &JsValue) -> Result<JsValue, JsValue> {
    let design = source::design(source).map_err(|error| thrown(&error))?;
    plain_object(&pasu::connectivity(&design))
}

/// Whether a scene keeps its constraints, as a plain object.
///
/// # Errors
/// When the source is not a design, or one of its parts cannot be solved; when the slack is no length.
#[wasm_bindgen]
pub fn constraints(source: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let judged = || {
        let given: Option<ConstraintFields> = source::argument(options, "options")?;
        source::solution(source)?.constraints(given.unwrap_or_default().slack)
    };
    plain_object(&judged().map_err(|error| thrown(&error))?)
}
