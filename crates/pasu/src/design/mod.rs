//! The design document: what a person has chosen, as data.

#[cfg(feature = "patchwork")]
mod blend;
mod boundary_value;
mod ceramics;
mod conversion;
#[cfg(feature = "typescript")]
mod declarations;
mod described;
mod document;
mod family;
mod fields;
mod handles;
mod joint;
mod label;
mod limits;
mod link;
mod list;
mod look;
mod modes;
#[cfg(feature = "patchwork")]
mod motion;
mod names;
mod number;
#[cfg(feature = "patchwork")]
mod octant;
mod order;
#[cfg(feature = "typescript")]
mod page;
mod parameter;
mod part;
mod placement;
mod quantity;
mod reader;
mod refusal;
mod ring;
mod rings;
mod shape;
#[cfg(feature = "typescript")]
mod slider;
mod standing;
mod symmetry;
#[cfg(feature = "typescript")]
mod tables;
mod text;
#[cfg(feature = "typescript")]
mod typescript;
mod unit;
mod value;
#[cfg(feature = "patchwork")]
mod vertex_frame;
mod wall;
#[cfg(feature = "patchwork")]
pub(crate) mod written;

#[cfg(feature = "patchwork")]
pub use blend::{Blend, Form, Harmonic, Method, Section};
pub use boundary_value::{Axis, BoundaryValue, Component, Datum, Mode, Order, Span};
pub(crate) use ceramics::Layer;
pub use conversion::{Conversion, Loss, VaseOrder};
pub(crate) use described::Address;
pub use document::Design;
pub(crate) use document::name_taken;
pub use family::{BloorWilson, FourthOrder, MixedOrder, SecondOrder};
pub(crate) use fields::Dimension;
pub use handles::{End, Handle, HandleId, Handles, Restraint, Step};
pub use joint::{Joint, Joints};
pub(crate) use limits::{RATE, RINGS, SWING, WAVES};
pub use look::{Choice, Clay, Colour, Glaze, Look, Named};
#[cfg(feature = "patchwork")]
pub use motion::Motion;
pub(crate) use number::{numbers_of, plain, rounded};
#[cfg(feature = "patchwork")]
pub use octant::Octant;
#[cfg(feature = "patchwork")]
pub(crate) use order::Key;
#[cfg(feature = "typescript")]
pub use page::{typescript_of_blends, typescript_of_materials, typescript_of_sliders, typescript_of_tables};
pub(crate) use parameter::Parameter;
pub use part::Part;
pub use placement::Placement;
pub use reader::read_from as read;
pub(crate) use refusal::unknown_name;
pub use ring::{Free, Ring};
pub use rings::{Hoop, Rings, Series, Slopes, Wave};
pub use shape::Shape;
pub(crate) use text::write as to_json;
#[cfg(feature = "typescript")]
pub use typescript::typescript;
pub use unit::Unit;
pub(crate) use value::Value;
#[cfg(feature = "patchwork")]
pub use vertex_frame::{Continuity, Falloff, Force, FramePatch, FrameRule, VertexFrame};
pub use wall::{Lining, RimForm, Side, Wall};
