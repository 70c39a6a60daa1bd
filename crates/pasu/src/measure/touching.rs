//! Curves on faces along which a body touches the table: ends, as the edge of a tube, crests, as the bead of one, and ridges, as of a prism that lies.

use core::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use crate::face::{Face, FaceJet, FaceWalk};
use crate::numeric::brent;
use crate::numeric::grid::Grid;
use crate::numeric::illinois;
use crate::numeric::trapezoid::round;

/// Places of a side of a face, or of a ridge, at which it is looked whether it touches.
const LOOKS: usize = 33;

/// A curve of a face at one level.
pub(crate) struct Touching<'a> {
    face: &'a dyn Face,
    course: Course,
}

/// Where on its face a curve is.
enum Course {
    /// Round an end of the face, `a` = 0 or 1.
    End(f64),
    /// Along `a` at one `v`.
    Along(f64),
    /// Round the face, where it is lowest in each column: of even ones about where, and how far from there at most.
    Crest { lows: Vec<f64>, within: f64 },
}

impl<'a> Touching<'a> {
    /// The edges of a face that touches as a whole.
    pub(crate) fn all(face: &'a dyn Face) -> impl Iterator<Item = Touching<'a>> {
        let sides = sides(face).map(Course::Along);
        [0.0, 1.0].map(Course::End).into_iter().chain(sides).map(move |course| Touching { face, course })
    }

    /// Whether it goes round this end of its face.
    pub(crate) fn is_end(&self, at: f64) -> bool {
        matches!(self.course, Course::End(a) if a == at)
    }

    /// Whether its last point is its first. What goes to an end and back is passed once.
    pub(crate) fn is_closed(&self) -> bool {
        match self.course {
            Course::End(_) => self.face.is_closed() && !self.goes_back(),
            Course::Along(_) => false,
            Course::Crest { .. } => self.face.is_closed(),
        }
    }

    fn goes_back(&self) -> bool {
        self.face.goes_back(1.5 * PI)
    }

    /// Points at even steps, from above.
    pub(crate) fn points(&self, n: usize) -> Vec<DVec2> {
        let last = (!self.is_closed()).then_some(TAU);
        let mut walk = self.walk();
        round(n).chain(last).map(|turn| walk.point(turn)).collect()
    }

    /// The same with how each changes by the turn; `None` where that is not known, or jumps.
    pub(crate) fn slopes(&self, n: usize) -> Option<Vec<[DVec2; 2]>> {
        let last = (!self.is_closed()).then_some(TAU);
        let mut walk = self.walk();
        round(n).chain(last).map(|turn| walk.sloped(turn)).collect()
    }

    /// One point after the other.
    pub(crate) fn walk(&self) -> TouchingWalk<'_> {
        TouchingWalk { curve: self, walk: self.face.walk() }
    }
}

/// Points of a curve one after the other, by their part of the way: 2 pi for all of it.
pub(crate) struct TouchingWalk<'a> {
    curve: &'a Touching<'a>,
    walk: Box<dyn FaceWalk + 'a>,
}

impl TouchingWalk<'_> {
    fn at(&mut self, turn: f64) -> FaceJet {
        match &self.curve.course {
            Course::End(a) if self.curve.goes_back() => {
                let jet = self.walk.jet(*a, 0.5 * turn);
                FaceJet { dv: 0.5 * jet.dv, ..jet }
            }
            Course::End(a) => self.walk.jet(*a, turn),
            Course::Along(v) => self.walk.jet(turn / TAU, *v),
            Course::Crest { lows, within } => {
                let n = lows.len() as f64;
                let column = libm::round(turn / TAU * n).rem_euclid(n) as usize;
                let a = low(&mut *self.walk, turn, lows[column], *within);
                self.walk.jet(a, turn)
            }
        }
    }

    /// A point from above.
    pub(super) fn point(&mut self, turn: f64) -> DVec2 {
        self.at(turn).position.truncate()
    }

    fn sloped(&mut self, turn: f64) -> Option<[DVec2; 2]> {
        let jet = self.at(turn);
        let slope = match self.curve.course {
            Course::End(_) => jet.dv,
            Course::Along(_) => jet.da / TAU,
            Course::Crest { .. } => return None,
        };
        Some([jet.position, slope].map(DVec3::truncate))
    }

    /// How far it reaches in a direction between two turns, between which it first goes further and then less far, given with the slopes there.
    pub(crate) fn top(&mut self, from: (f64, f64), to: (f64, f64), direction: DVec2) -> f64 {
        let mut slope = |turn: f64| self.sloped(turn).map_or(0.0, |[_, slope]| slope.dot(direction));
        let top = illinois::root(from, to, &mut slope);
        self.point(top).dot(direction)
    }

    /// The same of a curve without slopes, about a turn and no further from there than a step.
    pub(crate) fn farthest(&mut self, place: f64, step: f64, direction: DVec2) -> f64 {
        let ends = [place - step, place + step];
        let [low, high] = if self.curve.is_closed() { ends } else { ends.map(|turn| turn.clamp(0.0, TAU)) };
        -brent::least(low, high, 1e-9, |turn| -self.point(turn).dot(direction)).1
    }
}

