//! Measures of real designs against formulas, dense sums and each other.
//!
//! What its time buys: sums over grids so fine that they are an independent judge of the errors that measures state, also of petalled and of thinned walls.

use std::f64::consts::{PI, TAU};

use crate::support::random::Random;
use crate::support::{design, gallery, table};
use glam::DVec3;
use pasu::{
    Capacity, Code, CurvatureRange, Error, Face, FaceKind, Making, Map, MeasureOptions, Measures, MeshOptions, Pot,
    Product, Quantity, Size, Solution, measure, mesh, paint, water,
};

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
    near(capacity.spill.level, h, h);
    assert!((capacity.floor - b).abs() < 1e-12);
    let clay = w.clay.unwrap();
    let volume = PI * (r * r * h - inner * inner * (h - b));
    near(clay.volume, volume, 100.0);
    near(clay.mass, 2.3 * volume, 100.0);
    near(clay.area, TAU * r * h + TAU * inner * (h - b) + TAU * r * r, 100.0);
    let moment = PI * (r * r * h * h / 2.0 - inner * inner * (h - b) * (h + b) / 2.0);
    let centre = w.centre.empty.unwrap();
    assert!((centre.at[2] - moment / volume).abs() < 1e-10 && centre.at[0].abs() < 1e-10 && centre.error < 1e-8);
    let water = PI * inner * inner * (h - b);
    let full = (2.3 * moment + water * (h + b) / 2.0) / (2.3 * volume + water);
    assert!((w.centre.full.unwrap().at[2] - full).abs() < 1e-10);
    let footprint = w.footprint.as_ref().unwrap();
    near(footprint.area, PI * r * r, 10.0);
    near(footprint.hull_area, PI * r * r, 10.0);
    for (tipping, centre) in [(w.tipping.empty, moment / volume), (w.tipping.full, full)] {
        assert!((tipping.unwrap().degrees - (r / centre).atan().to_degrees()).abs() < 1e-9, "{tipping:?}");
    }
    assert_eq!(part.reason, None);
    let thickness = part.thickness.unwrap();
    assert_eq!((thickness.least.value, thickness.least.at, thickness.greatest.value), (t, None, t));
    assert!(part.overhang.unwrap().degrees.abs() < 1e-9);
    let curvature = part.curvature;
    assert!((curvature.mean.least.unwrap().value - 0.5 / r).abs() < 1e-12, "{curvature:?}");
    assert!(curvature.gaussian.greatest.unwrap().value.abs() < 1e-12);
}

#[test]
fn refusals_have_numbers() {
    let cup = design(&cone(3.0, 3.0, 8.0, WALL));
    let with = |options: MeasureOptions| measure(&cup, &options).unwrap_err();
    let say = |error: Error| (error.code().as_str().to_owned(), error.path().to_owned(), error.message().to_owned());
    let (code, path, message) = say(with(MeasureOptions { fill: Some(8.5), ..MeasureOptions::default() }));
    assert_eq!((code.as_str(), path.as_str()), (Code::OutOfRange.as_str(), "fill"));
    assert_eq!(message, "water runs out at the level 8: expected no more than that, found 8.5");
    assert_eq!(say(with(MeasureOptions { density: Some(-1.0), ..MeasureOptions::default() })).1, "density");
    let (_, path, message) = say(water(&cup, 9.0).unwrap_err());
    assert_eq!((path.as_str(), message.contains("level 8:")), ("level", true));
}

#[test]
fn a_flaring_cup_by_formula() {
    let (foot, rim, h, t, b) = (2.0, 5.0, 7.0, 0.25, 0.5);
    let m = measured(&cone(foot, rim, h, WALL));
    let slope = (rim - foot) / h;
    let (cos, sin) = (1.0 / slope.hypot(1.0), slope / slope.hypot(1.0));
    // Cut square, the inner edge of the rim is the higher one.
    let top = h + t * sin;
    let radius = |z: f64| foot + slope * z - t / cos;
    let frustum = |low: f64, high: f64, r: f64, s: f64| PI * (high - low) * (r * r + r * s + s * s) / 3.0;
    let capacity = m.whole.capacity.unwrap();
    near(capacity.spill.level, top, h);
    near(capacity.brim, frustum(b, top, radius(b), radius(top)), 300.0);
    near(m.whole.height, top, h);
    near(m.whole.area, PI * (foot + rim) * h.hypot(rim - foot), 200.0);
    near(m.whole.width.greatest, 2.0 * rim, rim);
    let overhang = m.parts[0].overhang.unwrap();
    assert!((overhang.degrees - slope.atan().to_degrees()).abs() < 1e-9, "{overhang:?}");
    assert!((m.parts[0].overhang_inside.unwrap().degrees + slope.atan().to_degrees()).abs() < 1e-9);
    // Clay: outer frustum, and the ring under the rim, less the inside.
    let ring = PI / 3.0 * (top - h) * (rim * rim + rim * radius(top) + radius(top).powi(2));
    let clay = frustum(0.0, h, foot, rim) + ring - frustum(b, top, radius(b), radius(top));
    near(m.whole.clay.unwrap().volume, clay, 300.0);
}

