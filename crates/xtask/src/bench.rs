//! `cargo xtask bench`: how fast surfaces are computed.

use std::process::Command;

use anyhow::{Result, bail};

use crate::command;
use crate::workspace::{Workspace, cargo};

const HELP: &str = "\
cargo xtask bench

Measures solving and sampling on this machine, native, optimised.";

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    match arguments {
        [] => {}
        [help] if help == "--help" || help == "-h" => {
            println!("{HELP}");
            return Ok(());
        }
        _ => bail!("`bench` takes no arguments\n\n{HELP}"),
    }
    let workspace = Workspace::find()?;
    let bench = ["run", "--quiet", "--release", "--package", "bench"];
    command::run(Command::new(cargo()).args(bench).current_dir(workspace.root()))
}
