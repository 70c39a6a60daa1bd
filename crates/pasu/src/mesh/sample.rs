//! Sampling a design on grids.

use core::fmt::Write;

use glam::{DMat3, DVec3};

use super::contract::{Mesh, MeshOptions};
use super::grid::append_triangles;
use super::normal::{self, Facing, write_single};
use super::orientation::is_outward;
use super::row::Row;
use super::tolerance::Bounds;
use crate::design::{Design, Part};
use crate::error::{Code, Error, Result};
use crate::surface::{BLOCK, Block, ColumnTable, RowTable, Surface, SurfaceJet, distinct};

/// The most vertices that a mesh may have.
pub const VERTEX_LIMIT: usize = 16_000_000;

/// Without rows, columns or tolerance a part is sampled to this fraction of its size.
const DEFAULT_FINENESS: f64 = 1.0 / 2000.0;

/// The mesh of every part of a design, placed, in one set of arrays.
///
/// # Errors
/// `too-large` beyond [`VERTEX_LIMIT`]; `tolerance-too-fine` where the tolerance cannot be promised (single precision positions, or rows and columns that are
/// given); `out-of-range` for options outside their range; what [`Surface::solve`] refuses; `overflow` for a point beyond single precision.
pub fn mesh(design: &Design, options: &MeshOptions) -> Result<Mesh> {
    let mut sampler = Sampler::new();
    sampler.sample(design, options)?;
    Ok(sampler.mesh)
}

/// Samples one design after the other into the same arrays: what a drag needs, where each mesh takes the place of the one before.
#[derive(Debug, Default)]
pub struct Sampler {
    mesh: Mesh,
}

impl Sampler {
    /// A sampler that holds nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// The mesh of a design, as [`mesh`] makes it. After an error the sampler is as good as a new one.
    ///
    /// # Errors
    /// As [`mesh`].
    pub fn sample(&mut self, design: &Design, options: &MeshOptions) -> Result<&Mesh> {
        let grids = choose(design, options)?;
        let mut mesh = core::mem::take(&mut self.mesh);
        mesh.clear();
        for grid in &grids {
            grid.append_to(&mut mesh)?;
        }
        self.mesh = mesh;
        Ok(&self.mesh)
    }
}

fn choose(design: &Design, options: &MeshOptions) -> Result<Vec<Grid>> {
    check(options)?;
    let mut grids = Vec::with_capacity(design.parts().len());
    let mut n_vertices = 0.0;
    for (index, part) in design.parts().iter().enumerate() {
        let grid = Grid::choose(part, index, options)?;
        n_vertices += grid.rows * grid.columns;
        if n_vertices > VERTEX_LIMIT as f64 {
            return Err(Error::new(
                Code::TooLarge,
                format!("parts[{index}]"),
                format!(
                    "needs {} rows of {} vertices, which takes the mesh beyond {VERTEX_LIMIT} vertices; ask for a coarser tolerance or fewer rows and columns",
                    grid.rows, grid.columns
                ),
            ));
        }
        grids.push(grid);
    }
    Ok(grids)
}

fn check(options: &MeshOptions) -> Result<()> {
    for (name, count, least) in [("rows", options.rows, 2), ("columns", options.columns, 4)] {
        if let Some(count) = count.filter(|count| !(least..=VERTEX_LIMIT).contains(count)) {
            let message = format!("expected a whole number from {least} to {VERTEX_LIMIT}, found {count}");
            return Err(Error::new(Code::OutOfRange, name, message));
        }
    }
    match options.tolerance {
        Some(tolerance) if !(tolerance > 0.0 && tolerance.is_finite()) => {
            let message = format!("expected a distance greater than 0 in model units, found {tolerance}");
            Err(Error::new(Code::OutOfRange, "tolerance", message))
        }
        _ => Ok(()),
    }
}

/// One part, ready to be sampled.
struct Grid {
    surface: Surface,
    index: usize,
    /// Whole, but perhaps too large for an integer until it has been held against the limit.
    rows: f64,
    columns: f64,
    matrix: DMat3,
    shift: DVec3,
}

impl Grid {
    fn choose(part: &Part, index: usize, options: &MeshOptions) -> Result<Grid> {
        let surface = Surface::of_part(part, index)?;
        let matrix = DMat3::from_cols_array_2d(&part.place.matrix()).transpose();
        let shift = DVec3::from_array(part.place.shift);
        let (along, round) = (options.rows.map(|n| n as f64 - 1.0), options.columns.map(|n| n as f64 - 1.0));
        let (along, round) = match (along, round, options.tolerance) {
            (Some(along), Some(round), None) => (along, round),
            _ => {
                let bounds = Bounds::of(&surface, &distinct(&surface), matrix);
                // Half a unit in the last place of the largest coordinate, in each of three directions.
                let rounding = (bounds.position + shift.length()) * f64::from(f32::EPSILON);
                match options.tolerance {
                    None => bounds.cells(bounds.position * DEFAULT_FINENESS, along, round),
                    Some(tolerance) => {
                        let (n, m) = bounds.cells(tolerance - rounding, along, round);
                        if !(bounds.deviation(1.0 / n, 1.0 / m) + rounding <= tolerance * (1.0 + 1e-12)) {
                            let message = if 2.0 * rounding > tolerance {
                                format!(
                                    "a mesh in single precision is only good to {rounding:e} for a pot of this size, found {tolerance}"
                                )
                            } else {
                                format!(
                                    "{} rows of {} vertices cannot hold {tolerance}; leave out rows and columns, or ask for more",
                                    n + 1.0,
                                    m + 1.0
                                )
                            };
                            return Err(Error::new(Code::ToleranceTooFine, "tolerance", message));
                        }
                        (n, m)
                    }
                }
            }
        };
        Ok(Grid { surface, index, rows: along + 1.0, columns: round + 1.0, matrix, shift })
    }

