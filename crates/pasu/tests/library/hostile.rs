//! What outsiders found that took too long, broke or lied: each case of `tests/reference/hostile.json` by its name.
//!
//! What its time buys: what once took minutes is done to its end, because that it ends is what is tested.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::time::{Duration, Instant};

use pasu::{
    Code, Design, Error, Format, Making, MeasureOptions, MeshOptions, Product, SketchOptions, check, measure, mesh,
    sketch, water, write,
};
use serde_json::Value;

const CASES: &str = include_str!("../reference/hostile.json");

/// What is refused is refused at once, however busy the machine.
const AT_ONCE: Duration = Duration::from_secs(10);

/// Many times what an ordinary pot takes: this is to notice minutes.
const SOON: Duration = Duration::from_secs(180);

/// The most bytes of a template.
const PAPER: usize = 4 << 20;

fn cases() -> Vec<Value> {
    serde_json::from_str(CASES).expect("the cases are JSON")
}

/// Whether a quantity anywhere has no finite value or error: as JSON has it, null.
fn has_hole(value: &Value) -> bool {
    match value {
        Value::Object(fields) => fields.iter().any(|(name, value)| {
            value.is_null() && matches!(name.as_str(), "value" | "error" | "degrees") || has_hole(value)
        }),
        Value::Array(items) => items.iter().any(has_hole),
        _ => false,
    }
}

/// Runs a call; the refusal, if it is one.
fn call(what: &str, design: &Design) -> Option<Error> {
    let product = if what.contains("product solid") { Product::Solid } else { Product::Pot };
    let making = Making { product, ..Making::default() };
    match what.split(',').next().unwrap_or_default() {
        "measure" => match measure(design, &MeasureOptions::default()) {
            Ok(measures) => {
                let told = measures.to_json();
                assert!(!has_hole(&serde_json::from_str(&told).unwrap()), "{told}");
                None
            }
            Err(error) => Some(error),
        },
        "check" => check(design, &making).err(),
        "sketch" => sketch(design, &SketchOptions { fill: Some(0.5), ..SketchOptions::default() }).err(),
        "water" => {
            let mut refusal = None;
            for level in [-1.0, 0.0, 1.0, 3.0] {
                match water(design, level) {
                    Ok(water) => assert!(water.volume >= -water.error && water.area >= 0.0, "{water:?}"),
                    Err(error) => refusal = Some(error),
                }
            }
            refusal
        }
        "write svg" => match write(design, Format::Svg, &making) {
            Ok(bytes) => {
                assert!(bytes.len() < PAPER, "{} bytes", bytes.len());
                None
            }
            Err(error) => Some(error),
        },
        "write step" => write(design, Format::Step, &making).err(),
        other => panic!("{other}"),
    }
}

/// The case of this name: its call ends in time, with numbers or with a refusal that says where and why. `path` is where it is refused, if it is to be.
fn judge(name: &str, path: Option<&str>) {
    let case = cases().into_iter().find(|case| case["name"] == name).expect("a case of this name");
    let input = case["input"].as_str().map_or_else(|| case["input"].to_string(), str::to_owned);
    // What was valid stays so: it is read, has its link, and is drawn.
    let design = Design::parse(&input).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(Design::parse(&design.link()).unwrap(), design);
    let start = Instant::now();
    let (refusal, told) = counted(case["call"].as_str().unwrap(), &design);
    let took = start.elapsed();
    if LASTING.contains(&name) {
        assert!(told <= MOST_TOLD, "told {told} times");
    }
    match (&refusal, path) {
        (Some(error), Some(path)) => {
            assert_eq!((error.code(), error.path()), (Code::TooLarge, path), "{error}");
            assert!(took < AT_ONCE, "{took:?}");
        }
        (None, Some(path)) => panic!("is not refused at {path}"),
        (Some(error), None) => assert!(error.code() != Code::Bug && !error.message().is_empty(), "{error}"),
        (None, None) => {}
    }
    assert!(took < SOON, "{took:?}");
}

/// One test for each case, and one that none is left out.
macro_rules! hostile {
    ($( $test:ident: $name:literal $(at $path:literal)?, )+) => {
        $(
            #[test]
            fn $test() {
                judge($name, None$(.or(Some($path)))?);
            }
        )+

        #[test]
        fn every_case_has_a_test() {
            let names = [$( $name, )+];
            for case in cases() {
                assert!(names.iter().any(|name| case["name"] == *name), "{}", case["name"]);
            }
        }
    };
}

