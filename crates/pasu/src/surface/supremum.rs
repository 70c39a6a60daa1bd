//! Suprema of the derivatives along `u` on a strip of a surface.

use super::circumference::length;
use super::solve::Surface;

/// Suprema over a strip `u` in an interval, every `v`, with `v` scaled to [0, 1].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct StripSuprema {
    /// Of `|X_uu|`, `|X_uuu|`, `|X_uuuu|`.
    pub(crate) along: [f64; 3],
    /// Of `|X_uuuv|`.
    pub(crate) once_round: f64,
    /// Of `|X_uuvv|`.
    pub(crate) twice_round: f64,
}

impl Surface {
    /// Bounds for a surface whose axes are stretched by these factors. Amplitudes of all modes are added up, so they serve as remainders, not as bounds to build on.
    // Inlined: as a call of its own it makes the module that draws the first picture larger.
    #[inline(always)]
    pub(crate) fn strip_suprema(&self, from: f64, to: f64, stretch: [f64; 3]) -> StripSuprema {
        let mut sums = [[0.0; 3]; 5];
        for (axis, terms) in self.components().iter().enumerate() {
            for term in terms {
                let k = (term.k * self.span()).abs();
                let [a, b] = term.beam.suprema::<5, 2>([&term.cos, &term.sin], from, to);
                let [uu, uuu, uuuu] = [2, 3, 4].map(|order| libm::hypot(a[order], b[order]) * stretch[axis]);
                for (sum, value) in sums.iter_mut().zip([uu, uuu, uuuu, k * uuu, k * k * uu]) {
                    sum[axis] += value;
                }
            }
        }
        let [uu, uuu, uuuu, uuuv, uuvv] = sums.map(length);
        StripSuprema { along: [uu, uuu, uuuu], once_round: uuuv, twice_round: uuvv }
    }
}
