//! What lies along a ray and what holds a point, against formulas and against the triangles of files.

use glam::{DMat3, DVec3};
use pasu::{Code, Design, Hit, Making, Product, Ray, Solution, at, pick};
use serde_json::{Value, json};

use crate::support::networks::{Dice, cube};
use crate::support::{design, gallery};

/// A number between two others.
fn between(dice: &mut Dice, least: f64, greatest: f64) -> f64 {
    least + (greatest - least) * (0.5 + 0.5 * dice.number())
}

fn point(dice: &mut Dice, size: f64) -> DVec3 {
    DVec3::new(dice.number(), dice.number(), dice.number()) * size
}

fn exponents(dice: &mut Dice, least: f64) -> [f64; 3] {
    [(); 3].map(|()| (least * (50.0 / least).powf(0.5 + 0.5 * dice.number()) * 1e6).round() / 1e6)
}

fn place(dice: &mut Dice, shift: f64) -> Value {
    let scale = [(); 3].map(|()| between(dice, 0.5, 2.0) * if dice.number() < -0.5 { -1.0 } else { 1.0 });
    let [axis, shift] = [1.0, shift].map(|size| point(dice, size).to_array());
    json!({ "scale": scale, "axis": axis, "angle": between(dice, -3.0, 3.0), "shift": shift })
}

fn scene(parts: &[Value]) -> Design {
    design(&json!({ "pasu": 1, "parts": parts }).to_string())
}

/// From the world into the frame of the first part.
fn own(design: &Design, part: usize) -> impl Fn(DVec3) -> DVec3 {
    let place = design.parts()[part].place;
    let (matrix, shift) = (DMat3::from_cols_array_2d(&place.matrix()).transpose(), DVec3::from_array(place.shift));
    let inverse = matrix.inverse();
    move |at| inverse * (at - shift)
}

fn ray(origin: DVec3, direction: DVec3) -> Ray {
    Ray { origin: origin.to_array(), direction: direction.to_array() }
}

