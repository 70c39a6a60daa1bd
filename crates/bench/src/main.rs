//! The native part of `cargo xtask bench`: prints one line of JSON for each group of contenders that take turns.
//! One thread.

use std::hint::black_box;

use bench::blend_differences::DISCS;
use bench::designs;
use bench::finite_difference::{Fourier, Problem};
use bench::rounds::{Contender, take_turns};
use pasu::{Design, Hand, MeshOptions, Result, Sampler, Solution, Surface};
use serde_json::{Value, json};

/// Turns of every contender, and with `--quick`.
const ROUNDS: [usize; 2] = [15, 3];

fn main() -> Result<()> {
    if std::env::args().any(|argument| argument == "storage") {
        return storage();
    }
    let quick = std::env::args().any(|argument| argument == "--quick");
    let rounds = ROUNDS[usize::from(quick)];
    for modes in [1, 4, 8] {
        kernel(modes, rounds)?;
    }
    every_wave(rounds)?;
    memory(rounds)?;
    solving(rounds)?;
    rings(rounds)?;
    pulling(rounds)?;
    networks(rounds)?;
    blends(rounds)?;
    baseline("order 4", &designs::vase(8)?, rounds)?;
    baseline("order 2", &designs::vase_of_second_order(8)?, rounds)
}

/// What networks take as patches of the equation, as NURBS patches and as polygons.
#[expect(clippy::print_stdout, reason = "standard output is where xtask reads the table")]
fn storage() -> Result<()> {
    println!("{}", bench::storage::table(&bench::storage::comparisons()?));
    Ok(())
}

/// Sampling against the closed form at every vertex.
fn kernel(modes: usize, rounds: usize) -> Result<()> {
    const SIDE: usize = 513;
    let design = designs::vase(modes)?;
    let at = grid(SIDE);
    let mut sampler = Sampler::new();
    let options = MeshOptions { rows: Some(SIDE), columns: Some(SIDE), ..MeshOptions::default() };
    let exact = pasu::evaluate(&design, 0, &at)?;
    let sampled = sampler.sample(&design, &options)?;
    let size = exact.iter().fold(0.0f64, |size, x| size.max(x.abs()));
    let off = exact.iter().zip(&sampled.positions).fold(0.0f64, |off, (a, b)| off.max((a - f64::from(*b)).abs()));
    assert!(off < 1e-6 * size, "sampled and exact positions differ by {off}");
    let mut contenders = [
        sampling("Pasu", &mut sampler, &design, SIDE),
        Contender::new("closed form per vertex, without normals", || pasu::evaluate(&design, 0, &at)),
    ];
    take_turns(&mut contenders, rounds);
    let [pasu, direct] = &contenders;
    let scale = 1e9 / (SIDE * SIDE) as f64;
    let mut direct = row(direct, scale);
    direct["against"] = json!("Pasu");
    print(&format!("Kernel, {0} x {0} cells, K = {modes}", SIDE - 1), "ns per vertex", vec![row(pasu, scale), direct]);
    Ok(())
}

/// Sampling where every component has cosines and sines, against sampling where each has one of the two.
fn every_wave(rounds: usize) -> Result<()> {
    const SIDE: usize = 513;
    const AT_MOST: f64 = 1.96;
    let (every, apart) = (designs::vase_of_every_wave(4)?, designs::vase(4)?);
    let (mut sampler, mut other) = (Sampler::new(), Sampler::new());
    let mut contenders = [
        sampling("Pasu", &mut sampler, &every, SIDE),
        sampling("Pasu, cosines and sines apart", &mut other, &apart, SIDE),
    ];
    take_turns(&mut contenders, rounds);
    let scale = 1e9 / (SIDE * SIDE) as f64;
    let [mut first, second] = contenders.each_ref().map(|contender| row(contender, scale));
    first["against"] = second["name"].clone();
    first["at_most"] = json!(AT_MOST);
    let group = format!("Kernel, {0} x {0} cells, K = 4 of cosines and as many of sines", SIDE - 1);
    print(&group, "ns per vertex", vec![first, second]);
    Ok(())
}

