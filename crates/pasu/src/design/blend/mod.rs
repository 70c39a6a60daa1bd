//! Solids that flow from one section into another (ZY04), as a document describes them.

mod described;
mod fields;
#[cfg(feature = "typescript")]
mod sliders;
mod symmetry;

pub use fields::{Blend, Form, Harmonic, Method, Section};
#[cfg(feature = "typescript")]
pub(super) use fields::{MOST_TERMS, TERMS};
#[cfg(feature = "typescript")]
pub(super) use sliders::{BlendSlider, SECTION_SLIDERS, WEIGHT_SLIDERS};
