//! Scans as JavaScript hands them over: triangles, and the levels that were made of them.

use js_sys::{Float32Array, Reflect, Uint32Array};
use pasu::{Code, Error, Levels, Result, Scan};
use wasm_bindgen::prelude::*;

use crate::plain::{self, Items};
use crate::source;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(extends = Uint32Array, js_name = Uint32Array)]
    type Counts;

    /// Throws of an array whose buffer was transferred, and of a proxy of an array.
    #[wasm_bindgen(catch, constructor, js_class = "Uint32Array")]
    fn new(array: &JsValue) -> core::result::Result<Counts, JsValue>;
}

/// The scan that an object is; nothing where it has no `positions`.
pub(crate) fn read(from: &JsValue) -> Result<Option<Scan>> {
    let Some(positions) = field(from, "positions")? else { return Ok(None) };
    let mut scan = Scan::new(coordinates(&positions).map_err(|error| error.at("positions"))?);
    scan.indices = match field(from, "indices")? {
        Some(indices) => Some(counts(&indices).map_err(|error| error.at("indices"))?),
        None => None,
    };
    Ok(Some(scan))
}

/// The levels that an object is; nothing where it has no `heights`. Where they lie may be left out.
pub(crate) fn levels(from: &JsValue) -> Result<Option<Levels>> {
    let Some(heights) = field(from, "heights")? else { return Ok(None) };
    let heights = distances(&heights, Levels::MOST).map_err(|error| error.at("heights"))?;
    let radii = field(from, "radii")?.unwrap_or_default();
    let sections = sections(&radii)?;
    let mut levels = Levels::new(heights, sections);
    if let Some(axis) = field(from, "axis")? {
        levels.axis = source::argument(&axis, "axis")?;
    }
    if let Some(bottom) = field(from, "bottom")? {
        levels.bottom = source::argument(&bottom, "bottom")?;
    }
    Ok(Some(levels))
}

/// Of each level the distances from the axis.
fn sections(value: &JsValue) -> Result<Vec<Vec<f64>>> {
    let Some(items) = Items::if_list(value).map_err(|error| error.at("radii"))? else {
        return Err(Error::new(Code::WrongType, "radii", "expected a list of Float64Arrays"));
    };
    no_longer_than(items.len(), Levels::MOST as u32).map_err(|error| error.at("radii"))?;
    let read = |(i, item): (usize, core::result::Result<JsValue, JsValue>)| {
        let section = item.map_err(plain::unreadable).and_then(|item| distances(&item, Levels::DIRECTIONS));
        section.map_err(|error| error.at(format!("radii[{i}]")))
    };
    items.enumerate().map(read).collect()
}

/// A typed array of no more than so many numbers.
fn distances(value: &JsValue, most: usize) -> Result<Vec<f64>> {
    let Some(numbers) = plain::numbers(value)? else {
        return Err(Error::new(Code::WrongType, "", "expected a Float64Array"));
    };
    no_longer_than(numbers.length(), most as u32)?;
    Ok(numbers.to_vec())
}

/// What an object has under a name; nothing where that is undefined, and of what is no object.
fn field(object: &JsValue, name: &str) -> Result<Option<JsValue>> {
    if !object.is_object() {
        return Ok(None);
    }
    let value = Reflect::get(object, &name.into()).map_err(|thrown| plain::unreadable(thrown).at(name))?;
    Ok((!value.is_undefined()).then_some(value))
}

/// The most coordinates, or numbers of points, of a scan: nine for each of its triangles. They are copied into the memory of the module before anybody looks at them.
const MOST_OF_A_SCAN: u32 = 36_000_000;

fn no_longer_than(length: u32, most: u32) -> Result<()> {
    if length <= most {
        return Ok(());
    }
    let message = format!("expected at most {most} numbers, found {length}");
    let error = Error::new(Code::TooLarge, "", message).with("greatest", f64::from(most));
    Err(error.with("found", f64::from(length)))
}

/// Coordinates: a typed array of floats.
fn coordinates(value: &JsValue) -> Result<Vec<f32>> {
    let Some(numbers) = plain::numbers(value)? else {
        return Err(Error::new(Code::WrongType, "", "expected a Float32Array"));
    };
    no_longer_than(numbers.length(), MOST_OF_A_SCAN)?;
    Ok(Float32Array::new(&numbers).to_vec())
}

/// Numbers of points: a typed array of unsigned integers.
fn counts(value: &JsValue) -> Result<Vec<u32>> {
    if !value.is_instance_of::<Uint32Array>() {
        return Err(Error::new(Code::WrongType, "", "expected a Uint32Array"));
    }
    let counts: Uint32Array = Counts::new(value).map_err(plain::unreadable)?.into();
    no_longer_than(counts.length(), MOST_OF_A_SCAN)?;
    Ok(counts.to_vec())
}
