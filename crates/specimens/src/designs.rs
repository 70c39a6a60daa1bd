//! Which designs are written, as what and how large.

use anyhow::{Context, Result};
use pasu::{Design, Format, Making, MeshOptions, Product, Size};
use serde_json::{Value, json};

/// The designs that the page offers, with their names.
const GALLERY: &str = include_str!("../../../tests/reference/gallery.json");

/// One product of one design and the files that are made of it.
pub(crate) struct Specimen {
    pub(crate) name: String,
    pub(crate) design: Design,
    pub(crate) making: Making,
    pub(crate) formats: Vec<Format>,
    /// Whether the slicer is to slice it too.
    pub(crate) slice: bool,
    /// The cells of the inside that are written as well, by how many there are along `u`, `v` and `w`.
    pub(crate) cells: Vec<[usize; 3]>,
}

impl Specimen {
    pub(crate) fn is_pot(&self) -> bool {
        self.making.product == Product::Pot
    }
}

/// Thickness of the wall and of the base, and the tolerance, as parts of the largest extent.
const WALL: f64 = 0.025;
const TOLERANCE: f64 = 2e-3;

/// How tall a figure of a paper is made, which has no unit of its own, in centimetres.
const FIGURE: f64 = 12.0;

/// Every exhibit as a pot with a plain wall and as a solid for vase mode, the solid in every format. A few of each are sliced; pots of the figures of papers leave out formats that
/// hold the same triangles.
pub(crate) fn gallery() -> Result<Vec<Specimen>> {
    let mut specimens = Vec::new();
    for exhibit in exhibits()? {
        let name = exhibit["name"].as_str().context("an exhibit has a name")?;
        let extent = extent(&exhibit["shape"])?;
        let size = (!name.starts_with("own-")).then_some(Size::Height(FIGURE));
        let making = Making { size, tolerance: Some(TOLERANCE * extent), ..Making::default() };
        let wall = json!({ "thickness": WALL * extent, "base": WALL * extent });
        specimens.push(Specimen {
            name: name.to_owned(),
            design: document(json!([{ "shape": exhibit["shape"], "wall": wall }]), "cm")?,
            making,
            formats: if size.is_none() {
                Format::ALL.to_vec()
            } else {
                vec![Format::Stl, Format::ThreeMf, Format::Step]
            },
            slice: ["own-dint", "own-saddle", "own-square", "zhang-you-1a"].contains(&name),
            cells: Vec::new(),
        });
        specimens.push(Specimen {
            name: format!("{name}-solid"),
            design: document(json!([{ "shape": exhibit["shape"] }]), "cm")?,
            making: Making { product: Product::Solid, ..making },
            formats: Format::ALL.to_vec(),
            slice: ["own-twist", "own-fluted", "ishak-ali-4-n5"].contains(&name),
            cells: Vec::new(),
        });
    }
    Ok(specimens)
}

