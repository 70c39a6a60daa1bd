//! What can be made of a surface.

/// What is made of each part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Product {
    /// A hollow pot with the part's wall.
    #[default]
    Pot,
    /// The surface with its ends closed, for the vase mode of a slicer.
    Solid,
}

impl Product {
    /// The word by which it is known: `pot` or `solid`.
    ///
    /// ```
    /// assert_eq!(pasu::Product::Solid.name(), "solid");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Product::Pot => "pot",
            Product::Solid => "solid",
        }
    }
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(Product, "Product");
