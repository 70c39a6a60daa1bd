//! The rooms of the solver, from the ground up.

use anyhow::Result;

use super::floors::House;
use super::imports::imports;
use super::modules::{Sources, modules};

const SOLVER: House = House {
    rules: "tidy/solver.rs",
    floors: &[
        "error",
        "watch",
        "answer",
        "numeric",
        "mode",
        "design",
        "patch",
        "surface",
        "frame",
        "blend",
        "octant",
        "solution",
        "evaluate",
        "interior",
        "pull",
        "fit",
        "mesh",
        "fingerprint",
        "face",
        "solid",
        "check",
        "join",
        "weave",
        "measure",
        "make",
        "scene",
        "export",
        "lib",
    ],
    alone: &[("check", &["mesh", "watch"])],
};

/// Every breach in the solver, each with its file and line.
pub(super) fn breaches(sources: &Sources) -> Result<Vec<String>> {
    Ok(SOLVER.judged(&imports(&modules(sources)?)))
}
