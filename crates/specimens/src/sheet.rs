//! What is to be found in the files of one specimen.

use std::f64::consts::TAU;

use glam::DVec3;
use pasu::{Face, FaceKind, Format, MeasureOptions, Pot, Product, Result, Shape, Size, SolidMesh};
use serde_json::{Value, json};

use crate::designs::Specimen;

/// Points of each face along and around, in which the widest are found.
const ALONG: usize = 60;
const AROUND: usize = 480;

/// Intervals along either parameter of a side of a blend.
const BORDER: usize = 240;

/// Lengths in millimetres: how many parts and triangles, how large by the measures, volume and area of the triangles, volume of the clay.
pub(crate) fn expected(specimen: &Specimen) -> Result<Value> {
    let Specimen { design, making, .. } = specimen;
    let millimetres = making.scale(design)?.millimetres;
    let meshes = pasu::solid(design, making)?;
    let (volume, area) = meshes.iter().map(content).fold((0.0, 0.0), |sum, each| (sum.0 + each.0, sum.1 + each.1));
    let measured = measured(specimen)?;
    let clay = |field: &str| {
        let volume = measured["clay"]["volume"][field].as_f64().unwrap_or(f64::NAN);
        volume * millimetres * millimetres * millimetres
    };
    Ok(json!({
        "link": design.link(),
        "making": {
            "size": match making.size {
                Some(Size::Height(height)) => json!({ "height": height }),
                Some(Size::Width(width)) => json!({ "width": width }),
                Some(Size::Capacity(capacity)) => json!({ "capacity": capacity }),
                // Sizes may come that this sheet does not know.
                Some(_) => Value::Null,
                None => Value::Null,
            },
            "product": making.product.name(),
            "shrinkage": making.shrinkage,
            "tolerance": making.tolerance,
        },
        "unit": design.unit().millimetres(),
        "parts": meshes.len(),
        "triangles": meshes.iter().map(SolidMesh::n_triangles).sum::<usize>(),
        "size": size(specimen, &measured, millimetres)?.to_array(),
        "mesh_volume": volume,
        "mesh_area": area,
        "clay_volume": clay("value"),
        "clay_error": clay("error"),
        "bound": meshes.iter().map(|mesh| mesh.bound).fold(0.0, f64::max) * millimetres,
        // What has no axis has no template.
        "templates": if specimen.formats.contains(&Format::Svg) { templates(specimen, millimetres)? } else { Vec::new() },
    }))
}

/// Volume and area of closed triangles, by the divergence theorem.
fn content(mesh: &SolidMesh) -> (f64, f64) {
    let point = |vertex: u32| {
        let at = 3 * vertex as usize;
        DVec3::from_array([0, 1, 2].map(|axis| f64::from(mesh.positions[at + axis])))
    };
    let (mut volume, mut area) = (0.0, 0.0);
    for triangle in mesh.indices.chunks_exact(3) {
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]].map(point);
        volume += a.dot(b.cross(c)) / 6.0;
        area += (b - a).cross(c - a).length() / 2.0;
    }
    (volume, area)
}

/// What the measures say.
fn measured(specimen: &Specimen) -> Result<Value> {
    let options = MeasureOptions { product: specimen.making.product, ..MeasureOptions::default() };
    let measures = pasu::measure(&specimen.design, &options)?;
    Ok(serde_json::from_str(&measures.to_json()).unwrap_or_default())
}

