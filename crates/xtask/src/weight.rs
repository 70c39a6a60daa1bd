//! What the designer weighs: the bytes that travel before the first picture.

use std::fs;
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result, bail};
use flate2::{Compression, write::GzEncoder};
use serde_json::Value;

use crate::stamp::sorted_entries;
use crate::workspace::Workspace;

/// Prints the weights and refuses a site above the budget of `web/weight.json`.
///
/// Counted are the files that are listed there, each as gzip: all that a browser asks for until the first picture is on the screen. That the list is right
/// is tested in a browser (`tests/e2e/weight.test.ts`).
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    let rules = read_json(&workspace.web().join("weight.json"))?;
    let budget = rules["budget"].as_u64().context("web/weight.json has no budget in bytes")?;
    let first: Vec<&str> = rules["first"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if !first.iter().any(|name| name.ends_with(".wasm")) {
        bail!("web/weight.json lists no WebAssembly module, and there is no picture without one");
    }

    let dist = workspace.dist();
    let assets = sorted_entries(&dist.join("assets"))?;
    let assets: Vec<String> =
        assets.iter().filter_map(|path| path.file_name()?.to_str()).map(|name| format!("assets/{name}")).collect();
    let mut total = 0;
    println!("weight to the first picture (gzip)");
    for name in first {
        let file = built(name, &assets)
            .with_context(|| format!("web/weight.json lists {name}, but the site has no such file, or several"))?;
        let bytes = fs::read(dist.join(file)).with_context(|| format!("web/dist/{file} is missing"))?;
        let size = gzip_size(&bytes)?;
        total += size;
        println!("  {:>8.1} kB  {file}", size as f64 / 1000.0);
    }
    println!("  {:>8.1} kB  of {:.0} kB", total as f64 / 1000.0, budget as f64 / 1000.0);
    if total as u64 > budget {
        bail!("the designer weighs {total} bytes, more than its budget of {budget} (web/weight.json)");
    }
    Ok(())
}

/// The one built file of a name: `assets/<stem>-<hash>.<extension>` for `assets/<stem>.<extension>`; what is in no folder is called what it is called.
fn built<'a>(name: &'a str, assets: &'a [String]) -> Option<&'a str> {
    if !name.contains('/') {
        return Some(name);
    }
    let mut found = assets.iter().filter(|file| is_named(file, name));
    match (found.next(), found.next()) {
        (Some(file), None) => Some(file),
        _ => None,
    }
}

/// Whether a file has this name, but for a hash.
fn is_named(file: &str, name: &str) -> bool {
    const HASH: usize = 8;
    let parts = || {
        let (stem, extension) = name.rsplit_once('.')?;
        let hash = file.strip_prefix(stem)?.strip_prefix('-')?.strip_suffix(extension)?.strip_suffix('.')?;
        Some(hash.len())
    };
    parts() == Some(HASH)
}

fn gzip_size(bytes: &[u8]) -> Result<usize> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::new(9));
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?.len())
}

fn read_json(path: &Path) -> Result<Value> {
    let text = fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    serde_json::from_str(&text).with_context(|| format!("{} is not JSON", path.display()))
}

#[cfg(test)]
mod tests {
    use super::{built, is_named};

    #[test]
    fn a_file_is_known_by_its_whole_name() {
        assert!(is_named("assets/bindings-a1b2c3d4.js", "assets/bindings.js"));
        assert!(is_named("assets/pasu_bg--_b2c3d4.wasm", "assets/pasu_bg.wasm"));
        assert!(!is_named("assets/drawing_bindings-a1b2c3d4.js", "assets/bindings.js"));
        assert!(!is_named("assets/pasu_drawing_bg-a1b2c3d4.wasm", "assets/pasu.wasm"));
        assert!(!is_named("assets/maker-panel-a1b2c3d4.js", "assets/maker.js"));
        assert!(!is_named("assets/index-a1b2c3d4.css", "assets/index.js"));
    }

    #[test]
    fn of_every_name_there_is_one_file() {
        let assets = ["assets/a-01234567.js", "assets/b-01234567.js", "assets/b-76543210.js"].map(str::to_owned);
        assert_eq!(built("assets/a.js", &assets), Some("assets/a-01234567.js"));
        assert_eq!(built("assets/b.js", &assets), None);
        assert_eq!(built("assets/c.js", &assets), None);
        assert_eq!(built("index.html", &assets), Some("index.html"));
    }
}
