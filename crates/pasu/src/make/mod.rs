//! Closed meshes that pass every check, or the reason why there is none.

mod craft;
mod disc;
mod made;
mod makeable;
mod making;
mod remedy;
mod report;
mod sketch;
mod solid_mesh;
mod together;
#[cfg(feature = "typescript")]
mod typescript;
mod verdict;
mod weave;

pub use craft::Craft;
pub use made::solid;
pub(crate) use made::{Made, make};
pub use making::{Making, Scale, Size};
pub use remedy::Remedy;
pub use report::{Finding, MeshReport, Report, Severity};
pub(crate) use sketch::sketched;
pub use solid_mesh::SolidMesh;
#[cfg(feature = "typescript")]
pub use typescript::typescript_of_answers;
pub use verdict::check;
pub(crate) use verdict::verdict;
