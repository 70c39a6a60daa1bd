//! The designs of `tests/bench`, from which JavaScript takes the same ones.

use pasu::{BoundaryValue, Design, Result, Solution};
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

/// How far the rings of [`vase_of_rings`] are at most from where they would stand evenly, as a part of their distance: what is alike between two rings is solved once, and here nothing is.
const ASIDE: f64 = 0.3;

/// The vase through so many rings, no two gaps of one length: between its ends, a little wider and narrower in turn.
///
/// # Errors
/// When the file is no design.
pub fn vase_of_rings(modes: usize, rings: usize) -> Result<Design> {
    through(modes, rings, ASIDE)
}

/// The same with all gaps of one length.
///
/// # Errors
/// When the file is no design.
pub fn vase_of_even_rings(modes: usize, rings: usize) -> Result<Design> {
    through(modes, rings, 0.0)
}

fn through(modes: usize, rings: usize, aside: f64) -> Result<Design> {
    let mut document = document(modes);
    let place = |index: usize| (index + 1) as f64 + aside * (1.7 * (index * index) as f64).sin();
    let places: Vec<f64> = (0..rings).map(|index| place(index) / (rings + 1) as f64).collect();
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

/// The patches along a side of the network that is measured.
pub const NETWORK: usize = 100;

/// How far its mesh is from it at most: a thousandth of its size.
pub const NETWORK_TOLERANCE: f64 = 0.01;

/// What moving its middle has solved again: two strips either way, which cross four times.
pub const NETWORK_NOTE: &str = "396 of 10,000 patches";

/// A network solved again and again with a point of it moved, each after the one before.
pub struct Moved<'a> {
    designs: &'a [Design; 2],
    next: usize,
    last: Solution,
}

impl<'a> Moved<'a> {
    /// Solves the first of two designs that differ by a point.
    ///
    /// # Errors
    /// When it cannot be solved.
    pub fn new(designs: &'a [Design; 2]) -> Result<Moved<'a>> {
        Ok(Moved { designs, next: 0, last: solved(Solution::of(&designs[0]))? })
    }

    /// Solves the other of the two.
    ///
    /// # Errors
    /// When it cannot be solved.
    pub fn step(&mut self) -> Result<&Solution> {
        self.next = 1 - self.next;
        self.last = solved(self.last.after(&self.designs[self.next]))?;
        Ok(&self.last)
    }
}

/// A solution of which the first part is computed.
///
/// # Errors
/// When it cannot be solved.
pub fn solved(solution: Solution) -> Result<Solution> {
    solution.evaluate(0, &[0.0, 0.5, 0.5])?;
    Ok(solution)
}

/// A sheet of `side x side` patches over a square of 10, wavy and joined edge to edge; the point in its middle is `lift` higher.
///
/// # Errors
/// When it has too many patches for a design.
pub fn network(side: usize, lift: f64) -> Result<Design> {
    // The points of a frame stand on a lattice of half patches, of whose squares the middles are of no frame.
    let across = 2 * side + 1;
    let number = |i: usize, j: usize| i * across + j;
    let step = 10.0 / (2 * side) as f64;
    // Six digits, as a document that people save has them.
    let round = |x: f64| (x * 1e6).round() / 1e6;
    let height = |i: usize, j: usize| {
        let (x, y) = (i as f64 * step, j as f64 * step);
        let raised = if (i, j) == (side / 2 * 2, side / 2 * 2) { lift } else { 0.0 };
        (1.3 * x).sin() * (0.9 * y + 0.4 * x).cos() + 0.3 * (2.9 * y).sin() + raised
    };
    let vertex = |k: usize| {
        let (i, j) = (k / across, k % across);
        json!([round(i as f64 * step), round(j as f64 * step), round(height(i, j))])
    };
    let frame = |k: usize| {
        let (i, j) = (2 * (k / side), 2 * (k % side));
        let round = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        json!({ "frame": round.map(|(a, b)| number(i + a, j + b)) })
    };
    let shape = json!({
        "kind": "vertex-frame",
        "vertices": (0..across * across).map(vertex).collect::<Vec<Value>>(),
        "patches": (0..side * side).map(frame).collect::<Vec<Value>>(),
    });
    Design::parse(&json!({ "pasu": 1, "parts": [{ "shape": shape }] }).to_string())
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
    fn the_two_networks_differ_by_a_point() {
        let [one, other] = [0.0, 0.01].map(|lift| network(4, lift).unwrap());
        let [one, other] = [&one, &other].map(|design| match &design.parts()[0].shape {
            pasu::Shape::VertexFrame(network) => network.clone(),
            _ => panic!("a network"),
        });
        assert_eq!((one.patches.len(), &one.patches), (16, &other.patches));
        assert_eq!(one.vertices.iter().zip(&other.vertices).filter(|(one, other)| one != other).count(), 1);
    }

    #[test]
    fn every_component_may_have_cosines_and_sines() {
        let shape = shape(&vase_of_every_wave(4).unwrap());
        for mode in [&shape.x, &shape.y, &shape.z].iter().flat_map(|component| &component.modes) {
            assert!(mode.n == 0.0 || mode.cos.start != 0.0 && mode.sin.start != 0.0, "{}", mode.n);
        }
    }
}
