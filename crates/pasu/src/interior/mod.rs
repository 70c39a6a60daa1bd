//! The inside of a solid as cells for analysis: hexahedra, or tetrahedra for programs that need them.

mod cells;
mod inside;
mod plan;
mod quality;

pub use cells::{CellShape, Cells, CellsOptions, cells};
pub use inside::{inside, inside_values};
