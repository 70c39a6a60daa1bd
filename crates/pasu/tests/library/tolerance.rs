//! The promise of a tolerance: measured distances against the bound, and how many vertices it takes.
//!
//! What its time buys: distances sampled between the vertices of meshes of every reference design, which only many points can contradict a bound by.

use std::collections::BTreeMap;

use crate::support::documents::document;
use crate::support::golden::golden;
use crate::support::{Exhibit, corpus, design, design_of_case, gallery};
use glam::{DMat3, DVec3, Vec3};
use pasu::{Design, Mesh, MeshOptions, Surface, bound, mesh};
use proptest::prelude::*;

fn within(tolerance: f64) -> MeshOptions {
    MeshOptions { tolerance: Some(tolerance), ..MeshOptions::default() }
}

/// A mesh of one part beside the exact surface.
struct Measured<'a> {
    mesh: &'a Mesh,
    surface: Surface,
    matrix: DMat3,
    shift: DVec3,
    rows: Vec<f64>,
    columns: usize,
}

impl<'a> Measured<'a> {
    fn new(design: &Design, mesh: &'a Mesh) -> Self {
        let part = &design.parts()[0];
        let columns = 1 + mesh.uvs.chunks_exact(2).position(|uv| uv[1] == 1.0).unwrap();
        let rows = mesh.uvs.chunks_exact(2 * columns).map(|row| f64::from(row[0])).collect();
        let matrix = DMat3::from_cols_array_2d(&part.place.matrix()).transpose();
        let shift = DVec3::from_array(part.place.shift);
        Measured { mesh, surface: Surface::of_part(part, 0).unwrap(), matrix, shift, rows, columns }
    }

    fn exact(&self, u: f64, v: f64) -> DVec3 {
        self.matrix * self.surface.at(u, v * self.surface.span()).position + self.shift
    }

    fn vertex(&self, i: usize, j: usize) -> DVec3 {
        Vec3::from_slice(&self.mesh.positions[3 * (i * self.columns + j)..]).as_dvec3()
    }

    /// The two triangles of a cell; the diagonal runs from its first corner to its last.
    fn triangles(&self, i: usize, j: usize) -> [[DVec3; 3]; 2] {
        let [a, b, c, d] = [self.vertex(i, j), self.vertex(i + 1, j), self.vertex(i + 1, j + 1), self.vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    }

    /// From points of the surface to the triangles near them, the largest distance.
    fn surface_to_triangles(&self, per_cell: usize, skip: usize) -> f64 {
        let mut worst = 0.0f64;
        let n_rows = self.rows.len();
        for i in 0..n_rows - 1 {
            for j in (i % skip..self.columns - 1).step_by(skip) {
                for (a, b) in pairs(per_cell) {
                    let u = self.rows[i] * (1.0 - a) + self.rows[i + 1] * a;
                    let point = self.exact(u.min(1.0), (j as f64 + b) / (self.columns - 1) as f64);
                    let near = i.saturating_sub(1)..=(i + 1).min(n_rows - 2);
                    let distance = near
                        .flat_map(|i| self.triangles(i, j))
                        .map(|triangle| distance_to_triangle(point, triangle))
                        .fold(f64::INFINITY, f64::min);
                    worst = worst.max(distance);
                }
            }
        }
        worst
    }

    /// From points of the triangles to the surface, the largest distance.
    fn triangles_to_surface(&self, per_cell: usize, skip: usize) -> f64 {
        let mut worst = 0.0f64;
        for i in 0..self.rows.len() - 1 {
            for j in (i % skip..self.columns - 1).step_by(skip) {
                for (p, q) in pairs(per_cell) {
                    let [[a, b, c], [_, _, d]] = self.triangles(i, j);
                    let flat =
                        if p >= q { a * (1.0 - p) + b * (p - q) + c * q } else { a * (1.0 - q) + d * (q - p) + c * p };
                    let v = (j as f64 + q) / (self.columns - 1) as f64;
                    // Single precision says where rows are.
                    let (mut from, mut to) = ((self.rows[i] - 1e-7).max(0.0), (self.rows[i + 1] + 1e-7).min(1.0));
                    let off = |u: f64| (self.exact(u, v) - flat).length();
                    for _ in 0..40 {
                        let (one, two) = (from + (to - from) / 3.0, to - (to - from) / 3.0);
                        if off(one) < off(two) { to = two } else { from = one }
                    }
                    worst = worst.max(off(0.5 * (from + to)));
                }
            }
        }
        worst
    }
}

fn pairs(n: usize) -> impl Iterator<Item = (f64, f64)> {
    let at = move |i: usize| i as f64 / n as f64;
    (0..=n).flat_map(move |a| (0..=n).map(move |b| (at(a), at(b))))
}

/// Ericson, *Real-Time Collision Detection*, 5.1.5.
fn distance_to_triangle(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return ap.length();
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return bp.length();
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (ap - ab * (d1 / (d1 - d3))).length();
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return cp.length();
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (ap - ac * (d2 / (d2 - d6))).length();
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return (bp - (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))).length();
    }
    let sum = va + vb + vc;
    if sum > 0.0 {
        (ap - ab * (vb / sum) - ac * (vc / sum)).length()
    } else {
        ap.length().min(bp.length()).min(cp.length())
    }
}

