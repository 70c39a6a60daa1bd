//! The static site, and the package of the element that is on it too.

use anyhow::Result;

use crate::stamp::Stamp;
use crate::wasm_package::Care;
use crate::workspace::Workspace;
use crate::{command, node};

/// Builds `web/pot/pkg` and `web/dist` from the designer and the package; unchanged inputs rebuild nothing.
pub(crate) fn build(workspace: &Workspace, care: Care) -> Result<()> {
    let inputs = [workspace.web(), workspace.package()];
    let stamp = Stamp::of(workspace, "site", &format!("{care:?}"), &inputs)?;
    let products = [workspace.dist().join("index.html"), workspace.web().join("pot/pkg/package.json")];
    if stamp.is_fresh() && products.iter().all(|product| product.is_file()) {
        return Ok(());
    }
    stamp.clear();
    // The site has a copy of the element.
    for config in ["vite.pot.config.ts", "vite.config.ts"] {
        let build = ["build", "--config", config, "--logLevel", "warn"];
        command::run(node::script(workspace, "vite/bin/vite.js").args(build))?;
    }
    stamp.save()
}
