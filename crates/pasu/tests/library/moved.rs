//! What a part measures is that of its body where it was moved to, also of a copy of another part: against the triangles that are made there.
//!
//! What its time buys: a body is measured once, at the origin, and whatever says where something is has to go along with every copy of it.

use glam::DVec3;
use pasu::{Design, Making, MeasureOptions, PartMeasures, SolidMesh, Solution, measure};
use serde_json::{Value, json};

use crate::support::random::{Random, drawn};

const SHIFTS: [DVec3; 3] = [DVec3::ZERO, DVec3::new(40.0, 0.25, 0.0), DVec3::new(-13.5, 60.0, 7.5)];

/// Models are in centimetres, meshes in millimetres.
const MILLIMETRES: f64 = 10.0;

/// A drawn pot at the origin, and copies of it that were moved.
fn copies(seed: u64) -> Design {
    let mut drawn: Value = serde_json::from_str(&Random::new(seed).design()).unwrap();
    let part = drawn["parts"][0].take();
    let copy = |(object, shift): (usize, &DVec3)| {
        let mut part = part.clone();
        part["object"] = json!(object);
        part["place"]["shift"] = json!(shift.to_array());
        part
    };
    drawn["parts"] = SHIFTS.iter().enumerate().map(copy).collect();
    Design::parse(&drawn.to_string()).unwrap_or_else(|e| panic!("{seed}: {e}"))
}

/// Volume and centre of what the triangles go round, in centimetres.
fn enclosed(mesh: &SolidMesh) -> (f64, DVec3) {
    let corner = |index: &u32| {
        let p = &mesh.positions[3 * *index as usize..][..3];
        DVec3::new(f64::from(p[0]), f64::from(p[1]), f64::from(p[2])) / MILLIMETRES
    };
    let middle = corner(&0);
    let (mut volume, mut moment) = (0.0, DVec3::ZERO);
    for triangle in mesh.indices.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|k| corner(&triangle[k]) - middle);
        let tetrahedron = a.dot(b.cross(c)) / 6.0;
        volume += tetrahedron;
        moment += (a + b + c) * (0.25 * tetrahedron);
    }
    (volume, middle + moment / volume)
}

/// What of the measures says where something is.
fn places(part: &PartMeasures) -> Vec<DVec3> {
    let body = &part.body;
    let centres = [body.centre.empty, body.centre.full].into_iter().flatten().map(|centre| centre.at);
    let spill = body.capacity.map(|capacity| capacity.spill.at);
    let thinnest = part.thickness.and_then(|thickness| thickness.least.at);
    let overhangs = [part.overhang, part.overhang_inside].into_iter().flatten().map(|overhang| overhang.at);
    let ranges = [part.curvature.mean, part.curvature.gaussian];
    let bends = ranges.iter().flat_map(|range| [range.least, range.greatest]).flatten().map(|located| located.at);
    let hull = body.footprint.iter().flat_map(|foot| foot.hull.iter().map(|p| [p[0], p[1], foot.level]));
    let all = centres.chain(spill).chain(thinnest).chain(overhangs).chain(bends).chain(hull);
    all.map(DVec3::from_array).collect()
}

#[test]
fn all_that_is_told_of_a_copy_is_on_the_triangles_that_are_made_of_it() {
    let mut n_made = 0;
    for seed in 1..=drawn(12, 200) {
        let solution = Solution::of(&copies(seed));
        let measures = solution.measure(&MeasureOptions { fill: Some(0.0), ..MeasureOptions::default() }).unwrap();
        let made = solution.solid(&Making::default());
        for (part, shift) in measures.parts.iter().zip(SHIFTS) {
            assert!(made.is_err() || part.is_pot, "{seed}: {:?}", part.reason);
            // What was found on the first is where that is, unless rounding decides where a wall is thin, or too thin for the numbers of a file where it stands.
            let is_even = part.is_pot == measures.parts[0].is_pot
                && part.thickness.is_none_or(|thickness| thickness.thinned.value == 0.0);
            let here = places(part);
            for (place, first) in here.iter().zip(places(&measures.parts[0])).filter(|_| is_even) {
                assert!(
                    (*place - shift - first).length() <= 1e-12 * shift.length(),
                    "{seed}: {place} {shift} {first} {}",
                    solution.design().to_json()
                );
            }
            let Ok(meshes) = &made else { continue };
            let mesh = &meshes[part.part];
            let (volume, centre) = enclosed(mesh);
            let clay = part.body.clay.unwrap();
            // The triangles lie on either side of the clay's border, no farther from it than they keep.
            let off = clay.area.value * mesh.bound;
            assert!((clay.volume.value - volume).abs() <= off, "{seed}: {clay:?} {volume} {off}");
            let found = DVec3::from_array(part.body.centre.empty.unwrap().at);
            let size = part.body.height.value.max(part.body.width.greatest.value);
            assert!((found - centre).length() * volume <= 2.0 * off * size, "{seed}: {found} {centre}");
            let ends = mesh.positions.chunks_exact(3).map(|p| f64::from(p[2]) / MILLIMETRES);
            let [low, high] = ends.fold([f64::MAX, f64::MIN], |[low, high], z| [low.min(z), high.max(z)]);
            let bound = 1.01 * mesh.bound;
            let body = &part.body;
            assert!(
                (body.bottom - low).abs() <= bound && (body.top - high).abs() <= bound,
                "{seed}: {shift} {low} {high} {} {} {bound}",
                body.bottom,
                body.top
            );
            let level = body.footprint.as_ref().unwrap().level;
            assert!((level - body.bottom).abs() <= 1e-9 * size, "{seed}: {level}");
            if let Some(capacity) = body.capacity {
                let (floor, spill) = (capacity.floor, capacity.spill.level.value);
                assert!(body.bottom < floor && floor <= spill && spill <= body.top + 1e-9, "{seed}: {floor} {spill}");
                assert!((capacity.spill.at[2] - spill).abs() <= 1e-6 * size, "{seed}: {:?}", capacity.spill);
                assert_eq!(capacity.fill.unwrap().level, spill.min(0.0));
            }
            n_made += 1;
        }
        // One that stands alone measures as it does among its copies.
        let last = SHIFTS.len() - 1;
        let mut alone: Value = serde_json::from_str(&solution.design().to_json()).unwrap();
        alone["parts"] = json!([alone["parts"][last]]);
        alone["parts"][0]["object"] = json!(0);
        let alone = measure(&Design::parse(&alone.to_string()).unwrap(), &MeasureOptions::default()).unwrap();
        let (alone, among) = (&alone.parts[0].body, &measures.parts[last].body);
        assert_eq!((alone.bottom, &alone.clay, &alone.centre), (among.bottom, &among.clay, &among.centre));
    }
    assert!(n_made >= 18, "{n_made}");
}
