//! A thousand random designs: each is made and passes every check, or is refused with a reason and a place in the document.
//!
//! What its time buys: designs that nobody has thought of. What went wrong on pots went wrong on random ones.

#[path = "support/mod.rs"]
mod support;

#[path = "support/random.rs"]
mod random;

use std::collections::{BTreeMap, HashSet};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use pasu::{Making, Pot, Product, SolidMesh, check, solid};
use random::Random;
use support::design;

const DESIGNS: u64 = 1000;

/// Of what the generator asks for; the others want rings and holes that do not fit, or have cusps.
const LEAST_MADE: f64 = 0.93;

/// What is written behind the reason of a refusal without a remedy.
const UNHELPED: &str = ", without a remedy";

/// The refusals that a design can meet, each with the field that asks too much.
const REASONS: [(&str, &str); 7] = [
    ("crosses-itself", "shape"),
    ("pinched-surface", "shape"),
    ("no-room", "wall.thickness"),
    ("no-room", "wall.base"),
    ("no-room", "wall.foot"),
    ("no-room", "wall.drain"),
    ("no-room", "wall.rim"),
];

#[test]
fn a_thousand_are_made_or_refused_with_a_reason() {
    let next = AtomicU64::new(1);
    let refusals: Mutex<BTreeMap<String, Vec<u64>>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed > DESIGNS {
                        break;
                    }
                    if let Some(reason) = make(seed) {
                        refusals.lock().unwrap().entry(reason).or_default().push(seed);
                    }
                }
            });
        }
    });
    let refusals = refusals.into_inner().unwrap();
    for (reason, seeds) in &refusals {
        println!("{:3} {reason}: {:?}", seeds.len(), &seeds[..seeds.len().min(8)]);
    }
    let n_refused: usize = refusals.values().map(Vec::len).sum();
    let made = 1.0 - n_refused as f64 / DESIGNS as f64;
    assert!(made >= LEAST_MADE, "only {made} of all were made");
    assert!(!refusals.keys().any(|reason| reason.ends_with(UNHELPED)), "{:?}", refusals.keys());
}

/// Makes pot and solid of one design; the reason where the pot is refused.
fn make(seed: u64) -> Option<String> {
    let json = Random::new(seed).design();
    let design = design(&json);
    let making = |product| Making { product, tolerance: Some(0.05), ..Making::default() };
    match solid(&design, &making(Product::Pot)) {
        Ok(meshes) => {
            let pot = Pot::new(&design, 0, Product::Pot).unwrap();
            let expected = if pot.is_ring() { 0 } else { 2 };
            assert_eq!(euler(&meshes[0]), expected, "seed {seed}: {json}");
            assert!(json.contains("drain") <= pot.is_ring(), "seed {seed}: {json}");
            None
        }
        Err(error) => {
            let path = error.path().trim_start_matches("parts[0].");
            assert!(
                REASONS.contains(&(error.code().as_str(), path)),
                "seed {seed}: {} {error}\n{json}",
                error.code().as_str()
            );
            let report = check(&design, &making(Product::Pot)).unwrap();
            let is_helped = report.findings[0].remedy.is_some();
            Some(format!("{} {path}{}", error.code().as_str(), if is_helped { "" } else { UNHELPED }))
        }
    }
}

/// The Euler characteristic of a mesh every edge of which is passed once each way.
fn euler(mesh: &SolidMesh) -> i64 {
    let mut edges = HashSet::new();
    for triangle in mesh.indices.chunks(3) {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            assert!(edges.insert((triangle[a], triangle[b])));
        }
    }
    assert!(edges.iter().all(|(a, b)| edges.contains(&(*b, *a))));
    mesh.n_vertices() as i64 - edges.len() as i64 / 2 + mesh.n_triangles() as i64
}