/// Widths along x, y and z in millimetres, of many points of the true faces. The height is what was asked for, or what was measured.
fn size(specimen: &Specimen, measured: &Value, millimetres: f64) -> Result<DVec3> {
    let design = &specimen.design;
    let (mut least, mut most) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for (part, described) in design.parts().iter().enumerate() {
        if let (Shape::Blend(_), Product::Solid) = (&described.shape, specimen.making.product) {
            for position in border(design, part)? {
                least = least.min(position);
                most = most.max(position);
            }
            continue;
        }
        let pot = Pot::new(design, part, specimen.making.product)?;
        for face in pot.faces() {
            for index in 0..=ALONG * AROUND {
                let (a, v) = ((index / AROUND) as f64 / ALONG as f64, (index % AROUND) as f64 / AROUND as f64 * TAU);
                let position = face.jet(a, v).position;
                least = least.min(position);
                most = most.max(position);
            }
        }
    }
    let mut size = (most - least) * millimetres;
    size.z = match specimen.making.size {
        // By the definition of what was asked for alone, whatever the factors say.
        Some(Size::Height(height)) => height * design.unit().millimetres() / (1.0 - specimen.making.shrinkage / 100.0),
        _ => measured["height"]["value"].as_f64().unwrap_or(f64::NAN) * millimetres,
    };
    Ok(size)
}

/// Points of the border of a blend that stands where its shape puts it, by the closed form of its inside: all sides of the cube of its parameters.
fn border(design: &pasu::Design, part: usize) -> Result<Vec<DVec3>> {
    let share = |index: usize| index as f64 / BORDER as f64;
    let mut at = Vec::new();
    for index in 0..(BORDER + 1) * (BORDER + 1) {
        let (p, q) = (share(index / (BORDER + 1)), share(index % (BORDER + 1)));
        at.extend([[0.0, p, q], [1.0, p, q], [p, 0.0, q], [p, 1.0, q], [p, q, 0.0], [p, q, 1.0]]);
    }
    let found = pasu::evaluate(design, part, &at.concat())?;
    Ok(found.chunks_exact(3).map(DVec3::from_slice).collect())
}

/// Chords of a rim.
const CHORDS: usize = 7_200;
/// A rim that is level to this, in millimetres, is cut along world x.
const LEVEL: f64 = 0.1;
/// How far a strip reaches below the lowest point of the rim, millimetres.
const STRIP: f64 = 20.0;

/// What the template of each part shows, by the true faces: width and height of each section, height of the whole part along its axis, area of the strip under the rim (`null` where the
/// rim is a point).
fn templates(specimen: &Specimen, millimetres: f64) -> Result<Vec<Value>> {
    let parts = 0..specimen.design.parts().len();
    parts.map(|part| Ok(template(&Pot::new(&specimen.design, part, specimen.making.product)?, millimetres))).collect()
}

fn template(pot: &Pot, millimetres: f64) -> Value {
    let axis = pot.axis();
    let along = if axis.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let across = (along - along.dot(axis) * axis).normalize();
    // Along the section of a level rim, across it, along the axis.
    let place = |point: DVec3| {
        let from = (point - pot.origin()) * millimetres;
        DVec3::new(from.dot(across), from.dot(axis.cross(across)), from.dot(axis))
    };
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut rows: Vec<Vec<DVec3>> = Vec::new();
    let (mut rim, mut below, mut top) = (Vec::new(), None, f64::NEG_INFINITY);
    for face in pot.faces() {
        let at = |a: f64, step: usize, steps: usize| place(face.jet(a, step as f64 / steps as f64 * TAU).position);
        for row in 0..=ALONG {
            let points: Vec<DVec3> = (0..=AROUND).map(|step| at(row as f64 / ALONG as f64, step, AROUND)).collect();
            (low, high) = points.iter().fold((low, high), |(low, high), point| (low.min(point.z), high.max(point.z)));
            rows.push(points);
        }
        if face.kind() == FaceKind::Outer {
            for end in [0.0, 1.0] {
                let points: Vec<DVec3> = (0..CHORDS).map(|step| at(end, step, CHORDS)).collect();
                let height = points.iter().map(|point| point.z).sum::<f64>() / points.len() as f64;
                if height > top {
                    (top, rim, below) = (height, points, Some((face, end)));
                }
            }
        }
    }
    let is_point = rim.iter().all(|point| (*point - rim[0]).length() <= 1e-6 * (high - low));
    let directions = if is_point { vec![(1.0, 0.0)] } else { directions(&rim) };
    let sections: Vec<[f64; 2]> = directions.into_iter().map(|towards| section(&rows, towards)).collect();
    let strip = below.filter(|_| !is_point).map(|(face, end)| {
        let at = |a: f64, step: usize| place(face.jet(a, step as f64 / CHORDS as f64 * TAU).position);
        strip(&rim, |down, step| at(if end > 0.0 { 1.0 - down } else { down }, step))
    });
    json!({ "sections": sections, "height": high - low, "strip": strip })
}

