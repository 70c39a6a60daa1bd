//! JavaScript values as plain data for `serde`.
//!
//! What a getter, a proxy or a detached array of the caller throws must not leave this module from its middle: it would look like a mistake of ours and cost the instance.
//! So everything that can throw is imported to be caught, and what is caught is a refusal with the path of what could not be read.

use js_sys::{Array, Float32Array, Float64Array, Reflect};
use pasu::{Code, Error, Result};
use serde::de::value::SeqDeserializer;
use serde::de::{DeserializeSeed, Deserializer, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::forward_to_deserialize_any;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Throws of a revoked proxy.
    #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
    fn is_array(value: &JsValue) -> core::result::Result<bool, JsValue>;

    /// Throws what a proxy throws.
    #[wasm_bindgen(catch, js_namespace = Object, js_name = keys)]
    fn keys(object: &JsValue) -> core::result::Result<Array, JsValue>;

    #[wasm_bindgen(extends = Float64Array, js_name = Float64Array)]
    type Numbers;

    /// Throws of an array whose buffer was transferred, and of a proxy of an array.
    #[wasm_bindgen(catch, constructor, js_class = "Float64Array")]
    fn new(array: &JsValue) -> core::result::Result<Numbers, JsValue>;
}

/// A value to be read: lists and objects here, everything within them by `serde_wasm_bindgen`.
///
/// That library takes an object apart by `Object.entries` and a list by its iterator, and catches nothing of what these throw. It reads a `Float64Array` as an object with the fields `"0"`, `"1"`, and so on.
pub(crate) struct Plain(pub(crate) JsValue);

impl<'de> Deserializer<'de> for Plain {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value> {
        let Plain(value) = self;
        if !value.is_object() {
            #[cfg(feature = "making")]
            if value.is_string() {
                text(&value)?;
            }
            let leaf = serde_wasm_bindgen::Deserializer::from(value.clone());
            leaf.deserialize_any(visitor).map_err(|_| not_plain(&value))
        } else if let Some(numbers) = numbers(&value)? {
            no_longer_than_any(numbers.length())?;
            visitor.visit_seq(SeqDeserializer::new(numbers.to_vec().into_iter()))
        } else if is_array(&value).map_err(unreadable)? {
            visitor.visit_seq(Items::of(value)?)
        } else {
            let keys = keys(&value).map_err(unreadable)?;
            visitor.visit_map(Fields { object: value, keys, index: 0, key: JsValue::UNDEFINED })
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

/// A text, letter by letter; `None` for everything else. The module for drawing reads half a letter as any page does, as U+FFFD: it keeps nothing of what it reads.
///
/// # Errors
/// For half a surrogate pair, which JavaScript has in texts and nobody else: read as usual it would become another letter.
pub(crate) fn text(value: &JsValue) -> Result<Option<String>> {
    let text = value.as_string();
    #[cfg(feature = "making")]
    if text.as_ref().is_some_and(|text| JsValue::from_str(text) != *value) {
        let message = "expected text, found half of a letter in it: a surrogate without its other half";
        return Err(Error::new(Code::WrongType, "", message));
    }
    Ok(text)
}

/// More numbers than any list of a design may have: a typed array is copied into the memory of the module as a whole, before anybody looks at it.
const MOST_NUMBERS: u32 = 1 << 20;

fn no_longer_than_any(length: u32) -> Result<()> {
    if length <= MOST_NUMBERS {
        return Ok(());
    }
    let message = format!("expected at most {MOST_NUMBERS} numbers in a list, found {length}");
    let error = Error::new(Code::TooLarge, "", message).with("greatest", f64::from(MOST_NUMBERS));
    Err(error.with("found", f64::from(length)))
}

/// The numbers of a typed array, as a copy that nobody else can take away; `None` for everything else.
pub(crate) fn numbers(value: &JsValue) -> Result<Option<Float64Array>> {
    if !(value.is_instance_of::<Float64Array>() || value.is_instance_of::<Float32Array>()) {
        return Ok(None);
    }
    Ok(Some(Numbers::new(value).map_err(unreadable)?.into()))
}

/// The items of a list, or of a proxy of one.
pub(crate) struct Items {
    list: JsValue,
    length: u32,
    index: u32,
}

impl Items {
    /// The items of a list; `None` in place of what is none.
    pub(crate) fn if_list(value: &JsValue) -> Result<Option<Items>> {
        is_array(value).map_err(unreadable)?.then(|| Items::of(value.clone())).transpose()
    }

    /// How many are left.
    #[cfg(feature = "making")]
    pub(crate) fn len(&self) -> u32 {
        self.length - self.index
    }

    fn of(list: JsValue) -> Result<Items> {
        let length = Reflect::get(&list, &"length".into()).map_err(unreadable)?;
        Ok(Items { list, length: length.as_f64().unwrap_or_default() as u32, index: 0 })
    }
}

impl Iterator for Items {
    /// An item, or what the caller threw when it was asked for.
    type Item = core::result::Result<JsValue, JsValue>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.index == self.length {
            return None;
        }
        let item = Reflect::get_u32(&self.list, self.index);
        self.index += 1;
        Some(item)
    }
}

impl<'de> SeqAccess<'de> for Items {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>> {
        self.next().map(|item| within(item, seed)).transpose()
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

/// What a getter or a proxy of the caller threw, or an array without memory, is the caller's; that the stack has run out is not, and goes on as it came.
pub(crate) fn unreadable(thrown: JsValue) -> Error {
    if is_overflow(&thrown) {
        wasm_bindgen::throw_val(thrown);
    }
    let message = "expected plain data, found something that cannot be read: a detached array, a revoked proxy, or a getter that throws";
    Error::new(Code::WrongType, "", message)
}

/// Whether this is what an engine throws when the stack has run out: a `RangeError` of V8 and JavaScriptCore, an `InternalError` of SpiderMonkey.
fn is_overflow(thrown: &JsValue) -> bool {
    let message = |of: &JsValue| Reflect::get(of, &"message".into());
    // Of a revoked proxy that was thrown nothing can be read, but of what is thrown when it is tried; where the stack has run out, of neither.
    match message(thrown).or_else(|second| message(&second)) {
        Ok(message) => message
            .as_string()
            .is_some_and(|text| text.starts_with("Maximum call stack size") || text == "too much recursion"),
        Err(_) => true,
    }
}
