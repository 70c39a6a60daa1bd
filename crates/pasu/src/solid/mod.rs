//! Pots and closed solids: a surface with a wall, as smooth faces and as a closed mesh.

mod face;

pub use face::{Face, FaceJet, FaceKind};
