//! `cargo xtask fuzz`: inputs that are guided by the code they reach, for as long as one likes.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::command;
use crate::workspace::{Workspace, cargo};

const HELP: &str = "\
cargo xtask fuzz [<target>..] [--time <seconds>]

Looks for inputs that break what docs/fuzzing.md promises, by libFuzzer, which keeps what reaches new code. It takes
a C++ compiler, and some minutes to compile at first.

  document, link, file, calls   only these targets; all of them otherwise
  --time <seconds>              for each target; 60 otherwise

What was reached is kept in target/fuzz/corpus and gone on from, what broke a promise in target/fuzz/found.";

const TARGETS: [&str; 4] = ["document", "link", "file", "calls"];

/// As cargo-fuzz has it, without a sanitizer, for which it would take a nightly toolchain: safe code has no use for one. Overflow checks and assertions are on.
const FLAGS: &str = "--cfg fuzzing -C passes=sancov-module -C llvm-args=-sanitizer-coverage-level=4 \
    -C llvm-args=-sanitizer-coverage-inline-8bit-counters -C llvm-args=-sanitizer-coverage-pc-table \
    -C llvm-args=-sanitizer-coverage-trace-compares -C codegen-units=1 -C debug-assertions";

/// Seconds by the clock after which an input that does not end is given up. One that ends and took more than it may, of the time of the processor, is noticed before, however
/// busy the machine.
const GIVEN_UP: u32 = 900;

/// Megabytes of the whole program.
const MEMORY: u32 = 4096;

/// What the command line asks for.
#[derive(Debug, PartialEq)]
struct Wishes {
    targets: Vec<String>,
    seconds: u32,
}

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    let Some(wishes) = read(arguments)? else {
        println!("{HELP}");
        return Ok(());
    };
    let workspace = Workspace::find()?;
    let folder = workspace.target().join("fuzz");
    let program = compile(&workspace, &folder)?;
    for target in &wishes.targets {
        run(&program, &folder, target, wishes.seconds)?;
    }
    Ok(())
}

fn read(arguments: &[String]) -> Result<Option<Wishes>> {
    let mut wishes = Wishes { targets: Vec::new(), seconds: 60 };
    let mut words = arguments.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--help" | "-h" => return Ok(None),
            "--time" => {
                let seconds = words.next().context("--time takes a number of seconds")?;
                wishes.seconds = seconds.parse().with_context(|| format!("{seconds} is no number of seconds"))?;
            }
            target if TARGETS.contains(&target) => wishes.targets.push(target.to_owned()),
            _ => bail!("not understood: {word}\n\n{HELP}"),
        }
    }
    if wishes.targets.is_empty() {
        wishes.targets = TARGETS.map(str::to_owned).to_vec();
    }
    Ok(Some(wishes))
}

/// The program with counters at every branch, in a folder of its own. That the platform is named keeps the flags from what runs while compiling.
fn compile(workspace: &Workspace, folder: &Path) -> Result<std::path::PathBuf> {
    let platform = platform(workspace)?;
    let mut build = Command::new(cargo());
    build
        .args(["build", "--package", "fuzz", "--release", "--target", &platform, "--target-dir"])
        .arg(folder)
        .env("RUSTFLAGS", FLAGS)
        .current_dir(workspace.root());
    command::run(&mut build)?;
    Ok(folder.join(platform).join("release").join(format!("fuzz{}", std::env::consts::EXE_SUFFIX)))
}

/// The platform that this machine compiles for.
fn platform(workspace: &Workspace) -> Result<String> {
    let told = command::read(Command::new("rustc").arg("-vV").current_dir(workspace.root()))?;
    let host = told.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(host.context("rustc does not name its platform")?.to_owned())
}

fn run(program: &Path, folder: &Path, target: &str, seconds: u32) -> Result<()> {
    let (corpus, seeds, found) =
        (folder.join("corpus").join(target), folder.join("seeds").join(target), folder.join("found"));
    for made in [&corpus, &seeds, &found] {
        fs::create_dir_all(made).with_context(|| format!("cannot make {}", made.display()))?;
    }
    let mut fuzz = Command::new(program);
    fuzz.env("PASU_FUZZ_TARGET", target)
        .env("PASU_FUZZ_SEEDS", &seeds)
        // New inputs go into the first folder.
        .args([&corpus, &seeds])
        .arg(format!("-artifact_prefix={}/{target}-", found.display()))
        .arg(format!("-max_total_time={seconds}"))
        .arg(format!("-timeout={GIVEN_UP}"))
        .arg(format!("-rss_limit_mb={MEMORY}"))
        .args(["-max_len=65536", "-print_final_stats=1"]);
    command::run(&mut fuzz).with_context(|| {
        format!("an input of the target {target} breaks a promise: it is in {}; `cargo run -p fuzz -- {target} <file>` looks at it again", found.display())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wishes(line: &str) -> Result<Option<Wishes>> {
        read(&line.split_whitespace().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn the_command_line_is_understood() {
        let all = Wishes { targets: TARGETS.map(str::to_owned).to_vec(), seconds: 60 };
        assert_eq!(wishes("").unwrap(), Some(all));
        let one = Wishes { targets: vec!["link".into()], seconds: 5 };
        assert_eq!(wishes("--time 5 link").unwrap(), Some(one));
        assert_eq!(wishes("--help").unwrap(), None);
        assert!(wishes("teapots").is_err() && wishes("--time").is_err() && wishes("--time soon").is_err());
    }
}
