//! The section of a body of revolution with the half plane of two such bodies, cut as finely as it is asked for.

use std::collections::BinaryHeap;

use glam::{DVec2, DVec3};

use super::border::Border;
use super::budget::Steps;
use super::meridian::{Joint, Meridian};
use super::open::Open;
use super::segment::Segment;
use super::space::Space;
use super::stroke::Stroke;

/// What it takes to halve a stroke, in steps: places of the surface are found for it.
const HALVED: u64 = 24;

/// How near to the distance of a point from a section what is found of it is.
const WELL: f64 = 0.9;

/// A stretch of a meridian: a stroke, or what follows on from each other of several.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    /// A box round it.
    pub(super) low: DVec2,
    pub(super) high: DVec2,
    /// Where it begins.
    pub(super) start: DVec2,
    pub(super) stroke: Option<Stroke>,
    halves: Option<[usize; 2]>,
}

impl Stretch {
    fn of(stroke: Stroke) -> Stretch {
        let [a, b] = stroke.chord.0;
        let (low, high) = (a.min(b) - stroke.deviation, a.max(b) + stroke.deviation);
        Stretch { low, high, start: a, stroke: Some(stroke), halves: None }
    }

    /// How far two boxes are from each other at least, on whichever side of the axis; with the boxes round strokes taken for these.
    pub(super) fn away(&self, other: &Stretch) -> f64 {
        apart([self.low, self.high], [other.low, other.high])
    }

    pub(super) fn size(&self) -> f64 {
        (self.high - self.low).length()
    }
}

/// How far two boxes are from each other at least, or one from the mirror image of the other.
fn apart([low, high]: [DVec2; 2], [other_low, other_high]: [DVec2; 2]) -> f64 {
    let away = |low: DVec2, high: DVec2| (low - other_high).max(other_low - high).max(DVec2::ZERO).length();
    let near = away(low, high);
    if low.x < 0.0 || other_low.x < 0.0 {
        near.min(away(DVec2::new(-high.x, low.y), DVec2::new(-low.x, high.y)))
    } else {
        near
    }
}

/// A corner, where it is known what is like on both sides of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) at: DVec2,
    /// The unit directions in which the meridian comes and goes.
    pub(super) directions: [DVec2; 2],
    /// By how much it turns to the side where the body is, if that is on the left of it; in radians.
    pub(super) turn: f64,
    /// Bounds of how far the curve is from the chords that this is told of, and of the angle between the two.
    pub(super) deviation: f64,
    pub(super) slant: f64,
}

/// The meridian of a part in the half plane through the axis of another.
pub(super) struct Section<'a> {
    meridian: &'a Meridian,
    borders: &'a [Border],
    /// The sense of its axis in that of the other, and where its origin is.
    sense: f64,
    rise: f64,
    /// On which side of the curve the body is: 1 for the left, -1 for the right, 0 of what has no inside.
    pub(super) inside: f64,
    stretches: Vec<Stretch>,
    root: usize,
    /// For each stroke with which the meridian begins the number of its stretch.
    first: Vec<usize>,
    corners: Vec<Option<Option<Corner>>>,
}

