//! STL, binary: what every slicer reads, and nothing but triangles.

use super::contents::{Body, Notes, PROGRAM};
use super::provenance;
use super::shading::point;

/// Bytes before the number of triangles.
pub(super) const HEADER: usize = 80;
/// Bytes of a triangle.
pub(super) const TRIANGLE: usize = 50;

/// The triangles of all bodies with their normals, in millimetres.
///
/// There is room for a note of 80 bytes and for no other: readers (trimesh, three.js, assimp) tell a binary file by its length being 84 + 50 n to the byte, and the two
/// spare bytes of a triangle are taken for a colour by some (MeshLab) and for the length of what follows by the letter of the format. So link and making are in the header if they
/// are short enough, and nowhere else if they are not. The header does not begin with `solid`, which would announce text.
pub(super) fn write(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let n_triangles = bodies.iter().map(Body::n_triangles).sum::<usize>();
    let mut bytes = header(notes);
    bytes.reserve(4 + TRIANGLE * n_triangles);
    bytes.extend_from_slice(&(n_triangles as u32).to_le_bytes());
    for body in bodies {
        for corners in body.triangles() {
            let [a, b, c] = corners.map(|vertex| point(body, vertex));
            let normal = (b - a).cross(c - a).normalize_or_zero().as_vec3();
            for number in normal.to_array().into_iter().chain(corners.into_iter().flat_map(|v| body.position(v))) {
                bytes.extend_from_slice(&number.to_le_bytes());
            }
            bytes.extend_from_slice(&[0; 2]);
        }
    }
    bytes
}

/// Before the link in the header, as in its address.
const LINK: &str = " #";

/// `Pasu 0.1.0 0123456789abcdef passed pot shrinkage=12 #1/bloor-wilson?a=6`, as much of it as fits; of the link and of the making all or nothing, and the link before the making.
fn header(notes: &Notes) -> Vec<u8> {
    let mut text = format!("{PROGRAM} {}", notes.fingerprint);
    let verdict = notes.verdict.split([':', ',', ';']).next().unwrap_or_default();
    let (making, link) = (format!(" {}", provenance::line(&notes.making)), format!("{LINK}{}", notes.link));
    let room = HEADER.saturating_sub(text.len() + 1 + verdict.len());
    let both = making.clone() + &link;
    text.push_str(&format!(" {verdict}"));
    if let Some(more) = [both, link, making].into_iter().find(|more| more.len() <= room) {
        text.push_str(&more);
    }
    text.truncate(HEADER);
    let mut bytes = text.into_bytes();
    bytes.resize(HEADER, 0);
    bytes
}

/// What the header of an STL file of ours tells of a name.
pub(super) fn note(header: &str, name: &str) -> Option<String> {
    let (before, link) = header.split_once(LINK).map_or((header, None), |(before, link)| (before, Some(link)));
    if name == "link" { link.map(str::to_owned) } else { provenance::of_line(before, name) }
}

/// The text in the header of an STL file of ours.
pub(super) fn text(bytes: &[u8]) -> Option<&str> {
    let count = u32::from_le_bytes(bytes.get(HEADER..HEADER + 4)?.try_into().ok()?);
    if bytes.len() as u64 != (HEADER + 4) as u64 + TRIANGLE as u64 * u64::from(count) {
        return None;
    }
    let text = std::str::from_utf8(&bytes[..HEADER]).ok()?.trim_end_matches('\0');
    text.starts_with("Pasu ").then_some(text)
}
