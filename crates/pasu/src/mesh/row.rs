//! One row of a grid: the sum of outer products, a block of columns at a time.
//!
//! This is where a mesh's time goes. A vertex costs three multiplications and additions per datum that is not 0, a square root and a division; tables and
//! coefficients are made once per column and row. Blocks are plain arrays, which compilers turn into vector instructions without changing a bit.

use glam::DVec3;

use crate::surface::{BLOCK, Block, ColumnTable, RowTable};

/// One datum of one mode at one row: adds `value * line` to the position, `slope * line` to `X_u` and `turned * other` to `X_v`, where `line` is
/// `cos(k v)` and `other` `sin(k v)`, or the reverse.
#[derive(Debug, Clone, Copy)]
struct Strand {
    value: f64,
    slope: f64,
    turned: f64,
    /// First block of the line in the table.
    line: usize,
    /// First block of the other line.
    other: usize,
}

/// Position and tangents at the columns of one block, component by component.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sums {
    pub(super) position: [Block; 3],
    pub(super) du: [Block; 3],
    pub(super) dv: [Block; 3],
}

/// The strands of one row, kept to be filled again.
#[derive(Debug, Default)]
pub(super) struct Row {
    strands: [Vec<Strand>; 3],
}

impl Row {
    /// Takes the coefficients of a row of the surface that the table is of.
    pub(super) fn fill(&mut self, row: &RowTable<2>, table: &ColumnTable) {
        for (strands, terms) in self.strands.iter_mut().zip(&row.components) {
            strands.clear();
            for term in terms {
                let (cos, sin) = (table.cos(term.column), table.sin(term.column));
                let [value, slope] = term.cos;
                strands.push(Strand { value, slope, turned: -term.k * value, line: cos, other: sin });
                let [value, slope] = term.sin;
                strands.push(Strand { value, slope, turned: term.k * value, line: sin, other: cos });
            }
            strands.retain(|strand| strand.value != 0.0 || strand.slope != 0.0);
        }
    }

    /// The sums at block number `block`.
    pub(super) fn sums(&self, table: &ColumnTable, block: usize) -> Sums {
        let mut sums = Sums::default();
        for (axis, strands) in self.strands.iter().enumerate() {
            let (mut position, mut du, mut dv) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
            for strand in strands {
                let (Some(line), Some(other)) = (table.block(strand.line + block), table.block(strand.other + block))
                else {
                    continue;
                };
                for lane in 0..BLOCK {
                    position[lane] += strand.value * line[lane];
                    du[lane] += strand.slope * line[lane];
                    dv[lane] += strand.turned * other[lane];
                }
            }
            (sums.position[axis], sums.du[axis], sums.dv[axis]) = (position, du, dv);
        }
        sums
    }
}

impl Sums {
    /// `X`, `X_u`, `X_v` at one column of the block.
    pub(super) fn at(&self, lane: usize) -> (DVec3, DVec3, DVec3) {
        let at = |sums: &[Block; 3]| DVec3::new(sums[0][lane], sums[1][lane], sums[2][lane]);
        (at(&self.position), at(&self.du), at(&self.dv))
    }
}
