//! Vases and pots whose surfaces are exact solutions of partial differential equations.
//!
//! Data flows one way: [design](crate::Design) -> canonical -> boundary-value problem -> closed form -> mesh.

mod design;
mod error;
mod mode;

pub use design::{Axis, BoundaryValue, Component, Datum, Mode, Order, Span};
pub use error::{Code, Error, Result};
pub use mode::{Equation, ModeData, ModeSolution, Unsolvable};