impl<'a> Section<'a> {
    /// Of a part whose axis is run through in this sense, with its origin at this height; `None` of what is no body of revolution.
    pub(super) fn of(space: &'a Space, sense: f64, rise: f64) -> Option<Section<'a>> {
        let meridian = space.meridian()?;
        let inside = if space.is_solid { meridian.inside * sense } else { 0.0 };
        let mut section = Section {
            meridian,
            borders: &space.borders,
            sense,
            rise,
            inside,
            stretches: Vec::with_capacity(4 * meridian.strokes.len()),
            root: 0,
            first: vec![0; meridian.strokes.len()],
            corners: vec![None; meridian.joints.len()],
        };
        section.root = section.build(0, meridian.strokes.len());
        Some(section)
    }

    fn build(&mut self, from: usize, to: usize) -> usize {
        let stretch = if to - from == 1 {
            Stretch::of(self.placed(&self.meridian.strokes[from]))
        } else {
            let middle = usize::midpoint(from, to);
            let halves = [self.build(from, middle), self.build(middle, to)];
            let [one, other] = halves.map(|half| self.stretches[half]);
            let (low, high) = (one.low.min(other.low), one.high.max(other.high));
            Stretch { low, high, start: one.start, stroke: None, halves: Some(halves) }
        };
        self.stretches.push(stretch);
        let index = self.stretches.len() - 1;
        if to - from == 1 {
            self.first[from] = index;
        }
        index
    }

    fn turned(&self, place: DVec2) -> DVec2 {
        DVec2::new(place.x, self.sense * place.y + self.rise)
    }

    fn placed(&self, stroke: &Stroke) -> Stroke {
        let turned = |place| self.turned(place);
        Stroke { chord: Segment(stroke.chord.0.map(turned)), inner: stroke.inner.map(turned), ..*stroke }
    }

    pub(super) fn root(&self) -> usize {
        self.root
    }

    pub(super) fn stretch(&self, stretch: usize) -> &Stretch {
        &self.stretches[stretch]
    }

    pub(super) fn joints(&self) -> &'a [Joint] {
        &self.meridian.joints
    }

    /// Where a corner is.
    pub(super) fn place_of(&self, joint: Joint) -> DVec2 {
        let strokes = &self.meridian.strokes;
        let before = joint.before.map(|before| strokes[before].chord.0[1]);
        let after = joint.after.map(|after| strokes[after].chord.0[0]);
        self.turned(after.or(before).unwrap_or(DVec2::ZERO))
    }

    /// A place of a stroke in space, on the exact surface.
    pub(super) fn place(&self, stroke: &Stroke, t: f64) -> DVec3 {
        self.meridian.place(self.borders, stroke.course, t)
    }

    /// The place in the middle of a stroke's parameter that is furthest in a direction across the axis, as [`Meridian::place_towards`].
    pub(super) fn place_towards(&self, stroke: &Stroke, direction: DVec3) -> DVec3 {
        let [from, to] = stroke.t;
        self.meridian.place_towards(self.borders, stroke.course, 0.5 * from + 0.5 * to, direction)
    }

    /// The parts of a stretch that is already in parts.
    pub(super) fn parts(&self, stretch: usize) -> Option<[usize; 2]> {
        self.stretches[stretch].halves
    }

    /// The halves of a stretch, which are made of a stroke where they are not there; the outer `None` where work is at its end, the inner where there is no number between its ends.
    pub(super) fn halves(&mut self, stretch: usize, steps: &mut Steps) -> Option<Option<[usize; 2]>> {
        let Stretch { halves, stroke, .. } = self.stretches[stretch];
        let (None, Some(stroke)) = (halves, stroke) else { return Some(halves) };
        let [from, to] = stroke.t;
        let middle = 0.5 * from + 0.5 * to;
        if !(from < middle && middle < to) {
            return Some(None);
        }
        steps.take(HALVED)?;
        // Of the meridian as it is by itself.
        let back = |place: DVec2| DVec2::new(place.x, self.sense * (place.y - self.rise));
        let [a, b] = stroke.chord.0.map(back);
        let [first, at, third] = stroke.inner.map(back);
        let (meridian, borders, course) = (self.meridian, self.borders, stroke.course);
        let before = meridian.stroke(borders, course, [from, middle], [a, at], first);
        let after = meridian.stroke(borders, course, [middle, to], [at, b], third);
        let halves = [
            Stroke { joints: [stroke.joints[0], None], ..self.placed(&before) },
            Stroke { joints: [None, stroke.joints[1]], ..self.placed(&after) },
        ]
        .map(|half| {
            self.stretches.push(Stretch::of(half));
            self.stretches.len() - 1
        });
        self.stretches[stretch].halves = Some(halves);
        Some(Some(halves))
    }