#[test]
fn octants_hold_what_their_formula_holds() {
    let mut dice = Dice(11);
    for round in 0..60 {
        // Small exponents make parts that are thinner than places are told apart: they are only asked what they hold.
        let given = exponents(&mut dice, if round % 2 == 0 { 0.3 } else { 0.05 });
        let place = place(&mut dice, 3.0);
        let design = scene(&[json!({ "shape": { "kind": "octant", "exponents": given }, "place": place })]);
        let Some(pasu::Shape::Octant(octant)) = design.parts().first().map(|part| part.shape.clone()) else {
            unreachable!()
        };
        let own = own(&design, 0);
        let excess = |at: DVec3| {
            let at = own(at);
            let powers: f64 = (0..3).map(|i| at[i].max(0.0).powf(octant.exponents[i])).sum();
            (powers - 1.0).max(-at.min_element())
        };
        let solution = Solution::of(&design);
        for _ in 0..60 {
            let from = point(&mut dice, 4.0);
            if excess(from).abs() > 1e-9 {
                assert_eq!(solution.at(from.to_array()).unwrap().len(), usize::from(excess(from) < 0.0), "{given:?}");
            }
            if round % 2 == 1 {
                continue;
            }
            // Through the inside, so that it is met.
            let to = DVec3::from_array(design.parts()[0].place.shift) + point(&mut dice, 1.0);
            let direction = (to - from).normalize();
            let hits = solution.pick(ray(from, to - from)).unwrap();
            // Between two hits that follow each other the formula says one thing.
            let mut places: Vec<f64> = hits.iter().map(|hit| hit.distance).collect();
            places.push(places.last().copied().unwrap_or(0.0) + 1.0);
            let mut before = 0.0;
            let is_in = excess(from) < 0.0;
            for (index, t) in places.into_iter().enumerate() {
                let middle = from + direction * (0.5 * (before + t));
                if t - before > 1e-6 && excess(middle).abs() > 1e-12 {
                    assert_eq!(excess(middle) < 0.0, is_in != (index % 2 == 1), "{given:?} {from} {to} {hits:?}");
                }
                before = t;
            }
            for hit in &hits {
                assert!(excess(DVec3::from_array(hit.point)).abs() < 1e-6, "{given:?} {hit:?}");
                assert!((DVec3::from_array(hit.normal).length() - 1.0).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn depths_in_a_ball_and_a_box_are_those_of_their_formulas() {
    let mut dice = Dice(5);
    let ball =
        scene(&[json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "scale": [3, 3, 3] } })]);
    let solution = Solution::of(&ball);
    for _ in 0..200 {
        let from = point(&mut dice, 3.0).abs();
        let depth = (3.0 - from.length()).min(from.min_element());
        let hits = solution.at(from.to_array()).unwrap();
        assert_eq!(hits.len(), usize::from(depth >= 0.0));
        for Hit { distance, point, normal, .. } in hits {
            assert!((distance - depth).abs() < 3e-9, "{from} {distance} {depth}");
            let away = DVec3::from_array(point) - from;
            assert!((away.length() - depth).abs() < 3e-9);
            assert!(depth < 1e-3 || away.normalize().dot(DVec3::from_array(normal)) > 1.0 - 1e-6, "{from} {normal:?}");
        }
    }
}

/// Blends of one radius are cylinders where their border is a cubic, and cones where the radius grows evenly: both solids and vases.
#[test]
fn cylinders_and_cones_are_met_where_their_formulas_say() {
    let mut dice = Dice(9);
    let section = |z: f64| json!({ "form": "disc", "radius": [2, 2], "z": z, "taper": 0, "dz": 3 });
    let cylinder = json!({ "kind": "blend", "start": section(0.0), "end": section(3.0), "method": "modal" });
    let cone = json!({ "kind": "second-order", "r": [3, 0, 1, 0], "t": [0, 0], "n": [1, 2], "height": 4 });
    for round in 0..60 {
        let place = place(&mut dice, 3.0);
        let (shape, is_solid) = if round % 2 == 0 { (&cylinder, true) } else { (&cone, false) };
        let design = scene(&[json!({ "shape": shape, "place": place })]);
        let own = own(&design, 0);
        let solution = Solution::of(&design);
        for _ in 0..10 {
            let from = point(&mut dice, 6.0);
            let local = own(from);
            let inside = [2.0 - local.truncate().length(), local.z, 3.0 - local.z].into_iter().fold(9.0, f64::min);
            if inside.abs() > 1e-8 {
                let held = solution.at(from.to_array()).unwrap().len();
                assert_eq!(held, usize::from(is_solid && inside > 0.0), "{local}");
            }
            let to = DVec3::from_array(design.parts()[0].place.shift) + point(&mut dice, 2.0);
            let direction = (to - from).normalize();
            let along = own(from + direction) - local;
            // r = a + b z, on which x^2 + y^2 = (a + b z)^2.
            let (a, b, height) = if is_solid { (2.0, 0.0, 3.0) } else { (1.0, 0.5, 4.0) };
            let (p, d) = (local.truncate(), along.truncate());
            let (w, s) = (a + b * local.z, b * along.z);
            let (q, h, c) = (d.length_squared() - s * s, p.dot(d) - w * s, p.length_squared() - w * w);
            let root = h * h - q * c;
            let mut expected = Vec::new();
            if root > 0.0 {
                for t in [(-h - root.sqrt()) / q, (-h + root.sqrt()) / q] {
                    let z = local.z + t * along.z;
                    if (0.0..=height).contains(&z) && a + b * z > 0.0 {
                        expected.push(t);
                    }
                }
            }
            for z in [0.0, height].into_iter().filter(|_| is_solid) {
                let t = (z - local.z) / along.z;
                if (p + t * d).length() <= a {
                    expected.push(t);
                }
            }
            expected.retain(|t| *t >= 0.0);
            expected.sort_by(f64::total_cmp);
            let hits = solution.pick(ray(from, direction * 7.0)).unwrap();
            let found: Vec<f64> = hits.iter().map(|hit| hit.distance).collect();
            assert_eq!(found.len(), expected.len(), "{round} {from} {to} {found:?} {expected:?}");
            for (found, expected) in found.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-9, "{found} {expected}");
            }
            // Where a surface says it is, it is.
            for hit in hits.iter().filter(|_| !is_solid) {
                let there = solution.evaluate(0, &[hit.u.unwrap(), hit.v.unwrap()]).unwrap();
                assert!((DVec3::from_slice(&there) - own(DVec3::from_array(hit.point))).length() < 1e-9);
            }
        }
    }
}

/// How often the triangles of a file go round a point, and how near they come.
fn round(mesh: &pasu::SolidMesh, at: DVec3) -> (f64, f64) {
    let corner =
        |i: u32| DVec3::from_array([0, 1, 2].map(|k| f64::from(mesh.positions[3 * i as usize + k]))) * 0.1 - at;
    let (mut angle, mut nearest) = (0.0, f64::INFINITY);
    for triangle in mesh.indices.chunks_exact(3) {
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]].map(corner);
        let [p, q, r] = [a, b, c].map(DVec3::length);
        angle += 2.0 * a.dot(b.cross(c)).atan2(p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q);
        nearest = nearest.min(p.min(q).min(r) - (a - b).length().max((b - c).length()).max((c - a).length()));
    }
    (angle / (4.0 * std::f64::consts::PI), nearest)
}

