//! Calls that tell JavaScript how far they are.

use core::ops::ControlFlow;

use js_sys::{Date, Function};
use pasu::{Code, Error};
use wasm_bindgen::prelude::*;

use crate::error::thrown;

/// Milliseconds between two words to JavaScript: what it does with them may take longer than what is told.
const BETWEEN: f64 = 20.0;

/// What `call` returns or throws, which calls this module itself; meanwhile `progress` is told how far it is, and ends it by `false`.
///
/// # Errors
/// What `call` throws; `cancelled` where `progress` returned `false`, or threw.
#[wasm_bindgen]
pub fn watched(progress: &Function, call: &Function) -> Result<JsValue, JsValue> {
    let mut refusal = None;
    let called = || {
        call.call0(&JsValue::UNDEFINED).map_err(|error| {
            refusal = Some(error);
            // What it says is what was thrown.
            Error::new(Code::Bug, "", "")
        })
    };
    let answer = pasu::watched(listener(progress.clone()), called);
    answer.map_err(|error| match refusal {
        Some(refusal) if error.code() != Code::Cancelled => refusal,
        _ => thrown(&error),
    })
}

fn listener(progress: Function) -> impl FnMut(f64) -> ControlFlow<()> {
    let mut last = f64::NEG_INFINITY;
    move |done| {
        let now = Date::now();
        // A clock may be set back.
        if done < 1.0 && (0.0..BETWEEN).contains(&(now - last)) {
            return ControlFlow::Continue(());
        }
        last = now;
        match progress.call1(&JsValue::UNDEFINED, &done.into()) {
            Ok(answer) if answer != JsValue::FALSE => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        }
    }
}
