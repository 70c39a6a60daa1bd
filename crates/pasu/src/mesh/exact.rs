//! Rows, or single normals, in double precision.

use glam::{DMat3, DVec3};

use super::normal::{Facing, cofactors, write_single};
use super::part::PartGrid;
use crate::error::{Code, Error, Result};
use crate::patch::normal_limit;
use crate::surface::{BLOCK, Block, ColumnTable, Row, RowTable, Sums};

/// No column of a block.
const NONE: [bool; BLOCK] = [false; BLOCK];

/// Where so many vertices have no normal the surface is a curve or a point all over, and limits are no longer looked for: each costs as much as twelve vertices.
const MOST_WITHOUT: usize = 256;

/// Rows of one part with every sum in double precision, rounded once; poles and cusps have their limits. Tables are made when first needed.
pub(super) struct ExactRows<'a> {
    grid: &'a PartGrid<'a>,
    n_columns: usize,
    table: Option<ColumnTable>,
    coefficients: RowTable<2>,
    row: Row,
    u: f64,
    /// By blocks, the columns at which single normals are formed.
    wanted: Vec<[bool; BLOCK]>,
    /// Made only for rows with a pole or cusp, where the normal's limit needs second derivatives.
    second: Option<RowTable<3>>,
    /// How many vertices were met that have no normal, nor a limit of one.
    n_without: usize,
    /// The matrix for normals, which go by the inverse transpose, whose size does not matter: the cofactors, turned outward.
    outward: DMat3,
}

impl<'a> ExactRows<'a> {
    pub(super) fn new(grid: &'a PartGrid<'a>, n_columns: usize) -> Self {
        // The cofactors of a mirror image hold the sign of its determinant, as the product of the placed tangents does.
        let outward = cofactors(grid.matrix) * grid.sign();
        let (coefficients, row) = (RowTable::default(), Row::default());
        let wanted = Vec::new();
        ExactRows {
            grid,
            n_columns,
            table: None,
            coefficients,
            row,
            u: 0.0,
            wanted,
            second: None,
            n_without: 0,
            outward,
        }
    }

    /// Fills a row of the grid.
    ///
    /// # Errors
    /// `overflow` for a point beyond single precision.
    pub(super) fn fill(&mut self, row: usize, positions: &mut [f32], normals: &mut [f32]) -> Result<()> {
        self.take(row);
        self.write(positions, normals);
        self.check(row, positions)
    }

    fn write(&mut self, positions: &mut [f32], normals: &mut [f32]) {
        let positions = positions.as_chunks_mut::<3>().0.chunks_mut(BLOCK);
        let normals = normals.as_chunks_mut::<3>().0.chunks_mut(BLOCK);
        for (block, (positions, normals)) in positions.zip(normals).enumerate() {
            let Sums { position, du, dv } = self.row.sums(circles(self.table.as_ref(), block));
            self.facing(block, [du, dv]).write(normals);
            write_single(self.placed(position), positions);
        }
    }

    fn check(&self, row: usize, positions: &[f32]) -> Result<()> {
        match positions.iter().position(|x| !x.is_finite()) {
            None => Ok(()),
            Some(index) => {
                let path = format!("parts[{}]", self.grid.index);
                let message = format!(
                    "the surface runs beyond what a mesh can hold at row {row}, column {}; numbers up to 3e38 can be held",
                    index / 3
                );
                Err(Error::new(Code::Overflow, path, message))
            }
        }
    }

    /// Fills the normals at some columns of a row of the grid.
    pub(super) fn normals(&mut self, row: usize, columns: &[usize], normals: &mut [f32]) {
        self.take(row);
        let mut wanted = core::mem::take(&mut self.wanted);
        wanted.clear();
        wanted.resize(self.n_columns.div_ceil(BLOCK), NONE);
        for column in columns {
            if let Some(block) = wanted.get_mut(column / BLOCK) {
                block[column % BLOCK] = true;
            }
        }
        let normals = normals.as_chunks_mut::<3>().0.chunks_mut(BLOCK);
        for (block, (normals, wanted)) in normals.zip(&wanted).enumerate().filter(|(_, (_, wanted))| **wanted != NONE) {
            let tangents = self.row.tangents(circles(self.table.as_ref(), block));
            self.facing(block, tangents).write_some(wanted, normals);
        }
        self.wanted = wanted;
    }

    fn take(&mut self, row: usize) {
        let u = self.grid.tessellation.row(row);
        self.table.get_or_insert_with(|| ColumnTable::new(self.grid.surface, self.n_columns));
        self.coefficients.take(self.grid.surface.components(), u);
        self.row.fill(&self.coefficients);
        self.u = u;
        self.second = None;
    }

    /// Normals at one block of columns, where `X_u` and `X_v` are these.
    fn facing(&mut self, block: usize, tangents: [[Block; 3]; 2]) -> Facing {
        let (mut facing, missing) = Facing::of(tangents, self.row.terms());
        if missing != 0 {
            let surface = self.grid.surface;
            let table = self.table.get_or_insert_with(|| ColumnTable::new(surface, self.n_columns));
            let second = self.second.get_or_insert_with(|| RowTable::at(surface.components(), self.u));
            for lane in (0..BLOCK).filter(|lane| missing >> lane & 1 == 1) {
                let jet = second.jet(|n| table.circle(n, block, lane));
                // The seam's two columns share the limit, as they share their position.
                let last = self.n_columns - 1;
                let column = (block * BLOCK + lane).min(last);
                let v = if column == last && surface.is_closed() { 0.0 } else { column as f64 / last as f64 };
                let limit = if self.n_without < MOST_WITHOUT {
                    normal_limit(&jet, (self.u, v), |u, v| surface.at(u, v * surface.span()))
                } else {
                    None
                };
                self.n_without += usize::from(limit.is_none());
                // Where there is none, the axis is as good as any.
                facing.set(lane, limit.unwrap_or(DVec3::Z));
            }
        }
        if self.outward != DMat3::IDENTITY {
            facing.turn(self.outward);
        }
        facing
    }

    /// Scales, turns and moves the positions of a block.
    fn placed(&self, positions: [Block; 3]) -> [Block; 3] {
        let (m, shift) = (self.grid.matrix, self.grid.shift);
        if m == DMat3::IDENTITY && shift == DVec3::ZERO {
            return positions;
        }
        let [x, y, z] = positions;
        let component = |i: usize| x * m.x_axis[i] + y * m.y_axis[i] + z * m.z_axis[i] + Block::splat(shift[i]);
        [component(0), component(1), component(2)]
    }
}

/// Cosine and sine of each distinct `n` at one block of columns, of a table that was made when its row was taken.
fn circles(table: Option<&ColumnTable>, block: usize) -> &[[Block; 2]] {
    table.map(|table| table.block(block)).unwrap_or_default()
}
