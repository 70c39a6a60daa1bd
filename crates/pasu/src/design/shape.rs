//! The shape of one part: a named family, or the general boundary-value shape into which each family expands.

use std::borrow::Cow;

use super::boundary_value::BoundaryValue;
use super::family::{BloorWilson, FourthOrder, MixedOrder, SecondOrder};
use super::fields::{self, Field, Fields};
use super::modes;
use super::path::Path;
use super::reader::{self, Record};
use super::table;
use super::value::Value;
use crate::error::{Code, Result};

/// A surface as the document describes it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// `second-order`, ZY01 eqs 1-8.
    SecondOrder(SecondOrder),
    /// `mixed-order`, ZY01 eqs 9-12.
    MixedOrder(MixedOrder),
    /// `fourth-order`, ZY01 eqs 13-17.
    FourthOrder(FourthOrder),
    /// `bloor-wilson`, IA eqs 15-18.
    BloorWilson(BloorWilson),
    /// `boundary-value`: any Fourier boundary data.
    BoundaryValue(BoundaryValue),
}

/// The word in a document's `kind`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    SecondOrder,
    MixedOrder,
    FourthOrder,
    BloorWilson,
    BoundaryValue,
}

impl Kind {
    /// In the order of [`Kind::NAMES`].
    const ALL: [Kind; 5] =
        [Kind::SecondOrder, Kind::MixedOrder, Kind::FourthOrder, Kind::BloorWilson, Kind::BoundaryValue];
    const NAMES: [&str; 5] = ["second-order", "mixed-order", "fourth-order", "bloor-wilson", "boundary-value"];
    /// Kinds of the format that this version cannot compute.
    const LATER: [&str; 3] = ["vertex-frame", "blend", "octant"];

    pub(crate) fn name(self) -> &'static str {
        Kind::NAMES[self as usize]
    }

    fn read(record: &Record) -> Result<Self> {
        let value = record.require("kind", &reader::alternatives(&Kind::NAMES))?;
        Kind::among(value, &record.path.field("kind"), &Kind::NAMES)
    }

    /// Reads the kind of a readable link: a named family.
    pub(crate) fn read_family(name: &str, path: &Path) -> Result<Self> {
        let families = &Kind::NAMES[..Kind::BoundaryValue as usize];
        Kind::among(&Value::Text(name.to_owned()), path, families)
    }

    fn among(value: &Value, path: &Path, names: &[&str]) -> Result<Self> {
        if let Value::Text(text) = value
            && let Some(later) = Kind::LATER.iter().find(|name| *name == text)
        {
            let known = reader::alternatives(names);
            let message = format!("this version of Pasu cannot compute the shape {later:?} yet; expected {known}");
            return Err(path.error(Code::UnsupportedShape, message));
        }
        Ok(Kind::ALL[reader::name(value, path, names)?])
    }

    /// The parameters of a named family.
    pub(crate) fn fields(self) -> &'static [Field] {
        match self {
            Kind::SecondOrder => SecondOrder::FIELDS,
            Kind::MixedOrder => MixedOrder::FIELDS,
            Kind::FourthOrder => FourthOrder::FIELDS,
            Kind::BloorWilson => BloorWilson::FIELDS,
            Kind::BoundaryValue => &[],
        }
    }

    /// The document fields of the shape that a link of this kind starts from.
    pub(crate) fn start(self) -> Vec<(String, Value)> {
        let shape = match self {
            Kind::SecondOrder => Shape::SecondOrder(SecondOrder::START),
            Kind::MixedOrder => Shape::MixedOrder(MixedOrder::START),
            Kind::FourthOrder => Shape::FourthOrder(FourthOrder::START),
            Kind::BloorWilson => Shape::BloorWilson(BloorWilson::START),
            Kind::BoundaryValue => return Vec::new(),
        };
        shape.fields()
    }
}

impl Shape {
    /// Reads and checks a bare shape; `path` is put before the path of an error.
    ///
    /// The shape is as given. Only a whole [`Design`](crate::Design) is brought into canonical form.
    ///
    /// ```
    /// use pasu::{Shape, Value};
    ///
    /// let value: Value = serde_json::from_str(r#"{ "kind": "second-order", "r": [1, 0.1, 0.6] }"#).unwrap();
    /// let error = Shape::from_value(&value, "shape").unwrap_err();
    /// assert_eq!(error.to_string(), "shape.r: expected a list of 4 numbers, found a list of 3");
    /// ```
    ///
    /// # Errors
    /// As [`Design::from_value`](crate::Design::from_value).
    pub fn from_value(value: &Value, path: &str) -> Result<Shape> {
        Shape::read(value, Path::Start(path))
    }