/// Where the sides are of an open face, also of one that is passed there and back.
fn sides(face: &dyn Face) -> impl Iterator<Item = f64> {
    let last = match face.is_closed() {
        true => face.goes_back(1.5 * PI).then_some(PI),
        false => Some(TAU),
    };
    last.into_iter().flat_map(|last| [0.0, last])
}

/// The ends, and of an open face the sides, that lie below a level; what is no longer than `point` is none.
pub(super) fn level_ends<'a>(face: &'a dyn Face, grid: &Grid<FaceJet>, level: f64, point: f64) -> Vec<Touching<'a>> {
    let rows: Vec<&[FaceJet]> = grid.by_rows().collect();
    let is_level = |jet: &FaceJet| jet.position.z <= level;
    let is_long = |row: &[FaceJet]| row.iter().any(|jet| jet.position.distance(row[0].position) > point);
    let ends = [(0.0, rows.first()), (1.0, rows.last())];
    let ends = ends.into_iter().filter(|(_, row)| row.is_some_and(|row| row.iter().all(is_level) && is_long(row)));
    let mut found: Vec<Touching> = ends.map(|(a, _)| Touching { face, course: Course::End(a) }).collect();
    found.extend(sides(face).filter_map(|v| level_ridge(face, v, level)));
    found
}

/// The curve along `a` at one `v`, if all of it lies below a level.
pub(super) fn level_ridge(face: &dyn Face, v: f64, level: f64) -> Option<Touching<'_>> {
    let mut walk = face.walk();
    let is_level = (0..LOOKS).all(|i| walk.jet(i as f64 / (LOOKS - 1) as f64, v).position.z <= level);
    is_level.then_some(Touching { face, course: Course::Along(v) })
}

/// The curve round a closed face where it is lowest in each column, if all of it lies below a level; on the grid no column is higher than `near`, and what is no longer there than `point` is none.
pub(super) fn level_crest<'a>(
    face: &'a dyn Face,
    grid: &Grid<FaceJet>,
    level: f64,
    near: f64,
    point: f64,
) -> Option<Touching<'a>> {
    if !face.is_closed() {
        return None;
    }
    let (columns, within) = (grid.columns(), grid.steps().0);
    let position = |row: usize, column: usize| grid.points()[row * columns + column].position;
    let height = |row: usize, column: usize| position(row, column).z;
    let lows: Vec<usize> = (0..columns)
        .map(|column| (0..grid.rows()).min_by(|i, j| height(*i, column).total_cmp(&height(*j, column))).unwrap_or(0))
        .collect();
    if lows.iter().enumerate().any(|(column, row)| height(*row, column) > near) {
        return None;
    }
    // All columns of a face that ends in a point may be lowest there.
    let is_at_first = |(column, row): (usize, &usize)| position(*row, column).distance(position(lows[0], 0)) <= point;
    if lows.iter().enumerate().all(is_at_first) {
        return None;
    }
    let mut walk = face.walk();
    let mut found = Vec::with_capacity(columns);
    for (column, row) in lows.into_iter().enumerate() {
        let (near, v) = grid.place(row * columns + column);
        let a = low(&mut *walk, v, near, within);
        if walk.jet(a, v).position.z > level {
            return None;
        }
        found.push(a);
    }
    Some(Touching { face, course: Course::Crest { lows: found, within } })
}

/// Where a column is lowest, about a place and no further from there than `within`.
fn low(walk: &mut dyn FaceWalk, v: f64, near: f64, within: f64) -> f64 {
    let mut at = |a: f64| walk.jet(a, v);
    let ends = [near - within, near + within].map(|a| a.clamp(0.0, 1.0)).map(|a| (a, at(a)));
    let [from, to] = ends.map(|(a, jet)| (a, jet.da.z));
    if from.1 < 0.0 && to.1 > 0.0 {
        return illinois::root(from, to, |a| at(a).da.z);
    }
    let middle = (near, at(near));
    let [from, to] = ends;
    [middle, from, to].into_iter().min_by(|x, y| x.1.position.z.total_cmp(&y.1.position.z)).map_or(near, |low| low.0)
}