/// `r = R u`, `z = H u^2`: the force is a constant.
fn paraboloid(r: f64, h: f64, extra: &str) -> String {
    let round = |name: &str, wave: &str| {
        format!(
            r#""{name}": {{ "order": 2, "s": 1, "t": 0, "modes": [ {{ "n": 1, "{wave}": {{ "start": 0, "end": {r} }} }} ] }}"#
        )
    };
    let z = format!(
        r#""z": {{ "order": 2, "s": 1, "t": 0, "modes": [ {{ "n": 0, "cos": {{ "start": 0, "end": {h}, "force": [{}] }} }} ] }}"#,
        2.0 * h
    );
    format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": "2pi", {}, {}, {z} }}{extra} }}] }}"#,
        round("x", "cos"),
        round("y", "sin")
    )
}

#[test]
fn a_bare_paraboloid_by_formula() {
    let (r, h) = (3.0f64, 4.0f64);
    let m = measured(&paraboloid(r, h, ""));
    let part = &m.parts[0];
    near(m.whole.area, PI * r / (6.0 * h * h) * ((r * r + 4.0 * h * h).powf(1.5) - r.powi(3)), 50.0);
    near(m.whole.capacity.unwrap().brim, PI * r * r * h / 2.0, 50.0);
    assert!(part.reason.as_ref().unwrap().contains("no wall") && m.whole.clay.is_none() && m.whole.footprint.is_none());
    let apex = 2.0 * h / (r * r);
    let (mean, gaussian) = (part.curvature.mean.greatest.unwrap(), part.curvature.gaussian.greatest.unwrap());
    assert!((mean.value - apex).abs() < 1e-6 && (gaussian.value - apex * apex).abs() < 1e-6, "{mean:?} {gaussian:?}");
    assert!(DVec3::from_array(mean.at).length() < 1e-2);
    // The tip of a cone bends without bound.
    let m = measured(&cone(0.0, 3.0, 4.0, ""));
    assert_eq!(m.parts[0].curvature.mean.greatest, None);
    near(m.whole.capacity.unwrap().brim, PI * 9.0 * 4.0 / 3.0, 50.0);
}

/// As [`near`], of a value with an error beside it.
#[track_caller]
fn within(value: f64, error: f64, exact: f64, most: f64) {
    assert!((value - exact).abs() <= error, "dishonest: {value} off by {:e}, stated {error:e}", value - exact);
    assert!(error <= most, "{value} {error:e}");
}

#[track_caller]
fn bounds(range: CurvatureRange, [least, greatest]: [f64; 2], most: f64) {
    for (found, exact) in [(range.least.unwrap(), least), (range.greatest.unwrap(), greatest)] {
        within(found.value, found.error, exact, most);
    }
}

