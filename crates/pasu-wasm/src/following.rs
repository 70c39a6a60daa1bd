//! What of the mesh of a network is another once points are elsewhere: of thousands of patches a hand moves few, and to read, to sample and to copy all of them would take longer than a frame.

use js_sys::{Float32Array, Object, Uint32Array};
use pasu::{Code, Error, Result};
use wasm_bindgen::prelude::*;

use crate::error::thrown;
use crate::mesh::{sampled_after, set};
use crate::{last, options, points};

/// The design that has the mark `known`, its network with points elsewhere, gets the mark `next`; `moves` has four numbers for each point: which it is, and where.
///
/// Returns `{ ranges, positions, normals }`: pairs of the first vertex and the number of vertices, and what these have, one range after the other. `undefined` where the design of that mark, or its mesh of these options, is not kept.
///
/// # Errors
/// When a point does not exist or is no number, an option is not understood, or the network cannot be solved or meshed.
#[wasm_bindgen]
pub fn moved(known: f64, next: f64, moves: &JsValue, given: &JsValue) -> core::result::Result<JsValue, JsValue> {
    let Some(before) = last::marked(known) else { return Ok(JsValue::UNDEFINED) };
    let followed = || {
        let options = options::read(given)?;
        let design = before.design().with_points(
            0,
            &moves_of(&points::numbers(moves, "moves", "a Float64Array of four numbers for each point")?)?,
        )?;
        let after = || last::solution(&design);
        sampled_after(&before, after, &options, |mesh, written| {
            last::mark(next);
            let n = written.iter().map(|range| range.len()).sum::<usize>() as u32;
            let (positions, normals) = (Float32Array::new_with_length(3 * n), Float32Array::new_with_length(3 * n));
            let mut ranges = Vec::with_capacity(2 * written.len());
            let mut place = 0;
            for range in written {
                let (from, to) = (3 * range.start, 3 * range.end);
                let end = place + (to - from) as u32;
                for (array, values) in [(&positions, &mesh.positions), (&normals, &mesh.normals)] {
                    array.subarray(place, end).copy_from(&values[from..to]);
                }
                ranges.extend([range.start as u32, range.len() as u32]);
                place = end;
            }
            let object = Object::new();
            set(&object, "ranges", Uint32Array::from(ranges.as_slice()).into())?;
            set(&object, "positions", positions.into())?;
            set(&object, "normals", normals.into())?;
            Ok(object)
        })
    };
    followed().map_err(|error| thrown(&error))?.map_or(Ok(JsValue::UNDEFINED), |object| object.map(JsValue::from))
}

/// Points by their numbers.
fn moves_of(numbers: &[f64]) -> Result<Vec<(usize, [f64; 3])>> {
    let (moves, rest) = numbers.as_chunks::<4>();
    if !rest.is_empty() {
        let message = format!("expected four numbers for each point, found {} in all", numbers.len());
        return Err(Error::new(Code::WrongType, "moves", message));
    }
    let of = |(index, [number, x, y, z]): (usize, &[f64; 4])| match *number {
        n if (0.0..=f64::from(u32::MAX)).contains(&n) && n.fract() == 0.0 => Ok((n as usize, [*x, *y, *z])),
        n => {
            let message = format!("expected the number of a point, found {n}");
            Err(Error::new(Code::NoSuchPoint, format!("moves[{}]", 4 * index), message))
        }
    };
    moves.iter().enumerate().map(of).collect()
}
