//! What a part is made of and covered with.

use super::names::names;
use super::path::Path;
use super::reader::Record;
use super::table::{self, Entry, optional};
use super::value::Value;
use crate::error::Result;

/// The clay and the glaze of a part. They change no geometry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct Look {
    /// What covers the part.
    pub glaze: Glaze,
    /// What the part is made of.
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

pub(crate) const LOOK: &[Entry] = &[
    optional("glaze", "GlazeName", "What covers the part; celadon when left out."),
    optional("clay", "ClayName", "What the part is made of; stoneware when left out."),
];

impl Look {
    pub(crate) fn read(value: &Value, path: Path) -> Result<Self> {
        let record = Record::open(value, path, "a look with glaze and clay")?.only(&table::names(LOOK))?;
        Ok(Look { glaze: Glaze::read(&record, "glaze")?, clay: Clay::read(&record, "clay")? })
    }

    pub(crate) fn write(self, into: &mut Vec<(String, Value)>) {
        self.glaze.write("glaze", into);
        self.clay.write("clay", into);
    }
}