hostile! {
    an_area_that_loses_its_petals: "an area that loses its petals" at "parts[0].shape.n[1]",
    ten_thousand_petals: "ten thousand petals" at "parts[0].shape.n[1]",
    a_frequency_of_1e12: "a frequency of 1e12" at "parts[0].shape.x.modes[1].n",
    five_hundred_petals: "five hundred petals with a wall" at "parts[0].shape.n[1]",
    a_thousand_petals: "a thousand petals with a wall" at "parts[0].shape.n[1]",
    a_hundred_thousand_petals: "a hundred thousand petals with a wall" at "parts[0].shape.n[1]",
    a_frequency_of_4e14: "a frequency of 4.3e14" at "parts[0].shape.n[1]",
    a_pot_of_90_m: "a pot of 90 m as a template" at "parts[0]",
    a_template_of_a_solid: "a template of a solid" at "parts[0].shape",
    a_part_that_ends_where_no_other_begins: "a part that ends where no other begins" at "parts[0].shape",
    ordinary_numbers: "ordinary numbers, slowly measured",
    water_in_a_flat_pot: "water in a pot nearly flat in y",
    an_overhang: "an overhang whose error is not finite",
    a_curvature: "a curvature whose error is not finite",
    curvatures: "curvatures that are not finite" at "parts[0].shape",
    a_height: "a height whose error is not finite",
    ordinary_pot_1: "ordinary pot 1, slowly measured",
    ordinary_pot_2: "ordinary pot 2, slowly measured",
    ordinary_pot_3: "ordinary pot 3, slowly measured",
    ordinary_pot_4: "ordinary pot 4, slowly measured",
    ordinary_pot_5: "ordinary pot 5, slowly measured",
    ordinary_pot_6: "ordinary pot 6, slowly measured",
    ordinary_pot_7: "ordinary pot 7, slowly measured",
    ordinary_pot_8: "ordinary pot 8, slowly measured",
    less_than_no_water: "less than no water",
    a_folded_cloth: "a wall on a folded cloth",
    a_thick_wall_on_a_folded_cloth: "a thick wall on a folded cloth",
    a_wall_thicker_than_a_folded_cloth: "a wall thicker than a folded cloth",
    a_wall_far_thicker_than_a_folded_cloth: "a wall a thousand times as thick as a folded cloth",
    triangles_in_one_place: "a wall whose triangles lie in one place",
    forty_petals: "forty petals stretched eighteen times",
    refused_after_every_trial: "a wall that is refused after every trial",
    a_remedy_sought_for_long: "a remedy that is sought for long",
}

/// What went on for minutes.
const LASTING: [&str; 8] = [
    "a wall on a folded cloth",
    "a thick wall on a folded cloth",
    "a wall thicker than a folded cloth",
    "a wall a thousand times as thick as a folded cloth",
    "a wall whose triangles lie in one place",
    "forty petals stretched eighteen times",
    "a wall that is refused after every trial",
    "a remedy that is sought for long",
];

/// How often a watcher may hear of a call on these: as of any pot, about once for a millisecond of work.
const MOST_TOLD: u64 = 2500;

/// Runs a call and counts how often a watcher is told of it; the refusal, if it is one.
fn counted(what: &str, design: &Design) -> (Option<Error>, u64) {
    let told = Rc::new(Cell::new(0));
    let progress = {
        let told = Rc::clone(&told);
        move |_| {
            told.set(told.get() + 1);
            ControlFlow::Continue(())
        }
    };
    let refusal = pasu::watched(progress, || call(what, design).map_or(Ok(()), Err)).err();
    (refusal, told.get())
}

/// Work is counted, not time: as the library tells it to whoever waits. What each case calls itself is counted where that is judged.
#[test]
fn what_went_on_for_minutes_does_a_bounded_work() {
    for name in LASTING {
        let case = cases().into_iter().find(|case| case["name"] == name).expect("a case of this name");
        let design = Design::parse(&case["input"].to_string()).unwrap();
        for what in ["measure", "check", "sketch"].into_iter().filter(|what| case["call"] != *what) {
            // Refused or not: it ends.
            let (_, told) = counted(what, &design);
            assert!(told <= MOST_TOLD, "{name}, {what}: told {told} times");
        }
    }
}

