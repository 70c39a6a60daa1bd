//! The TypeScript declarations of what is answered in numbers and words.

use super::breach::{Breach, Constraints};
use super::connectivity::Connectivity;
use super::difference::{Counterpart, Difference};
use super::hit::Hit;
use crate::answer::Answer;
use crate::fit::{Apart, Ringed, Scanned};
use crate::make::{Finding, MeshReport, Remedy, Report, UnionReport};
use crate::measure::{
    Body, Capacity, Cause, Centre, ClayMeasures, Curvature, CurvatureRange, Fill, Footprint, LeastThickness, Located,
    Measures, Overhang, PartMeasures, Quantity, Spill, ThicknessRange, Tipping, Width,
};
use crate::pull::Pulled;

/// The declarations of measures and reports, as the text of a `.d.ts` module beside the package's own.
///
/// ```
/// assert!(pasu::typescript_of_answers().contains("export interface Measures extends BodyMeasures {"));
/// ```
pub fn typescript_of_answers() -> String {
    let mut text = String::from("// Generated from the structures of the Rust crate `pasu`. Do not edit.\n\n");
    text.push_str("import type { Design, FaceKind, PasuErrorArgs, Point, Product, Unit, Wall } from \"./pasu.js\";\n");
    let all = [
        Quantity::declare,
        Located::declare,
        Measures::declare,
        Body::declare,
        Width::declare,
        ClayMeasures::declare,
        Capacity::declare,
        Spill::declare,
        Fill::declare,
        Centre::declare,
        Footprint::declare,
        Tipping::declare,
        PartMeasures::declare,
        Cause::declare,
        ThicknessRange::declare,
        LeastThickness::declare,
        Overhang::declare,
        Curvature::declare,
        CurvatureRange::declare,
        Report::declare,
        Finding::declare,
        Remedy::declare,
        MeshReport::declare,
        UnionReport::declare,
        Pulled::declare,
        Ringed::declare,
        Scanned::declare,
        Apart::declare,
        Difference::declare,
        Counterpart::declare,
        Hit::declare,
        Connectivity::declare,
        Constraints::declare,
        Breach::declare,
    ];
    all.into_iter().for_each(|declare| declare(&mut text));
    text
}
