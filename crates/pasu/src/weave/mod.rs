//! Bodies of clay and their triangles: which wall a pot is made with, and closed meshes that pass every check.

mod blocks;
mod closed_patches;
mod disc;
mod fit;
mod meshed;
mod settled;
mod shelled;
mod solid_mesh;
mod woven;

pub(crate) use closed_patches::closed_patches;
pub(crate) use meshed::{
    COARSE, GLIMPSE, Made, compact, finished, glimpsed, grid, is_coarse, meshed_once, refuse_crossing,
};
pub use solid_mesh::SolidMesh;
pub(crate) use woven::{Woven, weave};