/// Sampling against filling the memory that it writes.
fn memory(rounds: usize) -> Result<()> {
    const SIDE: usize = 1025;
    let designs = [designs::vase(1)?, designs::vase(4)?, designs::vase(8)?, designs::turned()?];
    let names = ["Pasu, K = 1", "Pasu, K = 4", "Pasu, K = 8", "Pasu, turned"];
    let mut samplers = [Sampler::new(), Sampler::new(), Sampler::new(), Sampler::new()];
    let mut bytes = vec![0u8; 24 * SIDE * SIDE];
    let mut contenders = vec![Contender::new("memset", || black_box(&mut bytes).fill(0))];
    for ((design, name), sampler) in designs.iter().zip(names).zip(&mut samplers) {
        contenders.push(sampling(name, sampler, design, SIDE));
    }
    take_turns(&mut contenders, rounds);
    let scale = 1e9 / (SIDE * SIDE) as f64;
    let rows = contenders.iter().enumerate().map(|(index, contender)| {
        let mut row = row(contender, scale);
        if index > 0 {
            row["against"] = json!("memset");
        }
        row
    });
    print(&format!("Memory, {0} x {0} cells, 24 bytes a vertex", SIDE - 1), "ns per vertex", rows.collect());
    Ok(())
}

/// Solving 64 modes in each component.
fn solving(rounds: usize) -> Result<()> {
    let shape = designs::shape(&designs::vase(64)?);
    let (rows, columns) = (128, 256);
    let problem = Problem::new(&shape, rows, columns);
    let mut fourier = Fourier::new(rows, columns);
    let error = problem.error(&Surface::solve(&shape, "shape")?, fourier.solve(&problem));
    let alike = designs::shape(&designs::vase_of_one_equation(64)?);
    let mut contenders = [
        Contender::new("Pasu, an equation for each component", || Surface::solve(&shape, "shape")),
        Contender::new("Pasu, one equation for all", || Surface::solve(&alike, "shape")),
        Contender::new("finite differences, FFT and bands", || fourier.solve(&problem)[0][0]),
    ];
    take_turns(&mut contenders, rounds);
    let [each, one, fast] = &contenders;
    let mut fast = row(fast, 1e6);
    fast["against"] = json!(each.name);
    fast["note"] = json!(format!("{rows} x {columns} points, error {error:.1e}"));
    print("Solving 64 modes per component", "us", vec![row(each, 1e6), row(one, 1e6), fast]);
    Ok(())
}

/// Solving 64 modes in each component through rings: in proportion to how many there are.
fn rings(rounds: usize) -> Result<()> {
    let [many, few, none] = [64, 8, 0].map(|rings| designs::vase_of_rings(64, rings));
    let [many, few, none] = [designs::shape(&many?), designs::shape(&few?), designs::shape(&none?)];
    let even = designs::shape(&designs::vase_of_even_rings(64, 64)?);
    let mut contenders = [
        Contender::new("64 rings", || Surface::solve(&many, "shape")),
        Contender::new("64 rings, evenly spaced", || Surface::solve(&even, "shape")),
        Contender::new("8 rings", || Surface::solve(&few, "shape")),
        Contender::new("none", || Surface::solve(&none, "shape")),
    ];
    take_turns(&mut contenders, rounds);
    let [mut many, even, few, none] = contenders.each_ref().map(|contender| row(contender, 1e3));
    many["against"] = few["name"].clone();
    many["at_most"] = json!(PER_RING);
    print("Solving 64 modes per component through rings", "ms", vec![many, even, few, none]);
    Ok(())
}

/// 65 stretches between 64 rings and the ends, and 9 between 8.
const PER_RING: f64 = 65.0 / 9.0;

/// A pull, from a design to the next: on a ring, and where one is put first.
fn pulling(rounds: usize) -> Result<()> {
    let design = designs::vase_of_rings(16, 8)?;
    let ring = designs::shape(&design).rings[3].u;
    let hand = |u: f64| -> Result<Hand> {
        let from = pasu::evaluate(&design, 0, &[u, 0.3])?;
        Ok(Hand { width: Some(1.0), ..Hand::new([u, 0.3], [from[0] + 0.2, from[1], from[2]]) })
    };
    let (on, between) = (hand(ring)?, hand(0.5 * (ring + designs::shape(&design).rings[4].u))?);
    let shape = designs::shape(&design);
    let mut contenders = [
        Contender::new("solving", || Surface::solve(&shape, "shape")),
        Contender::new("pull on a ring", || pasu::pull(&design, 0, &on)),
        Contender::new("pull between rings", || pasu::pull(&design, 0, &between)),
    ];
    take_turns(&mut contenders, rounds);
    let rows = contenders.iter().enumerate().map(|(index, contender)| {
        let mut row = row(contender, 1e6);
        if index > 0 {
            row["against"] = json!("solving");
        }
        row
    });
    print("Pulling a pot of 8 rings, 16 modes per component", "us", rows.collect());
    Ok(())
}

