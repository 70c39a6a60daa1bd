//! What is no pot of rings, as one.

use js_sys::{Array, Float32Array, Float64Array, Object};
use pasu::{Code, Error, FittedLevels, Levels, Profile, Result, Ringed, Scan, Scanned};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::mesh::set;
use crate::{plain_object, points, scan, source};

/// `{ right, left }`. Which lines can be drawn is `pasu`'s to say.
#[derive(Deserialize)]
#[serde(expecting = "an object with right")]
struct ProfileFields {
    right: Vec<f64>,
    left: Option<Vec<f64>>,
}

/// `{ tolerance }`.
#[derive(Deserialize)]
#[serde(expecting = "an object with tolerance")]
struct FitOptions {
    tolerance: f64,
}

fn freed_by(source: &JsValue, part: &JsValue, options: &JsValue) -> Result<Ringed> {
    let design = source::design(source)?;
    let FitOptions { tolerance } = source::argument(options, "options")?;
    pasu::free(&design, points::part(part)?, tolerance)
}

/// A profile has sides, a scan has positions, and levels have heights.
fn fitted_by(from: &JsValue, options: &JsValue) -> core::result::Result<JsValue, JsValue> {
    if let Some(levels) = scan::levels(from).map_err(|error| thrown(&error))? {
        let FittedLevels { scanned, away, .. } = by_levels(&levels, options).map_err(|error| thrown(&error))?;
        let object = plain_object(&scanned)?;
        set(&object.clone().into(), "away", Float32Array::from(away.as_slice()).into())?;
        return Ok(object);
    }
    let scan = scan::read(from).map_err(|error| thrown(&error))?;
    match scan {
        Some(scan) => plain_object(&scanned_by(&scan, options).map_err(|error| thrown(&error))?),
        None => plain_object(&drawn_by(from, options).map_err(|error| thrown(&error))?),
    }
}

fn scanned_by(scan: &Scan, options: &JsValue) -> Result<Scanned> {
    let FitOptions { tolerance } = source::argument(options, "options")?;
    pasu::fit_scan(scan, tolerance)
}

fn by_levels(levels: &Levels, options: &JsValue) -> Result<FittedLevels> {
    let FitOptions { tolerance } = source::argument(options, "options")?;
    pasu::fit_levels(levels, tolerance)
}

fn levels_by(from: &JsValue) -> Result<Levels> {
    let nothing = || Error::new(Code::WrongType, "positions", "expected a Float32Array");
    pasu::levels(&scan::read(from)?.ok_or_else(nothing)?)
}

fn drawn_by(profile: &JsValue, options: &JsValue) -> Result<Ringed> {
    let ProfileFields { right, left } = source::argument(profile, "profile")?;
    let FitOptions { tolerance } = source::argument(options, "options")?;
    let mut profile = Profile::new(right);
    profile.left = left;
    pasu::fit(&profile, tolerance)
}

/// The design with a part as a pot of rings, and how far that is from what it was: `{ design, distance }`.
///
/// # Errors
/// When the source is no design, the part does not exist, or rings cannot say it.
#[wasm_bindgen]
pub fn free(source: &JsValue, part: &JsValue, options: &JsValue) -> core::result::Result<JsValue, JsValue> {
    plain_object(&freed_by(source, part, options).map_err(|error| thrown(&error))?)
}

/// A pot of rings with a drawn profile, or through a scan, and how far it is from that: `{ design, distance }`, of a scan also `rms` and `withoutHandle`.
///
/// # Errors
/// When the profile is no line, the scan no pot that stands upright, or rings cannot follow it.
#[wasm_bindgen]
pub fn fit(from: &JsValue, options: &JsValue) -> core::result::Result<JsValue, JsValue> {
    fitted_by(from, options)
}

/// The outside of a scan, level by level: `{ axis, bottom, height, heights, radii }`.
///
/// # Errors
/// When the scan is no pot that stands upright.
#[wasm_bindgen]
pub fn levels(from: &JsValue) -> core::result::Result<Object, JsValue> {
    let Levels { axis, bottom, height, heights, radii, holes, .. } = levels_by(from).map_err(|error| thrown(&error))?;
    let object = Object::new();
    set(&object, "axis", Array::of2(&axis[0].into(), &axis[1].into()).into())?;
    set(&object, "bottom", bottom.into())?;
    set(&object, "height", height.into())?;
    set(&object, "heights", Float64Array::from(heights.as_slice()).into())?;
    let sections: Array = radii.iter().map(|section| Float64Array::from(section.as_slice())).collect();
    set(&object, "radii", sections.into())?;
    set(&object, "holes", holes.into())?;
    Ok(object)
}
