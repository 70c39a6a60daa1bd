//! A scene as the tree of its unions (ASB88's additive constructive solid geometry), and the one tree of a design.

use serde::{Deserialize, Deserializer, Serialize};

use super::branch::Branch;
use super::node::{Content, Leaf, Node};
use crate::design::{Design, Motion, Part, Unit, Value, written};
use crate::error::Result;

/// A scene as a tree: at its leaves solids, above them connected unions, which glue, and above these unconnected unions, which put apart.
///
/// Only leaves scale. The first member of a union stands where the union does, every other is rotated and moved as seen from the first, and the root places the whole. The members of a connected union are one solid: from each of them
/// one comes to every other through members that share points. A union of two is that of the paper; one of more is short for unions of two that each have the one before as their first member.
///
/// A `Tree` can only be made by reading one, or of a design by [`tree()`]. Its unions nest at most 24 deep, and it has at most 500 leaves. `docs/scenes.md` has the fields.
///
/// ```
/// use pasu::{Tree, flat};
///
/// let jar = Tree::parse(
///     r#"{ "pasu": 1, "tree": { "connected": [
///         { "name": "jar", "shape": { "kind": "second-order", "r": [3, 0, 2, 0], "height": 4 } },
///         { "name": "knob", "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "scale": [0.5, 0.5, 0.5], "place": { "shift": [0, 0, 4] } }
///     ], "place": { "shift": [10, 0, 0] } } }"#,
/// )?;
/// assert_eq!(flat(&jar)?.parts()[1].place.shift, [10.0, 0.0, 4.0]);
/// # Ok::<(), pasu::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Tree {
    pasu: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    #[serde(skip_serializing_if = "written::is_default")]
    unit: Unit,
    tree: Node,
}

/// The tree of a design: its objects in the order of links, apart from each other where there are several, and in each the parts in that order, glued where there are several.
///
/// Equal scenes have equal trees, as far as double precision holds what twelve digits tell. [`flat`](super::flat()) gives the scene back.
///
/// ```
/// let two = r#"{ "pasu": 1, "parts": [
///     { "object": 1, "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "shift": [3, 0, 1] } },
///     { "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "shift": [1, 0, 0] } }
/// ] }"#;
/// let octant = r#""shape":{"kind":"octant","exponents":[2,2,2]}"#;
/// let tree = pasu::tree(&pasu::Design::parse(two)?);
/// assert_eq!(
///     tree.to_json(),
///     format!(r#"{{"pasu":1,"tree":{{"unconnected":[{{{octant}}},{{{octant},"place":{{"shift":[2,0,1]}}}}],"place":{{"shift":[1,0,0]}}}}}}"#)
/// );
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn tree(design: &Design) -> Tree {
    let design = design.ordered();
    // Of each object its parts; in the order of links the first part of an object comes before that of the next.
    let mut objects: Vec<Vec<&Part>> = Vec::new();
    for part in design.parts() {
        match objects.get_mut(part.object as usize) {
            Some(members) => members.push(part),
            None => objects.push(vec![part]),
        }
    }
    let united = |nodes: Vec<Node>, content: fn(Vec<Node>) -> Content| {
        let first = nodes.first().map_or_else(Motion::default, |node| node.place);
        let seen = |node: Node| Node { place: node.place.seen_from(&first), ..node };
        let mut nodes = nodes;
        match nodes.len() {
            1 => nodes.pop(),
            _ => Some(Node { content: content(nodes.into_iter().map(seen).collect()), place: first }),
        }
    };
    let glued = |members: Vec<&Part>| {
        let leaves = members.into_iter().map(Node::of).collect();
        united(leaves, |connected| Content::Connected { connected })
    };
    let all = objects.into_iter().filter_map(glued).collect();
    let root = united(all, |unconnected| Content::Unconnected { unconnected });
    // A design has a part, and so its tree has a leaf.
    let tree = root.unwrap_or_else(|| Node::of(&design.parts()[0]));
    Tree { pasu: written::VERSION, title: design.title().map(str::to_owned), unit: design.unit(), tree }
}

impl Node {
    /// A part as a leaf that stands where it does.
    fn of(part: &Part) -> Node {
        let Part { name, object: _, shape, place, wall, look, joints } = part.clone();
        let leaf = Leaf { name, shape, scale: place.scale, wall, look, joints };
        Node { content: Content::Leaf(Box::new(leaf)), place: Motion::of(&place) }
    }
}

impl Tree {
    /// Reads a tree from JSON text.
    ///
    /// ```
    /// let error = pasu::Tree::parse(r#"{ "pasu": 1, "tree": { "connected": [] } }"#).unwrap_err();
    /// assert_eq!(error.path(), "tree.connected");
    /// ```
    ///
    /// # Errors
    /// As [`Tree::read`], and `not-json`.
    pub fn parse(json: &str) -> Result<Tree> {
        let value = written::text(json)?;
        let tree = Tree::from_value(&value)?;
        written::without_null(&value)?;
        Ok(tree)
    }

    /// Reads a tree from any plain data whose reader refuses with this crate's error, as [`Design::read`] does.
    ///
    /// # Errors
    /// What [`Design::read`] refuses of the fields that a leaf shares with a part, each with its path in the tree; `unknown-field` for a scale, a name, a wall or a look of a union; `out-of-range` for the place of the first member of a
    /// union, an unconnected union within a connected one, and a union of fewer than two; `too-large` for more than 500 leaves and unions that nest more than 24 deep. What only the whole shows, names that are not unique among it, [`flat`](super::flat()) refuses.
    pub fn read<'de, D: Deserializer<'de, Error = crate::error::Error>>(source: D) -> Result<Tree> {
        Tree::from_value(&written::buffered(source)?)
    }

    fn from_value(value: &Value) -> Result<Tree> {
        written::check_version(value)?;
        let Document { pasu, title, unit, tree } = written::read(value)?;
        Ok(Tree { pasu, title, unit, tree: tree.checked()? })
    }

    /// The tree as JSON, on one line. Numbers that were computed have all their digits.
    ///
    /// ```
    /// let vase = pasu::tree(&pasu::Design::parse("#1/bloor-wilson")?);
    /// assert!(vase.to_json().starts_with(r#"{"pasu":1,"tree":{"shape":{"kind":"bloor-wilson","#));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn to_json(&self) -> String {
        written::to_json(self)
    }

    /// The title, if it has one.
    ///
    /// ```
    /// assert_eq!(pasu::tree(&pasu::Design::parse("#1/bloor-wilson")?).title(), None);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    /// What 1 means.
    ///
    /// ```
    /// assert_eq!(pasu::tree(&pasu::Design::parse("#1/bloor-wilson")?).unit(), pasu::Unit::Cm);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// The root.
    ///
    /// ```
    /// let vase = pasu::tree(&pasu::Design::parse("#1/bloor-wilson")?);
    /// assert!(matches!(vase.root().content, pasu::Content::Leaf(_)));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn root(&self) -> &Node {
        &self.tree
    }
}

/// The fields of a tree's document.
#[derive(Deserialize)]
#[serde(expecting = "a tree")]
struct Document {
    #[serde(deserialize_with = "written::whole")]
    pasu: u32,
    #[serde(deserialize_with = "written::label")]
    title: Option<String>,
    #[serde(deserialize_with = "written::or_default")]
    unit: Unit,
    tree: Branch,
}
