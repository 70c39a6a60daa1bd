//! What every kind of shape says of itself, in its own room.

use std::borrow::Cow;

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::boundary_value::BoundaryValue;
#[cfg(feature = "typescript")]
use super::boundary_value::Span;
#[cfg(feature = "typescript")]
use super::declarations;
use super::fields::{Dimension, Field, Fields};
use super::handles::Handles;
use super::quantity::Size;
#[cfg(feature = "typescript")]
use super::slider::Slider;
use crate::error::{Code, Error, Result};

/// A kind of shape: `serde` reads and writes the fields beside `kind`, and this is what else there is to know of them.
pub(crate) trait Described: Serialize + DeserializeOwned {
    /// What a readable link has to know of it, if it has one.
    const FAMILY: Option<Family>;

    /// The boundary-value problem that it stands for.
    fn problem(&self) -> Cow<'_, BoundaryValue>;

    /// The one way of writing this surface to twelve significant digits.
    ///
    /// # Errors
    /// `overflow` when the numbers leave the range of numbers.
    fn canonical(self) -> Result<Self>;

    /// How many modes have to be solved.
    fn cost(&self) -> usize {
        self.problem().n_modes()
    }

    /// Every number of waves that the document gives, with where it stands within the shape.
    fn waves(&self) -> Vec<(String, f64)>;

    /// What differs from the shape that a link of this kind starts from; `None` when it has no readable link.
    fn link(&self) -> Option<Vec<String>>;

    /// What of it a hand can drag.
    fn handles(&self) -> Handles;

    /// Refuses parameters within the range of numbers whose products leave it.
    ///
    /// # Errors
    /// `overflow`.
    fn finite(self) -> Result<Self> {
        match self.problem().is_finite() {
            true => Ok(self),
            false => {
                let message = "these numbers are so large that their products cannot be computed";
                Err(Error::new(Code::Overflow, "", message))
            }
        }
    }

    /// Writes its TypeScript declarations.
    #[cfg(feature = "typescript")]
    fn typescript(kind: &str, into: &mut String);
}

/// The parameters of a named family, and what a link of it starts from: the numbers of each.
#[derive(Clone, Copy)]
pub(crate) struct Family {
    pub(crate) fields: &'static [Field],
    pub(crate) start: fn() -> Vec<Vec<f64>>,
    /// How a person changes them, in the order in which they are shown.
    #[cfg(feature = "typescript")]
    pub(crate) sliders: fn() -> Vec<Slider>,
    /// Round the axis, the same for all of them.
    #[cfg(feature = "typescript")]
    pub(crate) span: fn() -> Span,
}

/// A named family: a few numbers that expand into a boundary-value problem.
pub(crate) trait Expanded: Fields + Serialize + DeserializeOwned {
    /// Where it comes from, for its declaration in TypeScript.
    #[cfg(feature = "typescript")]
    const SOURCE: &'static str;

    /// The name of its type.
    #[cfg(feature = "typescript")]
    const NAME: &'static str;

    /// How a person changes its numbers, in the order in which they are shown.
    #[cfg(feature = "typescript")]
    fn sliders() -> Vec<Slider>;

    /// The problem that these numbers stand for.
    fn boundary_value(&self) -> BoundaryValue;

    /// What of it a hand can drag.
    fn handles(&self) -> Handles;
}

impl<T: Expanded> Described for T {
    const FAMILY: Option<Family> = Some(Family {
        fields: T::FIELDS,
        start: || T::START.numbers().into_iter().map(<[f64]>::to_vec).collect(),
        #[cfg(feature = "typescript")]
        sliders: T::sliders,
        #[cfg(feature = "typescript")]
        span: || T::START.boundary_value().span,
    });

    fn problem(&self) -> Cow<'_, BoundaryValue> {
        Cow::Owned(self.boundary_value())
    }

    fn canonical(mut self) -> Result<Self> {
        self.round();
        self.finite()
    }

    fn waves(&self) -> Vec<(String, f64)> {
        let mut waves = Vec::with_capacity(2);
        let fields = T::FIELDS.iter().zip(self.numbers());
        for (field, numbers) in fields.filter(|(field, _)| field.dimension == Dimension::Waves) {
            let place = |index: usize| match field.size {
                Size::One => field.name.to_owned(),
                Size::List(_) => format!("{}[{index}]", field.name),
            };
            waves.extend(numbers.iter().enumerate().map(|(index, n)| (place(index), *n)));
        }
        waves
    }

    fn link(&self) -> Option<Vec<String>> {
        Some(self.link_fields())
    }

    #[inline]
    fn handles(&self) -> Handles {
        Expanded::handles(self)
    }

    #[cfg(feature = "typescript")]
    fn typescript(kind: &str, into: &mut String) {
        declarations::numbers(into, T::NAME, &format!("The vase of {}.", T::SOURCE), Some(kind), T::FIELDS);
    }
}
