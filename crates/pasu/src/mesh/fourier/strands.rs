//! What the columns of four rows are summed from, in single precision, with the error that this costs.

use super::doubt::LEAST_SQUARE;
use super::extent::Extent;
use super::lanes::Lanes;
use super::waves::{ROWS, Waves};
use crate::mesh::promise::{HALF_UNIT, NORMAL_ERROR, POSITION_ERROR};
use crate::surface::Block;

/// Factors of one harmonic in one component, a row in each lane: of the position, of `X_u` and of `X_v`, the tangents scaled by a power of two to be about 1 where they are longest.
pub(super) type Strand = [Lanes; 3];

/// A rounding error is even between plus and minus half a unit in the last place, so that its mean square is that of `0.41 HALF_UNIT` times the number.
const ROUNDING: f64 = 0.41 * HALF_UNIT;

/// How many standard deviations the error of a sum is allowed. The variance is that of terms all at their amplitude at once, four times what it is at the mean vertex, so that these are
/// five: a sum of few terms cannot be off by as much, and one of many is not in as many vertices as a mesh may have.
const DEVIATIONS: f64 = 2.5;

/// How the components use the harmonics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// For folded rows: `x` is of cosines, `y` of sines, `z` of one of the two, and what does not depend on `v` does not lean towards `y`. One strand serves
    /// all three components.
    Split { z_is_sine: bool },
    /// Anything else: the strands of the cosines and those of the sines are summed one after the other.
    Both,
}

/// The coefficients of four rows, rounded.
#[derive(Debug)]
pub(super) struct Strands {
    pub(super) layout: Layout,
    /// Half a turn takes the surface into itself: normals there are turned by as much.
    pub(super) is_turned: bool,
    /// Which components depend on `v` at all.
    pub(super) is_wavy: [bool; 3],
    /// How many of the strands are summed by themselves, before the others: those of even `n` where columns half a turn apart share sums, otherwise all.
    pub(super) n_even: usize,
    /// Value and slope of what does not depend on `v`, the slope scaled as the strands are.
    pub(super) constant: [[Lanes; 2]; 3],
    /// The strands of each harmonic and component: those of [`Layout::Split`], or of the cosines.
    pub(super) strands: Vec<[Strand; 3]>,
    /// Those of the sines, for [`Layout::Both`].
    pub(super) sine_strands: Vec<[Strand; 3]>,
    /// With these the normal of a vertex is known to be off when `tilt_u |X_v|^2 + tilt_v |X_u|^2 > |X_u x X_v|^2`.
    pub(super) tilt: [Lanes; 2],
    /// No normal of a row can be off where `|X_u x X_v|^2` is more than this.
    pub(super) steepest: Lanes,
    /// Whether single precision is not enough for the positions of a row, or its range is not.
    pub(super) is_exact: [bool; ROWS],
}

impl Default for Strands {
    fn default() -> Self {
        Strands {
            layout: Layout::Both,
            is_turned: false,
            is_wavy: [false; 3],
            n_even: 0,
            constant: [[Lanes::ZERO; 2]; 3],
            strands: Vec::new(),
            sine_strands: Vec::new(),
            tilt: [Lanes::ZERO; 2],
            steepest: Lanes::ZERO,
            is_exact: [false; ROWS],
        }
    }
}

impl Strands {
    /// Takes the waves of another surface; `folds` as [`folds`](super::circles::folds).
    pub(super) fn prepare(&mut self, waves: &Waves, folds: bool) {
        let Waves { has, leans, .. } = waves;
        self.n_even = if folds { waves.n_even } else { waves.harmonics.len() };
        self.layout = match *has {
            [[_, false], [false, _], [cos, sin]] if folds && !(leans[1] || cos && sin) => {
                Layout::Split { z_is_sine: sin }
            }
            _ => Layout::Both,
        };
        self.is_wavy = has.map(|waves| waves != [false; 2]);
        self.is_turned = waves.n_even == 0 && has[2] == [false; 2] && !leans[0] && !leans[1];
        let silent = [[Lanes::ZERO; 3]; 3];
        for strands in [&mut self.strands, &mut self.sine_strands] {
            strands.clear();
            strands.resize(waves.harmonics.len(), silent);
        }
    }

