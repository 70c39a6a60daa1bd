//! What the designer weighs: the bytes that travel before the first picture.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result, bail};
use flate2::{Compression, write::GzEncoder};
use serde_json::Value;

use crate::stamp::sorted_entries;
use crate::workspace::Workspace;

/// Prints the parts and refuses a site above the budget of `web/weight.json`.
///
/// Counted are the page, its styles, every script that it loads by itself (also those that it imports while it starts),
/// and what these name of the rest, worker and WebAssembly module, each as gzip. Not counted are modules listed there as `later`, which are
/// loaded by a gesture or beside the pot, which does not wait for them, files listed as `later files`, workers and modules
/// of which the same is true, with what they alone name, and the icons, manifest and service worker, which the first picture does not wait for.
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    let rules = read_json(&workspace.web().join("weight.json"))?;
    let budget = rules["budget"].as_u64().context("web/weight.json has no budget in bytes")?;
    let words = |list: &'static str| rules[list].as_array().into_iter().flatten().filter_map(Value::as_str);

    let dist = workspace.dist();
    let manifest = read_json(&dist.join(".vite/manifest.json"))?;
    let later: Vec<&str> = words("later").map(|module| chunk_key(&manifest, module)).collect::<Result<_>>()?;
    let mut files = first_files(&manifest, &later);
    files.insert("index.html".into());
    let unlisted = unlisted_files(&dist, &manifest, &words("later files").collect::<Vec<_>>())?;
    add_named(&mut files, &unlisted, |file| {
        let bytes = fs::read(dist.join(file)).with_context(|| format!("web/dist/{file} is missing"))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    })?;
    if !files.iter().any(|file| file.ends_with(".wasm")) {
        bail!("no WebAssembly module was found among what the first picture takes, and there must be one");
    }

    let mut total = 0;
    let mut parts: BTreeMap<&str, usize> = BTreeMap::new();
    println!("weight to the first picture (gzip)");
    for file in &files {
        let bytes = fs::read(dist.join(file)).with_context(|| format!("web/dist/{file} is missing"))?;
        let size = gzip_size(&bytes)?;
        total += size;
        *parts.entry(part(file)).or_default() += size;
        println!("  {:>8.1} kB  {file}", size as f64 / 1000.0);
    }
    let parts: Vec<String> =
        parts.iter().map(|(part, size)| format!("{part} {:.1} kB", *size as f64 / 1000.0)).collect();
    println!("  {}", parts.join(", "));
    println!("  {:>8.1} kB  of {:.0} kB", total as f64 / 1000.0, budget as f64 / 1000.0);
    if total as u64 > budget {
        bail!("the designer weighs {total} bytes, more than its budget of {budget} (web/weight.json)");
    }
    Ok(())
}

/// Whose weight a file is.
fn part(file: &str) -> &'static str {
    if file.ends_with(".wasm") {
        "module"
    } else if file.contains("/three-") {
        "three"
    } else {
        "page"
    }
}

/// The manifest's key of a module that has a chunk of its own: its path, or, where several share it, a key made of its name.
fn chunk_key<'a>(manifest: &'a Value, module: &str) -> Result<&'a str> {
    let stem = Path::new(module).file_stem().and_then(|stem| stem.to_str());
    let chunks = || manifest.as_object().into_iter().flatten();
    chunks()
        .find(|(key, _)| *key == module)
        .or_else(|| chunks().find(|(key, chunk)| key.starts_with('_') && chunk["name"].as_str() == stem))
        .map(|(key, _)| key.as_str())
        .with_context(|| format!("web/weight.json lists {module} as loaded later, but the site has no such chunk"))
}

/// The scripts and styles of the page and of everything it imports, except what is loaded later.
fn first_files(manifest: &Value, later: &[&str]) -> BTreeSet<String> {
    let mut files = BTreeSet::new();
    let mut seen = BTreeSet::new();
    let mut waiting: Vec<&str> = manifest
        .as_object()
        .into_iter()
        .flatten()
        .filter(|(_, chunk)| chunk["isEntry"].as_bool() == Some(true))
        .map(|(key, _)| key.as_str())
        .collect();
    while let Some(key) = waiting.pop() {
        if later.contains(&key) || !seen.insert(key) {
            continue;
        }
        let chunk = &manifest[key];
        files.extend(chunk["file"].as_str().map(str::to_owned));
        files.extend(chunk["css"].as_array().into_iter().flatten().filter_map(Value::as_str).map(str::to_owned));
        for list in ["imports", "dynamicImports"] {
            waiting.extend(chunk[list].as_array().into_iter().flatten().filter_map(Value::as_str));
        }
    }
    files
}

