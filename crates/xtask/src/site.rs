//! The static site.

use anyhow::Result;

use crate::stamp::Stamp;
use crate::wasm_package::Care;
use crate::workspace::Workspace;
use crate::{command, node};

/// Builds `web/dist` from the designer and the package; unchanged inputs rebuild nothing.
pub(crate) fn build(workspace: &Workspace, care: Care) -> Result<()> {
    let inputs = [workspace.web(), workspace.package()];
    let stamp = Stamp::of(workspace, "site", &format!("{care:?}"), &inputs)?;
    if stamp.is_fresh() && workspace.dist().join("index.html").is_file() {
        return Ok(());
    }
    stamp.clear();
    command::run(node::script(workspace, "vite/bin/vite.js").args(["build", "--logLevel", "warn"]))?;
    stamp.save()
}
