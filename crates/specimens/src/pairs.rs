//! Random pairs of bodies with what the constraints of scenes say of them, for a program that cuts the triangles of both with each other.
//!
//! `pairs.json` lists them, `pairs.bin` holds their meshes: coordinates in single precision and numbers of corners, little-endian. Lengths are those of the designs.

use std::fs;
use std::panic::resume_unwind;
use std::path::Path;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::thread;

use anyhow::{Context, Result};
use pasu::{Design, Making, SolidMesh, Solution};
use serde_json::{Value, json};

/// As many are drawn until so many can be made.
const PAIRS: usize = 1000;

/// The triangles are as near to the bodies as this, whose sizes are between 1 and 8.
const TOLERANCE: f64 = 0.004;

/// A pair that can be made.
struct Pair {
    number: u64,
    /// The code of the first breach, or `apart`.
    verdict: &'static str,
    depth: f64,
    meshes: Vec<SolidMesh>,
}

/// Writes all pairs.
pub(crate) fn write(folder: &Path) -> Result<()> {
    let (next, n_made) = (AtomicU64::new(1), AtomicUsize::new(0));
    let worker = || {
        let mut made = Vec::new();
        while n_made.load(Ordering::Relaxed) < PAIRS {
            if let Some(pair) = judged(next.fetch_add(1, Ordering::Relaxed))? {
                n_made.fetch_add(1, Ordering::Relaxed);
                made.push(pair);
            }
        }
        Ok(made)
    };
    let made = thread::scope(|scope| {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(worker)).collect();
        let answers = workers.into_iter().map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        answers.collect::<Result<Vec<Vec<Pair>>>>()
    })?;
    let mut made: Vec<Pair> = made.into_iter().flatten().collect();
    made.sort_by_key(|pair| pair.number);
    let (mut bytes, mut all) = (Vec::new(), Vec::new());
    for Pair { number, verdict, depth, meshes } in made.into_iter().take(PAIRS) {
        let meshes: Vec<Value> = meshes
            .iter()
            .map(|mesh| {
                let positions = put(&mut bytes, mesh.positions.iter().map(|x| x.to_le_bytes()));
                let indices = put(&mut bytes, mesh.indices.iter().map(|corner| corner.to_le_bytes()));
                json!({ "positions": positions, "indices": indices, "bound": mesh.bound })
            })
            .collect();
        all.push(json!({ "name": format!("pair {number}"), "verdict": verdict, "depth": depth, "meshes": meshes }));
    }
    fs::write(folder.join("pairs.bin"), bytes)?;
    fs::write(folder.join("pairs.json"), serde_json::to_string(&all)?)?;
    Ok(())
}

/// What is said of a pair. What cannot be made has no triangles to be cut: now and then a wall, or a tip like a needle.
fn judged(number: u64) -> Result<Option<Pair>> {
    let design = pair(number)?;
    let solution = Solution::of(&design);
    let told = solution.constraints(None).with_context(|| format!("pair {number}"))?;
    let making = Making { tolerance: Some(TOLERANCE), ..Making::default() };
    let Ok(meshes) = solution.solid(&making) else { return Ok(None) };
    let verdict = told.breaches.first().map_or("apart", |breach| breach.code);
    let depth = told.breaches.iter().filter_map(|breach| breach.distance).fold(0.0, f64::max);
    Ok(Some(Pair { number, verdict, depth, meshes }))
}

/// Appends words of four bytes; where they begin, and how many they are.
fn put(bytes: &mut Vec<u8>, words: impl Iterator<Item = [u8; 4]>) -> [usize; 2] {
    let first = bytes.len();
    bytes.extend(words.flatten());
    [first, (bytes.len() - first) / 4]
}

/// Two bodies of different objects, now and then apart, now and then not.
fn pair(number: u64) -> Result<Design> {
    let mut dice = Dice(number.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let parts = [0, 1].map(|object| {
        let mut part = body(&mut dice);
        let reach = dice.between(0.2, 3.0);
        let mut point = |size: f64| [(); 3].map(|()| dice.between(-size, size));
        part["object"] = object.into();
        part["place"] = json!({ "axis": point(1.0), "angle": 3.0 * point(1.0)[0], "shift": point(reach) });
        part
    });
    let text = json!({ "pasu": 1, "unit": "mm", "parts": parts }).to_string();
    Design::parse(&text).with_context(|| format!("pair {number}: {text}"))
}

/// An octant, a blend, or a pot with a wall.
fn body(dice: &mut Dice) -> Value {
    match dice.whole(4) {
        0 | 1 => {
            // From pyramids over balls to nearly boxes.
            let exponents = [(); 3].map(|()| dice.between(0.0, 2.5).exp());
            json!({ "shape": { "kind": "octant", "exponents": exponents } })
        }
        2 => {
            let mut section = |z: f64| {
                let radius = [(); 2].map(|()| dice.between(0.4, 1.6));
                json!({ "form": "rectangle", "radius": radius, "z": z, "taper": 0, "dz": dice.between(1.5, 2.5) })
            };
            json!({ "shape": { "kind": "blend", "start": section(0.0), "end": section(2.0) } })
        }
        _ => {
            let (rim, foot) = (dice.between(0.8, 1.6), dice.between(0.7, 1.2));
            json!({
                "shape": { "kind": "second-order", "r": [rim, 0, foot, 0], "t": [dice.between(-0.3, 0.3), dice.between(-0.3, 0.3)], "n": [1, 2], "height": dice.between(1.5, 3.5) },
                "wall": { "thickness": 0.15, "base": 0.2 },
            })
        }
    }
}

/// Marsaglia's xorshift.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        let share = (self.next() >> 11) as f64 / (1u64 << 53) as f64;
        ((low + (high - low) * share) * 1e4).round() / 1e4
    }

    /// Below `n`.
    fn whole(&mut self, n: u64) -> u64 {
        (self.next() >> 11) % n
    }
}
