//! What the columns of four rows are summed from, in single precision, with the error that this costs.

use glam::{DMat3, DVec3};

use super::lanes::Lanes;
use super::outline::Scaled;
use super::tolerance::Tessellation;
use crate::surface::{BLOCK, Block, Curves, Surface, Turns};

/// Rows whose coefficients are made together.
pub(super) const ROWS: usize = BLOCK;

/// Factors of one harmonic in one component, a row in each lane: of the position, of `X_u` and of `X_v`, the tangents scaled by a power of two to be about 1 where they are longest.
pub(super) type Strand = [Lanes; 3];

/// Half a unit in the last place of a single, relative to the number.
pub(super) const HALF_UNIT: f64 = 1.0 / 16_777_216.0;

/// A rounding error is even between plus and minus half a unit in the last place, so that its mean square is that of `0.41 HALF_UNIT` times the number.
const ROUNDING: f64 = 0.41 * HALF_UNIT;

/// How many standard deviations the error of a sum is allowed. The variance is that of terms all at their amplitude at once, four times what it is at the mean vertex, so that these are
/// five: a sum of few terms cannot be off by as much, and one of many is not in as many vertices as a mesh may have.
const DEVIATIONS: f64 = 2.5;

/// The promised largest error of a position, in parts of the largest coordinate.
pub(super) const POSITION_ERROR: f64 = 5e-7;

/// The promised largest error of a normal, less what its own arithmetic takes, in radians.
const NORMAL_ERROR: f64 = 9.2e-7;

/// How far the waves of a row may be from those of a scaled outline, in parts of the largest: more than the twelve digits of a design and solving leave of a
/// copy. What it makes of a normal is asked row by row.
const ALIKE: f64 = 1e-11;

/// Where `|X_u x X_v|^2` is less, beside tangents of about 1, single precision has lost digits of it or soon will.
pub(super) const LEAST_SQUARE: f32 = 1e-30;

/// A wave round the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Harmonic {
    pub(super) n: f64,
    k: f64,
}

/// How the components use the harmonics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// For folded rows: `x` is of cosines, `y` of sines, `z` of one of the two, and what does not depend on `v` does not lean towards `y`. One strand serves
    /// all three components.
    Split { z_is_sine: bool },
    /// Anything else: the strands of the cosines and those of the sines are summed one after the other.
    Both,
}

/// The coefficients of four rows.
#[derive(Debug)]
pub(super) struct Coefficients {
    /// Those of even `n` first; in either part the highest first, whose amplitudes are the smallest nearly always, so that the partial sums stay small.
    pub(super) harmonics: Vec<Harmonic>,
    pub(super) n_even: usize,
    pub(super) layout: Layout,
    /// Half a turn takes the surface into itself: normals there are turned by as much.
    pub(super) is_turned: bool,
    /// For every curve where it goes.
    places: Vec<Place>,
    matrix: DMat3,
    shift: DVec3,
    /// The matrix only stretches along the axes, and no harmonic comes twice in a component: every datum has a place of its own.
    is_axial: bool,
    /// Value and slope of what does not depend on `v`, for each component.
    constants: [[Block; 2]; 3],
    /// The same of what goes with the cosine and with the sine of each harmonic.
    waves: [Vec<[[Block; 2]; 3]>; 2],
    /// Which of [`Coefficients::waves`] each component has.
    has: [[bool; 2]; 3],
    /// How far `X_u` and `X_v` may be off before any of this is rounded to single precision, over the four rows.
    noise: [f64; 2],
    /// Powers of two that bring `X_u` and `X_v` of the whole surface to about 1.
    scales: [f64; 2],
    /// The waves of a row that all others may be scaled copies of: cosine and sine of each harmonic, in `x` and in `y`.
    outline: Vec<[[f64; 2]; 2]>,