/// Pots with their walls, as they are made: whatever is not within a triangle of their border is held, and met, as by the triangles of the file.
#[test]
fn pots_hold_what_their_files_go_round() {
    let mut dice = Dice(21);
    // All of them when somebody wants to know; each takes a second or two.
    let every = if std::env::var("SPACES").is_ok() { 1 } else { 12 };
    let mut n_inside = 0;
    for exhibit in gallery().into_iter().step_by(every) {
        let size = exhibit.design();
        let measured = pasu::measure(&size, &pasu::MeasureOptions::default()).unwrap().whole;
        let thickness = 0.04 * measured.height.value;
        let wall = json!({ "thickness": thickness, "base": thickness, "rim": "rounded" });
        let design =
            scene(&[json!({ "shape": exhibit.shape, "wall": wall, "place": { "axis": [1, 0, 1], "angle": 0.4 } })]);
        let solution = Solution::of(&design);
        let Ok(meshes) = solution.solid(&Making { product: Product::Pot, ..Making::default() }) else { continue };
        let mesh = &meshes[0];
        let reach = 4.0 * measured.height.value;
        for _ in 0..40 {
            // Beside a corner of a triangle: above and beneath the surface.
            let n = mesh.positions.len() / 3;
            let i = ((0.5 + 0.5 * dice.number()) * n as f64) as usize % n;
            let corner = DVec3::from_array([0, 1, 2].map(|k| f64::from(mesh.positions[3 * i + k]))) * 0.1;
            let from = corner + point(&mut dice, thickness);
            let (winding, _) = round(mesh, from);
            let bound = 2.0 * mesh.bound;
            let hits = solution.at(from.to_array()).unwrap();
            if let Some(hit) = hits.first() {
                if hit.distance < bound {
                    continue;
                }
                n_inside += 1;
            } else if winding > 0.5 && nearest(mesh, from) < bound {
                continue;
            }
            assert_eq!(hits.len(), usize::from(winding > 0.5), "{} {from} {winding} {hits:?}", exhibit.name);
            // In and out by turns, and beside a hit the file says the same.
            let direction = point(&mut dice, 1.0).normalize();
            let hits = solution.pick(ray(from, direction)).unwrap();
            assert_eq!(hits.len() % 2, usize::from(winding > 0.5), "{} {from} {direction} {hits:?}", exhibit.name);
            for hit in &hits {
                let there = DVec3::from_array(hit.point);
                assert!((there - from - direction * hit.distance).length() < 1e-9 * reach, "{hit:?}");
                assert!(nearest(mesh, there) <= bound, "{} {hit:?} {} {bound}", exhibit.name, nearest(mesh, there));
                assert!(hit.face.is_some() && hit.u.is_none());
            }
        }
    }
    assert!(n_inside > 30, "{n_inside}");
}

/// How near a point is to the triangles of a file.
fn nearest(mesh: &pasu::SolidMesh, at: DVec3) -> f64 {
    let corner = |i: u32| DVec3::from_array([0, 1, 2].map(|k| f64::from(mesh.positions[3 * i as usize + k]))) * 0.1;
    let mut least = f64::INFINITY;
    for triangle in mesh.indices.chunks_exact(3) {
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]].map(corner);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let sides = [(a, b), (b, c), (c, a)];
        if sides.iter().all(|(from, to)| (*to - *from).cross(at - *from).dot(normal) >= 0.0) {
            least = least.min(normal.dot(at - a).abs());
        }
        for (from, to) in sides {
            let along = to - from;
            let share = ((at - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            least = least.min((from + along * share - at).length());
        }
    }
    least
}

#[test]
fn what_has_no_inside_is_met_and_holds_nothing() {
    let vase = scene(&[json!({ "shape": { "kind": "second-order", "r": [1, 0.1, 2, 0.1], "height": 4 } })]);
    assert!(at(&vase, [0.0, 0.0, 2.0]).unwrap().is_empty());
    assert_eq!(pick(&vase, Ray { origin: [-9.0, 0.1, 2.0], direction: [1.0, 0.0, 0.0] }).unwrap().len(), 2);
    // Of a closed network the inside is.
    let cube = scene(&[json!({ "shape": cube() })]);
    let hits = at(&cube, [0.2, 0.1, -0.7]).unwrap();
    assert!((hits[0].distance - 0.3).abs() < 1e-12 && hits[0].normal == [0.0, 0.0, -1.0], "{hits:?}");
    // Through the middle of an edge and through a corner: once in, once out.
    for direction in [[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 0.0]] {
        let origin = direction.map(|c: f64| -5.0 * c);
        let hits = pick(&cube, Ray { origin, direction }).unwrap();
        assert_eq!(hits.len(), 2, "{direction:?} {hits:?}");
    }
}

