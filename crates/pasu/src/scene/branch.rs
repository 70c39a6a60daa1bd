//! A node of a tree as it is read, before it is known to be a leaf or a union.

use serde::Deserialize;

use super::node::{Content, Leaf, Node};
use crate::design::{Joints, Look, Motion, Shape, Wall, written};
use crate::error::{Code, Error, Result};

/// How deep unions may nest. A union takes any number of members, so that no tree has to be deep.
const DEEPEST: usize = 24;

/// Every field that a node may have.
#[derive(Deserialize)]
#[serde(expecting = "a leaf or a union")]
pub(super) struct Branch {
    #[serde(deserialize_with = "written::label")]
    name: Option<String>,
    shape: Option<Shape>,
    #[serde(deserialize_with = "written::maybe_not_zero")]
    scale: Option<[f64; 3]>,
    wall: Option<Wall>,
    look: Option<Look>,
    joints: Option<Joints>,
    connected: Option<Vec<Branch>>,
    unconnected: Option<Vec<Branch>>,
    #[serde(deserialize_with = "written::or_default")]
    place: Motion,
}

/// Where in a tree a node stands.
#[derive(Clone, Copy)]
struct Standing {
    depth: usize,
    is_first: bool,
    is_glued: bool,
}

impl Branch {
    /// The root, as the node that it is.
    pub(super) fn checked(self) -> Result<Node> {
        let mut n_leaves = 0;
        let root = Standing { depth: 0, is_first: false, is_glued: false };
        self.node(root, &mut n_leaves).map_err(|error| error.inside_field("tree"))
    }

    /// The node, where it may stand. Values are read to a limited depth, and so is this.
    fn node(self, standing: Standing, n_leaves: &mut usize) -> Result<Node> {
        let Branch { name, shape, scale, wall, look, joints, connected, unconnected, place } = self;
        if standing.is_first && place != Motion::default() {
            let message = "the first member of a union stands where the union does: expected no place, found one";
            return Err(Error::new(Code::OutOfRange, "place", message));
        }
        if place.axis == [0.0; 3] {
            let message = "expected the direction of an axis, found [0, 0, 0]";
            return Err(Error::new(Code::OutOfRange, "place.axis", message));
        }
        let union = match (shape, connected, unconnected) {
            (Some(shape), None, None) => {
                *n_leaves += 1;
                if *n_leaves > written::PARTS {
                    let message =
                        format!("expected at most {} leaves in a tree; this one exceeds them", written::PARTS);
                    return Err(Error::new(Code::TooLarge, "", message).with("greatest", written::PARTS));
                }
                let (scale, look) = (scale.unwrap_or([1.0; 3]), look.unwrap_or_default());
                let leaf = Leaf { name, shape, scale, wall, look, joints: joints.unwrap_or_default() };
                return Ok(Node { content: Content::Leaf(Box::new(leaf)), place });
            }
            (None, Some(members), None) => (members, true),
            (None, None, Some(members)) => (members, false),
            (None, None, None) => {
                let message = "expected shape, connected or unconnected, found none of them";
                return Err(Error::new(Code::MissingField, "", message));
            }
            _ => {
                let message = "expected one of shape, connected and unconnected, found several";
                return Err(Error::new(Code::Duplicate, "", message));
            }
        };
        let of_leaves = [
            ("name", name.is_some()),
            ("scale", scale.is_some()),
            ("wall", wall.is_some()),
            ("look", look.is_some()),
            ("joints", joints.is_some()),
        ];
        if let Some((field, _)) = of_leaves.into_iter().find(|(_, is_given)| *is_given) {
            let message = format!("only leaves have a {field}: expected none of a union");
            return Err(Error::new(Code::UnknownField, field, message).with("found", field));
        }
        let (members, is_glued) = union;
        let field = if is_glued { "connected" } else { "unconnected" };
        if standing.is_glued && !is_glued {
            let message = "within a connected union: expected a leaf or a connected union, found an unconnected one";
            return Err(Error::new(Code::OutOfRange, field, message));
        }
        if standing.depth == DEEPEST {
            let message =
                format!("expected unions that nest at most {DEEPEST} deep; a union may have any number of members");
            return Err(Error::new(Code::TooLarge, field, message).with("greatest", DEEPEST));
        }
        if members.len() < 2 {
            let message = format!("expected a list of 2 or more members of a union, found a list of {}", members.len());
            let error = Error::new(Code::OutOfRange, field, message).with("least", 2.0);
            return Err(error.with("found", members.len()));
        }
        let mut nodes = Vec::with_capacity(members.len().min(written::PARTS));
        for (index, member) in members.into_iter().enumerate() {
            let inside = Standing { depth: standing.depth + 1, is_first: index == 0, is_glued };
            let node = member.node(inside, n_leaves);
            nodes.push(node.map_err(|error| error.inside_item(index).inside_field(field))?);
        }
        let content = match is_glued {
            true => Content::Connected { connected: nodes },
            false => Content::Unconnected { unconnected: nodes },
        };
        Ok(Node { content, place })
    }
}
