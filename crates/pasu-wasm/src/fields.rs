//! Options of what makes a design, as JavaScript names them.

use js_sys::Object;
use pasu::{Code, Craft, Error, Making, MeasureOptions, Product, Result, Size, SketchOptions};
use serde::Deserialize;
use wasm_bindgen::JsValue;

use crate::mesh::set;
use crate::options::Finite;
use crate::source;

#[derive(Deserialize, Default)]
#[serde(expecting = "an object of options")]
struct MakingFields {
    product: Option<ProductName>,
    size: Option<SizeFields>,
    shrinkage: Option<Finite>,
    tolerance: Option<Finite>,
    craft: Option<CraftName>,
    union: Option<bool>,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum CraftName {
    Print,
    Clay,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum ProductName {
    Pot,
    Solid,
}

#[derive(Deserialize)]
#[serde(expecting = "an object with one of height, width and capacity")]
struct SizeFields {
    height: Option<Finite>,
    width: Option<Finite>,
    capacity: Option<Finite>,
}

#[derive(Deserialize, Default)]
#[serde(expecting = "an object of options")]
struct MeasureFields {
    fill: Option<Finite>,
    product: Option<ProductName>,
    density: Option<Finite>,
}

#[derive(Deserialize, Default)]
#[serde(expecting = "an object of options")]
struct SketchFields {
    tolerance: Option<Finite>,
    fill: Option<Finite>,
}

/// Reads `{ product, size, shrinkage, tolerance, craft, union }`; all of it may be left out.
pub(crate) fn making(options: &JsValue) -> Result<Making> {
    let given: Option<MakingFields> = source::argument(options, "making")?;
    let given = given.unwrap_or_default();
    Ok(Making {
        product: product(given.product),
        size: given.size.map(size).transpose()?,
        shrinkage: number(given.shrinkage).unwrap_or_default(),
        tolerance: number(given.tolerance),
        craft: given.craft.map(|craft| match craft {
            CraftName::Print => Craft::Print,
            CraftName::Clay => Craft::Clay,
        }),
        union: given.union.unwrap_or_default(),
    })
}

/// The same fields again, those that were given.
pub(crate) fn made(making: &Making) -> core::result::Result<Object, JsValue> {
    let object = Object::new();
    set(&object, "product", making.product.name().into())?;
    let sized = match making.size {
        None => None,
        Some(Size::Height(height)) => Some(("height", height)),
        Some(Size::Width(width)) => Some(("width", width)),
        Some(Size::Capacity(capacity)) => Some(("capacity", capacity)),
        // A size that JavaScript cannot ask for.
        Some(_) => None,
    };
    if let Some((name, value)) = sized {
        let size = Object::new();
        set(&size, name, value.into())?;
        set(&object, "size", size.into())?;
    }
    set(&object, "shrinkage", making.shrinkage.into())?;
    if let Some(tolerance) = making.tolerance {
        set(&object, "tolerance", tolerance.into())?;
    }
    if let Some(craft) = making.craft {
        set(&object, "craft", craft.name().into())?;
    }
    if making.union {
        set(&object, "union", true.into())?;
    }
    Ok(object)
}

/// Reads `{ fill, product, density }`; all of it may be left out.
pub(crate) fn measuring(options: &JsValue) -> Result<MeasureOptions> {
    let given: Option<MeasureFields> = source::argument(options, "options")?;
    let given = given.unwrap_or_default();
    Ok(MeasureOptions { fill: number(given.fill), product: product(given.product), density: number(given.density) })
}

/// Reads `{ tolerance, fill }`; all of it may be left out.
pub(crate) fn sketching(options: &JsValue) -> Result<SketchOptions> {
    let given: Option<SketchFields> = source::argument(options, "options")?;
    let given = given.unwrap_or_default();
    Ok(SketchOptions { tolerance: number(given.tolerance), fill: number(given.fill) })
}

/// Reads one of some names, by what each is called.
pub(crate) fn one_of<T: Copy>(value: &JsValue, path: &str, all: &[T], name: fn(T) -> &'static str) -> Result<T> {
    let text: String = source::argument(value, path)?;
    all.iter().copied().find(|one| name(*one) == text).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|one| name(*one)).collect();
        let message = format!("expected {}, found {text:?}", names.join(", "));
        Error::new(Code::UnknownName, path, message).with("words", names.as_slice()).with("found", text.as_str())
    })
}

/// Reads a number that is an argument of its own.
pub(crate) fn argument(value: &JsValue, path: &str) -> Result<f64> {
    source::argument(value, path).map(|Finite(number)| number)
}

fn number(given: Option<Finite>) -> Option<f64> {
    given.map(|Finite(number)| number)
}

fn product(given: Option<ProductName>) -> Product {
    match given {
        None | Some(ProductName::Pot) => Product::Pot,
        Some(ProductName::Solid) => Product::Solid,
    }
}

fn size(given: SizeFields) -> Result<Size> {
    const ONE: &str = "expected an object with one of height, width and capacity";
    match (number(given.height), number(given.width), number(given.capacity)) {
        (Some(height), None, None) => Ok(Size::Height(height)),
        (None, Some(width), None) => Ok(Size::Width(width)),
        (None, None, Some(capacity)) => Ok(Size::Capacity(capacity)),
        (None, None, None) => Err(Error::new(Code::MissingField, "size", ONE)),
        _ => Err(Error::new(Code::Duplicate, "size", ONE)),
    }
}
