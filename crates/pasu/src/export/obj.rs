//! Wavefront OBJ: text, one object per part.

use super::contents::{Body, Notes, PROGRAM};
use super::numbers::{push_decimal, push_f32};

/// The bodies in millimetres, `z` up. Faces are smoothing groups, so that programs shade them smooth and the edges between them sharp without vertices being split.
pub(super) fn write(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let mut bytes = format!("# {PROGRAM}, lengths in millimetres, z up\n").into_bytes();
    for line in notes.lines() {
        bytes.extend_from_slice(format!("# {line}\n").as_bytes());
    }
    // Vertices are counted from 1 through the whole file.
    let mut first_vertex = 1;
    for body in bodies {
        bytes.extend_from_slice(format!("o {}\n", identifier(&body.name)).as_bytes());
        for position in body.positions.chunks_exact(3) {
            bytes.push(b'v');
            for number in position {
                bytes.push(b' ');
                push_f32(&mut bytes, *number);
            }
            bytes.push(b'\n');
        }
        for (group, (_, first, count)) in body.faces.iter().enumerate() {
            bytes.extend_from_slice(format!("s {}\n", group + 1).as_bytes());
            for corners in body.indices[*first..first + count].chunks_exact(3) {
                bytes.push(b'f');
                for vertex in corners {
                    bytes.push(b' ');
                    push_decimal(&mut bytes, first_vertex + u64::from(*vertex), 0);
                }
                bytes.push(b'\n');
            }
        }
        first_vertex += body.positions.len() as u64 / 3;
    }
    bytes
}

/// One word: readers end a name at white space of any kind.
fn identifier(name: &str) -> String {
    name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect()
}
