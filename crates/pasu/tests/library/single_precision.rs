//! Meshes in single precision against the same meshes in double precision.

use crate::support::{corpus, design_of, design_of_case, gallery};
use glam::{DVec3, Vec3};
use pasu::{Design, MeshOptions, Sampler, mesh};
use proptest::prelude::*;

/// The promise of `Mesh`: positions in parts of the largest coordinate.
const POSITION_ERROR: f64 = 5e-7;
/// The promise of `Mesh`: normals in radians.
const NORMAL_ERROR: f64 = 1e-6;

/// The largest errors of positions, in parts of the largest coordinate, and of normals, in radians.
fn errors(design: &Design, rows: usize, columns: usize) -> (f64, f64) {
    let options = MeshOptions { rows: Some(rows), columns: Some(columns), tolerance: None };
    let fast = mesh(design, &options).unwrap();
    fast.validate().unwrap();
    // A tolerance is held in double precision, rounded once.
    let exact = mesh(design, &MeshOptions { tolerance: Some(1e30), ..options }).unwrap();
    assert_eq!((&fast.indices, &fast.uvs), (&exact.indices, &exact.uvs));
    let largest = exact.positions.iter().fold(0.0f32, |m, x| m.max(x.abs()));
    let off = fast.positions.iter().zip(&exact.positions).fold(0.0f64, |m, (a, b)| m.max(f64::from(a - b).abs()));
    let vectors = |values: &[f32]| -> Vec<DVec3> {
        values.as_chunks::<3>().0.iter().map(|v| Vec3::from_array(*v).as_dvec3().normalize()).collect()
    };
    let tilt = vectors(&fast.normals)
        .iter()
        .zip(vectors(&exact.normals))
        .fold(0.0f64, |m, (a, b)| m.max(a.cross(b).length().atan2(a.dot(b))));
    // A design may be a point at the origin.
    (off / f64::from(largest.max(f32::MIN_POSITIVE)), tilt)
}

fn check(name: &str, design: &Design, rows: usize, columns: usize) {
    let (position, normal) = errors(design, rows, columns);
    assert!(position <= POSITION_ERROR, "{name}: positions off by {position:e}, {rows} x {columns}");
    assert!(normal <= NORMAL_ERROR, "{name}: normals off by {normal:e}, {rows} x {columns}");
}

/// The same of what is a design and has a mesh.
fn check_if_any(json: &str, rows: usize, columns: usize) {
    if let Ok(design) = Design::parse(json) {
        let options = MeshOptions { rows: Some(rows), columns: Some(columns), tolerance: None };
        if mesh(&design, &options).is_ok() {
            check(json, &design, rows, columns);
        }
    }
}

#[test]
fn figures_and_gallery_keep_the_promise() {
    let figures = corpus().into_iter().map(|case| (case.name.clone(), design_of_case(&case)));
    let figures = figures.map(|(name, design)| (name, design, 0));
    let exhibits = gallery().into_iter().map(|exhibit| (exhibit.name.clone(), exhibit.design(), exhibit.rings().len()));
    let mut worst = (0.0f64, 0.0f64);
    for (name, design, rings) in figures.chain(exhibits) {
        // Quartered, mirrored and too few to be folded; rows by expansions and by themselves.
        for (rows, columns) in [(65, 129), (64, 128), (7, 9), (2, 4), (33, 14), (257, 61)] {
            // Fewer rows than rings are even, and nothing is promised of them.
            if rows < rings {
                continue;
            }
            check(&name, &design, rows, columns);
            let (position, normal) = errors(&design, rows, columns);
            worst = (worst.0.max(position), worst.1.max(normal));
        }
    }
    println!("positions {:e}, normals {:e}", worst.0, worst.1);
}

