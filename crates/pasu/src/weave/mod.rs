//! Bodies of clay and their triangles: which wall a pot is made with, and closed meshes that pass every check.

mod body;
mod disc;
mod fit;
mod meshed;
mod settled;
mod shell;
mod solid_mesh;
mod woven;

pub(crate) use body::{Body, Made};
pub(crate) use meshed::{COARSE, GLIMPSE, MadePot, compact, finished, glimpsed, grid, meshed_once, refuse_crossing};
pub use solid_mesh::SolidMesh;
pub(crate) use woven::{Woven, weave};