#[test]
fn angles_and_curvatures_by_formula_with_their_errors() {
    // A cylinder.
    let (r, h, t, b) = (3.0f64, 8.0f64, 0.25f64, 0.5f64);
    let m = measured(&cone(r, r, h, WALL));
    let part = &m.parts[0];
    bounds(part.curvature.mean, [0.5 / r; 2], 1e-11);
    bounds(part.curvature.gaussian, [0.0; 2], 1e-11);
    for overhang in [part.overhang, part.overhang_inside] {
        within(overhang.unwrap().degrees, overhang.unwrap().error, 0.0, 1e-9);
    }
    let inner = r - t;
    let moment = PI * (r * r * h * h / 2.0 - inner * inner * (h - b) * (h + b) / 2.0);
    let volume = PI * (r * r * h - inner * inner * (h - b));
    let tipping = m.whole.tipping.empty.unwrap();
    within(tipping.degrees, tipping.error, (r * volume / moment).atan().to_degrees(), 1e-7);
    let thickness = part.thickness.unwrap();
    assert_eq!([thickness.least.error, thickness.greatest.error, thickness.thinned.error], [0.0; 3]);

    // A cone: the circle across is seen by the slope of its side (Meusnier).
    let m = measured(&cone(2.0, 5.0, 7.0, WALL));
    let (slope, side) = (3.0f64 / 7.0, (1.0 + 9.0 / 49.0f64).sqrt());
    let overhang = m.parts[0].overhang.unwrap();
    within(overhang.degrees, overhang.error, slope.atan().to_degrees(), 1e-9);
    bounds(m.parts[0].curvature.mean, [0.5 / (5.0 * side), 0.5 / (2.0 * side)], 1e-10);
    bounds(m.parts[0].curvature.gaussian, [0.0; 2], 1e-11);

    // A paraboloid: a pole, and the rim.
    let (r, h) = (3.0f64, 4.0f64);
    let m = measured(&paraboloid(r, h, ""));
    let p = 2.0 * h / (r * r);
    let stretch = (1.0 + p * p * r * r).sqrt();
    let (along, across) = (p / stretch.powi(3), p / stretch);
    bounds(m.parts[0].curvature.mean, [0.5 * (along + across), p], 3e-8);
    bounds(m.parts[0].curvature.gaussian, [along * across, p * p], 3e-8);
    let overhang = m.parts[0].overhang.unwrap();
    within(overhang.degrees, overhang.error, 90.0, 1e-6);

    // A catenoid: r = a cosh(z / a), whose mean curvature vanishes.
    let (a, rate) = (2.0f64, 3.0f64);
    let end = a * (0.5 * rate).cosh();
    let round = |name: &str, wave: &str| {
        let datum = format!(r#"{{ "n": 1, "{wave}": {{ "start": {end}, "end": {end} }} }}"#);
        format!(r#""{name}": {{ "order": 2, "s": 1, "t": {}, "modes": [ {datum} ] }}"#, rate * rate)
    };
    let z = format!(
        r#""z": {{ "order": 2, "s": 1, "t": 0, "modes": [ {{ "n": 0, "cos": {{ "end": {} }} }} ] }}"#,
        a * rate
    );
    let m = measured(&format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": "2pi", {}, {}, {z} }} }}] }}"#,
        round("x", "cos"),
        round("y", "sin")
    ));
    let curvature = m.parts[0].curvature;
    bounds(curvature.mean, [0.0; 2], 1e-10);
    bounds(curvature.gaussian, [-1.0 / (a * a), -1.0 / (a * a * (0.5 * rate).cosh().powi(4))], 1e-10);
    let overhang = m.parts[0].overhang.unwrap();
    within(overhang.degrees, overhang.error, (0.5 * rate).sinh().atan().to_degrees(), 1e-9);
}

/// What a fine grid finds is within the error that is stated, also of walls that had to be thinned.
#[test]
fn overhangs_against_a_fine_grid() {
    for (name, rim) in
        [("own-dint", "rounded"), ("own-twist", "flat"), ("own-fluted", "flat"), ("ishak-ali-4-n5", "flat")]
    {
        let design = design(&exhibit(name, rim, ""));
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        let part = &measure(&design, &MeasureOptions::default()).unwrap().parts[0];
        for (is_inside, found) in [(false, part.overhang.unwrap()), (true, part.overhang_inside.unwrap())] {
            let is_meant = |kind: FaceKind| match is_inside {
                true => kind == FaceKind::Lining,
                false => matches!(kind, FaceKind::Outer | FaceKind::Rim),
            };
            let mut most = f64::MIN;
            for face in pot.faces().iter().filter(|face| is_meant(face.kind())) {
                for i in 0..=200 {
                    for j in 0..400 {
                        let jet = face.jet(f64::from(i) / 200.0, TAU * f64::from(j) / 400.0);
                        let normal = jet.da.cross(jet.dv) * face.outward();
                        most = most.max((-normal.z).atan2(normal.x.hypot(normal.y)).to_degrees());
                    }
                }
            }
            println!("{name} {is_inside} {found:?} {most}");
            assert!(most <= found.degrees + found.error, "{name} {is_inside}: {found:?} {most}");
            assert!(found.degrees - most < 3.0, "{name} {is_inside}: {found:?} {most}");
        }
    }
}

/// What stays in a cylinder of this radius and depth that is tilted: a hoof, where its bottom is partly dry.
fn hoof(r: f64, h: f64, tilt: f64) -> f64 {
    let tan = f64::tan(tilt);
    let x = r - h / tan;
    if x > -r {
        let half = (r * r - x * x).sqrt();
        tan * (2.0 / 3.0 * half.powi(3) - x * (r * r * (x / r).acos() - x * half))
    } else {
        PI * r * r * (h - r * tan)
    }
}

#[test]
fn a_tilted_cup_by_the_formula_of_a_hoof() {
    for tilt in [0.2, 0.7, 1.1, 1.4] {
        let place = format!(r#", "place": {{ "axis": [0, 1, 0], "angle": {tilt}, "shift": [1, 2, 30] }}"#);
        let m = measured(&cone(3.0, 3.0, 8.0, &format!("{WALL}{place}")));
        near(m.whole.capacity.unwrap().brim, hoof(2.75, 7.5, tilt), 100.0);
        assert_eq!(m.whole.tipping.empty.unwrap().degrees, 0.0);
        assert!(m.whole.footprint.as_ref().unwrap().hull_area.value < 1e-9);
    }
}

/// Upside down a pot holds what is in its recess, whose middle is soon dry and higher than its edge.
#[test]
fn a_tilted_recess_by_the_formula_of_a_hoof() {
    for tilt in [0.05, 0.2, 0.4, 0.5415926535, 0.74, 0.94, 1.2] {
        let foot = r#", "wall": { "thickness": 0.5, "base": 0.5, "foot": [1.5, 0.8] }"#;
        let place = format!(r#", "place": {{ "axis": [1, 0, 0], "angle": {} }}"#, PI - tilt);
        let capacity = measured(&cone(5.0, 5.0, 10.0, &format!("{foot}{place}"))).whole.capacity;
        let capacity = capacity.unwrap_or_else(|| panic!("{tilt}: nothing"));
        near(capacity.brim, hoof(3.5, 0.8, tilt), 100.0);
        assert!((capacity.spill.level.value + 3.5 * tilt.sin()).abs() < 1e-9, "{tilt}: {capacity:?}");
    }
}

/// The water below a level by the midpoint rule, column by column up to the crest.
fn dense(pot: &Pot, level: f64, columns: usize, rows: usize) -> f64 {
    // Height and upward element of every place, from the middle of the floor outwards and up. Row by row, whose places share what depends on the row alone.
    let mut places: Vec<Vec<(f64, f64)>> = vec![Vec::new(); columns];
    for face in pot.faces().iter().rev() {
        if matches!(face.kind(), FaceKind::Floor | FaceKind::Lining | FaceKind::Rim) {
            let mut walk = face.walk();
            for i in (0..rows).rev() {
                for (j, column) in places.iter_mut().enumerate() {
                    let jet = walk.jet((i as f64 + 0.5) / rows as f64, TAU * j as f64 / columns as f64);
                    column.push((jet.position.z, jet.da.cross(jet.dv).z * face.outward()));
                }
            }
        }
    }
    let water = places.iter().map(|column| {
        let crest = (0..column.len()).max_by(|&a, &b| column[a].0.total_cmp(&column[b].0)).unwrap();
        column[..crest].iter().map(|(z, up)| (level - z).max(0.0) * up).sum::<f64>()
    });
    water.sum::<f64>() * TAU / (columns * rows) as f64
}

/// A design of the gallery with a wall in proportion to its height.
fn exhibit(name: &str, rim: &str, extra: &str) -> String {
    let exhibit = gallery().into_iter().find(|exhibit| exhibit.name == name).expect("in the gallery");
    let t = 0.015 * measure(&exhibit.design(), &MeasureOptions::default()).unwrap().whole.height.value;
    let shape = serde_json::to_string(&exhibit.shape).unwrap();
    format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {{ "thickness": {t}, "base": {t}, "rim": "{rim}" }}{extra} }}] }}"#
    )
}

