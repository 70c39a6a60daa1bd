//! How far the surface moves where the triangles round a vertex give way to others.

use glam::{DVec2, DVec3};

use crate::mesh::cleared::height;

/// How far two ways of dividing one region into triangles, round `own` and round `goal`, are from each other at most: measured over a plane the distance is greatest where an edge of one meets one of the other, and at the vertex that goes. `None` where they are not both over
/// one plane, but for triangles lower than `least`, whose heights are added. `is_within` says that `own` is in no edge of the region.
pub(super) fn apart(
    own: DVec3,
    goal: DVec3,
    old: &[[DVec3; 3]],
    new: &[[DVec3; 3]],
    least: f64,
    is_within: bool,
) -> Option<f64> {
    let normal = old.iter().map(|[a, b, c]| (*b - *a).cross(*c - *a)).sum::<DVec3>().try_normalize()?;
    let one = normal.any_orthonormal_vector();
    let other = normal.cross(one);
    let project = |at: DVec3| DVec2::new(at.dot(one), at.dot(other));
    let area = |[a, b, c]: [DVec3; 3]| (project(b) - project(a)).perp_dot(project(c) - project(a));
    let mut spare = 0.0;
    for triangle in old.iter().chain(new) {
        let [a, b, c] = *triangle;
        if !(area(*triangle) > 0.0) {
            let height = height(a, b, c);
            if !(height < least) {
                return None;
            }
            spare = height.max(spare);
        }
    }
    let mut most = 0.0f64;
    if is_within {
        let at = project(own);
        let over = new.iter().filter_map(|triangle| {
            let [a, b, c] = *triangle;
            let whole = area(*triangle);
            let weight = |a: DVec3, b: DVec3| (project(a) - at).perp_dot(project(b) - at) / whole;
            let weights = [weight(b, c), weight(c, a), weight(a, b)];
            let is_in = whole > 0.0 && weights.iter().all(|weight| *weight >= -1e-9);
            is_in.then(|| (a * weights[0] + b * weights[1] + c * weights[2] - own).dot(normal).abs())
        });
        most = over.min_by(f64::total_cmp)?;
    }
    let spokes = |all: &[[DVec3; 3]], hub: DVec3| -> Vec<DVec3> {
        all.iter().flatten().copied().filter(|at| *at != hub).collect()
    };
    for from in spokes(old, own) {
        for to in spokes(new, goal) {
            let (along, across) = (project(from) - project(own), project(to) - project(goal));
            let whole = along.perp_dot(across);
            let between = project(goal) - project(own);
            let [s, t] = [between.perp_dot(across) / whole, between.perp_dot(along) / whole];
            if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
                let gap = own + (from - own) * s - goal - (to - goal) * t;
                most = most.max(gap.dot(normal).abs());
            }
        }
    }
    Some(most + spare)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The triangles of a ring of corners round a hub, and those that are left when the hub goes to the first of them.
    fn both(hub: DVec3, ring: &[DVec3]) -> [Vec<[DVec3; 3]>; 2] {
        let n = ring.len();
        let old = (0..n).map(|k| [hub, ring[k], ring[(k + 1) % n]]).collect();
        let new = (1..n - 1).map(|k| [ring[0], ring[k], ring[k + 1]]).collect();
        [old, new]
    }

    #[test]
    fn a_tent_comes_down_by_its_height() {
        let ring = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        for height in [0.0, 1e-6, 0.25] {
            let hub = DVec3::new(0.0, 0.0, height);
            let [old, new] = both(hub, &ring);
            let found = apart(hub, ring[0], &old, &new, 1e-9, true).unwrap();
            assert!((found - height).abs() < 1e-15, "{height}: {found}");
        }
    }

    /// Against the greatest distance over places of a fine grid, by the heights of both surfaces there.
    #[test]
    fn no_place_of_either_is_further_than_told() {
        let mut state = 7u64;
        let mut draw = move || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) as f64 / (1u64 << 31) as f64 - 0.5
        };
        let mut n_told = 0;
        for _ in 0..200 {
            let ring: Vec<DVec3> = (0..6)
                .map(|k| {
                    let (sin, cos) = libm::sincos(f64::from(k) * 1.047 + 0.3 * draw());
                    DVec3::new(cos, sin, 0.4 * draw())
                })
                .collect();
            let hub = DVec3::new(0.3 * draw(), 0.3 * draw(), 0.4 * draw());
            let [old, new] = both(hub, &ring);
            let Some(told) = apart(hub, ring[0], &old, &new, 1e-9, true) else { continue };
            n_told += 1;
            let normal = old.iter().map(|[a, b, c]| (*b - *a).cross(*c - *a)).sum::<DVec3>().normalize();
            // Where a line along the normal meets the triangles.
            let over = |at: DVec3, all: &[[DVec3; 3]]| {
                all.iter().find_map(|[a, b, c]| {
                    let across = (*b - *a).cross(*c - *a);
                    let along = (*a - at).dot(across) / normal.dot(across);
                    let place = at + normal * along;
                    let is_in = [[a, b], [b, c], [c, a]]
                        .iter()
                        .all(|[a, b]| (**b - **a).cross(place - **a).dot(across) >= -1e-12);
                    is_in.then_some(along)
                })
            };
            let mut most = 0.0f64;
            for [a, b, c] in &old {
                for i in 0..=20 {
                    for j in 0..=20 - i {
                        let (s, t) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
                        let at = *a + (*b - *a) * s + (*c - *a) * t;
                        if let Some(along) = over(at, &new) {
                            most = most.max(along.abs());
                        }
                    }
                }
            }
            assert!(most <= told * (1.0 + 1e-9) + 1e-12, "{most} {told}");
            assert!(most >= 0.7 * told - 1e-12, "{most} {told}: it is no more than that");
        }
        assert!(n_told > 50, "{n_told}");
    }
}
