//! Suprema of derivatives round one row, over every `v`.

use core::f64::consts::PI;

use super::circle;
use super::solve::Surface;
use super::table::{RowTable, distinct};

/// Modes beyond this are not sampled but added up.
const HIGHEST_SAMPLED: f64 = 256.0;

/// Samples per wave of the highest mode: with 12 a supremum is at most 3.5 % too large.
const SAMPLES_PER_WAVE: f64 = 12.0;

/// As [`SAMPLES_PER_WAVE`] for surfaces of many modes, where sampling is what takes the time; 8.3 % too large.
const SAMPLES_PER_WAVE_OF_MANY: f64 = 8.0;

/// From this many modes of all three components together on, a surface has many.
const MANY: usize = 32;

/// The most samples, hence four for each wave of [`HIGHEST_SAMPLED`].
const MOST_SAMPLES: usize = 1024;

/// What a mode adds is not sampled but added up where all such modes together are at most this part of the largest.
const NEGLIGIBLE: f64 = 1e-3;

/// The largest rate at which the parameter is straightened: where a wall stands still (`X_u = 0`) it would be infinite.
const STRAIGHTEST: f64 = 32.0;

/// Suprema over all `v` of one row, with `v` scaled to [0, 1].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RowSuprema {
    /// Of `|X|`: the sum of all amplitudes.
    pub(crate) size: f64,
    /// The rate `g` for which `X_uu + g X_u` is smallest in the mean of squares: it takes out what is only parametrisation.
    pub(crate) straightening: f64,
    /// Of `|X_uu + g X_u|`.
    pub(crate) uu: f64,
    /// Of `|X_uv|`.
    pub(crate) uv: f64,
    /// Of `|X_vv|`.
    pub(crate) vv: f64,
}

/// Samples round a row of one surface.
///
/// Every component of a closed surface is a trigonometric polynomial of `v`. One of degree `N` is nowhere larger than its largest value at `M > 2 N` even
/// points divided by `cos(pi N / M)` (Ehlich and Zeller, *Schwankung von Polynomen zwischen Gitterpunkten*, 1964); applied to the component in whichever direction a vector of them points where
/// it is longest, this bounds lengths too. On a surface that does not close, a mode is between its samples at most by an eighth of its second derivative times the
/// square of the gap above the line that joins them.
#[derive(Debug)]
pub(crate) struct Circumference {
    n_samples: usize,
    /// What sampled suprema are multiplied by.
    margin: f64,
    /// For each distinct `n` what is added of its amplitude: nothing, a little, or all of it for one that is not sampled.
    added: Vec<f64>,
    distinct: Vec<f64>,
    /// For each distinct `n` all cosines, then all sines.
    circles: Vec<f64>,
    sum: Vec<f64>,
    squared: Vec<f64>,
    waves: Vec<Wave>,
}

/// One mode of one component: coefficients of cosine and sine in `X_uu + g X_u`, `X_uv` and `X_vv`.
#[derive(Debug)]
struct Wave {
    axis: usize,
    column: usize,
    parts: [[f64; 2]; 3],
    amplitudes: [f64; 3],
}

impl Circumference {
    pub(crate) fn new(surface: &Surface) -> Self {
        let distinct = distinct(surface);
        let is_sampled = |n: f64| n.abs() <= HIGHEST_SAMPLED;
        let highest = distinct.iter().filter(|n| is_sampled(**n)).fold(1.0f64, |highest, n| highest.max(n.abs()));
        let n_modes = surface.components().iter().map(Vec::len).sum::<usize>();
        let per_wave = if n_modes < MANY { SAMPLES_PER_WAVE } else { SAMPLES_PER_WAVE_OF_MANY };
        let n_samples = (libm::ceil(per_wave * highest) as usize).next_multiple_of(8).clamp(16, MOST_SAMPLES);
        let is_closed = surface.is_closed();
        // A row that does not close has a sample at each end.
        let steps = (if is_closed { n_samples } else { n_samples - 1 }) as f64;
        let margin = if is_closed { 1.0 / libm::cos(PI * highest / steps) } else { 1.0 };
        let added = |n: f64| {
            let gap = 2.0 * PI * n / steps;
            if !is_sampled(n) {
                1.0
            } else if is_closed {
                0.0
            } else {
                0.125 * gap * gap
            }
        };
        let mut circles = Vec::with_capacity(2 * n_samples * distinct.len());
        for &n in &distinct {
            let turns = if is_sampled(n) { n } else { 0.0 };
            let circle = |j: usize| circle::of_turns(libm::fmod(turns * j as f64, steps) / steps);
            circles.extend((0..n_samples).map(|j| circle(j).0));
            circles.extend((0..n_samples).map(|j| circle(j).1));
        }
        Circumference {
            n_samples,
            margin,
            added: distinct.iter().map(|&n| added(n)).collect(),
            distinct,
            circles,
            sum: vec![0.0; n_samples],
            squared: vec![0.0; n_samples],
            waves: Vec::with_capacity(n_modes),
        }
    }