/// All that a wall can be, and places, sizes, units and shrinkages that are easily got wrong.
pub(crate) fn hard() -> Result<Vec<Specimen>> {
    let shape = |name: &str| -> Result<Value> {
        let exhibits = exhibits()?;
        let exhibit = exhibits.into_iter().find(|exhibit| exhibit["name"] == name);
        Ok(exhibit.with_context(|| format!("the gallery has no {name}"))?["shape"].take())
    };
    let mut specimens = Vec::new();
    let mut add = |name: &str, parts: Value, unit: &str, making: Making| -> Result<()> {
        specimens.push(Specimen {
            name: format!("hard-{name}"),
            design: document(parts, unit)?,
            making,
            formats: Format::ALL.to_vec(),
            slice: name == "foot-ring-and-drain",
            cells: Vec::new(),
        });
        Ok(())
    };
    let coarse = |tolerance: f64| Making { tolerance: Some(tolerance), ..Making::default() };
    let jar = shape("own-jar")?;
    let dint = shape("own-dint")?;
    let square = shape("own-square")?;

    let wall = json!({ "thickness": 0.5, "base": 0.6, "side": "outside", "rim": "rounded" });
    add("outside-and-rounded", json!([{ "shape": jar, "wall": wall }]), "cm", coarse(0.04))?;

    let wall = json!({ "thickness": 0.5, "base": 0.6, "rim": "rounded" });
    add("rounded-rim-of-dints", json!([{ "shape": dint, "wall": wall }]), "cm", coarse(0.04))?;

    let wall = json!({ "thickness": 0.5, "base": 0.6, "foot": [0.8, 0.7], "drain": 1 });
    add("foot-ring-and-drain", json!([{ "shape": jar, "wall": wall }]), "cm", coarse(0.04))?;

    let wall = json!({ "thickness": 0.4, "base": 0.5, "foot": [0.7, 0.6], "rim": "rounded" });
    add("foot-ring-of-a-square", json!([{ "shape": square, "wall": wall }]), "cm", coarse(0.04))?;

    let wall = json!({ "thickness": 0.4, "base": 0 });
    add("tube", json!([{ "shape": jar, "wall": wall }]), "cm", coarse(0.04))?;

    // Mitred at the shoulder and rounded at the neck, and mitred where the profile turns inwards here and outwards there.
    let petals = json!({ "kind": "rings", "rings": [{ "u": 0, "r": { "mean": 3 }, "z": { "mean": 0 } },
        { "u": 0.35, "sharp": true, "r": { "mean": 6, "waves": [{ "n": 6, "cos": 0.4 }] }, "z": { "mean": 6 } },
        { "u": 0.7, "sharp": true, "r": { "mean": 2.6 }, "z": { "mean": 13 } }, { "u": 1, "r": { "mean": 3.2 }, "z": { "mean": 17 } }] });
    let wall = json!({ "thickness": 0.3, "base": 0.4 });
    add("sharp-petals", json!([{ "shape": petals, "wall": wall }]), "cm", coarse(0.04))?;

    let turning = json!({ "kind": "rings", "rings": [{ "u": 0, "r": { "mean": 4 }, "z": { "mean": 0 } },
        { "u": 0.5, "sharp": true, "r": { "mean": 4.6, "waves": [{ "n": 5, "cos": 0.8, "sin": 0.3 }] }, "z": { "mean": 6, "waves": [{ "n": 3, "cos": 0.5 }] } },
        { "u": 1, "r": { "mean": 5 }, "z": { "mean": 12 } }] });
    let wall = json!({ "thickness": 0.3, "base": 0.4, "side": "outside", "rim": "rounded" });
    add("sharp-both-ways", json!([{ "shape": turning, "wall": wall }]), "cm", coarse(0.04))?;

    let wall = json!({ "thickness": 3, "base": 2 });
    add("thinned", json!([{ "shape": square, "wall": wall }]), "cm", coarse(0.04))?;

    let wall = json!({ "thickness": 0.4, "base": 0.5, "drain": 0.8 });
    let place = json!({ "scale": [1, 0.8, 1.2], "axis": [1, 0.4, 0.2], "angle": 0.35, "shift": [12, -7, 3] });
    let placed = json!([{ "shape": dint, "wall": wall, "place": place }]);
    add("tilted-and-stretched", placed, "cm", coarse(0.04))?;

    let wall = json!({ "thickness": 0.3, "base": 0.3 });
    let making = Making { size: Some(Size::Height(7.5)), shrinkage: 12.5, ..coarse(0.03) };
    add("inches-that-shrink", json!([{ "shape": jar, "wall": wall }]), "in", making)?;

    let making = Making { size: Some(Size::Capacity(500_000.0)), shrinkage: 6.0, ..coarse(0.03) };
    add("half-a-litre-in-millimetres", json!([{ "shape": jar, "wall": wall }]), "mm", making)?;

    let making = Making { size: Some(Size::Width(9.0)), ..coarse(0.03) };
    add("of-a-width", json!([{ "shape": dint, "wall": wall }]), "cm", making)?;

    let beside = json!({ "shift": [25, 0, 0] });
    let pair = json!([{ "name": "jar", "shape": jar, "wall": wall, "look": { "glaze": "celadon" } },
        { "name": "dints", "shape": dint, "wall": wall, "place": beside, "look": { "glaze": "cobalt" } }]);
    add("a-pair", pair, "cm", coarse(0.04))?;
    Ok(specimens)
}

/// Formats of a body that has no axis to be cut along.
const BODIES: [Format; 7] =
    [Format::Stl, Format::ThreeMf, Format::Glb, Format::Obj, Format::ObjZip, Format::Ply, Format::Step];

