//! What the columns of four rows are summed from, in single precision, with the error that this costs.

use glam::{DMat3, DVec3};

use super::lanes::Lanes;
use crate::surface::{BLOCK, Block, Curves, Surface};

/// Rows whose coefficients are made together.
pub(super) const ROWS: usize = BLOCK;

/// Factors of one harmonic in one component, a row in each lane: of the position, of `X_u` and of `X_v`, the tangents scaled by a power of two to be about 1.
pub(super) type Strand = [Lanes; 3];

/// Half a unit in the last place of a single, relative to the number.
const HALF_UNIT: f64 = 1.0 / 16_777_216.0;

/// A rounding error is even between plus and minus half a unit in the last place, so that its mean square is that of `0.41 HALF_UNIT` times the number.
const ROUNDING: f64 = 0.41 * HALF_UNIT;

/// How many standard deviations the error of a sum is allowed. The variance is that of terms all at their amplitude at once, four times what it is at the mean vertex, so that these are
/// five: a sum of few terms cannot be off by as much, and one of many is not in as many vertices as a mesh may have.
const DEVIATIONS: f64 = 2.5;

/// The promised largest error of a position, in parts of the largest coordinate.
pub(super) const POSITION_ERROR: f64 = 5e-7;

/// The promised largest error of a normal, less what its own arithmetic takes, in radians.
const NORMAL_ERROR: f64 = 9.2e-7;

/// A wave round the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Harmonic {
    pub(super) n: f64,
    k: f64,
}

/// How the components use the harmonics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// `x` is of cosines, `y` of sines, `z` of one of the two: one strand serves all three components.
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
    /// What does not depend on `v` does not lean towards `y`.
    pub(super) is_upright: bool,
    /// Half a turn takes the surface into itself: normals there are turned by as much.
    pub(super) is_turned: bool,
    /// For every curve its harmonic, or none where it does not depend on `v`.
    slots: Vec<Option<usize>>,
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

    /// Value and slope of what does not depend on `v`, the slope scaled as the strands are.
    pub(super) constant: [[Lanes; 2]; 3],
    /// The strands of each harmonic and component: those of [`Layout::Split`], or of the cosines.
    pub(super) strands: Vec<[Strand; 3]>,
    /// Those of the sines, for [`Layout::Both`].
    pub(super) sine_strands: Vec<[Strand; 3]>,
    /// With these the normal of a vertex is known to be off when `tilt_u |X_v|^2 + tilt_v |X_u|^2 > |X_u x X_v|^2`.
    pub(super) tilt: [Lanes; 2],
    /// Whether single precision is not enough for the positions of a row, or its range is not.
    pub(super) is_exact: [bool; ROWS],
}

impl Default for Coefficients {
    fn default() -> Self {
        Coefficients {
            harmonics: Vec::new(),
            n_even: 0,
            layout: Layout::Both,
            is_upright: false,
            is_turned: false,
            slots: Vec::new(),
            matrix: DMat3::IDENTITY,
            shift: DVec3::ZERO,
            is_axial: true,
            constants: [[Block::ZERO; 2]; 3],
            waves: [Vec::new(), Vec::new()],
            has: [[false; 2]; 3],
            constant: [[Lanes::ZERO; 2]; 3],
            strands: Vec::new(),
            sine_strands: Vec::new(),
            tilt: [Lanes::ZERO; 2],
            is_exact: [false; ROWS],
        }
    }
}

