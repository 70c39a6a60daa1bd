//! Sampling a design on grids.

use core::fmt::Write;

use glam::{DMat3, DVec3};

use super::contract::{Mesh, MeshOptions};
use super::grid::append_triangles;
use super::normal::{self, Facing, write_single};
use super::orientation::is_outward;
use super::profile::Profile;
use super::row::Row;
use super::tolerance::Tessellation;
use crate::design::{Design, Part};
use crate::error::{Code, Error, Result};
use crate::surface::{BLOCK, Block, ColumnTable, RowTable, Surface, SurfaceJet};

/// The most vertices that a mesh may have.
pub const VERTEX_LIMIT: usize = 16_000_000;

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
        let grids = choose(design, options, false)?;
        let mut mesh = core::mem::take(&mut self.mesh);
        mesh.clear();
        mesh.bound = largest_bound(&grids);
        for grid in &grids {
            grid.append_to(&mut mesh)?;
        }
        self.mesh = mesh;
        Ok(&self.mesh)
    }
}

/// The bound that [`mesh`] with the same options keeps: the largest distance between its triangles and the true surface, in model units.
///
/// It is [`Mesh::bound`] wherever that is known, and is found also for rows and columns that are both given, at the cost of some hundred rows of vertices.
///
/// # Errors
/// As [`mesh`], but for `overflow`, which only sampling finds.
pub fn bound(design: &Design, options: &MeshOptions) -> Result<f64> {
    Ok(largest_bound(&choose(design, options, true)?).unwrap_or(0.0))
}

/// The largest bound of all parts, if every part has one.
fn largest_bound(grids: &[Grid]) -> Option<f64> {
    grids.iter().try_fold(0.0f64, |largest, grid| grid.tessellation.bound.map(|bound| largest.max(bound)))
}

fn choose(design: &Design, options: &MeshOptions, is_bounded: bool) -> Result<Vec<Grid>> {
    check(options)?;
    let mut grids = Vec::with_capacity(design.parts().len());
    let mut n_vertices = 0.0;
    for (index, part) in design.parts().iter().enumerate() {
        let grid = Grid::choose(part, index, options, is_bounded)?;
        let (rows, columns) = (grid.tessellation.along + 1.0, grid.tessellation.round + 1.0);
        n_vertices += rows * columns;
        if n_vertices > VERTEX_LIMIT as f64 {
            return Err(Error::new(
                Code::TooLarge,
                format!("parts[{index}]"),
                format!(
                    "needs {rows} rows of {columns} vertices, which takes the mesh beyond {VERTEX_LIMIT} vertices; ask for a coarser tolerance or fewer rows and columns"
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
    tessellation: Tessellation,
    matrix: DMat3,
    shift: DVec3,
}

impl Grid {
    fn choose(part: &Part, index: usize, options: &MeshOptions, is_bounded: bool) -> Result<Grid> {
        let surface = Surface::of_part(part, index)?;
        let matrix = DMat3::from_cols_array_2d(&part.place.matrix()).transpose();
        let shift = DVec3::from_array(part.place.shift);
        let tessellation = Tessellation::choose(|| Profile::of(&surface, matrix), shift.length(), options, is_bounded)?;
        Ok(Grid { surface, index, tessellation, matrix, shift })
    }

    fn append_to(&self, mesh: &mut Mesh) -> Result<()> {
        let (rows, columns) = self.tessellation.counts();
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
            let u = self.tessellation.row(i);
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
        if let Some(hash) = self.tessellation.hash() {
            let _ = write!(mesh.topology, "{hash:016x}");
        }
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
