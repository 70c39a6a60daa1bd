//! The table in `docs/benchmarks.md`, between two marks that nobody edits by hand.

use std::fs;

use anyhow::{Context, Result};

use super::machine::Machine;
use super::measurement::Group;
use super::table;
use crate::workspace::Workspace;

const START: &str = "<!-- Written by `cargo xtask bench --write`. -->";
const END: &str = "<!-- Until here. -->";

/// Puts the table in the place of the last one.
pub(crate) fn write(workspace: &Workspace, machine: &Machine, groups: &[Group]) -> Result<()> {
    let path = workspace.root().join("docs/benchmarks.md");
    let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let fresh = replaced(&text, &table::markdown(machine, groups))
        .with_context(|| format!("{} has no place for the table, from {START} to {END}", path.display()))?;
    fs::write(&path, fresh).with_context(|| format!("cannot write {}", path.display()))
}

fn replaced(text: &str, table: &str) -> Option<String> {
    let (before, rest) = text.split_once(START)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{START}\n\n{}\n\n{END}{after}", table.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_lies_between_the_marks_changes() {
        let text = format!("before\n{START}\nold\n{END}\nafter\n");
        let fresh = replaced(&text, "new").unwrap();
        assert_eq!(fresh, format!("before\n{START}\n\nnew\n\n{END}\nafter\n"));
        assert_eq!(replaced(&fresh, "new").unwrap(), fresh);
        assert_eq!(replaced("no marks", "new"), None);
    }
}
