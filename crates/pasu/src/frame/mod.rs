//! Networks of vertex-frames: from their description to patches (W22, with a closed form of its own; `docs/frames.md`).

mod bump;
mod four_sided;
mod network;
mod orientation;
mod region;
mod ruled;
mod shell;
mod solve;
mod strips;

pub(crate) use shell::{Lie, NoShell, Shell, Thick};
pub(crate) use solve::Frame;
