//! What is to be found in the files of one specimen.

use std::f64::consts::TAU;

use glam::DVec3;
use pasu::{Face, MeasureOptions, Pot, Result, Size, SolidMesh};
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
