//! Files hold the checked mesh to the bit, say what they were made from, and are the same everywhere.
//!
//! What its time buys: every format is written and read again, of each kind of making.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use crate::support::golden::golden;
use crate::support::random::{Random, drawn};
use crate::support::step::{Spline, arguments};
use crate::support::{design, gallery};
use miniz_oxide::inflate::decompress_to_vec;
use pasu::{
    Craft, Design, Face, Format, Making, MeasureOptions, Pot, Product, Size, SolidMesh, fingerprint, measure,
    obj_materials, open, provenance, solid, write,
};
use serde_json::Value;
use xxhash_rust::xxh64::xxh64;

/// A jar of revolution, a dinted vase and a twisted one, of the gallery.
const JAR: &str = r#""kind": "fourth-order", "r0": 5.5, "r1": 5.4, "rm": 9.4, "h1": 20, "eta": [1.4, -1.9], "dz": [34, 9], "s": [1, 1], "t": [2, 2], "w": [1, 1]"#;
const DINT: &str = r#""kind": "bloor-wilson", "a": 0.3, "r": [7, 0.5, 0.5, 5], "R": [-22, -3, -3, -14], "h": [21, 1.4], "H": [-14, -4], "n1": 5"#;
const PETALS: &str = r#""kind": "second-order", "r": [8, 0.4, 5, 0.3], "n": [1, 6], "height": 15"#;

