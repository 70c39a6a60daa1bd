//! Suprema of derivatives round one row, over every `v`.

use core::f64::consts::PI;

use super::circle;
use super::row_table::RowTable;
use super::solve::Surface;
use super::table::{BLOCK, Block};

/// Modes beyond this are not sampled but added up.
const HIGHEST_SAMPLED: f64 = 256.0;

/// Samples per wave of the highest mode: with 12 a supremum is at most 3.5 % too large.
const SAMPLES_PER_WAVE: f64 = 12.0;

/// As [`SAMPLES_PER_WAVE`] for surfaces of many modes, where sampling is what takes the time; 8.3 % too large.
const SAMPLES_PER_WAVE_OF_MANY: f64 = 8.0;

/// A surface of so many modes in all three components together has many.
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
    /// What sampled suprema are multiplied by.
    margin: f64,
    /// For each distinct `n` what is added of its amplitude: nothing, a little, or all of it for one that is not sampled.
    added: Vec<f64>,
    distinct: Vec<f64>,
    /// Whether a row costs so much that few should be asked for.
    pub(crate) has_many_modes: bool,
    /// Whether the samples at `-v` are had from those at `v`, and only these are in `circles`.
    is_mirrored: bool,
    /// Block by block of samples, cosine and sine of each distinct `n`.
    circles: Vec<[Block; 2]>,
    waves: [Vec<Wave>; 3],
    /// What of the waves of each component is sampled, those that are even in `X_vv` and those that are odd.
    halves: [[Vec<Half>; 2]; 3],
}

/// The coefficients of one mode of one component that are not 0, those of `even` or of `odd` in [`Wave`].
#[derive(Debug)]
struct Half {
    column: usize,
    factors: [f64; 3],
}

/// One mode of one component.
#[derive(Debug)]
struct Wave {
    column: usize,
    /// Coefficients of the cosine in `X_uu + g X_u`, of the sine in `X_uv`, of the cosine in `X_vv`.
    even: [f64; 3],
    /// As `even`, with sine and cosine exchanged.
    odd: [f64; 3],
}

impl Circumference {
    pub(crate) fn new(surface: &Surface) -> Self {
        let distinct = surface.distinct().to_vec();
        let has_many_modes = surface.components().iter().map(Vec::len).sum::<usize>() >= MANY;
        let is_sampled = |n: f64| n.abs() <= HIGHEST_SAMPLED;
        let highest = distinct.iter().filter(|n| is_sampled(**n)).fold(1.0f64, |highest, n| highest.max(n.abs()));
        let per_wave = if has_many_modes { SAMPLES_PER_WAVE_OF_MANY } else { SAMPLES_PER_WAVE };
        let n_samples = ((per_wave * highest).ceil() as usize).next_multiple_of(2 * BLOCK).clamp(16, MOST_SAMPLES);
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
        // Samples from v = 0 to v = 1/2 and their mirror images, or all from 0 to 1.
        let n_formed = if is_closed { n_samples / 2 + 1 } else { n_samples };
        let circle = |n: f64, j: usize| {
            let turns = if is_sampled(n) { n } else { 0.0 };
            circle::of_turns(libm::fmod(turns * j.min(n_formed - 1) as f64, steps) / steps)
        };
        let mut circles = Vec::with_capacity(n_formed.div_ceil(BLOCK) * distinct.len());
        for first in (0..n_formed).step_by(BLOCK) {
            for &n in &distinct {
                let lanes: [_; BLOCK] = core::array::from_fn(|lane| circle(n, first + lane));
                circles.push([lanes.map(|(cos, _)| cos).into(), lanes.map(|(_, sin)| sin).into()]);
            }
        }
        let added = distinct.iter().map(|&n| added(n)).collect();
        Circumference {
            margin,
            added,
            distinct,
            has_many_modes,
            is_mirrored: is_closed,
            circles,
            waves: Default::default(),
            halves: Default::default(),
        }
    }

    /// The suprema at `u` of a surface whose axes are stretched by these factors.
    pub(crate) fn suprema(&mut self, surface: &Surface, u: f64, stretch: [f64; 3]) -> RowSuprema {
        let row = RowTable::<3>::at(surface.components(), u);
        let straightening = straightening(&row, &self.distinct, stretch);
        let mut size = [0.0; 3];
        for (axis, (waves, terms)) in self.waves.iter_mut().zip(&row.components).enumerate() {
            waves.clear();
            for term in terms {
                let k = term.k * surface.span();
                let ([a, a_u, a_uu], [b, b_u, b_uu]) =
                    (term.cos.map(|x| x * stretch[axis]), term.sin.map(|x| x * stretch[axis]));
                size[axis] += libm::hypot(a, b);
                waves.push(Wave {
                    column: term.column,
                    even: [a_uu + straightening * a_u, -k * a_u, -k * k * a],
                    odd: [b_uu + straightening * b_u, k * b_u, -k * k * b],
                });
            }
        }
        let [uu, uv, vv] = self.longest();
        RowSuprema { size: length(size), straightening, uu, uv, vv }
    }

