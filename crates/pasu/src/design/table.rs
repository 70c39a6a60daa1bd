//! The table of fields of a record that is not all numbers: what the reader knows and what TypeScript is told.

#[cfg(feature = "typescript")]
use super::fields::Need;

/// One field. What only the TypeScript declarations read is compiled in only for them.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    #[cfg(feature = "typescript")]
    pub(crate) need: Need,
    /// Its type as TypeScript writes it.
    #[cfg(feature = "typescript")]
    pub(crate) typescript: &'static str,
    /// What it means.
    #[cfg(feature = "typescript")]
    pub(crate) about: &'static str,
}

#[cfg(feature = "typescript")]
pub(crate) const fn required(name: &'static str, typescript: &'static str, about: &'static str) -> Entry {
    Entry { name, need: Need::Required, typescript, about }
}

#[cfg(feature = "typescript")]
pub(crate) const fn optional(name: &'static str, typescript: &'static str, about: &'static str) -> Entry {
    Entry { name, need: Need::Optional, typescript, about }
}

#[cfg(not(feature = "typescript"))]
pub(crate) const fn required(name: &'static str, _: &'static str, _: &'static str) -> Entry {
    Entry { name }
}

#[cfg(not(feature = "typescript"))]
pub(crate) const fn optional(name: &'static str, _: &'static str, _: &'static str) -> Entry {
    Entry { name }
}

/// The names of the fields, for [`Record::only`](super::reader::Record::only).
pub(crate) fn names(table: &[Entry]) -> Vec<&'static str> {
    table.iter().map(|entry| entry.name).collect()
}
