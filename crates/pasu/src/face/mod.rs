//! Smooth faces, whatever they are made of: what is meshed, measured and written of a body.

mod contract;
mod kind;
mod patch_face;
mod sealed;
mod seams;

pub use contract::{Face, FaceJet, FaceWalk};
pub use kind::FaceKind;
pub(crate) use patch_face::{PatchFace, kind_of};
pub(crate) use sealed::Sealed;
pub(crate) use seams::{Seams, ascending};
