//! Whether nothing of two bodies of revolution is deep in the other.
//!
//! Two bodies that touch along circles, as a lid in its groove, have no plane between them. That they do not interfere is proved by what lies *beneath* each border instead.
//!
//! Let `t = 15/16` of the slack, and let `A` and `B` be bodies in the half plane (what follows holds as well of what these are turned into). Every stroke of the border of `A` gets a *probe*: all that is no further than a radius `R` from a segment. It covers the stroke if
//!
//! 1. no place of the stroke is further from the probe than some `s < t`, and
//! 2. wherever a disc of radius `t` within `A` touches the border on this stroke, the probe holds its middle.
//!
//! A probe is *clear* of `B` if the border of `B` is nowhere in it, and one place of it is not in `B`: then none is.
//!
//! **If all strokes of both are covered by probes that are clear of the other body, no place of `A` and `B` is deeper than `t` in either.** By (1) and the clear probes of `A`, every place of its border is outside of `B` or no deeper in it than `s`. Suppose that `p` is in both
//! and deeper than `t` in `B`. All that is deeper than `s` in `B` and hangs together with `p` is then met by no border of `A`, and so is in `A` with `p`. Let `q` be the place of the border of `B` that is nearest to `p`. The disc round `p` that touches the border in `q` is within `B`, and so is the one of radius `t`
//! that touches it there, whose middle `m` is between `q` and `p`. All between `m` and `p` is no less than `t` deep, so that `m` hangs together with `p` and is in `A`. But by (2) `m` is in the probe of the stroke on which `q` is, of which nothing is in `A`. The same holds with `A` and `B` exchanged. A cell that is partly deep is therefore
//! one whose probe is not clear, however it is cut.
//!
//! The probe of a stroke that is far from the other body is all that is no further than `t` from it, and needs to know nothing of it. That of one that is near runs along its chord, `17/32` of the slack beneath it, with a radius of `13/32`: what is between an eighth of the slack and `t` deep. A border that runs along that of the other body, or goes into it by less
//! than an eighth of the slack, so is clear of it. How far the stroke is from its chord, and its normals from that of the chord, is added to the radius.
//!
//! **Corners.** Where the border turns towards the body by more than 20°, no disc of radius `t` touches it near to the corner: those that touch one of its sides there would go through the other. So the segment ends where that beneath the other side begins, at `17/32` of the slack times the tangent of half of the turn from the end; of turns up to 132° (1) holds all the
//! same. Where it turns away from the body, discs touch it in the corner itself, from all directions between the two normals, which have probes of their own.

use glam::{DVec2, DVec3};

use super::budget::Steps;
use super::section::{Corner, Section};
use super::segment::Segment;
use super::stroke::Stroke;

/// Parts of the slack: how deep nothing is where it is proved, how far beneath a stroke its probe is, and the radius of that.
const DEEP: f64 = 15.0 / 16.0;
const BENEATH: f64 = 17.0 / 32.0;
const RADIUS: f64 = 13.0 / 32.0;

/// How far a stroke is from its chord at most, as a part of the slack, and by which angle it turns, that has a probe beneath it.
const FINE: f64 = 1.0 / 128.0;
const SLANT: f64 = 1.0 / 32.0;

/// The same of the strokes against which it is held,
const FINE_OTHER: f64 = 1.0 / 256.0;

/// and of those beside a corner, which are at least so long.
const FINE_CORNER: f64 = 1.0 / 512.0;
const SLANT_CORNER: f64 = 1.0 / 256.0;
const LONG: f64 = 4.0;

/// From which turn on a corner is one to which nothing beneath is near, and up to which places in the corner are near to what is beneath; in radians.
const TURN: f64 = 20.0 / 180.0 * core::f64::consts::PI;
const SHARPEST: f64 = 132.0 / 180.0 * core::f64::consts::PI;

/// Arcs round a corner are cut into pieces of no more than this angle.
const ARC: f64 = 0.5;