/// Designs with every kind of face, coarse enough to be quick.
fn designs() -> Vec<(&'static str, Design, Making)> {
    let coarse = Making { tolerance: Some(0.05), ..Making::default() };
    let one = |shape: &str, wall: &str, more: &str| {
        design(&format!(r#"{{ "pasu": 1, {more} "parts": [{{ "shape": {{ {shape} }}, "wall": {{ {wall} }} }}] }}"#))
    };
    let thin = r#""thickness": 0.4, "base": 0.5"#;
    vec![
        ("dint", one(DINT, thin, r#""title": "Dint & <vase> 'é' 🏺","#), coarse),
        (
            "rounded with ring and drain",
            one(JAR, r#""thickness": 0.5, "base": 0.5, "rim": "rounded", "foot": [0.6, 0.4], "drain": 1"#, ""),
            coarse,
        ),
        ("tube", one(PETALS, r#""thickness": 0.4, "base": 0, "side": "outside""#, r#""unit": "mm","#), coarse),
        ("vase mode", one(PETALS, thin, ""), Making { product: Product::Solid, ..coarse }),
        (
            "two parts",
            design(&format!(
                r#"{{ "pasu": 1, "parts": [
                    {{ "name": "body of clay", "shape": {{ {JAR} }}, "wall": {{ {thin} }} }},
                    {{ "shape": {{ {PETALS} }}, "place": {{ "shift": [30, 0, 0] }}, "wall": {{ {thin} }}, "look": {{ "glaze": "cobalt" }} }}
                ] }}"#
            )),
            Making { shrinkage: 12.0, ..coarse },
        ),
    ]
}

/// A design, its meshes and its files.
struct Specimen {
    name: &'static str,
    design: Design,
    making: Making,
    meshes: Vec<SolidMesh>,
    files: BTreeMap<&'static str, Vec<u8>>,
}

impl Specimen {
    fn file(&self, format: Format) -> &[u8] {
        &self.files[format.name()]
    }

    fn triangles(&self) -> Triangles {
        self.meshes.iter().flat_map(triangles_of).collect()
    }
}

/// Made once for all tests.
fn specimens() -> &'static [Specimen] {
    static SPECIMENS: OnceLock<Vec<Specimen>> = OnceLock::new();
    SPECIMENS.get_or_init(|| {
        let made = designs().into_iter().map(|(name, design, making)| {
            // As files have them.
            let design = design.ordered();
            let meshes = solid(&design, &making).unwrap_or_else(|error| panic!("{name}: {error}"));
            let files = Format::ALL.map(|format| (format.name(), write(&design, format, &making).unwrap()));
            Specimen { name, design, making, meshes, files: files.into() }
        });
        made.collect()
    })
}

/// Triangles by the coordinates of their corners.
type Triangles = Vec<[[f32; 3]; 3]>;

fn triangles_of(mesh: &SolidMesh) -> Triangles {
    assembled(&mesh.positions, &mesh.indices)
}

fn assembled(positions: &[f32], indices: &[u32]) -> Triangles {
    let corner = |index: u32| <[f32; 3]>::try_from(&positions[3 * index as usize..][..3]).unwrap();
    indices.chunks_exact(3).map(|t| [corner(t[0]), corner(t[1]), corner(t[2])]).collect()
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

fn f32s(bytes: &[u8]) -> Vec<f32> {
    bytes.chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect()
}

/// Zero has one sign in text.
fn plus(triangles: &Triangles) -> Triangles {
    triangles.iter().map(|t| t.map(|p| p.map(|x| x + 0.0))).collect()
}

#[test]
fn stl_holds_the_mesh() {
    for specimen in specimens() {
        let (name, expected) = (specimen.name, specimen.triangles());
        let bytes = specimen.file(Format::Stl);
        assert!(!bytes.starts_with(b"solid") && bytes.starts_with(b"Pasu "), "{name}");
        assert_eq!(bytes.len(), 84 + 50 * u32_at(bytes, 80) as usize);
        let mut found = Triangles::new();
        for triangle in bytes[84..].chunks_exact(50) {
            let numbers = f32s(&triangle[..48]);
            let points = [3, 6, 9].map(|i| [numbers[i], numbers[i + 1], numbers[i + 2]]);
            let [a, b, c] = points.map(|p| glam::DVec3::from(p.map(f64::from)));
            let normal = glam::DVec3::new(numbers[0].into(), numbers[1].into(), numbers[2].into());
            assert!((normal.length() - 1.0).abs() < 1e-6);
            assert!((b - a).cross(c - a).normalize().dot(normal) > 1.0 - 1e-6);
            found.push(points);
        }
        assert_eq!(found, expected, "{name}");
    }
}

/// The files of a package, by name.
fn unzipped(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut at = 0;
    while bytes[at..].starts_with(b"PK\x03\x04") {
        let short = |offset: usize| usize::from(u16::from_le_bytes([bytes[at + offset], bytes[at + offset + 1]]));
        let (method, packed, name) = (short(8), u32_at(bytes, at + 18) as usize, short(26));
        assert_eq!((short(10), short(12)), (0, 33), "the first day of ZIP");
        let start = at + 30 + name + short(28);
        let data = &bytes[start..start + packed];
        let data = if method == 8 { decompress_to_vec(data).unwrap() } else { data.to_vec() };
        assert_eq!(data.len(), u32_at(bytes, at + 22) as usize);
        files.insert(String::from_utf8(bytes[at + 30..at + 30 + name].to_vec()).unwrap(), data);
        at = start + packed;
    }
    files
}

/// The values of an attribute of all elements of a name, in order.
fn attributes<'a>(text: &'a str, element: &'a str, names: &'a [&'a str]) -> Vec<Vec<&'a str>> {
    let start = format!("<{element} ");
    let elements = text.split(start.as_str()).skip(1).map(|rest| rest.split('>').next().unwrap());
    elements
        .map(|element| {
            let value = |name: &&str| {
                element.split_once(&format!("{name}=\"")).map_or("", |(_, rest)| rest.split('"').next().unwrap())
            };
            names.iter().map(value).collect()
        })
        .collect()
}

#[test]
fn three_mf_holds_the_mesh() {
    for specimen in specimens() {
        let Specimen { name, meshes, .. } = specimen;
        let files = unzipped(specimen.file(Format::ThreeMf));
        let names: Vec<&str> = files.keys().map(String::as_str).collect();
        assert_eq!(names, ["3D/3dmodel.model", "Metadata/thumbnail.png", "[Content_Types].xml", "_rels/.rels"]);
        let model = std::str::from_utf8(&files["3D/3dmodel.model"]).unwrap();
        assert!(model.contains("<model unit=\"millimeter\"") && !model.contains("transform"));
        let objects: Vec<&str> = model.split("<object ").skip(1).collect();
        assert_eq!(objects.len(), meshes.len(), "{name}");
        assert_eq!(model.matches("<item ").count(), meshes.len());
        for (object, mesh) in objects.iter().zip(meshes) {
            let numbers = attributes(object, "vertex", &["x", "y", "z"]);
            let positions: Vec<f32> = numbers.iter().flatten().map(|x| x.parse().unwrap()).collect();
            let numbers = attributes(object, "triangle", &["v1", "v2", "v3"]);
            let indices: Vec<u32> = numbers.iter().flatten().map(|x| x.parse().unwrap()).collect();
            assert_eq!(plus(&assembled(&positions, &indices)), plus(&triangles_of(mesh)), "{name}");
        }
        let picture = &files["Metadata/thumbnail.png"];
        assert!(picture.starts_with(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x01\0\0\0\x01\0"), "{name}");
    }
}

#[test]
fn glb_holds_the_mesh() {
    for specimen in specimens() {
        let Specimen { name, meshes, .. } = specimen;
        let bytes = specimen.file(Format::Glb);
        assert_eq!(u32_at(bytes, 8) as usize, bytes.len());
        let length = u32_at(bytes, 12) as usize;
        let document: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
        let binary = &bytes[28 + length..];
        assert_eq!(document["asset"]["version"], "2.0");
        let view = |accessor: &Value| {
            let accessor = &document["accessors"][accessor.as_u64().unwrap() as usize];
            let view = &document["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
            let [offset, length] = ["byteOffset", "byteLength"].map(|key| view[key].as_u64().unwrap() as usize);
            &binary[offset..offset + length]
        };
        for (mesh, found) in meshes.iter().zip(document["meshes"].as_array().unwrap()) {
            let primitive = &found["primitives"][0];
            let positions = f32s(view(&primitive["attributes"]["POSITION"]));
            let normals = f32s(view(&primitive["attributes"]["NORMAL"]));
            let indices: Vec<u32> = view(&primitive["indices"]).chunks_exact(4).map(|b| u32_at(b, 0)).collect();
            assert_eq!(assembled(&positions, &indices), triangles_of(mesh), "{name}");
            assert_eq!(normals.len(), positions.len());
            for normal in normals.chunks_exact(3) {
                let length = normal.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>();
                assert!((length - 1.0).abs() < 1e-6, "{name} {normal:?}");
            }
        }
        let root = document["nodes"].as_array().unwrap().last().unwrap();
        assert_eq!(root["children"].as_array().unwrap().len(), meshes.len());
        assert_eq!(root["scale"], serde_json::json!([0.001, 0.001, 0.001]));
        assert_eq!(document["asset"]["extras"]["link"], specimen.design.link().as_str());
    }
}

#[test]
fn obj_holds_the_mesh() {
    for specimen in specimens() {
        let (name, expected) = (specimen.name, specimen.triangles());
        let text = std::str::from_utf8(specimen.file(Format::Obj)).unwrap();
        let (mut positions, mut indices) = (Vec::<f32>::new(), Vec::<u32>::new());
        for line in text.lines() {
            let mut words = line.split(' ');
            match words.next() {
                Some("v") => positions.extend(words.map(|word| word.parse::<f32>().unwrap())),
                Some("f") => indices.extend(words.map(|word| word.parse::<u32>().unwrap() - 1)),
                Some("#" | "o" | "s" | "mtllib" | "usemtl") => {}
                _ => panic!("{line}"),
            }
        }
        assert_eq!(text.matches("\no ").count(), specimen.meshes.len());
        assert_eq!(text.matches("\nusemtl ").count(), specimen.meshes.len());
        let files = unzipped(specimen.file(Format::ObjZip));
        assert_eq!(files.keys().map(String::as_str).collect::<Vec<_>>(), ["pasu.mtl", "pasu.obj"]);
        assert!(files["pasu.obj"] == text.as_bytes() && files["pasu.mtl"] == obj_materials().as_bytes(), "{name}");
        assert_eq!(plus(&assembled(&positions, &indices)), plus(&expected), "{name}");
    }
}

#[test]
fn ply_holds_the_mesh() {
    for specimen in specimens() {
        let Specimen { name, meshes, .. } = specimen;
        let expected = specimen.triangles();
        let bytes = specimen.file(Format::Ply);
        let end = bytes.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
        let header = std::str::from_utf8(&bytes[..end]).unwrap();
        assert!(header.is_ascii() && header.lines().all(|line| line.len() < 256));
        let count = |element: &str| -> usize {
            let (_, rest) = header.split_once(&format!("element {element} ")).unwrap();
            rest.lines().next().unwrap().parse().unwrap()
        };
        let faces = end + 15 * count("vertex");
        let positions: Vec<f32> = bytes[end..faces].chunks_exact(15).flat_map(|vertex| f32s(&vertex[..12])).collect();
        let stride = if meshes.len() > 1 { 17 } else { 13 };
        assert_eq!(bytes.len(), faces + stride * count("face"));
        let mut indices = Vec::new();
        for face in bytes[faces..].chunks_exact(stride) {
            assert_eq!(face[0], 3);
            indices.extend([1, 5, 9].map(|at| u32_at(face, at)));
        }
        assert_eq!(assembled(&positions, &indices), expected, "{name}");
    }
}

#[test]
fn step_surfaces_are_as_far_off_as_the_file_says() {
    for specimen in specimens() {
        let Specimen { name, design, making, .. } = specimen;
        let text = std::str::from_utf8(specimen.file(Format::Step)).unwrap();
        assert!(text.is_ascii() && text.starts_with("ISO-10303-21;\n") && text.ends_with("END-ISO-10303-21;\n"));
        let millimetres = making.scale(design).unwrap().millimetres;
        let bound: f64 = {
            let (_, rest) = text.split_once("points compared, ").unwrap();
            rest.split(' ').next().unwrap().parse().unwrap()
        };
        let entities: BTreeMap<&str, &str> =
            text.lines().filter_map(|line| line.strip_suffix(';')?.split_once('=')).collect();
        let pots: Vec<Pot> = (0..design.parts().len()).map(|i| Pot::new(design, i, making.product).unwrap()).collect();
        let faces: Vec<_> = pots.iter().flat_map(|pot| pot.faces()).collect();
        let written: Vec<Vec<String>> = text
            .lines()
            .filter_map(|line| line.split_once("=ADVANCED_FACE("))
            .map(|(_, rest)| arguments(rest.strip_suffix(");").unwrap()))
            .collect();
        assert_eq!(text.matches("=MANIFOLD_SOLID_BREP(").count(), pots.len());
        assert_eq!(text.matches("=CLOSED_SHELL(").count(), pots.len());
        let mut n_splines = 0;
        let mut faces = faces.into_iter();
        let mut face = None;
        for written in &written {
            let Some(surface) = entities[written[2].as_str()].strip_prefix("B_SPLINE_SURFACE_WITH_KNOTS(") else {
                assert!(entities[written[2].as_str()].starts_with("PLANE("));
                assert_eq!(written[0], format!("'{:?}'", faces.next().unwrap().kind()));
                continue;
            };
            n_splines += 1;
            let spline = Spline::read(surface, |id| entities[id]);
            let (along, round) = (&spline.along, &spline.round);
            assert_eq!((along.len(), round.len()), (spline.control.len() + 4, spline.control[0].len() + 4));
            // Panels follow on from each other round a face.
            if round[0] == 0.0 {
                face = faces.next();
            }
            let face = face.unwrap();
            assert_eq!(written[0], format!("'{:?}'", face.kind()));
            let (from, to) = (round[0], round[round.len() - 1]);
            for i in 0..23 {
                let a = (f64::from(i) + 0.37) / 23.0;
                for j in 0..37 {
                    let v = from + (to - from) * (f64::from(j) + 0.61) / 37.0;
                    let point = spline.at(a, v);
                    let off = (point - millimetres * face.jet(a, v).position).length();
                    assert!(off <= bound, "{name} {:?} {off} {bound}", face.kind());
                }
            }
        }
        assert!(n_splines > 0 && faces.next().is_none(), "{name}");
    }
}

#[test]
fn every_file_says_what_it_was_made_from() {
    for Specimen { name, design, files, .. } in specimens() {
        let print = fingerprint(design).unwrap();
        for (format, bytes) in files {
            let found = open(bytes);
            assert!(found == Some(design.link()) || *format == "stl" && found.is_none(), "{name} {format}");
            let text = match *format {
                "3mf" => unzipped(bytes)["3D/3dmodel.model"].clone(),
                "obj.zip" => unzipped(bytes)["pasu.obj"].clone(),
                _ => bytes.clone(),
            };
            let text = String::from_utf8_lossy(&text);
            for expected in [print.as_str(), "passed", concat!("Pasu ", env!("CARGO_PKG_VERSION"))] {
                assert!(text.contains(expected), "{name} {format} {expected}");
            }
        }
    }
}

/// Whatever holds a link says how it was made, and what it says makes the same file again.
#[test]
fn what_a_file_says_makes_it_again() {
    let cup = |unit: &str| {
        design(&format!(
            r#"{{ "pasu": 1, "unit": "{unit}", "parts": [{{ "shape": {{ "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 }},
                "wall": {{ "thickness": 0.5, "base": 1 }} }}] }}"#
        ))
    };
    let plain = Making::default();
    let coarse = Making { tolerance: Some(0.2), ..plain };
    for (unit, making) in [
        ("cm", plain),
        ("cm", Making { product: Product::Solid, ..coarse }),
        ("mm", Making { shrinkage: 12.5, ..coarse }),
        ("in", Making { size: Some(Size::Height(0.1 + 0.2)), shrinkage: 49.999, craft: Some(Craft::Clay), ..coarse }),
        ("cm", Making { size: Some(Size::Width(12.0)), craft: Some(Craft::Print), ..coarse }),
        ("in", Making { size: Some(Size::Capacity(100.0 / 3.0)), ..coarse }),
    ] {
        let cup = cup(unit);
        for format in Format::ALL {
            let bytes = write(&cup, format, &making).unwrap();
            let Some(found) = provenance(&bytes) else {
                assert_eq!(format, Format::Stl);
                continue;
            };
            assert_eq!((&found.link, found.making), (&cup.link(), Some(making)), "{format:?}");
            let again = write(&Design::parse(&found.link).unwrap(), format, &found.making.unwrap()).unwrap();
            assert!(again == bytes, "{format:?} of {making:?}");
            let is_plain = !matches!(format, Format::ThreeMf | Format::Glb | Format::ObjZip);
            assert!(!is_plain || told(&bytes, "unit", unit), "{format:?}");
        }
    }
}

/// Whether a text says what is called so, in any of the ways in which formats do.
fn told(bytes: &[u8], name: &str, value: &str) -> bool {
    let text = String::from_utf8_lossy(bytes);
    text.contains(&format!("pasu-{name}: {value}")) || text.contains(&format!("<pasu:{name}>{value}</"))
}

#[test]
fn short_links_are_in_stl() {
    let design = Design::parse("#1/bloor-wilson?a=6&n1=4&glaze=cobalt").unwrap();
    let making = Making { product: Product::Solid, tolerance: Some(0.05), ..Making::default() };
    let bytes = write(&design, Format::Stl, &making).unwrap();
    assert_eq!(open(&bytes), Some(design.link()));
    // The making beside it would be too long.
    assert_eq!(provenance(&bytes).unwrap().making, None);
    let short = Design::parse("#1/bloor-wilson?n1=4").unwrap();
    let bytes = write(&short, Format::Stl, &Making { tolerance: Some(0.1), ..making }).unwrap();
    assert_eq!(provenance(&bytes).unwrap().making, Some(Making { tolerance: Some(0.1), ..making }));
}

#[test]
fn files_are_larger_by_what_the_clay_shrinks() {
    let specimen = specimens().last().unwrap();
    let height = |mesh: &SolidMesh| {
        let heights = || mesh.positions.iter().skip(2).step_by(3).copied();
        f64::from(heights().fold(f32::MIN, f32::max)) - f64::from(heights().fold(f32::MAX, f32::min))
    };
    // 20 cm and 12 percent.
    let highest = specimen.meshes.iter().map(height).fold(0.0, f64::max);
    assert!((highest - 200.0 / 0.88).abs() < 1e-3);
    let text = String::from_utf8_lossy(specimen.file(Format::Obj));
    assert!(text.contains("# pasu-scale: 1 cm of the design is 11.363636"));
}

/// The tests in Node make the same files of the links in it.
///
/// After a change that is meant, or of the version, `PASU_BLESS=1 cargo test -p pasu --test library export` writes the file anew; the CHANGELOG says why.
#[test]
fn files_are_golden() {
    let mut found = BTreeMap::from([("version".to_owned(), env!("CARGO_PKG_VERSION").to_owned())]);
    for Specimen { name, design, making, files, .. } in specimens() {
        let Making { product, shrinkage, tolerance, .. } = making;
        let making = serde_json::json!({ "product": product.name(), "shrinkage": shrinkage, "tolerance": tolerance });
        found.insert(format!("{name}: link"), design.link());
        found.insert(format!("{name}: making"), making.to_string());
        for (format, bytes) in files {
            found.insert(format!("{name}.{format}"), format!("{:016x}", xxh64(bytes, 0)));
        }
    }
    let golden = golden!("files.json").beside(&found);
    assert_eq!(found, golden);
}

/// `PASU_FILES=folder cargo test -p pasu --test library export::kept` keeps the files of every specimen, and of the pots of the gallery, for other programs to read.
#[test]
fn files_can_be_kept() {
    let Some(folder) = std::env::var_os("PASU_FILES") else { return };
    let keep = |name: &str, format: &str, bytes: &[u8]| {
        let file = std::path::Path::new(&folder).join(format!("{}.{format}", name.replace(' ', "-")));
        std::fs::write(file, bytes).unwrap();
    };
    for specimen in specimens() {
        for (format, bytes) in &specimen.files {
            keep(specimen.name, format, bytes);
        }
    }
    for exhibit in gallery() {
        let wall = r#"{ "thickness": 0.4, "base": 0.5, "rim": "rounded" }"#;
        let shape = serde_json::to_string(&exhibit.shape).unwrap();
        let design = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall} }}] }}"#));
        for format in Format::ALL {
            let start = std::time::Instant::now();
            match write(&design, format, &Making::default()) {
                Ok(bytes) => keep(&exhibit.name, format.name(), &bytes),
                Err(error) => {
                    println!("{}: {error} after {:?}", exhibit.name, start.elapsed());
                    break;
                }
            }
            println!("{}.{}: {:?}", exhibit.name, format.name(), start.elapsed());
        }
    }
}

/// They were those of the vertices of a mesh, which has none on the crest of a rounded rim.
#[test]
fn the_height_on_a_template_is_the_height_that_is_measured() {
    let mut n_told = 0;
    for seed in [120].into_iter().chain(0..drawn(12, 120)) {
        let mut document: Value = serde_json::from_str(&Random::new(seed).design()).unwrap();
        let part = &mut document["parts"][0];
        (part["place"], part["wall"]["rim"]) = (serde_json::json!({}), "rounded".into());
        let design = design(&document.to_string());
        let Ok(bytes) = write(&design, Format::Svg, &Making::default()) else { continue };
        let text = String::from_utf8(bytes).unwrap();
        let height = measure(&design, &MeasureOptions::default()).unwrap().whole.height.value;
        let told: f64 = text.split_once(" top<").unwrap().0.rsplit_once('>').unwrap().1.parse().unwrap();
        assert!((told - height).abs() <= 0.005 + 1e-9, "seed {seed}: {told} is told, it is {height}");
        n_told += 1;
    }
    assert!(n_told > 8, "{n_told}");
}
