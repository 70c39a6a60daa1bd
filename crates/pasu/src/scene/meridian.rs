//! The meridian of a part that is a body of revolution: the closed profile of which all of it is the turned image.

use glam::{DVec2, DVec3};

use super::border::Border;
use super::segment::Segment;
use super::stroke::Stroke;
use crate::patch::Cell;
use crate::solution::Placed;

/// Angles, in turns, at which a face of a wall is held against its own meridian: no two differ by a simple part of a turn.
const ANGLES: [f64; 7] = [0.13, 0.271, 0.382, 0.5, 0.618, 0.744, 0.891];

/// Places along a face at which that is done.
const ROWS: usize = 6;

/// What is measured of a face, of which no bounds are known, is taken this many times, as it is of its cells.
const MARGIN: f64 = 2.0;

/// Into how many pieces a curve of a wall is cut at least, and what lies between two knots of a patch.
const PIECES: usize = 12;

/// How many places of a circle are looked at for the one that is furthest in a direction.
const ROUND: u8 = 32;

/// Coordinates in the plane through the axis are wrong by less than this part of those in space.
const ROUNDING: f64 = 4e-15;

/// Curves whose ends are no further from each other, or from the axis, than this part of the size meet there.
const MET: f64 = 1e-9;

/// A curve of a meridian.
#[derive(Debug, Clone, Copy)]
enum Course {
    /// The line `v = 0` of a piece of the border, along `u`.
    Border(usize),
    /// Straight across the axis: a level disc.
    Disc([DVec2; 2]),
}

/// Where one curve ends and another begins: the numbers of the strokes before and after it. On the axis there is one alone, and its mirror image in place of the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joint {
    pub(super) before: Option<usize>,
    pub(super) after: Option<usize>,
}

/// The profile of a body of revolution in `(w, z)`: `z` along the axis from the origin on, `|w|` the distance from it.
#[derive(Debug)]
pub(super) struct Meridian {
    pub(super) origin: DVec3,
    /// Of length 1.
    pub(super) axis: DVec3,
    /// Across the axis, towards the line `v = 0` of its patches.
    across: DVec3,
    courses: Vec<Course>,
    /// From end to end.
    pub(super) strokes: Vec<Stroke>,
    pub(super) joints: Vec<Joint>,
    /// On which side of its direction the body is: 1 for the left, -1 for the right, as `(w, z)` are drawn; 0 for a surface without an inside.
    pub(super) inside: f64,
    /// How far the border of the part is from what the meridian describes at most, either way.
    pub(super) off: f64,
    /// No place is further from the origin.
    pub(super) reach: f64,
    rounding: f64,
}

impl Meridian {
    /// The meridian of a part, of which this is the border; `None` of what is no body of revolution, or not known to be one.
    ///
    /// That it is one is read from the modes of its surface, and of its placement: what these are off is a bound, and a part of what the border is off. Of a wall, which is made of its surface by the same rule all round, it is measured besides.
    pub(super) fn of(borders: &[Border], placed: &Placed, middle: DVec3, size: f64) -> Option<Meridian> {
        let round = placed.round(size)?;
        let matrix = placed.matrix();
        let axis = matrix.z_axis.try_normalize()?;
        let along = matrix.col(round.axis);
        let across = (along - axis * along.dot(axis)).try_normalize()?;
        let origin = placed.shift() + axis * axis.dot(middle - placed.shift());
        let rounding = ROUNDING * (origin.abs().max_element() + size);
        let is_wall = borders.iter().all(|border| !border.is_proved());
        let is_solid_blend = !is_wall && borders.len() == 3;
        if !(is_wall || is_solid_blend || borders.len() == 1) {
            return None;
        }
        let mut meridian = Meridian {
            origin,
            axis,
            across,
            courses: Vec::new(),
            strokes: Vec::new(),
            joints: Vec::new(),
            inside: 0.0,
            off: round.off + rounding,
            reach: (origin - middle).length() + size,
            rounding,
        };
        if is_solid_blend {
            // The second is between two level discs.
            meridian.courses.push(Course::Border(1));
            let [start, end] = [0.0, 1.0].map(|t| meridian.at(borders, 0, t));
            let on_axis = |end: DVec2| DVec2::new(0.0, end.y);
            meridian.courses =
                vec![Course::Disc([on_axis(start), start]), Course::Border(1), Course::Disc([end, on_axis(end)])];
        } else {
            meridian.courses.extend((0..borders.len()).map(Course::Border));
        }
        if is_wall {
            meridian.off += MARGIN * meridian.out_of_round(borders);
        }
        let cut = (0..meridian.courses.len()).flat_map(|course| meridian.cut(borders, course)).collect();
        meridian.strokes = cut;
        let is_surface = !is_wall && !is_solid_blend;
        if is_surface {
            meridian.bends();
        } else {
            meridian.close(size)?;
        }
        meridian.off.is_finite().then_some(meridian)
    }

