//! Blends that were meant to break, take for ever or lie: each kind of bad input a dozen times.

use pasu::{
    CellsOptions, Code, Design, Error, InsideMap, Making, MeasureOptions, Measures, MeshOptions, Product, cells, check,
    evaluate, inside, inside_values, measure, mesh, solid,
};
use serde_json::{Value, json};

/// An outline whose `x` is a sum of sines and whose `y` is the same of cosines.
fn waves(pairs: &[(f64, f64)], z: f64, [taper, dz]: [f64; 2]) -> Value {
    let series = |name: &str| -> Vec<Value> { pairs.iter().map(|(n, by)| json!({ "n": n, name: by })).collect() };
    json!({ "form": "outline", "x": series("sin"), "y": series("cos"), "z": z, "taper": taper, "dz": dz })
}

fn section(form: &str, radius: [f64; 2], z: f64, [taper, dz]: [f64; 2]) -> Value {
    json!({ "form": form, "radius": radius, "z": z, "taper": taper, "dz": dz })
}

fn disc(z: f64, dz: f64) -> Value {
    section("disc", [1.0, 1.0], z, [0.0, dz])
}

/// A disc of the same size with its middle four radii away.
fn beside([taper, dz]: [f64; 2]) -> Value {
    json!({ "form": "outline", "x": [{ "n": 0, "cos": 4 }, { "n": 1, "sin": 1 }], "y": [{ "n": 1, "cos": 1 }], "z": 0, "taper": taper, "dz": dz })
}

fn design(start: &Value, end: &Value, more: &Value) -> Design {
    let mut shape = json!({ "kind": "blend", "start": start, "end": end });
    more.as_object().into_iter().flatten().for_each(|(name, value)| shape[name] = value.clone());
    Design::parse(&json!({ "pasu": 1, "parts": [{ "shape": shape }] }).to_string()).unwrap()
}

const MAKING: Making =
    Making { product: Product::Solid, tolerance: None, size: None, shrinkage: 0.0, craft: None, union: false };

/// The refusal of whatever is asked of a design that cannot be solved.
fn refusals(design: &Design) -> [Option<Error>; 4] {
    [
        evaluate(design, 0, &[0.3, 0.4, 0.5]).err(),
        mesh(design, &MeshOptions::default()).err(),
        measure(design, &MeasureOptions::default()).err(),
        solid(design, &MAKING).err(),
    ]
}

#[test]
fn sections_that_run_through_themselves_are_refused_with_the_place() {
    let mut outlines: Vec<Value> = [2.0, 3.0, 7.0].map(|n| waves(&[(n, 1.0)], 0.0, [0.0, 2.0])).to_vec();
    outlines.push(waves(&[(1.0, 1.0), (2.0, 0.8)], 0.0, [0.0, 2.0]));
    outlines.push(waves(&[(1.0, 0.3), (6.0, 1.0)], 0.0, [0.0, 2.0]));
    // A loop that is a hundredth of the outline, and one on each of many waves.
    outlines.push(waves(&[(1.0, 1.0), (4.0, 0.3)], 0.0, [0.0, 2.0]));
    outlines.extend([100.0, 128.0, 340.0, 1000.0].map(|n| waves(&[(1.0, 1.0), (n, 0.2)], 0.0, [0.0, 2.0])));
    let eight = |middle: f64| json!({ "form": "outline", "x": [{ "n": 0, "cos": middle }, { "n": 1, "sin": 1 }], "y": [{ "n": 2, "sin": 1 }], "z": 0, "taper": 0, "dz": 2 });
    outlines.extend([eight(0.0), eight(1e-3)]);
    for outline in outlines {
        for (start, end, name) in [(&outline, &disc(2.0, 2.0), "start"), (&disc(2.0, 2.0), &outline, "end")] {
            for error in refusals(&design(start, end, &json!({}))) {
                let error = error.unwrap_or_else(|| panic!("{outline} was taken"));
                assert_eq!((error.code(), error.path()), (Code::CrossesItself, &*format!("parts[0].shape.{name}")));
                assert!(error.place().is_some(), "{error}");
            }
        }
    }
}

