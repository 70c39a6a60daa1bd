//! All rows of a part.

use super::circles::{Circles, folds};
use super::copies::Copies;
use super::double::DoubleNormals;
use super::extent::Extent;
use super::strands::Strands;
use super::waves::{ROWS, Waves};
use crate::error::Result;
use crate::mesh::exact::ExactRows;
use crate::mesh::part::PartGrid;
use crate::surface::Turns;

/// Fills parts in single precision. What it needs besides the mesh is kept from one to the next.
#[derive(Debug, Default)]
pub(crate) struct Kernel {
    waves: Waves,
    strands: Strands,
    turns: Turns,
    circles: Circles,
    copies: Copies,
    /// The columns of a row whose normals single precision does not hold.
    unsure: Vec<usize>,
    double: DoubleNormals,
}

impl Kernel {
    /// Fills positions and normals of a part; rows and normals that single precision does not hold are those of `exact`.
    ///
    /// # Errors
    /// `overflow` for a point beyond single precision.
    pub(crate) fn fill(
        &mut self,
        grid: &PartGrid,
        exact: &mut ExactRows,
        positions: &mut [f32],
        normals: &mut [f32],
    ) -> Result<()> {
        let Kernel { waves, strands, turns, circles, copies, unsure, double } = self;
        let PartGrid { surface, curves, tessellation, .. } = grid;
        let (rows, columns) = tessellation.counts();
        let sign = grid.sign();
        turns.divide(columns - 1);
        waves.prepare(curves, grid.matrix, grid.shift);
        strands.prepare(waves, folds(surface.is_closed(), columns));
        let extent = Extent::of(grid, waves, &mut copies.original);
        circles.prepare(&waves.harmonics, surface.is_closed(), turns, columns);
        copies.prepare(waves, turns, columns);
        double.prepare();
        for first in (0..rows).step_by(ROWS) {
            waves.take(surface, curves, core::array::from_fn(|row| tessellation.row((first + row).min(rows - 1))));
            let mut is_rounded = false;
            for (row, index) in (first..rows).take(ROWS).enumerate() {
                if copies.take(waves, turns, (index, row), columns, extent.largest, sign) {
                    continue;
                }
                let range = 3 * columns * index..3 * columns * (index + 1);
                let (Some(positions), Some(normals)) = (positions.get_mut(range.clone()), normals.get_mut(range))
                else {
                    continue;
                };
                if !is_rounded {
                    strands.round(waves, &extent);
                    is_rounded = true;
                }
                if strands.is_exact[row] {
                    exact.fill(index, positions, normals)?;
                    continue;
                }
                unsure.clear();
                circles.row(strands, row, sign as f32, positions, normals, unsure);
                if !unsure.is_empty() {
                    double.take(waves, turns, columns, extent.scales, row, sign);
                    unsure.retain(|column| !double.put(*column, normals));
                }
                if !unsure.is_empty() {
                    exact.normals(index, unsure, normals);
                }
            }
            copies.write(first + ROWS >= rows, columns, positions, normals);
        }
        Ok(())
    }
}