/// The most places that are asked for how deep they are.
const MOST_ASKED: usize = 256;

/// What is found.
pub(super) enum Shallow {
    Yes,
    /// This place of one is so deep in the other.
    No {
        at: DVec3,
        depth: f64,
    },
    Unknown,
}

/// Whether no place of two whose borders touch is deeper in the other than the slack, with both borders so far off in all; `None` where work is at its end.
pub(super) fn shallow(sections: &mut [Section; 2], slack: f64, off: f64, steps: &mut Steps) -> Option<Shallow> {
    let mut is_known = true;
    for part in 0..2 {
        let [one, other] = sections;
        let (of, against) = if part == 0 { (one, other) } else { (other, one) };
        // Where the other has no inside nothing is in it; that no place of it is in this one is told by its own probes.
        if against.inside == 0.0 {
            continue;
        }
        // Beneath a surface without an inside is either side of it.
        let sides = if of.inside == 0.0 { vec![1.0, -1.0] } else { vec![of.inside] };
        let mut is_shallow = false;
        for side in sides {
            let mut probe = Probe { of: &mut *of, against: &mut *against, side, slack, off, n_asked: 0 };
            match probe.all(steps)? {
                Shallow::Yes => {
                    is_shallow = true;
                    break;
                }
                no @ Shallow::No { .. } => return Some(no),
                Shallow::Unknown => {}
            }
        }
        is_known &= is_shallow;
    }
    Some(if is_known { Shallow::Yes } else { Shallow::Unknown })
}

/// The probes of one body, against the other.
struct Probe<'a, 'b> {
    of: &'a mut Section<'b>,
    against: &'a mut Section<'b>,
    /// On which side of its border what is beneath it is: 1 for the left, -1 for the right.
    side: f64,
    slack: f64,
    off: f64,
    n_asked: usize,
}

impl Probe<'_, '_> {
    fn all(&mut self, steps: &mut Steps) -> Option<Shallow> {
        let mut open = vec![self.of.root()];
        // Whether all that was looked at is shallow. Where it is not, as beside where one border crosses the other, what is deep is still to be found.
        let mut is_known = true;
        while let Some(index) = open.pop() {
            let stretch = *self.of.stretch(index);
            let far = DEEP * self.slack + self.off;
            if self.against.is_far(&stretch, far, steps)? && self.against.is_without(stretch.start, self.off, steps)? {
                continue;
            }
            if let Some(stroke) = stretch.stroke {
                let round = (stroke.chord, DEEP * self.slack + stroke.deviation);
                if self.is_clear(round, steps)? {
                    continue;
                }
                let is_fine = stroke.deviation <= FINE * self.slack && stroke.slant() <= SLANT;
                if is_fine
                    && let Some(beneath) = self.beneath(&stroke, steps)?
                    && self.is_clear(beneath, steps)?
                {
                    continue;
                }
                if let Some((at, depth)) = self.deep(&stroke, steps)? {
                    return Some(Shallow::No { at, depth });
                }
                if self.n_asked >= MOST_ASKED {
                    return Some(Shallow::Unknown);
                }
                if is_fine && stroke.chord.length() <= 2.0 * LONG * self.slack {
                    is_known = false;
                    continue;
                }
            }
            match self.of.halves(index, steps)? {
                Some([first, second]) => open.extend([second, first]),
                None => is_known = false,
            }
        }
        // What has no inside has no disc in it.
        if self.of.inside != 0.0 {
            for joint in 0..self.of.joints().len() {
                is_known = is_known && self.is_round(joint, steps)?;
            }
        }
        Some(if is_known { Shallow::Yes } else { Shallow::Unknown })
    }

    /// Whether a probe is clear of the other body.
    fn is_clear(&mut self, (segment, radius): (Segment, f64), steps: &mut Steps) -> Option<bool> {
        let fine = FINE_OTHER * self.slack;
        if !self.against.is_clear(&segment, radius + self.off, fine, steps)? {
            return Some(false);
        }
        self.against.is_without(segment.0[0], self.off, steps)
    }

