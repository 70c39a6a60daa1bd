//! Programs that Debian has, where they may be installed.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::command;

/// Whether packages can be installed here without asking anyone.
pub(crate) fn is_at_hand() -> bool {
    Path::new("/etc/debian_version").exists()
        && command::read(Command::new("id").arg("-u")).is_ok_and(|id| id.trim() == "0")
}

/// Installs a package.
pub(crate) fn install(package: &str) -> Result<()> {
    eprintln!("installing Debian's {package}");
    let apt = |arguments: &[&str]| {
        command::run(Command::new("apt-get").args(arguments).env("DEBIAN_FRONTEND", "noninteractive"))
    };
    apt(&["update", "-q"])?;
    apt(&["install", "-y", "-q", "--no-install-recommends", package])
}

/// A program on the path.
pub(crate) fn on_path(names: &[&str]) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path)
        .flat_map(|folder| names.iter().map(|name| folder.join(name)).collect::<Vec<_>>())
        .find(|candidate| candidate.is_file())
}
