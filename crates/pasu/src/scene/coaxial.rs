//! How two bodies of revolution about one axis meet.
//!
//! What is the same all round is decided in the half plane through the axis, where both are profiles: a place of one is as far from the other in space as its `(|w|, z)` is from the profile. A gap along a whole circle, for which pairs of tiles are many, is one between two curves.
//!
//! Where they are only nearly such, or their axes are only nearly one, as those of a lid that was put on its jar by hand, they are apart by as much as their profiles are, less what their borders are off, and a place is as deep as it is in a profile, less that. Whether they touch is not told then.

use std::collections::BinaryHeap;

use glam::{DVec2, DVec3};

use super::budget::{Budget, Steps};
use super::deep::deep;
use super::open::Open;
use super::section::Section;
use super::shallow::{Shallow, shallow};
use super::space::Space;
use super::stroke::Stroke;

/// What both borders together may be off from what turns about one axis, as a part of the slack, where it is to be told whether they touch.
const OFF: f64 = 1.0 / 32.0;

/// The same at all, as a part of how far each reaches: what is apart by more is soon told without.
const ASIDE: f64 = 1.0 / 8.0;

/// How near to the distance of two what is found of it is, where that is sought.
const WELL: f64 = 0.98;

/// Which part of what all is off is as good as nothing.
const CLOSE: f64 = 1.0 / 8.0;

/// What is found of two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Coaxial {
    /// Their borders are further from each other than the slack: by this at least.
    Apart { least: f64 },
    /// There they come as near as the slack; whether nothing of one is deeper than that in the other.
    Touch { at: DVec3, is_contact: bool },
    /// This place belongs to one and is so deep in the other at least, which is more than the slack.
    Deep { at: DVec3, depth: f64 },
    /// They may come as near as the slack. These places of the first and of the second are where they come nearest, if anywhere.
    Near { places: [[DVec3; 2]; 2] },
}

/// What is asked of two.
#[derive(Debug, Clone, Copy)]
pub(super) struct Question {
    pub(super) slack: f64,
    /// Whether all that matters is where they touch.
    pub(super) is_touch_enough: bool,
    /// Whether it matters how far they are apart.
    pub(super) is_distance_sought: bool,
    /// The most work, in pairs of tiles.
    pub(super) most: u64,
}

/// Where the borders of two come nearest.
enum Near {
    Apart(f64),
    Touch(DVec2),
    /// Nearer than they could be known to be apart, at these strokes.
    Close(Box<[Stroke; 2]>),
    Unknown,
}

impl Space {
    /// How this part meets another, if both are nearly bodies of revolution about one axis and it can be told; and whether more work might tell. Unless they are that to within a small part of the slack, it is not told that they touch.
    pub(super) fn coaxial(&self, other: &Space, question: Question, budget: &mut Budget) -> (Option<Coaxial>, bool) {
        let Some((mut sections, off, aside)) = self.sections(other) else { return (None, false) };
        let way = aside.try_normalize();
        let mut steps = Steps::of(budget, question.most);
        match met(&mut sections, off, question, &mut steps) {
            Some((found, at)) => {
                let lifted = |place: DVec2| self.meridian().map_or(DVec3::ZERO, |meridian| meridian.lifted(place));
                let touch = |is_contact| at.map(|at| Coaxial::Touch { at: lifted(at), is_contact });
                let found = match found {
                    Found::Apart(least) => Some(Coaxial::Apart { least }),
                    Found::Touch => touch(false),
                    Found::Contact => touch(true),
                    Found::Deep { at, depth } => Some(Coaxial::Deep { at, depth }),
                    Found::Close(strokes) => way.map(|way| {
                        let places = [0, 1].map(|part| {
                            [way, -way].map(|direction| sections[part].place_towards(&strokes[part], direction))
                        });
                        Coaxial::Near { places }
                    }),
                    Found::Nothing => None,
                };
                (found, false)
            }
            None => (None, true),
        }
    }

    /// Both in the half plane through the axis of the first, how far the borders may be off from these in all, and where the axis of the other is beside that of the first. `None` where all is off by more than an eighth of how far either reaches.
    fn sections<'a>(&'a self, other: &'a Space) -> Option<([Section<'a>; 2], f64, DVec3)> {
        let (one, another) = (self.meridian()?, other.meridian()?);
        let sense = if one.axis.dot(another.axis) < 0.0 { -1.0 } else { 1.0 };
        let way = another.origin - one.origin;
        let rise = way.dot(one.axis);
        let aside = way - one.axis * rise;
        // By how much the other has to be moved and turned until its axis is that of the first.
        let moved = aside.length() + one.axis.cross(another.axis).length() * another.reach;
        let off = one.off + another.off + moved;
        if !(off <= ASIDE * one.reach.min(another.reach)) {
            return None;
        }
        Some(([Section::of(self, 1.0, 0.0)?, Section::of(other, sense, rise)?], off, aside))
    }
}