    /// Towards what is beneath, square to a direction.
    fn inwards(&self, direction: DVec2) -> DVec2 {
        direction.perp() * self.side
    }

    fn corner(&mut self, joint: usize, steps: &mut Steps) -> Option<Option<Corner>> {
        self.of.corner(joint, [FINE_CORNER * self.slack, SLANT_CORNER, LONG * self.slack], steps)
    }

    /// The probe beneath a stroke that is all but straight; none where it has one corner that is too sharp.
    fn beneath(&mut self, stroke: &Stroke, steps: &mut Steps) -> Option<Option<(Segment, f64)>> {
        let (slack, length) = (self.slack, stroke.chord.length());
        let along = stroke.chord.along() / length;
        let mut shorter = [0.0; 2];
        for (end, joint) in stroke.joints.into_iter().enumerate() {
            let Some(joint) = joint else { continue };
            let Some(corner) = self.corner(joint, steps)? else { return Some(None) };
            let turn = corner.turn * self.side;
            if turn > SHARPEST || (turn > TURN && length < LONG * slack) {
                return Some(None);
            }
            if turn > TURN {
                shorter[end] = BENEATH * slack * libm::tan(0.5 * turn);
            }
        }
        let [a, b] = stroke.chord.0;
        let down = self.inwards(along) * (BENEATH * slack);
        let segment = Segment([a + along * shorter[0] + down, b - along * shorter[1] + down]);
        // An arc is longer than its chord by less than a tenth.
        let radius = RADIUS * slack + stroke.deviation + 1.1 * DEEP * slack * stroke.slant();
        Some(Some((segment, radius)))
    }

    /// Whether discs that touch the border in a corner, if there can be any, have their middles outside of the other body.
    fn is_round(&mut self, joint: usize, steps: &mut Steps) -> Option<bool> {
        let slack = self.slack;
        // Of what is far from it nothing has to be known.
        let of = self.of.joints()[joint];
        let at = self.of.place_of(of);
        if self.is_clear((Segment([at; 2]), DEEP * slack + self.off), steps)? {
            return Some(true);
        }
        let Some(corner) = self.corner(joint, steps)? else { return Some(false) };
        let turn = corner.turn * self.side;
        let error = 2.2 * corner.slant;
        if turn > error {
            return Some(true);
        }
        let normals = corner.directions.map(|direction| self.inwards(direction));
        let n_pieces = libm::ceil(turn.abs() / ARC).max(1.0);
        let step = turn.abs() / n_pieces;
        let flat = BENEATH * slack * (1.0 - libm::cos(0.5 * step));
        let radius = RADIUS * slack + flat + corner.deviation + 1.1 * DEEP * slack * corner.slant;
        let by = |share: f64| {
            let angle = corner.turn * share;
            corner.at + DVec2::from_angle(angle).rotate(normals[0]) * (BENEATH * slack)
        };
        for i in 0..n_pieces as usize {
            let segment = Segment([by(i as f64 / n_pieces), by((i + 1) as f64 / n_pieces)]);
            if !self.is_clear((segment, radius), steps)? {
                return Some(false);
            }
        }
        Some(true)
    }

    /// A place of a stroke that is deeper in the other body than the slack.
    fn deep(&mut self, stroke: &Stroke, steps: &mut Steps) -> Option<Option<(DVec3, f64)>> {
        let [from, to] = stroke.t;
        let places = [(0.5 * from + 0.5 * to, stroke.inner[1]), (from, stroke.chord.0[0]), (to, stroke.chord.0[1])];
        for (t, at) in places {
            self.n_asked += 1;
            if let Some(depth) = self.against.depth(at, self.off, self.slack, steps)? {
                return Some(Some((self.of.place(stroke, t), depth)));
            }
        }
        Some(None)
    }
}
