//! What makes an open surface a pot.

use serde::{Deserialize, Serialize};

use super::limits::WAVES;
use super::names::names;
use super::number::rounded;
use super::quantity::{
    is_default, is_zero, maybe_positive, not_negative, not_negative_or_zero, or_default, positive, whole,
};
#[cfg(feature = "typescript")]
use super::slider::Which;
use crate::error::{Code, Error, Result};

/// The clay between the surface and the lining, in model units after placement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "a wall with thickness and base")]
#[non_exhaustive]
pub struct Wall {
    /// The thickness of the wall along the normal; greater than 0.
    #[serde(deserialize_with = "positive")]
    pub thickness: f64,
    /// The thickness of the base; 0 for a pot without one.
    #[serde(deserialize_with = "not_negative")]
    pub base: f64,
    /// Which side of the wall the surface is not: where the clay goes.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub side: Side,
    /// How the wall ends at an opening.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub rim: RimForm,
    /// Width and height of a ring under the base, both greater than 0, for a pot that stands on one.
    #[serde(deserialize_with = "maybe_positive", skip_serializing_if = "Option::is_none")]
    pub foot: Option<[f64; 2]>,
    /// The diameter of a round hole through the base; 0 for none.
    #[serde(deserialize_with = "not_negative_or_zero", skip_serializing_if = "is_zero")]
    pub drain: f64,
    /// An inside that does not follow the outside; where there is none, the other side of the wall is the surface at the distance of the thickness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lining: Option<Lining>,
}

/// A lining of its own: a surface between two curves like the outside, with fewer waves round it, drawn in by so much that the wall is nowhere thinner than its thickness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(expecting = "a lining with its number of waves")]
#[non_exhaustive]
pub struct Lining {
    /// The most waves round it that it keeps of those of the outside; 0 for a lining that is round, or an ellipse where the outside is one.
    #[serde(deserialize_with = "whole", skip_serializing_if = "is_default")]
    pub waves: u32,
}

names! {
    /// Where the clay of a wall goes.
    pub enum Side {
        /// Inwards: the surface is the outside of the pot.
        Inside = "inside",
        /// Outwards: the surface is the lining of the pot.
        Outside = "outside",
    }
}

names! {
    /// How a wall ends at an opening.
    #[non_exhaustive]
    pub enum RimForm {
        /// Cut square across the wall.
        Flat = "flat",
        /// Half a circle as wide as the wall.
        Rounded = "rounded",
    }
}

/// The numbers of a wall as a person changes them, in the order in which they are shown: the field, which of its numbers, and where its slider ends, as a share of the
/// size of the pot. All are lengths, from 0.
#[cfg(feature = "typescript")]
pub(super) const SLIDERS: [(&str, Which, f64); 5] = [
    ("thickness", Which::Only, 0.2),
    ("base", Which::Only, 0.2),
    ("foot", Which::At(0), 0.2),
    ("foot", Which::At(1), 0.2),
    ("drain", Which::Only, 0.4),
];

impl Wall {
    /// Every number to twelve significant digits.
    ///
    /// # Errors
    /// `out-of-range` for a lining of more waves than are made of anything, or inside clay that goes outwards.
    pub(crate) fn canonical(self) -> Result<Self> {
        if let Some(Lining { waves }) = self.lining {
            if f64::from(waves) > WAVES {
                let message = format!("expected a whole number from 0 to {WAVES}, found {waves}");
                let error = Error::new(Code::OutOfRange, "lining.waves", message).with("least", 0.0);
                return Err(error.with("greatest", WAVES).with("found", f64::from(waves)));
            }
            if self.side == Side::Outside {
                let message = "the surface is itself the lining of a wall whose clay goes outwards: expected the side \"inside\", or no lining";
                return Err(Error::new(Code::OutOfRange, "lining", message).with("what", "lining-outside"));
            }
        }
        Ok(Wall {
            thickness: rounded(self.thickness),
            base: rounded(self.base),
            foot: self.foot.map(|ring| ring.map(rounded)),
            drain: rounded(self.drain),
            ..self
        })
    }
}
