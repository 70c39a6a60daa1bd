//! The named families of the papers: a few parameters that expand into a general boundary-value shape.

mod bloor_wilson;
mod fourth_order;
mod mixed_order;
mod second_order;

pub use bloor_wilson::BloorWilson;
pub use fourth_order::FourthOrder;
pub use mixed_order::MixedOrder;
pub use second_order::SecondOrder;

use super::boundary_value::{Component, Datum, Free, Mode, Order};

/// A component of order 2.
fn second(s: f64, t: f64, modes: Vec<Mode>) -> Component {
    Component { order: Order::Second, s, t, w: 0.0, free: Free::default(), modes }
}

/// A component of order 4.
fn fourth([s, t, w]: [f64; 3], modes: Vec<Mode>) -> Component {
    Component { order: Order::Fourth, s, t, w, free: Free::default(), modes }
}

fn cos(n: f64, datum: Datum) -> Mode {
    Mode { n, cos: datum, sin: Datum::default() }
}

fn sin(n: f64, datum: Datum) -> Mode {
    Mode { n, cos: Datum::default(), sin: datum }
}

/// `(value, slope)` at `u = 0` and at `u = 1`.
fn datum(start: (f64, f64), end: (f64, f64)) -> Datum {
    Datum { start: start.0, start_u: start.1, end: end.0, end_u: end.1, ..Datum::default() }
}