    /// How high the section reaches at most, or how low, to within `enough`.
    pub(super) fn reach(&mut self, upwards: bool, enough: f64, steps: &mut Steps) -> Option<f64> {
        let sign = if upwards { 1.0 } else { -1.0 };
        let most = |stretch: &Stretch| if upwards { stretch.high.y } else { -stretch.low.y };
        let mut open = BinaryHeap::from([Open { least: -most(self.stretch(self.root)), rank: 0.0, of: self.root }]);
        let mut reached = f64::NEG_INFINITY;
        while let Some(Open { least, of: stretch, .. }) = open.pop() {
            steps.take(1)?;
            if let Some(stroke) = self.stretch(stretch).stroke {
                reached = stroke.chord.0.into_iter().fold(reached, |most, end| most.max(sign * end.y));
            }
            if -least <= reached + enough {
                return Some(sign * -least);
            }
            for half in self.halves(stretch, steps)?? {
                open.push(Open { least: -most(self.stretch(half)), rank: 0.0, of: half });
            }
        }
        None
    }

    /// How often the section goes round a place that is further from it than this; the outer `None` where work is at its end, the inner where the place is not so far from it.
    ///
    /// Counted on the ray away from the axis, and on the chords in place of the strokes: these can be drawn straight without one of them going over a place that is further from the chord than the stroke is.
    pub(super) fn winding(&mut self, at: DVec2, off: f64, steps: &mut Steps) -> Option<Option<i32>> {
        let point = Segment([at; 2]);
        let mut open = vec![self.root];
        let mut count = 0;
        while let Some(index) = open.pop() {
            steps.take(1)?;
            let stretch = *self.stretch(index);
            if stretch.high.x + off < at.x || stretch.high.y + off < at.y || stretch.low.y - off > at.y {
                continue;
            }
            if let Some(stroke) = stretch.stroke
                && stroke.chord.distance(&point) > stroke.deviation + off
            {
                let [a, b] = stroke.chord.0;
                if (a.y <= at.y) != (b.y <= at.y) {
                    let is_left = (b - a).perp_dot(at - a) > 0.0;
                    // On the chord's inner side of a ray that goes to greater w.
                    if (b.y > a.y) == is_left {
                        count += if b.y > a.y { 1 } else { -1 };
                    }
                }
                continue;
            }
            match self.halves(index, steps)? {
                Some(halves) => open.extend(halves),
                None => return Some(None),
            }
        }
        Some(Some(count))
    }

    /// Whether the body is known not to hold a place that is further from the section than this.
    pub(super) fn is_without(&mut self, at: DVec2, off: f64, steps: &mut Steps) -> Option<bool> {
        if self.inside == 0.0 {
            return Some(true);
        }
        Some(self.winding(at, off, steps)? == Some(0))
    }

    /// Whether all of the section is known to be further than `radius` from a segment. Strokes are halved as long as they are further than `fine` from their chords.
    pub(super) fn is_clear(&mut self, segment: &Segment, radius: f64, fine: f64, steps: &mut Steps) -> Option<bool> {
        let [a, b] = segment.0;
        let round = [a.min(b), a.max(b)];
        let mut open = vec![self.root];
        while let Some(index) = open.pop() {
            steps.take(1)?;
            let stretch = *self.stretch(index);
            if apart([stretch.low, stretch.high], round) > radius {
                continue;
            }
            if let Some(stroke) = stretch.stroke {
                let away = stroke.chord.distance(segment);
                if away - stroke.deviation > radius {
                    continue;
                }
                if stroke.deviation <= fine || away + stroke.deviation <= radius {
                    return Some(false);
                }
            }
            match self.halves(index, steps)? {
                Some(halves) => open.extend(halves),
                None => return Some(false),
            }
        }
        Some(true)
    }

    /// Whether all of the section is known to be further than `radius` from all of a stretch of another one, by boxes and chords as they are.
    pub(super) fn is_far(&self, other: &Stretch, radius: f64, steps: &mut Steps) -> Option<bool> {
        let mut open = vec![self.root];
        while let Some(index) = open.pop() {
            steps.take(1)?;
            let stretch = self.stretch(index);
            if stretch.away(other) > radius {
                continue;
            }
            match self.parts(index) {
                Some(halves) => open.extend(halves),
                None => return Some(false),
            }
        }
        Some(true)
    }

