//! What a part is made of and covered with.

use serde::{Deserialize, Serialize};

use super::names::names;
use super::quantity::{is_default, or_default};

/// The clay and the glaze of a part. They change no geometry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(expecting = "a look with glaze and clay")]
#[non_exhaustive]
pub struct Look {
    /// What covers the part.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub glaze: Glaze,
    /// What the part is made of.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub clay: Clay,
}

names! {
    /// A glaze.
    #[non_exhaustive]
    pub enum Glaze {
        /// Grey-green, glassy, pooling in hollows.
        Celadon = "celadon",
        /// Black-brown, breaking to rust on edges.
        Tenmoku = "tenmoku",
        /// Deep blue.
        Cobalt = "cobalt",
        /// Opaque white.
        TinWhite = "tin-white",
        /// Milky orange-white.
        Shino = "shino",
        /// Ox-blood red.
        CopperRed = "copper-red",
        /// Transparent.
        Clear = "clear",
        /// No glaze.
        Bare = "bare",
    }
}

names! {
    /// A clay body.
    #[non_exhaustive]
    pub enum Clay {
        /// Warm grey.
        Stoneware = "stoneware",
        /// White.
        Porcelain = "porcelain",
        /// Red-brown.
        Terracotta = "terracotta",
        /// Black.
        Black = "black",
    }
}
