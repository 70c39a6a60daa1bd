//! Everything that is measured on a design, in one structure.

use super::capacity::Capacity;
use super::curvature::Curvature;
use super::quantity::Quantity;
use super::standing::{Footprint, Tipping};
use crate::design::Unit;
use crate::face::FaceKind;
use crate::solid::Product;

/// What to measure.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeasureOptions {
    /// A level, the `z` of the world, to which the pot is filled besides the brim.
    pub fill: Option<f64>,
    /// What is made of the design; a solid has no lining and holds nothing.
    pub product: Product,
    /// The density of the clay in g/cm3; by the clay of each part's look when left out: stoneware 2.3, porcelain 2.4, terracotta 1.9, black 2.3.
    pub density: Option<f64>,
}

/// The measures of a design and of its parts. `docs/measures.md` defines every one.
///
/// Lengths are in the unit of the design, areas and volumes in its square and cube, angles in degrees, masses in grams; `z` of the world is up.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Measures {
    /// The unit of length.
    pub unit: Unit,
    /// What was measured.
    pub product: Product,
    /// Of the whole design. Sums are over the parts that have the measure.
    pub whole: Body,
    /// Of each part.
    pub parts: Vec<PartMeasures>,
}

/// What can be said of one part and of several together.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Body {
    /// From the lowest to the highest point.
    pub height: Quantity,
    /// The lowest `z`.
    pub bottom: f64,
    /// The highest `z`.
    pub top: f64,
    /// Caliper widths of the silhouette from above.
    pub width: Width,
    /// Area of the design surface, one side.
    pub area: Quantity,
    /// The clay; `None` without a wall.
    pub clay: Option<ClayMeasures>,
    /// What it holds; `None` where it holds nothing.
    pub capacity: Option<Capacity>,
    /// Centre of mass without water.
    pub centre_empty: Option<Centre>,
    /// Centre of mass with water to the brim.
    pub centre_full: Option<Centre>,
    /// What it stands on; `None` without a wall.
    pub footprint: Option<Footprint>,
    /// How far it can be tilted without water.
    pub tipping_empty: Option<Tipping>,
    /// How far it can be tilted with water, which is taken as it lies upright.
    pub tipping_full: Option<Tipping>,
}

/// The least and the greatest distance of two parallel upright boards on either side of a pot.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Width {
    /// The least.
    pub least: Quantity,
    /// The greatest.
    pub greatest: Quantity,
    /// The direction across the boards in degrees anticlockwise from `x`, 0 to 180.
    pub least_direction: f64,
    /// As `least_direction`.
    pub greatest_direction: f64,
}

/// The clay of a pot.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct ClayMeasures {
    /// Of its whole boundary.
    pub area: Quantity,
    /// Its volume.
    pub volume: Quantity,
    /// Its mass in grams.
    pub mass: Quantity,
}

/// A centre of mass.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Centre {
    /// Where it is.
    pub at: [f64; 3],
    /// How far each coordinate may be off.
    pub error: f64,
}

/// The measures of one part.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PartMeasures {
    /// Its number.
    pub part: usize,
    /// Its name.
    pub name: Option<String>,
    /// What it shares with the whole.
    pub body: Body,
    /// Why it is no pot, in words; `None` where it is one.
    pub reason: Option<String>,
    /// Why it holds nothing, in words; `None` where it holds something.
    pub capacity_reason: Option<String>,
    /// The thickness of the wall along the normal.
    pub thickness: Option<ThicknessRange>,
    /// The largest overhang of the outside.
    pub overhang: Option<Overhang>,
    /// The largest overhang of the lining.
    pub overhang_inside: Option<Overhang>,
    /// Curvature of the design surface.
    pub curvature: Curvature,
}

/// How thick a wall is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ThicknessRange {
    /// The thickness asked for.
    pub asked: f64,
    /// The least, and where if it is less than asked for.
    pub least: (f64, Option<[f64; 3]>),
    /// The greatest.
    pub greatest: f64,
    /// The share of the surface, 0 to 1, where the wall is thinner than asked for.
    pub thinned: f64,
    /// How far the least, the greatest and the share may be off.
    pub errors: [f64; 3],
}

/// How far a wall leans over what is below.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Overhang {
    /// The angle against the vertical, in degrees: 0 is a vertical wall, 90 a level ceiling, less than 0 a wall that faces up.
    pub degrees: f64,
    /// How far that may be off.
    pub error: f64,
    /// Where.
    pub at: [f64; 3],
    /// What overhangs.
    pub face: FaceKind,
}
