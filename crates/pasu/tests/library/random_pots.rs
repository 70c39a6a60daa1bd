//! Random designs: each is made and passes every check, with its ring fitted where that has no room, or is refused with a reason, a place in the document and a remedy.
//!
//! What its time buys: designs that nobody has thought of. What went wrong on pots went wrong on random ones. `POTS=1000 cargo test -p pasu --test library random_pots` makes as many.

use std::collections::{BTreeMap, HashSet};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

use crate::support::design;
use crate::support::random::Random;
use pasu::{Making, Product, Severity, SolidMesh, Solution};

/// In every run.
const POTS: u64 = 150;

/// More than this is made of what the generator asks for; the others want a ring under a round bottom, or clay where there is no room for any.
const LEAST_MADE: f64 = 0.98;

/// One of so many at least: fewer would say that nothing was fitted.
const LEAST_FITTED: u64 = 70;

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
fn all_are_made_or_refused_with_a_reason() {
    let pots = std::env::var("POTS").ok().and_then(|count| count.parse().ok()).unwrap_or(POTS);
    let next = AtomicU64::new(1);
    let refusals: Mutex<BTreeMap<String, Vec<u64>>> = Mutex::default();
    let n_fitted = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed > pots {
                        break;
                    }
                    match make(seed) {
                        Outcome::Refused(reason) => {
                            refusals.lock().unwrap().entry(reason).or_default().push(seed);
                        }
                        Outcome::Fitted => {
                            n_fitted.fetch_add(1, Ordering::Relaxed);
                        }
                        Outcome::Made => {}
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
    let made = 1.0 - n_refused as f64 / pots as f64;
    let n_fitted = n_fitted.into_inner();
    println!("{n_fitted:3} fitted");
    assert!(made > LEAST_MADE, "only {made} of all were made");
    assert!(n_fitted as u64 >= pots / LEAST_FITTED, "only {n_fitted} were fitted");
    assert!(!refusals.keys().any(|reason| reason.ends_with(UNHELPED)), "{:?}", refusals.keys());
}

enum Outcome {
    Made,
    /// With another ring or drain than the one that is asked for.
    Fitted,
    /// For this reason.
    Refused(String),
}

/// Makes one design a pot.
fn make(seed: u64) -> Outcome {
    let json = Random::new(seed).design();
    let design = design(&json);
    // What other tests ask of a design that is solved for it alone is asked of one solution here: the body is sought once.
    let solution = Solution::of(&design);
    let making = Making { tolerance: Some(0.05), ..Making::default() };
    match solution.solid(&making) {
        Ok(meshes) => {
            let pot = solution.pot(0, Product::Pot).unwrap();
            let expected = if pot.is_ring() { 0 } else { 2 };
            assert_eq!(euler(&meshes[0]), expected, "seed {seed}: {json}");
            assert!(json.contains("drain") <= pot.is_ring(), "seed {seed}: {json}");
            let can_give_way = ["foot", "drain"].iter().any(|field| json.contains(&format!("\"{field}\":")));
            if can_give_way && is_fitted(seed, &solution, &making, &meshes) { Outcome::Fitted } else { Outcome::Made }
        }
        Err(error) => {
            let path = error.path().trim_start_matches("parts[0].");
            assert!(
                REASONS.contains(&(error.code().as_str(), path)),
                "seed {seed}: {} {error}\n{json}",
                error.code().as_str()
            );
            // Which of several things have this code is told besides, so that a page can say it in its own words.
            assert!(error.arg("what").is_some(), "seed {seed}: {} {error}", error.code());
            let report = solution.check(&making).unwrap();
            let named: Vec<&str> = report.findings[0].args.keys().copied().collect();
            assert!(error.args().iter().all(|(name, _)| named.contains(name)), "seed {seed}: {named:?}");
            let is_helped = report.findings[0].remedy.is_some();
            let helped = if is_helped { "" } else { UNHELPED };
            Outcome::Refused(format!("{} {path}{helped}", error.code().as_str()))
        }
    }
}

/// Whether a warning tells that ring or drain were fitted; then the wall that comes with it has to make the very same body without a warning.
fn is_fitted(seed: u64, solution: &Solution, making: &Making, meshes: &[SolidMesh]) -> bool {
    let asked = solution.design();
    let report = solution.check(making).unwrap();
    assert!(report.is_ok(), "seed {seed}: {:?}", report.findings);
    let Some(found) = report.findings.iter().find(|found| found.code.starts_with("fitted")) else {
        assert!(report.findings.iter().all(|found| found.remedy.is_none()), "seed {seed}: {:?}", report.findings);
        return false;
    };
    assert_eq!(found.severity, Severity::Warning, "seed {seed}");
    let remedy = found.remedy.as_ref().unwrap_or_else(|| panic!("seed {seed}: no remedy"));
    let wall = asked.parts()[0].wall.unwrap();
    let (has_ring, has_drain) = (remedy.wall.foot.is_some(), remedy.wall.drain > 0.0);
    assert_eq!((has_ring, has_drain), (wall.foot.is_some(), wall.drain > 0.0), "seed {seed}: {remedy:?}");
    let mut document: serde_json::Value = serde_json::from_str(&asked.to_json()).unwrap();
    document["parts"][0]["wall"] = serde_json::to_value(remedy.wall).unwrap();
    let made = Solution::of(&design(&document.to_string()));
    assert_eq!(made.solid(making).unwrap(), meshes, "seed {seed}");
    let report = made.check(making).unwrap();
    assert!(report.is_ok() && report.findings.iter().all(|found| !found.code.starts_with("fitted")), "seed {seed}");
    true
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
