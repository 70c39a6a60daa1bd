//! The closed mesh of a pot or solid: the very triangles that files hold.

use crate::face::FaceKind;

/// The boundary of one part as triangles: closed, oriented, welded.
///
/// - One vertex per point; every edge is shared by exactly two triangles, which pass it in opposite directions; the triangles at each vertex are one fan.
/// - Triangles are counter-clockwise seen from outside the clay.
/// - No triangle is without area and no two cross, on the coordinates as they are: single precision, rounded once.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct SolidMesh {
    /// `x, y, z` per vertex, in millimetres, after size and shrinkage.
    pub positions: Vec<f32>,
    /// Three vertex numbers per triangle.
    pub indices: Vec<u32>,
    /// (kind, first index, number of indices), in the order of `indices`, which they cover.
    pub faces: Vec<(FaceKind, u32, u32)>,
    /// The part of the design.
    pub part: usize,
    /// The largest distance between triangles and true faces, in model units: before size, shrinkage and millimetres. Of the surface of the design it is a bound. Of the other side of the wall, the rim and the
    /// base it is an estimate on the safe side, by how the faces bend at the vertices. Where it is more than the tolerance that was asked for, that could not be kept; [`check`](crate::check()) says so.
    pub bound: f64,
}

impl SolidMesh {
    /// Number of vertices.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let pots = pasu::solid(&cup, &pasu::Making::default())?;
    /// assert_eq!(3 * pots[0].n_vertices(), pots[0].positions.len());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn n_vertices(&self) -> usize {
        self.positions.len() / 3
    }

    /// Number of triangles.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let pots = pasu::solid(&cup, &pasu::Making::default())?;
    /// // A cup has no handle: V - E + F = 2, and E = 3 F / 2.
    /// assert_eq!(2 * pots[0].n_vertices() - pots[0].n_triangles(), 4);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn n_triangles(&self) -> usize {
        self.indices.len() / 3
    }
}
