//! Writes the files that other programs judge, and in `specimens.json` what these are to find. `cargo xtask test --tools` runs it.

mod cells;
mod designs;
mod pairs;
mod sheet;

use std::fs;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};

/// So many designs of the gallery can be made into pots, at least: fewer mean that something was lost.
const FEWEST_POTS: usize = 30;

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().map(PathBuf::from).context("expected the folder to write to")?;
    // All of them, unless some are named.
    let named: Vec<String> = arguments.collect();
    let wanted = |all: Vec<designs::Specimen>| -> Vec<designs::Specimen> {
        all.into_iter().filter(|specimen| named.is_empty() || named.contains(&specimen.name)).collect()
    };
    fs::create_dir_all(&folder)?;
    let mut specimens = Vec::new();
    let mut refused = Vec::new();
    let mut pots = 0;
    let gallery = wanted(designs::gallery()?);
    for (specimen, written) in gallery.iter().zip(write_all(&folder, &gallery)) {
        match written? {
            Ok(sheet) => {
                pots += usize::from(specimen.is_pot());
                specimens.push(sheet);
            }
            Err(error) => {
                println!("{} cannot be made: {error}", specimen.name);
                refused.push(json!({ "name": specimen.name, "code": error.code().as_str(), "path": error.path(), "message": error.message() }));
            }
        }
    }
    if named.is_empty() && pots < FEWEST_POTS {
        bail!("{pots} designs of the gallery can be made into pots, expected {FEWEST_POTS} at least");
    }
    let hard = wanted(designs::hard()?.into_iter().chain(designs::blends()?).collect());
    for (specimen, written) in hard.iter().zip(write_all(&folder, &hard)) {
        match written? {
            Ok(sheet) => specimens.push(sheet),
            Err(error) => bail!("{}: {error}", specimen.name),
        }
    }
    if named.is_empty() {
        pairs::write(&folder)?;
    }
    println!("{} specimens, {} refused", specimens.len(), refused.len());
    let all = json!({ "specimens": specimens, "refused": refused });
    fs::write(folder.join("specimens.json"), serde_json::to_string_pretty(&all)?)?;
    Ok(())
}

/// Writes the files of all, on every core; the answers are in their order.
fn write_all(folder: &Path, specimens: &[designs::Specimen]) -> Vec<Result<pasu::Result<Value>>> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut written = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(specimen) = specimens.get(index) else { return written };
            written.push((index, write(folder, specimen)));
        }
    };
    let mut all = thread::scope(|scope| {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(worker)).collect();
        let answers = workers.into_iter().flat_map(|worker| worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        answers.collect::<Vec<_>>()
    });
    all.sort_by_key(|(index, _)| *index);
    all.into_iter().map(|(_, written)| written).collect()
}

/// Writes the files of one specimen and returns what is to be found in them.
fn write(folder: &Path, specimen: &designs::Specimen) -> Result<pasu::Result<Value>> {
    let expected = match sheet::expected(specimen) {
        Ok(expected) => expected,
        Err(error) => return Ok(Err(error)),
    };
    let mut files = serde_json::Map::new();
    for format in &specimen.formats {
        let bytes = match pasu::write(&specimen.design, *format, &specimen.making) {
            Ok(bytes) => bytes,
            Err(error) => return Ok(Err(error)),
        };
        let name = format!("{}.{}", specimen.name, format.name());
        fs::write(folder.join(&name), bytes).with_context(|| format!("cannot write {name}"))?;
        files.insert(format.name().to_owned(), name.into());
    }
    let cells = match cells::write(folder, specimen)? {
        Ok(cells) => cells,
        Err(error) => return Ok(Err(error)),
    };
    let mut sheet = expected;
    sheet["cells"] = cells;
    sheet["name"] = specimen.name.clone().into();
    sheet["slice"] = specimen.slice.into();
    sheet["files"] = files.into();
    Ok(Ok(sheet))
}
