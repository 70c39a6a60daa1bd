//! One row of a grid: the sum of outer products, a block of columns at a time.
//!
//! This is where a mesh's time goes. A vertex costs three multiplications and additions per datum that is not 0, a square root and a division; tables and
//! coefficients are made once per column and row.

use super::curves::Curves;
use super::row_table::{RowTable, RowTerm};
use super::solve::Surface;
use super::table::Block;

/// One datum of one mode at one row: adds `value cos(k v)` to the position, `slope cos(k v)` to `X_u` and `turned sin(k v)` to `X_v`; a datum of
/// `sin(k v)` has the two exchanged.
#[derive(Debug, Clone, Copy)]
struct Strand {
    value: f64,
    slope: f64,
    turned: f64,
    /// Index of the distinct `n`.
    column: usize,
}

/// Position and tangents at the columns of one block, component by component.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    pub(crate) position: [Block; 3],
    pub(crate) du: [Block; 3],
    pub(crate) dv: [Block; 3],
}

/// The strands of one row, kept to be filled again: for each component those of `cos` and those of `sin`.
#[derive(Debug, Default)]
pub(crate) struct Row {
    strands: [[Vec<Strand>; 2]; 3],
    /// The squared lengths that `X_u` and `X_v` would have if nothing cancelled.
    terms: [f64; 2],
}

impl Row {
    /// Takes the coefficients of a row.
    pub(crate) fn fill(&mut self, row: &RowTable<2>) {
        for ([cosines, sines], terms) in self.strands.iter_mut().zip(&row.components) {
            cosines.clear();
            sines.clear();
            for &RowTerm { column, k, cos, sin } in terms {
                if cos != [0.0; 2] {
                    cosines.push(Strand { value: cos[0], slope: cos[1], turned: -k * cos[0], column });
                }
                if sin != [0.0; 2] {
                    sines.push(Strand { value: sin[0], slope: sin[1], turned: k * sin[0], column });
                }
            }
        }
        self.measure();
    }

    /// Takes the coefficients of a row to the digits that [`Curves`] promise.
    pub(crate) fn fill_roughly(&mut self, surface: &Surface, curves: &Curves, distinct: &[f64], u: f64) {
        for strands in self.strands.as_flattened_mut() {
            strands.clear();
        }
        let list = curves.list();
        curves.row(surface, u, &mut |index, [value, slope]| {
            let Some(curve) = list.get(index) else { return };
            let column = distinct.iter().position(|n| *n == curve.n).unwrap_or(0);
            let k = if curve.is_sine { curve.k } else { -curve.k };
            self.strands[curve.axis][usize::from(curve.is_sine)].push(Strand {
                value,
                slope,
                turned: k * value,
                column,
            });
        });
        self.measure();
    }

    fn measure(&mut self) {
        self.terms = [0.0; 2];
        for strands in &self.strands {
            let sizes = strands.iter().flatten().fold([0.0; 2], |[u, v], s| [u + s.slope.abs(), v + s.turned.abs()]);
            for (terms, size) in self.terms.iter_mut().zip(sizes) {
                *terms += size * size;
            }
        }
    }

    /// The squared lengths that `X_u` and `X_v` would have if nothing cancelled.
    pub(crate) fn terms(&self) -> [f64; 2] {
        self.terms
    }

    /// The sums at one block of the columns of the same surface: all three in one run, because each circle is then read once.
    pub(crate) fn sums(&self, circles: &[[Block; 2]]) -> Sums {
        let mut sums = Sums::default();
        for (axis, [cosines, sines]) in self.strands.iter().enumerate() {
            let (mut position, mut du, mut dv) = (Block::ZERO, Block::ZERO, Block::ZERO);
            for strand in cosines {
                let Some([cos, sin]) = circles.get(strand.column) else { continue };
                position += *cos * strand.value;
                du += *cos * strand.slope;
                dv += *sin * strand.turned;
            }
            for strand in sines {
                let Some([cos, sin]) = circles.get(strand.column) else { continue };
                position += *sin * strand.value;
                du += *sin * strand.slope;
                dv += *cos * strand.turned;
            }
            (sums.position[axis], sums.du[axis], sums.dv[axis]) = (position, du, dv);
        }
        sums
    }

    /// Of these, `X_u` and `X_v` alone.
    pub(crate) fn tangents(&self, circles: &[[Block; 2]]) -> [[Block; 3]; 2] {
        let mut tangents = [[Block::ZERO; 3]; 2];
        for (axis, [cosines, sines]) in self.strands.iter().enumerate() {
            let (mut du, mut dv) = (Block::ZERO, Block::ZERO);
            for strand in cosines {
                let Some([cos, sin]) = circles.get(strand.column) else { continue };
                du += *cos * strand.slope;
                dv += *sin * strand.turned;
            }
            for strand in sines {
                let Some([cos, sin]) = circles.get(strand.column) else { continue };
                du += *sin * strand.slope;
                dv += *cos * strand.turned;
            }
            (tangents[0][axis], tangents[1][axis]) = (du, dv);
        }
        tangents
    }
}
