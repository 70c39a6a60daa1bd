//! A point of a part is pulled.

use js_sys::Object;
use pasu::{Code, Error, Hand, Pulled, Result};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::options::Count;
use crate::{plain_object, points, source};

/// `{ at, to, width, petals, keep }`. What numbers they may be is `pasu`'s to say.
#[derive(Deserialize)]
#[serde(expecting = "an object with at and to")]
struct HandFields {
    at: Vec<f64>,
    to: Vec<f64>,
    width: Option<f64>,
    petals: Option<Count>,
    keep: Option<Vec<String>>,
}

/// So many numbers.
fn coordinates<const N: usize>(list: Vec<f64>, path: &str) -> Result<[f64; N]> {
    let refused = |list: Vec<f64>| {
        let message = format!("expected a list of {N} numbers, found a list of {}", list.len());
        Error::new(Code::WrongType, path, message)
    };
    list.try_into().map_err(refused)
}

fn pulled_by(source: &JsValue, part: &JsValue, hand: &JsValue) -> Result<Pulled> {
    let design = source::design(source)?;
    let HandFields { at, to, width, petals, keep } = source::argument(hand, "hand")?;
    let petals = petals.map(|Count(petals)| u32::try_from(petals).unwrap_or(u32::MAX));
    let mut hand = Hand::new(coordinates(at, "at")?, coordinates(to, "to")?);
    (hand.width, hand.petals, hand.keep) = (width, petals, keep.unwrap_or_default());
    pasu::pull(&design, points::part(part)?, &hand)
}

/// The design with a point of a part pulled somewhere.
///
/// # Errors
/// When the source is no design, the part or the point does not exist, or the hand asks for what there is not.
#[wasm_bindgen]
pub fn pull(source: &JsValue, part: &JsValue, hand: &JsValue) -> core::result::Result<JsValue, JsValue> {
    plain_object(&pulled_by(source, part, hand).map_err(|error| thrown(&error))?.design)
}

/// The same, the point that arrived, and how far it stayed behind: `{ design, at, behind }`.
///
/// # Errors
/// As [`pull`].
#[wasm_bindgen]
pub fn pulled(source: &JsValue, part: &JsValue, hand: &JsValue) -> core::result::Result<Object, JsValue> {
    let pulled = pulled_by(source, part, hand).map_err(|error| thrown(&error))?;
    Ok(plain_object(&pulled)?.into())
}
