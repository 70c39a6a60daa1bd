//! What parts are to each other: apart, run through each other, within each other's clay, or the same body twice.

use core::f64::consts::PI;

use glam::DVec3;

use super::report::{Finding, Severity};
use crate::check;
use crate::error::Args;
use crate::solid::place;
use crate::watch;
use crate::weave::SolidMesh;

/// What one part is to another.
struct Relation {
    severity: Severity,
    code: &'static str,
    /// Which it is, as a program knows it and in words.
    word: &'static str,
    words: &'static str,
}

const SAME_PLACE: Relation = Relation {
    severity: Severity::Error,
    code: "same-place",
    word: "same-body",
    words: "is the same body in the same place as",
};

const TOUCHES: Relation = overlap_of("touches", "touches or runs through");

const WITHIN: Relation = overlap_of("within", "lies within the clay of");

const ROUND: Relation = overlap_of("round", "has clay round all of");

const fn overlap_of(word: &'static str, words: &'static str) -> Relation {
    Relation { severity: Severity::Warning, code: "overlap", word, words }
}

type Box3 = [[f32; 3]; 2];

/// What there is to say of parts that have clay in common; `name` is what a part is called, `millimetres` how many a model unit has.
///
/// Two parts that touch or cross are told by exact predicates on the triangles of the file. Where none do, one corner of each tells whether it lies within the other's clay; a part in the hollow of another is apart from it.
pub(super) fn findings(meshes: &[&SolidMesh], name: impl Fn(usize) -> String, millimetres: f64) -> Vec<Finding> {
    let boxes: Vec<Box3> = meshes.iter().map(|mesh| bounds(points(mesh))).collect();
    let mut found = Vec::new();
    for (j, other) in meshes.iter().enumerate() {
        for (i, one) in meshes.iter().enumerate().take(j) {
            let common = overlap(&boxes[i], &boxes[j]);
            let Some((Relation { severity, code, word, words }, at)) =
                common.and_then(|common| told(one, other, &common))
            else {
                continue;
            };
            let at = at / millimetres;
            let message = format!("{} {words} {} at {}", name(other.part), name(one.part), place(at));
            let at = Some(at.to_array());
            let args = Args::from([("what", word.into()), ("other", one.part.into())]);
            found.push(Finding { code, severity, part: other.part, path: None, message, args, at, remedy: None });
        }
    }
    found
}

/// How two parts whose boxes have this in common meet, in words, and where in millimetres.
fn told(one: &SolidMesh, other: &SolidMesh, common: &Box3) -> Option<(Relation, DVec3)> {
    if one.positions == other.positions && one.indices == other.indices {
        let at = points(one).next().map_or(DVec3::ZERO, point);
        return Some((SAME_PLACE, at));
    }
    if let Some(at) = meeting(one, other, common) {
        return Some((TOUCHES, at));
    }
    for (inner, outer, relation) in [(other, one, WITHIN), (one, other, ROUND)] {
        let at = points(inner).next().map(point)?;
        if winding(outer, at) > 0.5 {
            return Some((relation, at));
        }
    }
    None
}

/// The middle of one of two triangles that cross or touch, one of each mesh.
fn meeting(one: &SolidMesh, other: &SolidMesh, common: &Box3) -> Option<DVec3> {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut n_first = 0;
    for mesh in [one, other] {
        n_first = triangles.len();
        for corners in corners(mesh) {
            // Only what reaches into both boxes can meet the other.
            if overlap(&bounds(corners.into_iter()), common).is_some() {
                let base = positions.len() as u32;
                positions.extend(corners);
                triangles.push([base, base + 1, base + 2]);
            }
        }
    }
    let group = |triangle: u32| Some(u32::from(triangle as usize >= n_first));
    let [first, _] = check::a_crossing(&positions, &triangles, group)?;
    Some(triangles[first as usize].into_iter().map(|vertex| point(positions[vertex as usize])).sum::<DVec3>() / 3.0)
}

