//! What is to be found in the files of one specimen.

use std::f64::consts::TAU;

use glam::DVec3;
use pasu::{Face, FaceKind, MeasureOptions, Pot, Result, Size, SolidMesh};
use serde_json::{Value, json};

use crate::designs::Specimen;

/// Points of each face along and around, in which the widest are found.
const ALONG: usize = 60;
const AROUND: usize = 480;

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
        "parts": meshes.len(),
        "triangles": meshes.iter().map(SolidMesh::n_triangles).sum::<usize>(),
        "size": size(specimen, &measured, millimetres)?.to_array(),
        "mesh_volume": volume,
        "mesh_area": area,
        "clay_volume": clay("value"),
        "clay_error": clay("error"),
        "bound": meshes.iter().map(|mesh| mesh.bound).fold(0.0, f64::max) * millimetres,
        "templates": templates(specimen, millimetres)?,
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
    for part in 0..design.parts().len() {
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

/// Chords by which the length of a rim is found.
const CHORDS: usize = 20_000;

/// What the template of each part shows, by the true faces: width and height of the section through the axis along world x, height of the whole part along its axis, length of the rim
/// seen from above (`null` where it is a point).
fn templates(specimen: &Specimen, millimetres: f64) -> Result<Vec<Value>> {
    let parts = 0..specimen.design.parts().len();
    parts.map(|part| Ok(template(&Pot::new(&specimen.design, part, specimen.making.product)?, millimetres))).collect()
}

fn template(pot: &Pot, millimetres: f64) -> Value {
    let axis = pot.axis();
    let along = if axis.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let across = (along - along.dot(axis) * axis).normalize();
    let normal = axis.cross(across);
    // Across the section's plane, across the axis, along it.
    let place = |point: DVec3| {
        let from = (point - pot.origin()) * millimetres;
        DVec3::new(from.dot(normal), from.dot(across), from.dot(axis))
    };
    let (mut least, mut most) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let (mut rim, mut top) = (0.0, f64::NEG_INFINITY);
    for face in pot.faces() {
        let at = |a: f64, step: usize, steps: usize| place(face.jet(a, step as f64 / steps as f64 * TAU).position);
        for row in 0..=ALONG {
            let a = row as f64 / ALONG as f64;
            let points: Vec<DVec3> = (0..=AROUND).map(|step| at(a, step, AROUND)).collect();
            for pair in points.windows(2) {
                let (before, after) = (pair[0], pair[1]);
                low = low.min(before.z);
                high = high.max(before.z);
                if (before.x < 0.0) != (after.x < 0.0) {
                    let cut = before.lerp(after, before.x / (before.x - after.x));
                    least = least.min(cut);
                    most = most.max(cut);
                }
            }
        }
        if face.kind() == FaceKind::Outer {
            for a in [0.0, 1.0] {
                let points: Vec<DVec3> = (0..=CHORDS).map(|step| at(a, step, CHORDS)).collect();
                let height = points.iter().map(|point| point.z).sum::<f64>() / points.len() as f64;
                if height > top {
                    top = height;
                    rim = points.windows(2).map(|pair| (pair[1] - pair[0]).truncate().length()).sum();
                }
            }
        }
    }
    let section = most - least;
    let is_point = rim <= 1e-5 * (high - low);
    json!({ "section": [section.y, section.z], "height": high - low, "rim": if is_point { Value::Null } else { rim.into() } })
}