#[test]
fn small_loops_on_as_many_waves_as_are_drawn_are_refused() {
    for n in [341.0, 342.0, 512.0, 700.0, 1000.0, 1024.0] {
        let outline = |by: f64| waves(&[(1.0, 1.0), (n, by / n)], 0.0, [0.0, 2.0]);
        let found = |by: f64| evaluate(&design(&outline(by), &disc(2.0, 2.0), &json!({})), 0, &[0.3, 0.4, 0.5]);
        // From 1 on it turns back on every wave.
        assert_eq!(found(1.1).unwrap_err().code(), Code::CrossesItself, "{n}");
        found(0.9).unwrap_or_else(|error| panic!("{n}: {error}"));
    }
}

#[test]
fn sections_beyond_numbers_are_refused_for_their_size() {
    for form in ["disc", "rectangle", "disc-in-square"] {
        for (start, end, name) in [(1e300, 1.0, "start"), (1.0, 1e300, "end")] {
            let of = |radius: f64, z: f64| section(form, [radius, radius], z, [0.0, 2.0]);
            for error in refusals(&design(&of(start, 0.0), &of(end, 2.0), &json!({}))) {
                let error = error.unwrap_or_else(|| panic!("a {form} of 1e300 was taken"));
                assert_eq!(
                    (error.code(), error.path()),
                    (Code::Overflow, &*format!("parts[0].shape.{name}")),
                    "{error}"
                );
            }
        }
    }
    let far = json!({ "form": "outline", "x": [{ "n": 0, "cos": 1e300 }, { "n": 1, "sin": 1 }], "y": [{ "n": 1, "cos": 1 }], "z": 0, "taper": 0, "dz": 2 });
    let error = evaluate(&design(&far, &disc(2.0, 2.0), &json!({})), 0, &[0.3, 0.4, 0.5]).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::Overflow, "parts[0].shape.start"), "{error}");
}

#[test]
fn sides_that_lie_in_one_another_are_refused_with_the_place() {
    let design = design(&disc(0.0, 2.0), &section("rectangle", [1.0, 1.0], 2.0, [0.0, 2.0]), &json!({}));
    let error = solid(&design, &MAKING).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::CrossesItself, "parts[0].shape"), "{error}");
    let [x, y, z] = error.place().unwrap();
    assert!(x.abs() <= 1.01 && y.abs() <= 1.01 && (-0.01..2.01).contains(&z), "{error}");
}

#[test]
fn sections_that_lie_in_each_other_or_have_no_height_are_refused() {
    let cross = |radius: [f64; 2], dz: f64| section("rectangle", radius, 0.0, [0.0, dz]);
    for (start, end) in [
        (disc(0.0, 2.0), section("disc", [0.5, 0.5], 0.0, [0.0, -2.0])),
        (disc(0.0, 0.0), section("disc", [0.5, 0.5], 0.0, [0.0, 0.0])),
        (cross([3.0, 0.5], 2.0), cross([0.5, 3.0], -2.0)),
        (cross([3.0, 0.001], 2.0), cross([0.001, 3.0], -2.0)),
    ] {
        for error in refusals(&design(&start, &end, &json!({}))) {
            let error = error.unwrap_or_else(|| panic!("{start}, {end} were taken"));
            assert_eq!((error.code(), error.path()), (Code::CrossesItself, "parts[0].shape.end.z"), "{error}");
            assert!(error.place().is_some(), "{error}");
        }
    }
    // Beside each other, but nothing leaves the plane.
    for error in refusals(&design(&disc(0.0, 0.0), &beside([0.5, 0.0]), &json!({}))) {
        let error = error.expect("a solid without height was taken");
        assert_eq!((error.code(), error.path()), (Code::PinchedSurface, "parts[0].shape.end.z"), "{error}");
    }
}

