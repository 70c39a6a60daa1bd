//! How far second derivatives on a strip of a surface can be from those at one place of it.

use super::circumference::length;
use super::solve::Surface;
use crate::numeric::taylor;

/// Suprema over a strip `u` in an interval without a ring inside, every `v`, with `v` as an angle that goes round once.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ThirdSuprema {
    /// Of `|X_uu|` and `|X_vv|`.
    pub(crate) second: [f64; 2],
    /// Of `|X_uuu|`, `|X_uuv|`, `|X_uvv|`, `|X_vvv|`.
    pub(crate) third: [f64; 4],
}

impl Surface {
    /// Bounds for a closed surface whose axes are stretched by these factors. Amplitudes of all modes are added up; each is bounded by Taylor's formula about the middle of the strip, so that of what cancels in a mode little is left on a narrow one.
    pub(crate) fn third_suprema(&self, [from, to]: [f64; 2], stretch: [f64; 3]) -> ThirdSuprema {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut sums = [[0.0; 3]; 6];
        for (axis, terms) in self.components().iter().enumerate() {
            for term in terms {
                let n = term.n.abs();
                let data = [&term.cos, &term.sin];
                let mut bounds = term.beam.suprema::<5, 2>(data, from, to);
                let jets = term.beam.jets::<5, 2>(data, middle);
                for (bound, jet) in bounds.iter_mut().zip(&jets) {
                    taylor::tighten(bound, jet, half);
                }
                let [a, b] = bounds;
                let [value, u, uu, uuu] = [0, 1, 2, 3].map(|order| libm::hypot(a[order], b[order]) * stretch[axis]);
                for (sum, bound) in sums.iter_mut().zip([uu, n * n * value, uuu, n * uu, n * n * u, n * n * n * value])
                {
                    sum[axis] += bound;
                }
            }
        }
        let [uu, vv, uuu, uuv, uvv, vvv] = sums.map(length);
        ThirdSuprema { second: [uu, vv], third: [uuu, uuv, uvv, vvv] }
    }
}
