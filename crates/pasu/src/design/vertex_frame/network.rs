//! The fields of a network of vertex-frames.

use core::f64::consts::PI;
use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, Unexpected, Visitor};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::design::limits::{FORCES, PATCHES, VERTICES};
use crate::design::list;
use crate::design::names::names;
use crate::design::quantity::{Index, Quantity, Range, any, is_default, or, or_default};

/// Four-sided patches, each through the eight points of its frame. Patches whose frames have the three points of an edge in common are joined there, in whatever direction each passes it.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(expecting = "a shape")]
pub struct VertexFrame {
    /// The points, to which patches refer by their number.
    #[serde(deserialize_with = "vertices")]
    pub vertices: Vec<[f64; 3]>,
    /// At least one.
    #[serde(deserialize_with = "patches")]
    pub patches: Vec<FramePatch>,
    /// How the cubic terms of the edges are decided.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub rule: FrameRule,
    /// How smoothly patches meet.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub continuity: Continuity,
    /// Edges at which the surface turns by less than this angle are drawn as if it were smooth, in radians; [`VertexFrame::CREASE`] when left out.
    #[serde(deserialize_with = "crease", skip_serializing_if = "is_usual")]
    pub crease: f64,
}

impl VertexFrame {
    /// The angle of a crease where none is given. Frozen with version 1 of the format.
    pub const CREASE: f64 = 0.5;
}

/// One patch of a network, `a1 X_uu + a2 X_vv = 0` as nearly as its points leave it free to be, and what sculpts it.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(expecting = "a patch with its frame")]
pub struct FramePatch {
    /// The numbers of eight vertices, at `(u, v) = (0, 0) (.5, 0) (1, 0) (1, .5) (1, 1) (.5, 1) (0, 1) (0, .5)`.
    #[serde(deserialize_with = "frame")]
    pub frame: [u32; 8],
    /// Shape control parameters of `X_uu`, one for each component; 1 when left out.
    #[serde(deserialize_with = "ones", skip_serializing_if = "are_ones")]
    pub a1: [f64; 3],
    /// The same of `X_vv`.
    #[serde(deserialize_with = "ones", skip_serializing_if = "are_ones")]
    pub a2: [f64; 3],
    /// Sculpting forces, which add up.
    #[serde(deserialize_with = "forces", skip_serializing_if = "Vec::is_empty")]
    pub forces: Vec<Force>,
}

/// A sculpting force: a swelling of height `-f0 / (pi^2 (a1 + a2))` on a rectangle.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(expecting = "a force with f0")]
pub struct Force {
    /// How strong, one number for each component.
    #[serde(deserialize_with = "any")]
    pub f0: [f64; 3],
    /// From where to where along `u` of the patch, ascending; all of it when left out.
    #[serde(deserialize_with = "whole_side", skip_serializing_if = "is_whole_side")]
    pub u: [f64; 2],
    /// The same along `v`.
    #[serde(deserialize_with = "whole_side", skip_serializing_if = "is_whole_side")]
    pub v: [f64; 2],
    /// How it falls off towards the rim of the rectangle.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub falloff: Falloff,
}

names! {
    /// How a force falls off.
    pub enum Falloff {
        /// As `sin(pi u) sin(pi v)`, with a crease along the rim.
        Sine = "sine",
        /// As the square of that, which meets what is round it without a crease.
        Smooth = "smooth",
    }
}

names! {
    /// How smoothly patches meet.
    #[non_exhaustive]
    pub enum Continuity {
        /// They have their edges in common.
        C0 = "C0",
    }
}

/// How the cubic term of a strip is decided, which all its edges have in common: from edge to opposite edge, a strip runs through patch after patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FrameRule {
    /// It makes the squared residuals of all patches of the strip least.
    #[default]
    Global,
    /// It makes that of the patch of the strip least which comes first in a breadth-first walk from this patch: the rule of W22.
    Seed(u32),
}

/// How documents write [`FrameRule::Global`].
const GLOBAL: &str = "global";

impl Serialize for FrameRule {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            FrameRule::Global => serializer.serialize_str(GLOBAL),
            FrameRule::Seed(patch) => {
                let mut fields = serializer.serialize_struct("Seed", 1)?;
                fields.serialize_field("seed", patch)?;
                fields.end()
            }
        }
    }
}

