//! Rows that are scaled copies of one outline: their positions are multiples of it, and two numbers make their normals of its tangents.

use super::copy::{Original, Scaled};
use super::lanes::{Lanes, write};
use super::waves::Harmonic;
use crate::surface::Turns;

/// What a copy's vertices are made of: its centre, `a`, and the two numbers of its normals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OutlineRow {
    centre: [f32; 3],
    scale: f32,
    level: f32,
    upright: f32,
}

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
    /// The largest coordinate.
    size: f64,
}

/// The shortest of the vectors that normals are made of, in parts of the longest, with which all directions are known to more digits than a normal has.
const SHORTEST: f64 = 1e-4;

impl Outline {
    /// Takes the outline of a surface, and says whether there is one whose copies have their normals by it: not where it comes to a stop.
    pub(super) fn prepare(
        &mut self,
        original: &Original,
        harmonics: &[Harmonic],
        turns: &Turns,
        n_columns: usize,
    ) -> bool {
        self.columns.resize(n_columns, [[0.0; 2]; 2]);
        self.blocks.clear();
        if !original.trace(harmonics, turns, &mut self.columns) {
            return false;
        }
        let (mut reach, mut speeds, mut size) = ([f64::INFINITY, 0.0f64], [f64::INFINITY, 0.0f64], 0.0f64);
        for columns in self.columns.chunks(4) {
            let mut block = [[0.0f32; 4]; 5];
            for (lane, &[[x, y], [dx, dy]]) in columns.iter().enumerate() {
                let speed = (dx * dx + dy * dy).sqrt();
                let [tx, ty] = if speed > 0.0 { [dx / speed, dy / speed] } else { [0.0; 2] };
                let past = x * ty - y * tx;
                reach = [reach[0].min(past.abs()), reach[1].max(past.abs())];
                speeds = [speeds[0].min(speed), speeds[1].max(speed)];
                size = size.max(x.abs()).max(y.abs());
                for (lanes, value) in block.iter_mut().zip([x, y, tx, ty, past]) {
                    lanes[lane] = value as f32;
                }
            }
            self.blocks.push(block.map(Lanes::from));
        }
        (self.reach, self.slowest, self.size) = (reach, speeds[0], size);
        speeds[0] > SHORTEST * speeds[1]
    }

    /// A copy, normals times `sign`; none where single precision may not hold a position or a normal of it in a mesh with a coordinate of at least `largest`.
    ///
    /// With the unit tangent `t` of the outline, `X_u x X_v` goes along `(-z' t_y, z' t_x, a' (P_x t_y - P_y t_x))`, the other way for `a < 0`.
    pub(super) fn row(&self, copy: &Scaled, largest: f64, sign: f64) -> Option<OutlineRow> {
        let &Scaled { centre, rise, scale, slope, .. } = copy;
        let [nearest, farthest] = self.reach;
        let longest = rise.abs().max(slope.abs() * farthest);
        if scale == 0.0 || !(longest > 0.0 && longest < f64::MAX) || !copy.is_held(self.size, largest) {
            return None;
        }
        // At a larger size than 1 neither square leaves single precision, as long as one of the two is not small.
        let (level, upright) = (rise / longest, slope / longest);
        let shortest = level.abs().max(upright.abs() * nearest);
        if shortest < SHORTEST || !copy.tells([shortest * longest, scale.abs() * self.slowest]) {
            return None;
        }
        let sign = if scale < 0.0 { -sign } else { sign };
        let [level, upright, scale] = [sign * level, sign * upright, scale].map(|x| x as f32);
        Some(OutlineRow { centre: centre.map(|x| x as f32), scale, level, upright })
    }

    /// Writes positions and unit normals of a copy.
    pub(super) fn write(&self, row: &OutlineRow, positions: &mut [f32], normals: &mut [f32]) {
        let [x, y, z] = row.centre.map(Lanes::splat);
        let [scale, level, upright] = [row.scale, row.level, row.upright].map(Lanes::splat);
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
    }
}
