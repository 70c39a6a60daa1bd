//! Pots for the screen, again and again, into the same arrays.

use js_sys::{Array, Float32Array, Object, Uint32Array};
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::making::faces;
use crate::mesh::{field, set};
use crate::{fields, source};

/// New arrays have room for so much more than is needed, because the next sketch may need a little more.
const ROOM: f64 = 1.25;

/// What [`solid`](crate::solid) draws, quickly, without the surface of the design: `{ positions, normals, indices, faces, water }`.
///
/// The arrays of `into` that are long enough are written over, and what is handed back are views of their beginnings.
///
/// # Errors
/// When the source is not a design, an option is not understood, or the design cannot be made.
#[wasm_bindgen]
pub fn sketch(source: &JsValue, options: &JsValue, into: &JsValue) -> Result<Object, JsValue> {
    let sketched = || pasu::sketch(&source::design(source)?, &fields::sketching(options)?);
    let sketch = sketched().map_err(|error| thrown(&error))?;
    let object = Object::new();
    set(&object, "positions", floats(&sketch.positions, &field(into, "positions")).into())?;
    set(&object, "normals", floats(&sketch.normals, &field(into, "normals")).into())?;
    set(&object, "indices", integers(&sketch.indices, &field(into, "indices")).into())?;
    set(&object, "faces", faces(&sketch.faces)?.into())?;
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

/// The length of a new array for so many numbers: one of whole triples, also of the array of fours beside it.
fn room(length: usize) -> u32 {
    ((ROOM * length as f64) as u32 / 12 + 1) * 12
}

fn floats(values: &[f32], into: &JsValue) -> Float32Array {
    let length = values.len() as u32;
    let array = match into.dyn_ref::<Float32Array>() {
        Some(array) if array.length() >= length => array.clone(),
        _ => Float32Array::new_with_length(room(values.len())),
    };
    let view = array.subarray(0, length);
    view.copy_from(values);
    view
}

fn integers(values: &[u32], into: &JsValue) -> Uint32Array {
    let length = values.len() as u32;
    let array = match into.dyn_ref::<Uint32Array>() {
        Some(array) if array.length() >= length => array.clone(),
        _ => Uint32Array::new_with_length(room(values.len())),
    };
    let view = array.subarray(0, length);
    view.copy_from(values);
    view
}
