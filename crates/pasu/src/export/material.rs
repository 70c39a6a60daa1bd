//! Clay and glaze as a plain material: one colour and one roughness.

use crate::design::{Choice, Glaze, Layer, Look};

/// A surface that reflects as a dielectric.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Material {
    /// Linear reflectances of red, green and blue, 0 to 1.
    pub(super) colour: [f64; 3],
    /// 0 (mirror) to 1.
    pub(super) roughness: f64,
}

impl Material {
    /// A plain wall, seen from outside above the glaze line: `clay tint (1 - opacity) + body opacity`.
    pub(super) fn of(look: Look) -> Material {
        let (clay, bare) = look.clay.fired();
        let Some(Layer { tint, body, opacity, roughness }) = look.glaze.layer() else {
            return Material { colour: clay, roughness: bare };
        };
        let colour = [0, 1, 2].map(|i| clay[i] * tint[i] * (1.0 - opacity) + body[i] * opacity);
        Material { colour, roughness }
    }
}

/// `celadon on stoneware`.
pub(super) fn name(look: Look) -> String {
    match look.glaze {
        Choice::Named(Glaze::Bare) => look.clay.to_string(),
        glaze => format!("{glaze} on {}", look.clay),
    }
}

/// A linear reflectance as a byte of sRGB (IEC 61966-2-1).
pub(super) fn srgb(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let coded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 };
    libm::round(255.0 * coded) as u8
}
