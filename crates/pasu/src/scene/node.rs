//! What a tree of a scene is made of: solids and unions of them.

use serde::Serialize;

use crate::design::{Joints, Look, Motion, Shape, Wall, written};

/// A leaf or a union, with where it stands.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Node {
    /// What stands there.
    #[serde(flatten)]
    pub content: Content,
    /// Where, seen from the first member of the union that it is in; that member itself is not moved. Of the root, where the whole stands.
    #[serde(skip_serializing_if = "written::is_default")]
    pub place: Motion,
}

/// What a node of a [`Tree`](super::tree::Tree) is.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
#[non_exhaustive]
pub enum Content {
    /// A solid.
    Leaf(Box<Leaf>),
    /// Leaves and connected unions, glued into one object.
    Connected {
        /// Two or more.
        connected: Vec<Node>,
    },
    /// Objects and sets of them, apart from each other.
    Unconnected {
        /// Two or more.
        unconnected: Vec<Node>,
    },
}

/// A solid of a [`Tree`](super::tree::Tree): a part of a design without its place.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Leaf {
    /// Its name, different from that of every other leaf.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its surface.
    pub shape: Shape,
    /// Factors along x, y and z.
    #[serde(skip_serializing_if = "is_as_it_is")]
    pub scale: [f64; 3],
    /// The wall that makes its surface a pot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall: Option<Wall>,
    /// Its clay and glaze.
    #[serde(skip_serializing_if = "written::is_default")]
    pub look: Look,
    /// By which numbers of its placement it can be moved, in the coordinates of the scene.
    #[serde(skip_serializing_if = "written::is_default")]
    pub joints: Joints,
}

fn is_as_it_is(scale: &[f64; 3]) -> bool {
    *scale == [1.0; 3]
}
