//! Blocks of the cells between rings whose triangles are known not to cross each other, so that nobody has to look.
//!
//! Let `x` and `y` be two linear functions of space. If `x` grows along every edge of a block that leads from a ring to the next, `y` along every edge from a column to the next, and each three
//! corners of a cell go round the same way in the plane of `x` and `y`, then no two points of the block have the same `x` and `y`, and the less the same place: the Jacobian of the map from rings
//! and columns to `x` and `y` is a P-matrix in every triangle (D. Gale and H. Nikaido, *The Jacobian matrix and global univalence of mappings*, 1965).
//!
//! In the plane that is seen at once. Of each column one point at most has a given `x`. As the column moves on along these points, `y` grows, by the determinant divided by the slope of `x`.
//! Where they end at the first or the last ring and begin again at that ring later, `y` grows along the ring between. So none of them has the `y` of another.

use core::ops::Range;

use glam::DVec3;

/// No block: the triangles of the cell are looked at one by one.
pub(super) const NONE: u32 = u32::MAX;

/// With fewer cells than this a block is not worth its while.
const FEWEST_CELLS: usize = 16;

/// How far beyond zero what must be positive is, as a part of what it is made of: far beyond what some twenty roundings take away.
const SURE: f64 = 1e-12;

/// Steps by which the length of a block is measured.
const STEPS: usize = 8;

/// Vertices in rings and columns.
pub(super) struct Rings<F: Fn(usize, usize) -> DVec3> {
    /// Of a vertex by ring and column; the column that is one beyond the last is the first.
    pub(super) at: F,
    pub(super) n_rings: usize,
    pub(super) n_columns: usize,
}

/// Cells from ring to ring and from column to column.
#[derive(Debug, Clone)]
struct Block {
    rings: Range<usize>,
    columns: Range<usize>,
}

impl Block {
    fn n_cells(&self) -> usize {
        self.rings.len() * self.columns.len()
    }
}

impl<F: Fn(usize, usize) -> DVec3> Rings<F> {
    /// For each cell, ring by ring, the number of the block that it is in, from `first` on, or [`NONE`].
    ///
    /// A block whose triangles might cross each other is halved across its longer side.
    pub(super) fn blocks(&self, first: u32) -> Vec<u32> {
        let mut of_cell = vec![NONE; self.n_rings.saturating_sub(1) * self.n_columns];
        let mut number = first;
        let mut open = vec![Block { rings: 0..self.n_rings.saturating_sub(1), columns: 0..self.n_columns }];
        while let Some(block) = open.pop() {
            if block.n_cells() < FEWEST_CELLS {
                continue;
            }
            if self.is_plain(&block) {
                for ring in block.rings.clone() {
                    let row = ring * self.n_columns;
                    of_cell[row + block.columns.start..row + block.columns.end].fill(number);
                }
                number += 1;
                continue;
            }
            open.extend(self.halves(block));
        }
        of_cell
    }

    fn halves(&self, Block { rings, columns }: Block) -> [Block; 2] {
        let halved = |range: &Range<usize>| {
            let middle = range.start + range.len() / 2;
            [range.start..middle, middle..range.end]
        };
        let (ring, column) = (rings.start + rings.len() / 2, columns.start + columns.len() / 2);
        let along = length(&rings, |ring| (self.at)(ring, column));
        let round = length(&columns, |column| (self.at)(ring, column));
        if columns.len() < 2 || (rings.len() > 1 && along > round) {
            halved(&rings).map(|rings| Block { rings, columns: columns.clone() })
        } else {
            halved(&columns).map(|columns| Block { rings: rings.clone(), columns })
        }
    }

