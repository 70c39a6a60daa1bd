//! What every kind of shape says of itself, in its own room.

use std::borrow::Cow;

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::boundary_value::BoundaryValue;
#[cfg(feature = "typescript")]
use super::boundary_value::Span;
#[cfg(feature = "typescript")]
use super::declarations;
#[cfg(feature = "typescript")]
use super::fields::Field;
use super::fields::{self, Dimension, Fields};
use super::handles::Handles;
use super::parameter::Parameter;
use super::placement::Placement;
use super::quantity::Size;
#[cfg(feature = "typescript")]
use super::slider::Slider;
use super::symmetry::Symmetry;
use super::value::Value;
use crate::error::{Code, Error, Result};

/// A kind of shape: `serde` reads and writes the fields beside `kind`, and this is what else there is to know of them.
pub(crate) trait Described: Serialize + DeserializeOwned {
    /// Its numbers, if it is made of a fixed number of them.
    #[cfg(feature = "typescript")]
    const FAMILY: Option<Family> = None;

    /// How a readable link says it, if it has one.
    const SPELLING: Option<Spelling> = None;

    /// The boundary-value problem between two ends that it stands for; `None` where it stands for other patches than a surface between two ends.
    fn problem(&self) -> Option<Cow<'_, BoundaryValue>> {
        None
    }

    /// By which numbers a point of it is told.
    fn address(&self) -> Address {
        Address::Surface
    }

    /// The one way of writing this surface to twelve significant digits.
    ///
    /// # Errors
    /// `overflow` when the numbers leave the range of numbers.
    fn canonical(self) -> Result<Self>;

    /// This shape and its placement, both canonical by themselves, in the one way of writing the solid that they make: where a shape is its own image under some motion, placements differ that make the same of it.
    /// The placement that was `given` has more digits than its canonical form.
    fn standing(self, given: &Placement, place: Placement) -> (Self, Placement) {
        // What is neither turned nor mirrored is canonical as it is, and nothing has to be expanded.
        let is_upright = place.angle == 0.0 && place.scale[1] > 0.0;
        let symmetry = (!is_upright).then(|| self.problem()).flatten().map(|problem| Symmetry::of(&problem));
        let place = symmetry.map_or(place, |symmetry| symmetry.standing(given, place));
        (self, place)
    }

    /// How many modes have to be solved; 0 of what has none, whose own limits are told when it is read.
    fn cost(&self) -> usize {
        self.problem().map_or(0, |problem| problem.n_modes())
    }

    /// Every number of waves that the document gives, with where it stands within the shape.
    fn waves(&self) -> Vec<(String, f64)> {
        Vec::new()
    }

    /// What differs from the shape that a link of this kind starts from; `None` when it has no readable link.
    fn link(&self) -> Option<Vec<String>> {
        None
    }

    /// What of its profile a hand can drag: nothing where it has none.
    fn handles(&self) -> Handles {
        Handles::none()
    }

    /// Its numbers one by one, if it is a named family; none otherwise.
    fn parameters(&self) -> Vec<Parameter> {
        Vec::new()
    }

    /// The same with other numbers, in the order of [`Described::parameters`].
    fn with_parameters(self, _values: &[f64]) -> Self {
        self
    }

    /// Refuses parameters within the range of numbers whose products leave it.
    ///
    /// # Errors
    /// `overflow`.
    fn finite(self) -> Result<Self> {
        match self.problem().is_none_or(|problem| problem.is_finite()) {
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

/// By which numbers a point of a shape is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Address {
    /// `(u, v)`: `u` in [0, 1], `v` any number in the units of the span.
    Surface,
    /// `(patch, u, v)`: one of so many patches, `u` and `v` in [0, 1].
    Patches(usize),
    /// `(u, v, w)` within a solid, each in [0, 1].
    Volume,
}

/// The parameters of a named family, and what a link of it starts from: the numbers of each.
#[cfg(feature = "typescript")]
#[derive(Clone, Copy)]
pub(crate) struct Family {
    pub(crate) fields: &'static [Field],
    pub(crate) start: fn() -> Vec<Vec<f64>>,
    /// How a person changes them, in the order in which they are shown.
    pub(crate) sliders: fn() -> Vec<Slider>,
    /// Round the axis, the same for all of them.
    pub(crate) span: fn() -> Span,
}

/// How a readable link says the fields of a document.
#[derive(Clone, Copy)]
pub(crate) struct Spelling {
    /// What may stand before `=`.
    pub(crate) names: &'static [&'static str],
    /// The fields from the names and texts of a link, all of these names. What a link may leave out is there; what is wrong is left to the reader of the document, or refused with the path of the field.
    pub(crate) read: fn(&[(&str, &str)]) -> Result<Spelled>,
}

/// Fields of a document by their names.
pub(crate) type Spelled = Vec<(String, Value)>;

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
    #[cfg(feature = "typescript")]
    const FAMILY: Option<Family> = Some(Family {
        fields: T::FIELDS,
        start: || T::START.numbers().into_iter().map(<[f64]>::to_vec).collect(),
        sliders: T::sliders,
        span: || T::START.boundary_value().span,
    });
    const SPELLING: Option<Spelling> = Some(Spelling { names: T::NAMES, read: fields::spelled::<T> });

    fn problem(&self) -> Option<Cow<'_, BoundaryValue>> {
        Some(Cow::Owned(self.boundary_value()))
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

    fn parameters(&self) -> Vec<Parameter> {
        Parameter::all(T::FIELDS, &self.numbers())
    }

    fn with_parameters(mut self, values: &[f64]) -> Self {
        for (number, value) in self.numbers_mut().into_iter().flatten().zip(values) {
            *number = *value;
        }
        self
    }

    #[cfg(feature = "typescript")]
    fn typescript(kind: &str, into: &mut String) {
        declarations::numbers(into, T::NAME, &format!("The vase of {}.", T::SOURCE), Some(kind), T::FIELDS);
    }
}