    fn append_to(&self, mesh: &mut Mesh) -> Result<()> {
        let (rows, columns) = (self.rows as usize, self.columns as usize);
        let table = ColumnTable::new(&self.surface, columns);
        let base = mesh.n_vertices() as u32;
        let mirrored = self.matrix.determinant() < 0.0;
        let outward = is_outward(&self.surface);
        let is_placed = self.matrix != DMat3::IDENTITY || self.shift != DVec3::ZERO;
        // Normals go by the inverse transpose, whose size does not matter: the cofactors, with the sign of the determinant taken out.
        let cofactors = cofactors(self.matrix) * if mirrored { -1.0 } else { 1.0 };
        let outward_sign = if outward { 1.0 } else { -1.0 };
        let mut row = Row::default();
        let (first_position, first_uv) = (mesh.positions.len(), mesh.uvs.len());
        mesh.positions.resize(first_position + 3 * rows * columns, 0.0);
        mesh.normals.resize(first_position + 3 * rows * columns, 0.0);
        mesh.uvs.resize(first_uv + 2 * rows * columns, 0.0);
        let mut positions = mesh.positions[first_position..].as_chunks_mut::<3>().0.chunks_exact_mut(columns);
        let mut normals = mesh.normals[first_position..].as_chunks_mut::<3>().0.chunks_exact_mut(columns);
        let mut uvs = mesh.uvs[first_uv..].as_chunks_mut::<2>().0.chunks_exact_mut(columns);
        let across: Vec<f32> = (0..columns).map(|j| (j as f64 / (columns - 1) as f64) as f32).collect();
        for i in 0..rows {
            let u = i as f64 / (rows - 1) as f64;
            let (Some(positions), Some(normals), Some(uvs)) = (positions.next(), normals.next(), uvs.next()) else {
                break;
            };
            row.fill(&RowTable::at(&self.surface, &table.distinct, u));
            // Made only for rows with a pole or cusp, where the normal's limit needs second derivatives.
            let mut second = None;
            let blocks = positions.chunks_mut(BLOCK).zip(normals.chunks_mut(BLOCK));
            for (block, (positions, normals)) in blocks.enumerate() {
                let mut sums = row.sums(table.block(block));
                let (mut facing, missing) = Facing::of(&sums);
                if missing != 0 {
                    let second = second.get_or_insert_with(|| RowTable::at(&self.surface, &table.distinct, u));
                    for lane in (0..BLOCK).filter(|lane| missing >> lane & 1 == 1) {
                        let jet = second.jet(|n| table.circle(n, block, lane));
                        facing.set(lane, self.limit(u, (block * BLOCK + lane).min(columns - 1), columns, &jet));
                    }
                }
                if is_placed {
                    self.place(&mut sums.position);
                    facing.turn(cofactors);
                }
                facing.write(outward_sign, normals);
                write_single(sums.position, positions);
            }
            if let Some(j) = positions.iter().position(|position| !position.iter().all(|x| x.is_finite())) {
                let path = format!("parts[{}]", self.index);
                let message = format!(
                    "the surface runs beyond what a mesh can hold at row {i}, column {j}; numbers up to 3e38 can be held"
                );
                return Err(Error::new(Code::Overflow, path, message));
            }
            for (uv, &across) in uvs.iter_mut().zip(&across) {
                *uv = [u as f32, across];
            }
        }
        let first = mesh.indices.len() as u32;
        append_triangles(&mut mesh.indices, base, rows as u32, columns as u32, outward != mirrored);
        mesh.groups.extend_from_slice(&[first, mesh.indices.len() as u32 - first, self.index as u32]);
        let winding = if outward != mirrored { '+' } else { '-' };
        // A String takes whatever is written to it.
        let _ = write!(mesh.topology, "{rows}x{columns}{winding}");
        Ok(())
    }
}

impl Grid {
    /// Scales, turns and moves the positions of a block.
    fn place(&self, positions: &mut [Block; 3]) {
        let [x, y, z] = *positions;
        let (m, shift) = (self.matrix, self.shift);
        let component = |i: usize| x * m.x_axis[i] + y * m.y_axis[i] + z * m.z_axis[i] + Block::splat(shift[i]);
        *positions = [component(0), component(1), component(2)];
    }

    /// The limit of the normal where the surface has none, along `X_u x X_v`. The seam's two columns share it, as they share their position.
    fn limit(&self, u: f64, column: usize, columns: usize, jet: &SurfaceJet) -> DVec3 {
        let v =
            if column + 1 == columns && self.surface.is_closed() { 0.0 } else { column as f64 / (columns - 1) as f64 };
        normal::limit(&self.surface, u, v * self.surface.span(), jet)
    }
}

/// The matrix of cofactors, `det(m) m^-T` also where `m` is singular.
fn cofactors(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis))
}