    /// Whether it is seen, along one direction, side by side and the same way up.
    fn is_plain(&self, block: &Block) -> bool {
        let Block { rings, columns } = block;
        let thirds = |range: &Range<usize>| [range.start, range.start + range.len() / 2, range.end];
        let from_ring = |column: usize| (self.at)(rings.end, column) - (self.at)(rings.start, column);
        let from_column = |ring: usize| (self.at)(ring, columns.end) - (self.at)(ring, columns.start);
        let along: DVec3 = thirds(columns).map(from_ring).iter().sum();
        let round: DVec3 = thirds(rings).map(from_column).iter().sum();
        let (along, round) = (along.normalize_or_zero(), round.normalize_or_zero());
        let normal = along.cross(round).normalize_or_zero();
        // Along one of them the mean of the other does not grow.
        let axes = Axes { x: round.cross(normal), y: normal.cross(along) };
        rings.clone().all(|ring| {
            let leg = |column: usize| axes.seen((self.at)(ring, column), (self.at)(ring + 1, column));
            let mut before = leg(columns.start);
            before.is_along_x()
                && columns.clone().all(|column| {
                    let after = leg(column + 1);
                    let base = |ring: usize| axes.seen((self.at)(ring, column), (self.at)(ring, column + 1));
                    let bases = [base(ring), base(ring + 1)];
                    let legs = [before, after];
                    before = after;
                    after.is_along_x()
                        && bases.iter().all(|base| base.is_along_y() && legs.iter().all(|leg| leg.turns_left_to(base)))
                })
        })
    }
}

/// The directions along which `x` and `y` grow.
struct Axes {
    x: DVec3,
    y: DVec3,
}

/// An edge in the plane of `x` and `y`.
#[derive(Debug, Clone, Copy)]
struct Seen {
    x: f64,
    y: f64,
    /// The sum of its coordinates in space without signs, to which rounding is in proportion.
    length: f64,
}

impl Axes {
    fn seen(&self, from: DVec3, to: DVec3) -> Seen {
        let edge = to - from;
        Seen { x: edge.dot(self.x), y: edge.dot(self.y), length: edge.abs().element_sum() }
    }
}

impl Seen {
    fn is_along_x(&self) -> bool {
        self.x > SURE * self.length
    }

    fn is_along_y(&self) -> bool {
        self.y > SURE * self.length
    }

    fn turns_left_to(&self, other: &Seen) -> bool {
        self.x * other.y - self.y * other.x > SURE * self.length * other.length
    }
}