impl<'de> Deserialize<'de> for FrameRule {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RuleVisitor)
    }
}

struct RuleVisitor;

impl<'de> Visitor<'de> for RuleVisitor {
    type Value = FrameRule;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"global\" or the number of a patch as seed")
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<FrameRule, E> {
        if text == GLOBAL { Ok(FrameRule::Global) } else { Err(E::unknown_variant(text, &[GLOBAL])) }
    }

    fn visit_map<A: MapAccess<'de>>(self, fields: A) -> Result<FrameRule, A::Error> {
        #[derive(serde::Deserialize)]
        #[serde(deny_unknown_fields, expecting = "the number of a patch as seed")]
        struct Seed {
            seed: Index,
        }
        let Seed { seed: Index(patch) } = Seed::deserialize(MapAccessDeserializer::new(fields))?;
        Ok(FrameRule::Seed(patch))
    }
}

fn vertices<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<[f64; 3]>, D::Error> {
    struct Vertex([f64; 3]);

    impl<'de> Deserialize<'de> for Vertex {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            any(deserializer).map(Vertex)
        }
    }

    let most = format!("at most {VERTICES} vertices");
    let vertices: Vec<Vertex> = list::read(deserializer, "a list of vertices", Some((VERTICES, &most)))?;
    Ok(vertices.into_iter().map(|Vertex(at)| at).collect())
}

fn patches<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<FramePatch>, D::Error> {
    let (expected, most) = (format!("a list of 1 to {PATCHES} patches"), format!("at most {PATCHES} patches"));
    let patches: Vec<FramePatch> = list::read(deserializer, &expected, Some((PATCHES, &most)))?;
    match patches.is_empty() {
        true => Err(D::Error::invalid_value(Unexpected::Other("an empty list"), &expected.as_str())),
        false => Ok(patches),
    }
}

fn frame<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[u32; 8], D::Error> {
    const EXPECTED: &str = "a list of 8 numbers of vertices";
    let indices: Vec<Index> = list::read(deserializer, EXPECTED, None)?;
    let found = indices.len();
    let numbers: Vec<u32> = indices.into_iter().map(|Index(number)| number).collect();
    numbers.try_into().map_err(|_| {
        let found = if found == 0 { "an empty list".to_owned() } else { format!("a list of {found}") };
        D::Error::invalid_type(Unexpected::Other(&found), &EXPECTED)
    })
}

fn forces<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Force>, D::Error> {
    #[derive(Default)]
    struct Forces(Vec<Force>);

    impl<'de> Deserialize<'de> for Forces {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let most = format!("at most {FORCES} forces on a patch");
            list::read(deserializer, "a list of forces", Some((FORCES, &most))).map(Forces)
        }
    }

    or_default(deserializer).map(|Forces(forces)| forces)
}

fn crease<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    const { assert!(VertexFrame::CREASE < PI) };
    or(deserializer, Range::NotNegative, VertexFrame::CREASE)
}

fn is_usual(crease: &f64) -> bool {
    *crease == VertexFrame::CREASE
}

const ONES: [f64; 3] = [1.0; 3];

fn ones<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; 3], D::Error> {
    or(deserializer, Range::Any, ONES)
}

fn are_ones(parameters: &[f64; 3]) -> bool {
    *parameters == ONES
}

/// All of a side of a patch.
const WHOLE_SIDE: [f64; 2] = [0.0, 1.0];

fn whole_side<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; 2], D::Error> {
    or(deserializer, Range::Any, WHOLE_SIDE)
}

fn is_whole_side(side: &[f64; 2]) -> bool {
    *side == WHOLE_SIDE
}

impl VertexFrame {
    /// Every number that is not an index.
    pub(super) fn numbers_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        let vertices = self.vertices.iter_mut().flat_map(Quantity::as_numbers_mut);
        let patches = self.patches.iter_mut().flat_map(|FramePatch { a1, a2, forces, .. }| {
            let forces = forces.iter_mut().flat_map(|Force { f0, u, v, .. }| f0.iter_mut().chain(u).chain(v));
            a1.iter_mut().chain(a2).chain(forces)
        });
        vertices.chain(patches).chain([&mut self.crease])
    }
}
