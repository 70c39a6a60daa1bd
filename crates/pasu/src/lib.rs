//! Vases and pots whose surfaces are exact solutions of partial differential equations.
//!
//! Data flows one way: [design](crate::Design) -> canonical -> boundary-value problem -> closed form -> mesh.

mod design;
mod error;
mod evaluate;
mod fingerprint;
mod mesh;
mod mode;
mod surface;

#[cfg(feature = "typescript")]
pub use design::typescript;
pub use design::{
    Axis, BloorWilson, BoundaryValue, Clay, Component, Datum, Design, FourthOrder, Glaze, Look, MixedOrder, Mode,
    Order, Part, Placement, SecondOrder, Shape, Span, Unit, Value, Wall,
};
pub use error::{Code, Error, Result};
pub use evaluate::{Derivatives, derivatives, evaluate};
pub use fingerprint::fingerprint;
pub use mesh::{Mesh, MeshOptions, VERTEX_LIMIT, mesh};
pub use mode::{Equation, ModeData, ModeSolution, Unsolvable};
pub use surface::{Surface, SurfaceJet};