/// The length of a row of points, roughly.
fn length(range: &Range<usize>, at: impl Fn(usize) -> DVec3) -> f64 {
    let places: Vec<DVec3> = (0..=STEPS).map(|step| at(range.start + range.len() * step / STEPS)).collect();
    places.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;
    use crate::check;

    const N_RINGS: usize = 41;
    const N_COLUMNS: usize = 60;

    /// Blocks of rings that close round, each cell of which is cut along a diagonal; none crosses itself, and every two cells of one are a rectangle apart.
    fn blocks_of(name: &str, at: impl Fn(usize, usize) -> DVec3) -> Vec<u32> {
        // As the points of a mesh are.
        let rounded = |ring: usize, column: usize| at(ring, column % N_COLUMNS).as_vec3().as_dvec3();
        let rings = Rings { at: rounded, n_rings: N_RINGS, n_columns: N_COLUMNS };
        let blocks = rings.blocks(3);
        assert_eq!(blocks.len(), (N_RINGS - 1) * N_COLUMNS, "{name}");
        let points = (0..N_RINGS).flat_map(|ring| (0..N_COLUMNS).map(move |column| (ring, column)));
        let positions: Vec<[f32; 3]> = points.map(|(i, j)| rounded(i, j).as_vec3().to_array()).collect();
        let mut numbers: Vec<u32> = blocks.iter().copied().filter(|block| *block != NONE).collect();
        numbers.sort_unstable();
        numbers.dedup();
        assert!(numbers.iter().zip(3..).all(|(number, expected)| *number == expected), "{name}: {numbers:?}");
        for number in numbers {
            for is_other in [false, true] {
                let mut triangles = Vec::new();
                for (cell, _) in blocks.iter().enumerate().filter(|(_, block)| **block == number) {
                    let (i, j) = (cell / N_COLUMNS, cell % N_COLUMNS);
                    let vertex = |ring: usize, column: usize| (ring * N_COLUMNS + column % N_COLUMNS) as u32;
                    let (a, b, c, d) = (vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
                    triangles.extend(if is_other { [[a, b, d], [b, c, d]] } else { [[a, b, c], [a, c, d]] });
                }
                assert_eq!(check::a_crossing(&positions, &triangles, |_| None), None, "{name}, block {number}");
            }
        }
        blocks
    }

    fn n_free(blocks: &[u32]) -> usize {
        blocks.iter().filter(|block| **block == NONE).count()
    }

    fn share(index: usize, of: usize) -> f64 {
        index as f64 / of as f64
    }

    #[test]
    fn round_a_cylinder_there_are_few_blocks_and_no_cell_is_left() {
        let blocks = blocks_of("cylinder", |ring, column| {
            let (sin, cos) = (TAU * share(column, N_COLUMNS)).sin_cos();
            DVec3::new(cos, sin, 5.0 * share(ring, N_RINGS))
        });
        assert_eq!(n_free(&blocks), 0);
        // The half of a turn is seen side by side from outside.
        assert_eq!(blocks.iter().max(), Some(&4));
    }

    #[test]
    fn what_runs_into_itself_or_has_no_width_is_in_no_block_whole() {
        // Rolled up in three turns, each in the same place, from ring to ring.
        let roll = |ring: usize, column: usize| {
            let (sin, cos) = (3.0 * TAU * share(ring, N_RINGS)).sin_cos();
            DVec3::new(cos, sin, share(column, N_COLUMNS))
        };
        // A figure eight, a flat sheet folded in two, and one whose rings are points.
        let eight = |ring: usize, column: usize| {
            let turn = TAU * share(column, N_COLUMNS);
            DVec3::new(turn.sin(), (2.0 * turn).sin(), share(ring, N_RINGS))
        };
        let folded = |ring: usize, column: usize| {
            let along = 0.5 - share(ring, N_RINGS - 1);
            DVec3::new(along.abs(), 0.0, share(column, N_COLUMNS))
        };
        let needle = |ring: usize, _: usize| DVec3::Z * share(ring, N_RINGS);
        blocks_of("roll", roll);
        blocks_of("eight", eight);
        let blocks = blocks_of("folded", folded);
        assert!(n_free(&blocks) < blocks.len() / 4, "{}", n_free(&blocks));
        // The column that leads back to the first lies over all others.
        let back = |cell: usize| cell % N_COLUMNS == N_COLUMNS - 1;
        let beside = (0..blocks.len()).filter(|cell| back(*cell) && blocks[*cell] != NONE);
        assert_eq!(beside.filter(|cell| blocks[*cell] == blocks[cell - 1]).count(), 0);
        assert_eq!(n_free(&blocks_of("needle", needle)), (N_RINGS - 1) * N_COLUMNS);
    }

    #[test]
    fn no_block_of_crumpled_rings_crosses_itself() {
        // Marsaglia's xorshift.
        let mut state = 88_172_645_463_325_252u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 40) as f64 / (1u64 << 24) as f64 - 0.5
        };
        let (mut n_in_blocks, mut n_all) = (0, 0);
        for number in 0..60 {
            let waves: Vec<(f64, f64, f64, DVec3)> = (0..6)
                .map(|_| {
                    let (along, round) = ((40.0 * random()).round(), (30.0 * random()).round());
                    (along, round, TAU * random(), DVec3::new(random(), random(), random()))
                })
                .collect();
            let amplitude = 3.0 * f64::from(number % 6) / 6.0;
            let size = 10f64.powf(60.0 * random());
            let blocks = blocks_of(&format!("crumpled {number}"), |ring, column| {
                let (s, v) = (share(ring, N_RINGS), TAU * share(column, N_COLUMNS));
                let mut at = DVec3::new(v.cos(), v.sin(), 3.0 * s);
                for (along, round, phase, by) in &waves {
                    at += amplitude * by * (along * s + round * v + phase).sin();
                }
                size * at
            });
            n_in_blocks += blocks.len() - n_free(&blocks);
            n_all += blocks.len();
        }
        assert!(8 * n_in_blocks > n_all && n_in_blocks < n_all, "{n_in_blocks} of {n_all}");
    }
}
