//! Edges of floors, where the lining goes down below the floor and comes up again: there its last rise above the floor leaps.

use core::f64::consts::TAU;

use pasu::{Design, Face, FaceKind, Making, MeasureOptions, Pot, Product};

use crate::support::gallery;

/// Pots of which it leaps.
fn leaping() -> Vec<(&'static str, Design)> {
    let dint = gallery().into_iter().find(|exhibit| exhibit.name == "own-dint").expect("in the gallery").shape;
    let dint =
        format!(r#"{{ "pasu": 1, "parts": [{{ "shape": {dint}, "wall": {{ "thickness": 1, "base": 0.8 }} }}] }}"#);
    // Waves so low that of the places at which columns are looked at first most see no leap.
    let waves = r#"{ "pasu": 1, "parts": [{
        "shape": { "kind": "bloor-wilson", "n1": 5, "a": 1.3641, "r": [3.5303, -0.41481025, 0.37315271, 4.397], "R": [-5.3041, -2.65205, -2.65205, -1.8746],
            "h": [11.0975, 0.0636], "H": [-14.34351875, -0.2143] },
        "wall": { "thickness": 2.1204, "base": 0.1929, "foot": [0.5742, 0.1724], "rim": "rounded" } }] }"#;
    [("dint", dint.as_str()), ("waves", waves)].map(|(name, text)| (name, Design::parse(text).unwrap())).into()
}

/// No face had what lies between the sides of a leap: volumes were up to 1.4e-4 of themselves too small, with errors a fiftieth of that, and STEP files millimetres off.
#[test]
fn no_edge_of_a_face_leaps() {
    // Of pots that are some twenty units high.
    const PLACES: u32 = 20_000;
    for (name, design) in leaping() {
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        for face in pot.faces() {
            for a in [0.0, 1.0] {
                let at = |j: u32| face.jet(a, TAU * f64::from(j) / f64::from(PLACES)).position;
                let steps = (0..PLACES).map(|j| (at(j).distance(at(j + 1)), j));
                let (step, j) = steps.fold((0.0, 0), |most, here| if here.0 > most.0 { here } else { most });
                assert!(step < 0.05, "{name}: {:?} leaps by {step} at {j}, a = {a}", face.kind());
            }
        }
    }
}

#[test]
fn the_slopes_of_a_bridge_are_those_of_its_positions() {
    const STEP: f64 = 1e-6;
    for (name, design) in leaping() {
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        let lining = pot.faces().iter().find(|face| face.kind() == FaceKind::Lining).unwrap();
        let (mut off, n) = (0, 1500);
        for j in 0..n {
            let v = TAU * (f64::from(j) + 0.3) / f64::from(n);
            let [before, here, after] = [v - STEP, v, v + STEP].map(|v| lining.jet(1.0, v));
            let slope = (after.position - before.position) / (2.0 * STEP);
            off += i32::from(slope.distance(here.dv) > 1e-4 * slope.length().max(1.0));
        }
        // Where a bridge ends the edge has a kink, between two such places as a rule.
        assert!(off <= 2, "{name}: {off} of {n}");
    }
}

/// What was between the sides of a leap was met by no triangle within the tolerance.
#[test]
fn meshes_follow_a_bridge() {
    let (_, dint) = &leaping()[0];
    let mesh = &pasu::solid(dint, &Making { tolerance: Some(0.01), ..Making::default() }).unwrap()[0];
    assert!(mesh.bound < 0.02, "{}", mesh.bound);
}

#[test]
fn from_a_bridge_the_lining_goes_straight_down_to_the_floor() {
    for (name, design) in leaping() {
        let pot = Pot::new(&design, 0, Product::Pot).unwrap();
        let upright = pot.faces().iter().filter(|face| face.kind() == FaceKind::Lining).nth(1).unwrap();
        let heights = (0..500).map(|j| {
            let v = TAU * f64::from(j) / 500.0;
            upright.jet(0.0, v).position.z - upright.jet(1.0, v).position.z
        });
        let (least, most) = heights.fold((f64::INFINITY, 0.0f64), |(least, most), h| (least.min(h), most.max(h)));
        assert!(least > -1e-9 && most > 1e-3, "{name}: straight down by {least} to {most}");
    }
}

/// A floor whose edge is not seen as a whole from its middle goes back over itself, and what was covered three times was counted so: 1.2 of 558, with an error of 0.03.
#[test]
fn a_floor_that_folds_over_itself_has_the_area_of_its_triangles() {
    let (_, waves) = &leaping()[1];
    let told = pasu::measure(waves, &MeasureOptions::default()).unwrap().whole.clay.unwrap().area;
    // Chords take away as much as they are off: of three tolerances two tell where that leads to.
    let area = |tolerance: f64| {
        let mesh = &pasu::solid(waves, &Making { tolerance: Some(tolerance), ..Making::default() }).unwrap()[0];
        let corner = |k: u32| glam::Vec3::from_slice(&mesh.positions[3 * k as usize..]).as_dvec3() / 10.0;
        let triangles = mesh.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(corner));
        triangles.map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum::<f64>()
    };
    let (coarse, fine) = (area(0.01), area(0.004));
    let met = fine + (fine - coarse) * 0.004 / (0.01 - 0.004);
    assert!((told.value - met).abs() < 0.1, "{told:?} {met}");
}
