//! The table of fields of a record that is not all numbers: what the reader knows and what TypeScript is told.

use super::fields::Need;

/// One field.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    #[cfg_attr(not(feature = "typescript"), expect(dead_code, reason = "read by the TypeScript declarations"))]
    pub(crate) need: Need,
    /// Its type as TypeScript writes it.
    #[cfg_attr(not(feature = "typescript"), expect(dead_code, reason = "read by the TypeScript declarations"))]
    pub(crate) typescript: &'static str,
    /// What it means.
    #[cfg_attr(not(feature = "typescript"), expect(dead_code, reason = "read by the TypeScript declarations"))]
    pub(crate) about: &'static str,
}

pub(crate) const fn required(name: &'static str, typescript: &'static str, about: &'static str) -> Entry {
    Entry { name, need: Need::Required, typescript, about }
}

pub(crate) const fn optional(name: &'static str, typescript: &'static str, about: &'static str) -> Entry {
    Entry { name, need: Need::Optional, typescript, about }
}

/// The names of the fields, for [`Record::only`](super::reader::Record::only).
pub(crate) fn names(table: &[Entry]) -> Vec<&'static str> {
    table.iter().map(|entry| entry.name).collect()
}
