//! Clay and glaze as a plain material: one colour and one roughness.

use crate::design::{Clay, Glaze, Look};

/// A surface that reflects as a dielectric.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Material {
    /// Linear reflectances of red, green and blue, 0 to 1.
    pub(super) colour: [f64; 3],
    /// 0 (mirror) to 1.
    pub(super) roughness: f64,
}

/// The fired body: colour and roughness. The numbers are those of the designer's stage.
fn clay(clay: Clay) -> ([f64; 3], f64) {
    match clay {
        Clay::Stoneware => ([0.4, 0.29, 0.195], 0.78),
        Clay::Porcelain => ([0.79, 0.765, 0.715], 0.6),
        Clay::Terracotta => ([0.47, 0.165, 0.075], 0.85),
        Clay::Black => ([0.035, 0.031, 0.029], 0.7),
    }
}

/// The layer on it: what it lets through, what it scatters, how opaque and how rough it is.
fn glaze(glaze: Glaze) -> Option<([f64; 3], [f64; 3], f64, f64)> {
    Some(match glaze {
        Glaze::Celadon => ([0.4, 0.66, 0.5], [0.34, 0.49, 0.39], 0.62, 0.1),
        Glaze::Tenmoku => ([0.1, 0.04, 0.02], [0.016, 0.01, 0.008], 0.95, 0.09),
        Glaze::Cobalt => ([0.05, 0.12, 0.5], [0.012, 0.035, 0.2], 0.8, 0.08),
        Glaze::TinWhite => ([0.85, 0.84, 0.8], [0.78, 0.765, 0.72], 0.96, 0.2),
        Glaze::Shino => ([0.8, 0.6, 0.42], [0.72, 0.64, 0.54], 0.88, 0.36),
        Glaze::CopperRed => ([0.5, 0.035, 0.025], [0.2, 0.012, 0.013], 0.8, 0.06),
        Glaze::Clear => ([0.9, 0.88, 0.8], [0.6, 0.6, 0.55], 0.06, 0.07),
        Glaze::Bare => return None,
    })
}

impl Material {
    /// A plain wall: `clay tint (1 - opacity) + body opacity`.
    pub(super) fn of(look: Look) -> Material {
        let (colour, roughness) = clay(look.clay);
        let Some((tint, body, opacity, glossy)) = glaze(look.glaze) else { return Material { colour, roughness } };
        let colour = [0, 1, 2].map(|i| colour[i] * tint[i] * (1.0 - opacity) + body[i] * opacity);
        Material { colour, roughness: glossy }
    }
}

/// `celadon on stoneware`.
pub(super) fn name(look: Look) -> String {
    match look.glaze {
        Glaze::Bare => look.clay.name().to_owned(),
        glaze => format!("{} on {}", glaze.name(), look.clay.name()),
    }
}

/// A linear reflectance as a byte of sRGB (IEC 61966-2-1).
pub(super) fn srgb(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let coded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 };
    libm::round(255.0 * coded) as u8
}
