//! The inside of solids: cells for analysis, and what is known of how well it solves its equation.

use js_sys::{Array, Float64Array, Object, Uint8Array, Uint32Array};
use pasu::{CellShape, CellsFormat, CellsOptions, InsideMap, Result};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::mesh::set;
use crate::options::Count;
use crate::{fields, points, source};

#[derive(Deserialize, Default)]
#[serde(expecting = "an object of options")]
struct Options {
    counts: Option<[Count; 3]>,
    shape: Option<ShapeName>,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum ShapeName {
    Hexahedron,
    Tetrahedron,
}

/// Reads `{ counts, shape }`; all of it may be left out.
fn options(options: &JsValue) -> Result<CellsOptions> {
    let given: Option<Options> = source::argument(options, "options")?;
    let Options { counts, shape } = given.unwrap_or_default();
    let usual = CellsOptions::default();
    let shape = shape.map_or(usual.shape, |shape| match shape {
        ShapeName::Hexahedron => CellShape::Hexahedron,
        ShapeName::Tetrahedron => CellShape::Tetrahedron,
    });
    let counts = counts.map_or(usual.counts, |counts| counts.map(|Count(count)| count));
    Ok(CellsOptions { counts, shape })
}

/// The inside of a part as cells: `{ positions, corners, quality, shape }`.
///
/// # Errors
/// When the source is not a design, an option is not understood, or the part is no solid with an inside that is known.
#[wasm_bindgen]
pub fn cells(source: &JsValue, part: &JsValue, given: &JsValue) -> core::result::Result<Object, JsValue> {
    let cut = || source::solution(source)?.cells(points::part(part)?, &options(given)?);
    let cells = cut().map_err(|error| thrown(&error))?;
    let object = Object::new();
    set(&object, "positions", Float64Array::from(cells.positions.as_slice()).into())?;
    set(&object, "corners", Uint32Array::from(cells.corners.as_slice()).into())?;
    set(&object, "quality", Float64Array::from(cells.quality.as_slice()).into())?;
    set(&object, "shape", cells.shape.name().into())?;
    Ok(object)
}

/// The same as the bytes of a file.
///
/// # Errors
/// As [`cells`], and when the format is not understood.
#[wasm_bindgen(js_name = cellsFile)]
pub fn cells_file(
    source: &JsValue,
    part: &JsValue,
    format: &JsValue,
    given: &JsValue,
) -> core::result::Result<Uint8Array, JsValue> {
    let written = || {
        let format = fields::one_of(format, "format", &CellsFormat::ALL, CellsFormat::name)?;
        source::solution(source)?.cells_file(points::part(part)?, &options(given)?, format)
    };
    Ok(Uint8Array::from(written().map_err(|error| thrown(&error))?.as_slice()))
}

/// How well the inside of a part solves its equation: `{ residual, residualAt, residualRms, jacobian, jacobianAt, jacobianMean, isFolded }`.
///
/// # Errors
/// When the source is not a design, or the part has no inside that is known.
#[wasm_bindgen]
pub fn inside(source: &JsValue, part: &JsValue) -> core::result::Result<Object, JsValue> {
    let found = || source::solution(source)?.inside(points::part(part)?);
    let inside = found().map_err(|error| thrown(&error))?;
    let place = |at: [f64; 3]| at.iter().map(|x| JsValue::from(*x)).collect::<Array>().into();
    let object = Object::new();
    set(&object, "residual", inside.residual.into())?;
    set(&object, "residualAt", place(inside.residual_at))?;
    set(&object, "residualRms", inside.residual_rms.into())?;
    set(&object, "jacobian", inside.jacobian.into())?;
    set(&object, "jacobianAt", place(inside.jacobian_at))?;
    set(&object, "jacobianMean", inside.jacobian_mean.into())?;
    set(&object, "isFolded", inside.is_folded().into())?;
    Ok(object)
}

/// The values of a map at triples `(u, v, w)`.
///
/// # Errors
/// As [`inside`], and when the map or the points are not understood.
#[wasm_bindgen(js_name = insideValues)]
pub fn inside_values(
    source: &JsValue,
    part: &JsValue,
    map: &JsValue,
    at: &JsValue,
) -> core::result::Result<Float64Array, JsValue> {
    let found = || {
        let map = fields::one_of(map, "map", &InsideMap::ALL, InsideMap::name)?;
        source::solution(source)?.inside_values(points::part(part)?, map, &points::read(at)?)
    };
    Ok(Float64Array::from(found().map_err(|error| thrown(&error))?.as_slice()))
}
