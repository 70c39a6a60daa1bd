//! The general two-sided shape: Fourier boundary data for a second or fourth order equation, component by component.

use std::fmt;

use serde::de::{Deserializer, Error, Unexpected, Visitor};
use serde::ser::{SerializeStruct, Serializer};
use serde::{Deserialize, Serialize};

use super::limits::{FORCE, RINGS};
use super::list;
use super::quantity::{Finite, One, Range, any, is_zero, not_zero, or_default, or_zero};
use super::ring::rings;

/// A surface `X(u, v)`, `u` in [0, 1], `v` in [0, `span`], of which each component solves its own equation (ZY01 eqs 1, 9, 13; IA eq 1).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "a shape")]
pub struct BoundaryValue {
    /// The length of the parameter interval round the axis.
    pub span: Span,
    /// Curves between the two ends that it passes through, in ascending `u`.
    #[serde(deserialize_with = "rings", skip_serializing_if = "Vec::is_empty")]
    pub rings: Vec<Ring>,
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

pub(super) use super::ring::{Free, Ring};
pub use crate::mode::Order;

/// The equation and the boundary data of one component.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(from = "Equation")]
pub struct Component {
    /// The order of the equation.
    pub order: Order,
    /// Shape control parameter of the highest `u` derivative; not zero.
    pub s: f64,
    /// Shape control parameter of the mixed (order 4) or `v` (order 2) derivative.
    pub t: f64,
    /// Shape control parameter of the fourth `v` derivative; 0 and without meaning for order 2.
    pub w: f64,
    /// Ends whose slopes are not given; order 4 only.
    pub free: Free,
    /// The finite Fourier sum of boundary data and force.
    pub modes: Vec<Mode>,
}

/// The data of `cos(k_n v)` and `sin(k_n v)`, `k_n = 2 pi n / span`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mode {
    /// Any real; the surface closes only when every `n` in use is whole.
    pub n: f64,
    /// The data of `cos(k_n v)`.
    #[serde(skip_serializing_if = "Datum::is_zero")]
    pub cos: Datum,
    /// The data of `sin(k_n v)`.
    #[serde(skip_serializing_if = "Datum::is_zero")]
    pub sin: Datum,
}

/// Boundary values and force of one scalar mode problem; what is left out is 0.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(expecting = "boundary data")]
pub struct Datum {
    /// Value at `u = 0`.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub start: f64,
    /// Value at `u = 1`.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub end: f64,
    /// Derivative in `u` at `u = 0`; order 4 only.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub start_u: f64,
    /// Derivative in `u` at `u = 1`; order 4 only.
    #[serde(deserialize_with = "or_zero", skip_serializing_if = "is_zero")]
    pub end_u: f64,
    /// Values at the rings, one for each; all are 0 where there are none.
    #[serde(deserialize_with = "values", skip_serializing_if = "Vec::is_empty")]
    pub rings: Vec<f64>,
    /// Polynomial force in ascending powers of `u`.
    #[serde(deserialize_with = "force", skip_serializing_if = "Vec::is_empty")]
    pub force: Vec<f64>,
}

/// A component as a document gives it: the order says what there is to be given.
#[derive(Deserialize)]
#[serde(rename = "order", expecting = "an equation with its modes")]
enum Equation {
    #[serde(rename = "2")]
    Second {
        #[serde(deserialize_with = "not_zero")]
        s: f64,
        #[serde(deserialize_with = "any")]
        t: f64,
        #[serde(deserialize_with = "modes")]
        modes: Vec<Harmonic<SecondOrderDatum>>,
    },
    #[serde(rename = "4")]
    Fourth {
        #[serde(deserialize_with = "not_zero")]
        s: f64,
        #[serde(deserialize_with = "any")]
        t: f64,
        #[serde(deserialize_with = "any")]
        w: f64,
        #[serde(deserialize_with = "or_default")]
        free: Free,
        #[serde(deserialize_with = "modes")]
        modes: Vec<Harmonic<Datum>>,
    },
}

#[derive(Deserialize)]
#[serde(expecting = "a mode with n, cos and sin")]
struct Harmonic<D: Default> {
    #[serde(deserialize_with = "any")]
    n: f64,
    #[serde(deserialize_with = "or_default", bound(deserialize = "D: Deserialize<'de>"))]
    cos: D,
    #[serde(deserialize_with = "or_default", bound(deserialize = "D: Deserialize<'de>"))]
    sin: D,
}