    /// The suprema of the lengths of the three vectors.
    fn longest(&mut self) -> [f64; 3] {
        let mut largest = [0.0f64; 3];
        for wave in self.waves.iter().flatten() {
            for (part, largest) in largest.iter_mut().enumerate() {
                *largest = largest.max(wave.amplitude(part));
            }
        }
        // Lengths are compared by their squares, which must neither vanish nor overflow.
        let scale = largest.map(|largest| 1.0 / largest);
        let can_be_sampled = scale.map(|scale| scale.is_finite() && scale > 0.0);
        let n_waves = self.waves.iter().map(Vec::len).sum::<usize>();
        let negligible = largest.map(|largest| NEGLIGIBLE * largest / n_waves as f64);
        let mut added = [[0.0; 3]; 3];
        for (axis, waves) in self.waves.iter_mut().enumerate() {
            waves.retain_mut(|wave| {
                let share = self.added[wave.column];
                for part in 0..3 {
                    let amplitude = wave.amplitude(part);
                    if amplitude <= negligible[part] || share == 1.0 || !can_be_sampled[part] {
                        added[part][axis] += amplitude;
                        (wave.even[part], wave.odd[part]) = (0.0, 0.0);
                    } else {
                        added[part][axis] += share * amplitude;
                        wave.even[part] *= scale[part];
                        wave.odd[part] *= scale[part];
                    }
                }
                wave.even != [0.0; 3] || wave.odd != [0.0; 3]
            });
        }
        for ([even, odd], waves) in self.halves.iter_mut().zip(&self.waves) {
            let half = |column: usize, factors: [f64; 3]| (factors != [0.0; 3]).then_some(Half { column, factors });
            even.clear();
            even.extend(waves.iter().filter_map(|wave| half(wave.column, wave.even)));
            odd.clear();
            odd.extend(waves.iter().filter_map(|wave| half(wave.column, wave.odd)));
        }
        let sampled = self.sampled();
        core::array::from_fn(|part| {
            let sampled = if sampled[part] > 0.0 { largest[part] * sampled[part].sqrt() * self.margin } else { 0.0 };
            sampled + length(added[part])
        })
    }

    /// The largest square of each length at any sample.
    fn sampled(&self) -> [f64; 3] {
        // Where no component has both halves, lengths at `v` are those at `-v`.
        let is_mirrored =
            self.is_mirrored && self.halves.iter().any(|halves| halves.iter().all(|half| !half.is_empty()));
        let mut most = [Block::ZERO; 3];
        for circles in self.circles.chunks_exact(self.distinct.len().max(1)) {
            let (mut here, mut mirrored) = ([Block::ZERO; 3], [Block::ZERO; 3]);
            for [even, odd] in &self.halves {
                let even = summed(even, circles, |[cos, sin]| [cos, sin]);
                let odd = summed(odd, circles, |[cos, sin]| [sin, cos]);
                for part in 0..3 {
                    let sum = even[part] + odd[part];
                    here[part] += sum * sum;
                    if is_mirrored {
                        let difference = even[part] - odd[part];
                        mirrored[part] += difference * difference;
                    }
                }
            }
            for part in 0..3 {
                most[part] = most[part].max(here[part]);
                if is_mirrored {
                    most[part] = most[part].max(mirrored[part]);
                }
            }
        }
        most.map(|most| most.to_array().into_iter().fold(0.0, f64::max))
    }
}

/// The three vectors' part of one component that such halves make at a block of samples; `order` puts the one of cosine and sine in front that the outer two are of.
#[inline(always)]
fn summed(halves: &[Half], circles: &[[Block; 2]], order: impl Fn([Block; 2]) -> [Block; 2]) -> [Block; 3] {
    let mut sums = [Block::ZERO; 3];
    for Half { column, factors } in halves {
        let Some(circle) = circles.get(*column) else { continue };
        let [outer, inner] = order(*circle);
        sums[0] += outer * factors[0];
        sums[1] += inner * factors[1];
        sums[2] += outer * factors[2];
    }
    sums
}

impl Wave {
    fn amplitude(&self, part: usize) -> f64 {
        let amplitude = libm::hypot(self.even[part], self.odd[part]);
        if amplitude.is_nan() { f64::INFINITY } else { amplitude }
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
