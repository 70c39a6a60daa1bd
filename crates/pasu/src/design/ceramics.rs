//! Clay and glaze as light sees them, as far as files and pages have to agree on it.

use super::look::{Choice, Clay, Glaze};

/// A fired clay body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Body {
    /// Linear reflectances of red, green and blue, 0 to 1.
    pub(crate) colour: [f64; 3],
    /// 0 (mirror) to 1.
    pub(crate) roughness: f64,
    /// The colour by which a person chooses it, of sRGB.
    #[cfg(feature = "typescript")]
    pub(crate) swatch: u32,
}

/// A layer of coloured glass over the clay.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Layer {
    /// What a layer of thickness 1 lets through, there and back: the colour of the glass. Linear, 0 to 1.
    pub(crate) tint: [f64; 3],
    /// What is scattered inside the layer: the colour of an opaque glaze. Linear, 0 to 1.
    pub(crate) body: [f64; 3],
    /// How opaque a layer of thickness 1 is, 0 (glass) to 1.
    pub(crate) opacity: f64,
    /// 0 (mirror) to 1.
    pub(crate) roughness: f64,
}

/// How rough clay of one's own colour is.
pub(super) const OWN_CLAY: f64 = 0.75;
/// The layer of a glaze of one's own colour: opaque and glossy, so that the pot has that colour.
pub(super) const OWN_OPACITY: f64 = 0.9;
pub(super) const OWN_GLAZE: f64 = 0.12;

impl Choice<Clay> {
    /// The fired body: its colour and its roughness.
    pub(crate) fn fired(self) -> ([f64; 3], f64) {
        match self {
            Choice::Named(clay) => (clay.body().colour, clay.body().roughness),
            Choice::Own(colour) => (colour.linear(), OWN_CLAY),
        }
    }
}

impl Choice<Glaze> {
    /// The layer; none on bare clay.
    pub(crate) fn layer(self) -> Option<Layer> {
        match self {
            Choice::Named(glaze) => glaze.layer(),
            Choice::Own(colour) => {
                let colour = colour.linear();
                Some(Layer { tint: colour, body: colour, opacity: OWN_OPACITY, roughness: OWN_GLAZE })
            }
        }
    }
}

impl Clay {
    /// The fired body.
    pub(crate) fn body(self) -> Body {
        let (colour, roughness) = match self {
            Clay::Stoneware => ([0.4, 0.29, 0.195], 0.78),
            Clay::Porcelain => ([0.79, 0.765, 0.715], 0.6),
            Clay::Terracotta => ([0.47, 0.165, 0.075], 0.85),
            Clay::Black => ([0.035, 0.031, 0.029], 0.7),
        };
        Body {
            colour,
            roughness,
            #[cfg(feature = "typescript")]
            swatch: match self {
                Clay::Stoneware => 0xa98e6f,
                Clay::Porcelain => 0xefece6,
                Clay::Terracotta => 0xb9613d,
                Clay::Black => 0x38332f,
            },
        }
    }
}

impl Glaze {
    /// The layer; none on bare clay.
    pub(crate) fn layer(self) -> Option<Layer> {
        let (tint, body, opacity, roughness) = match self {
            Glaze::Celadon => ([0.4, 0.66, 0.5], [0.34, 0.49, 0.39], 0.62, 0.1),
            Glaze::Tenmoku => ([0.1, 0.04, 0.02], [0.016, 0.01, 0.008], 0.95, 0.09),
            Glaze::Cobalt => ([0.05, 0.12, 0.5], [0.012, 0.035, 0.2], 0.8, 0.08),
            Glaze::TinWhite => ([0.85, 0.84, 0.8], [0.78, 0.765, 0.72], 0.96, 0.2),
            Glaze::Shino => ([0.8, 0.6, 0.42], [0.72, 0.64, 0.54], 0.88, 0.36),
            Glaze::CopperRed => ([0.5, 0.035, 0.025], [0.2, 0.012, 0.013], 0.8, 0.06),
            Glaze::Clear => ([0.9, 0.88, 0.8], [0.6, 0.6, 0.55], 0.06, 0.07),
            Glaze::Bare => return None,
        };
        Some(Layer { tint, body, opacity, roughness })
    }

    /// The colour by which a person chooses it, of sRGB.
    #[cfg(feature = "typescript")]
    pub(crate) fn swatch(self) -> u32 {
        match self {
            Glaze::Celadon => 0x9dbfa6,
            Glaze::Tenmoku => 0x2f1a12,
            Glaze::Cobalt => 0x1f3f8f,
            Glaze::TinWhite => 0xf1eee6,
            Glaze::Shino => 0xe6c9ae,
            Glaze::CopperRed => 0x8f1f24,
            Glaze::Clear => 0xd9cdb8,
            Glaze::Bare => 0xb99a76,
        }
    }
}
