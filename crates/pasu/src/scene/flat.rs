//! From a tree to the flat list of its leaves.

use std::collections::HashMap;

use super::node::{Content, Node};
use super::tree::Tree;
use crate::design::{Design, Motion, Part, name_taken};
use crate::error::{Code, Error, Result};

/// The design of a tree: its leaves, in the order in which they stand in it, each where the unions above it put it, and glued into an object as the connected unions say.
///
/// Objects are numbered 0, 1, 2 as they first appear. Placements are put together in double precision and rounded once, as the design is made.
///
/// ```
/// use pasu::{Design, flat, tree};
///
/// let vase = Design::parse("#1/bloor-wilson?n1=5")?;
/// assert_eq!(flat(&tree(&vase))?, vase);
/// # Ok::<(), pasu::Error>(())
/// ```
///
/// # Errors
/// As [`Design::read`], each with its path in the tree; `overflow` where shifts add up to more than numbers hold.
pub fn flat(tree: &Tree) -> Result<Design> {
    let mut leaves = Leaves { parts: Vec::new(), paths: Vec::new(), names: HashMap::new(), n_objects: 0 };
    leaves.take(tree.root(), &Motion::default(), "tree", false)?;
    let Leaves { parts, paths, .. } = leaves;
    let design = Design::of_parts(tree.title().map(str::to_owned), tree.unit(), parts);
    design.map_err(|error| told(error, &paths))
}

/// What was found on the way through a tree.
struct Leaves {
    parts: Vec<Part>,
    paths: Vec<String>,
    /// The paths of the leaves that have names.
    names: HashMap<String, String>,
    n_objects: u32,
}

impl Leaves {
    /// What a node is made of. A tree that was read nests to a limited depth, and so does this.
    fn take(&mut self, node: &Node, frame: &Motion, path: &str, is_glued: bool) -> Result<()> {
        let place = frame.around(&node.place);
        if !place.shift.iter().all(|c| c.is_finite()) {
            let message = "these shifts are so large that their sum cannot be computed";
            return Err(Error::new(Code::Overflow, format!("{path}.place.shift"), message));
        }
        let (members, field) = match &node.content {
            Content::Leaf(leaf) => {
                let object = if is_glued { self.n_objects.saturating_sub(1) } else { self.n_objects };
                self.n_objects = object + 1;
                // The design would say by which of its parts the name is taken, and a tree has leaves.
                if let Some(name) = &leaf.name
                    && let Some(earlier) = self.names.insert(name.clone(), path.to_owned())
                {
                    return Err(name_taken(name, &earlier).at(format!("{path}.name")));
                }
                self.paths.push(path.to_owned());
                self.parts.push(Part {
                    name: leaf.name.clone(),
                    object,
                    shape: leaf.shape.clone(),
                    place: place.placing(leaf.scale),
                    wall: leaf.wall,
                    look: leaf.look,
                    joints: leaf.joints.clone(),
                });
                return Ok(());
            }
            Content::Connected { connected } => {
                if !is_glued {
                    self.n_objects += 1;
                }
                (connected, "connected")
            }
            Content::Unconnected { unconnected } => (unconnected, "unconnected"),
        };
        for (index, member) in members.iter().enumerate() {
            let path = format!("{path}.{field}[{index}]");
            self.take(member, &place, &path, matches!(node.content, Content::Connected { .. }))?;
        }
        Ok(())
    }
}

/// A refusal of a part as one of the leaf that it was made of.
fn told(error: Error, paths: &[String]) -> Error {
    let path = error.path().to_owned();
    let Some((number, rest)) = path.strip_prefix("parts[").and_then(|rest| rest.split_once(']')) else { return error };
    let Some(leaf) = number.parse().ok().and_then(|index: usize| paths.get(index)) else { return error };
    // What of a placement is the leaf's own.
    let rest = rest.strip_prefix(".place.scale").map_or_else(|| rest.to_owned(), |rest| format!(".scale{rest}"));
    error.at(format!("{leaf}{rest}"))
}
