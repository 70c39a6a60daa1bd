//! What else than designs is written down as they are, trees of scenes, is read and written with.

pub(crate) use super::document::{check_version, without_null};
pub(crate) use super::label::read as label;
pub(crate) use super::limits::{PARTS, VERSION};
pub(crate) use super::quantity::{is_default, maybe_not_zero, or_default, whole};
pub(crate) use super::reader::{buffered, read};
pub(crate) use super::text::{read as text, write as to_json};
