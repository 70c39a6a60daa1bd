//! A Chromium for the browser tests.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::workspace::Workspace;
use crate::{command, debian, node};

/// The variable that names a browser to use.
pub(crate) const VARIABLE: &str = "PASU_BROWSER";

/// Chromium without windows: the same engine and the same pages, which open in half the time because no browser is built round each.
const SHELL: &str = "chromium-headless-shell";

const NAMES: [&str; 8] = [
    SHELL,
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "microsoft-edge",
    "microsoft-edge-stable",
];

/// Where browsers live that are not on the path.
const PLACES: [&str; 6] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
];

/// A browser that is installed, else Debian's, else the one that Playwright downloads.
pub(crate) fn ensure(workspace: &Workspace) -> Result<PathBuf> {
    if let Some(named) = std::env::var_os(VARIABLE) {
        let named = PathBuf::from(named);
        if named.is_file() {
            return Ok(named);
        }
        bail!("{VARIABLE} names {}, which is not there", named.display());
    }
    if let Some(found) = installed() {
        return Ok(found);
    }
    if debian::is_at_hand() {
        for package in [SHELL, "chromium"] {
            match (debian::install(package), installed()) {
                (Ok(()), Some(found)) => return Ok(found),
                (Err(error), _) => eprintln!("that did not work: {error:#}"),
                (Ok(()), None) => eprintln!("that did not bring a browser"),
            }
        }
    }
    eprintln!("installing Playwright's chromium");
    command::run(node::script(workspace, "playwright-core/cli.js").args(["install", "--no-shell", "chromium"]))
        .ok()
        .and_then(|()| downloaded(workspace))
        .context(
            "no browser was found for the browser tests; install Chromium or Google Chrome, or set PASU_BROWSER to one, \
             or leave these tests out with `cargo xtask test --fast`",
        )
}

fn installed() -> Option<PathBuf> {
    debian::on_path(&NAMES).or_else(|| PLACES.iter().map(PathBuf::from).find(|candidate| candidate.is_file()))
}

/// Where Playwright puts its own.
fn downloaded(workspace: &Workspace) -> Option<PathBuf> {
    const ASK: &str = "process.stdout.write(require('playwright-core').chromium.executablePath())";
    let path = command::read(Command::new("node").args(["-e", ASK]).current_dir(workspace.web())).ok()?;
    Some(PathBuf::from(path)).filter(|path| path.is_file())
}