impl Coefficients {
    /// Takes another surface, placed by a matrix and a shift.
    pub(super) fn prepare(&mut self, curves: &Curves, matrix: DMat3, shift: DVec3) {
        (self.matrix, self.shift) = (matrix, shift);
        let names = curves.list().iter().map(|curve| (curve.axis, curve.is_sine, curve.n));
        let is_twofold = names
            .clone()
            .enumerate()
            .any(|(index, name)| name.2 != 0.0 && names.clone().skip(index + 1).any(|other| other == name));
        self.is_axial = matrix == DMat3::from_diagonal(matrix.diagonal()) && !is_twofold;
        self.harmonics.clear();
        let is_odd = |harmonic: &Harmonic| libm::fmod(harmonic.n, 2.0) != 0.0;
        for curve in curves.list() {
            let harmonic = Harmonic { n: curve.n, k: curve.k };
            if curve.n != 0.0 && !self.harmonics.contains(&harmonic) {
                let order = |other: &Harmonic| (is_odd(other), -other.n.abs());
                let place = self.harmonics.partition_point(|earlier| order(earlier) <= order(&harmonic));
                self.harmonics.insert(place, harmonic);
            }
        }
        self.n_even = self.harmonics.iter().take_while(|harmonic| !is_odd(harmonic)).count();
        self.slots.clear();
        self.has = [[false; 2]; 3];
        let mut leans = [false; 3];
        for curve in curves.list() {
            self.slots.push(self.harmonics.iter().position(|harmonic| harmonic.n == curve.n));
            for ((factor, leans), has) in
                matrix.col(curve.axis).to_array().into_iter().zip(&mut leans).zip(&mut self.has)
            {
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
            [[_, false], [false, _], [cos, sin]] if !(cos && sin) => Layout::Split { z_is_sine: sin },
            _ => Layout::Both,
        };
        self.is_upright = !leans[1];
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

    /// Takes four rows of the surface, whose mesh has a coordinate of at least `largest`.
    pub(super) fn take(&mut self, surface: &Surface, curves: &Curves, u: [f64; ROWS], largest: f64) {
        self.gather(surface, curves, u);
        let sizes = self.sizes();
        let [position, tangent_u, tangent_v] = sizes;
        let error = (position.variance.sqrt() * DEVIATIONS).to_array();
        for ((is_exact, error), length) in self.is_exact.iter_mut().zip(error).zip(position.length.to_array()) {
            *is_exact = !(length < f64::from(f32::MAX) && error <= POSITION_ERROR * largest);
        }
        let scales = [power_of_two(tangent_u.length), power_of_two(tangent_v.length)];
        for (tilt, (size, scale)) in self.tilt.iter_mut().zip([tangent_u, tangent_v].iter().zip(scales)) {
            let allowed = DEVIATIONS / NORMAL_ERROR;
            // A variance too small for a single would let everything pass.
            *tilt = single(size.variance * (allowed * allowed) * scale * scale).max(Lanes::splat(f32::MIN_POSITIVE));
        }
        for (single_constant, [value, slope]) in self.constant.iter_mut().zip(self.constants) {
            *single_constant = [single(value), single(slope * scales[0])];
        }
        let [cosines, sines] = &self.waves;
        let strand = |[value, slope]: [Block; 2], k: f64| {
            [single(value), single(slope * scales[0]), single(value * k * scales[1])]
        };
        for (index, &Harmonic { k, .. }) in self.harmonics.iter().enumerate() {
            let (cosine, sine) = (cosines[index], sines[index]);
            match self.layout {
                Layout::Split { z_is_sine } => {
                    let z = if z_is_sine { strand(sine[2], k) } else { strand(cosine[2], -k) };
                    self.strands[index] = [strand(cosine[0], -k), strand(sine[1], k), z];
                }
                Layout::Both => {
                    self.strands[index] = cosine.map(|data| strand(data, -k));
                    self.sine_strands[index] = sine.map(|data| strand(data, k));
                }
            }
        }
    }

    /// A coordinate that the placed surface reaches: the largest root mean square of a component over a row, among some rows.
    pub(super) fn reached(&mut self, surface: &Surface, curves: &Curves) -> f64 {
        const STEPS: usize = 8;
        let mut largest = 0.0f64;
        for i in 0..=STEPS {
            self.gather(surface, curves, [i as f64 / STEPS as f64; ROWS]);
            for axis in 0..3 {
                let waves = self.waves.iter().flatten().map(|wave| wave[axis][0] * wave[axis][0]);
                let constant = self.constants[axis][0];
                let square = constant * constant + waves.fold(Block::ZERO, |sum, square| sum + square) * 0.5;
                largest = largest.max(square.to_array()[0]);
            }
        }
        libm::sqrt(largest)
    }

    /// The radius of a row that is a circle about a parallel of the axis, and how fast it grows.
    pub(super) fn circle(&self, row: usize) -> Option<Circle> {
        let at = |block: Block| block.to_array()[row];
        let ([cosine], [sine]) = (self.waves[0].as_slice(), self.waves[1].as_slice()) else { return None };
        if self.layout != (Layout::Split { z_is_sine: false }) || self.has[2][0] || self.is_exact[row] {
            return None;
        }
        let [[radius, slope], [other, other_slope]] = [cosine[0].map(at), sine[1].map(at)];
        let [x, y, z] = self.constants.map(|constant| constant.map(at));
        let is_round = radius == other && slope == other_slope && x[1] == 0.0 && y[1] == 0.0;
        is_round.then_some(Circle { centre: [x[0], y[0], z[0]], rise: z[1], radius, slope, k: self.harmonics[0].k })
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
        let list = curves.list();
        curves.rows(surface, u, |index, [value, slope]| {
            let (Some(curve), Some(slot)) = (list.get(index), self.slots.get(index)) else { return };
            let factors = self.matrix.col(curve.axis).to_array();
            match slot {
                Some(harmonic) if self.is_axial => {
                    let factor = factors[curve.axis];
                    self.waves[usize::from(curve.is_sine)][*harmonic][curve.axis] = [value * factor, slope * factor];
                }
                slot => {
                    let target = match slot {
                        None => &mut self.constants,
                        Some(harmonic) => &mut self.waves[usize::from(curve.is_sine)][*harmonic],
                    };
                    for (target, factor) in target.iter_mut().zip(factors).filter(|(_, factor)| *factor != 0.0) {
                        target[0] += value * factor;
                        target[1] += slope * factor;
                    }
                }
            }
        });
    }

    /// How large positions and tangents may be and how far their sums may be off.
    fn sizes(&self) -> [Size; 3] {
        let mut sizes = [Size { length: Block::ZERO, variance: Block::ZERO }; 3];
        let n = self.harmonics.len();
        for axis in 0..3 {
            let mut sum = [Block::ZERO; 3];
            let mut squares = [Block::ZERO; 3];
            let mut n_parts = 0.0;
            for (waves, _) in self.waves.iter().zip(self.has[axis]).filter(|(_, has)| *has) {
                for part in [0..self.n_even, self.n_even..n] {
                    n_parts += f64::from(u8::from(!part.is_empty()));
                    let mut partial = [Block::ZERO; 3];
                    for (index, harmonic) in self.harmonics.iter().enumerate().take(part.end).skip(part.start) {
                        let [value, slope] = waves[index][axis].map(Block::abs);
                        for (i, size) in [value, slope, value * harmonic.k.abs()].into_iter().enumerate() {
                            // Rounding of the table, of the coefficient and of the product; and, from the second on, of the sum.
                            squares[i] += size * size * 3.0;
                            if index > part.start {
                                let so_far = partial[i] + size;
                                squares[i] += so_far * so_far;
                            }
                            partial[i] += size;
                        }
                    }
                    for (sum, partial) in sum.iter_mut().zip(partial) {
                        *sum += partial;
                    }
                }
            }
            let [value, slope] = self.constants[axis].map(Block::abs);
            for (i, constant) in [value, slope, Block::ZERO].into_iter().enumerate() {
                let whole = sum[i] + constant;
                squares[i] += constant * constant + whole * whole * n_parts;
                sizes[i].length += whole * whole;
                sizes[i].variance = sizes[i].variance.fast_max(squares[i]);
            }
        }
        for size in &mut sizes {
            // The products of the normal round by as much again, in parts of the tangents.
            size.variance = (size.variance + size.length * 0.5) * (ROUNDING * ROUNDING);
            size.length = size.length.sqrt();
        }
        sizes
    }
}

/// A bound on the length of a vector and the variance of each of its components.
#[derive(Debug, Clone, Copy)]
struct Size {
    length: Block,
    variance: Block,
}

/// A row that is a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Circle {
    pub(super) centre: [f64; 3],
    pub(super) rise: f64,
    pub(super) radius: f64,
    pub(super) slope: f64,
    pub(super) k: f64,
}

/// A power of two that brings a length to between a half and 1.
fn power_of_two(length: Block) -> Block {
    length.to_array().map(|length| libm::ldexp(1.0, -libm::frexp(length).1.clamp(-1000, 1000))).into()
}

fn single(block: Block) -> Lanes {
    block.to_array().map(|x| x as f32).into()
}
