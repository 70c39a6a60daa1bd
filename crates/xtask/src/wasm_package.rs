//! The npm package: Rust to WebAssembly, bindings, optimisation, and the files around them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use anyhow::{Context, Result, bail};
use wasm_bindgen_cli_support::Bindgen;

use crate::stamp::Stamp;
use crate::workspace::{Workspace, cargo};
use crate::{command, node, wasm_target};

/// How carefully the module is compiled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Care {
    /// For working: recompiled in a second or two.
    Fast,
    /// For shipping: optimised as a whole, then by wasm-opt.
    Release,
}

impl Care {
    /// The profile in Cargo.toml.
    fn profile(self) -> &'static str {
        match self {
            Care::Fast => "wasm-fast",
            Care::Release => "wasm",
        }
    }
}

/// Files that are copied into the package as they are.
const COPIED: [(&str, &str); 11] = [
    ("crates/pasu-wasm/js/pasu.js", "pasu.js"),
    ("crates/pasu-wasm/js/drawing.js", "drawing.js"),
    ("crates/pasu-wasm/js/known.js", "known.js"),
    ("crates/pasu-wasm/js/wrapper.js", "wrapper.js"),
    ("crates/pasu-wasm/js/pasu.d.ts", "pasu.d.ts"),
    ("crates/pasu-wasm/js/drawing.d.ts", "drawing.d.ts"),
    ("crates/pasu-wasm/js/design.d.ts", "design.d.ts"),
    ("crates/pasu-wasm/js/answers.d.ts", "answers.d.ts"),
    ("crates/pasu-wasm/js/README.md", "README.md"),
    ("LICENSE-MIT", "LICENSE-MIT"),
    ("LICENSE-APACHE", "LICENSE-APACHE"),
];

/// This program's own text, which decides too: it holds the options of every step.
const OWN_TEXT: &str = "crates/xtask/src/wasm_package.rs";

/// What wasm-opt may assume: the features that rustc compiles for by default, present in every browser since 2022.
const WASM_OPT: [&str; 10] = [
    "-O3",
    // The loops of the kernel stay functions of their own: put into their one caller, they run out of registers and take a fifth longer.
    "--one-caller-inline-max-function-size=100",
    "--enable-bulk-memory",
    "--enable-bulk-memory-opt",
    "--enable-multivalue",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-reference-types",
    "--enable-sign-ext",
    "--enable-simd",
];

/// Builds the package into `crates/pasu-wasm/pkg`; unchanged inputs rebuild nothing.
pub(crate) fn build(workspace: &Workspace, care: Care) -> Result<()> {
    wasm_target::ensure(workspace)?;
    let package = workspace.package();
    fs::create_dir_all(&package)?;

    let module = |lanes, content| compile(workspace, "pasu-wasm", care, lanes, content);
    // What is optimised as a whole keeps one processor busy, and so each of these compiles beside the others in a folder of its own. That some of the crates
    // below are compiled more than once takes less time than waiting for one another does.
    let (drawing, scalar, whole) = thread::scope(|scope| {
        let drawing = scope.spawn(|| module(Lanes::Simd, Content::Drawing));
        let scalar = scope.spawn(|| module(Lanes::Scalar, Content::Whole));
        let whole = module(Lanes::Simd, Content::Whole);
        (drawing.join(), scalar.join(), whole)
    });
    let of_thread =
        |result: thread::Result<Result<PathBuf>>| result.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
    let (drawing, scalar, whole) = (of_thread(drawing)?, of_thread(scalar)?, whole?);

    step(workspace, "module for drawing", care, &[&drawing], &["pasu_drawing_bg.wasm", "drawing_bindings.js"], || {
        let bound = bind(workspace, &drawing, "pasu_drawing", care, "bindgen-drawing")?;
        write(&package.join("pasu_drawing_bg.wasm"), &fs::read(bound.module)?)?;
        write(&package.join("drawing_bindings.js"), &fs::read(bound.script)?)
    })?;
    let products = ["pasu_bg.wasm", "pasu_scalar_bg.wasm", "bindings.js"];
    step(workspace, "whole module", care, &[&whole, &scalar], &products, || {
        let bound = bind(workspace, &whole, "pasu", care, "bindgen")?;
        write(&package.join("pasu_bg.wasm"), &fs::read(bound.module)?)?;
        let glue = fs::read(bound.script)?;
        write(&package.join("bindings.js"), &glue)?;
        let bound = bind(workspace, &scalar, "pasu", care, "bindgen-scalar")?;
        if fs::read(bound.script)? != glue {
            bail!("the module without SIMD has bindings of its own, but pasu.js loads both by those of the other");
        }
        write(&package.join("pasu_scalar_bg.wasm"), &fs::read(bound.module)?)
    })?;
    for (from, to) in COPIED {
        let from = workspace.root().join(from);
        write(&package.join(to), &fs::read(&from).with_context(|| format!("cannot read {}", from.display()))?)?;
    }
    write(&package.join("package.json"), manifest(workspace)?.as_bytes())
}

