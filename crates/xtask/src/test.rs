//! `cargo xtask test`: every check there is.

use std::process::Command;

use anyhow::{Result, bail};

use crate::report::{Report, cargo_count, node_count, vitest_count};
use crate::wasm_package::{self, Care};
use crate::workspace::{Workspace, cargo};
use crate::{browser, command, crate_package, node, site, tidy, tools, wasm_target, weight};

const HELP: &str = "\
cargo xtask test [--fast | --tools | --package]

Runs, and goes on after a failure: the rules of the house, the formatter, clippy, the tests of the
mathematics, the WebAssembly tests in Node, the TypeScript check, the linter, the tests of the front
end and of the library as it is published, and the browser tests.

  --fast   leave out what needs a browser
  --tools  instead of all that, have other programs judge files of many designs: Manifold, trimesh, lib3mf,
           OpenCASCADE, PrusaSlicer, resvg, meshio, scikit-fem and the glTF validator. They are installed when
           first needed
  --package
           instead of all that, pack the crate `pasu`, run its tests in an empty folder, and compare its interface
           with that of the last tag. With CI set, where the same tests ran just before, all of them are checked
           by the compiler, and the unit tests alone run";

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    let fast = match arguments {
        [] => false,
        [word] if word == "--fast" => true,
        [word] if word == "--tools" => return with_tools(),
        [word] if word == "--package" => return of_package(),
        [word] if word == "--help" || word == "-h" => {
            println!("{HELP}");
            return Ok(());
        }
        _ => bail!("not understood: {}\n\n{HELP}", arguments.join(" ")),
    };
    let workspace = Workspace::find()?;
    wasm_target::ensure(&workspace)?;
    node::ensure(&workspace)?;

    let mut report = Report::default();
    rust(&mut report, &workspace);
    report.check("library package", || wasm_package::build(&workspace, Care::Release));
    front_end(&mut report, &workspace);
    report.check("site and its weight", || {
        site::build(&workspace, Care::Release)?;
        weight::check(&workspace)
    });
    if !fast {
        report.tests("browser tests", vitest_count, || {
            let mut vitest = node::script(&workspace, "vitest/vitest.mjs");
            vitest.args(["run", "--config", "vitest.e2e.config.ts"]);
            vitest.env(browser::VARIABLE, browser::ensure(&workspace)?);
            Ok(vitest)
        });
    }
    report.close()
}

fn with_tools() -> Result<()> {
    let workspace = Workspace::find()?;
    node::ensure(&workspace)?;
    let mut report = Report::default();
    tools::check(&mut report, &workspace);
    report.close()
}

fn of_package() -> Result<()> {
    let workspace = Workspace::find()?;
    let mut report = Report::default();
    crate_package::check(&mut report, &workspace);
    report.close()
}

fn rust(report: &mut Report, workspace: &Workspace) {
    let cargo = |arguments: &[&str]| {
        let mut command = Command::new(cargo());
        command.args(arguments).current_dir(workspace.root());
        command
    };
    report.check("rules of the house", || tidy::check(workspace.root()));
    report.check("rustfmt", || command::run(&mut cargo(&["fmt", "--all", "--check"])));
    report.check("clippy", || {
        command::run(&mut cargo(&["clippy", "--all-targets", "--all-features", "--", "-D", "warnings"]))
    });
    report.check("clippy for WebAssembly", || {
        let target = ["--target", wasm_target::TRIPLE];
        let clippy = |arguments: &[&str]| {
            let mut command = cargo(&["clippy", "--package", "pasu-wasm"]);
            command::run(command.args(arguments).args(target).args(["--", "-D", "warnings"]))
        };
        clippy(&["--all-targets"])?;
        clippy(&["--lib", "--no-default-features"])
    });
    // These are no default members. Without the feature `sparse` of the benchmarks, whose solver takes a minute to compile.
    report.check("clippy for what does not ship", || {
        let packages = ["--package", "bench", "--package", "bench-wasm", "--package", "specimens"];
        command::run(cargo(&["clippy", "--all-targets"]).args(packages).args(["--", "-D", "warnings"]))
    });
    report.check("documentation", || {
        command::run(cargo(&["doc", "--no-deps", "--package", "pasu", "--quiet"]).env("RUSTDOCFLAGS", "-D warnings"))
    });
    report.tests("native tests", cargo_count, || Ok(cargo(&["test", "--all-features", "--no-fail-fast"])));
    report.tests("WebAssembly tests in Node", cargo_count, || {
        command::run(&mut cargo(&["build", "--package", "wasm-test-runner"]))?;
        let runner = workspace.target().join("debug").join(format!("wasm-test-runner{}", std::env::consts::EXE_SUFFIX));
        let mut tests = cargo(&["test", "--package", "pasu-wasm", "--no-fail-fast", "--target", wasm_target::TRIPLE]);
        tests.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", runner);
        // The runner's own backtrace says nothing about a test that failed.
        tests.env("RUST_BACKTRACE", "0");
        Ok(tests)
    });
}

fn front_end(report: &mut Report, workspace: &Workspace) {
    report.check("TypeScript", || {
        for project in ["tsconfig.json", "src/sw/tsconfig.json", "../tests/tsconfig.json"] {
            command::run(node::script(workspace, "typescript/bin/tsc").args(["--project", project]))?;
        }
        Ok(())
    });
    report.check("Biome", || command::run(node::script(workspace, "@biomejs/biome/bin/biome").args(["ci", ".."])));
    report.tests("library in Node", node_count, || {
        let mut tests = Command::new("node");
        tests
            .args([
                "--test",
                "--test-concurrency=2",
                "--test-reporter=tap",
                "tests/package/",
                "tests/bench/agreement.test.mjs",
            ])
            .current_dir(workspace.root());
        Ok(tests)
    });
    report.tests("front-end unit tests", vitest_count, || {
        let mut vitest = node::script(workspace, "vitest/vitest.mjs");
        vitest.arg("run");
        Ok(vitest)
    });
}
