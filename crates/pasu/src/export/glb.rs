//! GLB, the binary form of glTF 2.0: what shows a pot on a page, in a room, in a film.

use super::contents::{Body, Notes, PROGRAM};
use super::material::{self, Material};
use super::shading::{Shaded, shaded};
use crate::design::{Look, Value, to_json};

/// Before what the file says of itself in the JSON: pairs of a name and a text without escapes, and after them the title.
pub(super) const EXTRAS: &str = r#""extras":{"#;

/// A quarter turn about x that takes z to y: `sin` and `cos` of an eighth.
const HALF_ROOT: f64 = std::f64::consts::FRAC_1_SQRT_2;

const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY: u32 = 34962;
const ELEMENT_ARRAY: u32 = 34963;

/// A scene of one node, which makes metres of millimetres and turns z up into y up, and below it one node and mesh per part. Vertices keep the numbers that were checked;
/// they are split where faces meet, so that edges are drawn sharp.
pub(super) fn write(notes: &Notes, bodies: &[Body]) -> Vec<u8> {
    let mut buffer = Buffer::default();
    let mut looks: Vec<Look> = Vec::new();
    let mut meshes = Vec::new();
    let mut nodes = Vec::new();
    for body in bodies {
        let mut material = |own: Look| {
            looks.iter().position(|look| *look == own).unwrap_or_else(|| {
                looks.push(own);
                looks.len() - 1
            })
        };
        let Shaded { positions, normals, indices } = shaded(body);
        let attributes =
            record([("POSITION", buffer.vectors(&positions, true)), ("NORMAL", buffer.vectors(&normals, false))]);
        // The triangles of each look, all of the same vertices.
        let look_of = body.look_of();
        let mut primitives = Vec::new();
        for (number, look) in body.looks().into_iter().enumerate() {
            let own = indices.chunks_exact(3).enumerate().filter(|(triangle, _)| look_of(*triangle) == number);
            let own: Vec<u32> = own.flat_map(|(_, corners)| corners).copied().collect();
            primitives.push(record([
                ("attributes", attributes.clone()),
                ("indices", buffer.indices(&own)),
                ("material", count(material(look))),
            ]));
        }
        nodes.push(record([("name", text(&body.name)), ("mesh", count(meshes.len()))]));
        meshes.push(record([("name", text(&body.name)), ("primitives", Value::List(primitives))]));
    }
    let n_parts = nodes.len();
    nodes.push(record([
        ("name", text(&notes.title)),
        ("rotation", numbers([-HALF_ROOT, 0.0, 0.0, HALF_ROOT])),
        ("scale", numbers([0.001; 3])),
        ("children", Value::List((0..n_parts).map(count).collect())),
    ]));
    let mut extras: Vec<(&str, Value)> = notes.list().into_iter().map(|(name, value)| (name, text(&value))).collect();
    extras.push(("title", text(&notes.title)));
    let asset = record([("version", text("2.0")), ("generator", text(PROGRAM)), ("extras", record(extras))]);
    let scene = record([("nodes", Value::List(vec![count(n_parts)]))]);
    let bytes = record([("byteLength", count(buffer.bytes.len()))]);
    let document = record([
        ("asset", asset),
        ("scene", count(0)),
        ("scenes", Value::List(vec![scene])),
        ("nodes", Value::List(nodes)),
        ("meshes", Value::List(meshes)),
        ("materials", Value::List(looks.into_iter().map(material_of).collect())),
        ("accessors", Value::List(buffer.accessors)),
        ("bufferViews", Value::List(buffer.views)),
        ("buffers", Value::List(vec![bytes])),
    ]);
    packed(to_json(&document).into_bytes(), buffer.bytes)
}

/// The header and two chunks, JSON and binary, each of a whole number of four bytes.
fn packed(mut document: Vec<u8>, binary: Vec<u8>) -> Vec<u8> {
    document.resize(document.len().next_multiple_of(4), b' ');
    let length = 12 + 8 + document.len() + 8 + binary.len();
    let mut bytes = Vec::with_capacity(length);
    bytes.extend_from_slice(b"glTF");
    bytes.extend_from_slice(&2u32.to_le_bytes());
    bytes.extend_from_slice(&(length as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", document), (b"BIN\0", binary)] {
        bytes.extend_from_slice(&(chunk.len() as u32).to_le_bytes());
        bytes.extend_from_slice(kind);
        bytes.extend_from_slice(&chunk);
    }
    bytes
}

/// The binary chunk and what the document says of it. Everything in it has four bytes.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    fn vectors(&mut self, vectors: &[f32], with_bounds: bool) -> Value {
        let mut accessor = vec![
            ("componentType", Value::Number(FLOAT.into())),
            ("count", count(vectors.len() / 3)),
            ("type", text("VEC3")),
        ];
        if with_bounds {
            let bound = |of: fn(f32, f32) -> f32| {
                let along = |axis: usize| vectors.iter().skip(axis).step_by(3).copied().reduce(of).unwrap_or_default();
                numbers([0, 1, 2].map(|axis| f64::from(along(axis))))
            };
            accessor.extend([("min", bound(f32::min)), ("max", bound(f32::max))]);
        }
        self.add(vectors.iter().flat_map(|number| number.to_le_bytes()), ARRAY, accessor)
    }

    fn indices(&mut self, indices: &[u32]) -> Value {
        let accessor = vec![
            ("componentType", Value::Number(UNSIGNED_INT.into())),
            ("count", count(indices.len())),
            ("type", text("SCALAR")),
        ];
        self.add(indices.iter().flat_map(|index| index.to_le_bytes()), ELEMENT_ARRAY, accessor)
    }

    /// The number of the accessor.
    fn add(&mut self, bytes: impl Iterator<Item = u8>, target: u32, accessor: Vec<(&'static str, Value)>) -> Value {
        let offset = self.bytes.len();
        self.bytes.extend(bytes);
        self.views.push(record([
            ("buffer", count(0)),
            ("byteOffset", count(offset)),
            ("byteLength", count(self.bytes.len() - offset)),
            ("target", Value::Number(target.into())),
        ]));
        self.accessors.push(record([("bufferView", count(self.views.len() - 1))].into_iter().chain(accessor)));
        count(self.accessors.len() - 1)
    }
}

fn material_of(look: Look) -> Value {
    let Material { colour: [red, green, blue], roughness } = Material::of(look);
    let metallic_roughness = record([
        ("baseColorFactor", numbers([red, green, blue, 1.0])),
        ("metallicFactor", Value::Number(0.0)),
        ("roughnessFactor", Value::Number(roughness)),
    ]);
    record([("name", text(&material::name(look))), ("pbrMetallicRoughness", metallic_roughness)])
}

fn record<'a>(fields: impl IntoIterator<Item = (&'a str, Value)>) -> Value {
    Value::Record(fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
}

fn text(text: &str) -> Value {
    Value::Text(text.to_owned())
}

fn count(count: usize) -> Value {
    Value::Number(count as f64)
}

fn numbers<const N: usize>(numbers: [f64; N]) -> Value {
    Value::List(numbers.into_iter().map(Value::Number).collect())
}
