//! The general two-sided shape: Fourier boundary data for a second or fourth order equation, component by component.

/// A surface `X(u, v)`, `u` in [0, 1], `v` in [0, `span`], of which each component solves its own equation (ZY01 eqs 1, 9, 13; IA eq 1).
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryValue {
    /// The length of the parameter interval round the axis.
    pub span: Span,
    /// The `x` component.
    pub x: Component,
    /// The `y` component.
    pub y: Component,
    /// The `z` component; the axis of a pot.
    pub z: Component,
}

/// The length of the `v` interval. [`Span::Tau`] is exactly `2 pi`, where `k_n = n` holds without rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Span {
    /// `"2pi"`.
    Tau,
    /// A positive number.
    Length(f64),
}

/// One of the three components.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// `x`.
    X,
    /// `y`.
    Y,
    /// `z`.
    Z,
}

pub use crate::mode::Order;

/// The equation and the boundary data of one component.
#[derive(Debug, Clone, PartialEq)]
pub struct Component {
    /// The order of the equation.
    pub order: Order,
    /// Shape control parameter of the highest `u` derivative; not zero.
    pub s: f64,
    /// Shape control parameter of the mixed (order 4) or `v` (order 2) derivative.
    pub t: f64,
    /// Shape control parameter of the fourth `v` derivative; 0 and without meaning for order 2.
    pub w: f64,
    /// The finite Fourier sum of boundary data and force.
    pub modes: Vec<Mode>,
}

/// The data of `cos(k_n v)` and `sin(k_n v)`, `k_n = 2 pi n / span`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Any real; the surface closes only when every `n` in use is whole.
    pub n: f64,
    /// The data of `cos(k_n v)`.
    pub cos: Datum,
    /// The data of `sin(k_n v)`.
    pub sin: Datum,
}

/// Boundary values and force of one scalar mode problem; what is left out is 0.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Datum {
    /// Value at `u = 0`.
    pub start: f64,
    /// Value at `u = 1`.
    pub end: f64,
    /// Derivative in `u` at `u = 0`; order 4 only.
    pub start_u: f64,
    /// Derivative in `u` at `u = 1`; order 4 only.
    pub end_u: f64,
    /// Polynomial force in ascending powers of `u`.
    pub force: Vec<f64>,
}
