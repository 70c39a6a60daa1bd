//! The rules of the house that a program can check: who may import what, and what must not appear. One kind of rule a file.

mod circles;
mod floors;
mod front_end;
mod imports;
mod modules;
mod page;
mod rust;
mod solver;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::stamp::sorted_entries;
use crate::workspace::Workspace;
use modules::Sources;

/// Where the solver is, whose files have circles and floors to be judged.
const SOLVER: &str = "crates/pasu/src";

/// Where the page is.
const PAGE: &str = "web/src";

const HELP: &str = "\
cargo xtask tidy

Checks the rules of the house that a program can check, and names every breach with its file and line:
who may import what, circles and floors of the rooms of the solver and of the page, and what must not appear.";

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    match arguments {
        [] => check(Workspace::find()?.root()),
        [word] if word == "--help" || word == "-h" => {
            println!("{HELP}");
            Ok(())
        }
        _ => bail!("not understood: {}\n\n{HELP}", arguments.join(" ")),
    }
}

/// Checks the repository and names every breach with its file and line.
pub(crate) fn check(root: &Path) -> Result<()> {
    let mut breaches = Vec::new();
    for file in files_below(&root.join("crates"), "rs")? {
        let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        breaches.extend(rust::breaches(&relative(root, &file), &text));
    }
    let mut page = page::Files::new();
    for file in files_below(&root.join(PAGE), "ts")? {
        let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        breaches.extend(front_end::breaches(&relative(root, &file), &text));
        page.insert(relative(&root.join(PAGE), &file), text);
    }
    breaches.extend(page::breaches(&page).iter().map(|breach| format!("{PAGE}/{breach}")));
    let solver = Sources::read(&root.join(SOLVER))?;
    breaches.extend(solver::breaches(&solver)?.iter().map(|breach| format!("{SOLVER}/{breach}")));
    if breaches.is_empty() {
        return Ok(());
    }
    bail!("{}", breaches.join("\n"))
}

/// Lines with their numbers, without those that are only a comment.
fn code_lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines()
        .enumerate()
        .map(|(index, line)| (index + 1, line))
        .filter(|(_, line)| !["//", "*", "/*"].iter().any(|comment| line.trim_start().starts_with(comment)))
}

fn files_below(folder: &Path, extension: &str) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in sorted_entries(folder)? {
        if entry.is_dir() {
            if !["node_modules", "target", "pkg"].iter().any(|name| entry.ends_with(name)) {
                files.extend(files_below(&entry, extension)?);
            }
        } else if entry.extension().is_some_and(|found| found == extension) {
            files.push(entry);
        }
    }
    Ok(files)
}

/// A path from the root with forward slashes on every system.
fn relative(root: &Path, file: &Path) -> String {
    let path = file.strip_prefix(root).unwrap_or(file);
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}