/// Makes `products` in the package from compiled modules, unless neither these nor the way of making them have changed.
fn step(
    workspace: &Workspace,
    name: &str,
    care: Care,
    inputs: &[&Path],
    products: &[&str],
    make: impl FnOnce() -> Result<()>,
) -> Result<()> {
    let mut inputs: Vec<PathBuf> = inputs.iter().map(|input| input.to_path_buf()).collect();
    inputs.push(workspace.root().join(OWN_TEXT));
    let stamp = Stamp::of(workspace, &name.replace(' ', "-"), &format!("{care:?}"), &inputs)?;
    if stamp.is_fresh() && products.iter().all(|product| workspace.package().join(product).is_file()) {
        return Ok(());
    }
    stamp.clear();
    eprintln!("writing the {name} of the package crates/pasu-wasm/pkg");
    make()?;
    stamp.save()
}

/// Builds the module that only the benchmarks use, with the same care, into `crates/bench-wasm/pkg`.
pub(crate) fn build_bench(workspace: &Workspace) -> Result<()> {
    wasm_target::ensure(workspace)?;
    let care = Care::Release;
    let compiled = compile(workspace, "bench-wasm", care, Lanes::Simd, Content::Whole)?;
    let own_text = workspace.root().join(OWN_TEXT);
    let stamp = Stamp::of(workspace, "bench-module", &format!("{care:?}"), &[compiled.clone(), own_text])?;
    let folder = workspace.root().join("crates/bench-wasm/pkg");
    if stamp.is_fresh() && folder.join("bench.js").is_file() {
        return Ok(());
    }
    stamp.clear();
    fs::create_dir_all(&folder)?;
    let bound = bind(workspace, &compiled, "bench", care, "bindgen")?;
    write(&folder.join("bench_bg.wasm"), &fs::read(bound.module)?)?;
    write(&folder.join("bench.js"), &fs::read(bound.script)?)?;
    stamp.save()
}

/// Whether a module uses 128-bit SIMD.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Lanes {
    /// As `.cargo/config.toml` says.
    Simd,
    /// For browsers of before 2023: the same bits, more slowly.
    Scalar,
}

/// How much of a crate of bindings a module holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Content {
    /// What drawing a design takes.
    Drawing,
    /// Everything.
    Whole,
}

