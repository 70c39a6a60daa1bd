//! `cargo xtask build`: the library and the site as they ship.

use anyhow::{Result, bail};

use crate::wasm_package::{self, Care};
use crate::workspace::Workspace;
use crate::{node, site, weight};

const HELP: &str = "\
cargo xtask build

Builds for release:
  crates/pasu-wasm/pkg/   the library for JavaScript, a publishable npm package
  web/pot/pkg/            <pasu-pot>, the element for other people's pages, a publishable npm package
  web/dist/               the designer, a static site for any folder of any host, with the element in pot/

Fails when the designer weighs more than its budget (web/weight.json).";

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    match arguments {
        [] => {}
        [help] if help == "--help" || help == "-h" => {
            println!("{HELP}");
            return Ok(());
        }
        _ => bail!("`build` takes no arguments\n\n{HELP}"),
    }
    let workspace = Workspace::find()?;
    node::ensure(&workspace)?;
    wasm_package::build(&workspace, Care::Release)?;
    site::build(&workspace, Care::Release)?;
    weight::check(&workspace)?;
    println!("\nlibrary  crates/pasu-wasm/pkg\nelement  web/pot/pkg\nsite     web/dist");
    Ok(())
}
