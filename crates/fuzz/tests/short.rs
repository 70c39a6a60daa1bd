//! What was once found, and a few inputs that nobody has looked at: the same on every machine, some seconds of them.
//!
//! `FUZZ=100000 cargo test -p fuzz` looks at as many.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use fuzz::{Random, Target};

/// Looks at an input; a broken promise is told with the bytes that broke it.
fn judge(target: Target, input: &[u8], told: &str) -> bool {
    catch_unwind(AssertUnwindSafe(|| target.judge(input))).unwrap_or_else(|_| {
        panic!("{told} of the target {} breaks a promise, see above:\n{}", target.name(), input.escape_ascii())
    })
}

/// What was kept, then so many inputs of up to three changes each.
fn run(target: Target, count: u64) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases").join(target.name());
    for entry in fs::read_dir(&folder).into_iter().flatten() {
        let path = entry.expect("a case").path();
        judge(target, &fs::read(&path).expect("a case"), &path.display().to_string());
    }
    let count = std::env::var("FUZZ").ok().and_then(|count| count.parse().ok()).unwrap_or(count);
    let seeds = target.seeds();
    let mut n_answered = 0;
    for seed in 0..count {
        let mut random = Random::new(seed);
        let mut input = random.one_of(&seeds).clone();
        for _ in 0..1 + random.below(3) {
            input = target.mutated(&input, &seeds, &mut random);
        }
        n_answered += u64::from(judge(target, &input, &format!("the input of seed {seed}")));
    }
    println!("{n_answered} of {count} inputs of the target {} were answered", target.name());
    // Changes that leave nothing to answer would test refusals alone.
    assert!(8 * n_answered >= count, "only {n_answered} of {count} were answered");
}

#[test]
fn documents() {
    run(Target::Document, 1500);
}

#[test]
fn links() {
    run(Target::Link, 1000);
}

#[test]
fn files() {
    run(Target::File, 1000);
}

#[test]
fn calls() {
    run(Target::Calls, 40);
}

#[test]
fn every_seed_is_answered() {
    for target in [Target::Document, Target::Link, Target::File] {
        for (i, seed) in target.seeds().iter().enumerate() {
            assert!(judge(target, seed, &format!("seed {i}")), "seed {i} of the target {}", target.name());
        }
    }
}