    /// Whether what follows has been made of what is above.
    is_single: bool,
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

impl Default for Coefficients {
    fn default() -> Self {
        Coefficients {
            harmonics: Vec::new(),
            n_even: 0,
            layout: Layout::Both,
            is_turned: false,
            places: Vec::new(),
            matrix: DMat3::IDENTITY,
            shift: DVec3::ZERO,
            is_axial: true,
            constants: [[Block::ZERO; 2]; 3],
            waves: [Vec::new(), Vec::new()],
            has: [[false; 2]; 3],
            noise: [0.0; 2],
            scales: [1.0; 2],
            outline: Vec::new(),
            is_single: false,
            constant: [[Lanes::ZERO; 2]; 3],
            strands: Vec::new(),
            sine_strands: Vec::new(),
            tilt: [Lanes::ZERO; 2],
            steepest: Lanes::ZERO,
            is_exact: [false; ROWS],
        }
    }
}

impl Coefficients {
    /// Takes another surface, placed by a matrix and a shift; `folds` as [`folds`](super::kernel::folds).
    pub(super) fn prepare(&mut self, curves: &Curves, matrix: DMat3, shift: DVec3, folds: bool) {
        (self.matrix, self.shift) = (matrix, shift);
        let names = curves.list().iter().map(|curve| (curve.axis, curve.is_sine, curve.n));
        let is_twofold = names
            .clone()
            .enumerate()
            .any(|(index, name)| name.2 != 0.0 && names.clone().skip(index + 1).any(|other| other == name));
        self.is_axial = matrix == DMat3::from_diagonal(matrix.diagonal()) && !is_twofold;
        self.harmonics.clear();
        let is_odd = |harmonic: &Harmonic| harmonic.n != 2.0 * (0.5 * harmonic.n).trunc();
        for curve in curves.list() {
            let harmonic = Harmonic { n: curve.n, k: curve.k };
            if curve.n != 0.0 && !self.harmonics.contains(&harmonic) {
                let order = |other: &Harmonic| (is_odd(other), -other.n.abs());
                let place = self.harmonics.partition_point(|earlier| order(earlier) <= order(&harmonic));
                self.harmonics.insert(place, harmonic);
            }
        }
        self.n_even = self.harmonics.iter().take_while(|harmonic| !is_odd(harmonic)).count();
        self.places.clear();
        self.has = [[false; 2]; 3];
        let mut leans = [false; 3];
        for curve in curves.list() {
            let harmonic = self.harmonics.iter().position(|harmonic| harmonic.n == curve.n);
            let factors = matrix.col(curve.axis).to_array();
            let slope_noise = factors.into_iter().fold(0.0f64, |most, factor| most.max(factor.abs()));
            let noise_factors = [slope_noise, slope_noise * curve.k.abs()];
            let (wave, axis) = (usize::from(curve.is_sine), curve.axis);
            self.places.push(Place { harmonic, wave, axis, factors, noise_factors });
            for ((factor, leans), has) in factors.into_iter().zip(&mut leans).zip(&mut self.has) {
                if factor != 0.0 {
                    if curve.n == 0.0 {
                        *leans = true;
                    } else {
                        has[usize::from(curve.is_sine)] = true;
                    }
                }
            }
        }
        self.layout = match self.has {
            [[_, false], [false, _], [cos, sin]] if folds && !(leans[1] || cos && sin) => {
                Layout::Split { z_is_sine: sin }
            }
            _ => Layout::Both,
        };
        self.is_turned = self.n_even == 0 && self.has[2] == [false; 2] && !leans[0] && !leans[1];
        let zero = [[Block::ZERO; 2]; 3];
        for waves in &mut self.waves {
            waves.clear();
            waves.resize(self.harmonics.len(), zero);
        }
        let silent = [[Lanes::ZERO; 3]; 3];
        for strands in [&mut self.strands, &mut self.sine_strands] {
            strands.clear();
            strands.resize(self.harmonics.len(), silent);
        }
    }

    /// Takes four rows of the surface, in double precision.
    pub(super) fn take(&mut self, surface: &Surface, curves: &Curves, u: [f64; ROWS]) {
        self.gather(surface, curves, u);
        self.is_single = false;
    }