#[test]
fn equal_heights_with_tangents_that_fold_are_told_with_the_place() {
    for (start, end) in [
        (disc(0.0, 5.0), beside([0.0, 5.0])),
        (disc(0.0, 5.0), beside([0.0, -5.0])),
        (disc(0.0, 5.0), beside([4.0, -5.0])),
        (disc(0.0, -5.0), beside([0.0, 5.0])),
        (disc(0.0, 1e6), beside([0.0, 1e6])),
        // Not equal, but not far from it.
        (disc(0.0, 30.0), disc(1.0, 30.0)),
    ] {
        let design = design(&start, &end, &json!({}));
        mesh(&design, &MeshOptions::default()).unwrap().validate().unwrap();
        let report = check(&design, &MAKING).unwrap();
        assert!(!report.is_ok() && report.findings[0].at.is_some(), "{start}, {end}: {:?}", report.findings);
        let error = solid(&design, &MAKING).unwrap_err();
        assert_eq!((error.code(), error.path()), (Code::CrossesItself, "parts[0].shape"), "{error}");
        assert!(error.place().is_some() && inside(&design, 0).unwrap().is_folded());
    }
}

#[test]
fn waves_and_weights_without_an_end_are_refused_at_once() {
    let too_fine = |design: &Design, path: &str| {
        let making = [measure(design, &MeasureOptions::default()).err(), solid(design, &MAKING).err()];
        for error in making {
            let error = error.expect("it can only be drawn");
            assert_eq!((error.code(), error.path()), (Code::TooLarge, path), "{error}");
        }
        // Drawing it is a mesh of more vertices than there can be, which takes no trying.
        assert_eq!(mesh(design, &MeshOptions::default()).unwrap_err().code(), Code::TooLarge);
        assert!(evaluate(design, 0, &[0.3, 0.4, 0.5]).unwrap().iter().all(|x| x.is_finite()));
    };
    for n in [1e9, 1e11] {
        // Away from the middle and back, so that it runs through itself nowhere.
        let mut outline = waves(&[(1.0, 1.0), (n - 1.0, 1e-3), (n + 1.0, 1e-3)], 0.0, [0.0, 2.0]);
        outline["x"][1]["sin"] = json!(-1e-3);
        let fine = design(&outline, &disc(2.0, 2.0), &json!({}));
        too_fine(&fine, "parts[0].shape.start.x[1].n");
        assert_eq!(mesh(&fine, &MeshOptions::default()).unwrap_err().path(), "parts[0].shape.start.x[1].n");
    }
    // So small that few lines would do, but hundreds of waves, each looked at in every cell.
    let mut many: Vec<(f64, f64)> = (0..511).map(|k| (1e6 + 1e6 * f64::from(k), 1e-13)).collect();
    many.insert(0, (1.0, 1.0));
    let fine = design(&waves(&many, 0.0, [0.0, 2.0]), &disc(2.0, 2.0), &json!({}));
    too_fine(&fine, "parts[0].shape.start.x[1].n");
    let oval = section("disc", [2.0, 1.0], 3.0, [0.0, 2.0]);
    too_fine(&design(&disc(0.0, 2.0), &oval, &json!({ "weights": [1, 1e300, 1] })), "parts[0].shape.weights");
    // More waves than are made are drawn, up to 1024.
    for (n, is_drawn) in [(1024.0, true), (1025.0, false)] {
        let outline = waves(&[(1.0, 1.0), (n, 1e-6)], 0.0, [0.0, 2.0]);
        let fine = design(&outline, &disc(2.0, 2.0), &json!({}));
        assert_eq!(mesh(&fine, &MeshOptions { tolerance: Some(0.01), ..MeshOptions::default() }).is_ok(), is_drawn);
    }
    let outline = waves(&[(1.0, 1.0), (200.0, 1e-4)], 0.0, [0.0, 2.0]);
    let fine = design(&outline, &disc(2.0, 2.0), &json!({}));
    mesh(&fine, &MeshOptions { tolerance: Some(0.01), ..MeshOptions::default() }).unwrap();
    assert_eq!(measure(&fine, &MeasureOptions::default()).unwrap_err().path(), "parts[0].shape.start.x[1].n");
}

/// A section with every wave up to `most`, none of which is deep.
fn all_waves(most: usize, z: f64) -> Value {
    let by = |n: usize| if n == 1 { 1.0 } else { 0.01 / (n * n) as f64 };
    let series = |names: [&str; 2], share: f64| -> Vec<Value> {
        let wave = |n: usize| json!({ "n": n, names[0]: by(n), names[1]: if n == 1 { 0.0 } else { share * by(n) } });
        (1..=most).map(wave).collect()
    };
    json!({ "form": "outline", "x": series(["sin", "cos"], 0.3), "y": series(["cos", "sin"], -0.2), "z": z, "taper": 0, "dz": 2 })
}