#[test]
fn hits_are_sorted_by_how_far_they_are_and_parts_by_how_deep() {
    let ball =
        |z: f64| json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "shift": [0, 0, z] } });
    let design = scene(&[ball(6.0), ball(0.0), ball(0.5), ball(3.0)]);
    let hits = pick(&design, Ray { origin: [0.1, 0.1, -1.0], direction: [0.0, 0.0, 1.0] }).unwrap();
    let parts: Vec<usize> = hits.iter().map(|hit| hit.part).collect();
    assert_eq!(parts, [1, 2, 1, 2, 3, 3, 0, 0]);
    assert!(hits.windows(2).all(|pair| pair[0].distance <= pair[1].distance));
    let held: Vec<usize> = at(&design, [0.3, 0.3, 0.52]).unwrap().iter().map(|hit| hit.part).collect();
    assert_eq!(held, [2, 1]);
}

#[test]
fn what_is_no_ray_and_no_point_is_refused_with_its_path() {
    let ball = scene(&[json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] } })]);
    let (nan, huge) = (f64::NAN, 1e300);
    for (origin, direction, code, path) in [
        ([0.0, nan, 0.0], [1.0, 0.0, 0.0], Code::NotFinite, "ray.origin[1]"),
        ([0.0, 0.0, 0.0], [1.0, 0.0, f64::INFINITY], Code::NotFinite, "ray.direction[2]"),
        ([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], Code::OutOfRange, "ray.direction"),
        ([huge, 0.0, 0.0], [1.0, 0.0, 0.0], Code::OutOfRange, "ray.origin[0]"),
    ] {
        let error = pick(&ball, Ray { origin, direction }).unwrap_err();
        assert_eq!((error.code(), error.path()), (code, path));
    }
    let error = at(&ball, [0.0, 0.0, nan]).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::NotFinite, "point[2]"));
    // A direction of any length is one.
    for length in [5e-324, 1e-310, 1e-160, 1e99] {
        let hits = pick(&ball, Ray { origin: [0.1, 0.1, -1.0], direction: [0.0, 0.0, length] }).unwrap();
        assert_eq!(hits.len(), 2, "{length}");
    }
    let far =
        scene(&[json!({ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "scale": [1e200, 1, 1] } })]);
    let error = at(&far, [0.1; 3]).unwrap_err();
    assert_eq!((error.code(), error.path()), (Code::Overflow, "parts[0]"));
}

/// Of any size, and as far from the origin as leaves its digits.
#[test]
fn sizes_make_no_difference() {
    for size in [1e-60, 1e-6, 1.0, 1e6, 1e60] {
        let place = json!({ "scale": [size, size, size], "shift": [3.0 * size, 0, 0] });
        let parts = [
            json!({ "shape": { "kind": "octant", "exponents": [0.05, 50, 1] }, "place": place }),
            json!({ "shape": { "kind": "second-order", "r": [1, 0.1, 2, 0.1], "height": 4 }, "place": place }),
            json!({ "shape": cube(), "place": place }),
        ];
        let design = scene(&parts);
        let origin = [3.0 * size, 0.11 * size, 0.07 * size];
        let hits = pick(&design, Ray { origin, direction: [1.0, 0.2, 0.1] }).unwrap();
        let parts: Vec<(usize, f64)> =
            hits.iter().map(|hit| (hit.part, (hit.distance / size * 1e9).round() / 1e9)).collect();
        let expected = scene_of_one();
        assert_eq!(parts, expected, "{size}");
    }
}

fn scene_of_one() -> Vec<(usize, f64)> {
    let place = json!({ "shift": [3, 0, 0] });
    let parts = [
        json!({ "shape": { "kind": "octant", "exponents": [0.05, 50, 1] }, "place": place }),
        json!({ "shape": { "kind": "second-order", "r": [1, 0.1, 2, 0.1], "height": 4 }, "place": place }),
        json!({ "shape": cube(), "place": place }),
    ];
    let hits = pick(&scene(&parts), Ray { origin: [3.0, 0.11, 0.07], direction: [1.0, 0.2, 0.1] }).unwrap();
    let found: Vec<(usize, f64)> = hits.iter().map(|hit| (hit.part, (hit.distance * 1e9).round() / 1e9)).collect();
    assert!(found.len() >= 2, "{found:?}");
    found
}
