//! Pots and closed solids: a surface with a wall, as smooth faces and as a closed mesh.

mod face;
mod making;
mod mesh;

pub use face::{Face, FaceJet, FaceKind};
pub use making::{Making, Product, Scale, Size};
pub use mesh::SolidMesh;
