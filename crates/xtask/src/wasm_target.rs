//! The WebAssembly target of the Rust toolchain.

use std::process::Command;

use anyhow::{Context, Result};

use crate::command;
use crate::workspace::Workspace;

/// The target triple.
pub(crate) const TRIPLE: &str = "wasm32-unknown-unknown";

/// Installs the target when it is missing: rustup does so by itself only where automatic installation is on.
pub(crate) fn ensure(workspace: &Workspace) -> Result<()> {
    let installed =
        Command::new("rustup").args(["target", "list", "--installed"]).current_dir(workspace.root()).output();
    let Ok(installed) = installed else {
        // A toolchain without rustup has to bring the target itself; cargo says so if it does not.
        return Ok(());
    };
    if String::from_utf8_lossy(&installed.stdout).lines().any(|line| line.trim() == TRIPLE) {
        return Ok(());
    }
    println!("installing the Rust target {TRIPLE}");
    command::run(Command::new("rustup").args(["target", "add", TRIPLE]).current_dir(workspace.root()))
        .with_context(|| format!("the Rust target {TRIPLE} is missing; get it with `rustup target add {TRIPLE}`"))
}