    /// Makes of four rows what is summed.
    pub(super) fn round(&mut self, waves: &Waves, extent: &Extent) {
        let &Extent { scales, largest } = extent;
        for (single_constant, [value, slope]) in self.constant.iter_mut().zip(waves.constants) {
            *single_constant = [single(value), single(slope * scales[0])];
        }
        let [cosines, sines] = &waves.data;
        let strand = |[value, slope]: [Block; 2], k: f64| {
            [single(value), single(slope * scales[0]), single(value * (scales[1] * k))]
        };
        for ((harmonic, strands), (cosine, sine)) in
            waves.harmonics.iter().zip(&mut self.strands).zip(cosines.iter().zip(sines))
        {
            let k = harmonic.k;
            *strands = match self.layout {
                Layout::Split { z_is_sine: true } => [strand(cosine[0], -k), strand(sine[1], k), strand(sine[2], k)],
                Layout::Split { z_is_sine: false } => {
                    [strand(cosine[0], -k), strand(sine[1], k), strand(cosine[2], -k)]
                }
                Layout::Both => cosine.map(|data| strand(data, -k)),
            };
        }
        if self.layout == Layout::Both {
            for ((harmonic, strands), sine) in waves.harmonics.iter().zip(&mut self.sine_strands).zip(sines) {
                *strands = sine.map(|data| strand(data, harmonic.k));
            }
        }
        let ([variance, mut variance_u, mut variance_v], squared_lengths) = self.variances((1.0 / largest) as f32);
        for ((variance, noise), scale) in [&mut variance_u, &mut variance_v].into_iter().zip(waves.noise).zip(scales) {
            let noise = (scale * noise) as f32;
            *variance += noise * noise;
        }
        let errors = (variance.sqrt() * (DEVIATIONS / POSITION_ERROR) as f32).to_array();
        let lengths = squared_lengths[0].sqrt().to_array();
        for ((is_exact, error), length) in self.is_exact.iter_mut().zip(errors).zip(lengths) {
            *is_exact = !(f64::from(length) * largest < f64::from(f32::MAX) && error <= 1.0);
        }
        let allowed = (DEVIATIONS / NORMAL_ERROR) as f32;
        // A variance too small for a single would let everything pass.
        self.tilt = [variance_u, variance_v]
            .map(|variance| (variance * (allowed * allowed)).max(Lanes::splat(f32::MIN_POSITIVE)));
        // With both tangents as long as they can be, and a little more for its own rounding.
        let steepest = (self.tilt[0] * squared_lengths[2] + self.tilt[1] * squared_lengths[1]) * 1.001;
        self.steepest = steepest + LEAST_SQUARE;
    }

    /// How far the sums of positions, times `scale`, and of tangents may be off: the variance of each of their components, from the strands, the tangents scaled as
    /// they are; and the squares of how long positions and tangents are at most. What is too large for single precision has a variance that is infinite or not a number.
    fn variances(&self, scale: f32) -> ([Lanes; 3], [Lanes; 3]) {
        let (mut variances, mut lengths) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        let kinds = [Some(&self.strands), (self.layout == Layout::Both).then_some(&self.sine_strands)];
        for (axis, [value, slope]) in self.constant.iter().enumerate() {
            let constants = [value.abs() * scale, slope.abs(), Lanes::ZERO];
            let (mut squares, mut whole) = (constants.map(|constant| constant * constant), [Lanes::ZERO; 3]);
            for strands in kinds.into_iter().flatten() {
                let (even, odd) = strands.split_at(self.n_even.min(strands.len()));
                let mut waves = weigh(even, axis, scale, &mut squares);
                let odd = weigh(odd, axis, scale, &mut squares);
                join(&mut waves, odd, &mut squares);
                join(&mut whole, waves, &mut squares);
            }
            join(&mut whole, constants, &mut squares);
            for i in 0..3 {
                lengths[i] += whole[i] * whole[i];
                variances[i] = variances[i].fast_max(squares[i]);
            }
        }
        for (variance, length) in variances.iter_mut().zip(lengths) {
            // The products of the normal round by as much again, in parts of the tangents.
            *variance = (*variance + length * 0.5) * ((ROUNDING * ROUNDING) as f32);
        }
        (variances, lengths)
    }
}

/// Adds the squared errors of the sums of one component's strands, in units of a rounding; returns how large these are at most.
#[inline(never)]
fn weigh(strands: &[[Strand; 3]], axis: usize, scale: f32, squares: &mut [Lanes; 3]) -> [Lanes; 3] {
    let mut partial = [Lanes::ZERO; 3];
    let mut terms = [Lanes::ZERO; 3];
    for (index, strand) in strands.iter().enumerate() {
        let [value, slope, turned] = strand[axis];
        for ((size, partial), (terms, square)) in
            [value * scale, slope, turned].into_iter().zip(&mut partial).zip(terms.iter_mut().zip(&mut *squares))
        {
            *terms += size * size;
            *partial += size.abs();
            if index > 0 {
                *square += *partial * *partial;
            }
        }
    }
    // Rounding of the table, of the coefficient and of the product of each; and, from the second on, of the sum.
    for (square, terms) in squares.iter_mut().zip(terms) {
        *square += terms * 3.0;
    }
    partial
}

/// Adds the squared error of joining a part to a sum, in units of a rounding: none where either is 0.
fn join(sum: &mut [Lanes; 3], part: [Lanes; 3], squares: &mut [Lanes; 3]) {
    for ((sum, part), square) in sum.iter_mut().zip(part).zip(squares) {
        let is_rounded = sum.simd_gt(Lanes::ZERO) & part.simd_gt(Lanes::ZERO);
        *sum += part;
        *square += (*sum * *sum) & is_rounded;
    }
}

/// Rounds to single precision.
#[inline(always)]
fn single(block: Block) -> Lanes {
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    {
        // Of an array the compiler rounds one number after the other.
        use core::arch::wasm32::{f32x4_demote_f64x2_zero, i64x2_shuffle, v128};
        let [low, high] = bytemuck::cast::<Block, [v128; 2]>(block).map(|half| f32x4_demote_f64x2_zero(half));
        bytemuck::cast(i64x2_shuffle::<0, 2>(low, high))
    }
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    {
        block.to_array().map(|x| x as f32).into()
    }
}
