//! PLY, binary little-endian: one welded mesh.

use super::contents::{Body, Notes, PROGRAM};
use super::material::{Material, srgb};

/// All bodies in millimetres, one after the other, each vertex with the colour of its clay and glaze (sRGB), and each triangle too where a body has several; a property of each triangle says of which body it is, if there are several.
pub(super) fn write(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let n_vertices = bodies.iter().map(|body| body.positions.len() / 3).sum::<usize>();
    let n_triangles = bodies.iter().map(Body::n_triangles).sum::<usize>();
    let several = bodies.len() > 1;
    let by_faces = bodies.iter().any(|body| body.looks().len() > 1);
    let mut header = format!("ply\nformat binary_little_endian 1.0\ncomment {PROGRAM}, lengths in millimetres, z up\n");
    for line in notes.lines() {
        header.push_str(&format!("comment {line}\n"));
    }
    header.push_str(&format!("element vertex {n_vertices}\n"));
    for axis in ["x", "y", "z"] {
        header.push_str(&format!("property float {axis}\n"));
    }
    // The names by which programs know a colour; of vertices, because some do not ask triangles for theirs. No vertex belongs to two bodies.
    const COLOURS: &str = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    header.push_str(COLOURS);
    header.push_str(&format!("element face {n_triangles}\nproperty list uchar int vertex_indices\n"));
    if by_faces {
        header.push_str(COLOURS);
    }
    if several {
        header.push_str("property int body\n");
    }
    header.push_str("end_header\n");
    let mut bytes = header.into_bytes();
    bytes.reserve(15 * n_vertices + 17 * n_triangles);
    for body in bodies {
        let colours: Vec<[u8; 3]> = body.looks().into_iter().map(|look| Material::of(look).colour.map(srgb)).collect();
        let look_of = body.look_of();
        // Where looks meet, a vertex has that of the last of its triangles.
        let mut of_vertex = vec![0; body.positions.len() / 3];
        for (number, corners) in body.triangles().enumerate() {
            for vertex in corners {
                of_vertex[vertex as usize] = look_of(number);
            }
        }
        for (position, look) in body.positions.chunks_exact(3).zip(of_vertex) {
            for number in position {
                bytes.extend_from_slice(&number.to_le_bytes());
            }
            bytes.extend_from_slice(&colours[look]);
        }
    }
    let mut first_vertex = 0;
    for (index, body) in bodies.iter().enumerate() {
        let (looks, look_of) = (body.looks(), body.look_of());
        for (number, corners) in body.triangles().enumerate() {
            bytes.push(3);
            for vertex in corners {
                bytes.extend_from_slice(&(first_vertex + vertex).to_le_bytes());
            }
            if by_faces {
                bytes.extend_from_slice(&Material::of(looks[look_of(number)]).colour.map(srgb));
            }
            if several {
                bytes.extend_from_slice(&(index as u32).to_le_bytes());
            }
        }
        first_vertex += body.positions.len() as u32 / 3;
    }
    bytes
}