fn size(design: &Design) -> f64 {
    let coarse = mesh(design, &MeshOptions { rows: Some(65), columns: Some(97), tolerance: None }).unwrap();
    coarse.positions.chunks_exact(3).map(|p| Vec3::from_slice(p).length()).fold(0.0, f32::max).into()
}

/// A design, how finely it is sampled, and how many cells are passed over for one that is measured.
fn check(what: &str, design: &Design, options: &MeshOptions, skip: usize) -> f64 {
    let mesh = mesh(design, options).unwrap_or_else(|e| panic!("{what}: {e}"));
    mesh.validate().unwrap_or_else(|e| panic!("{what}: {e}"));
    let promised = bound(design, options).unwrap();
    if let Some(known) = mesh.bound {
        assert_eq!(known, promised, "{what}");
    }
    if let Some(tolerance) = options.tolerance {
        assert!(promised <= tolerance * (1.0 + 1e-12), "{what}: {promised} for {tolerance}");
    }
    let measured = Measured::new(design, &mesh);
    assert_eq!((measured.rows[0], measured.rows[measured.rows.len() - 1]), (0.0, 1.0), "{what}");
    assert!(measured.rows.is_sorted(), "{what}: {:?}", measured.rows);
    let found = measured.surface_to_triangles(4, skip);
    assert!(found <= promised, "{what}: {found} from the surface, {promised} promised");
    let back = measured.triangles_to_surface(3, 4 * skip);
    assert!(back <= promised, "{what}: {back} from the triangles, {promised} promised");
    promised / found.max(back)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[test]
fn the_promise_is_kept_all_over_the_gallery_and_is_hardly_more_than_needed() {
    let mut loosenesses = Vec::new();
    for exhibit in gallery() {
        let design = exhibit.design();
        for fineness in [50.0, 700.0] {
            loosenesses.push(check(&exhibit.name, &design, &within(size(&design) / fineness), 11));
        }
    }
    let median = median(loosenesses);
    assert!(median < 2.0, "the bound is {median} times what is measured");
}

#[test]
fn the_promise_is_kept_all_over_the_corpus() {
    for case in corpus() {
        let design = design_of_case(&case);
        let size = size(&design);
        for fineness in [20.0, 200.0] {
            let options = within(size / fineness);
            match mesh(&design, &options) {
                Ok(mesh) if mesh.n_vertices() > 300_000 => {}
                Ok(mesh) => {
                    check(&case.name, &design, &options, 1 + mesh.n_vertices() / 200);
                }
                Err(error) => assert_eq!(error.code().as_str(), "too-large", "{}: {error}", case.name),
            }
        }
    }
}

#[test]
fn grids_that_are_given_are_bounded_too() {
    for exhibit in gallery().iter().step_by(3) {
        for (rows, columns) in [(2, 7), (5, 40), (33, 97), (150, 30)] {
            // Of fewer rows than rings nothing is promised.
            if rows < exhibit.rings().len() {
                continue;
            }
            let options = MeshOptions { rows: Some(rows), columns: Some(columns), tolerance: None };
            assert_eq!(mesh(&exhibit.design(), &options).unwrap().bound, None);
            check(&exhibit.name, &exhibit.design(), &options, 11);
        }
    }
}

#[test]
fn what_is_given_stays_and_the_other_is_chosen() {
    for exhibit in gallery().iter().step_by(5) {
        let design = exhibit.design();
        let tolerance = size(&design) / 400.0;
        for options in [
            MeshOptions { rows: Some(90), ..within(tolerance) },
            MeshOptions { columns: Some(400), ..within(tolerance) },
        ] {
            check(&exhibit.name, &design, &options, 9);
        }
        // Rows that are given are even; with enough of them there is one on every ring.
        let mesh = mesh(&design, &MeshOptions { rows: Some(9), ..MeshOptions::default() }).unwrap();
        let us: Vec<f32> = Measured::new(&design, &mesh).rows.iter().map(|u| *u as f32).collect();
        let rings: Vec<f32> = exhibit.rings().iter().map(|u| *u as f32).collect();
        if rings.is_empty() || rings.len() > 9 {
            assert_eq!(us, (0u8..9).map(|i| f32::from(i) / 8.0).collect::<Vec<_>>(), "{}", exhibit.name);
        } else {
            assert_eq!(us.len(), 9, "{}", exhibit.name);
            assert!(rings.iter().all(|ring| us.contains(ring)), "{}: {us:?}", exhibit.name);
        }
    }
}

/// A pot of order 4 whose wall has one wave; `wall` are the equation's `s`, `t`, `w`.
fn waved(n: f64, amplitude: f64, wall: [f64; 3], span: &str) -> String {
    let [s, t, w] = wall;
    let component = |round: &str, wave: &str| {
        format!(
            r#"{{ "order": 4, "s": {s}, "t": {t}, "w": {w}, "modes": [
                {{ "n": 1, "{round}": {{ "start": 3, "end": 2, "start_u": 4, "end_u": 1 }} }},
                {{ "n": {n}, "{wave}": {{ "start": {amplitude}, "end": {amplitude}, "start_u": 1 }} }}] }}"#
        )
    };
    format!(
        r#"{{ "kind": "boundary-value", "span": {span}, "x": {}, "y": {},
              "z": {{ "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{{ "n": 0, "cos": {{ "end": 9, "start_u": 12, "end_u": 3 }} }}] }} }}"#,
        component("cos", "cos"),
        component("sin", "cos")
    )
}

#[test]
fn the_promise_is_kept_where_it_is_hard() {
    // Fast layers, oscillation, both sides of a resonance (order 4, w = 0: k sqrt(-t) = 2 pi), modes too high to be sampled, waves that do not close.
    let near = |share: f64| -(2.0 * std::f64::consts::PI / 5.0).powi(2) * share;
    let hard = [
        ("layers", waved(5.0, 0.2, [1.0, 3000.0, 1000.0], "\"2pi\"")),
        ("thin layers", waved(2.0, 0.2, [1e-6, 2.0, 1.0], "\"2pi\"")),
        ("oscillation", waved(5.0, 0.2, [1.0, -20.0, 3.0], "\"2pi\"")),
        ("complex roots", waved(7.0, 0.2, [1.0, 0.1, 90.0], "\"2pi\"")),
        ("before resonance", waved(5.0, 0.002, [1.0, near(0.999), 0.0], "\"2pi\"")),
        ("after resonance", waved(5.0, 0.002, [1.0, near(1.001), 0.0], "\"2pi\"")),
        ("high mode", waved(300.0, 0.01, [1.0, 0.0, 0.0], "\"2pi\"")),
        ("higher mode", waved(1200.0, 0.001, [1.0, 0.0, 0.0], "\"2pi\"")),
        ("broken wave", waved(6.3, 0.2, [1.0, 2.0, 1.0], "\"2pi\"")),
        ("short span", waved(0.4, 0.2, [1.0, 2.0, 1.0], "2.5")),
        // A pole, and a wall that stands still at the rim.
        ("cusp", lathe_of_order_4([0.0, 3.0], [4.0, 0.0], [0.0, 5.0], [0.0, 0.0])),
        ("double cusp", lathe_of_order_4([1.0, 3.0], [0.0, 0.0], [0.0, 5.0], [0.0, 0.0])),
        ("point", lathe_of_order_4([0.0, 0.0], [0.0, 0.0], [1.0, 1.0], [0.0, 0.0])),
    ];
    for (name, shape) in hard {
        for place in [
            "",
            r#", "place": { "scale": [3, -0.2, 1], "axis": [1, 2, 3], "angle": 1, "shift": [5, 0, -2] }"#,
            r#", "place": { "scale": [0.01, 1, 40] }"#,
        ] {
            let design = design(&format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {shape}{place} }}] }}"#));
            for fineness in [15.0, 300.0] {
                let options = within(size(&design) / fineness);
                let n = mesh(&design, &options).unwrap_or_else(|e| panic!("{name}{place}: {e}")).n_vertices();
                check(&format!("{name}{place}"), &design, &options, 1 + n / 200);
            }
        }
    }
}

