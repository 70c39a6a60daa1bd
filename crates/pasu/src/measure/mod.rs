//! What can be measured on a pot: by quadrature on the closed form, each with the error that it may have.

mod accuracy;
mod bare;
mod capacity;
mod cause;
mod column;
mod curvature;
mod design;
mod dry;
mod fill;
mod filled;
mod finite;
mod folded;
mod ground;
mod hull_area;
mod integral;
mod known;
mod loads;
mod measures;
mod moments;
mod moved;
mod outside;
mod paint;
mod panels;
mod pond;
mod pool;
mod quantity;
mod saddle;
mod share;
mod standing;
mod taken;
mod touching;
mod trimmed;
mod water;
mod whole_face;
mod widths;

pub use capacity::{Capacity, Fill, Spill};
pub use cause::Cause;
pub use curvature::{Curvature, CurvatureRange, Located};
pub use design::measure;
pub(crate) use design::{Gauge, gauge};
pub use filled::WaterSurface;
pub(crate) use filled::filled;
pub use loads::Loads;
pub use measures::{
    Body, Centre, ClayMeasures, LeastThickness, MeasureOptions, Measures, Overhang, PartMeasures, ThicknessRange, Width,
};
pub(crate) use outside::{hull, lean, least_width};
pub use paint::{Map, paint};
pub use quantity::Quantity;
pub use standing::{Footprint, Tipping};
pub use water::{Water, water};
