//! Pots for the screen, again and again, into the same arrays.

use js_sys::{Array, Float32Array, Object, Uint32Array};
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::into::{Room, floats, integers};
use crate::making::faces;
use crate::mesh::{field, set};
use crate::{fields, source};

/// What [`solid`](crate::solid) draws, quickly, without the surface of the design: `{ positions, normals, indices, faces, water }`.
///
/// The arrays of `into` that are long enough are written over; new ones are views of the beginnings of longer ones, so that the next sketch has room in them.
///
/// # Errors
/// When the source is not a design, an option is not understood, or the design cannot be made.
#[wasm_bindgen]
pub fn sketch(source: &JsValue, options: &JsValue, into: &JsValue) -> Result<Object, JsValue> {
    let sketched = || source::solution(source)?.sketch(&fields::sketching(options)?);
    let sketch = sketched().map_err(|error| thrown(&error))?;
    let object = Object::new();
    set(&object, "positions", floats(&sketch.positions, &field(into, "positions"), Room::Spare).into())?;
    set(&object, "normals", floats(&sketch.normals, &field(into, "normals"), Room::Spare).into())?;
    set(&object, "indices", integers(&sketch.indices, &field(into, "indices"), Room::Spare).into())?;
    set(&object, "faces", faces(&sketch.faces)?.into())?;
    set(&object, "water", JsValue::NULL)?;
    if let Some(water) = &sketch.water {
        let surface = Object::new();
        set(&surface, "level", water.level.into())?;
        set(&surface, "range", water.range.iter().map(|z| JsValue::from(*z)).collect::<Array>().into())?;
        set(&surface, "positions", Float32Array::from(water.positions.as_slice()).into())?;
        set(&surface, "indices", Uint32Array::from(water.indices.as_slice()).into())?;
        set(&object, "water", surface.into())?;
    }
    Ok(object)
}
