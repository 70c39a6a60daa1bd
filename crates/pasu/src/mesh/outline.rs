//! Rows that are scaled copies of one outline: their positions are multiples of it, and two numbers make their normals of its tangents.

use super::coefficients::Coefficients;
use super::lanes::{Lanes, write};
use crate::surface::Turns;

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
    /// Whether directions that are made of `X_u` and of `X_v`, of these lengths, are known to all digits that a normal has.
    pub(super) fn tells(&self, lengths: [f64; 2]) -> bool {
        self.noise.iter().zip(lengths).all(|(noise, length)| *noise <= SURE * length)
    }
}

/// What a direction may be off, in radians, by more than the arithmetic of single precision: too little to be seen among that.
const SURE: f64 = 1e-7;

/// An outline and what the normals of its copies are made of.
#[derive(Debug, Default)]
pub(super) struct Outline {
    /// For four columns at a time `P_x`, `P_y`, both components of the unit tangent, and how far the tangent passes the centre.
    blocks: Vec<[Lanes; 5]>,
    /// Points and tangents in double precision, column by column.
    columns: Vec<[[f64; 2]; 2]>,
    /// The least and the largest of those distances, without their sign.
    reach: [f64; 2],
    /// The shortest tangent.
    slowest: f64,
}

/// The shortest of the vectors that normals are made of, in parts of the longest, with which all directions are known to more digits than a normal has.
const SHORTEST: f64 = 1e-4;

impl Outline {
    /// Takes the outline of a surface, and says whether there is one whose copies have their normals by it: not where it comes to a stop.
    pub(super) fn prepare(&mut self, coefficients: &Coefficients, turns: &Turns, n_columns: usize) -> bool {
        self.columns.resize(n_columns, [[0.0; 2]; 2]);
        self.blocks.clear();
        if !coefficients.trace_outline(turns, &mut self.columns) {
            return false;
        }
        let (mut reach, mut speeds) = ([f64::INFINITY, 0.0f64], [f64::INFINITY, 0.0f64]);
        for columns in self.columns.chunks(4) {
            let mut block = [[0.0f32; 4]; 5];
            for (lane, &[[x, y], [dx, dy]]) in columns.iter().enumerate() {
                let speed = (dx * dx + dy * dy).sqrt();
                let [tx, ty] = if speed > 0.0 { [dx / speed, dy / speed] } else { [0.0; 2] };
                let past = x * ty - y * tx;
                reach = [reach[0].min(past.abs()), reach[1].max(past.abs())];
                speeds = [speeds[0].min(speed), speeds[1].max(speed)];
                for (lanes, value) in block.iter_mut().zip([x, y, tx, ty, past]) {
                    lanes[lane] = value as f32;
                }
            }
            self.blocks.push(block.map(Lanes::from));
        }
        (self.reach, self.slowest) = (reach, speeds[0]);
        speeds[0] > SHORTEST * speeds[1]
    }

    /// Writes positions and unit normals of a copy, normals times `sign`; or nothing, and false, where single precision may not hold a normal.
    ///
    /// With the unit tangent `t` of the outline, `X_u x X_v` goes along `(-z' t_y, z' t_x, a' (P_x t_y - P_y t_x))`, the other way for `a < 0`.
    pub(super) fn write(&self, row: &Scaled, sign: f64, positions: &mut [f32], normals: &mut [f32]) -> bool {
        let &Scaled { centre, rise, scale, slope, .. } = row;
        let [nearest, farthest] = self.reach;
        let longest = rise.abs().max(slope.abs() * farthest);
        if scale == 0.0 || !(longest > 0.0 && longest < f64::MAX) {
            return false;
        }
        // At a larger size than 1 neither square leaves single precision, as long as one of the two is not small.
        let (level, upright) = (rise / longest, slope / longest);
        let shortest = level.abs().max(upright.abs() * nearest);
        if shortest < SHORTEST || !row.tells([shortest * longest, scale.abs() * self.slowest]) {
            return false;
        }
        let sign = if scale < 0.0 { -sign } else { sign };
        let [level, upright, scale] = [sign * level, sign * upright, scale].map(|x| Lanes::splat(x as f32));
        let [x, y, z] = centre.map(|x| Lanes::splat(x as f32));
        let level_squared = level * level;
        let place = |&[px, py, tx, ty, past]: &[Lanes; 5]| {
            let up = upright * past;
            let inverse = Lanes::ONE / (level_squared + up * up).sqrt();
            let around = level * inverse;
            ([x + scale * px, y + scale * py, z], [-(around * ty), around * tx, up * inverse])
        };
        let n_whole = self.columns.len() / 4;
        for (index, block) in self.blocks.iter().take(n_whole).enumerate() {
            let (position, normal) = place(block);
            write(position, positions, 4 * index);
            write(normal, normals, 4 * index);
        }
        if let Some(block) = self.blocks.get(n_whole) {
            let (position, normal) = place(block);
            for (vectors, to) in [(position, positions), (normal, normals)] {
                let mut last = [0.0; 12];
                write(vectors, &mut last, 0);
                for (to, value) in to.iter_mut().skip(12 * n_whole).zip(last) {
                    *to = value;
                }
            }
        }
        true
    }
}
