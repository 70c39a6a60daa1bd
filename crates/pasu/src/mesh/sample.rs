//! Sampling a design on grids.

use glam::{DMat3, DVec3};

use super::contract::{Mesh, MeshOptions};
use super::grid::append_triangles;
use super::normal;
use super::orientation::is_outward;
use super::tolerance::Bounds;
use crate::design::{Design, Part};
use crate::error::{Code, Error, Result};
use crate::surface::{ColumnTable, RowTable, Surface};

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
    let mut mesh = Mesh::default();
    for grid in &grids {
        grid.append_to(&mut mesh)?;
    }
    Ok(mesh)
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
                let bounds = Bounds::of(&surface, &ColumnTable::new(&surface, 2).distinct, matrix);
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
        // Normals go by the inverse transpose, whose size does not matter: the cofactors, with the sign of the determinant taken out.
        let cofactors = cofactors(self.matrix) * if mirrored { -1.0 } else { 1.0 } * if outward { 1.0 } else { -1.0 };
        let mut lines = RowLines::new(columns);
        mesh.positions.reserve(3 * rows * columns);
        mesh.normals.reserve(3 * rows * columns);
        mesh.uvs.reserve(2 * rows * columns);
        let mut reach = 0.0f64;
        for i in 0..rows {
            let u = i as f64 / (rows - 1) as f64;
            lines.fill(&RowTable::at(&self.surface, &table.distinct, u), &table);
            for j in 0..columns {
                let (position, du, dv) = lines.vertex(j);
                reach = reach.max(position.abs().max_element()).max(dv.abs().max_element());
                let placed = self.matrix * position + self.shift;
                let single = placed.as_vec3() + glam::Vec3::ZERO; // -0 becomes 0
                if !single.is_finite() {
                    let path = format!("parts[{}]", self.index);
                    let message = format!("the surface reaches {placed} at u = {u}, beyond what a mesh can hold");
                    return Err(Error::new(Code::Overflow, path, message));
                }
                let v = j as f64 / (columns - 1) as f64;
                let normal = match normal::regular(du, dv, reach) {
                    Some(normal) => normal,
                    // The seam's two columns share a limit, as they share their position.
                    None if j + 1 == columns && self.surface.is_closed() => normal::limit(&self.surface, u, 0.0, reach),
                    None => normal::limit(&self.surface, u, v * self.surface.span(), reach),
                };
                let normal = (cofactors * normal).try_normalize().unwrap_or(DVec3::Z).as_vec3() + glam::Vec3::ZERO;
                mesh.positions.extend_from_slice(&single.to_array());
                mesh.normals.extend_from_slice(&normal.to_array());
                mesh.uvs.extend_from_slice(&[u as f32, v as f32]);
            }
        }
        let first = mesh.indices.len() as u32;
        append_triangles(&mut mesh.indices, base, rows as u32, columns as u32, outward != mirrored);
        mesh.groups.extend_from_slice(&[first, mesh.indices.len() as u32 - first, self.index as u32]);
        Ok(())
    }
}

/// The matrix of cofactors, `det(m) m^-T` also where `m` is singular.
fn cofactors(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis))
}

/// Position and tangents along one row, a line of numbers each, so that a term adds to whole lines.
struct RowLines {
    position: [Vec<f64>; 3],
    du: [Vec<f64>; 3],
    dv: [Vec<f64>; 3],
}

impl RowLines {
    fn new(columns: usize) -> Self {
        let lines = || [(); 3].map(|()| vec![0.0; columns]);
        RowLines { position: lines(), du: lines(), dv: lines() }
    }

    fn fill(&mut self, row: &RowTable<2>, table: &ColumnTable) {
        for axis in 0..3 {
            let (position, du, dv) = (&mut self.position[axis], &mut self.du[axis], &mut self.dv[axis]);
            position.fill(0.0);
            du.fill(0.0);
            dv.fill(0.0);
            for term in &row.components[axis] {
                let (cos, sin) = (&table.cos[term.column], &table.sin[term.column]);
                for (value, slope, line, turned, sign) in
                    [(term.cos[0], term.cos[1], cos, sin, -1.0), (term.sin[0], term.sin[1], sin, cos, 1.0)]
                {
                    if value != 0.0 || slope != 0.0 {
                        add(position, value, line);
                        add(du, slope, line);
                        add(dv, sign * term.k * value, turned);
                    }
                }
            }
        }
    }

    fn vertex(&self, j: usize) -> (DVec3, DVec3, DVec3) {
        let at = |lines: &[Vec<f64>; 3]| DVec3::new(lines[0][j], lines[1][j], lines[2][j]);
        (at(&self.position), at(&self.du), at(&self.dv))
    }
}

/// `sum += factor * line`.
fn add(sum: &mut [f64], factor: f64, line: &[f64]) {
    for (sum, value) in sum.iter_mut().zip(line) {
        *sum += factor * value;
    }
}
