//! The inside of a solid as cells in every format, and what is to be found in them.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use pasu::{CellShape, CellsFormat, CellsOptions, Solution};
use serde_json::{Value, json};

use crate::designs::Specimen;

/// Writes the cells of the first part: of every shape, fineness and format. Lengths are millimetres.
pub(crate) fn write(folder: &Path, specimen: &Specimen) -> Result<pasu::Result<Value>> {
    let solution = Solution::of(&specimen.design);
    let millimetres = specimen.design.unit().millimetres();
    let mut all = Vec::new();
    for (fineness, counts) in specimen.cells.iter().enumerate() {
        for shape in [CellShape::Hexahedron, CellShape::Tetrahedron] {
            let options = CellsOptions { counts: *counts, shape };
            let cells = match solution.cells(0, &options) {
                Ok(cells) => cells,
                Err(error) => return Ok(Err(error)),
            };
            let mut files = serde_json::Map::new();
            for format in CellsFormat::ALL {
                let bytes = match solution.cells_file(0, &options, format) {
                    Ok(bytes) => bytes,
                    Err(error) => return Ok(Err(error)),
                };
                let name = format!("{}-{}-{fineness}.{}", specimen.name, shape.name(), format.name());
                fs::write(folder.join(&name), bytes).with_context(|| format!("cannot write {name}"))?;
                files.insert(format.name().to_owned(), name.into());
            }
            all.push(json!({
                "shape": shape.name(),
                "fineness": fineness,
                "points": cells.n_points(),
                "cells": cells.n_cells(),
                "volume": cells.volume() * millimetres * millimetres * millimetres,
                "least_quality": cells.least_quality(),
                "files": files,
            }));
        }
    }
    Ok(Ok(Value::Array(all)))
}
