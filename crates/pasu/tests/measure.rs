//! Measures of real designs against formulas, dense sums and each other.

mod support;

use std::f64::consts::{PI, TAU};

use pasu::{Code, Error, MeasureOptions, Measures, Quantity, measure};
use support::design;

fn measured(json: &str) -> Measures {
    measure(&design(json), &MeasureOptions::default()).unwrap_or_else(|e| panic!("{e}\n{json}"))
}

/// The value is the exact one to 1e-10 of its size, and within the error that it states.
#[track_caller]
fn near(found: Quantity, exact: f64, size: f64) {
    assert!((found.value - exact).abs() <= 1e-10 * size, "{found:?} {exact}");
    assert!((found.value - exact).abs() <= found.error, "dishonest: {found:?} {exact}");
    assert!(found.error <= 1e-8 * size, "{found:?} {exact}");
}

/// A surface of revolution between two circles, which `t = 0` makes a straight cone.
fn cone(foot: f64, rim: f64, height: f64, extra: &str) -> String {
    let component = |name: &str, wave: &str| {
        format!(
            r#""{name}": {{ "order": 2, "s": 1, "t": 0, "modes": [ {{ "n": 1, "{wave}": {{ "start": {foot}, "end": {rim} }} }} ] }}"#
        )
    };
    let z = format!(
        r#""z": {{ "order": 2, "s": 1, "t": 0, "modes": [ {{ "n": 0, "cos": {{ "start": 0, "end": {height} }} }} ] }}"#
    );
    let shape = format!(
        r#"{{ "kind": "boundary-value", "span": "2pi", {}, {}, {z} }}"#,
        component("x", "cos"),
        component("y", "sin")
    );
    format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}{extra} }}] }}"#)
}

const WALL: &str = r#", "wall": { "thickness": 0.25, "base": 0.5 }"#;

#[test]
fn a_cup_by_formula() {
    let (r, h, t, b) = (3.0, 8.0, 0.25, 0.5);
    let m = measured(&cone(r, r, h, WALL));
    let (w, part) = (&m.whole, &m.parts[0]);
    near(w.height, h, h);
    near(w.width.least, 2.0 * r, r);
    near(w.width.greatest, 2.0 * r, r);
    near(w.area, TAU * r * h, 100.0);
    let inner = r - t;
    let capacity = w.capacity.unwrap();
    near(capacity.brim, PI * inner * inner * (h - b), 100.0);
    near(capacity.spill_level, h, h);
    assert!((capacity.floor - b).abs() < 1e-12);
    let clay = w.clay.unwrap();
    let volume = PI * (r * r * h - inner * inner * (h - b));
    near(clay.volume, volume, 100.0);
    near(clay.mass, 2.3 * volume, 100.0);
    near(clay.area, TAU * r * h + TAU * inner * (h - b) + TAU * r * r, 100.0);
    let moment = PI * (r * r * h * h / 2.0 - inner * inner * (h - b) * (h + b) / 2.0);
    let centre = w.centre_empty.unwrap();
    assert!((centre.at[2] - moment / volume).abs() < 1e-10 && centre.at[0].abs() < 1e-10 && centre.error < 1e-8);
    let water = PI * inner * inner * (h - b);
    let full = (2.3 * moment + water * (h + b) / 2.0) / (2.3 * volume + water);
    assert!((w.centre_full.unwrap().at[2] - full).abs() < 1e-10);
    let footprint = w.footprint.as_ref().unwrap();
    near(footprint.area, PI * r * r, 10.0);
    near(footprint.hull_area, PI * r * r, 10.0);
    for (tipping, centre) in [(w.tipping_empty, moment / volume), (w.tipping_full, full)] {
        assert!((tipping.unwrap().degrees - (r / centre).atan().to_degrees()).abs() < 1e-9, "{tipping:?}");
    }
    assert_eq!(part.reason, None);
    let thickness = part.thickness.unwrap();
    assert_eq!((thickness.least, thickness.greatest), ((t, None), t));
    assert!(part.overhang.unwrap().degrees.abs() < 1e-9);
    let curvature = part.curvature;
    assert!((curvature.mean.least.unwrap().value - 0.5 / r).abs() < 1e-12, "{curvature:?}");
    assert!(curvature.gaussian.greatest.unwrap().value.abs() < 1e-12);
}

#[test]
fn refusals_have_numbers() {
    let cup = design(&cone(3.0, 3.0, 8.0, WALL));
    let with = |options: MeasureOptions| measure(&cup, &options).unwrap_err();
    let say = |error: Error| (error.code().to_owned(), error.path().to_owned(), error.message().to_owned());
    let (code, path, message) = say(with(MeasureOptions { fill: Some(8.5), ..MeasureOptions::default() }));
    assert_eq!((code.as_str(), path.as_str()), (Code::OutOfRange.as_str(), "fill"));
    assert_eq!(message, "water runs out at the level 8: expected no more than that, found 8.5");
    assert_eq!(say(with(MeasureOptions { density: Some(-1.0), ..MeasureOptions::default() })).1, "density");
    let (_, path, message) = say(pasu::water(&cup, 9.0).unwrap_err());
    assert_eq!((path.as_str(), message.contains("level 8:")), ("level", true));
}
