//! Networks of vertex-frames: four-sided patches through points of space (W22).

mod described;
mod network;

pub use network::{Continuity, Falloff, Force, FramePatch, FrameRule, VertexFrame};
