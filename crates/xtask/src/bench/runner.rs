//! Where measurements run. Each runner is a program that hands over groups as lines of JSON.

use std::fs;
use std::process::Command;

use anyhow::{Context, Result, bail};

use super::measurement::Group;
use crate::workspace::{Workspace, cargo};
use crate::{browser, command, node};

/// Names the file that scripts under vitest append their lines to: vitest's own output is for people.
const ROWS: &str = "PASU_BENCH_ROWS";
/// Set when a few turns are enough.
const QUICK: &str = "PASU_BENCH_QUICK";

/// A place where measurements run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Runner {
    Native,
    Node,
    /// The kernel on a blank page, and whatever else `tests/bench/*.bench.ts` measures.
    Chromium,
}

impl Runner {
    pub(crate) const ALL: [Runner; 3] = [Runner::Native, Runner::Node, Runner::Chromium];

    pub(crate) fn named(name: &str) -> Option<Runner> {
        match name {
            "native" => Some(Runner::Native),
            "node" => Some(Runner::Node),
            "chromium" => Some(Runner::Chromium),
            _ => None,
        }
    }

    /// As in "measuring natively".
    pub(crate) fn place(self) -> &'static str {
        match self {
            Runner::Native => "natively",
            Runner::Node => "in Node",
            Runner::Chromium => "in Chromium",
        }
    }

    /// Runs it and reads what it measured.
    pub(crate) fn measure(self, workspace: &Workspace, quick: bool) -> Result<Vec<Group>> {
        let lines = match self {
            Runner::Native => native(workspace, quick)?,
            Runner::Node => in_node(workspace, quick)?,
            Runner::Chromium => in_chromium(workspace, quick)?,
        };
        let groups = lines.lines().map(Group::read).collect::<Result<Vec<_>>>()?;
        if groups.is_empty() {
            bail!("nothing was measured {}", self.place());
        }
        Ok(groups)
    }
}

/// The table of what networks take to store.
pub(crate) fn storage(workspace: &Workspace) -> Result<String> {
    let mut bench = Command::new(cargo());
    bench.args(["run", "--quiet", "--release", "--package", "bench", "--", "storage"]);
    command::read(bench.current_dir(workspace.root()))
}

fn native(workspace: &Workspace, quick: bool) -> Result<String> {
    let mut bench = Command::new(cargo());
    bench.args(["run", "--quiet", "--release", "--package", "bench", "--features", "sparse", "--"]);
    command::read(bench.args(quick.then_some("--quick")).current_dir(workspace.root()))
}

fn in_node(workspace: &Workspace, quick: bool) -> Result<String> {
    let mut node = Command::new("node");
    node.args(["--expose-gc", "tests/bench/node.mjs"]).args(quick.then_some("--quick"));
    command::read(node.current_dir(workspace.root()))
}

fn in_chromium(workspace: &Workspace, quick: bool) -> Result<String> {
    let folder = workspace.target().join("xtask");
    fs::create_dir_all(&folder)?;
    let rows = folder.join("bench-rows.jsonl");
    fs::write(&rows, "")?;
    let mut vitest = node::script(workspace, "vitest/vitest.mjs");
    vitest.args(["run", "--config", "../tests/bench/vitest.config.mts"]);
    vitest.env(browser::VARIABLE, browser::ensure(workspace)?).env(ROWS, &rows);
    if quick {
        vitest.env(QUICK, "1");
    }
    command::read(&mut vitest)?;
    fs::read_to_string(&rows).with_context(|| format!("cannot read {}", rows.display()))
}
