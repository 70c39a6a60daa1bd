//! Pasu for JavaScript: converts arguments, calls `pasu`, converts the result back. No arithmetic of its own.
//!
//! What is exported here becomes `bindings.js`, and without the feature `making` `drawing_bindings.js`; `js/pasu.js` and `js/drawing.js`
//! wrap them into the modules that people import, and `js/pasu.d.ts` and `js/drawing.d.ts` describe these. Every refusal leaves as an error named `PasuError` with `code` and `path`.
//!
//! A panic is a bug. The module is compiled with `panic = "abort"`, so nothing is unwound: the panic hook throws a
//! `PasuError` with the code `bug` instead, and the wrapper starts a fresh instance before the next call.

#![cfg_attr(target_arch = "wasm32", warn(missing_docs))]

mod error;
#[cfg(feature = "making")]
mod fields;
#[cfg(feature = "making")]
mod fit;
#[cfg(feature = "making")]
mod following;
#[cfg(feature = "making")]
mod interior;
mod into;
mod last;
#[cfg(feature = "making")]
mod making;
mod mesh;
mod options;
mod plain;
mod points;
#[cfg(feature = "making")]
mod pull;
mod room;
#[cfg(feature = "making")]
mod scan;
#[cfg(feature = "making")]
mod scene;
mod shape;
#[cfg(feature = "making")]
mod sketch;
mod source;
#[cfg(feature = "making")]
mod watch;

use js_sys::{Float64Array, Object};
use wasm_bindgen::prelude::*;

use crate::error::thrown;
#[cfg(feature = "making")]
pub use crate::fit::{fit, free, levels};
#[cfg(feature = "making")]
pub use crate::following::moved;
#[cfg(feature = "making")]
pub use crate::interior::{cells, cells_file, inside, inside_values};
#[cfg(feature = "making")]
pub use crate::making::{check, measure, obj_materials, open, paint, provenance, solid, water, write};
#[cfg(feature = "making")]
pub use crate::pull::{pull, pulled};
#[cfg(feature = "making")]
pub use crate::scene::{at, at_again, compare, connectivity, constraints, flat, mark_last, pick, pick_again, tree};
pub use crate::shape::{convert, handles};
#[cfg(feature = "making")]
pub use crate::sketch::sketch;
#[cfg(feature = "making")]
pub use crate::watch::watched;

#[cfg(all(doctest, not(target_arch = "wasm32")))]
#[doc = include_str!("../../../README.md")]
mod readme {}

/// Prepares the module; runs once, when it is instantiated.
#[wasm_bindgen(start)]
pub fn start() {
    error::install_panic_hook();
}

/// The canonical design, as a plain object.
///
/// # Errors
/// When the source is not a design.
#[wasm_bindgen]
pub fn parse(source: &JsValue) -> Result<JsValue, JsValue> {
    let solution = source::solution(source).map_err(|error| thrown(&error))?;
    plain_object(solution.design())
}

/// What is made of structs, lists and numbers as plain objects, as `JSON.parse` would make them.
fn plain_object(value: &impl serde::Serialize) -> Result<JsValue, JsValue> {
    Ok(value.serialize(&serde_wasm_bindgen::Serializer::json_compatible())?)
}

/// The link of a design, without the leading `#`.
///
/// # Errors
/// When the source is not a design, or one that is too large for a link.
#[wasm_bindgen]
pub fn link(source: &JsValue) -> Result<String, JsValue> {
    let linked = || source::solution(source)?.design().try_link();
    linked().map_err(|error| thrown(&error))
}

/// The triangles of a design, as an object of typed arrays: those of an earlier mesh in `into` where they are long enough.
///
/// # Errors
/// When the source is not a design, an option is not understood, or the design cannot be solved or meshed.
#[wasm_bindgen]
pub fn mesh(source: &JsValue, options: &JsValue, into: &JsValue) -> Result<Object, JsValue> {
    let sampled = || mesh::sampled(&source::solution(source)?, &options::read(options)?, into);
    sampled().map_err(|error| thrown(&error))?
}

/// The largest distance between the triangles of such a mesh and the surface.
///
/// # Errors
/// As [`mesh`].
#[wasm_bindgen]
pub fn bound(source: &JsValue, options: &JsValue) -> Result<f64, JsValue> {
    let bounded = || source::solution(source)?.bound(&options::read(options)?);
    bounded().map_err(|error| thrown(&error))
}

/// Positions of a part before placement, xyz triples.
///
/// # Errors
/// When the source is not a design, the part or a point does not exist, or the part cannot be solved.
#[wasm_bindgen]
pub fn evaluate(source: &JsValue, part: &JsValue, at: &JsValue) -> Result<Float64Array, JsValue> {
    let solved = || source::solution(source)?.evaluate(points::part(part)?, &points::read(at)?);
    let positions = solved().map_err(|error| thrown(&error))?;
    Ok(Float64Array::from(positions.as_slice()))
}

/// First derivatives of a part before placement, as an object of two arrays of xyz triples.
///
/// # Errors
/// As [`evaluate`].
#[wasm_bindgen]
pub fn derivatives(source: &JsValue, part: &JsValue, at: &JsValue) -> Result<Object, JsValue> {
    let solved = || source::solution(source)?.derivatives(points::part(part)?, &points::read(at)?);
    let derivatives = solved().map_err(|error| thrown(&error))?;
    let object = Object::new();
    mesh::set(&object, "du", Float64Array::from(derivatives.du.as_slice()).into())?;
    mesh::set(&object, "dv", Float64Array::from(derivatives.dv.as_slice()).into())?;
    Ok(object)
}

/// A short hash of the design's mesh, the same on every machine.
///
/// # Errors
/// When the source is not a design or cannot be solved.
#[wasm_bindgen]
pub fn fingerprint(source: &JsValue) -> Result<String, JsValue> {
    let solved = || source::solution(source)?.fingerprint();
    solved().map_err(|error| thrown(&error))
}
