//! One placed surface of a design.

use serde::{Deserialize, Serialize};

use super::joint::Joints;
use super::label;
use super::look::Look;
use super::placement::Placement;
use super::quantity::{is_default, or_default, whole};
use super::shape::Shape;
use super::wall::Wall;
use crate::error::Result;

/// A part of a [`Design`](crate::Design).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "a part")]
#[non_exhaustive]
pub struct Part {
    /// Its name, different from that of every other part.
    #[serde(deserialize_with = "label::read", skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The discrete object that it is glued into.
    #[serde(deserialize_with = "whole", skip_serializing_if = "is_default")]
    pub object: u32,
    /// Its surface, before placement.
    pub shape: Shape,
    /// Where it stands.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub place: Placement,
    /// The wall that makes its surface a pot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall: Option<Wall>,
    /// Its clay and glaze.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub look: Look,
    /// By which numbers of its placement it can be moved.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub joints: Joints,
}

impl Part {
    /// Whether another part is the same body in the same place, whatever it is called and looks like.
    pub(crate) fn stands_as(&self, other: &Part) -> bool {
        self.place == other.place && self.wall == other.wall && self.shape == other.shape
    }

    /// The one way of writing this part.
    #[inline]
    pub(crate) fn canonical(self) -> Result<Self> {
        let shape = self.shape.canonical().map_err(|error| error.inside_field("shape"))?;
        let place = self.place.canonical().map_err(|error| error.inside_field("place"))?;
        let joints = self.joints.canonical().map_err(|error| error.inside_field("joints"))?;
        let wall = self.wall.map(Wall::canonical).transpose().map_err(|error| error.inside_field("wall"))?;
        let (shape, place) = shape.standing(&self.place, place);
        Ok(Part { shape, place, wall, look: self.look.canonical(), joints, ..self })
    }
}
