//! 3MF, core specification 1.3: what slicers read best.

use super::contents::{Body, Notes, PROGRAM};
use super::material::{self, Material, srgb};
use super::numbers::{push_decimal, push_f32};
use super::thumbnail::thumbnail;
use super::xml::escaped;
use super::zip::Package;
use crate::watch;

/// Where the model is in the package.
pub(super) const MODEL: &str = "3D/3dmodel.model";
/// What begins an element of our metadata, up to its name; they stand near the beginning of the model.
pub(super) const METADATA: &str = "<metadata name=\"pasu:";

const THUMBNAIL: &str = "Metadata/thumbnail.png";

const CONTENT_TYPES: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/><Default Extension="png" ContentType="image/png"/></Types>
"#;

/// A package of one model: an object per part, in millimetres, placed where it is by no transform, with its clay and glaze as base materials; a thumbnail.
pub(super) fn write(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let relationships = format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="model" Target="/{MODEL}" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/><Relationship Id="thumbnail" Target="/{THUMBNAIL}" Type="http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"/></Relationships>
"#
    );
    let mut package = Package::default();
    package.add_text("[Content_Types].xml", CONTENT_TYPES.as_bytes());
    package.add_text("_rels/.rels", relationships.as_bytes());
    package.add_text(MODEL, &model(notes, bodies));
    package.add_stored(THUMBNAIL, &thumbnail(bodies));
    package.finish()
}

fn model(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let mut text = r#"<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:pasu="https://github.com/pasu-vase/pasu/3mf/1">
"#
    .to_owned();
    let metadata =
        |name: &str, value: &str| format!("<metadata name=\"{name}\" preserve=\"1\">{}</metadata>\n", escaped(value));
    text.push_str(&metadata("Title", &notes.title));
    text.push_str(&metadata("Application", PROGRAM));
    for (name, value) in notes.list() {
        text.push_str(&metadata(&format!("pasu:{name}"), &value));
    }
    text.push_str("<resources>\n<basematerials id=\"1\">");
    // The looks of all bodies, one after the other; which of them each body begins with.
    let mut first_look = vec![0];
    for look in bodies.iter().flat_map(Body::looks) {
        let [red, green, blue] = Material::of(look).colour.map(srgb);
        let name = material::name(look);
        text.push_str(&format!("<base name=\"{name}\" displaycolor=\"#{red:02X}{green:02X}{blue:02X}\"/>"));
    }
    text.push_str("</basematerials>\n");
    let mut bytes = text.into_bytes();
    for (index, body) in bodies.iter().enumerate() {
        let (object, name) = (object(index), escaped(&body.name));
        let (n_looks, look_of) = (body.looks().len(), body.look_of());
        let first = first_look[index];
        first_look.push(first + n_looks);
        bytes.extend_from_slice(
            format!("<object id=\"{object}\" type=\"model\" pid=\"1\" pindex=\"{first}\" name=\"{name}\"><mesh>\n<vertices>\n")
                .as_bytes(),
        );
        for position in body.positions.chunks_exact(3) {
            watch::work(10);
            for (before, number) in ["<vertex x=\"", "\" y=\"", "\" z=\""].into_iter().zip(position) {
                bytes.extend_from_slice(before.as_bytes());
                push_f32(&mut bytes, *number);
            }
            bytes.extend_from_slice(b"\"/>\n");
        }
        bytes.extend_from_slice(b"</vertices>\n<triangles>\n");
        for (number, corners) in body.triangles().enumerate() {
            for (before, vertex) in ["<triangle v1=\"", "\" v2=\"", "\" v3=\""].into_iter().zip(corners) {
                bytes.extend_from_slice(before.as_bytes());
                push_decimal(&mut bytes, u64::from(vertex), 0);
            }
            if look_of(number) != 0 {
                bytes.extend_from_slice(b"\" pid=\"1\" p1=\"");
                push_decimal(&mut bytes, (first + look_of(number)) as u64, 0);
            }
            bytes.extend_from_slice(b"\"/>\n");
        }
        bytes.extend_from_slice(b"</triangles>\n</mesh></object>\n");
    }
    bytes.extend_from_slice(b"</resources>\n<build>");
    for index in 0..bodies.len() {
        bytes.extend_from_slice(format!("<item objectid=\"{}\"/>", object(index)).as_bytes());
    }
    bytes.extend_from_slice(b"</build>\n</model>\n");
    bytes
}

/// Identifiers begin at 1, which the materials have.
fn object(index: usize) -> usize {
    index + 2
}
