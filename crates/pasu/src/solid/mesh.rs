//! The closed mesh of a pot or solid: the very triangles that files hold.

use super::face::FaceKind;

/// The boundary of one part as triangles: closed, oriented, welded.
///
/// - One vertex per point; every edge is shared by exactly two triangles, which pass it in opposite directions; the triangles at each vertex are one fan.
/// - Triangles are counter-clockwise seen from outside the clay.
/// - No triangle is without area and no two cross, on the coordinates as they are: single precision, rounded once.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidMesh {
    /// `x, y, z` per vertex, in millimetres, after size and shrinkage.
    pub positions: Vec<f32>,
    /// Three vertex numbers per triangle.
    pub indices: Vec<u32>,
    /// (kind, first index, number of indices), in the order of `indices`, which they cover.
    pub faces: Vec<(FaceKind, u32, u32)>,
    /// The part of the design.
    pub part: usize,
    /// The largest distance between triangles and true faces, in model units: before size, shrinkage and millimetres.
    pub bound: f64,
}

impl SolidMesh {
    /// Number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.positions.len() / 3
    }

    /// Number of triangles.
    pub fn n_triangles(&self) -> usize {
        self.indices.len() / 3
    }
}
