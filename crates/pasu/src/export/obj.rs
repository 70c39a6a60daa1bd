//! Wavefront OBJ: text, one object per part, and the file of materials beside it.

use super::contents::{Body, Notes, PROGRAM};
use super::material::{self, Material, srgb};
use super::numbers::{push_decimal, push_f32};
use super::zip::Package;
use crate::design::{Choice, Clay, Glaze, Look, plain};
use crate::watch;

/// The name under which the file of materials is looked for, in the folder of the OBJ.
const LIBRARY: &str = "pasu.mtl";

/// How a file of ours begins.
pub(super) const START: &[u8] = b"# Pasu ";

/// The bodies in millimetres, `z` up. Faces are smoothing groups, so that programs shade them smooth and the edges between them sharp without vertices being split. Every object names
/// its material; a reader that does not find [`materials`] shows it in a colour of its own.
pub(super) fn write(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let mut bytes = format!("# {PROGRAM}, lengths in millimetres, z up\n").into_bytes();
    for line in notes.lines() {
        bytes.extend_from_slice(format!("# {line}\n").as_bytes());
    }
    bytes.extend_from_slice(format!("mtllib {LIBRARY}\n").as_bytes());
    // Vertices are counted from 1 through the whole file.
    let mut first_vertex = 1;
    for body in bodies {
        bytes.extend_from_slice(format!("o {}\n", identifier(&body.name)).as_bytes());
        for position in body.positions.chunks_exact(3) {
            watch::work(10);
            bytes.push(b'v');
            for number in position {
                bytes.push(b' ');
                push_f32(&mut bytes, *number);
            }
            bytes.push(b'\n');
        }
        let (looks, look_of) = (body.looks(), body.look_of());
        let mut used = None;
        for (group, (_, first, count)) in body.faces.iter().enumerate() {
            let triangles = body.indices[*first..first + count].chunks_exact(3);
            for (number, corners) in (first / 3..).zip(triangles) {
                watch::work(10);
                if used != Some(look_of(number)) {
                    used = Some(look_of(number));
                    let name = identifier(&material::name(looks[look_of(number)]));
                    bytes.extend_from_slice(format!("usemtl {name}\n").as_bytes());
                }
                if 3 * number == *first {
                    bytes.extend_from_slice(format!("s {}\n", group + 1).as_bytes());
                }
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

/// The entry of such a package that holds the bodies.
pub(super) const MODEL: &str = "pasu.obj";

/// The same and the materials, those of colours of one's own among them, together in a package.
pub(super) fn package(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let mut package = Package::default();
    package.add_text(MODEL, &write(notes, bodies));
    let mut materials = obj_materials();
    let mut own: Vec<Look> = Vec::new();
    for look in bodies.iter().flat_map(Body::looks) {
        let is_known = matches!(look, Look { glaze: Choice::Named(_), clay: Choice::Named(_), .. });
        if !is_known && !own.contains(&look) {
            materials.push_str(&entry(look));
            own.push(look);
        }
    }
    package.add_text(LIBRARY, materials.as_bytes());
    package.finish()
}

/// The file of materials that OBJ files name, to be saved as `pasu.mtl` in their folder: every glaze on every clay.
///
/// It is the same for all designs, so that the files of many pots can lie in one folder. Colours (`Kd`) are coded as sRGB, as most programs take them, between 0 and 1; `Pr` is the roughness, and `Ns` says the same
/// for programs that do not know that, as Blender reads it: `1000 (1 - roughness)^2`.
///
/// ```
/// let materials = pasu::obj_materials();
/// assert!(materials.contains("\nnewmtl celadon_on_stoneware\nKd "));
/// ```
pub fn obj_materials() -> String {
    let mut text = format!("# {PROGRAM}, clays and glazes\n");
    for &clay in Clay::ALL {
        for &glaze in Glaze::ALL {
            text.push_str(&entry(Look::new(glaze, clay)));
        }
    }
    text
}

fn entry(look: Look) -> String {
    let Material { colour, roughness } = Material::of(look);
    let [red, green, blue] = colour.map(|linear| thousandths(f64::from(srgb(linear)) / 255.0));
    let (roughness, shininess) = (thousandths(roughness), thousandths(1000.0 * (1.0 - roughness) * (1.0 - roughness)));
    format!(
        "\nnewmtl {}\nKd {red} {green} {blue}\nKs 0.04 0.04 0.04\nNs {shininess}\nPr {roughness}\nd 1\nillum 2\n",
        identifier(&material::name(look))
    )
}

fn thousandths(x: f64) -> String {
    plain(libm::round(x * 1e3) / 1e3)
}

/// One word: readers end a name at white space of any kind, and some take what follows `#` for a comment.
fn identifier(name: &str) -> String {
    name.chars().filter(|c| *c != '#').map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect()
}
