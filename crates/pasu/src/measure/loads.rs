//! What depends on how much is in a pot.

/// Something of a pot without water and of one that is full to the brim.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Loads<T> {
    /// Without water.
    pub empty: Option<T>,
    /// With water to the brim; `None` where it holds none.
    pub full: Option<T>,
}

impl<T> Default for Loads<T> {
    /// Neither is known.
    fn default() -> Self {
        Loads { empty: None, full: None }
    }
}

#[cfg(feature = "typescript")]
impl<T: crate::answer::Answer> crate::answer::Answer for Loads<T> {
    fn type_name() -> String {
        let name = T::type_name();
        format!("{{ readonly empty: {name} | null; readonly full: {name} | null }}")
    }
}
