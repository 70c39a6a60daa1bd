//! What the formula of an octant says of it without cells: how deep a point is, how far one is from it, places of it, and how far two are apart.

use glam::DVec3;

use super::space::Space;
use super::tile::Tile;
use crate::numeric::gilbert::gilbert;
use crate::octant::Supersphere;

/// Coordinates in the frame of an octant are wrong by less than this part of what they are summed of.
const ROUNDING: f64 = 1e-14;

/// Halvings of the radius of a ball that is all inside.
const HALVINGS: usize = 12;

/// Steps towards the nearest place of the difference of two octants.
const STEPS: usize = 40;

/// How often one goes from an octant to the other to find where both are.
const TURNS: usize = 6;

/// What is found of how far two are apart is this part of it, where it is sought as well as can be.
const WELL: f64 = 0.98;

/// Shares of the powers on the curved side, of places that may be in another part.
const SHARES: [[f64; 3]; 10] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.5, 0.5, 0.0],
    [0.5, 0.0, 0.5],
    [0.0, 0.5, 0.5],
    [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0],
    [0.8, 0.1, 0.1],
    [0.1, 0.8, 0.1],
    [0.1, 0.1, 0.8],
];

/// An octant and, in its frame, a box round a ball: its middle, half of its sides for a radius of 1, and what rounding adds to these.
struct Ball<'a> {
    octant: &'a Supersphere,
    middle: DVec3,
    radius: DVec3,
    rounding: DVec3,
}

/// The nearest place of the flat sides of an octant to a point in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestFlat {
    pub(super) border: usize,
    pub(super) position: DVec3,
    pub(super) distance: f64,
    /// Whether it is known that no place of the curved side is nearer.
    pub(super) is_nearest: bool,
}

impl Ball<'_> {
    fn corners(&self, radius: f64) -> [DVec3; 2] {
        let half = self.radius * radius + self.rounding;
        [self.middle - half, self.middle + half]
    }

    fn is_held(&self, radius: f64) -> bool {
        let [low, high] = self.corners(radius);
        self.octant.holds_box(low, high)
    }

    fn is_missed(&self, radius: f64) -> bool {
        let [low, high] = self.corners(radius);
        self.octant.misses_box(low, high)
    }
}