/// Along what is stretched a thousand million times every ray goes all but along the border: each place that was asked took twelve rays of forty thousand cells, and counted for none of them.
#[test]
fn rays_along_a_border_are_paid_for() {
    let vase = r#"{ "shape": { "kind": "second-order", "r": [3, 0, 2, 0], "height": 5 }, "wall": { "thickness": 0.2, "base": 0.3 }, "object": 1 }"#;
    let disc =
        |radius: &str, z: f64| format!(r#"{{ "form": "disc", "radius": {radius}, "z": {z}, "taper": 0.05, "dz": 2 }}"#);
    let (start, end) = (disc("[1.2, 1.1]", 0.0), disc("[0.7, 1e9]", 3.0));
    let turned = r#"{ "axis": [-0.05, 0.16, -0.8], "angle": -0.1, "shift": [-3, -3, -2] }"#;
    let blend = format!(r#"{{ "shape": {{ "kind": "blend", "start": {start}, "end": {end} }}, "place": {turned} }}"#);
    let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{vase}, {blend}] }}"#)).unwrap();
    let told = Rc::new(Cell::new(0));
    let counting = Rc::clone(&told);
    let progress = move |_| {
        counting.set(counting.get() + 1);
        ControlFlow::Continue(())
    };
    pasu::watched(progress, || pasu::constraints(&design, None)).unwrap();
    assert!(told.get() <= MOST_TOLD, "told {} times", told.get());
}

#[test]
fn waves_are_drawn_beyond_what_is_measured() {
    let parse = |n: &str| Design::parse(&format!("#1/second-order?n=1,{n}")).unwrap();
    for n in ["129", "1500", "1e12"] {
        let design = parse(n);
        let options = MeshOptions { rows: Some(9), columns: Some(33), ..MeshOptions::default() };
        assert!(mesh(&design, &options).unwrap().n_triangles() > 0);
        let error = measure(&design, &MeasureOptions::default()).unwrap_err();
        assert_eq!((error.code(), error.path()), (Code::TooLarge, "parts[0].shape.n[1]"));
        assert!(error.message().starts_with("expected at most 128 waves"), "{error}");
    }
    // A grid for so many is larger than a mesh can be, and is not looked for without end.
    assert_eq!(mesh(&parse("1e15"), &MeshOptions::default()).unwrap_err().code(), Code::TooLarge);
    assert!(measure(&parse("128"), &MeasureOptions::default()).is_ok());
    // Petals of no depth are none.
    assert!(measure(&Design::parse("#1/second-order?n=1,1e6&r=1,0,.6,0").unwrap(), &MeasureOptions::default()).is_ok());
}

/// Areas by a rule that knows nothing of errors: Gauss's with 16 nodes on panels of one petal, 160 by 24 of them, which crowd at both ends where the petals fade; how far that may be off comes from half as many.
#[test]
fn areas_of_many_petals_are_those_of_a_finer_rule() {
    for (link, area, off) in [
        ("#1/second-order?n=1,100", 13.522_800_747, 1e-8),
        ("#1/second-order?n=1,8&t=2000,2000", 4.619_832_316_597_154, 1e-13),
    ] {
        let found = measure(&Design::parse(link).unwrap(), &MeasureOptions::default()).unwrap().whole.area;
        assert!((area - found.value).abs() <= found.error + off, "{link}: {area} {found:?}");
        assert!(found.error < 1e-8 * area, "{link}: {area} {found:?}");
    }
}

/// A pot with a wall that stands 1e100 away, or is as large: no message has a number that is none.
#[test]
fn what_is_too_large_or_too_far_is_refused_without_infinities() {
    let rings = r#"{ "kind": "rings", "rings": [{ "u": 0, "r": { "mean": 2 }, "z": { "mean": 0 } }, { "u": 1, "r": { "mean": 2.5 }, "z": { "mean": 5 } }] }"#;
    for exponent in [100, 150, 155, 200, 308] {
        for place in [
            format!("\"shift\": [1e{exponent}, 0, 0]"),
            format!("\"scale\": [1e{exponent}, 1e{exponent}, 1e{exponent}]"),
        ] {
            let part = format!(
                r#"{{ "shape": {rings}, "wall": {{ "thickness": 0.3, "base": 0.3 }}, "place": {{ {place} }} }}"#
            );
            let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{part}] }}"#)).unwrap();
            let solution = pasu::Solution::of(&design);
            let refusals = [
                solution.mesh(&MeshOptions::default()).map(drop),
                solution.solid(&Making::default()).map(drop),
                solution.sketch(&SketchOptions::default()).map(drop),
                solution.constraints(None).map(drop),
            ];
            let mut told: Vec<String> = refusals
                .into_iter()
                .filter_map(|refusal| refusal.err().map(|error| format!("{error} {:?}", error.args())))
                .collect();
            if let Ok(report) = solution.check(&Making::default()) {
                told.push(serde_json::to_string(&report).unwrap());
            }
            for text in told {
                let is_number = !["Infinity", "inf ", "inf)", "NaN"].iter().any(|word| text.contains(word));
                assert!(is_number, "{place}: {text}");
            }
        }
    }
}
