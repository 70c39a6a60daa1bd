//! JavaScript values as `pasu`'s tree of plain data, with the path of whatever is not plain data.

use js_sys::{Array, Float32Array, Float64Array, Object, Reflect};
use pasu::{Code, Error, Result, Value};
use wasm_bindgen::{JsCast, JsValue};

/// How deep an object may nest. A design nests nine deep; an object that contains itself has no bottom.
const DEEPEST: usize = 64;

/// How many values an object may hold. A design of 1 MiB of JSON holds fewer: each takes two bytes at least.
const MOST: usize = 1 << 19;

/// Reads a value. `undefined` becomes `null`, which counts as absent.
pub(crate) fn read(value: &JsValue) -> Result<Value> {
    Reader { left: MOST }.value(value, &Place::Start)
}

/// Where a value stands, built on the stack and written out only when something is wrong.
enum Place<'a> {
    Start,
    Field(&'a Place<'a>, &'a str),
    Item(&'a Place<'a>, usize),
}

impl Place<'_> {
    fn depth(&self) -> usize {
        match self {
            Place::Start => 0,
            Place::Field(parent, _) | Place::Item(parent, _) => 1 + parent.depth(),
        }
    }

    fn text(&self) -> String {
        match self {
            Place::Start => String::new(),
            Place::Field(Place::Start, name) => (*name).to_owned(),
            Place::Field(parent, name) => format!("{}.{name}", parent.text()),
            Place::Item(parent, index) => format!("{}[{index}]", parent.text()),
        }
    }
}

struct Reader {
    /// How many more values may come.
    left: usize,
}

impl Reader {
    fn value(&mut self, value: &JsValue, place: &Place) -> Result<Value> {
        if place.depth() > DEEPEST {
            let message = format!("expected at most {DEEPEST} levels; an object that contains itself has no end");
            return Err(Error::new(Code::TooLarge, "", message));
        }
        self.left = self
            .left
            .checked_sub(1)
            .ok_or_else(|| Error::new(Code::TooLarge, "", format!("expected at most {MOST} values in one design")))?;
        if value.is_undefined() || value.is_null() {
            Ok(Value::Null)
        } else if let Some(truth) = value.as_bool() {
            Ok(Value::Bool(truth))
        } else if let Some(number) = value.as_f64() {
            Ok(Value::Number(number))
        } else if let Some(text) = value.as_string() {
            Ok(Value::Text(text))
        } else if let Some(array) = value.dyn_ref::<Float64Array>() {
            Ok(Value::List(array.to_vec().into_iter().map(Value::Number).collect()))
        } else if let Some(array) = value.dyn_ref::<Float32Array>() {
            Ok(Value::List(array.to_vec().into_iter().map(|number| Value::Number(number.into())).collect()))
        } else if Array::is_array(value) {
            self.list(value.unchecked_ref(), place)
        } else if value.is_function() || !value.is_object() {
            let kind = value.js_typeof().as_string().unwrap_or_default();
            let message = format!("expected plain data (numbers, texts, lists and objects of them), found a {kind}");
            Err(Error::new(Code::WrongType, place.text(), message))
        } else {
            self.record(value.unchecked_ref(), place)
        }
    }

    fn list(&mut self, array: &Array, place: &Place) -> Result<Value> {
        // The length of a sparse array is no measure of what it holds.
        let length = array.length() as usize;
        if length > self.left {
            let message = format!("expected at most {MOST} values in one design, found a list of {length}");
            return Err(Error::new(Code::TooLarge, place.text(), message));
        }
        let mut items = Vec::with_capacity(length);
        for index in 0..array.length() {
            let place = Place::Item(place, index as usize);
            let item = Reflect::get_u32(array, index).map_err(|thrown| unreadable(&place, thrown))?;
            items.push(self.value(&item, &place)?);
        }
        Ok(Value::List(items))
    }

    fn record(&mut self, object: &Object, place: &Place) -> Result<Value> {
        let keys = Object::keys(object);
        let mut fields = Vec::with_capacity(keys.length() as usize);
        for key in keys.iter() {
            let name = key.as_string().unwrap_or_default();
            let place = Place::Field(place, &name);
            let field = Reflect::get(object, &key).map_err(|thrown| unreadable(&place, thrown))?;
            let field = self.value(&field, &place)?;
            fields.push((name, field));
        }
        Ok(Value::Record(fields))
    }
}

/// What a getter of the caller threw, or a proxy, is the caller's; that the stack has run out is not, and goes on as it came.
fn unreadable(place: &Place, thrown: JsValue) -> Error {
    if is_overflow(&thrown) {
        wasm_bindgen::throw_val(thrown);
    }
    Error::new(Code::WrongType, place.text(), "expected plain data, found a field that cannot be read")
}

/// Whether this is what an engine throws when the stack has run out: a `RangeError` of V8 and JavaScriptCore, an `InternalError` of SpiderMonkey.
fn is_overflow(thrown: &JsValue) -> bool {
    match Reflect::get(thrown, &"message".into()) {
        Ok(message) => message
            .as_string()
            .is_some_and(|text| text.starts_with("Maximum call stack size") || text == "too much recursion"),
        // Not even this can be read.
        Err(_) => thrown.is_object(),
    }
}
