//! Evaluation as a sum of outer products: tables of `q` per row and of `cos`, `sin` per column.

use wide::f64x4;

use super::solve::Surface;
use super::turns::Turns;

/// Columns that are summed together: two vector registers of doubles for each sum.
pub(crate) const BLOCK: usize = 4;

/// A quantity at the columns of one block. Lane by lane its arithmetic is that of `f64`, whatever the instructions.
pub(crate) type Block = f64x4;

/// `cos(k_n v_j)` and `sin(k_n v_j)` for every distinct `n` of a surface and every column, in blocks of columns; the last block repeats the last column.
#[derive(Debug, Clone)]
pub(crate) struct ColumnTable {
    /// The distinct `n`.
    pub(crate) distinct: Vec<f64>,
    n_columns: usize,
    /// Block by block, cosine and sine of each `n`.
    circles: Vec<[Block; 2]>,
}

impl ColumnTable {
    /// Tables for `n_columns` columns from `v = 0` to `v = span`, both included. For whole `n` the last column has the bits of the first.
    pub(crate) fn new(surface: &Surface, n_columns: usize) -> Self {
        let distinct = surface.distinct().to_vec();
        let mut turns = Turns::default();
        turns.divide(n_columns.max(2) - 1);
        let mut circles = vec![[Block::ZERO; 2]; n_columns.div_ceil(BLOCK) * distinct.len()];
        for (index, &n) in distinct.iter().enumerate() {
            let mut last = (1.0, 0.0);
            let mut walk = turns.walk(n).take(n_columns);
            for pair in circles.iter_mut().skip(index).step_by(distinct.len()) {
                for lane in 0..BLOCK {
                    last = walk.next().unwrap_or(last);
                    pair[0].as_mut_array()[lane] = last.0;
                    pair[1].as_mut_array()[lane] = last.1;
                }
            }
        }
        ColumnTable { distinct, n_columns, circles }
    }

    /// The number of blocks.
    pub(crate) fn n_blocks(&self) -> usize {
        self.n_columns.div_ceil(BLOCK)
    }

    /// Cosine and sine of one distinct `n` at one column.
    pub(crate) fn circle(&self, index: usize, block: usize, lane: usize) -> (f64, f64) {
        self.block(block).get(index).map_or((1.0, 0.0), |[cos, sin]| (cos.to_array()[lane], sin.to_array()[lane]))
    }

    /// Cosine and sine of each distinct `n` at one block of columns.
    pub(crate) fn block(&self, block: usize) -> &[[Block; 2]] {
        let n = self.distinct.len();
        self.circles.get(block * n..(block + 1) * n).unwrap_or_default()
    }
}