/// Scripts of workers and WebAssembly modules, without those of `later`: vite's manifest does not list them.
fn unlisted_files(dist: &Path, manifest: &Value, later: &[&str]) -> Result<Vec<String>> {
    let listed: BTreeSet<&str> =
        manifest.as_object().into_iter().flatten().filter_map(|(_, chunk)| chunk["file"].as_str()).collect();
    let names = sorted_entries(&dist.join("assets"))?;
    Ok(names
        .iter()
        .filter(|path| path.extension().is_some_and(|extension| extension == "js" || extension == "wasm"))
        .filter_map(|path| path.file_name()?.to_str())
        .filter(|name| !later.iter().any(|stem| is_named(name, stem)))
        .map(|name| format!("assets/{name}"))
        .filter(|file| !listed.contains(file.as_str()) || file.ends_with(".wasm"))
        .collect())
}

/// Whether a built file is `<stem>-<hash>.<extension>`.
fn is_named(file: &str, stem: &str) -> bool {
    const HASH: usize = 8;
    let rest = file.strip_prefix(stem).and_then(|rest| rest.strip_prefix('-'));
    rest.and_then(|rest| rest.find('.')) == Some(HASH)
}

/// Adds the unlisted files that the files name, and those that these name.
fn add_named(files: &mut BTreeSet<String>, unlisted: &[String], read: impl Fn(&str) -> Result<String>) -> Result<()> {
    let mut waiting: Vec<String> = files.iter().cloned().collect();
    while let Some(file) = waiting.pop() {
        if file.ends_with(".wasm") {
            continue;
        }
        let text = read(&file)?;
        for other in unlisted {
            let name = other.rsplit('/').next().unwrap_or(other);
            if text.contains(name) && files.insert(other.clone()) {
                waiting.push(other.clone());
            }
        }
    }
    Ok(())
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
    use std::collections::BTreeSet;

    use super::{add_named, first_files, is_named};

    #[test]
    fn what_is_loaded_later_is_not_counted_and_cycles_end() {
        let manifest = serde_json::json!({
            "index.html": { "file": "a.js", "isEntry": true, "css": ["a.css"], "imports": ["_b"], "dynamicImports": ["c.ts", "d.ts"] },
            "_b": { "file": "b.js", "imports": ["index.html"] },
            "c.ts": { "file": "c.js" },
            "d.ts": { "file": "d.js", "imports": ["e.ts"] },
            "e.ts": { "file": "e.js" },
        });
        let files: Vec<String> = first_files(&manifest, &["d.ts"]).into_iter().collect();
        assert_eq!(files, ["a.css", "a.js", "b.js", "c.js"]);
    }

    #[test]
    fn what_a_counted_file_names_is_counted_and_what_only_a_later_one_names_is_not() {
        let texts = |file: &str| match file {
            "index.html" => "<script src=assets/page-01234567.js>",
            "assets/page-01234567.js" => "new Worker('solver-01234567.js'); new Worker('maker-01234567.js')",
            "assets/solver-01234567.js" => "fetch('pasu_drawing_bg-01234567.wasm')",
            _ => panic!("{file} is not counted and need not be read"),
        };
        let unlisted = ["solver-01234567.js", "pasu_drawing_bg-01234567.wasm", "pasu_bg-01234567.wasm"];
        let unlisted = unlisted.map(|name| format!("assets/{name}"));
        let mut files = BTreeSet::from(["index.html".to_owned(), "assets/page-01234567.js".to_owned()]);
        add_named(&mut files, &unlisted, |file| Ok(texts(file).to_owned())).expect("every file is read");
        assert!(files.contains("assets/solver-01234567.js") && files.contains("assets/pasu_drawing_bg-01234567.wasm"));
        assert_eq!(files.len(), 4);
    }

    #[test]
    fn a_file_is_known_by_its_whole_name() {
        assert!(is_named("bindings-a1b2c3d4.js", "bindings"));
        assert!(is_named("pasu_bg--_b2c3d4.wasm", "pasu_bg"));
        assert!(!is_named("drawing_bindings-a1b2c3d4.js", "bindings"));
        assert!(!is_named("pasu_drawing_bg-a1b2c3d4.wasm", "pasu"));
        assert!(!is_named("maker-panel-a1b2c3d4.js", "maker"));
    }
}
