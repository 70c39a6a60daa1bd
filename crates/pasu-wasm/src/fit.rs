//! What is no pot of rings, as one.

use pasu::{Profile, Result, Ringed, Scan, Scanned};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::thrown;
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

/// A profile has sides, a scan has positions.
fn fitted_by(from: &JsValue, options: &JsValue) -> core::result::Result<JsValue, JsValue> {
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
