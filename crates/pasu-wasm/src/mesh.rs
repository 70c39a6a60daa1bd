//! A mesh as an object of typed arrays, which are the caller's own copies.

use js_sys::{Float32Array, Object, Reflect, Uint32Array};
use pasu::Mesh;
use wasm_bindgen::JsValue;

/// `{ positions, normals, uvs, indices, groups }`.
pub(crate) fn object(mesh: &Mesh) -> Result<Object, JsValue> {
    let object = Object::new();
    set(&object, "positions", Float32Array::from(mesh.positions.as_slice()).into())?;
    set(&object, "normals", Float32Array::from(mesh.normals.as_slice()).into())?;
    set(&object, "uvs", Float32Array::from(mesh.uvs.as_slice()).into())?;
    set(&object, "indices", Uint32Array::from(mesh.indices.as_slice()).into())?;
    set(&object, "groups", Uint32Array::from(mesh.groups.as_slice()).into())?;
    Ok(object)
}

/// Sets a field of an object.
pub(crate) fn set(object: &Object, key: &str, value: JsValue) -> Result<(), JsValue> {
    Reflect::set(object, &key.into(), &value).map(|_| ())
}