/// Two ends and no slopes.
#[derive(Default, Deserialize)]
#[serde(expecting = "boundary data")]
struct SecondOrderDatum {
    #[serde(deserialize_with = "or_zero")]
    start: f64,
    #[serde(deserialize_with = "or_zero")]
    end: f64,
    #[serde(deserialize_with = "values")]
    rings: Vec<f64>,
    #[serde(deserialize_with = "force")]
    force: Vec<f64>,
}

impl From<Equation> for Component {
    fn from(equation: Equation) -> Self {
        match equation {
            Equation::Second { s, t, modes } => {
                Component { order: Order::Second, s, t, w: 0.0, free: Free::default(), modes: both(modes) }
            }
            Equation::Fourth { s, t, w, free, modes } => {
                Component { order: Order::Fourth, s, t, w, free, modes: both(modes) }
            }
        }
    }
}

fn both<D: Default + Into<Datum>>(modes: Vec<Harmonic<D>>) -> Vec<Mode> {
    modes.into_iter().map(|Harmonic { n, cos, sin }| Mode { n, cos: cos.into(), sin: sin.into() }).collect()
}

impl From<SecondOrderDatum> for Datum {
    fn from(SecondOrderDatum { start, end, rings, force }: SecondOrderDatum) -> Self {
        Datum { start, end, rings, force, ..Datum::default() }
    }
}

impl Serialize for Component {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Component", 6)?;
        let order: u8 = match self.order {
            Order::Second => 2,
            Order::Fourth => 4,
        };
        fields.serialize_field("order", &order)?;
        fields.serialize_field("s", &self.s)?;
        fields.serialize_field("t", &self.t)?;
        match self.order {
            Order::Second => fields.skip_field("w")?,
            Order::Fourth => fields.serialize_field("w", &self.w)?,
        }
        match self.free == Free::default() {
            true => fields.skip_field("free")?,
            false => fields.serialize_field("free", &self.free)?,
        }
        fields.serialize_field("modes", &self.modes)?;
        fields.end()
    }
}

/// How a document writes [`Span::Tau`].
const TAU_NAME: &str = "2pi";

impl Serialize for Span {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Span::Tau => serializer.serialize_str(TAU_NAME),
            Span::Length(length) => serializer.serialize_f64(*length),
        }
    }
}

impl<'de> Deserialize<'de> for Span {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SpanVisitor)
    }
}

struct SpanVisitor;

impl Visitor<'_> for SpanVisitor {
    type Value = Span;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number greater than 0 or \"2pi\"")
    }

    fn visit_u64<E: Error>(self, x: u64) -> Result<Span, E> {
        self.visit_f64(x as f64)
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<Span, E> {
        One(Range::Positive).visit_f64(x).map(Span::Length)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Span, E> {
        if text == TAU_NAME { Ok(Span::Tau) } else { Err(E::invalid_type(Unexpected::Str(text), &self)) }
    }
}

fn modes<'de, D: Deserializer<'de>, M: Deserialize<'de>>(deserializer: D) -> Result<Vec<M>, D::Error> {
    list::read(deserializer, "a list of modes", None)
}

/// Reads the coefficients of a force, none when they are left out.
fn force<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
    deserializer.deserialize_option(Numbers::<FORCE>("coefficients"))
}

/// Reads the values at rings, none when they are left out.
fn values<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
    deserializer.deserialize_option(Numbers::<RINGS>("values, one for each ring"))
}

/// A list of so many numbers at most, by what they are.
struct Numbers<const MOST: usize>(&'static str);

impl<'de, const MOST: usize> Visitor<'de> for Numbers<MOST> {
    type Value = Vec<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of numbers")
    }

    fn visit_none<E>(self) -> Result<Vec<f64>, E> {
        Ok(Vec::new())
    }

    fn visit_unit<E>(self) -> Result<Vec<f64>, E> {
        Ok(Vec::new())
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<f64>, D::Error> {
        let most = format!("at most {MOST} {}", self.0);
        let numbers: Vec<Finite> = list::read(deserializer, "a list of numbers", Some((MOST, &most)))?;
        Ok(numbers.into_iter().map(|Finite(number)| number).collect())
    }
}
