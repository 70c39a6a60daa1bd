//! Errors on their way to JavaScript.

use js_sys::{Array, Object, Reflect};
use pasu::{Arg, Code};
use wasm_bindgen::prelude::*;

/// The name by which the wrapper recognises what was thrown from here.
const NAME: &str = "PasuError";

/// A refusal as a JavaScript error with `code`, `path`, `args` and, where it went wrong at a point of space, `place`.
pub(crate) fn thrown(error: &pasu::Error) -> JsValue {
    let thrown = js_error(error.code(), error.path(), error.message());
    let args = Object::new();
    for (name, arg) in error.args() {
        set(&args, name, &js_arg(arg));
    }
    set(&thrown, "args", &args);
    if let Some(place) = error.place() {
        set(&thrown, "place", &Array::from_iter(place.map(JsValue::from)));
    }
    thrown.into()
}

/// Makes a panic leave the module as an error with the code `bug` in place of a bare trap.
pub(crate) fn install_panic_hook() {
    std::panic::set_hook(Box::new(|panic| {
        // Beside the stack that led to it, which the error loses on its way through a worker.
        web_sys::console::error_1(&panic.to_string().into());
        let message = format!("Pasu made a mistake of its own; please report it together with the design. ({panic})");
        wasm_bindgen::throw_val(js_error(Code::Bug, "", &message).into());
    }));
}

fn js_error(code: Code, path: &str, message: &str) -> js_sys::Error {
    let error = js_sys::Error::new(message);
    error.set_name(NAME);
    set(&error, "code", &code.as_str().into());
    set(&error, "path", &path.into());
    error
}

fn js_arg(arg: &Arg) -> JsValue {
    match arg {
        Arg::Number(number) => (*number).into(),
        Arg::Text(text) => text.into(),
        Arg::Words(words) => Array::from_iter(words.iter().map(JsValue::from)).into(),
        // A kind of argument that these bindings do not know yet: the sentence has it.
        _ => JsValue::UNDEFINED,
    }
}

/// Setting a field of an object that was made a line above can fail only where the stack has run out.
fn set(object: &JsValue, key: &str, value: &JsValue) {
    if let Err(overflow) = Reflect::set(object, &key.into(), value) {
        wasm_bindgen::throw_val(overflow);
    }
}