/// What is thinned at a shoulder has a spline for a wall, and a round pot runs over a crest that is level all round.
#[test]
fn a_round_pot_with_a_thinned_wall_holds_water_to_its_rounded_rim() {
    let shape = r#"{ "kind": "fourth-order", "r0": 4.3, "r1": 4.18, "rm": 12.3, "h1": 10.6, "eta": [1.07, 0.441], "dz": [8.98, 3.9], "s": [1.21, 1.21], "t": [2.83, 2.83], "w": [1.28, 1.28] }"#;
    let wall = r#"{ "thickness": 0.688, "base": 0.778, "side": "outside", "rim": "rounded" }"#;
    let json = format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall} }}] }}"#);
    let Capacity { brim, spill, .. } = measured(&json).whole.capacity.expect("water");
    let pot = Pot::new(&design(&json), 0, Product::Pot).unwrap();
    assert!(pot.thinned().is_some());
    let exact = dense(&pot, spill.level.value, 49, 20_000);
    assert!((brim.value - exact).abs() < 1e-6 * exact && brim.error < 1e-6 * exact, "{brim:?} {exact}");
}

#[test]
fn what_is_filled_to_the_spill_is_full() {
    let shape = r#"{ "kind": "mixed-order", "r": [3.45, 0.79, 8.85, 0.572], "n": [1, 4], "height": 20.3, "s": [1, 1], "t": [0.276, 0.276], "force": [-0.0743, -4.95], "rise": -23.9 }"#;
    let wall = r#"{ "thickness": 0.259, "base": 0.371, "side": "outside", "rim": "rounded" }"#;
    let place = r#"{ "scale": [1.23, 0.824, 0.778], "shift": [-16.3, 19.1, 19.2] }"#;
    let design =
        design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, "wall": {wall}, "place": {place} }}] }}"#));
    let filled = |fill: Option<f64>| {
        let options = MeasureOptions { fill, ..MeasureOptions::default() };
        measure(&design, &options).unwrap().whole.capacity.expect("water")
    };
    let full = filled(None);
    let (level, depth) = (full.spill.level.value, full.spill.level.value - full.floor);
    let capacity = filled(Some(level));
    let fill = capacity.fill.expect("it was asked for");
    assert_eq!((capacity.brim, fill.volume, fill.level), (full.brim, full.brim, level));
    // Nor is the work up to the brim missing for less.
    let capacity = filled(Some(level - 1e-3 * depth));
    let less = capacity.fill.expect("it was asked for").volume;
    assert_eq!(capacity.brim, full.brim);
    assert!(less.value < full.brim.value && less.value > 0.99 * full.brim.value, "{less:?}");
}

