//! What a mesh is, and how it is asked for.

/// The most vertices that a mesh may have.
pub const VERTEX_LIMIT: usize = 16_000_000;

/// Triangles of a whole design, in model units, after placement.
///
/// Every part is one grid of `rows x columns` vertices, row by row: row `i` is a curve of constant `u`, column `j` that of constant
/// `v_j = j span / (columns - 1)`. Where the number of rows is given, `u_i = i / (rows - 1)`; where it is chosen, rows are also placed, from 0 to 1, closer where the surface bends more along
/// `u`, and `uvs` tell where they are. The last column of a closed surface repeats the first, bit for bit in position and normal, so that `uvs` can run from 0 to 1.
///
/// A part that is a network of patches is such a grid for each of them, patch by patch; where rows and columns are given, each has its share of their product, as many rows as columns and at least 3. Patches have the same lines across a side that they share and the same bits along it, so that each has the lines of its neighbours besides its own.
///
/// - `positions`: `x, y, z` per vertex; with [`MeshOptions::tolerance`] the exact solution in `f64`, rounded once. Otherwise summed in `f32` where 2.5 standard deviations of what that rounds
///   are within 5e-7 of the largest coordinate, and in `f64` where many harmonics cancel. The deviation is that of all terms at their amplitudes at once, twice what it is at a vertex in the mean. This is an estimate
///   and no proof: no vertex is known that is off by more.
/// - `normals`: unit vectors, `X_u x X_v` normalised and turned to point out of the pot, off by no more than 1e-6 radians in the same sense; at a pole or a cusp the limit from the
///   inside of the surface. Where patches of a network meet at less than its crease angle they have the mean of both. Where `X_u` and `X_v` are too nearly parallel for `f32` a normal is formed in `f64`.
/// - `uvs`: `u`, `v / span` per vertex, both in [0, 1].
/// - `indices`: three per triangle, counter-clockwise seen from outside. Where a row shrinks to a point its triangles have no area.
/// - `groups`: triples (first index, number of indices, part).
///
/// Every number is finite.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Mesh {
    /// `x, y, z` per vertex.
    pub positions: Vec<f32>,
    /// Unit normals, three numbers per vertex.
    pub normals: Vec<f32>,
    /// `u`, `v / span` per vertex.
    pub uvs: Vec<f32>,
    /// Three vertex numbers per triangle.
    pub indices: Vec<u32>,
    /// (first index, number of indices, part) per part.
    pub groups: Vec<u32>,
    /// A name for the grids and their windings: meshes with equal names have equal `uvs`, `indices` and `groups`.
    pub topology: String,
    /// The largest distance between the triangles and the true surface, in model units, whichever of the two it is measured from; the rounding of the positions is in it.
    /// Known wherever rows or columns were chosen or a tolerance was asked for. `None` where both were given, and where it is beyond all numbers: finding it would take longer than the mesh, so
    /// [`bound`](crate::bound) does it on demand.
    pub bound: Option<f64>,
}

/// How finely to sample a design.
///
/// `rows` and `columns` count vertices (2 to 16 million, whose product over all parts is at most 16 million). What is not given
/// is chosen from `tolerance`, so that as few vertices as possible hold it; when that is not given either, from one two-thousandth of each part's size. Rows that are chosen are placed
/// where they are needed; rows that are given are even. Of a network of patches each has its share of `rows` times `columns`, see [`Mesh`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeshOptions {
    /// The largest distance between the triangles and the true surface, in model units; positive. It is a promise, from a bound on
    /// the second derivatives: where given rows or columns cannot hold it, the mesh is refused.
    pub tolerance: Option<f64>,
    /// Number of vertices along the profile.
    pub rows: Option<usize>,
    /// Number of vertices round the axis, the repeated one of a closed surface included.
    pub columns: Option<usize>,
}

impl Mesh {
    /// Empties every array and keeps its memory.
    pub(super) fn clear(&mut self) {
        self.positions.clear();
        self.normals.clear();
        self.uvs.clear();
        self.indices.clear();
        self.groups.clear();
        self.topology.clear();
        self.bound = None;
    }

    /// Number of vertices.
    ///
    /// ```
    /// use pasu::{Design, MeshOptions};
    ///
    /// let options = MeshOptions { rows: Some(5), columns: Some(9), ..MeshOptions::default() };
    /// let mesh = pasu::mesh(&Design::parse("#1/bloor-wilson")?, &options)?;
    /// assert_eq!(mesh.n_vertices(), 5 * 9);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn n_vertices(&self) -> usize {
        self.positions.len() / 3
    }

    /// Number of triangles.
    ///
    /// ```
    /// use pasu::{Design, MeshOptions};
    ///
    /// let options = MeshOptions { rows: Some(5), columns: Some(9), ..MeshOptions::default() };
    /// let mesh = pasu::mesh(&Design::parse("#1/bloor-wilson")?, &options)?;
    /// assert_eq!(mesh.n_triangles(), 2 * 4 * 8);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn n_triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// Checks the contract above; the message says what is broken. Used by tests and by whoever edits a mesh.
    ///
    /// # Errors
    /// The first violation found, in words.
    ///
    /// ```
    /// use pasu::{Design, MeshOptions};
    ///
    /// let mut mesh = pasu::mesh(&Design::parse("#1/bloor-wilson")?, &MeshOptions::default())?;
    /// assert_eq!(mesh.validate(), Ok(()));
    /// mesh.indices[0] = u32::MAX;
    /// assert!(mesh.validate().is_err());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn validate(&self) -> Result<(), String> {
        let n = self.n_vertices();
        if self.positions.len() != 3 * n || self.normals.len() != 3 * n || self.uvs.len() != 2 * n {
            return Err(format!(
                "arrays of {} positions, {} normals, {} uvs",
                self.positions.len(),
                self.normals.len(),
                self.uvs.len()
            ));
        }
        if let Some(i) = self.positions.iter().chain(&self.normals).chain(&self.uvs).position(|x| !x.is_finite()) {
            return Err(format!("number {i} is not finite"));
        }
        for (i, normal) in self.normals.chunks_exact(3).enumerate() {
            let length = normal.iter().map(|x| f64::from(*x) * f64::from(*x)).sum::<f64>();
            if (length - 1.0).abs() > 1e-6 {
                return Err(format!("normal {i} has squared length {length}"));
            }
        }
        if !self.indices.len().is_multiple_of(3) || self.indices.iter().any(|&i| i as usize >= n) {
            return Err("an index is out of range".to_owned());
        }
        let mut next = 0;
        for group in self.groups.chunks(3) {
            match *group {
                [first, count, _] if first == next && count % 3 == 0 => next += count,
                _ => return Err(format!("group {group:?} does not follow on from index {next}")),
            }
        }
        if next as usize == self.indices.len() { Ok(()) } else { Err("groups do not cover the indices".to_owned()) }
    }
}
