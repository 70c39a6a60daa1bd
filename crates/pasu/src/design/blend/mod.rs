//! Solids that flow from one section into another (ZY04), as a document describes them.

mod described;
mod fields;

pub use fields::{Blend, Form, Harmonic, Method, Section};
