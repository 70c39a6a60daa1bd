//! From the closed form to triangles.

mod coefficients;
mod contract;
mod copies;
mod exact;
mod grid;
mod kernel;
mod lanes;
mod normal;
mod orientation;
mod outline;
mod part;
mod profile;
mod ring;
mod row;
mod sample;
mod tolerance;

pub use contract::{Mesh, MeshOptions};
pub(crate) use orientation::points_outward;
pub use sample::{Sampler, VERTEX_LIMIT, bound, mesh};
pub(crate) use sample::{exact_mesh, grid_places, places};
