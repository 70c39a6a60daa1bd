//! The numbers of a named family one by one.

use super::fields::Field;
use super::quantity::Size;

/// One number of a family.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parameter {
    pub(crate) field: &'static Field,
    /// Its place in the field's list.
    pub(crate) index: usize,
    pub(crate) value: f64,
}

impl Parameter {
    /// Every number of these fields.
    pub(super) fn all(fields: &'static [Field], numbers: &[&[f64]]) -> Vec<Parameter> {
        let lists = fields.iter().zip(numbers);
        lists
            .flat_map(|(field, list)| {
                list.iter().enumerate().map(move |(index, &value)| Parameter { field, index, value })
            })
            .collect()
    }

    /// Its path within the shape: `r1` or `eta[0]`.
    pub(crate) fn path(&self) -> String {
        match self.field.size {
            Size::One => self.field.name.to_owned(),
            Size::List(_) => format!("{}[{}]", self.field.name, self.index),
        }
    }
}
