//! Evaluation as a sum of outer products: tables of `q` per row and of `cos`, `sin` per column (`math.md` section 1).

use super::circle;
use super::solve::Surface;

/// Columns that are summed together: two vector registers of doubles for each sum.
pub(crate) const BLOCK: usize = 4;

/// A quantity at the columns of one block.
pub(crate) type Block = [f64; BLOCK];

/// Coefficients of `cos(k v)` and `sin(k v)` at one row.
#[derive(Debug, Clone)]
pub(crate) struct RowTerm<const N: usize> {
    /// Index of the distinct `n` in the [`ColumnTable`].
    pub(crate) column: usize,
    pub(crate) k: f64,
    /// Derivatives of `A` up to order `N - 1`.
    pub(crate) cos: [f64; N],
    /// Derivatives of `B` up to order `N - 1`.
    pub(crate) sin: [f64; N],
}

/// What one row of constant `u` needs of the solution.
#[derive(Debug, Clone)]
pub(crate) struct RowTable<const N: usize> {
    pub(crate) components: [Vec<RowTerm<N>>; 3],
}

impl<const N: usize> RowTable<N> {
    /// The coefficients at `u`, for the columns of a table of the same surface.
    pub(crate) fn at(surface: &Surface, distinct: &[f64], u: f64) -> Self {
        let components = surface.components().each_ref().map(|terms| {
            let row = |term: &super::solve::Term| {
                let [cos, sin] = term.equation.jets::<N, 2>([&term.cos, &term.sin], u);
                let column = distinct.iter().position(|n| *n == term.n).unwrap_or(0);
                RowTerm { column, k: term.k, cos, sin }
            };
            terms.iter().map(row).collect()
        });
        RowTable { components }
    }
}

/// `cos(k_n v_j)` and `sin(k_n v_j)` for every distinct `n` of a surface and every column, in blocks that are padded at the end of each line.
#[derive(Debug, Clone)]
pub(crate) struct ColumnTable {
    /// The distinct `n`.
    pub(crate) distinct: Vec<f64>,
    blocks_per_line: usize,
    /// The cosines and then the sines of each `n` in turn.
    blocks: Vec<Block>,
}

impl ColumnTable {
    /// Tables for `n_columns` columns from `v = 0` to `v = span`, both included. For whole `n` the last column has the bits of the first.
    pub(crate) fn new(surface: &Surface, n_columns: usize) -> Self {
        let distinct = distinct(surface);
        let steps = (n_columns.max(2) - 1) as f64;
        let blocks_per_line = n_columns.div_ceil(BLOCK);
        let mut blocks = vec![[0.0; BLOCK]; 2 * blocks_per_line * distinct.len()];
        for (lines, &n) in blocks.chunks_exact_mut(2 * blocks_per_line).zip(&distinct) {
            let (cosines, sines) = lines.as_flattened_mut().split_at_mut(BLOCK * blocks_per_line);
            for (j, (c, s)) in cosines.iter_mut().zip(sines).take(n_columns).enumerate() {
                // n j is exact for every grid within the vertex limit, so the turn is reduced before the division rounds.
                (*c, *s) = circle::of_turns(libm::fmod(n * j as f64, steps) / steps);
            }
        }
        ColumnTable { distinct, blocks_per_line, blocks }
    }

    /// The number of blocks in a line.
    pub(crate) fn n_blocks(&self) -> usize {
        self.blocks_per_line
    }

    /// The first block of the cosines of the `n` with this index.
    pub(crate) fn cos(&self, index: usize) -> usize {
        2 * index * self.blocks_per_line
    }

    /// The first block of the sines of the `n` with this index.
    pub(crate) fn sin(&self, index: usize) -> usize {
        (2 * index + 1) * self.blocks_per_line
    }

    /// A block by its number.
    pub(crate) fn block(&self, number: usize) -> Option<&Block> {
        self.blocks.get(number)
    }
}

/// The different `n` of a surface, in the order of their first use.
pub(crate) fn distinct(surface: &Surface) -> Vec<f64> {
    let mut distinct = Vec::new();
    for term in surface.components().iter().flatten() {
        if !distinct.contains(&term.n) {
            distinct.push(term.n);
        }
    }
    distinct
}
