//! The options of `mesh`.

use pasu::{Code, Error, MeshOptions, Result, Value};
use wasm_bindgen::JsValue;

use crate::value;

/// The largest number of rows or columns that is handed on; which grids are too fine is `pasu`'s to say.
const LARGEST: f64 = u32::MAX as f64;

/// Reads `{ tolerance, rows, columns }`; all of it may be left out.
pub(crate) fn read(options: &JsValue) -> Result<MeshOptions> {
    let mut read = MeshOptions::default();
    let fields = match value::read(options)? {
        Value::Null => return Ok(read),
        Value::Record(fields) => fields,
        _ => return Err(Error::new(Code::WrongType, "options", "expected an object of options")),
    };
    for (name, value) in fields {
        let path = format!("options.{name}");
        match (name.as_str(), value) {
            ("tolerance" | "rows" | "columns", Value::Null) => {}
            ("tolerance", Value::Number(tolerance)) => read.tolerance = Some(tolerance),
            ("rows", Value::Number(rows)) => read.rows = Some(count(rows, path)?),
            ("columns", Value::Number(columns)) => read.columns = Some(count(columns, path)?),
            ("tolerance" | "rows" | "columns", _) => {
                return Err(Error::new(Code::WrongType, path, "expected a number"));
            }
            _ => {
                let message = "there is no such option; expected tolerance, rows or columns";
                return Err(Error::new(Code::UnknownField, path, message));
            }
        }
    }
    Ok(read)
}

fn count(number: f64, path: String) -> Result<usize> {
    if !number.is_finite() {
        return Err(Error::new(
            Code::NotFinite,
            path,
            format!("expected a whole number, found {}", Value::Number(number).described()),
        ));
    }
    if !(0.0..=LARGEST).contains(&number) || number.fract() != 0.0 {
        return Err(Error::new(
            Code::OutOfRange,
            path,
            format!("expected a whole number, found {}", Value::Number(number).described()),
        ));
    }
    Ok(number as usize)
}
