//! Rows and columns from a tolerance.

use glam::DMat3;

use crate::surface::{RowTable, Surface};

/// Suprema over the whole surface of the lengths of `X`, `X_uu`, `X_uv`, `X_vv`, after placement, with `v` scaled to [0, 1].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounds {
    pub(super) position: f64,
    pub(super) uu: f64,
    pub(super) uv: f64,
    pub(super) vv: f64,
}

/// Rows at which the coefficients are bounded: even, and denser towards both ends where fast modes decay.
const EVEN_ROWS: usize = 256;
/// Layers of rate 1e6 and less are seen.
const END_ROWS: i32 = 20;

impl Bounds {
    /// Bounds the coefficients by their values on rows and, between these, by their own derivatives; then every `cos` and `sin` by 1.
    pub(super) fn of(surface: &Surface, distinct: &[f64], placement: DMat3) -> Bounds {
        // Halving steps out of the start, even steps, halving steps into the end.
        let step = 1.0 / EVEN_ROWS as f64;
        let from_end = |i: i32| libm::ldexp(step, -i);
        let rows: Vec<f64> = core::iter::once(0.0)
            .chain((1..=END_ROWS).rev().map(from_end))
            .chain((1..EVEN_ROWS).map(|i| i as f64 * step))
            .chain((1..=END_ROWS).map(|i| 1.0 - from_end(i)))
            .chain([1.0])
            .collect();
        let at: Vec<[Amplitudes; 2]> =
            rows.iter().map(|&u| amplitudes(&RowTable::at(surface, distinct, u), surface.span())).collect();
        let mut sup: Amplitudes = [[0.0; 3]; 4];
        for (pair, gap) in at.windows(2).zip(rows.windows(2).map(|w| w[1] - w[0])) {
            for quantity in 0..4 {
                for axis in 0..3 {
                    let [value, slope] = [0, 1].map(|d| pair[0][d][quantity][axis].max(pair[1][d][quantity][axis]));
                    sup[quantity][axis] = sup[quantity][axis].max(value + 0.5 * gap * slope);
                }
            }
        }
        // The columns of a rotation times a scale are orthogonal.
        let columns = [placement.x_axis, placement.y_axis, placement.z_axis].map(glam::DVec3::length);
        let size = |v: [f64; 3]| glam::DVec3::new(v[0] * columns[0], v[1] * columns[1], v[2] * columns[2]).length();
        Bounds { position: size(sup[0]), uu: size(sup[1]), uv: size(sup[2]), vv: size(sup[3]) }
    }

    /// How far a triangle of a grid with `p = 1 / (rows - 1)` and `q = 1 / (columns - 1)` may be from the surface, at most.
    ///
    /// On a right triangle with legs `p`, `q` in the parameters, the linear interpolant of `X` is within
    /// `(p^2 |X_uu| + 2 p q |X_uv| + q^2 |X_vv|) / 8` (Filip, Magedson and Markot 1986, theorem 2).
    pub(super) fn deviation(&self, p: f64, q: f64) -> f64 {
        0.125 * (p * p * self.uu + 2.0 * p * q * self.uv + q * q * self.vv)
    }

    /// The least numbers of cells along `u` and round `v` for which the deviation is within the tolerance; a number that is given stays,
    /// and the other is chosen as well as it can be.
    pub(super) fn cells(&self, tolerance: f64, along: Option<f64>, round: Option<f64>) -> (f64, f64) {
        let budget = 8.0 * tolerance;
        // The largest step q with a + 2 b q + c q^2 <= budget, written without cancellation.
        let step = |a: f64, b: f64, c: f64| {
            let left = budget - a;
            if left > 0.0 { left / (b + libm::sqrt(b * b + c * left)) } else { 0.0 }
        };
        let cells = |step: f64, least: f64| if step * least >= 1.0 { least } else { libm::ceil(1.0 / step) };
        // Where a given step already spends the budget, the other is chosen as if it had the whole for itself.
        let beside = |a: f64, b: f64, c: f64| if a < budget { step(a, b, c) } else { step(0.0, 0.0, c) };
        let round_for = |p: f64| beside(p * p * self.uu, p * self.uv, self.vv);
        let along_for = |q: f64| beside(q * q * self.vv, q * self.uv, self.uu);
        match (along, round) {
            (Some(along), Some(round)) => (along, round),
            (Some(along), None) => (along, cells(round_for(1.0 / along), LEAST_ROUND)),
            (None, Some(round)) => (cells(along_for(1.0 / round), LEAST_ALONG), round),
            (None, None) => {
                // For a given budget the fewest cells have p^2 |X_uu| = q^2 |X_vv|; a surface that is straight one way takes the longest
                // step that way and leaves the budget to the other.
                let even = libm::sqrt(self.vv / self.uu);
                let p = libm::sqrt(0.5 * budget / (self.uu + self.uv / even));
                let p = if p > 0.0 { p.min(1.0 / LEAST_ALONG) } else { 1.0 / LEAST_ALONG };
                let round = cells(round_for(p), LEAST_ROUND);
                (cells(along_for(1.0 / round), LEAST_ALONG), round)
            }
        }
    }
}

/// The fewest cells along the profile.
const LEAST_ALONG: f64 = 1.0;
/// The fewest cells round the axis: with fewer a closed surface would be flat.
const LEAST_ROUND: f64 = 6.0;

/// For `X`, `X_uu`, `X_uv`, `X_vv` a bound in each component.
type Amplitudes = [[f64; 3]; 4];

/// Sums over the modes of `|A|`, `|A''|`, `k |A'|`, `k^2 |A|`, and of their derivatives, where `|A|` stands for the amplitude of `A cos + B sin` and
/// `k` is taken per whole span.
fn amplitudes(row: &RowTable<4>, span: f64) -> [Amplitudes; 2] {
    let mut sums = [[[0.0; 3]; 4]; 2];
    for (axis, terms) in row.components.iter().enumerate() {
        for term in terms {
            let k = (term.k * span).abs();
            let [a, a_u, a_uu, a_uuu]: [f64; 4] = core::array::from_fn(|d| libm::hypot(term.cos[d], term.sin[d]));
            let values = [[a, a_uu, k * a_u, k * k * a], [a_u, a_uuu, k * a_uu, k * k * a_u]];
            for (sum, value) in sums.iter_mut().flatten().zip(values.as_flattened()) {
                sum[axis] += value;
            }
        }
    }
    sums
}
