//! What a part is made of and covered with.

use std::fmt;

use serde::de::{Deserializer, Error, Visitor};
use serde::{Deserialize, Serialize, Serializer};

use super::names::names;
use super::number::rounded;
use super::quantity::{is_default, is_zero, or_default, share_or_zero};

/// The clay and the glaze of a part. They change no geometry.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(expecting = "a look with glaze and clay")]
#[non_exhaustive]
pub struct Look {
    /// What covers the part.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub glaze: Choice<Glaze>,
    /// What covers it inside, where that is something else.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inside: Option<Choice<Glaze>>,
    /// Where the glaze of the outside ends, as a share of its height: below it the clay is bare. 0 for a part that is glazed down to its foot, 1 for one that is bare outside.
    #[serde(deserialize_with = "share_or_zero", skip_serializing_if = "is_zero")]
    pub line: f64,
    /// What the part is made of.
    #[serde(deserialize_with = "or_default", skip_serializing_if = "is_default")]
    pub clay: Choice<Clay>,
}

impl Look {
    /// A glaze on a clay, inside and outside.
    ///
    /// ```
    /// use pasu::{Clay, Glaze, Look};
    ///
    /// assert_eq!(Look::new(Glaze::default(), Clay::default()), Look::default());
    /// ```
    pub fn new(glaze: impl Into<Choice<Glaze>>, clay: impl Into<Choice<Clay>>) -> Look {
        Look { glaze: glaze.into(), clay: clay.into(), ..Look::default() }
    }

    /// What covers the inside.
    ///
    /// ```
    /// use pasu::{Choice, Glaze, Look};
    ///
    /// assert_eq!(Look::default().within(), Choice::Named(Glaze::Celadon));
    /// ```
    pub fn within(&self) -> Choice<Glaze> {
        self.inside.unwrap_or(self.glaze)
    }

    /// The one way of writing this look: an inside like the outside is none of its own, and a glaze that is not there ends nowhere.
    pub(super) fn canonical(self) -> Look {
        let line = if self.glaze == Choice::Named(Glaze::Bare) { 0.0 } else { rounded(self.line) };
        Look { inside: self.inside.filter(|inside| *inside != self.glaze), line, ..self }
    }
}

/// One of the glazes or clays that have a name, or a colour of one's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choice<N> {
    /// By its name.
    Named(N),
    /// By its colour.
    Own(Colour),
}

impl<N: Default> Default for Choice<N> {
    fn default() -> Self {
        Choice::Named(N::default())
    }
}

impl<N: Named> From<N> for Choice<N> {
    fn from(name: N) -> Self {
        Choice::Named(name)
    }
}

impl<N: Named> From<Colour> for Choice<N> {
    fn from(colour: Colour) -> Self {
        Choice::Own(colour)
    }
}

impl<N: Named> fmt::Display for Choice<N> {
    /// As documents write it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Choice::Named(name) => f.write_str(name.word()),
            Choice::Own(colour) => colour.fmt(f),
        }
    }
}

impl<N: Named> Serialize for Choice<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, N: Named> Deserialize<'de> for Choice<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(Chosen(std::marker::PhantomData))
    }
}

struct Chosen<N>(std::marker::PhantomData<N>);

impl<N: Named> Visitor<'_> for Chosen<N> {
    type Value = Choice<N>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&super::refusal::alternatives(N::WORDS))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        if let Some(colour) = Colour::parse(text) {
            return Ok(Choice::Own(colour));
        }
        N::of(text).map(Choice::Named).ok_or_else(|| E::unknown_variant(text, N::WORDS))
    }
}

/// What glazes and clays have in common. Sealed: only Pasu has such.
pub trait Named: Copy + PartialEq + sealed::Sealed {
    /// What may stand in a document: the names, and how a colour is written.
    #[doc(hidden)]
    const WORDS: &'static [&'static str];
    /// The name.
    #[doc(hidden)]
    fn word(self) -> &'static str;
    /// The one of this name.
    #[doc(hidden)]
    fn of(word: &str) -> Option<Self>;
}

mod sealed {
    /// Nobody outside can name it, and so nobody outside can implement what asks for it.
    pub trait Sealed {}
}

/// The names, and after them how a colour is written.
const fn or_colour<const N: usize>(names: &[&'static str]) -> [&'static str; N] {
    let mut words = [COLOUR; N];
    let mut index = 0;
    while index < names.len() {
        words[index] = names[index];
        index += 1;
    }
    words
}

macro_rules! named {
    ($set:ident) => {
        impl sealed::Sealed for $set {}

        impl Named for $set {
            const WORDS: &'static [&'static str] = &or_colour::<{ $set::NAMES.len() + 1 }>($set::NAMES);

            fn word(self) -> &'static str {
                self.name()
            }

            fn of(word: &str) -> Option<Self> {
                $set::ALL.iter().copied().find(|each| each.name() == word)
            }
        }
    };
}

named!(Glaze);
named!(Clay);

/// How a colour is written, in the words of a refusal.
const COLOUR: &str = "#rrggbb";

/// A colour of sRGB: red, green and blue from 0 to 255. Documents write it as `#rrggbb`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Colour(pub [u8; 3]);

impl Colour {
    /// Reads `#1f3f8f`, in letters of either case.
    ///
    /// ```
    /// use pasu::Colour;
    ///
    /// assert_eq!(Colour::parse("#1F3f8f"), Some(Colour([0x1f, 0x3f, 0x8f])));
    /// assert_eq!(Colour::parse("blue"), None);
    /// ```
    pub fn parse(text: &str) -> Option<Colour> {
        let digits = text.strip_prefix('#').filter(|digits| is_hexadecimal(digits))?;
        let pair = |at: usize| u8::from_str_radix(&digits[at..at + 2], 16).ok();
        Some(Colour([pair(0)?, pair(2)?, pair(4)?]))
    }

    /// Linear reflectances of red, green and blue, 0 to 1 (IEC 61966-2-1).
    pub(crate) fn linear(self) -> [f64; 3] {
        self.0.map(|byte| {
            let coded = f64::from(byte) / 255.0;
            if coded <= 0.040_45 { coded / 12.92 } else { libm::pow((coded + 0.055) / 1.055, 2.4) }
        })
    }
}

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [red, green, blue] = self.0;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

/// Whether a text is the six digits of a colour: of a link, where `#` would begin another fragment.
pub(super) fn is_hexadecimal(text: &str) -> bool {
    text.len() == 6 && text.bytes().all(|byte| byte.is_ascii_hexdigit())
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