    /// Makes of the rows that were taken what is summed, where that has not been done, for a mesh with a coordinate of at least `largest`.
    pub(super) fn round(&mut self, largest: f64) {
        if self.is_single {
            return;
        }
        self.is_single = true;
        let scales = self.scales;
        for (single_constant, [value, slope]) in self.constant.iter_mut().zip(self.constants) {
            *single_constant = [single(value), single(slope * scales[0])];
        }
        let [cosines, sines] = &self.waves;
        let strand = |[value, slope]: [Block; 2], k: f64| {
            [single(value), single(slope * scales[0]), single(value * (scales[1] * k))]
        };
        for ((harmonic, strands), (cosine, sine)) in
            self.harmonics.iter().zip(&mut self.strands).zip(cosines.iter().zip(sines))
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
            for ((harmonic, strands), sine) in self.harmonics.iter().zip(&mut self.sine_strands).zip(sines) {
                *strands = sine.map(|data| strand(data, harmonic.k));
            }
        }
        let ([variance, mut variance_u, mut variance_v], squared_lengths) = self.variances((1.0 / largest) as f32);
        for ((variance, noise), scale) in [&mut variance_u, &mut variance_v].into_iter().zip(self.noise).zip(scales) {
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

    /// A coordinate that some vertex of the mesh has at least: the largest root mean square of a component over one of a few rows, or the largest component at `v = 0` of these.
    pub(super) fn reached(&mut self, surface: &Surface, curves: &Curves, grid: &Tessellation) -> f64 {
        const STEPS: usize = 8;
        let n_rows = grid.counts().0;
        let u = core::array::from_fn::<f64, { STEPS + 1 }, _>(|i| grid.row(i * (n_rows - 1) / STEPS));
        // The mean over the vertices of a row is that over a whole turn where the columns tell the harmonics apart.
        let are_apart = self.are_apart(grid.round) && surface.is_closed();
        let mut largest = 0.0f64;
        let mut widest = 0.0;
        let mut longest = [0.0f64; 2];
        self.outline.clear();
        for u in u {
            self.gather(surface, curves, [u; ROWS]);
            for (longest, length) in longest.iter_mut().zip(self.tangent_lengths()) {
                *longest = longest.max(length);
            }
            let mut width = 0.0;
            for axis in 0..3 {
                let waves = self.waves.iter().flatten().map(|wave| wave[axis][0] * wave[axis][0]);
                let waves = waves.fold(Block::ZERO, |sum, square| sum + square);
                let constant = self.constants[axis][0];
                let start = self.waves[0].iter().fold(constant, |sum, wave| sum + wave[axis][0]);
                let square = if are_apart { constant * constant + waves * 0.5 } else { start * start };
                largest = largest.max(square.to_array()[0]);
                width += waves.to_array()[0];
            }
            if width > widest && width < f64::MAX && self.has[2] == [false; 2] {
                widest = width;
                let mut outline = core::mem::take(&mut self.outline);
                outline.clear();
                outline.extend(self.waves_of(0).map(|[value, _]| value));
                self.outline = outline;
            }
        }
        self.scales = longest.map(power_of_two);
        // One row that is no copy, and rows are hardly ever asked again.
        for u in u {
            if !self.outline.is_empty() {
                self.gather(surface, curves, [u; ROWS]);
                if self.scaled(0).is_none() {
                    self.outline.clear();
                }
            }
        }
        largest.sqrt()
    }

    /// Whether no two of the harmonics, nor one and what does not depend on `v`, can cancel in all of so many equal steps round.
    fn are_apart(&self, n_steps: f64) -> bool {
        let mut others = self.harmonics.as_slice();
        while let [harmonic, rest @ ..] = others {
            others = rest;
            if 2.0 * harmonic.n.abs() >= n_steps || rest.iter().any(|other| other.n.abs() == harmonic.n.abs()) {
                return false;
            }
        }
        true
    }

    /// Value and slope of each harmonic of a row, of the cosine and the sine of `x` and of `y`.
    fn waves_of(&self, row: usize) -> impl Iterator<Item = [[[f64; 2]; 2]; 2]> {
        let [cosines, sines] = &self.waves;
        cosines.iter().zip(sines).map(move |(cosine, sine)| {
            [0, 1].map(|quantity| [0, 1].map(|axis| [cosine, sine].map(|wave| wave[axis][quantity].to_array()[row])))
        })
    }

    /// Adds up points and tangents, column by column, of the outline that rows may be copies of, and says whether there is one.
    pub(super) fn trace_outline(&self, turns: &Turns, columns: &mut [[[f64; 2]; 2]]) -> bool {
        columns.fill([[0.0; 2]; 2]);
        for (harmonic, wave) in self.harmonics.iter().zip(&self.outline) {
            for ([point, tangent], (cos, sin)) in columns.iter_mut().zip(turns.walk(harmonic.n)) {
                for ((point, tangent), [a, b]) in point.iter_mut().zip(tangent).zip(wave) {
                    *point += a * cos + b * sin;
                    *tangent += harmonic.k * (b * cos - a * sin);
                }
            }
        }
        !self.outline.is_empty()
    }

    /// A row as a copy of the outline, where it is one.
    pub(super) fn scaled(&self, row: usize) -> Option<Scaled> {
        let [x, y, z] = self.constants.map(|constant| constant.map(|block| block.to_array()[row]));
        if self.outline.is_empty() || x[1] != 0.0 || y[1] != 0.0 {
            return None;
        }
        // The sizes of the outline and of the row, and what they have in common, with the weight that each harmonic has in tangents.
        let (mut size, mut common) = (0.0, [0.0; 2]);
        let weighted = || self.harmonics.iter().zip(&self.outline).zip(self.waves_of(row));
        let parts = |wave: [[f64; 2]; 2]| wave.into_iter().flatten();
        for ((_, outline), quantities) in weighted() {
            size += parts(*outline).map(|part| part * part).sum::<f64>();
            for (common, quantity) in common.iter_mut().zip(quantities) {
                *common += parts(*outline).zip(parts(quantity)).map(|(a, b)| a * b).sum::<f64>();
            }
        }
        let [scale, slope] = common.map(|common| common / size);
        // How far the row and its slope are from copies, as that shows in tangents.
        let (mut off, mut lengths) = ([0.0f64; 2], 0.0f64);
        for ((harmonic, outline), quantities) in weighted() {
            let weight = harmonic.k.abs().max(1.0);
            lengths = lengths.max(parts(*outline).fold(0.0, |most, part| part.abs().max(most)) * weight);
            for ((off, quantity), factor) in off.iter_mut().zip(quantities).zip([scale, slope]) {
                let apart = parts(*outline).zip(parts(quantity)).map(|(a, b)| (b - factor * a).abs());
                *off += apart.sum::<f64>() * weight;
            }
        }
        let is_copy =
            off[0] <= ALIKE * lengths * scale.abs() && off[1] <= ALIKE * (lengths * slope.abs()).max(z[1].abs());
        let noise = [self.noise[0] + off[1], self.noise[1] + off[0]];
        is_copy.then_some(Scaled { centre: [x[0], y[0], z[0]], rise: z[1], scale, slope, noise })
    }

    /// The radius of a row that is a circle about a parallel of the axis, and how fast it grows.
    pub(super) fn circle(&self, row: usize) -> Option<Circle> {
        let at = |block: Block| block.to_array()[row];
        let ([cosine], [sine]) = (self.waves[0].as_slice(), self.waves[1].as_slice()) else { return None };
        if self.has != [[true, false], [false, true], [false; 2]] {
            return None;
        }
        let [[radius, slope], [other, other_slope]] = [cosine[0].map(at), sine[1].map(at)];
        let [x, y, z] = self.constants.map(|constant| constant.map(at));
        let is_round = radius == other && slope == other_slope && x[1] == 0.0 && y[1] == 0.0;
        let copy = Scaled { centre: [x[0], y[0], z[0]], rise: z[1], scale: radius, slope, noise: self.noise };
        is_round.then_some(Circle { copy, k: self.harmonics[0].k })
    }

    /// The coefficients in double precision, placed.
    fn gather(&mut self, surface: &Surface, curves: &Curves, u: [f64; ROWS]) {
        self.constants = self.shift.to_array().map(|shift| [Block::splat(shift), Block::ZERO]);
        // Where every datum has a place of its own, those of the rows before are written over.
        if !self.is_axial {
            for waves in &mut self.waves {
                waves.fill([[Block::ZERO; 2]; 3]);
            }
        }
        let is_axial = self.is_axial;
        self.noise = [0.0; 2];
        curves.rows(surface, u, |index, [value, slope], [value_noise, slope_noise]| {
            let Some(&Place { harmonic, wave, axis, factors, noise_factors }) = self.places.get(index) else { return };
            self.noise[0] += slope_noise * noise_factors[0];
            self.noise[1] += value_noise * noise_factors[1];
            let target = match harmonic {
                None => &mut self.constants,
                Some(harmonic) => match self.waves[wave & 1].get_mut(harmonic) {
                    Some(target) => target,
                    None => return,
                },
            };
            if is_axial && harmonic.is_some() {
                target[axis] = [value * factors[axis], slope * factors[axis]];
                return;
            }
            for (target, factor) in target.iter_mut().zip(factors).filter(|(_, factor)| *factor != 0.0) {
                target[0] += value * factor;
                target[1] += slope * factor;
            }
        });
    }

    /// How long `X_u` and `X_v` are at most in the first of the rows: as if all terms were at their amplitude at once.
    fn tangent_lengths(&self) -> [f64; 2] {
        let mut squares = [0.0; 2];
        for (axis, [_, slope]) in self.constants.iter().enumerate() {
            let mut sums = [slope.to_array()[0].abs(), 0.0];
            for (harmonic, wave) in self.waves.iter().flat_map(|waves| self.harmonics.iter().zip(waves)) {
                let [value, slope] = wave[axis].map(|block| block.to_array()[0].abs());
                sums[0] += slope;
                sums[1] += value * harmonic.k.abs();
            }
            for (square, sum) in squares.iter_mut().zip(sums) {
                *square += sum * sum;
            }
        }
        squares.map(f64::sqrt)
    }

    /// How far the sums of positions, times `scale`, and of tangents may be off: the variance of each of their components, from the strands, the tangents scaled as
    /// they are; and the squares of how long positions and tangents are at most. What is too large for single precision has a variance that is infinite or not a number.
    fn variances(&self, scale: f32) -> ([Lanes; 3], [Lanes; 3]) {
        let (mut variances, mut lengths) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        for (axis, [value, slope]) in self.constant.iter().enumerate() {
            let constants = [value.abs() * scale, slope.abs(), Lanes::ZERO];
            let (mut squares, mut whole) = (constants.map(|constant| constant * constant), constants);
            let mut n_parts = self.weigh(&self.strands, axis, scale, &mut squares, &mut whole);
            if self.layout == Layout::Both {
                n_parts += self.weigh(&self.sine_strands, axis, scale, &mut squares, &mut whole);
            }
            for i in 0..3 {
                let length = whole[i] * whole[i];
                lengths[i] += length;
                variances[i] = variances[i].fast_max(squares[i] + length * n_parts);
            }
        }
        for (variance, length) in variances.iter_mut().zip(lengths) {
            // The products of the normal round by as much again, in parts of the tangents.
            *variance = (*variance + length * 0.5) * ((ROUNDING * ROUNDING) as f32);
        }
        (variances, lengths)
    }

    /// Adds the squared errors of one component's sums in units of a rounding, and their sizes; returns in how many parts they are summed.
    #[inline(never)]
    fn weigh(
        &self,
        strands: &[[Strand; 3]],
        axis: usize,
        scale: f32,
        squares: &mut [Lanes; 3],
        whole: &mut [Lanes; 3],
    ) -> f32 {
        let mut n_parts = 0.0;
        for part in [strands.get(..self.n_even), strands.get(self.n_even..)].into_iter().flatten() {
            n_parts += f32::from(u8::from(!part.is_empty()));
            let mut partial = [Lanes::ZERO; 3];
            let mut terms = [Lanes::ZERO; 3];
            for (index, strand) in part.iter().enumerate() {
                let [value, slope, turned] = strand[axis];
                for ((size, partial), (terms, square)) in [value * scale, slope, turned]
                    .into_iter()
                    .zip(&mut partial)
                    .zip(terms.iter_mut().zip(&mut *squares))
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
            for (whole, partial) in whole.iter_mut().zip(partial) {
                *whole += partial;
            }
        }
        n_parts
    }
}

/// Where a curve goes: to a harmonic, or to what does not depend on `v`.
#[derive(Debug, Clone, Copy)]
struct Place {
    harmonic: Option<usize>,
    /// 0 for the cosines, 1 for the sines.
    wave: usize,
    axis: usize,
    /// How much of it each placed component has.
    factors: [f64; 3],
    /// How much of what its slope and its value may be off is in a component of `X_u` and of `X_v` at most.
    noise_factors: [f64; 2],
}

/// A row that is a circle: a copy of that of radius 1, which harmonic `k` goes round.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Circle {
    pub(super) copy: Scaled,
    pub(super) k: f64,
}

/// A power of two that brings a length to between a half and 2; for lengths beyond 1e300 or below 1e-300 as near as that.
fn power_of_two(length: f64) -> f64 {
    const BIAS: u64 = 1023;
    let exponent = (length.to_bits() >> 52).clamp(BIAS - 1000, BIAS + 1000);
    f64::from_bits((2 * BIAS - exponent) << 52)
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