    /// The suprema at `u` of a surface whose axes are stretched by these factors.
    pub(crate) fn suprema(&mut self, surface: &Surface, u: f64, stretch: [f64; 3]) -> RowSuprema {
        let row = RowTable::<3>::at(surface, &self.distinct, u);
        let straightening = straightening(&row, &self.distinct, stretch);
        self.waves.clear();
        let mut size = [0.0; 3];
        for (axis, terms) in row.components.iter().enumerate() {
            for term in terms {
                let k = term.k * surface.span();
                let ([a, a_u, a_uu], [b, b_u, b_uu]) =
                    (term.cos.map(|x| x * stretch[axis]), term.sin.map(|x| x * stretch[axis]));
                let parts = [
                    [a_uu + straightening * a_u, b_uu + straightening * b_u],
                    [k * b_u, -k * a_u],
                    [-k * k * a, -k * k * b],
                ];
                size[axis] += libm::hypot(a, b);
                let amplitudes = parts.map(|[cos, sin]| libm::hypot(cos, sin));
                self.waves.push(Wave { axis, column: term.column, parts, amplitudes });
            }
        }
        let [uu, uv, vv] = [0, 1, 2].map(|part| self.supremum(part));
        RowSuprema { size: length(size), straightening, uu, uv, vv }
    }

    /// The supremum of the length of one of the three vectors.
    fn supremum(&mut self, part: usize) -> f64 {
        let largest = self.waves.iter().fold(0.0f64, |largest, wave| largest.max(wave.amplitudes[part]));
        if largest == 0.0 {
            return 0.0;
        }
        // Lengths are compared by their squares, which must neither vanish nor overflow.
        let scale = 1.0 / largest;
        let can_be_sampled = largest.is_finite() && scale.is_finite() && scale > 0.0;
        let negligible = NEGLIGIBLE * largest / self.waves.len() as f64;
        let mut added = [0.0; 3];
        self.squared.fill(0.0);
        for (axis, added) in added.iter_mut().enumerate() {
            self.sum.fill(0.0);
            for wave in self.waves.iter().filter(|wave| wave.axis == axis) {
                let (amplitude, share) = (wave.amplitudes[part], self.added[wave.column]);
                if amplitude <= negligible || share == 1.0 || !can_be_sampled {
                    *added += amplitude;
                    continue;
                }
                *added += share * amplitude;
                let first = 2 * self.n_samples * wave.column;
                let (cosines, sines) = self.circles[first..first + 2 * self.n_samples].split_at(self.n_samples);
                for (factor, samples) in wave.parts[part].into_iter().zip([cosines, sines]) {
                    if factor != 0.0 {
                        let factor = factor * scale;
                        for (sum, sample) in self.sum.iter_mut().zip(samples) {
                            *sum += factor * sample;
                        }
                    }
                }
            }
            for (squared, sum) in self.squared.iter_mut().zip(&self.sum) {
                *squared += sum * sum;
            }
        }
        let sampled = self.squared.iter().fold(0.0f64, |largest, &squared| largest.max(squared));
        largest * libm::sqrt(sampled) * self.margin + length(added)
    }
}

/// `-(X_uu . X_u) / (X_u . X_u)`, both in the mean over `v`. Any number would do: what it is decides how good the bound is, not whether it holds.
fn straightening(row: &RowTable<3>, distinct: &[f64], stretch: [f64; 3]) -> f64 {
    let (mut along, mut across) = (0.0, 0.0);
    for (terms, stretch) in row.components.iter().zip(stretch) {
        for term in terms {
            let mean = if distinct[term.column] == 0.0 { [1.0, 0.0] } else { [0.5; 2] };
            for ([_, first, second], mean) in [term.cos, term.sin].into_iter().zip(mean) {
                let (first, second) = (first * stretch, second * stretch);
                along += mean * first * second;
                across += mean * first * first;
            }
        }
    }
    let rate = -along / across;
    if rate.is_finite() { rate.clamp(-STRAIGHTEST, STRAIGHTEST) } else { 0.0 }
}

/// The length of a vector whose square might leave the range of doubles.
pub(crate) fn length(v: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(v[0], v[1]), v[2])
}
