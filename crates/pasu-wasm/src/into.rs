//! Arrays of an earlier result, to be written over.
//!
//! One contract for all that take them: an array that is long enough is written over and handed back, as a view of its beginning where it is longer. For one
//! that is too short, or none, or anything else, there is a new one.

use js_sys::{ArrayBuffer, Float32Array, Uint32Array};
use wasm_bindgen::{JsCast, JsValue};

/// How much longer than what is in them new arrays are.
#[derive(Clone, Copy)]
pub(crate) enum Room {
    /// No longer: what comes next is of the same length, or of quite another.
    None,
    /// A quarter and a little, because what comes next may be a little longer.
    #[cfg(feature = "making")]
    Spare,
}

impl Room {
    /// The length of a new array for so many numbers; with room, one of whole triples, also of the array of fours beside it.
    fn length(self, needed: usize) -> u32 {
        match self {
            Room::None => needed as u32,
            #[cfg(feature = "making")]
            Room::Spare => ((1.25 * needed as f64) as u32 / 12 + 1) * 12,
        }
    }
}

macro_rules! written {
    ($(#[$about:meta])* $name:ident, $number:ty, $array:ty) => {
        $(#[$about])*
        pub(crate) fn $name(values: &[$number], given: &JsValue, room: Room) -> $array {
            let length = values.len() as u32;
            let array = match given.dyn_ref::<$array>() {
                // A proxy passes for an array and throws when it is asked for anything.
                Some(array) if ArrayBuffer::is_view(given) && array.length() >= length => array.clone(),
                _ if room.length(values.len()) == length => return <$array>::from(values),
                _ => <$array>::new_with_length(room.length(values.len())),
            };
            let array = if array.length() == length { array } else { array.subarray(0, length) };
            array.copy_from(values);
            array
        }
    };
}

written! {
    /// Numbers in the array that is given, where it is long enough.
    floats, f32, Float32Array
}

written! {
    /// As [`floats`].
    integers, u32, Uint32Array
}
