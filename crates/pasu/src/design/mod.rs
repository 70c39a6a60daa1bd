//! The design document: what a person has chosen, as data.

mod boundary_value;

pub use boundary_value::{Axis, BoundaryValue, Component, Datum, Mode, Order, Span};