    /// How far a place is from the section at least, as well as it can be told, if that is more than `enough`; the outer `None` where work is at its end.
    fn least(&mut self, at: DVec2, enough: f64, steps: &mut Steps) -> Option<Option<f64>> {
        let point = Segment([at; 2]);
        let mut open = BinaryHeap::from([Open { least: 0.0, rank: 0.0, of: self.root }]);
        let mut nearest = f64::INFINITY;
        while let Some(Open { least, of: stretch, .. }) = open.pop() {
            steps.take(1)?;
            if least >= WELL * nearest || nearest <= enough {
                return Some((least > enough).then_some(least));
            }
            if let Some(stroke) = self.stretch(stretch).stroke {
                nearest = nearest.min(stroke.chord.distance(&point) + stroke.deviation);
            }
            let Some(halves) = self.halves(stretch, steps)? else { return Some((least > enough).then_some(least)) };
            for half in halves {
                let next = self.stretch(half);
                let away = match next.stroke {
                    Some(stroke) => stroke.chord.distance(&point) - stroke.deviation,
                    None => apart([next.low, next.high], [at, at]),
                };
                open.push(Open { least: away.max(least), rank: 0.0, of: half });
            }
        }
        Some(None)
    }

    /// How deep a place is in the body at least, with the border so far off, if that is more than `enough`; the outer `None` where work is at its end.
    pub(super) fn depth(&mut self, at: DVec2, off: f64, enough: f64, steps: &mut Steps) -> Option<Option<f64>> {
        let at = DVec2::new(at.x.abs(), at.y);
        if self.inside == 0.0 {
            return Some(None);
        }
        let Some(least) = self.least(at, enough + off, steps)? else { return Some(None) };
        let is_in = self.winding(at, off, steps)?.is_some_and(|winding| winding != 0);
        Some(is_in.then_some(least - off))
    }

    /// What a corner is like, by strokes beside it that are no further than `fine` from their chords, turn by no more than `slant` and are at least so long; the outer `None` where work is at its end, the inner where there are none.
    pub(super) fn corner(
        &mut self,
        joint: usize,
        [fine, slant, long]: [f64; 3],
        steps: &mut Steps,
    ) -> Option<Option<Corner>> {
        if let Some(corner) = self.corners[joint] {
            return Some(corner);
        }
        let Joint { before, after } = self.meridian.joints[joint];
        let mut beside = [None; 2];
        for (side, of) in [before, after].into_iter().enumerate() {
            let Some(of) = of else { continue };
            let mut at = self.first[of];
            beside[side] = loop {
                let Some(stroke) = self.stretch(at).stroke else { break None };
                if !(stroke.chord.length() >= long) {
                    break None;
                }
                if stroke.deviation <= fine && stroke.slant() <= slant {
                    break Some(stroke);
                }
                match self.halves(at, steps)? {
                    Some(halves) => at = halves[1 - side],
                    None => break None,
                }
            };
        }
        let corner = self.between(beside, [before, after]);
        self.corners[joint] = Some(corner);
        Some(corner)
    }

    fn between(&self, beside: [Option<Stroke>; 2], of: [Option<usize>; 2]) -> Option<Corner> {
        let along = |stroke: Stroke| stroke.chord.along().normalize_or_zero();
        // On the axis it goes on in the mirror image of itself.
        let mirrored = |direction: DVec2| DVec2::new(direction.x, -direction.y);
        let (directions, at) = match (beside, of) {
            ([Some(before), Some(after)], _) => ([along(before), along(after)], after.chord.0[0]),
            ([Some(before), None], [_, None]) => ([along(before), mirrored(along(before))], before.chord.0[1]),
            ([None, Some(after)], [None, _]) => ([mirrored(along(after)), along(after)], after.chord.0[0]),
            _ => return None,
        };
        let most = |of: fn(&Stroke) -> f64| beside.iter().flatten().map(of).fold(0.0, f64::max);
        let [one, other] = directions;
        let turn = libm::atan2(one.perp_dot(other), one.dot(other));
        Some(Corner { at, directions, turn, deviation: most(|stroke| stroke.deviation), slant: most(Stroke::slant) })
    }
}
