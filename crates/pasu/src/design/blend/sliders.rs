//! How a person changes the numbers of a blend: symbols, dimensions, ranges and steps, in the order in which they are shown.

use crate::design::fields::Dimension;
use crate::design::slider::Which;

/// A number of a section, or of the equation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BlendSlider {
    pub(crate) field: &'static str,
    pub(crate) which: Which,
    /// As the paper writes it; `_` lowers what follows, `'` is a derivative along `w`.
    pub(crate) symbol: &'static str,
    pub(crate) dimension: Dimension,
    /// Where a potter looks for it, at the size of the paper's examples; lengths of larger pots go further.
    pub(crate) range: [f64; 2],
    pub(crate) step: f64,
}

/// The numbers of a section. Those of an outline are its series, which have no sliders of their own.
pub(crate) const SECTION_SLIDERS: [BlendSlider; 5] = [
    slider("radius", Which::At(0), "r_x", Dimension::Length, [0.0, 3.0], 0.01),
    slider("radius", Which::At(1), "r_y", Dimension::Length, [0.0, 3.0], 0.01),
    slider("z", Which::Only, "z", Dimension::Length, [0.0, 6.0], 0.05),
    slider("taper", Which::Only, "κ", Dimension::One, [-2.0, 2.0], 0.01),
    slider("dz", Which::Only, "z'", Dimension::Length, [-10.0, 10.0], 0.1),
];

/// The weights of the equation.
pub(crate) const WEIGHT_SLIDERS: [BlendSlider; 3] = [
    slider("weights", Which::At(0), "a", Dimension::One, [0.001, 1.0], 0.001),
    slider("weights", Which::At(1), "b", Dimension::One, [0.001, 1.0], 0.001),
    slider("weights", Which::At(2), "c", Dimension::One, [0.001, 1.0], 0.001),
];

const fn slider(
    field: &'static str,
    which: Which,
    symbol: &'static str,
    dimension: Dimension,
    range: [f64; 2],
    step: f64,
) -> BlendSlider {
    BlendSlider { field, which, symbol, dimension, range, step }
}
