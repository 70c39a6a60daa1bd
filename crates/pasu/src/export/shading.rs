//! Normals for drawing: smooth within a face, sharp where two faces meet.

use glam::DVec3;

use super::contents::Body;
use crate::watch;

/// A body whose vertices are split where faces meet. Positions are those of the body, bit for bit.
pub(super) struct Shaded {
    /// `x, y, z` per vertex, millimetres.
    pub(super) positions: Vec<f32>,
    /// Unit vectors, three numbers per vertex.
    pub(super) normals: Vec<f32>,
    /// Three vertex numbers per triangle.
    pub(super) indices: Vec<u32>,
}

const NOT_YET: u32 = u32::MAX;

/// Splits and shades: the normal of a vertex is the mean of those of its triangles within the face, weighted by their angles there (Thürmer and Wüthrich, *Computing vertex
/// normals from polygonal facets*, 1998), which does not depend on how a face is cut into triangles.
pub(super) fn shaded(body: &Body) -> Shaded {
    let mut shaded = Shaded { positions: Vec::new(), normals: Vec::new(), indices: Vec::new() };
    let mut number_of = vec![NOT_YET; body.positions.len() / 3];
    let mut sums: Vec<DVec3> = Vec::new();
    for &(_, first, count) in &body.faces {
        let triangles = &body.indices[first..first + count];
        for vertex in triangles {
            number_of[*vertex as usize] = NOT_YET;
        }
        for corners in triangles.chunks_exact(3) {
            watch::work(20);
            let points = [corners[0], corners[1], corners[2]].map(|vertex| point(body, vertex));
            let normal = (points[1] - points[0]).cross(points[2] - points[0]).normalize_or_zero();
            for (corner, vertex) in corners.iter().enumerate() {
                let number = &mut number_of[*vertex as usize];
                if *number == NOT_YET {
                    *number = sums.len() as u32;
                    sums.push(DVec3::ZERO);
                    shaded.positions.extend(body.position(*vertex));
                }
                shaded.indices.push(*number);
                let (here, next, last) = (points[corner], points[(corner + 1) % 3], points[(corner + 2) % 3]);
                sums[*number as usize] += angle(next - here, last - here) * normal;
            }
        }
    }
    for sum in sums {
        // Where triangles cancel, as round a needle, any direction is as good; one along the axis is a unit vector.
        let normal = sum.try_normalize().unwrap_or(DVec3::Z).as_vec3();
        shaded.normals.extend(normal.to_array());
    }
    shaded
}

pub(super) fn point(body: &Body, vertex: u32) -> DVec3 {
    DVec3::from_array(body.position(vertex).map(f64::from))
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}