/// How finely the inside of a blend is cut, and half as finely: what is solved on the cells has to come nearer to its formula.
const CELLS: [[usize; 3]; 2] = [[4, 16, 8], [8, 32, 16]];

/// Blends of every form and method as solids with their cells, and one as a pot.
pub(crate) fn blends() -> Result<Vec<Specimen>> {
    let section = |form: &str, radius: [f64; 2], [z, taper, dz]: [f64; 3]| json!({ "form": form, "radius": radius, "z": z, "taper": taper, "dz": dz });
    let petals = |[z, taper, dz]: [f64; 3]| {
        json!({ "form": "outline", "x": [{ "n": 1, "sin": 4 }, { "n": 4, "sin": -0.3 }, { "n": 6, "sin": 0.3 }],
            "y": [{ "n": 1, "cos": 4 }, { "n": 4, "cos": 0.3 }, { "n": 6, "cos": 0.3 }], "z": z, "taper": taper, "dz": dz })
    };
    let blend = |start: Value, end: Value, method: &str, weights: [f64; 3]| json!({ "kind": "blend", "start": start, "end": end, "method": method, "weights": weights, "terms": [6, 5, 4] });
    let (low, high) = ([0.0, 0.2, 7.0], [8.0, -0.1, 6.0]);
    // With even weights a round solid has a neck that is next to nothing.
    let light = [1.0, 0.005, 1.0];
    let solids = [
        (
            "rectangles",
            blend(section("rectangle", [2.0, 3.0], low), section("rectangle", [4.0, 2.0], high), "modal", [1.0; 3]),
            true,
        ),
        ("discs", blend(section("disc", [4.0, 3.0], low), section("disc", [2.5, 3.0], high), "exact", light), true),
        ("disc-to-petals", blend(section("disc", [3.0, 3.0], low), petals(high), "exact", light), true),
        ("petals-by-modes", blend(petals(low), section("disc", [3.0, 3.0], high), "modal", [1.0; 3]), false),
        (
            "disc-over-a-square",
            blend(
                section("disc-in-square", [2.0, 3.0], low),
                section("rectangle-reversed", [3.0, 2.0], high),
                "collocation",
                [1.0; 3],
            ),
            false,
        ),
    ];
    let making = Making { product: Product::Solid, tolerance: Some(0.03), ..Making::default() };
    let mut specimens = Vec::new();
    for (name, shape, has_cells) in solids {
        specimens.push(Specimen {
            name: format!("blend-{name}"),
            design: document(json!([{ "shape": shape }]), "cm")?,
            making,
            formats: BODIES.to_vec(),
            slice: false,
            cells: if has_cells { CELLS.to_vec() } else { Vec::new() },
        });
    }
    let vessel = blend(section("disc", [3.5, 3.0], low), petals([8.0, 0.3, 9.0]), "exact", light);
    let wall = json!({ "thickness": 0.3, "base": 0.4, "rim": "rounded" });
    specimens.push(Specimen {
        name: "blend-vessel".to_owned(),
        design: document(json!([{ "shape": vessel, "wall": wall }]), "cm")?,
        making: Making { tolerance: Some(0.03), ..Making::default() },
        formats: Format::ALL.to_vec(),
        slice: false,
        cells: Vec::new(),
    });
    Ok(specimens)
}

fn exhibits() -> Result<Vec<Value>> {
    serde_json::from_str(GALLERY).context("the gallery is JSON")
}

fn document(parts: Value, unit: &str) -> Result<Design> {
    let text = json!({ "pasu": 1, "title": "A specimen", "unit": unit, "parts": parts }).to_string();
    Design::parse(&text).with_context(|| format!("not a design: {text}"))
}

/// The largest extent of a shape along an axis, in its own unit.
fn extent(shape: &Value) -> Result<f64> {
    let design = document(json!([{ "shape": shape }]), "cm")?;
    let mesh = pasu::mesh(&design, &MeshOptions::default())?;
    let along = |axis: usize| {
        let all = mesh.positions.iter().skip(axis).step_by(3).map(|&coordinate| f64::from(coordinate));
        let (least, most) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        most - least
    };
    Ok([0, 1, 2].map(along).into_iter().fold(0.0, f64::max))
}