/// Compiles one crate of bindings and returns the module, unless it was compiled from the same sources before, however young their files are: what is optimised
/// as a whole takes minutes.
fn compile(workspace: &Workspace, package: &str, care: Care, lanes: Lanes, content: Content) -> Result<PathBuf> {
    let name = format!("{package}-{care:?}-{lanes:?}-{content:?}");
    let crates: &[&str] = if package == "bench-wasm" { &["pasu", "bench"] } else { &["pasu"] };
    let folders = crates.iter().chain([&package]).map(|name| Path::new("crates").join(name));
    let sources = folders.flat_map(|folder| [folder.join("src"), folder.join("Cargo.toml")]);
    let settings = ["Cargo.toml", "Cargo.lock", ".cargo/config.toml", "rust-toolchain.toml", OWN_TEXT];
    let inputs: Vec<PathBuf> =
        sources.chain(settings.map(PathBuf::from)).map(|path| workspace.root().join(path)).collect();
    let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
    let stamp = Stamp::of(workspace, &format!("{name}-compiled"), &flags, &inputs)?;
    let kept = stamp.beside(&format!("{name}.wasm"));
    if stamp.is_fresh() && kept.is_file() {
        return Ok(kept);
    }
    stamp.clear();
    let target = match (lanes, content) {
        (Lanes::Simd, Content::Whole) => workspace.target().to_owned(),
        (Lanes::Simd, Content::Drawing) => workspace.target().join("drawing"),
        (Lanes::Scalar, _) => workspace.target().join("scalar"),
    };
    let mut command = Command::new(cargo());
    // The module alone: for the tests the crate is a library as well, and what is one is not optimised across crates.
    command
        .args(["rustc", "--package", package, "--lib", "--crate-type", "cdylib", "--target", wasm_target::TRIPLE])
        .args(["--profile", care.profile(), "--target-dir"])
        .arg(&target)
        .current_dir(workspace.root());
    if content == Content::Drawing {
        command.arg("--no-default-features");
    }
    if lanes == Lanes::Scalar {
        // Takes the place of the flags in .cargo/config.toml.
        command.env("RUSTFLAGS", "-C llvm-args=-inline-threshold=50");
    }
    command::run(&mut command)?;
    let folder = target.join(wasm_target::TRIPLE).join(care.profile());
    let compiled = folder.join(package.replace('-', "_")).with_extension("wasm");
    // That of another checkout may take its place: they can share a target folder.
    if let Some(folder) = kept.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::copy(&compiled, &kept).with_context(|| format!("cannot copy {}", compiled.display()))?;
    stamp.save()?;
    Ok(kept)
}

/// A module with its bindings.
struct Bound {
    module: PathBuf,
    script: PathBuf,
}

/// Turns the module into `<name>.js` and `<name>_bg.wasm`, in a folder of its own.
fn bind(workspace: &Workspace, compiled: &Path, name: &str, care: Care, folder: &str) -> Result<Bound> {
    let scratch = workspace.target().join("xtask").join(folder);
    fs::create_dir_all(&scratch)?;
    Bindgen::new()
        .input_path(compiled)
        .web(true)?
        .out_name(name)
        .typescript(false)
        // js/pasu.js and js/drawing.js name their modules themselves; the benchmarks leave it to the bindings.
        .omit_default_module_path(name != "bench")
        .reset_state_function(true)
        .remove_producers_section(true)
        .remove_name_section(care == Care::Release)
        .generate(&scratch)?;
    let module = scratch.join(format!("{name}_bg.wasm"));
    if care == Care::Release {
        optimise(workspace, &module)?;
    }
    Ok(Bound { module, script: scratch.join(format!("{name}.js")) })
}

/// Runs npm's wasm-opt. A wasm-opt of the operating system may be years older and break the module in silence.
fn optimise(workspace: &Workspace, module: &Path) -> Result<()> {
    node::ensure(workspace)?;
    let optimised = module.with_extension("opt.wasm");
    command::run(
        node::script(workspace, "binaryen/bin/wasm-opt").args(WASM_OPT).arg(module).arg("-o").arg(&optimised),
    )?;
    fs::rename(&optimised, module)?;
    Ok(())
}

/// The package's own package.json: ours, with the version of the workspace.
fn manifest(workspace: &Workspace) -> Result<String> {
    let path = workspace.bindings().join("js/package.json");
    let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let placeholder = "\"0.0.0\"";
    if !text.contains(placeholder) {
        bail!("{} has no version {placeholder} to fill in", path.display());
    }
    Ok(text.replace(placeholder, concat!("\"", env!("CARGO_PKG_VERSION"), "\"")))
}

/// Replaces a file in one move, and only when it changes: a development server may be watching.
fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    if fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    let fresh = path.with_extension("fresh");
    fs::write(&fresh, bytes).with_context(|| format!("cannot write {}", fresh.display()))?;
    fs::rename(&fresh, path).with_context(|| format!("cannot write {}", path.display()))
}