#[test]
fn outlines_of_as_many_waves_as_are_made_are_measured_or_refused_beforehand() {
    let solid = design(&all_waves(128, 0.0), &all_waves(128, 3.0), &json!({}));
    let Measures { whole, .. } = measure(&solid, &MeasureOptions::default()).unwrap();
    let clay = whole.clay.unwrap();
    // What goes round the clay is the surface itself, and is integrated once.
    assert_eq!(whole.area, clay.area);
    // By the triangles of a file.
    let mesh = &pasu::solid(&solid, &Making { tolerance: Some(0.002), ..MAKING }).unwrap()[0];
    let corner = |index: u32| {
        glam::DVec3::from_array(core::array::from_fn(|i| f64::from(mesh.positions[3 * index as usize + i])))
    };
    let triangles = mesh.indices.chunks_exact(3).map(|at| [corner(at[0]), corner(at[1]), corner(at[2])]);
    let sum = triangles.map(|[a, b, c]| [(b - a).cross(c - a).length() / 2.0, a.dot(b.cross(c)) / 6.0]);
    let [area, volume] = sum.fold([0.0; 2], |sum, one| [sum[0] + one[0], sum[1] + one[1]]);
    let scale = solid.unit().millimetres();
    let off = [area / scale.powi(2) / clay.area.value, volume / scale.powi(3) / clay.volume.value];
    assert!(off.iter().all(|part| (part - 1.0).abs() < 0.01), "{off:?}");

    let mut vessel: Value = serde_json::from_str(&solid.to_json()).unwrap();
    vessel["parts"][0]["wall"] = json!({ "thickness": 0.05, "base": 0.05 });
    let vessel = Design::parse(&vessel.to_string()).unwrap();
    // Of all the work that it would take none is begun.
    let told = std::rc::Rc::new(core::cell::Cell::new(0));
    let count = std::rc::Rc::clone(&told);
    let progress = move |_| {
        count.set(count.get() + 1);
        core::ops::ControlFlow::Continue(())
    };
    let error = pasu::watched(progress, || measure(&vessel, &MeasureOptions::default())).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::TooLarge, "parts[0].wall"), "{error}");
    assert!(told.get() <= 2, "{} times told how far it is", told.get());
    assert!(check(&vessel, &Making::default()).unwrap().is_ok());
}

#[test]
fn sines_that_do_not_see_a_wave_are_told_with_the_place() {
    let outline = waves(&[(1.0, 1.0), (8.0, 0.02)], 0.0, [0.0, 2.0]);
    let of = |method: &str, m: u32| design(&outline, &disc(3.0, 2.0), &json!({ "method": method, "terms": [4, m, 3] }));
    let farthest = |design: &Design| {
        let at: Vec<f64> =
            (0..16 * 64).flat_map(|i| [f64::from(i % 16) / 16.0, f64::from(i / 16) / 64.0, 0.5]).collect();
        let points = evaluate(design, 0, &at).unwrap();
        points.chunks_exact(3).map(|p| p[0].hypot(p[1])).fold(0.0, f64::max)
    };
    let options = CellsOptions { counts: [4, 32, 4], ..CellsOptions::default() };
    for method in ["modal", "collocation"] {
        for (m, is_told) in [(15, true), (16, false)] {
            let design = of(method, m);
            let report = check(&design, &MAKING).unwrap();
            let told = report.findings.iter().find(|finding| finding.code == "few-terms");
            assert_eq!(told.is_some(), is_told, "{method} {m}");
            let refused = cells(&design, 0, &options).err();
            assert_eq!(refused.is_some(), is_told, "{method} {m}: {refused:?}");
            if let (Some(told), Some(refused)) = (told, refused) {
                assert_eq!(told.path.as_deref(), Some("parts[0].shape.terms"));
                assert!(told.at.is_some() && report.is_ok());
                assert_eq!((refused.code(), refused.path()), (Code::OutOfRange, "parts[0].shape.terms[1]"));
            }
        }
    }
    // Where v resists little the sines hardly move anything, seen or not.
    let little = json!({ "method": "modal", "weights": [1, 1e-4, 1] });
    cells(&design(&outline, &disc(3.0, 2.0), &little), 0, &options).unwrap();
    // Why: with a few terms the inside is nowhere near the skin.
    let wild = design(
        &waves(&[(1.0, 1.0), (128.0, 1e-4)], 0.0, [0.0, 2.0]),
        &disc(3.0, 2.0),
        &json!({ "method": "modal", "terms": [32, 32, 3] }),
    );
    assert!(farthest(&wild) > 100.0, "{}", farthest(&wild));
    let told = check(&wild, &MAKING).unwrap();
    let at = told.findings.iter().find(|finding| finding.code == "few-terms").unwrap().at.unwrap();
    assert!(at[0].hypot(at[1]) > 10.0, "{at:?}");
    // More waves than are made are refused for that.
    let fine = design(
        &waves(&[(1.0, 1.0), (512.0, 1e-5)], 0.0, [0.0, 2.0]),
        &disc(3.0, 2.0),
        &json!({ "method": "modal", "terms": [32, 32, 3] }),
    );
    let error = cells(&fine, 0, &options).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::TooLarge, "parts[0].shape.start.x[1].n"), "{error}");
    // Where every harmonic is solved by itself there is nothing to see.
    cells(&design(&outline, &disc(3.0, 2.0), &json!({ "weights": [1, 0.001, 1] })), 0, &options).unwrap();
}