/// How often a closed mesh goes round a point that is not on it: the solid angles of its triangles (A. Van Oosterom, J. Strackee, 1983) over those of a sphere.
fn winding(mesh: &SolidMesh, at: DVec3) -> f64 {
    let angle = |corners: [[f32; 3]; 3]| {
        let [a, b, c] = corners.map(|corner| point(corner) - at);
        let [p, q, r] = [a, b, c].map(DVec3::length);
        watch::work(10);
        2.0 * libm::atan2(a.dot(b.cross(c)), p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q)
    };
    corners(mesh).map(angle).sum::<f64>() / (4.0 * PI)
}

fn points(mesh: &SolidMesh) -> impl Iterator<Item = [f32; 3]> + '_ {
    mesh.positions.as_chunks::<3>().0.iter().copied()
}

fn corners(mesh: &SolidMesh) -> impl Iterator<Item = [[f32; 3]; 3]> + '_ {
    let points = mesh.positions.as_chunks::<3>().0;
    mesh.indices.as_chunks::<3>().0.iter().map(|triangle| triangle.map(|vertex| points[vertex as usize]))
}

fn point(at: [f32; 3]) -> DVec3 {
    DVec3::from_array(at.map(f64::from))
}

fn bounds(points: impl Iterator<Item = [f32; 3]>) -> Box3 {
    points.fold([[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]], |[low, high], at| {
        [core::array::from_fn(|i| low[i].min(at[i])), core::array::from_fn(|i| high[i].max(at[i]))]
    })
}

/// What two boxes have in common, borders included.
fn overlap([low, high]: &Box3, [other_low, other_high]: &Box3) -> Option<Box3> {
    let common =
        [core::array::from_fn(|i| low[i].max(other_low[i])), core::array::from_fn(|i| high[i].min(other_high[i]))];
    (0..3).all(|i| common[0][i] <= common[1][i]).then_some(common)
}

#[cfg(test)]
mod tests {
    use crate::design::Design;
    use crate::make::{Making, check};

    /// Cups of radius 3 and height 4 with a wall of 0.5, each scaled with its wall and moved.
    fn codes(places: &[(f64, [f64; 3])]) -> Vec<(&'static str, bool)> {
        let parts = places.iter().map(|(scale, shift)| {
            serde_json::json!({
                "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
                "place": { "scale": [scale, scale, scale], "shift": shift },
                "wall": { "thickness": 0.5 * scale, "base": 0.5 * scale }
            })
        });
        let document = serde_json::json!({ "pasu": 1, "parts": parts.collect::<Vec<_>>() });
        let report = check(&Design::parse(&document.to_string()).unwrap(), &Making::default()).unwrap();
        let is_ok = report.is_ok();
        report.findings.iter().map(|finding| (finding.code, is_ok)).collect()
    }

    #[test]
    fn parts_that_are_apart_are_not_spoken_of() {
        assert_eq!(codes(&[(1.0, [0.0; 3]), (1.0, [7.0, 0.0, 0.0])]), []);
        // In the hollow of the other, whose boxes overlap.
        assert_eq!(codes(&[(1.0, [0.0; 3]), (0.5, [0.0, 0.0, 1.0])]), []);
    }

    #[test]
    fn parts_that_run_through_each_other_are_found() {
        assert_eq!(codes(&[(1.0, [0.0; 3]), (1.0, [1.0, 0.0, 0.0])]), [("overlap", true)]);
        assert_eq!(codes(&[(1.0, [0.0; 3]), (1.0, [0.0, 0.0, 2.0])]), [("overlap", true)]);
    }

    #[test]
    fn one_pot_twice_in_one_place_is_an_error() {
        assert_eq!(codes(&[(1.0, [0.0; 3]), (1.0, [0.0; 3])]), [("same-place", false)]);
    }

    #[test]
    fn a_part_within_the_clay_of_another_is_found() {
        // Of a quarter of a millimetre in the middle of a base of 5.
        let (large, small) = ((1.0, [0.0; 3]), (0.01, [0.0, 0.0, 0.2]));
        for places in [[large, small], [small, large]] {
            assert!(codes(&places).contains(&("overlap", true)), "{:?}", codes(&places));
        }
        // As small, in the hollow.
        assert!(!codes(&[large, (0.01, [0.0, 0.0, 2.0])]).contains(&("overlap", true)));
    }
}
