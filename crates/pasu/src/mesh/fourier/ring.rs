//! Rows that are circles: every vertex is a multiple of one pattern.

use super::copy::{Circle, Scaled};
use super::lanes::Lanes;
use crate::surface::Turns;

/// What a row's vertices are made of: `radius` times the pattern plus `centre`, with a normal of `level` times the pattern and `upright`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RingRow {
    radius: f32,
    centre: [f32; 3],
    level: f32,
    upright: f32,
}

impl RingRow {
    /// The row that is this circle, normals times `sign`; none where single precision may not hold it in a mesh with a coordinate of at least `largest`, nor where there is no normal.
    ///
    /// With `X = (x + r cos, y + r sin, z)` the product `X_u x X_v` is `k r (-z' cos, -z' sin, r')`.
    pub(super) fn of(circle: &Circle, largest: f64, sign: f64) -> Option<RingRow> {
        let &Circle { copy, k } = circle;
        let Scaled { centre, rise, scale: radius, slope, .. } = copy;
        let along = libm::hypot(slope, rise);
        if along == 0.0 || radius == 0.0 || !copy.is_held(1.0, largest) || !copy.tells([along, f64::INFINITY]) {
            return None;
        }
        let sign = if k * radius < 0.0 { -sign } else { sign };
        Some(RingRow {
            radius: radius as f32,
            centre: centre.map(|x| x as f32),
            level: (-sign * rise / along) as f32,
            upright: (sign * slope / along) as f32,
        })
    }
}

/// `cos, sin, 0` of every column, as vertices follow each other: position and normal of a circular row are this times one number plus another, three numbers at a time.
#[derive(Debug, Default)]
pub(super) struct Pattern {
    numbers: Vec<f32>,
    made_for: Option<(f64, usize)>,
}

impl Pattern {
    /// Makes the pattern of harmonic `n` at a number of columns.
    pub(super) fn prepare(&mut self, n: f64, n_columns: usize, turns: &Turns) {
        if self.made_for != Some((n, n_columns)) {
            self.numbers.clear();
            self.numbers.extend(turns.walk(n).take(n_columns).flat_map(|(cos, sin)| [cos as f32, sin as f32, 0.0]));
            self.made_for = Some((n, n_columns));
        }
    }

    /// Writes a row.
    pub(super) fn write(&self, row: &RingRow, positions: &mut [f32], normals: &mut [f32]) {
        self.fill(positions, row.radius, row.centre);
        self.fill(normals, row.level, [0.0, 0.0, row.upright]);
    }

    /// `factor` times the pattern plus one vector everywhere.
    fn fill(&self, to: &mut [f32], factor: f32, [x, y, z]: [f32; 3]) {
        let plus: [Lanes; 3] = [[x, y, z, x], [y, z, x, y], [z, x, y, z]].map(Lanes::from);
        let by = Lanes::splat(factor);
        let (blocks, rest) = self.numbers.as_chunks::<12>();
        let (to_blocks, to_rest) = to.as_chunks_mut::<12>();
        for (to, block) in to_blocks.iter_mut().zip(blocks) {
            for ((to, from), plus) in to.as_chunks_mut::<4>().0.iter_mut().zip(block.as_chunks::<4>().0).zip(plus) {
                *to = (Lanes::from(*from) * by + plus).to_array();
            }
        }
        for ((to, from), plus) in to_rest.iter_mut().zip(rest).zip([x, y, z].into_iter().cycle()) {
            *to = from * factor + plus;
        }
    }
}