enum Found {
    Apart(f64),
    Close(Box<[Stroke; 2]>),
    Touch,
    Contact,
    Deep { at: DVec3, depth: f64 },
    Nothing,
}

/// What is found, and where they touch; `None` where work is at its end.
fn met(sections: &mut [Section; 2], off: f64, question: Question, steps: &mut Steps) -> Option<(Found, Option<DVec2>)> {
    let slack = question.slack;
    let at = match nearest(sections, off, question, steps)? {
        Near::Apart(least) => return Some((Found::Apart(least), None)),
        Near::Close(_) if question.is_touch_enough => return Some((Found::Nothing, None)),
        Near::Close(strokes) => {
            let deep = deep(sections, slack, off, steps)?;
            return Some((deep.map_or(Found::Close(strokes), |(at, depth)| Found::Deep { at, depth }), None));
        }
        Near::Unknown => return Some((Found::Nothing, None)),
        Near::Touch(at) => at,
    };
    if question.is_touch_enough {
        return Some((Found::Touch, Some(at)));
    }
    if is_level(sections, slack - off, steps)? {
        return Some((Found::Contact, Some(at)));
    }
    let found = match shallow(sections, slack, off, steps)? {
        Shallow::Yes => Found::Contact,
        Shallow::No { at, depth } => Found::Deep { at, depth },
        Shallow::Unknown => Found::Nothing,
    };
    Some((found, Some(at)))
}

/// Where two come nearest: the pair of stretches that may be nearest first, and of those that may be as near the smallest, so that what touches is soon known to.
fn nearest(sections: &mut [Section; 2], off: f64, question: Question, steps: &mut Steps) -> Option<Near> {
    let slack = question.slack;
    let of = [sections[0].root(), sections[1].root()];
    let mut open = BinaryHeap::from([Open { least: 0.0, rank: f64::NEG_INFINITY, of }]);
    let is_coaxial = off <= OFF * slack;
    // No two are further from each other than this.
    let (mut most, mut closest) = (f64::INFINITY, None);
    while let Some(Open { least, of, .. }) = open.pop() {
        steps.take(1)?;
        if least - off > slack && (!question.is_distance_sought || least >= WELL * most) {
            return Some(Near::Apart(least - off));
        }
        let both = [*sections[0].stretch(of[0]), *sections[1].stretch(of[1])];
        if let [Some(one), Some(other)] = both.map(|stretch| stretch.stroke) {
            let [p, q] = one.chord.between(&other.chord);
            let further = (p - q).length() + one.deviation + other.deviation;
            if is_coaxial && further + off <= slack {
                return Some(Near::Touch(0.5 * p + 0.5 * q));
            }
            if further < most {
                (most, closest) = (further, Some([one, other]));
            }
            if !is_coaxial
                && most - off <= slack
                && (least >= WELL * most || most <= CLOSE * off.max(slack))
                && let Some(closest) = closest
            {
                return Some(Near::Close(Box::new(closest)));
            }
            if both.iter().all(|stretch| stretch.size() <= 0.25 * slack) && least - off <= slack {
                return Some(Near::Unknown);
            }
        }
        let larger = usize::from(both[1].size() > both[0].size());
        let mut halved = None;
        for part in [larger, 1 - larger] {
            if let Some(halves) = sections[part].halves(of[part], steps)? {
                halved = Some((part, halves));
                break;
            }
        }
        let Some((part, halves)) = halved else { return Some(Near::Unknown) };
        for half in halves {
            let mut next = of;
            next[part] = half;
            let both = [*sections[0].stretch(next[0]), *sections[1].stretch(next[1])];
            let away = match both.map(|stretch| stretch.stroke) {
                [Some(one), Some(other)] => one.chord.distance(&other.chord) - one.deviation - other.deviation,
                _ => both[0].away(&both[1]),
            };
            let size = both[0].size().max(both[1].size());
            open.push(Open { least: away.max(least), rank: -size, of: next });
        }
    }
    Some(Near::Unknown)
}

/// Whether a plane across the axis is between two, which neither passes by more than the slack.
fn is_level(sections: &mut [Section; 2], slack: f64, steps: &mut Steps) -> Option<bool> {
    for [below, above] in [[0, 1], [1, 0]] {
        let (lower, upper) =
            (sections[below].stretch(sections[below].root()), sections[above].stretch(sections[above].root()));
        // Most are told by their boxes.
        if lower.high.y - upper.low.y > 0.5 * (lower.high.y - lower.low.y).min(upper.high.y - upper.low.y) {
            continue;
        }
        let highest = sections[below].reach(true, 0.125 * slack, steps)?;
        let lowest = sections[above].reach(false, 0.125 * slack, steps)?;
        if highest - lowest <= slack {
            return Some(true);
        }
    }
    Some(false)
}
