//! Vases and pots whose surfaces are exact solutions of partial differential equations.
//!
//! Data flows one way: [design](crate::Design) -> canonical -> [boundary-value problem](crate::BoundaryValue) ->
//! [closed form](crate::Surface) -> [mesh](crate::Mesh). A network of vertex-frames and a blend of two sections have closed forms of their own in the place of a boundary-value problem's.
//!
//! # Conventions
//!
//! - **Axes.** Right-handed; a pot stands along `z`, its foot below its rim.
//! - **Domain.** A surface is `X(u, v)` with `u` in [0, 1] along the profile, from the boundary that the papers give first (the rim
//!   of `second-order`, `mixed-order` and `bloor-wilson`, the foot of `fourth-order`), and `v` in [0, span] round the axis.
//! - **Winding.** Triangles are counter-clockwise seen from outside; normals point out of the pot.
//! - **Units.** Lengths are in the unit of the design, angles in radians.
//! - **Numbers.** The solution, points and derivatives are `f64` throughout. A [mesh](Mesh) is summed in `f32` from coefficients in `f64`, with stated errors; one
//!   that keeps a tolerance is summed in `f64` and rounded once. Elementary functions come from `libm` and nothing is fused,
//!   so that every machine computes the same bits. No result is NaN or infinite: what cannot be computed is an [`Error`].
//!
//! # Sources
//!
//! - **ZY01** J. J. Zhang, L. You, *Surface representation using second, fourth and mixed order partial differential equations*, 2001.
//! - **IA** S. N. Ishak, J. M. Ali, *Parametric surface generation using partial differential equation based approach*.
//! - **W22** S. Wang, Y. Xia, L. You, H. Ugail, A. Carriazo, A. Iglesias, J. Zhang, *Interactive PDE patch-based surface modeling from vertex-frames*, 2022.
//! - **ZY04** J. J. Zhang, L. You, *Blending solids with approximate analytical solution to PDE*, 2004.
//! - **ASB88** J. A. D. W. Anderson, G. D. Sullivan, K. D. Baker, *Constrained constructive solid geometry: a unique representation of scenes*, 1988.

// What only those shapes use stays where it belongs, and is left out by the linker.
#![cfg_attr(not(feature = "patchwork"), allow(dead_code, unused_imports, unused_variables, unreachable_patterns))]

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}

mod answer;
#[cfg(test)]
mod any_patch;
#[cfg(feature = "patchwork")]
mod blend;
mod check;
mod design;
mod error;
mod evaluate;
mod export;
mod face;
mod fingerprint;
mod fit;
#[cfg(feature = "patchwork")]
mod frame;
#[cfg(feature = "patchwork")]
mod interior;
#[cfg(feature = "patchwork")]
mod join;
mod make;
mod measure;
mod mesh;
mod mode;
mod numeric;
#[cfg(feature = "patchwork")]
mod octant;
mod patch;
mod pull;
#[cfg(feature = "patchwork")]
mod scene;
mod solid;
mod solution;
mod surface;
mod watch;
mod weave;

#[cfg(feature = "patchwork")]
pub use blend::{Inside, InsideMap};
pub use design::read;
pub use design::{
    Axis, BloorWilson, BoundaryValue, Choice, Clay, Colour, Component, Conversion, Datum, Design, End, FourthOrder,
    Free, Glaze, Handle, HandleId, Handles, Hoop, Joint, Joints, Lining, Look, Loss, MixedOrder, Mode, Named, Order,
    Part, Placement, Restraint, RimForm, Ring, Rings, SecondOrder, Series, Shape, Side, Slopes, Span, Step, Unit,
    VaseOrder, Wall, Wave,
};
#[cfg(feature = "patchwork")]
pub use design::{
    Blend, Continuity, Falloff, Force, Form, FramePatch, FrameRule, Harmonic, Method, Motion, Octant, Section,
    VertexFrame,
};
#[cfg(feature = "typescript")]
pub use design::{
    typescript, typescript_of_blends, typescript_of_materials, typescript_of_sliders, typescript_of_tables,
};
pub use error::{Arg, Code, Error, Result};
pub use evaluate::{Derivatives, derivatives, evaluate};
#[cfg(feature = "patchwork")]
pub use export::{CellsFormat, cells_file};
pub use export::{
    Drawn, DrawnFace, Format, Provenance, Sketch, SketchOptions, drawn, obj_materials, open, provenance, sketch, write,
};
pub use face::{Face, FaceJet, FaceKind, FaceWalk};
pub use fingerprint::fingerprint;
pub use fit::{Apart, FittedLevels, Levels, Profile, Ringed, Scan, Scanned, fit, fit_levels, fit_scan, free, levels};
/// The crate of the vectors in points and derivatives, in the version that they are of.
pub use glam;
#[cfg(feature = "patchwork")]
pub use interior::{CellShape, Cells, CellsOptions, cells, inside, inside_values};
pub use make::{Craft, Finding, Making, MeshReport, Remedy, Report, Scale, Severity, Size, UnionReport, check, solid};
pub use measure::{
    Body, Capacity, Cause, Centre, ClayMeasures, Curvature, CurvatureRange, Fill, Footprint, LeastThickness, Loads,
    Located, Map, MeasureOptions, Measures, Overhang, PartMeasures, Quantity, Spill, ThicknessRange, Tipping, Water,
    WaterSurface, Width, measure, paint, water,
};
pub use mesh::{Mesh, MeshOptions, Sampler, VERTEX_LIMIT, bound, mesh};
pub use mode::{Equation, ModeData, ModeSolution, Unsolvable};
pub use patch::SurfaceJet;
pub use pull::{Hand, Pulled, pull};
#[cfg(feature = "typescript")]
pub use scene::typescript_of_answers;
#[cfg(feature = "patchwork")]
pub use scene::{
    Breach, Connectivity, Constraints, Content, Counterpart, Difference, Hit, Leaf, Node, Ray, Tree, at, compare,
    connectivity, constraints, flat, pick, tree,
};
pub use solid::{Piece, Pot, Product};
pub use solution::Solution;
pub use surface::Surface;
pub use watch::watched;
pub use weave::SolidMesh;