/// A network of 10,000 patches, and the same with the point in its middle moved, in turn: as a whole, and with the strips through that point alone.
fn networks(rounds: usize) -> Result<()> {
    let designs = [designs::network(designs::NETWORK, 0.0)?, designs::network(designs::NETWORK, 0.01)?];
    let options = MeshOptions { tolerance: Some(designs::NETWORK_TOLERANCE), ..MeshOptions::default() };
    let mut samplers = [Sampler::new(), Sampler::new()];
    let [whole, strips] = &mut samplers;
    let (mut moved, mut both) = (designs::Moved::new(&designs)?, designs::Moved::new(&designs)?);
    let mut next = 0;
    let mut contenders = [
        Contender::new("solving and sampling", || {
            next = 1 - next;
            whole.sample(&designs[next], &options).map(|mesh| mesh.n_vertices())
        }),
        Contender::new("solving", || designs::solved(Solution::of(&designs[0]))),
        Contender::new("solving, a point moved", || moved.step().map(|solution| solution.design().parts().len())),
        Contender::new("solving and sampling, a point moved", || {
            strips.sample_solution(both.step()?, &options).map(|mesh| mesh.n_vertices())
        }),
    ];
    take_turns(&mut contenders, rounds);
    let mut rows: Vec<Value> = contenders.iter().map(|contender| row(contender, 1e3)).collect();
    rows[2]["against"] = rows[1]["name"].clone();
    rows[2]["note"] = json!(designs::NETWORK_NOTE);
    rows[3]["against"] = rows[0]["name"].clone();
    print("A network of 10,000 patches, within a thousandth of its size", "ms", rows);
    Ok(())
}

/// The second example of ZY04 by each method, solved and evaluated all through, against a plain loft; with what the equation leaves, and how far it is from finite differences.
fn blends(rounds: usize) -> Result<()> {
    const SIDE: usize = 17;
    const STEPS: usize = 24;
    let step = |index: usize| index as f64 / (SIDE - 1) as f64;
    let at: Vec<f64> = (0..SIDE)
        .flat_map(|k| (0..SIDE).flat_map(move |i| (0..SIDE).flat_map(move |j| [step(i), step(j), step(k)])))
        .collect();
    let ways = [
        ("exact", "exact", [4, 4, 3]),
        ("modal, 4 x 4", "modal", [4, 4, 1]),
        ("modal, 32 x 32", "modal", [32, 32, 1]),
        ("collocation, 4 x 4 x 3", "collocation", [4, 4, 3]),
        ("collocation, 32 x 32 x 8", "collocation", [32, 32, 8]),
    ];
    let designs =
        ways.iter().map(|(_, method, terms)| DISCS.design(method, *terms)).collect::<Result<Vec<Design>>>()?;
    let found = DISCS.by_differences(STEPS);
    let told = |apart: f64| format!("{apart:.1e} from finite differences on {STEPS} intervals");
    let mut notes = vec![("a plain loft, positions alone", told(DISCS.loft_apart(&found)))];
    for ((name, ..), design) in ways.iter().zip(&designs) {
        let inside = pasu::inside(design, 0)?;
        let left = format!("residual {:.1e} at most, {:.1e} RMS", inside.residual, inside.residual_rms);
        notes.push((*name, format!("{left}, {}", told(DISCS.apart(design, &found)?))));
    }
    let loft = || at.chunks_exact(3).map(|at| DISCS.loft([at[0], at[1], at[2]])[0]).sum::<f64>();
    let mut contenders = vec![Contender::new("a plain loft, positions alone", loft)];
    for ((name, ..), design) in ways.iter().zip(&designs) {
        contenders.push(Contender::new(name, || pasu::evaluate(design, 0, &at)));
    }
    contenders.push(Contender::new("finite differences, conjugate gradients", || DISCS.by_differences(STEPS)));
    take_turns(&mut contenders, rounds);
    let rows = contenders.iter().map(|contender| {
        let mut row = row(contender, 1e3);
        if let Some((_, note)) = notes.iter().find(|(name, _)| *name == contender.name) {
            row["note"] = json!(note);
        }
        row
    });
    print(
        &format!("A blend of two discs, solved and evaluated at {SIDE} x {SIDE} x {SIDE} points"),
        "ms",
        rows.collect(),
    );
    Ok(())
}

