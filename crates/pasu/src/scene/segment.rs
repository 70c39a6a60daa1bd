//! How far segments are from points and from each other, in a plane through an axis.
//!
//! A place of the plane is `(w, z)`: `|w|` from the axis and `z` along it. As parts of a body of revolution `(w, z)` and `(-w, z)` are one.

use glam::DVec2;

/// From one end to the other, which may be the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Segment(pub(super) [DVec2; 2]);

impl Segment {
    pub(super) fn length(&self) -> f64 {
        self.along().length()
    }

    pub(super) fn along(&self) -> DVec2 {
        self.0[1] - self.0[0]
    }

    /// Its place that is nearest to a point, on one side of the axis.
    fn nearest(&self, point: DVec2) -> DVec2 {
        let along = self.along();
        let square = along.length_squared();
        let share = if square > 0.0 { ((point - self.0[0]).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        self.0[0] + along * share
    }

    /// A place of each, as near to each other as any two, seen on the side of the axis on which `w` is not negative; the same one where they cross.
    pub(super) fn between(&self, other: &Segment) -> [DVec2; 2] {
        let best = self.between_as_drawn(other);
        let is_beyond = |segment: &Segment| segment.0.iter().any(|end| end.x < 0.0);
        if !is_beyond(self) && !is_beyond(other) {
            return best;
        }
        let mirrored = self.between_as_drawn(&Segment(other.0.map(folded)));
        let nearer = if length_squared(mirrored) < length_squared(best) { mirrored } else { best };
        nearer.map(|place| DVec2::new(place.x.abs(), place.y))
    }

    pub(super) fn distance(&self, other: &Segment) -> f64 {
        let [one, another] = self.between(other);
        (one - another).length()
    }

    fn between_as_drawn(&self, other: &Segment) -> [DVec2; 2] {
        if let Some(at) = self.crossing(other) {
            return [at, at];
        }
        let [a, b] = self.0;
        let [c, d] = other.0;
        let pairs = [[a, other.nearest(a)], [b, other.nearest(b)], [self.nearest(c), c], [self.nearest(d), d]];
        pairs
            .into_iter()
            .fold(pairs[0], |best, next| if length_squared(next) < length_squared(best) { next } else { best })
    }

    /// Where two go through each other. Rounding tells it wrongly only of those of which an end is as near to the other as that.
    fn crossing(&self, other: &Segment) -> Option<DVec2> {
        let [a, b] = self.0;
        let [c, d] = other.0;
        let side = |from: DVec2, to: DVec2, of: DVec2| (to - from).perp_dot(of - from);
        let (p, q) = (side(a, b, c), side(a, b, d));
        let (r, s) = (side(c, d, a), side(c, d, b));
        (p * q < 0.0 && r * s < 0.0).then(|| a + (b - a) * (r / (r - s)))
    }
}

fn folded(place: DVec2) -> DVec2 {
    DVec2::new(-place.x, place.y)
}

fn length_squared([one, other]: [DVec2; 2]) -> f64 {
    (one - other).length_squared()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_nearer_than_what_is_found() {
        let mut seed = 5u64;
        let mut dice = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.3
        };
        for round in 0..400 {
            let mut segment = || Segment([DVec2::new(dice(), dice()), DVec2::new(dice(), dice())]);
            let (one, mut other) = (segment(), segment());
            if round % 5 == 0 {
                other.0[1] = other.0[0];
            }
            let of = |segment: &Segment, i: i32| segment.0[0] + segment.along() * (f64::from(i) / 200.0);
            let folded = |place: DVec2| DVec2::new(place.x.abs(), place.y);
            let away = |i: i32, j: i32| (folded(of(&one, i)) - folded(of(&other, j))).length();
            let sampled = (0..=200).flat_map(|i| (0..=200).map(move |j| (i, j))).map(|(i, j)| away(i, j));
            let (sampled, found) = (sampled.fold(9.0, f64::min), one.distance(&other));
            assert!(found <= sampled + 1e-12 && sampled <= found + 0.02, "{one:?} {other:?} {found} {sampled}");
        }
    }
}
