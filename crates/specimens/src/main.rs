//! Writes the files that other programs judge, and in `specimens.json` what these are to find. `cargo xtask test --tools` runs it.

mod designs;
mod sheet;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};

/// So many designs of the gallery can be made into pots, at least: fewer mean that something was lost.
const FEWEST_POTS: usize = 30;

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().map(PathBuf::from).context("expected the folder to write to")?;
    // All of them, unless some are named.
    let named: Vec<String> = arguments.collect();
    let wanted = |specimen: &designs::Specimen| named.is_empty() || named.contains(&specimen.name);
    fs::create_dir_all(&folder)?;
    let mut specimens = Vec::new();
    let mut refused = Vec::new();
    let mut pots = 0;
    for specimen in designs::gallery()?.into_iter().filter(wanted) {
        match write(&folder, &specimen)? {
            Ok(sheet) => {
                pots += usize::from(specimen.is_pot());
                specimens.push(sheet);
            }
            Err(error) => {
                println!("{} cannot be made: {error}", specimen.name);
                refused.push(json!({ "name": specimen.name, "code": error.code(), "path": error.path(), "message": error.message() }));
            }
        }
    }
    if named.is_empty() && pots < FEWEST_POTS {
        bail!("{pots} designs of the gallery can be made into pots, expected {FEWEST_POTS} at least");
    }
    for specimen in designs::hard()?.into_iter().filter(wanted) {
        match write(&folder, &specimen)? {
            Ok(sheet) => specimens.push(sheet),
            Err(error) => bail!("{}: {error}", specimen.name),
        }
    }
    println!("{} specimens, {} refused", specimens.len(), refused.len());
    let all = json!({ "specimens": specimens, "refused": refused });
    fs::write(folder.join("specimens.json"), serde_json::to_string_pretty(&all)?)?;
    Ok(())
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
    let mut sheet = expected;
    sheet["name"] = specimen.name.clone().into();
    sheet["slice"] = specimen.slice.into();
    sheet["files"] = files.into();
    Ok(Ok(sheet))
}
