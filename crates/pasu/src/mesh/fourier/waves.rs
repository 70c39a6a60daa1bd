//! The coefficients of four rows in double precision, placed.

use glam::{DMat3, DVec3};

use crate::surface::{BLOCK, Block, Curves, Surface};

/// Rows whose coefficients are made together.
pub(super) const ROWS: usize = BLOCK;

/// A wave round the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Harmonic {
    pub(super) n: f64,
    pub(super) k: f64,
}

/// What four rows are sums of.
#[derive(Debug, Default)]
pub(super) struct Waves {
    /// Those of even `n` first; in either part the highest first, whose amplitudes are the smallest nearly always, so that the partial sums stay small.
    pub(super) harmonics: Vec<Harmonic>,
    pub(super) n_even: usize,
    /// Which waves each component has: those of cosines, those of sines.
    pub(super) has: [[bool; 2]; 3],
    /// Which components have something that does not depend on `v`.
    pub(super) leans: [bool; 3],
    /// Value and slope of what does not depend on `v`, for each component.
    pub(super) constants: [[Block; 2]; 3],
    /// The same of what goes with the cosine and with the sine of each harmonic.
    pub(super) data: [Vec<[[Block; 2]; 3]>; 2],
    /// How far `X_u` and `X_v` may be off before any of this is rounded to single precision, over the four rows.
    pub(super) noise: [f64; 2],
    /// For every curve where it goes.
    places: Vec<Place>,
    shift: DVec3,
    /// The matrix only stretches along the axes, and no harmonic comes twice in a component: every datum has a place of its own.
    is_axial: bool,
}

impl Waves {
    /// Takes another surface, placed by a matrix and a shift.
    pub(super) fn prepare(&mut self, curves: &Curves, matrix: DMat3, shift: DVec3) {
        self.shift = shift;
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
        self.leans = [false; 3];
        for curve in curves.list() {
            let harmonic = self.harmonics.iter().position(|harmonic| harmonic.n == curve.n);
            let factors = matrix.col(curve.axis).to_array();
            let slope_noise = factors.into_iter().fold(0.0f64, |most, factor| most.max(factor.abs()));
            let noise_factors = [slope_noise, slope_noise * curve.k.abs()];
            let (wave, axis) = (usize::from(curve.is_sine), curve.axis);
            self.places.push(Place { harmonic, wave, axis, factors, noise_factors });
            for ((factor, leans), has) in factors.into_iter().zip(&mut self.leans).zip(&mut self.has) {
                if factor != 0.0 {
                    if curve.n == 0.0 {
                        *leans = true;
                    } else {
                        has[usize::from(curve.is_sine)] = true;
                    }
                }
            }
        }
        let zero = [[Block::ZERO; 2]; 3];
        for waves in &mut self.data {
            waves.clear();
            waves.resize(self.harmonics.len(), zero);
        }
    }

    /// Takes four rows of the surface.
    pub(super) fn take(&mut self, surface: &Surface, curves: &Curves, u: [f64; ROWS]) {
        self.constants = self.shift.to_array().map(|shift| [Block::splat(shift), Block::ZERO]);
        // Where every datum has a place of its own, those of the rows before are written over.
        if !self.is_axial {
            for waves in &mut self.data {
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
                Some(harmonic) => match self.data[wave & 1].get_mut(harmonic) {
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
    pub(super) fn tangent_lengths(&self) -> [f64; 2] {
        let mut squares = [0.0; 2];
        for (axis, [_, slope]) in self.constants.iter().enumerate() {
            let mut sums = [slope.to_array()[0].abs(), 0.0];
            for (harmonic, wave) in self.data.iter().flat_map(|waves| self.harmonics.iter().zip(waves)) {
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

    /// Whether no two of the harmonics, nor one and what does not depend on `v`, can cancel in all of so many equal steps round.
    pub(super) fn are_apart(&self, n_steps: f64) -> bool {
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
    pub(super) fn of(&self, row: usize) -> impl Iterator<Item = [[[f64; 2]; 2]; 2]> {
        let [cosines, sines] = &self.data;
        cosines.iter().zip(sines).map(move |(cosine, sine)| {
            [0, 1].map(|quantity| [0, 1].map(|axis| [cosine, sine].map(|wave| wave[axis][quantity].to_array()[row])))
        })
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