    /// A place of a curve in the plane.
    fn at(&self, borders: &[Border], course: usize, t: f64) -> DVec2 {
        match self.courses[course] {
            Course::Border(border) => {
                let border = &borders[border];
                let place = self.flat(border.position(t, 0.0));
                // The faces of a wall go nowhere beyond the axis, and need not begin in one plane through it.
                let w = if border.is_proved() { place.0.dot(self.across) } else { place.0.length() };
                DVec2::new(w, place.1)
            }
            Course::Disc([from, to]) => from + (to - from) * t,
        }
    }

    /// A point as what it is away from the axis, and how far along.
    fn flat(&self, point: DVec3) -> (DVec3, f64) {
        let from = point - self.origin;
        let z = from.dot(self.axis);
        (from - self.axis * z, z)
    }

    /// A place of a curve in space, on the exact surface.
    pub(super) fn place(&self, borders: &[Border], course: usize, t: f64) -> DVec3 {
        match self.courses[course] {
            Course::Border(border) => borders[border].position(t, 0.0),
            Course::Disc(_) => self.lifted(self.at(borders, course, t)),
        }
    }

    /// The place of a curve's circle, on the exact surface, that is all but the furthest in a direction across the axis.
    pub(super) fn place_towards(&self, borders: &[Border], course: usize, t: f64, direction: DVec3) -> DVec3 {
        match self.courses[course] {
            Course::Border(border) => {
                let places = (0..ROUND).map(|i| borders[border].position(t, f64::from(i) / f64::from(ROUND)));
                places.max_by(|a, b| a.dot(direction).total_cmp(&b.dot(direction))).unwrap_or(self.origin)
            }
            Course::Disc(_) => {
                let place = self.at(borders, course, t);
                self.origin + direction * place.x.abs() + self.axis * place.y
            }
        }
    }

    /// A place of the plane in space.
    pub(super) fn lifted(&self, place: DVec2) -> DVec3 {
        self.origin + self.across * place.x + self.axis * place.y
    }

    /// How far faces are from being turned images of their lines `v = 0`, at some places.
    fn out_of_round(&self, borders: &[Border]) -> f64 {
        let mut most = 0.0f64;
        for border in borders {
            for row in 0..=ROWS {
                let u = row as f64 / ROWS as f64;
                let [first, others] = [vec![0.0], ANGLES.to_vec()].map(|angles| {
                    let flat = angles.into_iter().map(|v| self.flat(border.position(u, v)));
                    flat.map(|(away, z)| DVec2::new(away.length(), z)).collect::<Vec<_>>()
                });
                for other in others {
                    let off = (other - first[0]).length();
                    most = if off.is_finite() { most.max(off) } else { f64::INFINITY };
                }
            }
        }
        most
    }

    /// The strokes with which a curve begins.
    fn cut(&self, borders: &[Border], course: usize) -> Vec<Stroke> {
        let knots = match self.courses[course] {
            Course::Border(border) => borders[border].knots(),
            Course::Disc(_) => vec![0.0, 1.0],
        };
        let n_pieces = match self.courses[course] {
            Course::Border(border) if !borders[border].is_straight() => PIECES,
            _ => 1,
        };
        let mut strokes = Vec::new();
        for pair in knots.windows(2) {
            let place = |i: usize| pair[0] + (pair[1] - pair[0]) * (i as f64 / n_pieces as f64);
            for i in 0..n_pieces {
                let t = [place(i), if i + 1 == n_pieces { pair[1] } else { place(i + 1) }];
                let ends = t.map(|t| self.at(borders, course, t));
                let middle = self.at(borders, course, 0.5 * t[0] + 0.5 * t[1]);
                let mut stroke = self.stroke(borders, course, t, ends, middle);
                // For now that there is a corner.
                stroke.joints = [(i == 0).then_some(0), (i + 1 == n_pieces).then_some(0)];
                strokes.push(stroke);
            }
        }
        strokes
    }

