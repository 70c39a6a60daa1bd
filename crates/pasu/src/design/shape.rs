//! The shape of one part: one of several kinds, each of which describes itself in its own room ([`Described`]).

use std::borrow::Cow;

use serde::{Deserialize, Serialize, Serializer};

#[cfg(feature = "patchwork")]
use super::blend::Blend;
use super::boundary_value::BoundaryValue;
#[cfg(feature = "typescript")]
use super::described::Family;
use super::described::{Address, Described, Spelling};
use super::family::{BloorWilson, FourthOrder, MixedOrder, SecondOrder};
use super::handles::Handles;
#[cfg(feature = "patchwork")]
use super::octant::Octant;
use super::parameter::Parameter;
use super::placement::Placement;
use super::rings::Rings;
#[cfg(feature = "patchwork")]
use super::vertex_frame::VertexFrame;
use super::{reader, text};
use crate::error::Result;

/// Declares the kinds of shapes, each by one line: a variant with its type, the word in a document's `kind`, and the feature without which it is left out, if there is one.
macro_rules! shapes {
    ($( $(#[$about:meta])+ $kind:ident = $name:literal $(if $feature:literal)?, )+) => {
        /// A surface as the document describes it.
        #[derive(Debug, Clone, PartialEq, Deserialize)]
        // The reader of documents finds the variant of an enum of this name in the field `kind`.
        #[serde(rename = "kind", expecting = "a shape")]
        #[non_exhaustive]
        pub enum Shape {
            $( $(#[cfg(feature = $feature)])? $(#[$about])+ #[serde(rename = $name)] $kind($kind), )+
        }

        /// All kinds, in the order of the format.
        pub(crate) const KINDS: &[Kind] = &[$( $(#[cfg(feature = $feature)])? Kind {
            name: $name,
            #[cfg(feature = "typescript")]
            family: <$kind as Described>::FAMILY,
            spelling: <$kind as Described>::SPELLING,
            #[cfg(feature = "typescript")]
            type_name: stringify!($kind),
            #[cfg(feature = "typescript")]
            typescript: <$kind as Described>::typescript,
        }, )+];

        impl Serialize for Shape {
            fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
                #[derive(Serialize)]
                #[serde(tag = "kind")]
                enum Tagged<'a> {
                    $( $(#[cfg(feature = $feature)])? #[serde(rename = $name)] $kind(&'a $kind), )+
                }
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => Tagged::$kind(shape).serialize(serializer), )+
                }
            }
        }

        impl Shape {
            /// The word in a document's `kind`.
            pub(crate) fn kind(&self) -> &'static str {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(_) => $name, )+
                }
            }

            /// The boundary-value problem without a copy of what stands in the document: the one place where families expand. `None` of a shape that is no surface between two ends.
            pub(crate) fn problem(&self) -> Option<Cow<'_, BoundaryValue>> {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.problem(), )+
                }
            }

            /// By which numbers a point of it is told.
            pub(crate) fn address(&self) -> Address {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.address(), )+
                }
            }

            /// How many modes have to be solved.
            #[inline]
            pub(crate) fn cost(&self) -> usize {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.cost(), )+
                }
            }

            /// Every number of waves that the document gives, with where it stands within the shape.
            #[inline]
            pub(crate) fn waves(&self) -> Vec<(String, f64)> {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.waves(), )+
                }
            }

            /// What differs from the shape that a link of this kind starts from; `None` when it has no readable link.
            #[inline]
            pub(crate) fn link(&self) -> Option<Vec<String>> {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.link(), )+
                }
            }

            /// Where its profile can be dragged, and what that does to its numbers.
            ///
            /// ```
            /// let vase = pasu::Design::parse("#1/fourth-order")?;
            /// let handles = vase.parts()[0].shape.handles();
            /// assert_eq!(handles.rim, pasu::End::End);
            /// let rim = &handles.list[0];
            /// // Drawing the rim outwards by 1 widens it by 1, and the belly by 1/4: the slopes at both ends stay.
            /// let steps: Vec<(&str, f64)> = rim.radial.iter().map(|step| (step.path.as_str(), step.by)).collect();
            /// assert_eq!(steps, [("r1", 1.0), ("rm", 0.25)]);
            /// # Ok::<(), pasu::Error>(())
            /// ```
            // Compiled where it is called, for size: see `Design::from_value`.
            #[inline]
            pub fn handles(&self) -> Handles {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => Described::handles(shape), )+
                }
            }

            /// Its numbers one by one, if it is of a named family; none otherwise.
            pub(crate) fn parameters(&self) -> Vec<Parameter> {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.parameters(), )+
                }
            }

            /// The same shape with other numbers, in the order of [`Shape::parameters`].
            pub(crate) fn with_parameters(self, values: &[f64]) -> Shape {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => Shape::$kind(shape.with_parameters(values)), )+
                }
            }

            /// Refuses parameters within the range of numbers whose products leave it.
            #[inline]
            pub(crate) fn finite(self) -> Result<Shape> {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.finite().map(Shape::$kind), )+
                }
            }

            /// The one way of writing this surface to twelve significant digits.
            #[inline]
            pub(crate) fn canonical(self) -> Result<Shape> {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => shape.canonical().map(Shape::$kind), )+
                }
            }

            /// The one way of writing the solid that this shape makes where it stands: see [`Described::standing`].
            #[inline]
            pub(crate) fn standing(self, given: &Placement, place: Placement) -> (Shape, Placement) {
                match self {
                    $( $(#[cfg(feature = $feature)])? Shape::$kind(shape) => {
                        let (shape, place) = shape.standing(given, place);
                        (Shape::$kind(shape), place)
                    } )+
                }
            }
        }
    };
}