#[test]
fn dinted_and_petalled_rims_against_a_dense_sum() {
    let leaning = r#", "place": { "axis": [1, 2, 0], "angle": 0.2 }"#;
    for (name, rim, extra) in [
        ("own-dint", "flat", ""),
        ("own-dint", "rounded", leaning),
        ("own-tulip", "rounded", ""),
        ("own-trumpet", "flat", ""),
        ("own-bowl", "rounded", leaning),
    ] {
        let design = design(&exhibit(name, rim, extra));
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        let capacity = measure(&design, &MeasureOptions::default()).unwrap().whole.capacity.unwrap();
        // The midpoint rule is off by what goes with the square of the gap.
        let [coarse, fine] = [200, 400].map(|rows| dense(&pot, capacity.spill.level.value, 331, rows));
        let dense = fine + (fine - coarse) / 3.0;
        let brim = capacity.brim;
        assert!((brim.value - dense).abs() < 1.0 + 3e-6 * dense, "{name} {rim}: {brim:?} {dense}");
        assert!(brim.error < 1e-6 * dense, "{name} {rim}: {brim:?}");
    }
}

/// Twice the volume between faces and origin over three, and the area, by the midpoint rule; extrapolated from two finenesses by Richardson's formula.
fn dense_clay(pot: &Pot, rows: usize, columns: usize) -> [f64; 2] {
    let sum = |rows: usize, columns: usize| {
        let mut sum = [0.0; 2];
        for face in pot.faces() {
            let mut walk = face.walk();
            for i in 0..rows {
                for j in 0..columns {
                    let v = TAU * (j as f64 + 0.5) / columns as f64;
                    let jet = walk.jet((i as f64 + 0.5) / rows as f64, v);
                    let element = jet.da.cross(jet.dv);
                    sum[0] += jet.position.dot(element) * face.outward() / 3.0;
                    sum[1] += element.length();
                }
            }
        }
        sum.map(|sum| sum * TAU / (rows * columns) as f64)
    };
    let (coarse, fine) = (sum(rows, columns), sum(2 * rows, 2 * columns));
    [0, 1].map(|i| fine[i] + (fine[i] - coarse[i]) / 3.0)
}

/// A wall that had to be thinned is a spline whose second derivatives jump from place to place.
#[test]
fn thinned_walls_against_a_dense_sum() {
    let exhibit = table("table-fluted");
    let shape = serde_json::to_string(&exhibit.shape).unwrap();
    let wall = r#""wall": { "thickness": 0.6, "base": 0.6 }"#;
    let design = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}, {wall} }}] }}"#));
    let pot = Pot::new(&design, 0, Product::Pot).unwrap();
    assert!(pot.thinned().is_some());
    let body = measure(&design, &MeasureOptions::default()).unwrap().whole;
    let (clay, capacity) = (body.clay.unwrap(), body.capacity.unwrap());
    // So many columns that the jumps, at odd multiples of a 296th of the turn, are between them.
    let columns = 592;
    let [volume, area] = dense_clay(&pot, 500, columns);
    let level = capacity.spill.level.value;
    let [coarse, fine] = [1, 2].map(|times| dense(&pot, level, times * columns, times * 500));
    for (what, found, dense, within) in [
        ("clay", clay.volume, volume, 1e-6),
        ("area", clay.area, area, 1e-6),
        ("brim", capacity.brim, fine + (fine - coarse) / 3.0, 3e-6),
    ] {
        let off = (found.value - dense).abs() / dense;
        assert!(off < within, "{what} {found:?} {dense} {off:e}");
        assert!((found.value - dense).abs() <= found.error + 1e-7 * dense, "dishonest: {what} {found:?} {dense}");
        assert!(found.error < 4e-5 * dense, "{what} {found:?}");
    }
}

/// The volume of a fine polyhedron whose corners are on the faces, extrapolated from two finenesses.
fn polyhedral_clay(pot: &Pot, columns: usize) -> f64 {
    let sum = |columns: usize| {
        let mut sum = 0.0;
        for face in pot.faces() {
            let rows =
                if matches!(face.kind(), FaceKind::Outer | FaceKind::Lining) { columns / 4 } else { columns / 16 };
            let mut walk = face.walk();
            let mut row = |i: usize| -> Vec<DVec3> {
                let v = |j: usize| TAU * j as f64 / columns as f64;
                (0..columns).map(|j| walk.jet(i as f64 / rows as f64, v(j)).position).collect()
            };
            let mut below = row(0);
            for i in 1..=rows {
                let above = row(i);
                for j in 0..columns {
                    let next = (j + 1) % columns;
                    let (p, q, r, s) = (below[j], below[next], above[j], above[next]);
                    sum += face.outward() * (p.dot(r.cross(s)) + p.dot(s.cross(q))) / 6.0;
                }
                below = above;
            }
        }
        sum
    };
    let (coarse, fine) = (sum(columns), sum(2 * columns));
    fine + (fine - coarse) / 3.0
}