impl Space {
    fn ball(&self, at: DVec3) -> Option<Ball<'_>> {
        let (octant, inverse) = (self.octant()?, self.inverse()?);
        let rows = inverse.transpose();
        let radius = DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length());
        let summed = at.abs() + self.placed().shift().abs();
        let rounding = [rows.x_axis, rows.y_axis, rows.z_axis].map(|row| ROUNDING * row.abs().dot(summed));
        let ball = Ball { octant, middle: self.own(at), radius, rounding: DVec3::from_array(rounding) };
        [ball.middle, ball.radius, ball.rounding].iter().all(|vector| vector.is_finite()).then_some(ball)
    }

    /// How deep a point is in an octant at least, where that is more than `enough`: the radius of a ball of which the box in the frame of the octant is all inside. `None` also of what may be deeper, and of what is no octant.
    pub(super) fn depth_by_formula(&self, at: DVec3, enough: f64) -> Option<f64> {
        let ball = self.ball(at)?;
        if !ball.is_held(enough) {
            return None;
        }
        let (mut low, mut high) = (enough, self.size());
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if ball.is_held(middle) { low = middle } else { high = middle }
        }
        Some(low).filter(|depth| *depth > enough)
    }

    /// Of a point in an octant the nearest of the flat sides: straight across each of them there is a place of it, because an octant holds with a point all whose coordinates are less.
    pub(super) fn nearest_flat(&self, at: DVec3) -> Option<NearestFlat> {
        let ball = self.ball(at)?;
        if !ball.octant.holds(ball.middle) {
            return None;
        }
        let away = ball.middle / ball.radius;
        let axis = (0..3).fold(0, |least, axis| if away[axis] < away[least] { axis } else { least });
        let mut foot = ball.middle;
        foot[axis] = 0.0;
        let position = self.placed_point(foot);
        let distance = (position - at).length();
        // Axes are at right angles, so that both are one.
        ((distance - away[axis]).abs() <= 1e-12 * self.size()).then(|| NearestFlat {
            border: axis + 1,
            position,
            distance,
            is_nearest: ball.octant.holds_box(DVec3::ZERO, ball.corners(distance)[1]),
        })
    }

    /// Whether a point is known to be further from an octant than this; false also of what is no octant.
    pub(super) fn is_clear_by_formula(&self, at: DVec3, distance: f64) -> bool {
        self.ball(at).is_some_and(|ball| ball.is_missed(distance))
    }

    /// Whether all of a tile of another part is known to be further from an octant than this, by the box round it in the frame of the octant.
    pub(super) fn is_missed_by_formula(&self, tile: &Tile, distance: f64) -> bool {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for corner in tile.corners {
            let Some(ball) = self.ball(corner) else { return false };
            let [least, most] = ball.corners(tile.deviation + distance);
            (low, high) = (low.min(least), high.max(most));
        }
        self.octant().is_some_and(|octant| octant.misses_box(low, high))
    }

    /// Places of the border of an octant, far from each other; none of what is no octant.
    pub(super) fn places_by_formula(&self) -> impl Iterator<Item = DVec3> {
        let places = self.places.get_or_init(|| {
            let origin = self.octant().map(|_| DVec3::ZERO);
            let curved = self.octant().into_iter().flat_map(|octant| SHARES.map(|shares| octant.shared(shares)));
            origin.into_iter().chain(curved).map(|at| self.placed_point(at)).collect()
        });
        places.iter().copied()
    }

    /// How far places of an octant are in a direction, as seen from the origin of all: it reaches no less.
    fn at_least(&self, direction: DVec3) -> f64 {
        self.places_by_formula().map(|at| at.dot(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// How far an octant reaches in a direction at most, as seen from the origin of all, and where about it.
    fn furthest(&self, octant: &Supersphere, direction: DVec3) -> (f64, DVec3) {
        let (most, at) = octant.reach(self.placed().matrix().transpose() * direction);
        let rounding = ROUNDING * self.bounds.far();
        (most + direction.dot(self.placed().shift()) + rounding, self.placed_point(at))
    }

    /// The same; `None` of what is no octant.
    pub(super) fn reach_by_formula(&self, direction: DVec3) -> Option<(f64, DVec3)> {
        let (most, about) = self.furthest(self.octant()?, direction);
        // What is furthest of the least convex octant about it need not be a place of one that is hollow.
        Some((most, self.place_near(about)?))
    }

    /// A place of an octant near to a point.
    fn place_near(&self, at: DVec3) -> Option<DVec3> {
        Some(self.placed_point(self.octant()?.place_near(self.own(at))))
    }

    /// Where a place of this octant and one of another are no further from each other than this, sought from a point on by going from one to the other.
    fn near_both(&self, other: &Space, from: DVec3, distance: f64) -> Option<DVec3> {
        let mut at = from;
        for _ in 0..TURNS {
            let one = self.place_near(at)?;
            let another = other.place_near(one)?;
            if (one - another).length() <= distance {
                return Some(0.5 * one + 0.5 * another);
            }
            at = another;
        }
        None
    }

    /// The directions across the sides of an octant, of both signs: a plane between it and what touches it is often across one.
    fn across(&self) -> impl Iterator<Item = DVec3> {
        let rows = self.inverse().map(|inverse| inverse.transpose());
        let across = rows.map(|rows| [rows.x_axis, rows.y_axis, rows.z_axis]).into_iter().flatten();
        across.flat_map(|row| [row, -row]).map(DVec3::normalize_or_zero).filter(|row| *row != DVec3::ZERO)
    }

    /// A place at which two octants come as near as the slack, with a plane between them that neither passes by more, across a side of one. `None` also where there may be one, and of what is no octant.
    pub(super) fn contact_by_formula(&self, other: &Space, slack: f64) -> Option<DVec3> {
        // Rounding adds far less to a place.
        let clear = slack + 1e-12 * self.bounds.far().max(other.bounds.far());
        let is_between = |direction: DVec3| {
            // Few are, and of the others it costs little to say so.
            if self.at_least(direction) + other.at_least(-direction) > clear {
                return false;
            }
            let [one, another] = [self.reach_by_formula(direction), other.reach_by_formula(-direction)];
            one.zip(another).is_some_and(|((one, _), (another, _))| one + another <= slack)
        };
        self.across().chain(other.across()).find(|direction| is_between(*direction))?;
        // Where both boxes are, and places of either.
        let common = self.bounds.common(&other.bounds);
        let places = core::iter::once(common.middle()).chain(self.places_by_formula()).chain(other.places_by_formula());
        // Where edges are rounded little both may come so near beside an end of that box alone.
        places.chain(common.corners()).find_map(|at| self.near_both(other, at, slack))
    }

    /// How far two octants are apart at least, where that is more than `slack`; as well as it can be found if `is_well`. `None` also of what may be apart, and of what is no octant. The second number is how many steps it took.
    ///
    /// By [Gilbert's steps](gilbert), each of both octants in the least convex one about it. However far they come, what a plane across them leaves between both is a bound.
    pub(super) fn apart_by_formula(&self, other: &Space, slack: f64, is_well: bool) -> (Option<f64>, u64) {
        let both = [self, other];
        let [Some(one), Some(another)] = both.map(Space::octant) else { return (None, 0) };
        let mut found = None;
        let n_steps = gilbert(self.bounds.middle() - other.bounds.middle(), STEPS, |direction, length| {
            let (near, p) = self.furthest(one, -direction);
            let (far, q) = other.furthest(another, direction);
            let least = -near - far;
            if least > slack && found.is_none_or(|found| least > found) {
                found = Some(least);
            }
            let is_enough = if is_well { least >= WELL * length } else { found.is_some() };
            (!is_enough).then_some(p - q)
        });
        (found, n_steps)
    }
}
