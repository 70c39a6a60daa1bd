//! Solids that flow from one section into another (ZY04), as a document describes them.

mod fields;

pub use fields::{Blend, Form, Harmonic, Method, Section};

/// For tests of the room that solves them.
#[cfg(test)]
pub(crate) fn of_json(text: &str) -> crate::error::Result<Blend> {
    crate::design::reader::read(&crate::design::text::read(text)?)
}
