//! JavaScript values as plain data for `serde`.

use js_sys::{Array, Float32Array, Float64Array, Object, Reflect};
use pasu::{Code, Error, Result};
use serde::de::value::SeqDeserializer;
use serde::de::{DeserializeSeed, Deserializer, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::forward_to_deserialize_any;
use wasm_bindgen::{JsCast, JsValue};

/// A value to be read: lists and objects here, everything within them by `serde_wasm_bindgen`.
///
/// That library takes an object apart by `Object.entries` and a list by its iterator, and catches nothing: what a getter or a proxy of the caller throws would leave
/// this module from its middle, which looks like a mistake of ours and costs the instance. It reads a `Float64Array` as an object with the fields `"0"`, `"1"`, and so on.
pub(crate) struct Plain(pub(crate) JsValue);

impl<'de> Deserializer<'de> for Plain {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        let Plain(value) = self;
        if !value.is_object() {
            let leaf = serde_wasm_bindgen::Deserializer::from(value.clone());
            return leaf.deserialize_any(visitor).map_err(|_| not_plain(&value));
        }
        if let Some(array) = value.dyn_ref::<Float64Array>() {
            no_longer_than_text(array.length())?;
            visitor.visit_seq(SeqDeserializer::new(array.to_vec().into_iter()))
        } else if let Some(array) = value.dyn_ref::<Float32Array>() {
            no_longer_than_text(array.length())?;
            visitor.visit_seq(SeqDeserializer::new(array.to_vec().into_iter()))
        } else if Array::is_array(&value) {
            visitor.visit_seq(Items { array: value.unchecked_into(), index: 0 })
        } else if value.is_function() {
            Err(not_plain(&value))
        } else {
            let keys = Object::keys(value.unchecked_ref::<Object>());
            visitor.visit_map(Fields { object: value, keys, index: 0, key: JsValue::UNDEFINED })
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

/// As many numbers as the longest JSON text could hold: a typed array is copied into the memory of the module as a whole, before anybody looks at it.
const MOST_NUMBERS: u32 = 1 << 20;

fn no_longer_than_text(length: u32) -> Result<()> {
    if length <= MOST_NUMBERS {
        return Ok(());
    }
    let message = format!("expected at most {MOST_NUMBERS} numbers in a list, found {length}");
    let error = Error::new(Code::TooLarge, "", message).with("greatest", f64::from(MOST_NUMBERS));
    Err(error.with("found", f64::from(length)))
}

struct Items {
    array: Array,
    index: u32,
}

impl<'de> SeqAccess<'de> for Items {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>> {
        if self.index == self.array.length() {
            return Ok(None);
        }
        let item = Reflect::get_u32(&self.array, self.index);
        self.index += 1;
        within(item, seed).map(Some)
    }
}

struct Fields {
    object: JsValue,
    keys: Array,
    index: u32,
    key: JsValue,
}

impl<'de> MapAccess<'de> for Fields {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>> {
        if self.index == self.keys.length() {
            return Ok(None);
        }
        self.key = self.keys.get(self.index);
        self.index += 1;
        seed.deserialize(self.key.as_string().unwrap_or_default().into_deserializer()).map(Some)
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value> {
        within(Reflect::get(&self.object, &self.key), seed)
    }
}

/// Reads an item or a field. One that cannot be had is refused as what is being read, so that its place is known, and not as the list or object that it is in.
fn within<'de, T: DeserializeSeed<'de>>(found: core::result::Result<JsValue, JsValue>, seed: T) -> Result<T::Value> {
    match found {
        Ok(value) => seed.deserialize(Plain(value)),
        Err(thrown) => seed.deserialize(Unreadable(thrown)),
    }
}

/// In place of a value: what the caller threw when it was asked for.
struct Unreadable(JsValue);

impl<'de> Deserializer<'de> for Unreadable {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value> {
        Err(unreadable(self.0))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

fn not_plain(value: &JsValue) -> Error {
    let kind = value.js_typeof().as_string().unwrap_or_default();
    let message = format!("expected plain data (numbers, texts, lists and objects of them), found a {kind}");
    Error::new(Code::WrongType, "", message)
}

/// What a getter of the caller threw, or a proxy, is the caller's; that the stack has run out is not, and goes on as it came.
fn unreadable(thrown: JsValue) -> Error {
    if is_overflow(&thrown) {
        wasm_bindgen::throw_val(thrown);
    }
    Error::new(Code::WrongType, "", "expected plain data, found a field that cannot be read")
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
