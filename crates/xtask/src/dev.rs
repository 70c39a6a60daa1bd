//! `cargo xtask dev`: the designer, rebuilt while it is worked on.

use std::path::Path;
use std::sync::mpsc;
use std::time::Duration;

use anyhow::{Context, Result};
use notify::{EventKind, RecursiveMode, Watcher};

use crate::wasm_package::{self, Care};
use crate::workspace::Workspace;
use crate::{node, serve};

const HELP: &str = "\
cargo xtask dev [--port N]

Serves the designer with hot reloading. A change in web/ shows at once; a change in
crates/ rebuilds the WebAssembly module, and the page reloads with it.";

/// Editors write a file in several steps; a rebuild waits until nothing has happened for this long.
const QUIET: Duration = Duration::from_millis(150);

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    let Some(port) = serve::port(arguments, HELP)? else { return Ok(()) };
    let workspace = Workspace::find()?;
    node::ensure(&workspace)?;
    wasm_package::build(&workspace, Care::Fast)?;

    let (changed, changes) = mpsc::channel();
    let mut watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
        if event.is_ok_and(|event| is_change(&event)) {
            // The receiver lives as long as the process.
            let _ = changed.send(());
        }
    })
    .context("this system cannot watch files")?;
    for folder in ["crates/pasu", "crates/pasu-wasm/src", "crates/pasu-wasm/js"] {
        watcher
            .watch(&workspace.root().join(folder), RecursiveMode::Recursive)
            .with_context(|| format!("cannot watch {folder}"))?;
    }

    let mut vite = node::script(&workspace, "vite/bin/vite.js");
    if let Some(port) = port {
        vite.args(["--port", &port.to_string(), "--strictPort"]);
    }
    let mut vite = vite.spawn().context("vite cannot be started")?;
    loop {
        match changes.recv_timeout(Duration::from_secs(1)) {
            Ok(()) => {
                while changes.recv_timeout(QUIET).is_ok() {}
                // A mistake in the source is what this is for: show it and wait for the next change.
                match wasm_package::build(&workspace, Care::Fast) {
                    Ok(()) => println!("the module is up to date"),
                    Err(error) => eprintln!("{error:#}"),
                }
            }
            Err(mpsc::RecvTimeoutError::Timeout) => {
                if let Some(status) = vite.try_wait()? {
                    anyhow::ensure!(status.success(), "vite ended ({status})");
                    return Ok(());
                }
            }
            Err(mpsc::RecvTimeoutError::Disconnected) => return Ok(()),
        }
    }
}

fn is_change(event: &notify::Event) -> bool {
    let relevant = |path: &Path| !path.components().any(|part| part.as_os_str() == "target");
    matches!(event.kind, EventKind::Create(_) | EventKind::Modify(_) | EventKind::Remove(_))
        && event.paths.iter().any(|path| relevant(path))
}
