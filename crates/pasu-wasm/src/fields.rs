//! Options of functions, field by field: whatever is wrong is refused by its path, and what is left over has no meaning.

use pasu::{Code, Error, Making, MeasureOptions, Product, Result, Size, SketchOptions, Value};
use wasm_bindgen::JsValue;

use crate::value;

/// The fields of an object of options that have not been read yet.
struct Fields {
    /// Before the name of each field, with a dot; empty at the top.
    prefix: String,
    left: Vec<(String, Value)>,
}

/// Reads `{ product, size, shrinkage, tolerance }`; all of it may be left out.
pub(crate) fn making(options: &JsValue) -> Result<Making> {
    let mut fields = Fields::open(options, "making")?;
    let making = Making {
        product: fields.product()?,
        size: fields.size()?,
        shrinkage: fields.number("shrinkage")?.unwrap_or_default(),
        tolerance: fields.number("tolerance")?,
    };
    fields.close("product, size, shrinkage or tolerance")?;
    Ok(making)
}

/// Reads `{ fill, product, density }`; all of it may be left out.
pub(crate) fn measuring(options: &JsValue) -> Result<MeasureOptions> {
    let mut fields = Fields::open(options, "options")?;
    let measuring =
        MeasureOptions { fill: fields.number("fill")?, product: fields.product()?, density: fields.number("density")? };
    fields.close("fill, product or density")?;
    Ok(measuring)
}

/// Reads `{ tolerance, fill }`; all of it may be left out.
pub(crate) fn sketching(options: &JsValue) -> Result<SketchOptions> {
    let mut fields = Fields::open(options, "options")?;
    let sketching = SketchOptions { tolerance: fields.number("tolerance")?, fill: fields.number("fill")? };
    fields.close("tolerance, fill or into")?;
    Ok(sketching)
}

/// Reads one of some names, by what each is called.
pub(crate) fn one_of<T: Copy>(value: &JsValue, path: &str, all: &[T], name: fn(T) -> &'static str) -> Result<T> {
    named(value::read(value)?, path, all, name)
}

/// Reads a number that is an argument of its own.
pub(crate) fn argument(value: &JsValue, path: &str) -> Result<f64> {
    number(value::read(value)?, path)
}

impl Fields {
    fn open(options: &JsValue, path: &str) -> Result<Fields> {
        let left = match value::read(options)? {
            Value::Null => Vec::new(),
            Value::Record(fields) => fields,
            _ => return Err(Error::new(Code::WrongType, path, "expected an object of options")),
        };
        Ok(Fields { prefix: String::new(), left })
    }

    /// Takes a field out; what is null is as good as left out.
    fn take(&mut self, name: &str) -> Option<Value> {
        let at = self.left.iter().position(|(key, _)| key == name)?;
        let (_, value) = self.left.swap_remove(at);
        (value != Value::Null).then_some(value)
    }

    fn path(&self, name: &str) -> String {
        format!("{}{name}", self.prefix)
    }

    fn number(&mut self, name: &str) -> Result<Option<f64>> {
        self.take(name).map(|value| number(value, &self.path(name))).transpose()
    }

    fn product(&mut self) -> Result<Product> {
        let product = self.take("product");
        product.map_or(Ok(Product::default()), |value| {
            named(value, "product", &[Product::Pot, Product::Solid], Product::name)
        })
    }

    fn size(&mut self) -> Result<Option<Size>> {
        let left = match self.take("size") {
            None => return Ok(None),
            Some(Value::Record(left)) => left,
            Some(_) => return Err(Error::new(Code::WrongType, "size", ONE_SIZE)),
        };
        let mut fields = Fields { prefix: "size.".to_owned(), left };
        let sizes = [
            fields.number("height")?.map(Size::Height),
            fields.number("width")?.map(Size::Width),
            fields.number("capacity")?.map(Size::Capacity),
        ];
        fields.close("height, width or capacity")?;
        let mut sizes = sizes.into_iter().flatten();
        match (sizes.next(), sizes.next()) {
            (Some(size), None) => Ok(Some(size)),
            (None, _) => Err(Error::new(Code::MissingField, "size", ONE_SIZE)),
            (Some(_), Some(_)) => Err(Error::new(Code::Duplicate, "size", ONE_SIZE)),
        }
    }

    /// Refuses what is left.
    fn close(self, expected: &str) -> Result<()> {
        match self.left.first() {
            None => Ok(()),
            Some((name, _)) => {
                let message = format!("there is no such option; expected {expected}");
                Err(Error::new(Code::UnknownField, self.path(name), message))
            }
        }
    }
}

const ONE_SIZE: &str = "expected an object with one of height, width and capacity";

fn number(value: Value, path: &str) -> Result<f64> {
    match value {
        Value::Number(number) if number.is_finite() => Ok(number),
        Value::Number(_) => {
            Err(Error::new(Code::NotFinite, path, format!("expected a number, found {}", value.described())))
        }
        _ => Err(Error::new(Code::WrongType, path, format!("expected a number, found {}", value.described()))),
    }
}

fn named<T: Copy>(value: Value, path: &str, all: &[T], name: fn(T) -> &'static str) -> Result<T> {
    let Value::Text(text) = &value else {
        return Err(Error::new(Code::WrongType, path, format!("expected a word, found {}", value.described())));
    };
    all.iter().copied().find(|one| name(*one) == text).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|one| name(*one)).collect();
        let message = format!("expected {}, found {}", names.join(", "), value.described());
        Error::new(Code::UnknownName, path, message)
    })
}