/// Of faces between curves that are sought anew at every `v` few places are taken: the error says what that costs.
#[test]
fn rings_below_thinned_walls_against_a_polyhedron() {
    for seed in [308, 431, 490] {
        let design = design(&Random::new(seed).design());
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        assert!(pot.thinned().is_some() && pot.faces().iter().any(|face| face.kind() == FaceKind::FootRing), "{seed}");
        let found = measure(&design, &MeasureOptions::default()).unwrap().whole.clay.unwrap().volume;
        let dense = polyhedral_clay(&pot, 1000);
        let off = (found.value - dense).abs();
        assert!(off <= found.error + 1e-7 * dense, "dishonest: {seed} {found:?} {dense}");
        assert!(off < 2e-7 * dense && found.error < 1e-5 * dense, "{seed} {found:?} {dense}");
    }
}

/// The gallery's pots, and one that leans.
#[test]
fn water_rises_as_its_surface_says() {
    for (name, extra) in [
        ("own-jar", ""),
        ("own-tulip", ""),
        ("own-leaning", ""),
        ("own-dint", r#", "place": { "axis": [0.3, 1, 0], "angle": 0.3, "shift": [0, 0, -5] }"#),
    ] {
        let pot = Solution::of(&design(&exhibit(name, "flat", extra)));
        let capacity = pot.measure(&MeasureOptions::default()).unwrap().whole.capacity.unwrap();
        let (low, high) = (capacity.floor, capacity.spill.level.value);
        assert_eq!(pot.water(low - 1.0).unwrap(), Default::default());
        let mut before = 0.0;
        for i in 1..=9 {
            let level = low + (high - low) * f64::from(i) / 9.3;
            let d = 1e-3 * (high - low);
            let [below, here, above] = [level - d, level, level + d].map(|level| pot.water(level).unwrap());
            assert!(here.volume > before, "{name}: {level}");
            before = here.volume;
            // The volume is the integral of the surface.
            let slope = (above.volume - below.volume) / (2.0 * d);
            assert!((slope - here.area).abs() < 1e-3 * here.area, "{name} at {i}: {slope} {}", here.area);
            // The triangles cover it, level and facing up.
            let point = |i: u32| DVec3::from_array([0, 1, 2].map(|c| f64::from(here.positions[3 * i as usize + c])));
            let mut sum = 0.0;
            for t in here.indices.chunks(3) {
                let [a, b, c] = [point(t[0]), point(t[1]), point(t[2])];
                let area = 0.5 * (b - a).cross(c - a).z;
                assert!(area >= -1e-6 && (a.z - level).abs() < 1e-5);
                sum += area;
            }
            assert!((sum - here.area).abs() < 5e-3 * here.area, "{name}: {sum} {}", here.area);
        }
        let full = pot.water(high).unwrap();
        assert!((full.volume - capacity.brim.value).abs() <= full.error + capacity.brim.error, "{name}");
    }
}

/// A prism over a rose of five petals.
fn prism(extra: &str) -> String {
    let component = |name: &str, wave: &str, sign: f64| {
        let mode = |n: u32, r: f64| format!(r#"{{ "n": {n}, "{wave}": {{ "start": {r}, "end": {r} }} }}"#);
        format!(
            r#""{name}": {{ "order": 2, "s": 1, "t": 0, "modes": [ {}, {}, {} ] }}"#,
            mode(1, 4.0),
            mode(4, 0.2 * sign),
            mode(6, 0.2)
        )
    };
    let z = r#""z": { "order": 2, "s": 1, "t": 0, "modes": [ { "n": 0, "cos": { "start": 0, "end": 9 } } ] }"#;
    format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": "2pi", {}, {}, {z} }}{extra} }}] }}"#,
        component("x", "cos", 1.0),
        component("y", "sin", -1.0)
    )
}

#[test]
fn clay_and_inside_are_the_outside() {
    for wall in [WALL, r#", "wall": { "thickness": 0.4, "base": 1, "rim": "flat" }"#] {
        let json = prism(wall);
        let pot = measured(&json).whole;
        let solid = MeasureOptions { product: Product::Solid, ..MeasureOptions::default() };
        let solid = measure(&design(&json), &solid).unwrap();
        let (clay, brim) = (pot.clay.unwrap().volume, pot.capacity.unwrap().brim);
        let whole = solid.whole.clay.unwrap().volume;
        near(clay + brim, whole.value, whole.value);
        // r = 4 + 0.4 cos 5 v: the area is pi (16 + 0.08).
        near(whole, 9.0 * PI * 16.08, whole.value);
        assert_eq!(
            (solid.whole.capacity, solid.parts[0].capacity_reason.as_deref()),
            (None, Some("a solid has no inside"))
        );
        // Five petals: the hull of the foot goes from tip to tip.
        let footprint = pot.footprint.unwrap();
        assert!(footprint.hull_area.value > footprint.area.value * 1.02 && footprint.hull_area.error < 1e-4);
    }
}

#[test]
fn turning_and_scaling_change_what_they_should() {
    let wall = |t: f64| format!(r#", "wall": {{ "thickness": {t}, "base": {t} }}"#);
    let one = measured(&prism(&wall(0.4)));
    let turned = measured(&prism(&format!(r#"{}, "place": {{ "angle": 0.7 }}"#, wall(0.4))));
    let twice = measured(&prism(&format!(r#"{}, "place": {{ "scale": [2, 2, 2] }}"#, wall(0.8))));
    let scalars = |m: &Measures| {
        let (w, c, k) = (&m.whole, m.whole.clay.unwrap(), m.whole.capacity.unwrap());
        let footprint = w.footprint.as_ref().unwrap();
        [
            (w.height.value, 1),
            (w.width.least.value, 1),
            (w.width.greatest.value, 1),
            (w.area.value, 2),
            (c.area.value, 2),
            (c.volume.value, 3),
            (c.mass.value, 3),
            (k.brim.value, 3),
            (k.spill.level.value, 1),
            (w.centre.full.unwrap().at[2], 1),
            (footprint.area.value, 2),
            (w.tipping.empty.unwrap().degrees, 0),
            (w.tipping.full.unwrap().degrees, 0),
            (m.parts[0].curvature.mean.least.unwrap().value, -1),
            (m.parts[0].curvature.mean.greatest.unwrap().value, -1),
        ]
    };
    for ((a, b), (c, power)) in scalars(&one).iter().zip(scalars(&turned)).zip(scalars(&twice)) {
        assert!((a.0 - b.0).abs() < 1e-9 * a.0.abs().max(1e-3), "turned: {a:?} {b:?}");
        assert!((a.0 * 2f64.powi(power) - c).abs() < 1e-9 * c.abs().max(1e-3), "scaled: {a:?} {c}");
    }
    let inches = measured(&prism(&wall(0.4)).replacen("{", r#"{ "unit": "in", "#, 1));
    let grams = |m: &Measures| m.whole.clay.unwrap().mass.value;
    assert!((grams(&inches) / grams(&one) - 2.54f64.powi(3)).abs() < 1e-9);
}

#[test]
fn several_parts_are_added_up() {
    let part = |json: &str| json[json.find("[{ ").unwrap() + 1..json.len() - 3].to_owned();
    let cup = part(&cone(3.0, 3.0, 8.0, WALL));
    let far = cup.replace(r#", "wall""#, r#", "name": "far", "place": { "shift": [20, 0, 0] }, "wall""#);
    let bare = part(&cone(3.0, 3.0, 2.0, ""));
    let one = measured(&format!(r#"{{ "pasu": 1, "parts": [{cup}] }}"#)).whole;
    let all = measured(&format!(r#"{{ "pasu": 1, "parts": [{cup}, {far}, {bare}] }}"#));
    let (a, b) = (&one, &all.whole);
    near(b.clay.unwrap().mass, 2.0 * a.clay.unwrap().mass.value, 1000.0);
    near(b.capacity.unwrap().brim, 2.0 * a.capacity.unwrap().brim.value + 18.0 * PI, 1000.0);
    near(b.width.greatest, 26.0, 26.0);
    near(b.width.least, 6.0, 6.0);
    assert!((b.centre.empty.unwrap().at[0] - 10.0).abs() < 1e-9);
    assert_eq!(all.parts[1].name.as_deref(), Some("far"));
    assert!(b.tipping.empty.unwrap().degrees - a.tipping.empty.unwrap().degrees > -1e-9);
}

#[test]
fn what_cannot_be_a_pot_still_has_measures() {
    let open = measured(
        r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [1, 0.1, 0.6, 0.06], "n": [0.5, 8] }, "wall": { "thickness": 0.05, "base": 0.1 } }] }"#,
    );
    assert!(open.whole.height.value > 3.0 && open.whole.capacity.is_none() && open.whole.clay.is_none());
    assert!(open.parts[0].reason.is_some() && open.parts[0].capacity_reason.is_some());
    let tube = measured(&cone(3.0, 3.0, 8.0, r#", "wall": { "thickness": 0.25, "base": 0 }"#));
    near(tube.whole.clay.unwrap().volume, PI * (9.0 - 2.75 * 2.75) * 8.0, 100.0);
    assert!(tube.whole.capacity.is_none() && tube.parts[0].capacity_reason.as_ref().unwrap().contains("tube"));
    let planter = measured(&cone(3.0, 3.0, 8.0, r#", "wall": { "thickness": 0.25, "base": 0.5, "drain": 1 }"#));
    let capacity = planter.whole.capacity.unwrap();
    near(capacity.brim, PI * 2.75 * 2.75 * 7.5, 100.0);
    assert!(capacity.stopped);
}

#[test]
fn colours_have_one_number_for_each_vertex() {
    let options = MeshOptions { rows: Some(9), columns: Some(13), tolerance: None };
    let cup = design(&cone(3.0, 3.0, 8.0, WALL));
    for (map, value) in
        [(Map::MeanCurvature, 1.0 / 6.0), (Map::GaussianCurvature, 0.0), (Map::Thickness, 0.25), (Map::Overhang, 0.0)]
    {
        let values = paint(&cup, map, &options).unwrap();
        assert_eq!(values.len(), mesh(&cup, &options).unwrap().n_vertices());
        assert!(values.iter().all(|x| (f64::from(*x) - value).abs() < 1e-7), "{map:?} {values:?}");
    }
    // A pole: the apex of a bowl, at u = 0, bends alike in every direction and faces down.
    let bowl = design(&paraboloid(3.0, 4.0, ""));
    let apex = 8.0 / 9.0;
    for (map, value) in [(Map::MeanCurvature, apex), (Map::GaussianCurvature, apex * apex), (Map::Overhang, 90.0)] {
        let values = paint(&bowl, map, &options).unwrap();
        assert!(values[..13].iter().all(|x| (f64::from(*x) - value).abs() < 1e-3), "{map:?} {values:?}");
    }
    assert!(paint(&bowl, Map::Thickness, &options).is_err());
    for exhibit in gallery() {
        let options = MeshOptions { columns: Some(40), ..MeshOptions::default() };
        let (design, n) = (exhibit.design(), mesh(&exhibit.design(), &options).unwrap().n_vertices());
        for map in [Map::MeanCurvature, Map::GaussianCurvature, Map::Overhang] {
            let values = paint(&design, map, &options).unwrap();
            assert!(values.len() == n && values.iter().all(|x| x.is_finite()), "{}", exhibit.name);
        }
    }
}

#[test]
fn scaled_to_a_size() {
    let cup = design(&cone(3.0, 3.0, 8.0, WALL));
    let brim = PI * 2.75 * 2.75 * 7.5;
    for (size, factor) in [(Size::Height(4.0), 0.5), (Size::Width(12.0), 2.0), (Size::Capacity(27.0 * brim), 3.0)] {
        let making = Making { size: Some(size), shrinkage: 20.0, ..Making::default() };
        let scale = making.scale(&cup).unwrap();
        assert!((scale.size - factor).abs() < 1e-10 && (scale.millimetres - factor * 12.5).abs() < 1e-9, "{scale:?}");
    }
    let tube = design(&cone(3.0, 3.0, 8.0, r#", "wall": { "thickness": 0.25, "base": 0 }"#));
    let making = Making { size: Some(Size::Capacity(1.0)), ..Making::default() };
    let error = making.scale(&tube).unwrap_err();
    assert_eq!((error.code().as_str(), error.path()), ("no-room", "size.capacity"));
}

#[test]
fn the_json_is_complete() {
    let json = measured(&cone(3.0, 5.0, 8.0, WALL)).to_json();
    let value: serde_json::Value = serde_json::from_str(&json).unwrap();
    for path in [
        "/unit",
        "/product",
        "/height/value",
        "/height/error",
        "/bottom",
        "/top",
        "/width/least/value",
        "/width/greatestDirection",
        "/area/value",
        "/clay/area/value",
        "/clay/volume/error",
        "/clay/mass/value",
        "/capacity/brim/value",
        "/capacity/spill/level/value",
        "/capacity/spill/at/2",
        "/capacity/floor",
        "/capacity/stopped",
        "/centre/empty/at/0",
        "/centre/full/error",
        "/footprint/level",
        "/footprint/area/value",
        "/footprint/hullArea/value",
        "/footprint/hull/0/1",
        "/tipping/empty/degrees",
        "/tipping/empty/error",
        "/tipping/full/toward",
        "/parts/0/part",
        "/parts/0/isPot",
        "/parts/0/thickness/asked",
        "/parts/0/thickness/least/value",
        "/parts/0/thickness/least/error",
        "/parts/0/thickness/greatest/value",
        "/parts/0/thickness/greatest/error",
        "/parts/0/thickness/thinned/value",
        "/parts/0/thickness/thinned/error",
        "/parts/0/overhang/degrees",
        "/parts/0/overhang/error",
        "/parts/0/overhang/face",
        "/parts/0/overhangInside/at/0",
        "/parts/0/curvature/mean/least/value",
        "/parts/0/curvature/mean/least/error",
        "/parts/0/curvature/gaussian/greatest/at/2",
    ] {
        assert!(value.pointer(path).is_some_and(|found| !found.is_null()), "{path} in {json}");
    }
    for path in ["/capacity/fill", "/parts/0/name", "/parts/0/reason", "/parts/0/capacityReason"] {
        assert!(value.pointer(path).is_some_and(|found| found.is_null()), "{path} in {json}");
    }
}

#[test]
fn every_gallery_design_is_measured() {
    for exhibit in gallery() {
        let m = measure(&exhibit.design(), &MeasureOptions::default()).unwrap();
        let brim = m.whole.capacity.expect(&exhibit.name).brim;
        assert!(brim.value > 0.0 && brim.error < 1e-6 * brim.value, "{}: {brim:?}", exhibit.name);
        assert!(m.whole.area.error < 1e-8 * m.whole.area.value, "{}: {:?}", exhibit.name, m.whole.area);
    }
}
