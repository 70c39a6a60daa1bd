//! `cargo xtask bench`: how fast surfaces are computed, natively, in Node and in Chromium, in one table.

mod document;
mod machine;
mod measurement;
mod runner;
mod table;

use anyhow::{Result, bail};

use self::machine::Machine;
use self::measurement::Group;
use self::runner::Runner;
use crate::wasm_package::{self, Care};
use crate::workspace::Workspace;
use crate::{node, site};

const HELP: &str = "\
cargo xtask bench [options] [native] [node] [chromium]
cargo xtask bench storage

Measures solving and sampling against what else there is: natively, in Node, in Chromium and on the page.
The contenders of a group take turns, and every ratio is that of two contenders in the same turns.

  storage                  prints how much networks of patches take to store, beside NURBS patches and polygons; docs/frames.md
  native, node, chromium   only these; all of them otherwise
  --quick                  a few turns, to see that it runs
  --check                  fails when a target is missed by more than 15 %
  --json                   prints the samples instead of the table
  --write                  puts the table into docs/benchmarks.md";

/// What the command line asks for.
#[derive(Debug, Default, PartialEq)]
struct Wishes {
    quick: bool,
    check: bool,
    json: bool,
    write: bool,
    runners: Vec<Runner>,
}

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    if arguments == ["storage"] {
        print!("{}", runner::storage(&Workspace::find()?)?);
        return Ok(());
    }
    let Some(wishes) = read(arguments)? else {
        println!("{HELP}");
        return Ok(());
    };
    let load = machine::load();
    let workspace = Workspace::find()?;
    prepare(&workspace, &wishes.runners)?;
    let mut groups = Vec::new();
    for runner in &wishes.runners {
        eprintln!("measuring {}", runner.place());
        groups.extend(runner.measure(&workspace, wishes.quick)?);
    }
    let machine = Machine::this(&workspace, &wishes.runners, load)?;
    if wishes.json {
        println!(
            "{}",
            serde_json::json!({ "machine": machine.lines(), "groups": groups.iter().map(Group::to_json).collect::<Vec<_>>() })
        );
    } else {
        println!("{}", table::text(&machine, &groups));
    }
    if wishes.write {
        document::write(&workspace, &machine, &groups)?;
    }
    let missed: Vec<String> = groups.iter().flat_map(Group::missed).collect();
    if wishes.check && !missed.is_empty() {
        bail!("missed by more than {:.0} %:\n  {}", 100.0 * measurement::LEEWAY, missed.join("\n  "));
    }
    Ok(())
}

/// Reads the command line; nothing when it asks for help.
fn read(arguments: &[String]) -> Result<Option<Wishes>> {
    let mut wishes = Wishes::default();
    for argument in arguments {
        match argument.as_str() {
            "--help" | "-h" => return Ok(None),
            "--quick" => wishes.quick = true,
            "--check" => wishes.check = true,
            "--json" => wishes.json = true,
            "--write" => wishes.write = true,
            name => match Runner::named(name) {
                Some(runner) => wishes.runners.push(runner),
                None => bail!("not understood: {name}\n\n{HELP}"),
            },
        }
    }
    if wishes.runners.is_empty() {
        wishes.runners = Runner::ALL.to_vec();
    }
    if wishes.write && (wishes.quick || wishes.runners.len() < Runner::ALL.len()) {
        bail!("--write is for the whole table: leave out --quick and the names of runners");
    }
    Ok(Some(wishes))
}

/// Builds what is measured, as it ships.
fn prepare(workspace: &Workspace, runners: &[Runner]) -> Result<()> {
    if runners == [Runner::Native] {
        return Ok(());
    }
    node::ensure(workspace)?;
    wasm_package::build(workspace, Care::Release)?;
    wasm_package::build_bench(workspace)?;
    if runners.contains(&Runner::Chromium) { site::build(workspace, Care::Release) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_read() {
        let read = |words: &[&str]| read(&words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>());
        let all = read(&["--check"]).unwrap().unwrap();
        assert!(all.check && !all.quick && all.runners == Runner::ALL);
        assert_eq!(read(&["node", "--quick"]).unwrap().unwrap().runners, [Runner::Node]);
        assert!(read(&["--help"]).unwrap().is_none());
        assert!(
            read(&["--write", "--quick"]).is_err() && read(&["--write", "node"]).is_err() && read(&["deno"]).is_err()
        );
    }
}
