//! What several test files share: the reference corpus and designs written as JSON.

pub(crate) mod documents;
pub(crate) mod golden;
pub(crate) mod networks;
pub(crate) mod random;
pub(crate) mod step;
pub(crate) mod value;

use pasu::{BoundaryValue, Design, Shape, Surface};
use serde::Deserialize;
use serde_json::Value;

/// One case of `tests/reference/surfaces.json` or `digits.json`.
#[derive(Deserialize)]
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) family: Option<Value>,
    pub(crate) shape: Value,
    pub(crate) points: Vec<Point>,
    pub(crate) scale: f64,
}

#[derive(Deserialize)]
pub(crate) struct Point {
    pub(crate) u: f64,
    pub(crate) v: f64,
    pub(crate) position: [f64; 3],
    pub(crate) du: [f64; 3],
    pub(crate) dv: [f64; 3],
}

pub(crate) fn corpus() -> Vec<Case> {
    serde_json::from_str(include_str!("../../reference/surfaces.json")).expect("the corpus is JSON")
}

/// `tests/reference/digits.json`: data of twelve digits in every regime, values of full precision.
pub(crate) fn digits() -> Vec<Case> {
    serde_json::from_str(include_str!("../../reference/digits.json")).expect("the corpus is JSON")
}

/// `tests/reference/rings.json`: surfaces through rings.
pub(crate) fn ring_cases() -> Vec<Case> {
    serde_json::from_str(include_str!("../../reference/rings.json")).expect("the corpus is JSON")
}

/// `tests/reference/ring-regimes.json`: rings in every regime of the roots, solved by shooting from ring to ring with sixty digits and more; 64 rings with gaps of 1e-4 among them.
pub(crate) fn ring_regimes() -> Vec<Case> {
    serde_json::from_str(include_str!("../../reference/ring-regimes.json")).expect("the corpus is JSON")
}

pub(crate) fn shape(value: &Value) -> Shape {
    Shape::parse(&value.to_string()).unwrap_or_else(|e| panic!("{e}"))
}

/// The boundary-value problem of a surface between two ends.
pub(crate) fn problem_of(value: &Value) -> BoundaryValue {
    shape(value).boundary_value().expect("it has two ends")
}

pub(crate) fn surface(value: &Value) -> Surface {
    Surface::solve(&problem_of(value), "shape").unwrap_or_else(|e| panic!("{e}"))
}

pub(crate) fn surface_of(json: &str) -> Surface {
    surface(&serde_json::from_str(json).expect("a test's shape is JSON"))
}

/// A design of one part with the given shape.
pub(crate) fn design_of(shape: &str) -> Design {
    design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape} }}] }}"#))
}

pub(crate) fn design(json: &str) -> Design {
    Design::parse(json).unwrap_or_else(|e| panic!("{e}\n{json}"))
}

pub(crate) fn design_of_case(case: &Case) -> Design {
    design_of(&serde_json::to_string(case.family.as_ref().unwrap_or(&case.shape)).expect("a value is JSON"))
}

/// The largest `k sqrt(|t/s|)` or `k (|w/s|)^(1/4)` of a shape, at least 1: what a derivative may grow by.
pub(crate) fn rate(shape: &Shape) -> f64 {
    let shape = shape.boundary_value().expect("it has two ends");
    let span = shape.span.length();
    let mut rate = 1.0f64;
    for component in [&shape.x, &shape.y, &shape.z] {
        for mode in &component.modes {
            let k = if span == std::f64::consts::TAU { mode.n } else { std::f64::consts::TAU * mode.n / span };
            rate = rate.max(k * (component.t / component.s).abs().sqrt());
        }
    }
    rate
}

/// One design of the designer's gallery.
#[derive(Deserialize)]
pub(crate) struct Exhibit {
    pub(crate) name: String,
    pub(crate) shape: Value,
}

/// `tests/reference/gallery.json`, which a test of the front end keeps equal to the gallery.
pub(crate) fn gallery() -> Vec<Exhibit> {
    serde_json::from_str(include_str!("../../reference/gallery.json")).expect("the gallery is JSON")
}

/// A design of `tests/reference/tables.json`: pots that are written out as tables of Fourier data, whose exact shapes tests are about.
pub(crate) fn table(name: &str) -> Exhibit {
    let tables: Vec<Exhibit> =
        serde_json::from_str(include_str!("../../reference/tables.json")).expect("the tables are JSON");
    tables.into_iter().find(|table| table.name == name).expect("among the tables")
}

impl Exhibit {
    pub(crate) fn design(&self) -> Design {
        design_of(&serde_json::to_string(&self.shape).expect("a value is JSON"))
    }

    /// Where its rings are along the profile, both ends among them; empty where it has none.
    pub(crate) fn rings(&self) -> Vec<f64> {
        let rings = self.shape["rings"].as_array();
        rings.into_iter().flatten().map(|ring| ring["u"].as_f64().expect("a number")).collect()
    }
}
