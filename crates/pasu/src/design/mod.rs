//! The design document: what a person has chosen, as data.

mod boundary_value;
mod decimal;
mod document;
mod family;
mod fields;
mod json;
mod limits;
mod link;
mod look;
mod modes;
mod names;
mod number;
mod part;
mod path;
mod placement;
mod reader;
mod shape;
mod table;
#[cfg(feature = "typescript")]
mod typescript;
mod unit;
mod value;
mod wall;

pub use boundary_value::{Axis, BoundaryValue, Component, Datum, Mode, Order, Span};
pub use document::Design;
pub use family::{BloorWilson, FourthOrder, MixedOrder, SecondOrder};
pub(crate) use json::write as to_json;
pub(crate) use json::write as write_json;
pub use look::{Clay, Glaze, Look};
pub(crate) use number::{plain, rounded};
pub use part::Part;
pub use placement::Placement;
pub use shape::Shape;
#[cfg(feature = "typescript")]
pub use typescript::typescript;
pub use unit::Unit;
pub use value::Value;
pub use wall::{RimForm, Side, Wall};
