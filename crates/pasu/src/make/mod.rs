//! Closed meshes that pass every check, or the reason why there is none.

mod called;
mod craft;
mod fitted;
#[cfg(feature = "patchwork")]
mod folded;
#[cfg(feature = "patchwork")]
mod joined;
mod made;
mod makeable;
mod making;
mod remedy;
mod report;
mod sketch;
mod together;
mod verdict;

pub use craft::Craft;
pub use made::solid;
pub(crate) use made::{Finished, make};
pub use making::{Making, Scale, Size};
pub use remedy::Remedy;
pub use report::{Finding, MeshReport, Report, Severity, UnionReport};
pub(crate) use sketch::{Sketched, sketched};
pub use verdict::check;
pub(crate) use verdict::verdict;
