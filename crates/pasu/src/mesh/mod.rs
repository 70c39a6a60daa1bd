//! From the closed form to triangles.

#[cfg(feature = "patchwork")]
mod bladed;
mod cleared;
mod contract;
mod exact;
mod fill;
#[cfg(feature = "patchwork")]
mod followed;
mod fourier;
mod grid;
mod grids;
mod normal;
mod part;
mod patches;
mod profile;
mod promise;
mod sample;
mod seams;
mod sewn;
mod tolerance;

pub(crate) use cleared::height;
pub use contract::{Mesh, MeshOptions, VERTEX_LIMIT};
pub(crate) use grids::Places;
pub(crate) use patches::{Welded, welded, welded_clear};
pub use sample::{Sampler, bound, mesh};
pub(crate) use sample::{exact_mesh, grid_places, places};
#[cfg(feature = "patchwork")]
pub(crate) use tolerance::DEFAULT_FINENESS;