shapes! {
    /// `second-order`, ZY01 eqs 1-8.
    SecondOrder = "second-order",
    /// `mixed-order`, ZY01 eqs 9-12.
    MixedOrder = "mixed-order",
    /// `fourth-order`, ZY01 eqs 13-17.
    FourthOrder = "fourth-order",
    /// `bloor-wilson`, IA eqs 15-18.
    BloorWilson = "bloor-wilson",
    /// `boundary-value`: any Fourier boundary data.
    BoundaryValue = "boundary-value",
    /// `rings`: a pot by the radius and the height of its rings.
    Rings = "rings",
    /// `vertex-frame`: four-sided patches through a network of points, W22.
    VertexFrame = "vertex-frame" if "patchwork",
    /// `blend`: a solid that flows from one section into another, ZY04.
    Blend = "blend" if "patchwork",
    /// `octant`: the octant `x^a + y^b + z^c <= 1` of a supersphere, ASB88.
    Octant = "octant" if "patchwork",
}

/// A kind of shape.
pub(crate) struct Kind {
    /// The word in a document's `kind`.
    pub(crate) name: &'static str,
    #[cfg(feature = "typescript")]
    pub(crate) family: Option<Family>,
    /// How a readable link says it.
    pub(crate) spelling: Option<Spelling>,
    /// Its type in TypeScript.
    #[cfg(feature = "typescript")]
    pub(crate) type_name: &'static str,
    /// Writes its declarations.
    #[cfg(feature = "typescript")]
    pub(crate) typescript: fn(&str, &mut String),
}

impl Shape {
    /// Reads and checks a bare shape from JSON text.
    ///
    /// The shape is as given. Only a whole [`Design`](crate::Design) is brought into canonical form.
    ///
    /// ```
    /// use pasu::Shape;
    ///
    /// let error = Shape::parse(r#"{ "kind": "second-order", "r": [1, 0.1, 0.6] }"#).unwrap_err();
    /// assert_eq!(error.to_string(), "r: expected a list of 4 numbers, found a list of 3");
    /// ```
    ///
    /// # Errors
    /// As [`Design::parse`](crate::Design::parse), with paths that begin at the shape.
    pub fn parse(text: &str) -> Result<Shape> {
        reader::read::<Shape>(&text::read(text)?)?.finite()
    }

    /// The boundary-value problem of this shape; `None` of one that is no surface between two ends.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson?a=3")?;
    /// let problem = vase.parts()[0].shape.boundary_value().expect("a vase has two ends");
    /// // s = 1, t = 2 a^2, w = a^4
    /// assert_eq!((problem.x.s, problem.x.t, problem.x.w), (1.0, 18.0, 81.0));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn boundary_value(&self) -> Option<BoundaryValue> {
        self.problem().map(Cow::into_owned)
    }
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(Shape, "Shape");
