//! `cargo xtask test --tools`: programs that people have judge the files that Pasu writes.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};

use crate::report::{Report, node_count};
use crate::stamp::Stamp;
use crate::wasm_package::{self, Care};
use crate::workspace::{Workspace, cargo};
use crate::{command, debian};

/// Each program and the script by which it judges; those in Python have packages of their own.
const JUDGES: [(&str, &str); 9] = [
    ("Manifold", "with_manifold.py"),
    ("Manifold, pairs", "with_manifold_pairs.py"),
    ("trimesh", "with_trimesh.py"),
    ("lib3mf", "with_lib3mf.py"),
    ("OpenCASCADE", "with_opencascade.py"),
    ("PrusaSlicer", "with_prusaslicer.py"),
    ("resvg", "with_resvg.py"),
    ("meshio", "with_meshio.py"),
    ("scikit-fem", "with_scikit_fem.py"),
];

/// Writes the specimens and has every program judge them.
pub(crate) fn check(report: &mut Report, workspace: &Workspace) {
    report.check("Python packages", || install_packages(workspace));
    report.check("PrusaSlicer is here", ensure_slicer);
    report.check("specimens", || write_specimens(workspace));
    for (name, script) in JUDGES {
        report.tests(name, node_count, || {
            let mut judge = Command::new(python(workspace));
            judge.arg(scripts(workspace).join(script)).arg(specimens(workspace));
            // The folder of the scripts is one of sources.
            judge.env("PYTHONDONTWRITEBYTECODE", "1").env("PYTHONUTF8", "1");
            Ok(judge)
        });
    }
    report.check("library package", || wasm_package::build(workspace, Care::Release));
    for (name, script) in [("glTF validator", "with_gltf_validator.mjs"), ("WebAssembly", "with_webassembly.mjs")] {
        report.tests(name, node_count, || {
            let mut judge = Command::new("node");
            judge.arg(scripts(workspace).join(script)).arg(specimens(workspace));
            Ok(judge)
        });
    }
}

fn scripts(workspace: &Workspace) -> PathBuf {
    workspace.root().join("tests/tools")
}

fn specimens(workspace: &Workspace) -> PathBuf {
    workspace.target().join("tools/specimens")
}

/// The Python of the virtual environment.
fn python(workspace: &Workspace) -> PathBuf {
    let place = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
    environment(workspace).join(place)
}

fn environment(workspace: &Workspace) -> PathBuf {
    workspace.target().join("tools/python")
}

/// Makes the virtual environment when the list of packages or the Python has changed since.
fn install_packages(workspace: &Workspace) -> Result<()> {
    let system = if cfg!(windows) { "python" } else { "python3" };
    let version = command::read(Command::new(system).arg("--version"))
        .context("Python is missing; get version 3.11 or later from https://www.python.org")?;
    let list = scripts(workspace).join("requirements.txt");
    let stamp = Stamp::of(workspace, "python-packages", version.trim(), std::slice::from_ref(&list))?;
    if stamp.is_fresh() && python(workspace).is_file() {
        return Ok(());
    }
    stamp.clear();
    println!("installing Python packages");
    let folder = environment(workspace);
    let make = || command::run(Command::new(system).args(["-m", "venv", "--clear"]).arg(&folder));
    if let Err(error) = make() {
        // Debian keeps a part of Python's own library in a package of its own.
        if !debian::is_at_hand() {
            return Err(error.context("no virtual environment could be made; Debian and its kin want `python3-venv`"));
        }
        debian::install("python3-venv")?;
        make()?;
    }
    let mut pip = Command::new(python(workspace));
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps"]);
    command::run(pip.args(["--only-binary", ":all:", "--requirement"]).arg(&list)).context(
        "the packages of tests/tools/requirements.txt could not be installed; they want Python 3.11 or later",
    )?;
    stamp.save()
}

/// Looks for PrusaSlicer, and installs Debian's where that is possible.
fn ensure_slicer() -> Result<()> {
    let found = || debian::on_path(&["prusa-slicer", "prusa-slicer.exe"]);
    if found().is_none() && debian::is_at_hand() {
        debian::install("prusa-slicer")?;
    }
    found().map(|_| ()).context(
        "PrusaSlicer is missing: install it with `apt install prusa-slicer` or from https://www.prusa3d.com so that \
         `prusa-slicer` is on the PATH",
    )
}

/// Writes the files, unless nothing that they depend on has changed.
fn write_specimens(workspace: &Workspace) -> Result<()> {
    let folder = specimens(workspace);
    let inputs = ["crates/pasu", "crates/specimens", "tests/reference/gallery.json", "Cargo.toml", "Cargo.lock"];
    let inputs: Vec<PathBuf> = inputs.iter().map(|input| workspace.root().join(input)).collect();
    let stamp = Stamp::of(workspace, "specimens", "", &inputs)?;
    if stamp.is_fresh() && folder.join("specimens.json").is_file() {
        return Ok(());
    }
    stamp.clear();
    if folder.exists() {
        fs::remove_dir_all(&folder).with_context(|| format!("cannot empty {}", folder.display()))?;
    }
    let mut write = Command::new(cargo());
    // With the features that the native tests compile `pasu` with, which then is compiled already.
    write.args(["run", "--quiet", "--package", "specimens", "--features", "pasu/typescript", "--"]);
    write.arg(&folder).current_dir(workspace.root());
    command::run(&mut write)?;
    stamp.save()
}
