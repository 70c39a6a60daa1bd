//! What it takes to make a design, besides drawing it: measures, checks, files.

use js_sys::{Array, Float32Array, JSON, Object, Uint8Array, Uint32Array};
use pasu::Format;
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::mesh::set;
use crate::{fields, source};

/// Whether the design can be made, as a plain object.
///
/// # Errors
/// When the source is not a design or an option is not understood.
#[wasm_bindgen]
pub fn check(source: &JsValue, making: &JsValue) -> Result<JsValue, JsValue> {
    let checked = || pasu::check(&source::design(source)?, &fields::making(making)?);
    JSON::parse(&checked().map_err(|error| thrown(&error))?.to_json())
}

/// The bytes of a file.
///
/// # Errors
/// When the source is not a design, the format or an option is not understood, or the design cannot be made.
#[wasm_bindgen]
pub fn write(source: &JsValue, format: &JsValue, making: &JsValue) -> Result<Uint8Array, JsValue> {
    let written = || {
        let format = fields::one_of(format, "format", &Format::ALL, Format::name)?;
        pasu::write(&source::design(source)?, format, &fields::making(making)?)
    };
    Ok(Uint8Array::from(written().map_err(|error| thrown(&error))?.as_slice()))
}

/// What is made, to be drawn: `{ positions, normals, indices, faces, scale }`.
///
/// # Errors
/// As [`write`].
#[wasm_bindgen]
pub fn solid(source: &JsValue, making: &JsValue) -> Result<Object, JsValue> {
    let drawn = || pasu::drawn(&source::design(source)?, &fields::making(making)?);
    let drawn = drawn().map_err(|error| thrown(&error))?;
    let faces = Array::new();
    for face in &drawn.faces {
        let object = Object::new();
        set(&object, "kind", face.kind.name().into())?;
        set(&object, "part", (face.part as f64).into())?;
        set(&object, "first", (face.first as f64).into())?;
        set(&object, "count", (face.count as f64).into())?;
        faces.push(&object);
    }
    let scale = Object::new();
    set(&scale, "size", drawn.scale.size.into())?;
    set(&scale, "shrinkage", drawn.scale.shrinkage.into())?;
    set(&scale, "millimetres", drawn.scale.millimetres.into())?;
    let object = Object::new();
    set(&object, "positions", Float32Array::from(drawn.positions.as_slice()).into())?;
    set(&object, "normals", Float32Array::from(drawn.normals.as_slice()).into())?;
    set(&object, "indices", Uint32Array::from(drawn.indices.as_slice()).into())?;
    set(&object, "faces", faces.into())?;
    set(&object, "scale", scale.into())?;
    Ok(object)
}

/// The link in a file of Pasu's; `undefined` for every other.
///
/// # Errors
/// When these are not bytes.
#[wasm_bindgen]
pub fn open(bytes: &JsValue) -> Result<Option<String>, JsValue> {
    let Some(bytes) = bytes.dyn_ref::<Uint8Array>() else {
        let error = pasu::Error::new(pasu::Code::WrongType, "bytes", "expected the bytes of a file, a Uint8Array");
        return Err(thrown(&error));
    };
    Ok(pasu::open(&bytes.to_vec()))
}