#[test]
fn a_residual_beyond_all_numbers_is_refused() {
    let half = |z: f64| section("disc-in-square", [1.0, 2.0], z, [0.3, 2.0]);
    let design = design(&half(0.0), &half(2.0), &json!({ "weights": [1e300, 1, 1] }));
    let error = inside(&design, 0).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::Overflow, "parts[0].shape.weights"), "{error}");
    // What does not take the weights is still told.
    assert!(inside_values(&design, 0, InsideMap::Jacobian, &[0.5, 0.5, 0.5]).unwrap()[0].is_finite());
}

#[test]
fn the_most_terms_end_and_more_are_refused() {
    let half = section("disc-in-square", [1.0, 2.0], 0.0, [0.3, 2.0]);
    let flat = section("rectangle-reversed", [1.0, 2.0], 2.0, [0.3, 2.0]);
    for (method, terms) in
        [("collocation", [64, 64, 64]), ("collocation", [256, 16, 64]), ("modal", [16, 256, 1]), ("modal", [64, 64, 1])]
    {
        let design = design(&half, &flat, &json!({ "method": method, "terms": terms }));
        let found = evaluate(&design, 0, &[0.3, 0.4, 0.5, 0.7, 0.1, 0.2]).unwrap();
        assert!(found.iter().all(|x| x.is_finite()), "{method} {terms:?}: {found:?}");
    }
    for terms in [json!([65, 64, 1]), json!([256, 256, 64]), json!([1e300, 1, 1]), json!([4, 4, 65]), json!([4, 4, -1])]
    {
        let shape = json!({ "kind": "blend", "start": half, "end": flat, "method": "collocation", "terms": terms });
        let error = Design::parse(&json!({ "pasu": 1, "parts": [{ "shape": shape }] }).to_string()).unwrap_err();
        assert!([Code::TooLarge, Code::OutOfRange].contains(&error.code()), "{terms}: {error}");
    }
}

#[test]
fn values_do_not_depend_on_the_order_of_the_points() {
    let start = section("rectangle", [1.0, 2.0], 0.0, [0.3, 2.0]);
    let design = design(&start, &disc(3.0, 2.0), &json!({ "terms": [5, 4, 3] }));
    let points: Vec<[f64; 3]> = (0..60).map(|i| [7, 11, 3].map(|step| f64::from(i * step % 10) / 10.0)).collect();
    for map in InsideMap::ALL {
        let together = inside_values(&design, 0, map, &points.concat()).unwrap();
        for (point, value) in points.iter().zip(&together) {
            let alone = inside_values(&design, 0, map, point).unwrap();
            assert_eq!(alone[0].to_bits(), value.to_bits(), "{map:?} at {point:?}");
        }
    }
}
