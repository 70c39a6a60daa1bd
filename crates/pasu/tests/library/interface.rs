//! What every public type promises besides what it is.

use std::collections::BTreeSet;

use pasu::*;

/// The names of types, each of which can go from thread to thread and be shared between them.
macro_rules! shared {
    ($($name:ident)*) => {{
        fn is_shared<T: Send + Sync>() {}
        $(is_shared::<$name>();)*
        [$(stringify!($name)),*]
    }};
}

#[test]
fn every_type_goes_from_thread_to_thread() {
    let mut checked = BTreeSet::from(shared!(
    Apart Arg Axis Blend BloorWilson Body BoundaryValue Breach Capacity Cause CellShape Cells CellsFormat CellsOptions Centre Clay ClayMeasures Code Colour Component Connectivity Constraints Content Continuity Conversion Counterpart Craft Curvature CurvatureRange Datum Derivatives Design
    Difference Drawn DrawnFace End Equation Error FaceJet FaceKind Falloff Fill Finding FittedLevels Footprint Force Form Format FourthOrder FramePatch FrameRule Free Glaze Hand Handle HandleId Handles Harmonic Hit Hoop Inside InsideMap Joint Joints Leaf LeastThickness Levels Lining Located Look Loss Making Map
        MeasureOptions Measures Mesh MeshOptions MeshReport Method MixedOrder Mode ModeSolution Motion Node Octant Order Overhang Part PartMeasures Piece Placement Pot Product Profile Provenance Pulled Quantity Ray Remedy Report
    Restraint RimForm Ring Ringed Rings Sampler Scale Scan Scanned SecondOrder Section Series Severity Shape Side Size Sketch SketchOptions Slopes SolidMesh Solution Span Spill Step Surface SurfaceJet ThicknessRange Tipping Tree UnionReport Unit
    Unsolvable VaseOrder VertexFrame Wall Water WaterSurface Wave Width
    ));
    fn is_shared<T: Send + Sync>() {}
    is_shared::<ModeData<'_>>();
    checked.insert("ModeData");
    is_shared::<Loads<Centre>>();
    checked.insert("Loads");
    is_shared::<Choice<Glaze>>();
    checked.insert("Choice");
    // Traits and an alias.
    checked.extend(["Face", "FaceWalk", "Named", "Result"]);
    assert_eq!(checked, declared());
}

/// The types that `lib.rs` lists.
fn declared() -> BTreeSet<&'static str> {
    let lists = include_str!("../../src/lib.rs").split("pub use ").skip(1).filter_map(|list| list.split(';').next());
    let words = lists.flat_map(|list| list.split(|c: char| !c.is_alphanumeric() && c != '_'));
    words.filter(|word| word.starts_with(char::is_uppercase) && word.contains(char::is_lowercase)).collect()
}
