//! `cargo xtask test --package`: the crate `pasu` as crates.io would have it, and whether its interface is still that of the last tag.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::command;
use crate::report::{Report, cargo_count};
use crate::workspace::{Workspace, cargo};

/// Packs the crate, unpacks it where nothing else is, has its tests compile and run there, and compares interfaces.
pub(crate) fn check(report: &mut Report, workspace: &Workspace) {
    report.check("crate is packed", || unpack(workspace));
    let cargo = |arguments: &[&str]| {
        let mut command = Command::new(cargo());
        command.args(arguments).arg("--all-features").current_dir(folder(workspace));
        // Optimised as in the workspace, of which nothing is known there, and beside what was compiled for that: the packages that both stand on are the same.
        command.arg("--config").arg(workspace.root().join("Cargo.toml"));
        command.env("CARGO_TARGET_DIR", workspace.target());
        command
    };
    // Nothing that these tests read is looked for when they run (a rule of the house), so that whatever is missing in a package keeps them from being compiled. Where
    // they ran just before, from the same sources, they need not run again.
    if std::env::var_os("CI").is_some() {
        report.check("tests of the crate compile", || command::run(&mut cargo(&["check", "--all-targets"])));
        report.tests("unit tests of the crate", cargo_count, || Ok(cargo(&["test", "--lib", "--no-fail-fast"])));
    } else {
        report.tests("tests of the crate", cargo_count, || Ok(cargo(&["test", "--no-fail-fast"])));
    }
    report.check("interface since the last tag", || interface(workspace));
}

/// Outside the repository: in a folder below, Cargo would find the workspace, and a test a file that is not in the package.
fn folder(workspace: &Workspace) -> PathBuf {
    let mark =
        workspace.root().to_string_lossy().bytes().fold(0u32, |mark, byte| mark.rotate_left(5) ^ u32::from(byte));
    std::env::temp_dir().join(format!("pasu-crate-{mark:08x}"))
}

fn unpack(workspace: &Workspace) -> Result<()> {
    // Also what is not committed yet; whether it compiles is seen below.
    let packing = ["package", "--package", "pasu", "--no-verify", "--allow-dirty", "--quiet"];
    command::run(Command::new(cargo()).args(packing).current_dir(workspace.root()))?;
    let folder = folder(workspace);
    if folder.exists() {
        fs::remove_dir_all(&folder).with_context(|| format!("cannot empty {}", folder.display()))?;
    }
    fs::create_dir_all(&folder)?;
    let packed = workspace.target().join(format!("package/pasu-{}.crate", env!("CARGO_PKG_VERSION")));
    // Files in a package are as old as 2006, which Cargo would take for files that it has compiled before: they are to be of today.
    command::run(Command::new("tar").arg("-xzmf").arg(packed).args(["--strip-components", "1", "-C"]).arg(&folder))?;
    for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
        if fs::read(folder.join(licence)).ok() != fs::read(workspace.root().join(licence)).ok() {
            bail!(
                "{licence} in the package is not that of the repository; are symbolic links off? (git config core.symlinks true)"
            );
        }
    }
    Ok(())
}

/// `cargo semver-checks` against the last tag `v..`, once there is one. It is installed when first needed.
fn interface(workspace: &Workspace) -> Result<()> {
    let tags = command::read(
        Command::new("git")
            .args(["tag", "--list", "v*", "--merged", "HEAD", "--sort=-v:refname"])
            .current_dir(workspace.root()),
    )?;
    let Some(last) = tags.lines().next() else {
        println!("there is no tag v.. yet with which the interface could be compared");
        return Ok(());
    };
    let is_installed =
        Command::new(cargo()).args(["semver-checks", "--version"]).output().is_ok_and(|output| output.status.success());
    if !is_installed {
        command::run(Command::new(cargo()).args(["install", "--locked", "cargo-semver-checks"]))?;
    }
    let comparing = ["semver-checks", "--package", "pasu", "--all-features", "--baseline-rev", last];
    command::run(Command::new(cargo()).args(comparing).current_dir(workspace.root()))
}
