//! A section by the angle at which its points are seen from the axis.

use core::f64::consts::TAU;

use glam::DVec2;

use crate::patch::{Patch, Row, SurfaceJet};

/// Points by which a section is followed round the axis, for each wave and at least.
const POINTS_PER_WAVE: f64 = 24.0;
const LEAST_POINTS: f64 = 96.0;

/// A pole is no larger than this part of the size.
const POINT: f64 = 1e-9;

/// A curve of constant `u` that goes round the axis once, always onwards or always back.
pub(super) struct Azimuth<'a> {
    row: Box<dyn Row + 'a>,
    /// What of it goes round: its points, or at a pole the ways out of that.
    round: Round,
    /// Angle and `v`, in ascending angles, from some angle to a turn beyond it.
    followed: Vec<(f64, f64)>,
}

/// Steps of Newton's method at most; from where it begins it takes three or four.
const MOST_STEPS: usize = 12;

/// A step of this part of a turn is rounding.
const SHORTEST: f64 = 1e-15;

#[derive(Clone, Copy, PartialEq)]
enum Round {
    Points,
    WaysOn,
    WaysBack,
}

impl Round {
    fn of(self, jet: &SurfaceJet) -> DVec2 {
        match self {
            Round::Points => jet.position.truncate(),
            Round::WaysOn => jet.du.truncate(),
            Round::WaysBack => -jet.du.truncate(),
        }
    }

    /// Its derivative round the axis.
    fn turned(self, jet: &SurfaceJet) -> DVec2 {
        match self {
            Round::Points => jet.dv.truncate(),
            Round::WaysOn => jet.duv.truncate(),
            Round::WaysBack => -jet.duv.truncate(),
        }
    }
}

impl<'a> Azimuth<'a> {
    /// The section at `u` of a patch of some size with so many waves; nothing where it does not go once round the axis.
    pub(super) fn of(patch: &'a impl Patch, u: f64, size: f64, waves: f64) -> Option<Azimuth<'a>> {
        let row = patch.row(u);
        let n = (POINTS_PER_WAVE * waves).max(LEAST_POINTS) as usize;
        let jets: Vec<SurfaceJet> = (0..=n).map(|i| row.jet(i as f64 / n as f64)).collect();
        let is_pole = jets.iter().all(|jet| jet.position.truncate().length() <= POINT * size);
        let round = match is_pole {
            false => Round::Points,
            true if u < 0.5 => Round::WaysOn,
            true => Round::WaysBack,
        };
        let mut followed = Vec::with_capacity(n + 1);
        let mut before: Option<(DVec2, f64)> = None;
        for (i, jet) in jets.iter().enumerate() {
            let (v, point) = (i as f64 / n as f64, round.of(jet));
            let angle = match before {
                None => libm::atan2(point.y, point.x),
                Some((last, angle)) => angle + libm::atan2(last.perp_dot(point), last.dot(point)),
            };
            followed.push((angle, v));
            before = Some((point, angle));
        }
        let turn = followed[n].0 - followed[0].0;
        if turn < 0.0 {
            followed.reverse();
        }
        let is_onwards = followed.windows(2).all(|pair| pair[0].0 < pair[1].0);
        (is_onwards && (turn.abs() - TAU).abs() < 1e-6).then_some(Azimuth { row, round, followed })
    }

    /// Whether it is a point on the axis.
    pub(super) fn is_pole(&self) -> bool {
        self.round != Round::Points
    }

    /// Position and derivatives where the section meets the ray at an angle: by Newton's method from between the two points that were followed on either side of it.
    pub(super) fn at(&self, angle: f64) -> SurfaceJet {
        let first = self.followed[0].0;
        let angle = first + (angle - first).rem_euclid(TAU);
        let next = self.followed.partition_point(|(known, _)| *known <= angle).clamp(1, self.followed.len() - 1);
        let [from, to] = [self.followed[next - 1], self.followed[next]];
        let (on, length) = (onwards(angle), self.row.length());
        let mut v = from.1 + (to.1 - from.1) * (angle - from.0) / (to.0 - from.0);
        let mut jet = self.row.jet(v);
        for _ in 0..MOST_STEPS {
            let (off, slope) = (on.dot(self.round.of(&jet)), on.dot(self.round.turned(&jet)) * length);
            let step = -off / slope;
            // Next to where the section turns back the slope says little: what was followed is the better guess.
            if !(step.abs() <= (to.1 - from.1).abs()) {
                break;
            }
            v += step;
            jet = self.row.jet(v);
            if step.abs() <= SHORTEST {
                break;
            }
        }
        jet
    }
}

/// The direction in which angles grow.
pub(super) fn onwards(angle: f64) -> DVec2 {
    DVec2::new(-libm::sin(angle), libm::cos(angle))
}

/// The direction away from the axis.
pub(super) fn outwards(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}
