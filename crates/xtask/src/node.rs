//! Node and the npm packages of the designer.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::command;
use crate::stamp::Stamp;
use crate::workspace::Workspace;

/// The oldest Node that runs the tools: (major, minor).
const OLDEST: (u32, u32) = (20, 19);

/// Checks Node and installs the npm packages when the lock file has changed since they were installed.
pub(crate) fn ensure(workspace: &Workspace) -> Result<()> {
    let version = command::read(Command::new("node").arg("--version"))
        .context("Node is missing; get version 20.19 or later from https://nodejs.org")?;
    if !new_enough(&version) {
        bail!("Node {} is too old; get version 20.19 or later from https://nodejs.org", version.trim());
    }
    let web = workspace.web();
    let stamp =
        Stamp::of(workspace, "npm", version.trim(), &[web.join("package.json"), web.join("package-lock.json")])?;
    if stamp.is_fresh() && web.join("node_modules").is_dir() {
        return Ok(());
    }
    eprintln!("installing npm packages");
    stamp.clear();
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    command::run(Command::new(npm).args(["ci", "--no-audit", "--no-fund"]).current_dir(&web))
        .context("the npm packages could not be installed; see why with `npm ci` in the folder web")?;
    stamp.save()
}

/// `node <script>` for a script inside an npm package, run in `web`: no shell, the same on every system.
pub(crate) fn script(workspace: &Workspace, script: &str) -> Command {
    let mut command = Command::new("node");
    command.arg(module(workspace, script)).current_dir(workspace.web()).env("NO_COLOR", "1");
    command
}

/// A file of an installed npm package.
pub(crate) fn module(workspace: &Workspace, path: &str) -> PathBuf {
    workspace.web().join("node_modules").join(path)
}

fn new_enough(version: &str) -> bool {
    let mut numbers = version.trim().trim_start_matches('v').split('.').map(|number| number.parse::<u32>());
    match (numbers.next(), numbers.next()) {
        (Some(Ok(major)), Some(Ok(minor))) => (major, minor) >= OLDEST,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::new_enough;

    #[test]
    fn versions_are_compared_as_numbers() {
        assert!(new_enough("v20.19.0\n"));
        assert!(new_enough("v22.3.1"));
        assert!(!new_enough("v20.9.0"));
        assert!(!new_enough("v18.20.4"));
        assert!(!new_enough("nonsense"));
    }
}
