//! How fast surfaces are computed, natively: the closed form at every vertex, against the mesh, which samples it from
//! tables and adds normals.

use std::hint::black_box;
use std::time::{Duration, Instant};

use pasu::{Design, MeshOptions, Result};

/// Vertices along each side of the grid.
const SIDE: usize = 256;

/// Every measurement is repeated for this long; the fastest run counts, because everything else only adds to it.
const FOR: Duration = Duration::from_millis(500);

fn main() -> Result<()> {
    println!("{SIDE} x {SIDE} vertices, native, one thread; the fastest of the runs in {FOR:?} each\n");
    println!("modes  closed form per vertex   mesh with normals   ratio   solving alone");
    for modes in [1, 4, 8] {
        let design = Design::parse(&vase(modes))?;
        let at = grid();
        let points = fastest(|| pasu::evaluate(&design, 0, &at))?;
        let options = MeshOptions { rows: Some(SIDE), columns: Some(SIDE), ..MeshOptions::default() };
        let mesh = fastest(|| pasu::mesh(&design, &options))?;
        let solving = fastest(|| pasu::evaluate(&design, 0, &[0.5, 0.0]))?;
        println!(
            "{modes:>5}  {:>8.1} ns {:>6.2} ms  {:>8.1} ns {:>6.2} ms   {:>5.1}  {:>10.1} us",
            per_vertex(points),
            milliseconds(points),
            per_vertex(mesh),
            milliseconds(mesh),
            points.as_secs_f64() / mesh.as_secs_f64(),
            1e3 * milliseconds(solving),
        );
    }
    Ok(())
}

/// A fourth-order vase with so many modes in `x` and in `y`.
fn vase(modes: usize) -> String {
    let component = |data: &str| {
        let modes: Vec<String> = (1..=modes)
            .map(|n| {
                let size = 1.0 / (n * n) as f64;
                format!(
                    r#"{{ "n": {n}, "{data}": {{ "start": {size}, "end": {}, "start_u": -1, "end_u": 0.5 }} }}"#,
                    0.6 * size
                )
            })
            .collect();
        format!(r#"{{ "order": 4, "s": 1, "t": 3, "w": 1.5, "modes": [{}] }}"#, modes.join(", "))
    };
    let height = r#"{ "order": 4, "s": 1, "t": 1, "w": 1, "modes": [{ "n": 0, "cos": { "start": 3 } }] }"#;
    format!(
        r#"{{ "pasu": 1, "parts": [{{ "shape": {{ "kind": "boundary-value", "span": "2pi", "x": {}, "y": {}, "z": {height} }} }}] }}"#,
        component("cos"),
        component("sin")
    )
}

/// The parameters of every vertex.
fn grid() -> Vec<f64> {
    let step = |index: usize| index as f64 / (SIDE - 1) as f64;
    (0..SIDE)
        .flat_map(|row| (0..SIDE).flat_map(move |column| [step(row), std::f64::consts::TAU * step(column)]))
        .collect()
}

fn fastest<T>(mut run: impl FnMut() -> Result<T>) -> Result<Duration> {
    let start = Instant::now();
    let mut best = Duration::MAX;
    while start.elapsed() < FOR {
        let before = Instant::now();
        black_box(run()?);
        best = best.min(before.elapsed());
    }
    Ok(best)
}

fn per_vertex(time: Duration) -> f64 {
    time.as_secs_f64() * 1e9 / (SIDE * SIDE) as f64
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