fn lathe_of_order_4(radius: [f64; 2], slopes: [f64; 2], height: [f64; 2], rise: [f64; 2]) -> String {
    let component = |n: u32, part: &str, [start, end]: [f64; 2], [start_u, end_u]: [f64; 2]| {
        format!(
            r#"{{ "order": 4, "s": 1, "t": 0, "w": 0, "modes": [{{ "n": {n}, "{part}": {{ "start": {start}, "end": {end}, "start_u": {start_u}, "end_u": {end_u} }} }}] }}"#
        )
    };
    format!(
        r#"{{ "kind": "boundary-value", "span": "2pi", "x": {}, "y": {}, "z": {} }}"#,
        component(1, "cos", radius, slopes),
        component(1, "sin", radius, slopes),
        component(0, "cos", height, rise)
    )
}

fn component() -> impl Strategy<Value = String> {
    let n = prop_oneof![4 => (0u32..9).prop_map(f64::from), 1 => (0u32..60).prop_map(f64::from), 1 => 0.0..9.0f64];
    let datum = prop::collection::vec(-3.0..3.0f64, 5);
    let mode = (n, datum.clone(), datum);
    let rate = prop_oneof![Just(0.0), -9.0..9.0f64, 0.0..1.0f64, 0.0..900.0f64];
    (prop::sample::select(vec![2, 4]), rate.clone(), rate, prop::collection::vec(mode, 1..5)).prop_map(
        |(order, t, w, modes)| {
            let modes: Vec<String> = modes
                .into_iter()
                .map(|(n, a, b)| {
                    // Smaller the faster they wave, as of an outline that somebody drew.
                    let size = 1.0 / (1.0 + n * n / 9.0);
                    let datum = |d: Vec<f64>| {
                        let d: Vec<f64> = d.into_iter().map(|x| x * size).collect();
                        let slopes = if order == 4 {
                            format!(r#""start_u": {}, "end_u": {}, "#, d[2], d[3])
                        } else {
                            String::new()
                        };
                        format!(r#"{{ "start": {}, "end": {}, {slopes}"force": [0, {}] }}"#, d[0], d[1], d[4])
                    };
                    format!(r#"{{ "n": {n}, "cos": {}, "sin": {} }}"#, datum(a), datum(b))
                })
                .collect();
            let w = if order == 4 { format!(r#""w": {w}, "#) } else { String::new() };
            format!(r#"{{ "order": {order}, "s": 1, "t": {t}, {w}"modes": [{}] }}"#, modes.join(", "))
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn the_promise_is_kept_for_random_designs(
        x in component(), y in component(), z in component(),
        span in prop::sample::select(vec!["\"2pi\"", "1", "4.5"]),
        scale in prop::array::uniform3(0.05..20.0f64),
        fineness in prop::sample::select(vec![5.0, 40.0, 300.0]),
    ) {
        let [a, b, c] = scale;
        let text = format!(
            r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": {span}, "x": {x}, "y": {y}, "z": {z} }},
                  "place": {{ "scale": [{a}, {b}, {c}], "axis": [1, 1, 0], "angle": 2, "shift": [1, 2, 3] }} }}] }}"#
        );
        // Two modes of the same n, or a resonance, are refused.
        if let Ok(design) = Design::parse(&text) && let Ok(coarse) = mesh(&design, &MeshOptions { rows: Some(9), columns: Some(9), tolerance: None }) {
            prop_assume!(coarse.validate().is_ok());
            let options = within(size(&design) / fineness);
            match mesh(&design, &options) {
                Ok(mesh) => { check(&text, &design, &options, 1 + mesh.n_vertices() / 150); }
                Err(error) => prop_assert_eq!(error.code().as_str(), "too-large"),
            }
        }
    }
}

/// Grid, places of the rows and bound are the same bits on every machine; the tests in Node read the file too.
///
/// After a change of results that is meant, `PASU_BLESS=1 cargo test -p pasu --test library tolerance::of_the_gallery` writes the file anew; the CHANGELOG says why.
#[test]
fn of_the_gallery_are_golden() {
    let tessellation = |exhibit: &Exhibit| {
        let mesh = mesh(&exhibit.design(), &MeshOptions::default()).unwrap();
        format!("{} {:016x}", mesh.topology, mesh.bound.unwrap().to_bits())
    };
    let found: BTreeMap<String, String> =
        gallery().iter().map(|exhibit| (exhibit.name.clone(), tessellation(exhibit))).collect();
    let golden = golden!("tessellations.json").beside(&found);
    assert_eq!(found, golden);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Numbers of any size, and tolerances too: a grid with a finite bound, or a refusal.
    #[test]
    fn the_oddest_design_is_bounded_or_refused(value in document(), tolerance in prop::option::of(-12.0..12.0f64)) {
        let design = value.design().unwrap();
        for (rows, columns) in [(None, None), (Some(7), None), (None, Some(9)), (Some(30), Some(40))] {
            let options = MeshOptions { rows, columns, tolerance: tolerance.map(|power| 10f64.powf(power)) };
            match bound(&design, &options) {
                Ok(bound) => {
                    prop_assert!(bound.is_finite() && bound >= 0.0, "{bound}");
                    if let Some(tolerance) = options.tolerance {
                        prop_assert!(bound <= tolerance * (1.0 + 1e-12));
                    }
                }
                Err(error) => {
                    let codes = ["too-large", "tolerance-too-fine", "resonant-problem", "overflow", "out-of-range"];
                    prop_assert!(codes.contains(&error.code().as_str()), "{error:?}");
                }
            }
        }
    }
}

/// Even rows and columns of which the same bound keeps the tolerance: the fewest vertices, found by trying.
fn even_vertices(design: &Design, tolerance: f64) -> usize {
    let (mut least, mut rows) = (usize::MAX, 2);
    loop {
        if let Ok(mesh) = mesh(design, &MeshOptions { rows: Some(rows), ..within(tolerance) }) {
            least = least.min(mesh.n_vertices());
            if mesh.n_vertices() as f64 > 1.3 * least as f64 {
                return least;
            }
        }
        rows += 1 + rows / 20;
    }
}

#[test]
fn placed_rows_take_markedly_fewer_vertices_than_even_ones() {
    let ratios = gallery().into_iter().map(|exhibit| {
        let design = exhibit.design();
        let tolerance = size(&design) / 2000.0;
        let (placed, even) =
            (mesh(&design, &within(tolerance)).unwrap().n_vertices(), even_vertices(&design, tolerance));
        assert!(placed <= even, "{}: {placed} instead of {even}", exhibit.name);
        placed as f64 / even as f64
    });
    let median = median(ratios.collect());
    assert!(median < 0.6, "{median} of the even grid");
}

/// The table of docs/tessellation.md: `cargo test -p pasu --release --test library tolerance -- --ignored --nocapture`.
#[test]
#[ignore = "prints a table"]
fn table() {
    for fineness in [2000.0, 20000.0] {
        let (mut ratios, mut loosenesses, mut times) = (Vec::new(), Vec::new(), Vec::new());
        println!("| size / {fineness} | placed rows | even rows | ratio | bound / measured | microseconds |");
        for exhibit in gallery() {
            let design = exhibit.design();
            let tolerance = size(&design) / fineness;
            let start = std::time::Instant::now();
            let bound = bound(&design, &within(tolerance)).unwrap();
            times.push(start.elapsed().as_secs_f64() * 1e6);
            let placed = mesh(&design, &within(tolerance)).unwrap();
            let measured = Measured::new(&design, &placed);
            loosenesses.push(bound / measured.surface_to_triangles(4, 7));
            let even = even_vertices(&design, tolerance);
            ratios.push(placed.n_vertices() as f64 / even as f64);
            let (ratio, looseness, time) =
                (ratios[ratios.len() - 1], loosenesses[loosenesses.len() - 1], times[times.len() - 1]);
            let grid = format!("{} x {} = {}", measured.rows.len(), measured.columns, placed.n_vertices());
            println!("| {} | {grid} | {even} | {ratio:.2} | {looseness:.2} | {time:.0} |", exhibit.name);
        }
        println!("| median | | | {:.2} | {:.2} | {:.0} |", median(ratios), median(loosenesses), median(times));
    }
}
