//! The designs of `tests/bench`, from which JavaScript takes the same ones.

use pasu::{BoundaryValue, Design, Result};
use serde_json::{Value, json};

/// A vase of 64 modes in each component, each with a profile of its own.
const VASE: &str = include_str!("../../../tests/bench/vase.json");

/// A turned vase: every row is a circle about the axis.
const TURNED: &str = include_str!("../../../tests/bench/turned.json");

/// The vase with the first so many modes of each component.
///
/// # Errors
/// When the file is no design.
pub fn vase(modes: usize) -> Result<Design> {
    Design::parse(&document(modes).to_string())
}

/// The vase with the first so many modes of each component, and of each mode the other wave, half as high, with rim and foot exchanged: every component has cosines and sines.
///
/// # Errors
/// When the file is no design.
pub fn vase_of_every_wave(modes: usize) -> Result<Design> {
    let mut document = document(modes);
    for name in ["x", "y", "z"] {
        let component = &mut document["parts"][0]["shape"][name];
        for mode in component["modes"].as_array_mut().into_iter().flatten().filter(|mode| mode["n"] != 0) {
            let (here, other) = if mode["cos"].is_object() { ("cos", "sin") } else { ("sin", "cos") };
            let half = |datum: &str| mode[here][datum].as_f64().unwrap_or(0.0) / 2.0;
            mode[other] = json!({
                "start": half("end"), "end": half("start"), "start_u": half("end_u"), "end_u": half("start_u")
            });
        }
    }
    Design::parse(&document.to_string())
}

/// The vase with the equation of `x` in every component.
///
/// # Errors
/// When the file is no design.
pub fn vase_of_one_equation(modes: usize) -> Result<Design> {
    let mut document = document(modes);
    let shape = &mut document["parts"][0]["shape"];
    for factor in ["s", "t", "w"] {
        for component in ["y", "z"] {
            shape[component][factor] = shape["x"][factor].clone();
        }
    }
    Design::parse(&document.to_string())
}

/// The same boundary curves joined by the equation of order 2, `s X_uu + t X_vv = 0`.
///
/// # Errors
/// When the file is no design.
pub fn vase_of_second_order(modes: usize) -> Result<Design> {
    let mut document = document(modes);
    for name in ["x", "y", "z"] {
        let component = &mut document["parts"][0]["shape"][name];
        component["order"] = 2.into();
        remove(component, "w");
        for mode in component["modes"].as_array_mut().into_iter().flatten() {
            for datum in ["cos", "sin"] {
                if let Some(datum) = mode.get_mut(datum) {
                    remove(datum, "start_u");
                    remove(datum, "end_u");
                }
            }
        }
    }
    Design::parse(&document.to_string())
}

/// How far the rings of [`vase_of_rings`] are from where they would stand evenly, as parts of their distance.
const ASIDE: [f64; 3] = [-0.25, 0.0, 0.25];

/// The vase through so many rings, no two neighbouring gaps of one length: between its ends, a little wider and narrower in turn.
///
/// # Errors
/// When the file is no design.
pub fn vase_of_rings(modes: usize, rings: usize) -> Result<Design> {
    let mut document = document(modes);
    let places: Vec<f64> =
        (0..rings).map(|index| ((index + 1) as f64 + ASIDE[index % 3]) / (rings + 1) as f64).collect();
    let shape = &mut document["parts"][0]["shape"];
    shape["rings"] = places.iter().map(|u| json!({ "u": u })).collect();
    for name in ["x", "y", "z"] {
        for mode in shape[name]["modes"].as_array_mut().into_iter().flatten() {
            let datum = if mode["cos"].is_object() { &mut mode["cos"] } else { &mut mode["sin"] };
            let [start, end] = ["start", "end"].map(|field| datum[field].as_f64().unwrap_or(0.0));
            let value = |(index, u): (usize, &f64)| {
                let wider = if index % 2 == 0 { 0.05 } else { -0.05 };
                start + (end - start) * u + (start - end) * wider
            };
            datum["rings"] = places.iter().enumerate().map(value).collect();
        }
    }
    Design::parse(&document.to_string())
}

fn document(modes: usize) -> Value {
    let mut document: Value = serde_json::from_str(VASE).unwrap_or_default();
    for component in ["x", "y", "z"] {
        if let Some(list) = document["parts"][0]["shape"][component]["modes"].as_array_mut() {
            list.truncate(modes);
        }
    }
    document
}

fn remove(object: &mut Value, field: &str) {
    if let Some(object) = object.as_object_mut() {
        object.remove(field);
    }
}

/// The turned vase.
///
/// # Errors
/// When the file is no design.
pub fn turned() -> Result<Design> {
    Design::parse(TURNED)
}

/// The boundary-value problem of a design's first part.
pub fn shape(design: &Design) -> BoundaryValue {
    design.parts()[0].shape.boundary_value().expect("a vase has two ends")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_vase_has_as_many_modes_as_asked_for() {
        for modes in [1, 4, 8, 64] {
            let shape = shape(&vase(modes).unwrap());
            assert_eq!([&shape.x, &shape.y, &shape.z].map(|component| component.modes.len()), [modes; 3]);
        }
    }

    #[test]
    fn the_vase_goes_through_as_many_rings_as_asked_for() {
        for rings in [8, 64] {
            let shape = shape(&vase_of_rings(16, rings).unwrap());
            assert_eq!(shape.rings.len(), rings);
            for mode in [&shape.x, &shape.y, &shape.z].iter().flat_map(|component| &component.modes) {
                assert!(mode.cos.rings.len() == rings || mode.sin.rings.len() == rings, "{}", mode.n);
            }
        }
    }

    #[test]
    fn every_component_may_have_cosines_and_sines() {
        let shape = shape(&vase_of_every_wave(4).unwrap());
        for mode in [&shape.x, &shape.y, &shape.z].iter().flat_map(|component| &component.modes) {
            assert!(mode.n == 0.0 || mode.cos.start != 0.0 && mode.sin.start != 0.0, "{}", mode.n);
        }
    }
}
