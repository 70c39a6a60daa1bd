//! What it takes to make a design, besides drawing it: measures, checks, files.

use js_sys::{Array, Float32Array, Object, Uint8Array, Uint32Array};
use pasu::{DrawnFace, Format, Map};
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::mesh::set;
use crate::{fields, options, plain, plain_object, source};

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(extends = Uint8Array, js_name = Uint8Array)]
    type Bytes;

    /// Throws of an array whose buffer was transferred, and of a proxy of an array.
    #[wasm_bindgen(catch, constructor, js_class = "Uint8Array")]
    fn new(array: &JsValue) -> Result<Bytes, JsValue>;
}

/// What can be measured, as a plain object.
///
/// # Errors
/// When the source is not a design, an option is not understood, or the design cannot be solved.
#[wasm_bindgen]
pub fn measure(source: &JsValue, options: &JsValue) -> Result<JsValue, JsValue> {
    let measured = || source::solution(source)?.measure(&fields::measuring(options)?);
    plain_object(&measured().map_err(|error| thrown(&error))?)
}

/// Whether the design can be made, as a plain object.
///
/// # Errors
/// When the source is not a design or an option is not understood.
#[wasm_bindgen]
pub fn check(source: &JsValue, making: &JsValue) -> Result<JsValue, JsValue> {
    let checked = || source::solution(source)?.check(&fields::making(making)?);
    plain_object(&checked().map_err(|error| thrown(&error))?)
}

/// The bytes of a file.
///
/// # Errors
/// When the source is not a design, the format or an option is not understood, or the design cannot be made.
#[wasm_bindgen]
pub fn write(source: &JsValue, format: &JsValue, making: &JsValue) -> Result<Uint8Array, JsValue> {
    let written = || {
        let format = fields::one_of(format, "format", &Format::ALL, Format::name)?;
        source::solution(source)?.write(format, &fields::making(making)?)
    };
    Ok(Uint8Array::from(written().map_err(|error| thrown(&error))?.as_slice()))
}

/// The file of materials that OBJ files name.
#[wasm_bindgen(js_name = objMaterials)]
pub fn obj_materials() -> String {
    pasu::obj_materials()
}

/// What is made, to be drawn: `{ positions, normals, indices, faces, scale }`.
///
/// # Errors
/// As [`write`].
#[wasm_bindgen]
pub fn solid(source: &JsValue, making: &JsValue) -> Result<Object, JsValue> {
    let drawn = || source::solution(source)?.drawn(&fields::making(making)?);
    let drawn = drawn().map_err(|error| thrown(&error))?;
    let scale = Object::new();
    set(&scale, "size", drawn.scale.size.into())?;
    set(&scale, "shrinkage", drawn.scale.shrinkage.into())?;
    set(&scale, "millimetres", drawn.scale.millimetres.into())?;
    let object = Object::new();
    set(&object, "positions", Float32Array::from(drawn.positions.as_slice()).into())?;
    set(&object, "normals", Float32Array::from(drawn.normals.as_slice()).into())?;
    set(&object, "indices", Uint32Array::from(drawn.indices.as_slice()).into())?;
    set(&object, "faces", faces(&drawn.faces)?.into())?;
    set(&object, "scale", scale.into())?;
    Ok(object)
}

/// `{ kind, part, first, count }` of each face.
pub(crate) fn faces(faces: &[DrawnFace]) -> Result<Array, JsValue> {
    let array = Array::new();
    for face in faces {
        let object = Object::new();
        set(&object, "kind", face.kind.name().into())?;
        set(&object, "part", (face.part as f64).into())?;
        set(&object, "first", (face.first as f64).into())?;
        set(&object, "count", (face.count as f64).into())?;
        array.push(&object);
    }
    Ok(array)
}

/// One value for every vertex of the mesh of the same options: `{ values, least, greatest }`.
///
/// # Errors
/// When the source is not a design, the map or an option is not understood, or the design cannot be solved.
#[wasm_bindgen]
pub fn paint(source: &JsValue, map: &JsValue, options: &JsValue) -> Result<Object, JsValue> {
    let painted = || {
        let map = fields::one_of(map, "map", &Map::ALL, Map::name)?;
        source::solution(source)?.paint(map, &options::read(options)?)
    };
    let values = painted().map_err(|error| thrown(&error))?;
    let object = Object::new();
    let least = values.iter().copied().fold(f32::INFINITY, f32::min);
    let greatest = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    set(&object, "values", Float32Array::from(values.as_slice()).into())?;
    set(&object, "least", least.into())?;
    set(&object, "greatest", greatest.into())?;
    Ok(object)
}

/// Water up to a level: `{ volume, error, area, positions, indices }`.
///
/// # Errors
/// When the source is not a design, the level is above what the design holds, or the design holds nothing.
#[wasm_bindgen]
pub fn water(source: &JsValue, level: &JsValue) -> Result<Object, JsValue> {
    let filled = || source::solution(source)?.water(fields::argument(level, "level")?);
    let water = filled().map_err(|error| thrown(&error))?;
    let object = Object::new();
    set(&object, "volume", water.volume.into())?;
    set(&object, "error", water.error.into())?;
    set(&object, "area", water.area.into())?;
    set(&object, "positions", Float32Array::from(water.positions.as_slice()).into())?;
    set(&object, "indices", Uint32Array::from(water.indices.as_slice()).into())?;
    Ok(object)
}

/// The link in a file of Pasu's; `undefined` for every other.
///
/// # Errors
/// When these are not bytes.
#[wasm_bindgen]
pub fn open(bytes: &JsValue) -> Result<Option<String>, JsValue> {
    Ok(pasu::open(&file(bytes)?))
}

/// The link in a file of Pasu's, and how it was made: `{ link, making }`, of which the making may be null; `undefined` for every other file.
///
/// # Errors
/// When these are not bytes.
#[wasm_bindgen]
pub fn provenance(bytes: &JsValue) -> Result<Option<Object>, JsValue> {
    let Some(found) = pasu::provenance(&file(bytes)?) else { return Ok(None) };
    let object = Object::new();
    set(&object, "link", found.link.into())?;
    let making = found.making.map(|making| fields::made(&making)).transpose()?;
    set(&object, "making", making.map_or(JsValue::NULL, JsValue::from))?;
    Ok(Some(object))
}

/// The bytes of a file.
fn file(bytes: &JsValue) -> Result<Vec<u8>, JsValue> {
    if !bytes.is_instance_of::<Uint8Array>() {
        let error = pasu::Error::new(pasu::Code::WrongType, "bytes", "expected the bytes of a file, a Uint8Array");
        return Err(thrown(&error));
    }
    let bytes = Bytes::new(bytes).map_err(|error| thrown(&plain::unreadable(error).at("bytes")))?;
    Ok(bytes.to_vec())
}
