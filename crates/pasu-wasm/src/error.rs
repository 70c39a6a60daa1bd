//! Errors on their way to JavaScript.

use wasm_bindgen::prelude::*;

/// The name by which the wrapper recognises what was thrown from here.
const NAME: &str = "PasuError";

/// A refusal as a JavaScript error with `code` and `path`.
pub(crate) fn thrown(error: &pasu::Error) -> JsValue {
    js_error(error.code(), error.path(), error.message())
}

/// Makes a panic leave the module as an error with the code `bug` in place of a bare trap.
pub(crate) fn install_panic_hook() {
    std::panic::set_hook(Box::new(|panic| {
        let message = format!("Pasu made a mistake of its own; please report it together with the design. ({panic})");
        wasm_bindgen::throw_val(js_error("bug", "", &message));
    }));
}

fn js_error(code: &str, path: &str, message: &str) -> JsValue {
    let error = js_sys::Error::new(message);
    error.set_name(NAME);
    for (key, value) in [("code", code), ("path", path)] {
        // Setting a field of an error that was made a line above can fail only where the stack has run out.
        if let Err(overflow) = js_sys::Reflect::set(&error, &key.into(), &value.into()) {
            wasm_bindgen::throw_val(overflow);
        }
    }
    error.into()
}
