//! What has to be known of a whole surface before its rows are rounded.

use super::copy::Original;
use super::waves::{ROWS, Waves};
use crate::mesh::part::PartGrid;
use crate::surface::Block;

/// How large the numbers of a mesh are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    /// Powers of two that bring `X_u` and `X_v` of the whole surface to about 1.
    pub(super) scales: [f64; 2],
    /// A coordinate that some vertex of the mesh has at least: the largest root mean square of a component over one of a few rows, or the largest component at `v = 0` of these.
    pub(super) largest: f64,
}

impl Extent {
    /// Looks at a few rows. Takes the widest of them as the original of the others, where it may be that.
    pub(super) fn of(grid: &PartGrid, waves: &mut Waves, original: &mut Original) -> Extent {
        const STEPS: usize = 8;
        let PartGrid { surface, curves, tessellation, .. } = grid;
        let n_rows = tessellation.counts().0;
        let u = core::array::from_fn::<f64, { STEPS + 1 }, _>(|i| tessellation.row(i * (n_rows - 1) / STEPS));
        // The mean over the vertices of a row is that over a whole turn where the columns tell the harmonics apart.
        let are_apart = waves.are_apart(tessellation.round) && surface.is_closed();
        let mut largest = 0.0f64;
        let mut widest = 0.0;
        let mut longest = [0.0f64; 2];
        original.clear();
        for u in u {
            waves.take(surface, curves, [u; ROWS]);
            for (longest, length) in longest.iter_mut().zip(waves.tangent_lengths()) {
                *longest = longest.max(length);
            }
            let mut width = 0.0;
            for axis in 0..3 {
                let squares = waves.data.iter().flatten().map(|wave| wave[axis][0] * wave[axis][0]);
                let squares = squares.fold(Block::ZERO, |sum, square| sum + square);
                let constant = waves.constants[axis][0];
                let start = waves.data[0].iter().fold(constant, |sum, wave| sum + wave[axis][0]);
                let square = if are_apart { constant * constant + squares * 0.5 } else { start * start };
                largest = largest.max(square.to_array()[0]);
                width += squares.to_array()[0];
            }
            if width > widest && width < f64::MAX && waves.has[2] == [false; 2] {
                widest = width;
                original.take(waves);
            }
        }
        // One row that is no copy, and rows are hardly ever asked again.
        for u in u {
            if !original.is_empty() {
                waves.take(surface, curves, [u; ROWS]);
                if original.scaled(waves, 0).is_none() {
                    original.clear();
                }
            }
        }
        Extent { scales: longest.map(power_of_two), largest: largest.sqrt() }
    }
}

/// A power of two that brings a length to between a half and 2; for lengths beyond 1e300 or below 1e-300 as near as that.
fn power_of_two(length: f64) -> f64 {
    const BIAS: u64 = 1023;
    let exponent = (length.to_bits() >> 52).clamp(BIAS - 1000, BIAS + 1000);
    f64::from_bits((2 * BIAS - exponent) << 52)
}
