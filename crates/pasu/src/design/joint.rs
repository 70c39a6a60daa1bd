//! Which numbers of a placement are sliders of the scene (articulation).

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::label;
use super::number::{plain, rounded};
use super::placement::direction;
use super::quantity::{Range, any, is_default, or, or_default};
use crate::error::{Code, Error, Result};

/// By which numbers of its placement a part can be moved, each within limits.
///
/// What a joint has now stands in the placement, and nowhere else: it may be outside the limits. Joints do not say what a scene is: they change neither its fingerprint nor what it is compared with, and they travel with it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(expecting = "joints by the numbers that they move: x, y, z or turn")]
#[non_exhaustive]
pub struct Joints {
    /// Of the shift along x.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x: Option<Joint>,
    /// Of the shift along y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<Joint>,
    /// Of the shift along z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z: Option<Joint>,
    /// Of the turn about an axis of the scene through where the origin of the shape stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turn: Option<Joint>,
}

/// How far one number of a placement goes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "a joint with its limits")]
#[non_exhaustive]
pub struct Joint {
    /// What it is called.
    #[serde(deserialize_with = "label::read", skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// From where to where it goes: coordinates of the shift, or radians, of which no more than a whole turn either way.
    #[serde(deserialize_with = "any")]
    pub limits: [f64; 2],
    /// The axis that a turn is about, in the coordinates of the scene: how far a part is turned about it is twice the angle of `(w, axis . v)`, where `(w, v)` is the unit quaternion of its rotation. Only a turn has one.
    #[serde(deserialize_with = "upright", skip_serializing_if = "is_upright")]
    pub axis: [f64; 3],
    /// Whether all that is glued to the part goes along.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub glued: bool,
}

const UPRIGHT: [f64; 3] = [0.0, 0.0, 1.0];

fn upright<'de, D: serde::Deserializer<'de>>(deserializer: D) -> std::result::Result<[f64; 3], D::Error> {
    or(deserializer, Range::Any, UPRIGHT)
}

fn is_upright(axis: &[f64; 3]) -> bool {
    *axis == UPRIGHT
}

impl Joints {
    /// The one way of writing them.
    ///
    /// # Errors
    /// `out-of-range` where the second limit is not above the first (to twelve digits), a turn goes further than a whole one or has no axis, and where what is no turn has one.
    #[inline]
    pub(crate) fn canonical(mut self) -> Result<Self> {
        let turn = (&mut self.turn, "turn");
        for (joint, name) in [(&mut self.x, "x"), (&mut self.y, "y"), (&mut self.z, "z"), turn] {
            if let Some(joint) = joint {
                joint.settle(name == "turn").map_err(|error| error.inside_field(name))?;
            }
        }
        Ok(self)
    }
}

impl Joint {
    fn settle(&mut self, is_turn: bool) -> Result<()> {
        self.limits = self.limits.map(rounded);
        let [least, most] = self.limits;
        if least >= most {
            let message = format!("expected a number greater than {}, found {}", plain(least), plain(most));
            let error = Error::new(Code::OutOfRange, "limits[1]", message);
            return Err(error.with("above", least).with("found", most));
        }
        if !is_turn {
            return match is_upright(&self.axis) {
                true => Ok(()),
                false => {
                    let message = "only a turn has an axis: expected none of a shift";
                    Err(Error::new(Code::UnknownField, "axis", message).with("found", "axis"))
                }
            };
        }
        let whole = rounded(TAU);
        for (index, limit) in self.limits.into_iter().enumerate() {
            if limit.abs() > whole {
                let range = [plain(-whole), plain(whole)];
                let message = format!("expected an angle from {} to {}, found {}", range[0], range[1], plain(limit));
                let error = Error::new(Code::OutOfRange, "", message).with("least", -whole).with("greatest", whole);
                return Err(error.with("found", limit).inside_item(index).inside_field("limits"));
            }
        }
        let Some(axis) = direction(self.axis) else {
            let message = "expected the direction of an axis, found [0, 0, 0]";
            return Err(Error::new(Code::OutOfRange, "axis", message));
        };
        self.axis = axis;
        Ok(())
    }
}
