//! Pots and closed solids: a surface with a wall, as smooth faces and as a closed mesh.

mod cells;
mod curve;
mod disc;
mod face;
mod frame;
mod make;
mod making;
mod mesh;
mod piece;
mod pot;
mod seams;
mod sheet;
mod sketch;
mod skin;
mod thickness;
mod weave;

pub use face::{Face, FaceJet, FaceKind};
pub use make::solid;
pub(crate) use make::{Made, make};
pub use making::{Making, Product, Scale, Size};
pub use mesh::SolidMesh;
pub use piece::Piece;
pub use pot::Pot;
pub(crate) use seams::{Places, Seams, ascending};
pub(crate) use sketch::sketched;
pub(crate) use skin::{place, short};