/// Solving and sampling against finite differences on the same grid.
fn baseline(order: &str, design: &Design, rounds: usize) -> Result<()> {
    const SIDE: usize = 128;
    let shape = designs::shape(design);
    let surface = Surface::solve(&shape, "shape")?;
    let problem = Problem::new(&shape, SIDE, SIDE);
    let coarse = Problem::new(&shape, SIDE / 2, SIDE / 2);
    let (mut sampler, mut fourier) = (Sampler::new(), Fourier::new(SIDE, SIDE));
    let fast_note = {
        let error = problem.error(&surface, fourier.solve(&problem));
        note(error, coarse.error(&surface, Fourier::new(SIDE / 2, SIDE / 2).solve(&coarse)))
    };
    let mut contenders = vec![
        sampling("Pasu, solved and sampled with normals", &mut sampler, design, SIDE),
        Contender::new("finite differences, FFT and bands", || fourier.solve(&problem)[0][0]),
    ];
    #[cfg_attr(not(feature = "sparse"), expect(unused_mut, reason = "the sparse solver adds its own"))]
    let mut notes = vec![None, Some(fast_note)];
    #[cfg(feature = "sparse")]
    {
        use bench::finite_difference::sparse;
        let error = problem.error(&surface, &sparse::solve(&problem));
        notes.push(Some(note(error, coarse.error(&surface, &sparse::solve(&coarse)))));
        contenders.push(Contender::new("finite differences, sparse LU", || sparse::solve(&problem)));
    }
    take_turns(&mut contenders, rounds);
    let first = contenders[0].name;
    let rows = contenders.iter().zip(notes).enumerate().map(|(index, (contender, note))| {
        let mut row = row(contender, 1e3);
        if index > 0 {
            row["against"] = json!(first);
        }
        row["note"] = json!(note);
        row
    });
    print(&format!("Numerical baseline, {SIDE} x {SIDE}, K = 8, {order}"), "ms", rows.collect());
    Ok(())
}

/// How far off a numerical solution is, and with which power of the step its error falls.
///
/// # Panics
/// When it is so far off that it solves something else.
fn note(error: f64, of_half: f64) -> String {
    assert!(error < 1e-3, "finite differences are off by {error}");
    format!("error {error:.1e}, falls with the step to the power {:.1}", (of_half / error).log2())
}

/// Solves and samples into the same arrays again and again.
fn sampling<'a>(name: &'static str, sampler: &'a mut Sampler, design: &'a Design, side: usize) -> Contender<'a> {
    let options = MeshOptions { rows: Some(side), columns: Some(side), ..MeshOptions::default() };
    Contender::new(name, move || sampler.sample(design, &options).map(|mesh| mesh.positions[0]))
}

/// The parameters of every vertex.
fn grid(side: usize) -> Vec<f64> {
    let step = |index: usize| index as f64 / (side - 1) as f64;
    (0..side)
        .flat_map(|row| (0..side).flat_map(move |column| [step(row), std::f64::consts::TAU * step(column)]))
        .collect()
}

fn row(contender: &Contender, scale: f64) -> Value {
    let samples: Vec<f64> = contender.samples.iter().map(|seconds| scale * seconds).collect();
    json!({ "name": contender.name, "samples": samples })
}

#[expect(clippy::print_stdout, reason = "standard output is where xtask reads the rows")]
fn print(group: &str, unit: &str, rows: Vec<Value>) {
    println!("{}", json!({ "runner": "native", "group": group, "unit": unit, "rows": rows }));
}