/// Where the sections go: along the first axis, or to the highest and the lowest point of the rim.
fn directions(rim: &[DVec3]) -> Vec<(f64, f64)> {
    let first = |sign: f64| {
        let most = rim.iter().map(|point| sign * point.z).fold(f64::NEG_INFINITY, f64::max);
        rim.iter().copied().find(|point| sign * point.z >= most - 1e-6).unwrap_or_default()
    };
    let [high, low] = [first(1.0), first(-1.0)];
    if high.z - low.z <= LEVEL {
        return vec![(1.0, 0.0)];
    }
    let [high, low] = [high, low].map(|point| point.truncate().normalize());
    let both = if high.dot(low).abs() >= 0.9998 { vec![high] } else { vec![high, low] };
    both.into_iter().map(|towards| (towards.x, towards.y)).collect()
}

/// Width and height of what a plane through the axis cuts.
fn section(rows: &[Vec<DVec3>], (x, y): (f64, f64)) -> [f64; 2] {
    let turned = |point: DVec3| DVec3::new(x * point.x + y * point.y, x * point.y - y * point.x, point.z);
    let (mut least, mut most) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for pair in rows.iter().flat_map(|row| row.windows(2)) {
        let [before, after] = [pair[0], pair[1]].map(turned);
        if (before.y < 0.0) != (after.y < 0.0) {
            let cut = before.lerp(after, before.y / (before.y - after.y));
            least = least.min(cut);
            most = most.max(cut);
        }
    }
    [most.x - least.x, most.z - least.z]
}

/// The area of the triangles between the rim and the level below it at which the strip ends; `at` goes down a column of the outside. Where one does not come down so far, of a strip as long as the rim seen from above.
fn strip(rim: &[DVec3], at: impl Fn(f64, usize) -> DVec3) -> f64 {
    let lowest = rim.iter().map(|point| point.z).fold(f64::INFINITY, f64::min);
    let foot = (0..CHORDS).map(|step| at(1.0, step).z).fold(f64::NEG_INFINITY, f64::max);
    let level = lowest - STRIP.min((lowest - foot) / 2.0);
    let reached = |step: usize| {
        let mut above = 0.0;
        for index in 1..=ALONG {
            let mut below = index as f64 / ALONG as f64;
            if at(below, step).z <= level {
                for _ in 0..40 {
                    let middle = 0.5 * (above + below);
                    if at(middle, step).z <= level { below = middle } else { above = middle }
                }
                return Some(at(below, step));
            }
            above = below;
        }
        None
    };
    let hem: Option<Vec<DVec3>> = (0..CHORDS).map(reached).collect();
    let pairs = (0..CHORDS).map(|step| (step, (step + 1) % CHORDS));
    match hem {
        Some(hem) if level < lowest => pairs
            .map(|(i, j)| {
                let upper = (hem[i] - rim[i]).cross(rim[j] - rim[i]).length();
                (upper + (hem[i] - rim[j]).cross(hem[j] - rim[j]).length()) / 2.0
            })
            .sum(),
        _ => pairs
            .map(|(i, j)| {
                let depth = (rim[i].z + rim[j].z) / 2.0 - lowest + STRIP;
                (rim[j] - rim[i]).truncate().length() * depth
            })
            .sum(),
    }
}
