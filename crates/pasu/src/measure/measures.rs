//! Everything that is measured on a design, in one structure.

use super::capacity::Capacity;
use super::cause::Cause;
use super::curvature::Curvature;
use super::loads::Loads;
use super::quantity::Quantity;
use super::standing::{Footprint, Tipping};
use crate::answer::answers;
use crate::design::{Unit, to_json};
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

answers! {
    /// The measures of a design and of its parts. `docs/measures.md` defines every one.
    ///
    /// Lengths are in the unit of the design, areas and volumes in its square and cube, angles in degrees, masses in grams; `z` of the world is up.
    pub struct Measures as "Measures" {
        /// The unit of length.
        pub unit: Unit,
        /// What was measured.
        pub product: Product,
        /// Of the whole design. Sums are over the parts that have the measure.
        #[serde(flatten)]
        pub whole: Body,
        /// Of each part.
        pub parts: Vec<PartMeasures>,
    }

    /// What can be said of one part and of several together.
    #[derive(Default)]
    pub struct Body as "BodyMeasures" {
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
        /// Centre of mass of the clay, and of clay and water to the brim.
        pub centre: Loads<Centre>,
        /// What it stands on; `None` without a wall.
        pub footprint: Option<Footprint>,
        /// How far it can be tilted. Water is taken as it lies upright.
        pub tipping: Loads<Tipping>,
    }

    /// The least and the greatest distance of two parallel upright boards on either side of a pot.
    #[derive(Copy, Default)]
    pub struct Width as "Width" {
        /// The least.
        pub least: Quantity,
        /// The greatest.
        pub greatest: Quantity,
        /// The direction across the boards of the least width, in degrees anticlockwise from `x`, 0 to 180.
        pub least_direction: f64,
        /// The same of the greatest width.
        pub greatest_direction: f64,
    }

    /// The clay of a pot.
    #[derive(Copy, Default)]
    pub struct ClayMeasures as "ClayMeasures" {
        /// Of its whole boundary.
        pub area: Quantity,
        /// Its volume.
        pub volume: Quantity,
        /// Its mass in grams.
        pub mass: Quantity,
    }

    /// A centre of mass.
    #[derive(Copy, Default)]
    pub struct Centre as "Centre" {
        /// Where it is.
        pub at: [f64; 3],
        /// How far each coordinate may be off.
        pub error: f64,
    }

    /// The measures of one part.
    pub struct PartMeasures as "PartMeasures" {
        /// Its number.
        pub part: usize,
        /// Its name.
        pub name: Option<String>,
        /// What it shares with the whole.
        #[serde(flatten)]
        pub body: Body,
        /// Whether it has a wall, and can have it. What runs through itself is no pot; of a body for which its surface asks more than 50,000 triangles that is left to [`check`](crate::check()).
        pub is_pot: bool,
        /// Why it is no pot, in words; `None` where it is one.
        pub reason: Option<String>,
        /// Why it holds nothing, in words; `None` where it holds something.
        pub capacity_reason: Option<String>,
        /// Why it is no pot, for whoever says it in another language: what would be refused; `None` where it is one.
        pub cause: Option<Cause>,
        /// The same of why it holds nothing. Besides the codes of refusals it is `solid`, `no-foot`, `no-bottom` of a tube, `dry` where no water stays in this position, or `too-long` where nobody would wait for it.
        pub capacity_cause: Option<Cause>,
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
    #[derive(Copy)]
    pub struct ThicknessRange as "ThicknessRange" {
        /// The thickness asked for.
        pub asked: f64,
        /// The least.
        pub least: LeastThickness,
        /// The greatest.
        pub greatest: Quantity,
        /// The share of the wall, 0 to 1, that is thinner than asked for.
        pub thinned: Quantity,
    }

    /// The least thickness of a wall.
    #[derive(Copy)]
    pub struct LeastThickness as "LeastThickness" {
        /// The value.
        pub value: f64,
        /// How far it may be off; never negative.
        pub error: f64,
        /// Where, if it is less than asked for.
        pub at: Option<[f64; 3]>,
    }

    /// How far a wall leans over what is below.
    #[derive(Copy)]
    pub struct Overhang as "Overhang" {
        /// The angle against the vertical, in degrees: 0 is a vertical wall, 90 a level ceiling, less than 0 a wall that faces up.
        pub degrees: f64,
        /// How far that may be off.
        pub error: f64,
        /// Where.
        pub at: [f64; 3],
        /// What overhangs.
        pub face: FaceKind,
    }
}

impl Measures {
    /// As JSON text; `docs/measures.md` names every field with its unit.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// let measures = pasu::measure(&cup, &pasu::MeasureOptions::default())?;
    /// assert!(measures.to_json().starts_with(r#"{"unit":"cm","product":"pot","height":{"value":4,"#));
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}
