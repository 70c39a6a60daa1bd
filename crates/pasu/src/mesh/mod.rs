//! From the closed form to triangles.

mod contract;
mod grid;
mod normal;
mod orientation;
mod profile;
mod row;
mod sample;
mod tolerance;

pub use contract::{Mesh, MeshOptions};
pub use sample::{Sampler, VERTEX_LIMIT, bound, mesh};