    /// A piece of a curve, of which both ends and the middle are known.
    pub(super) fn stroke(
        &self,
        borders: &[Border],
        course: usize,
        t: [f64; 2],
        ends: [DVec2; 2],
        middle: DVec2,
    ) -> Stroke {
        let quarter = |share: f64| self.at(borders, course, t[0] + (t[1] - t[0]) * share);
        let inner = [quarter(0.25), middle, quarter(0.75)];
        let deviation = match self.courses[course] {
            Course::Disc(_) => 0.0,
            Course::Border(border) => match borders[border].is_proved() {
                true => borders[border].enclosed(Cell { u: t, v: [0.0; 2] }, [DVec3::ZERO; 4]).0,
                false => MARGIN * bend(ends, inner) / 8.0,
            },
        };
        let deviation = deviation + self.rounding;
        let deviation = if deviation.is_finite() { deviation } else { f64::INFINITY };
        Stroke { course, t, chord: Segment(ends), inner, deviation, joints: [None; 2] }
    }

    /// Numbers the corners of a surface without an inside: its ends are none.
    fn bends(&mut self) {
        let last = self.strokes.len() - 1;
        self.strokes[0].joints[0] = None;
        self.strokes[last].joints[1] = None;
        self.number();
    }

    /// Numbers the corners between strokes that follow on from each other.
    fn number(&mut self) {
        for after in 1..self.strokes.len() {
            let before = after - 1;
            if self.strokes[after].joints[0].is_some() {
                let joint = Some(self.joints.len());
                self.joints.push(Joint { before: Some(before), after: Some(after) });
                self.strokes[before].joints[1] = joint;
                self.strokes[after].joints[0] = joint;
            }
        }
    }

    /// Has a stroke begin to the bit where the one before it ends, so that no ray goes between them; how far that was from it.
    fn joined(&mut self, before: usize, after: usize) -> f64 {
        let end = self.strokes[before].chord.0[1];
        let stroke = &mut self.strokes[after];
        let gap = (stroke.chord.0[0] - end).length();
        stroke.chord.0[0] = end;
        stroke.deviation += gap;
        gap
    }

    /// Closes the curves round a body: each ends where the next begins, and the last where the first does or on the axis. `None` where they do not, or go beyond the axis.
    fn close(&mut self, size: f64) -> Option<()> {
        let met = MET * size;
        let last = self.strokes.len().checked_sub(1)?;
        let [start, end] = [self.strokes[0].chord.0[0], self.strokes[last].chord.0[1]];
        let mut gap = 0.0f64;
        for after in 1..=last {
            gap = gap.max(self.joined(after - 1, after));
        }
        let places = self.strokes.iter().flat_map(|stroke| stroke.chord.0.into_iter().chain(stroke.inner));
        let beyond = places.fold(0.0f64, |most, place| most.max(-place.x));
        self.number();
        let to_axis = start.x.abs().max(end.x.abs());
        let closing = if to_axis <= met {
            for (place, joint) in
                [(0, Joint { before: None, after: Some(0) }), (1, Joint { before: Some(last), after: None })]
            {
                let of = if place == 0 { 0 } else { last };
                self.strokes[of].joints[place] = Some(self.joints.len());
                self.joints.push(joint);
            }
            to_axis
        } else {
            let joint = Some(self.joints.len());
            self.joints.push(Joint { before: Some(last), after: Some(0) });
            self.strokes[last].joints[1] = joint;
            self.strokes[0].joints[0] = joint;
            self.joined(last, 0)
        };
        let worst = gap.max(closing).max(beyond);
        if !(worst <= met) {
            return None;
        }
        self.off += worst;
        let area: f64 = self.strokes.iter().map(|stroke| stroke.chord.0[0].perp_dot(stroke.chord.0[1])).sum();
        self.inside = if area > 0.0 { 1.0 } else { -1.0 };
        Some(())
    }
}

/// The second differences over a whole piece and over its halves, the largest of them.
fn bend([start, end]: [DVec2; 2], [first, middle, third]: [DVec2; 3]) -> f64 {
    let bend = |from: DVec2, at: DVec2, to: DVec2| ((from - at) + (to - at)).length();
    let halves = bend(start, first, middle).max(bend(first, middle, third)).max(bend(middle, third, end));
    (4.0 * bend(start, middle, end)).max(16.0 * halves)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bend_is_the_second_derivative_of_a_parabola() {
        let at = |t: f64| DVec2::new(3.0 * t, 5.0 * t * t);
        assert!((bend([at(0.0), at(1.0)], [at(0.25), at(0.5), at(0.75)]) - 10.0).abs() < 1e-12);
    }
}
