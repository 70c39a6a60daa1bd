//! `cargo xtask serve`: the designer on this machine.

use anyhow::{Context, Result, bail};

use crate::wasm_package::{self, Care};
use crate::workspace::Workspace;
use crate::{command, node, site};

const HELP: &str = "\
cargo xtask serve [--port N]

Builds what has changed, serves the designer and prints its address.
The port is 4173 unless it is taken or another is given.";

pub(crate) fn main(arguments: &[String]) -> Result<()> {
    let Some(port) = port(arguments, HELP)? else { return Ok(()) };
    let workspace = Workspace::find()?;
    node::ensure(&workspace)?;
    wasm_package::build(&workspace, Care::Fast)?;
    site::build(&workspace, Care::Fast)?;
    let mut server = node::script(&workspace, "vite/bin/vite.js");
    server.arg("preview");
    if let Some(port) = port {
        server.args(["--port", &port.to_string(), "--strictPort"]);
    }
    command::run(&mut server)
}

/// The outer `None`: help was asked for and printed. The inner: no port was named.
pub(crate) fn port(arguments: &[String], help: &str) -> Result<Option<Option<u16>>> {
    match arguments {
        [] => Ok(Some(None)),
        [word] if word == "--help" || word == "-h" => {
            println!("{help}");
            Ok(None)
        }
        [flag, number] if flag == "--port" => {
            let port = number.parse().with_context(|| format!("`{number}` is not a port (1 to 65535)"))?;
            Ok(Some(Some(port)))
        }
        _ => bail!("not understood: {}\n\n{help}", arguments.join(" ")),
    }
}

#[cfg(test)]
mod tests {
    use super::port;

    #[test]
    fn the_port_is_read_and_nonsense_is_refused() {
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(port(&words(""), "").ok(), Some(Some(None)));
        assert_eq!(port(&words("--port 8080"), "").ok(), Some(Some(Some(8080))));
        assert_eq!(port(&words("--help"), "").ok(), Some(None));
        assert!(port(&words("--port"), "").is_err());
        assert!(port(&words("--port many"), "").is_err());
        assert!(port(&words("8080"), "").is_err());
    }
}
