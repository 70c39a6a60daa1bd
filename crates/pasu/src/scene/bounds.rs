//! A box along the axes.

use glam::{BVec3, DVec3};

/// What lies between two corners, borders included; nothing where one coordinate is the wrong way round.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounds {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

impl Bounds {
    pub(super) const NOTHING: Bounds = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// Round these points.
    pub(super) fn of(points: &[DVec3]) -> Bounds {
        points.iter().fold(Bounds::NOTHING, |bounds, point| bounds.with(Bounds { low: *point, high: *point }))
    }

    /// The box round both.
    pub(super) fn with(self, other: Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The box in both, the wrong way round along axes along which they do not meet.
    pub(super) fn common(&self, other: &Bounds) -> Bounds {
        Bounds { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// Its eight corners.
    pub(super) fn corners(&self) -> [DVec3; 8] {
        core::array::from_fn(|i| DVec3::select(BVec3::new(i & 1 == 1, i & 2 == 2, i & 4 == 4), self.high, self.low))
    }

    /// The largest coordinate of it, whatever its sign.
    pub(super) fn far(&self) -> f64 {
        self.low.abs().max(self.high.abs()).max_element()
    }

    /// Wider by so much on every side.
    pub(super) fn wider(self, by: f64) -> Bounds {
        Bounds { low: self.low - by, high: self.high + by }
    }

    pub(super) fn middle(&self) -> DVec3 {
        0.5 * self.low + 0.5 * self.high
    }

    /// From corner to corner.
    pub(super) fn size(&self) -> f64 {
        (self.high - self.low).length()
    }

    pub(super) fn holds(&self, point: DVec3) -> bool {
        point.cmpge(self.low).all() && point.cmple(self.high).all()
    }

    /// How far a point is from it; 0 inside.
    pub(super) fn distance_to(&self, point: DVec3) -> f64 {
        (self.low - point).max(point - self.high).max(DVec3::ZERO).length()
    }

    /// How far two boxes are apart; 0 where they touch.
    pub(super) fn distance(&self, other: &Bounds) -> f64 {
        (self.low - other.high).max(other.low - self.high).max(DVec3::ZERO).length()
    }

    /// Whether a ray from its origin on meets it. The direction is given by what its components are divided into 1.
    pub(super) fn is_met(&self, origin: DVec3, inverse: DVec3) -> bool {
        let (mut from, mut to) = (0.0f64, f64::INFINITY);
        for axis in 0..3 {
            if inverse[axis].is_infinite() {
                if !(self.low[axis] <= origin[axis] && origin[axis] <= self.high[axis]) {
                    return false;
                }
                continue;
            }
            let [one, other] = [self.low, self.high].map(|side| (side[axis] - origin[axis]) * inverse[axis]);
            from = from.max(one.min(other));
            to = to.min(one.max(other));
        }
        // A box is round more than what is in it, by far less than this.
        from <= to * (1.0 + 1e-14)
    }
}