/// A design of up to so many modes, of any kind, placed.
fn designs() -> impl Strategy<Value = String> {
    let number = || prop_oneof![3 => -2.0..2.0f64, 1 => Just(0.0)];
    let datum = || {
        (prop::array::uniform4(number()), prop::collection::vec(-2.0..2.0f64, 0..3)).prop_map(
            |([a, b, c, d], force)| {
                format!(r#"{{ "start": {a}, "end": {b}, "start_u": {c}, "end_u": {d}, "force": {force:?} }}"#)
            },
        )
    };
    let mode = move || {
        (prop_oneof![3 => (0..9i32).prop_map(f64::from), 1 => (0..70i32).prop_map(f64::from)], datum(), datum(), 0..3)
            .prop_map(|(n, cos, sin, kind)| match kind {
                0 => format!(r#"{{ "n": {n}, "cos": {cos} }}"#),
                1 => format!(r#"{{ "n": {n}, "sin": {sin} }}"#),
                _ => format!(r#"{{ "n": {n}, "cos": {cos}, "sin": {sin} }}"#),
            })
    };
    let component = move || {
        (prop_oneof![Just(2), Just(4)], prop::collection::vec(mode(), 1..7), 0.0..4.0f64, 0.0..3.0f64).prop_map(
            |(order, modes, t, w)| {
                format!(r#"{{ "order": {order}, "s": 1, "t": {t}, "w": {w}, "modes": [{}] }}"#, modes.join(", "))
            },
        )
    };
    let place = prop_oneof![
        Just(String::new()),
        (
            prop::array::uniform3(0.2..3.0f64),
            prop::array::uniform3(-1.0..1.0f64),
            -3.0..3.0f64,
            prop::array::uniform3(-9.0..9.0f64)
        )
            .prop_map(|(scale, axis, angle, shift)| format!(
                r#", "place": {{ "scale": {scale:?}, "axis": {axis:?}, "angle": {angle}, "shift": {shift:?} }}"#
            )),
        prop::array::uniform3(-9.0..9.0f64)
            .prop_map(|shift| format!(r#", "place": {{ "shift": {shift:?}, "scale": [1, -2, 1] }}"#)),
    ];
    (prop_oneof![4 => Just("\"2pi\"".to_owned()), 1 => Just("1".to_owned())], component(), component(), component(), place)
        .prop_map(|(span, x, y, z, place)| {
            format!(
                r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": {span}, "x": {x}, "y": {y}, "z": {z} }}{place} }}] }}"#
            )
        })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn random_designs_keep_the_promise(json in designs(), (rows, columns) in grids()) {
        check_if_any(&json, rows, columns);
    }
}

/// Rows and columns; with many rows some are very near an end, where a surface may be very small.
fn grids() -> impl Strategy<Value = (usize, usize)> {
    prop_oneof![7 => (2..70usize, 4..130usize), 1 => (300..2000usize, 4..20usize)]
}

/// A design whose rows are scaled copies of one outline: one `n` and one equation, or any `n` of equations in which `n` is not.
fn copies() -> impl Strategy<Value = String> {
    let amplitude = || prop_oneof![4 => -2.0..2.0f64, 1 => Just(0.0), 1 => Just(1.0)];
    let datum = || prop::array::uniform4(prop_oneof![3 => -2.0..2.0f64, 1 => Just(0.0)]);
    let equation = prop_oneof![
        (Just((0.0, 0.0)), prop::collection::vec((0..9i32, prop::array::uniform4(amplitude())), 1..5)),
        ((0.0..4.0f64, 0.0..3.0f64), prop::collection::vec((1..9i32, prop::array::uniform4(amplitude())), 1..2)),
    ];
    let scale = prop_oneof![Just([1.0; 3]), prop::array::uniform3(-3.0..3.0f64)];
    (prop_oneof![4 => Just("\"2pi\""), 1 => Just("0.5")], equation, datum(), datum(), scale).prop_map(
        |(span, ((t, w), outline), profile, height, scale)| {
            let scaled = |part: &str, by: f64| {
                let [a, b, c, d] = profile.map(|x| x * by);
                format!(r#""{part}": {{ "start": {a}, "end": {b}, "start_u": {c}, "end_u": {d} }}"#)
            };
            let component = |cos: usize, sin: usize| {
                let modes: Vec<String> = outline
                    .iter()
                    .map(|(n, by)| format!(r#"{{ "n": {n}, {}, {} }}"#, scaled("cos", by[cos]), scaled("sin", by[sin])))
                    .collect();
                format!(r#"{{ "order": 4, "s": 1, "t": {t}, "w": {w}, "modes": [{}] }}"#, modes.join(", "))
            };
            let [a, b, c, d] = height;
            let z = format!(
                r#"{{ "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{{ "n": 0, "cos": {{ "start": {a}, "end": {b}, "start_u": {c}, "end_u": {d} }} }}] }}"#
            );
            let (x, y) = (component(0, 1), component(2, 3));
            format!(
                r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": {span}, "x": {x}, "y": {y}, "z": {z} }}, "place": {{ "scale": {scale:?} }} }}] }}"#
            )
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..ProptestConfig::default() })]

    #[test]
    fn copies_of_an_outline_keep_the_promise(json in copies(), (rows, columns) in grids()) {
        check_if_any(&json, rows, columns);
    }
}

#[test]
fn an_oval_vase_keeps_the_promise_from_pole_to_rim() {
    // Closed to a point at the foot, and level where it is widest: no row is wider than the outline, and at one the slope vanishes.
    let profile = |by: f64| {
        let [a, b, c, d] = [0.0, 0.7 * by, 2.0 * by, -1.5 * by];
        format!(r#"{{ "start": {a}, "end": {b}, "start_u": {c}, "end_u": {d} }}"#)
    };
    let shape = format!(
        r#"{{ "kind": "boundary-value", "span": "2pi",
        "x": {{ "order": 4, "s": 1, "t": 2, "w": 1, "modes": [{{ "n": 1, "cos": {} }}] }},
        "y": {{ "order": 4, "s": 1, "t": 2, "w": 1, "modes": [{{ "n": 1, "sin": {} }}] }},
        "z": {{ "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{{ "n": 0, "cos": {{ "end": 2, "start_u": 2, "end_u": 2 }} }}] }} }}"#,
        profile(1.0),
        profile(0.6)
    );
    let design = design_of(&shape);
    for (rows, columns) in [(65, 129), (64, 128), (7, 9), (2, 4), (513, 62)] {
        check("oval", &design, rows, columns);
    }
}

#[test]
fn a_foot_that_fades_away_keeps_the_promise() {
    // Nothing but the rim is given and `k` is 8 pi: by the foot the rows are 1e-10 of the rim, the difference of two halves as large as it.
    let component = |[end, end_u]: [f64; 2], sine: [f64; 2]| {
        format!(
            r#"{{ "order": 4, "s": 1, "t": 0.88, "w": 0.94, "modes": [{{ "n": 2,
            "cos": {{ "end": {end}, "end_u": {end_u} }}, "sin": {{ "end": {}, "end_u": {} }} }}] }}"#,
            sine[0], sine[1]
        )
    };
    let shape = |z: &str| {
        format!(
            r#"{{ "kind": "boundary-value", "span": 0.5, "x": {}, "y": {},
            "z": {{ "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{{ "n": 0, "cos": {z} }}] }} }}"#,
            component([1.3514, -0.398], [0.0; 2]),
            component([-1.8892, 0.5563], [1.0386, -0.3059])
        )
    };
    for z in [r#"{ "start_u": -1.548 }"#, r#"{ "end": 1 }"#] {
        for (rows, columns) in [(58, 62), (58, 114), (1000, 9), (65, 40)] {
            check(z, &design_of(&shape(z)), rows, columns);
        }
    }
}

#[test]
fn a_grid_that_cannot_tell_two_waves_apart_keeps_the_promise() {
    // In 14 steps round `cos 8v` and `cos 6v` are the same numbers: what is left of both is a fiftieth of either, and the largest coordinate that there is.
    let shape = r#"{ "kind": "boundary-value", "span": "2pi",
        "x": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [] },
        "y": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [
            { "n": 8, "cos": { "start": 1.987, "end": -1.339 } }, { "n": 6, "cos": { "start": -1.939, "end": 1.306 } }] },
        "z": { "order": 4, "s": 1, "t": 1, "w": 1, "modes": [] } }"#;
    for (rows, columns) in [(315, 15), (20, 15), (2, 15), (64, 128)] {
        check("aliased", &design_of(shape), rows, columns);
    }
}

#[test]
fn where_a_flat_sheet_turns_back_its_normals_keep_the_promise() {
    // At a third of the way `z' = 0`, of which rounding leaves either sign.
    let shape = r#"{ "kind": "boundary-value", "span": "2pi",
        "x": { "order": 4, "s": 1, "t": 0, "w": 0.4583889548357203, "modes": [{ "n": 8, "sin": { "end_u": -0.5652119097611386 } }] },
        "y": { "order": 4, "s": 1, "t": 0, "w": 0.4583889548357203, "modes": [] },
        "z": { "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{ "n": 0, "cos": { "start_u": -1.8634755089109516 } }] } }"#;
    for (rows, columns) in [(22, 4), (22, 40), (301, 4)] {
        check("sheet", &design_of(shape), rows, columns);
    }
    // With two components that are the same but for their size and the twelve digits of a design; row 5 is almost where it turns back.
    let shape = r#"{ "kind": "boundary-value", "span": "2pi",
        "x": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{ "n": 1, "sin": { "start": 0.6602327780333497, "end": 2.8227652429654624 } }] },
        "y": { "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{ "n": 1, "sin": { "start": 0.34022809506866697, "end": 1.4546143017935278 } }] },
        "z": { "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{ "n": 0, "cos": {
            "start": 0.009820772838878104, "end": -0.6450480523214672, "start_u": 0.4438647824101613, "end_u": -1.5568153163122576 } }] } }"#;
    check("two sheets", &design_of(shape), 29, 46);
}

#[test]
fn a_harmonic_may_come_twice() {
    let twice = r#"{ "kind": "second-order", "r": [2, 0.5, 1, 0.25], "n": [3, 3] }"#;
    check("twice", &design_of(twice), 33, 65);
}

#[test]
fn a_sampler_gives_what_a_fresh_one_gives() {
    let mut sampler = Sampler::new();
    let grids = [(9, 17), (9, 17), (12, 40), (9, 17)];
    for exhibit in gallery().iter().take(12) {
        for (rows, columns) in grids {
            let options = MeshOptions { rows: Some(rows), columns: Some(columns), tolerance: None };
            let design = exhibit.design();
            assert_eq!(
                sampler.sample(&design, &options).unwrap(),
                &mesh(&design, &options).unwrap(),
                "{}",
                exhibit.name
            );
        }
        let default = MeshOptions::default();
        assert_eq!(sampler.sample(&exhibit.design(), &default).unwrap(), &mesh(&exhibit.design(), &default).unwrap());
    }
}

#[test]
fn after_an_error_a_sampler_is_as_good_as_a_new_one() {
    // Circles to the last row, which single precision cannot hold; the rows before it must not turn up in the next mesh.
    let ring = |end: f64| {
        let axis = |part: &str| {
            format!(
                r#"{{ "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{{ "n": 1, "{part}": {{ "start": 1, "end": {end} }} }}] }}"#
            )
        };
        format!(
            r#"{{ "kind": "boundary-value", "span": "2pi", "x": {}, "y": {},
            "z": {{ "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{{ "n": 0, "cos": {{ "end": 1 }} }}] }} }}"#,
            axis("cos"),
            axis("sin")
        )
    };
    let (beyond, vase) = (design_of(&ring(1e39)), design_of(&ring(0.5)));
    let grid = MeshOptions { rows: Some(40), columns: Some(33), tolerance: None };
    for options in [grid, MeshOptions { tolerance: Some(1.0), ..grid }] {
        let mut sampler = Sampler::new();
        assert_eq!(sampler.sample(&beyond, &grid).unwrap_err().code().as_str(), "overflow");
        assert_eq!(sampler.sample(&vase, &options).unwrap(), &mesh(&vase, &options).unwrap());
    }
}
