//! Rows that are scaled copies of one row, and how that is found.

use super::waves::{Harmonic, Waves};
use crate::mesh::promise::{HALF_UNIT, POSITION_ERROR};
use crate::surface::{Block, Turns};

/// How far the waves of a row may be from those of a scaled outline, in parts of the largest: more than the twelve digits of a design and solving leave of a
/// copy. What it makes of a normal is asked row by row.
const ALIKE: f64 = 1e-11;

/// A row at height `z` about the point `(x, y)`: `X = (x + a P_x(v), y + a P_y(v), z)` of the outline `P`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scaled {
    pub(super) centre: [f64; 3],
    /// `z'`, the slope of the height.
    pub(super) rise: f64,
    /// `a`.
    pub(super) scale: f64,
    /// `a'`.
    pub(super) slope: f64,
    /// How far `X_u` and `X_v` may be off.
    pub(super) noise: [f64; 2],
}

impl Scaled {
    /// Whether single precision holds the positions of a mesh with a coordinate of at least `largest`, for an outline of this size.
    ///
    /// Outline, `a` and their product are rounded, then the centre, and the sum at last.
    pub(super) fn is_held(&self, size: f64, largest: f64) -> bool {
        let centre = self.centre.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let farthest = self.scale.abs() * size + centre;
        4.0 * HALF_UNIT * farthest <= POSITION_ERROR * largest && farthest < f64::from(f32::MAX)
    }

    /// Whether directions that are made of `X_u` and of `X_v`, of these lengths, are known to all digits that a normal has.
    pub(super) fn tells(&self, lengths: [f64; 2]) -> bool {
        self.noise.iter().zip(lengths).all(|(noise, length)| *noise <= SURE * length)
    }
}

/// What a direction may be off, in radians, by more than the arithmetic of single precision: too little to be seen among that.
const SURE: f64 = 1e-7;

/// The waves of a row that all others may be scaled copies of: cosine and sine of each harmonic, in `x` and in `y`. Empty where no row has copies.
#[derive(Debug, Default)]
pub(super) struct Original {
    waves: Vec<[[f64; 2]; 2]>,
}

impl Original {
    /// Forgets the row.
    pub(super) fn clear(&mut self) {
        self.waves.clear();
    }

    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.waves.is_empty()
    }

    /// Takes the first of four rows.
    pub(super) fn take(&mut self, waves: &Waves) {
        self.waves.clear();
        self.waves.extend(waves.of(0).map(|[value, _]| value));
    }

    /// Adds up points and tangents, column by column, of the row that others may be copies of, and says whether there is one.
    pub(super) fn trace(&self, harmonics: &[Harmonic], turns: &Turns, columns: &mut [[[f64; 2]; 2]]) -> bool {
        columns.fill([[0.0; 2]; 2]);
        for (harmonic, wave) in harmonics.iter().zip(&self.waves) {
            for ([point, tangent], (cos, sin)) in columns.iter_mut().zip(turns.walk(harmonic.n)) {
                for ((point, tangent), [a, b]) in point.iter_mut().zip(tangent).zip(wave) {
                    *point += a * cos + b * sin;
                    *tangent += harmonic.k * (b * cos - a * sin);
                }
            }
        }
        !self.waves.is_empty()
    }

    /// A row as a copy, where it is one.
    pub(super) fn scaled(&self, waves: &Waves, row: usize) -> Option<Scaled> {
        let [x, y, z] = waves.constants.map(|constant| constant.map(|block| block.to_array()[row]));
        if self.waves.is_empty() || x[1] != 0.0 || y[1] != 0.0 {
            return None;
        }
        // The sizes of the outline and of the row, and what they have in common, with the weight that each harmonic has in tangents.
        let (mut size, mut common) = (0.0, [0.0; 2]);
        let weighted = || waves.harmonics.iter().zip(&self.waves).zip(waves.of(row));
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
        let noise = [waves.noise[0] + off[1], waves.noise[1] + off[0]];
        is_copy.then_some(Scaled { centre: [x[0], y[0], z[0]], rise: z[1], scale, slope, noise })
    }
}

/// A row that is a circle: a copy of that of radius 1, which harmonic `k` goes round.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Circle {
    pub(super) copy: Scaled,
    pub(super) k: f64,
}

impl Circle {
    /// The radius of a row that is a circle about a parallel of the axis, and how fast it grows.
    pub(super) fn of(waves: &Waves, row: usize) -> Option<Circle> {
        let at = |block: Block| block.to_array()[row];
        let ([cosine], [sine]) = (waves.data[0].as_slice(), waves.data[1].as_slice()) else { return None };
        if waves.has != [[true, false], [false, true], [false; 2]] {
            return None;
        }
        let [[radius, slope], [other, other_slope]] = [cosine[0].map(at), sine[1].map(at)];
        let [x, y, z] = waves.constants.map(|constant| constant.map(at));
        let is_round = radius == other && slope == other_slope && x[1] == 0.0 && y[1] == 0.0;
        let copy = Scaled { centre: [x[0], y[0], z[0]], rise: z[1], scale: radius, slope, noise: waves.noise };
        is_round.then_some(Circle { copy, k: waves.harmonics[0].k })
    }
}