    pub(crate) fn read(value: &Value, path: Path) -> Result<Shape> {
        let record = Record::open(value, path, "a shape")?;
        let shape = match Kind::read(&record)? {
            Kind::SecondOrder => Shape::SecondOrder(family(record)?),
            Kind::MixedOrder => Shape::MixedOrder(family(record)?),
            Kind::FourthOrder => Shape::FourthOrder(family(record)?),
            Kind::BloorWilson => Shape::BloorWilson(family(record)?),
            Kind::BoundaryValue => {
                Shape::BoundaryValue(BoundaryValue::read(&record.only(&table::names(modes::BOUNDARY_VALUE))?)?)
            }
        };
        shape.finite(&path)
    }

    /// The boundary-value problem of this shape.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson?a=3")?;
    /// let problem = vase.parts()[0].shape.boundary_value();
    /// // s = 1, t = 2 a^2, w = a^4
    /// assert_eq!((problem.x.s, problem.x.t, problem.x.w), (1.0, 18.0, 81.0));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn boundary_value(&self) -> BoundaryValue {
        self.problem().into_owned()
    }

    /// The same without a copy of what stands in the document: the one place where families expand.
    pub(crate) fn problem(&self) -> Cow<'_, BoundaryValue> {
        Cow::Owned(match self {
            Shape::SecondOrder(family) => family.boundary_value(),
            Shape::MixedOrder(family) => family.boundary_value(),
            Shape::FourthOrder(family) => family.boundary_value(),
            Shape::BloorWilson(family) => family.boundary_value(),
            Shape::BoundaryValue(general) => return Cow::Borrowed(general),
        })
    }

    pub(crate) fn kind(&self) -> Kind {
        match self {
            Shape::SecondOrder(_) => Kind::SecondOrder,
            Shape::MixedOrder(_) => Kind::MixedOrder,
            Shape::FourthOrder(_) => Kind::FourthOrder,
            Shape::BloorWilson(_) => Kind::BloorWilson,
            Shape::BoundaryValue(_) => Kind::BoundaryValue,
        }
    }

    /// The one way of writing this surface to twelve significant digits.
    pub(crate) fn canonical(mut self, path: &Path) -> Result<Shape> {
        match &mut self {
            Shape::SecondOrder(family) => family.round(),
            Shape::MixedOrder(family) => family.round(),
            Shape::FourthOrder(family) => family.round(),
            Shape::BloorWilson(family) => family.round(),
            Shape::BoundaryValue(_) => {}
        }
        match self {
            Shape::BoundaryValue(general) => Ok(Shape::BoundaryValue(general.canonical(path)?)),
            family => family.finite(path),
        }
    }

    /// Parameters within the range of numbers may multiply beyond it.
    fn finite(self, path: &Path) -> Result<Shape> {
        if self.problem().is_finite() {
            return Ok(self);
        }
        Err(path.error(Code::Overflow, "these numbers are so large that their products cannot be computed"))
    }

    pub(crate) fn value(&self) -> Value {
        Value::Record(self.fields())
    }

    /// What differs from the shape that a link of this kind starts from; `None` when it is no named family.
    pub(crate) fn write_link(&self) -> Option<Vec<String>> {
        match self {
            Shape::SecondOrder(family) => Some(family.link_fields()),
            Shape::MixedOrder(family) => Some(family.link_fields()),
            Shape::FourthOrder(family) => Some(family.link_fields()),
            Shape::BloorWilson(family) => Some(family.link_fields()),
            Shape::BoundaryValue(_) => None,
        }
    }

    fn fields(&self) -> Vec<(String, Value)> {
        let mut into = vec![("kind".to_owned(), Value::Text(self.kind().name().into()))];
        match self {
            Shape::SecondOrder(family) => family.write(&mut into),
            Shape::MixedOrder(family) => family.write(&mut into),
            Shape::FourthOrder(family) => family.write(&mut into),
            Shape::BloorWilson(family) => family.write(&mut into),
            Shape::BoundaryValue(general) => general.write(&mut into),
        }
        into
    }
}

fn family<T: Fields>(record: Record) -> Result<T> {
    let mut known = vec!["kind"];
    known.extend(fields::names::<T>());
    T::read(&record.only(&known)?)
}
