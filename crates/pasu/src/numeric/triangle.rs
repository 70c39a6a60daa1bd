//! How far triangles are from points and from each other.

use glam::DVec3;

/// Three corners, of which some may be the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Triangle(pub(crate) [DVec3; 3]);

impl Triangle {
    /// Its point that is nearest to another: by the regions of its corners, sides and inside (C. Ericson, *Real-Time Collision Detection*, 2005, section 5.1.5). One without area is as good as its sides.
    pub(crate) fn nearest(&self, point: DVec3) -> DVec3 {
        let [a, b, c] = self.0;
        if let Some(normal) = self.normal() {
            // Inside of all three sides.
            let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| (to - from).cross(point - from).dot(normal));
            if sides.iter().all(|side| *side >= 0.0) {
                let unit = normal.normalize_or_zero();
                return point - unit * unit.dot(point - a);
            }
        }
        let on_sides = [(a, b), (b, c), (c, a)].map(|(from, to)| on_segment(from, to, point));
        nearest_of(&on_sides, point)
    }

    /// A point of each, as near to each other as any two; the same one where they meet.
    pub(crate) fn between(&self, other: &Triangle) -> [DVec3; 2] {
        if let Some(at) = self.pierced(other).or_else(|| other.pierced(self)) {
            return [at, at];
        }
        let mut best = [self.0[0], other.0[0]];
        let mut least = f64::INFINITY;
        let mut look = |one: DVec3, other: DVec3| {
            let distance = (one - other).length_squared();
            if distance < least {
                (best, least) = ([one, other], distance);
            }
        };
        for corner in self.0 {
            look(corner, other.nearest(corner));
        }
        for corner in other.0 {
            look(self.nearest(corner), corner);
        }
        for (i, j) in SIDES {
            for (k, l) in SIDES {
                let [one, another] = between_segments([self.0[i], self.0[j]], [other.0[k], other.0[l]]);
                look(one, another);
            }
        }
        best
    }

    /// Across it; `None` where its corners are in one line, to rounding.
    fn normal(&self) -> Option<DVec3> {
        let [a, b, c] = self.0;
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(ac);
        (normal.length() > FLAT * ab.length() * ac.length().max((c - b).length())).then_some(normal)
    }

    /// Where a side of another goes through its inside.
    pub(crate) fn pierced(&self, other: &Triangle) -> Option<DVec3> {
        let [a, b, c] = self.0;
        let normal = self.normal()?;
        SIDES.into_iter().find_map(|(i, j)| {
            let (from, to) = (other.0[i], other.0[j]);
            let (below, above) = (normal.dot(from - a), normal.dot(to - a));
            if !(below * above < 0.0) {
                return None;
            }
            let at = from + (to - from) * (below / (below - above));
            let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| (to - from).cross(at - from).dot(normal));
            sides.iter().all(|side| *side >= 0.0).then_some(at)
        })
    }
}

/// A triangle no higher than this part of its length is a line.
const FLAT: f64 = 1e-13;

const SIDES: [(usize, usize); 3] = [(0, 1), (1, 2), (2, 0)];

fn on_segment(from: DVec3, to: DVec3, point: DVec3) -> DVec3 {
    let along = to - from;
    let square = along.length_squared();
    let share = if square > 0.0 { ((point - from).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
    from + along * share
}

fn nearest_of(points: &[DVec3; 3], to: DVec3) -> DVec3 {
    let nearer = |best: DVec3, next: &DVec3| {
        if (*next - to).length_squared() < (best - to).length_squared() { *next } else { best }
    };
    points.iter().fold(points[0], nearer)
}

/// The points of two segments that are as near to each other as any two (Ericson, section 5.1.9).
fn between_segments([p, q]: [DVec3; 2], [r, s]: [DVec3; 2]) -> [DVec3; 2] {
    let (along, other, apart) = (q - p, s - r, p - r);
    let (a, e, f) = (along.length_squared(), other.length_squared(), other.dot(apart));
    let (b, c) = (along.dot(other), along.dot(apart));
    let denominator = a * e - b * b;
    let mut share = if denominator > 0.0 { ((b * f - c * e) / denominator).clamp(0.0, 1.0) } else { 0.0 };
    let mut across = if e > 0.0 { (b * share + f) / e } else { 0.0 };
    if across < 0.0 {
        across = 0.0;
        share = if a > 0.0 { (-c / a).clamp(0.0, 1.0) } else { 0.0 };
    } else if across > 1.0 {
        across = 1.0;
        share = if a > 0.0 { ((b - c) / a).clamp(0.0, 1.0) } else { 0.0 };
    }
    [p + along * share, r + other * across]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dice(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1u64 << 53) as f64
    }

    fn points(triangle: &Triangle) -> Vec<DVec3> {
        let n = 24;
        let [a, b, c] = triangle.0;
        let of = |i: i32, j: i32| a + (b - a) * (f64::from(i) / f64::from(n)) + (c - a) * (f64::from(j) / f64::from(n));
        (0..=n).flat_map(|i| (0..=n - i).map(move |j| of(i, j))).collect()
    }

    /// Nothing that is sampled is nearer, and what is found is hardly nearer than what is sampled.
    #[test]
    fn nothing_is_nearer_than_what_is_found() {
        let mut seed = 3;
        for round in 0..300 {
            let mut point = || DVec3::new(dice(&mut seed), dice(&mut seed), dice(&mut seed));
            let mut triangle = || Triangle([point(), point(), point()]);
            let (one, mut other) = (triangle(), triangle());
            if round % 3 == 0 {
                // Without area, or with a corner twice.
                other.0[2] = if round % 2 == 0 { other.0[1] } else { other.0[0] * 0.5 + other.0[1] * 0.5 };
            }
            let [p, q] = one.between(&other);
            assert!((one.nearest(p) - p).length() < 1e-12 && (other.nearest(q) - q).length() < 1e-12);
            let sampled = points(&one).into_iter().map(|p| (other.nearest(p) - p).length()).fold(9.0, f64::min);
            let found = (p - q).length();
            assert!(found <= sampled + 1e-12 && sampled <= found + 0.06, "{one:?} {other:?} {found} {sampled}");
            let at = point();
            let sampled = points(&other).into_iter().map(|p| (p - at).length()).fold(9.0, f64::min);
            let found = (other.nearest(at) - at).length();
            assert!(found <= sampled + 1e-12 && sampled <= found + 0.06, "{other:?} {at} {found} {sampled}");
        }
    }
}
