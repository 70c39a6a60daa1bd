//! `cargo xtask <task>`: everything that is done with this repository, on any machine with rustup and Node.

mod bench;
mod browser;
mod build;
mod command;
mod crate_package;
mod debian;
mod dev;
mod fuzz;
mod node;
mod report;
mod serve;
mod site;
mod stamp;
mod test;
mod tidy;
mod tools;
mod wasm_package;
mod wasm_target;
mod weight;
mod workspace;

use std::process::ExitCode;

const HELP: &str = "\
cargo xtask <task>

  serve    build the designer and serve it; prints the address
  dev      serve the designer and rebuild it on every change
  build    build the library (crates/pasu-wasm/pkg) and the static site (web/dist) for release
  test     every check there is; --fast leaves the browser out;
           --tools asks other programs to judge our files; --package tests the crate as it is published
  tidy     the rules of the house alone, which test begins with
  bench    how fast surfaces are computed
  fuzz     inputs that nobody would think of, guided by the code they reach

`cargo xtask <task> --help` tells more about each.";

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let task = arguments.next();
    let rest: Vec<String> = arguments.collect();
    let outcome = match task.as_deref() {
        Some("serve") => serve::main(&rest),
        Some("dev") => dev::main(&rest),
        Some("build") => build::main(&rest),
        Some("test") => test::main(&rest),
        Some("tidy") => tidy::main(&rest),
        Some("bench") => bench::main(&rest),
        Some("fuzz") => fuzz::main(&rest),
        None | Some("help" | "--help" | "-h") => {
            println!("{HELP}");
            return ExitCode::SUCCESS;
        }
        Some(other) => {
            eprintln!("There is no task `{other}`.\n\n{HELP}");
            return ExitCode::FAILURE;
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error:#}");
            ExitCode::FAILURE
        }
    }
}
