//! Rings through a drawn profile.

use glam::DVec2;

use super::chords::Chords;
use super::contract::{Ringed, check_tolerance, too_fine};
use super::curves::{self, Answers, Curves, Place, leaning};
use super::digits::{decimal, to_multiple};
use super::hausdorff::farthest;
use super::line::Line;
use super::normal::Normal;
use crate::design::{Design, RINGS, Rings, Shape, plain};
use crate::error::{Code, Error, Result};
use crate::surface::Surface;
use crate::watch;

/// A drawn profile: points as radius and height, in pairs, from one end to the other.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Profile {
    /// The right side: `[r, z, r, z, ..]`.
    pub right: Vec<f64>,
    /// The left side, its radii positive as well; as the right one without it.
    pub left: Option<Vec<f64>>,
}

impl Profile {
    /// A profile that is the same on both sides.
    ///
    /// ```
    /// assert!(pasu::Profile::new(vec![3.0, 0.0, 4.0, 10.0]).left.is_none());
    /// ```
    pub fn new(right: Vec<f64>) -> Profile {
        Profile { right, left: None }
    }
}

/// Points of a drawn line at most.
const MOST_POINTS: usize = 20_000;

/// Samples of a side, and for each ring at least.
const SAMPLES: usize = 240;
const SAMPLES_PER_RING: usize = 8;

/// How often samples are moved along the rings' curve to where they are nearest to it.
const ROUNDS: usize = 6;

/// Corners are looked for over this many tolerances, and this part of the length at least.
const OVER: f64 = 2.0;
const LEAST_OVER: f64 = 0.004;

/// Corners of both sides that are this near each other, in parts of the length, are one ring.
const SAME_CORNER: f64 = 0.06;

/// What a bound on the distance may be more than the distance, as a part of the tolerance, between chords of the pot's curve and on pieces of both lines.
const HIDDEN: f64 = 0.01;

/// What finding the nearest place of a line to a piece counts for, in the units of [`watch::work`].
const PIECE: u64 = 30;

/// Rings stand where their `u` has few digits, and this part of the profile apart at least.
const STEP: f64 = 1e-4;

/// The numbers of rings are rounded by this part of the tolerance at most.
const ROUNDED: f64 = 0.04;

/// Where it is off by less than this part of the most, a ring elsewhere helps more.
const WORTH: f64 = 0.25;

/// The most work on leaving out rings that are not needed, in the units of [`watch::work`]: a third of a second.
const MOST_WORK: u64 = 24_000_000;

/// Samples that moved by less than this part of the tolerance stay where they are.
const AT_REST: f64 = 0.01;

/// Least squares and the smoothing parameters that are tried: the potter's, and none, which makes straight lines straight.
const SMOOTHINGS: [f64; 2] = [1.0, 0.0];

/// A pot of `rings` with a drawn profile, no further from the line than a tolerance, nor the line from it: fitted by least squares, with as few rings as were found to be enough, sharp where the line turns by more than 35 degrees.
///
/// The line is run through by its length; what is `u` of the pot is the part of the length that lies below, about. With a left side of its own the pot leans or is wider there: each ring has one wave, `n = 1`, of radius and height. The lower end of the line is
/// the foot. Between two sharp rings of straight pieces the smoothing parameter `a` is 0, so that they are straight.
///
/// ```
/// use pasu::{Profile, Shape, fit};
///
/// let cone = fit(&Profile::new(vec![3.0, 0.0, 4.0, 10.0]), 0.01)?;
/// let Shape::Rings(pot) = &cone.design.parts()[0].shape else { unreachable!() };
/// assert!(cone.distance <= 0.01 && pot.rings.len() == 2);
/// # Ok::<(), pasu::Error>(())
/// ```
///
/// # Errors
/// `wrong-type` for less than two points or half a point, `not-finite` and `out-of-range` for a number that is none or a negative radius, `too-large` for more than 20,000 points, `out-of-range` for a tolerance that is not above 0 and for a line
/// without length, `tolerance-too-fine` where 66 rings are not enough.
pub fn fit(profile: &Profile, tolerance: f64) -> Result<Ringed> {
    check_tolerance(tolerance)?;
    let mut sides = vec![line(&profile.right, "right")?];
    if let Some(left) = &profile.left {
        sides.push(line(left, "left")?);
    }
    let mut best: Option<(Rings, f64)> = None;
    let mut failed = None;
    for a in SMOOTHINGS {
        match Search::of(&sides, a, tolerance).run() {
            Ok(found) => {
                if best.as_ref().is_none_or(|(rings, _)| found.0.rings.len() < rings.rings.len()) {
                    best = Some(found);
                }
            }
            Err(error) => failed = Some(error),
        }
    }
    match (best, failed) {
        (Some((rings, distance)), _) => {
            Ok(Ringed { design: Design::parse("#1/rings")?.with_shape(0, Shape::Rings(rings))?, distance })
        }
        (None, Some(error)) => Err(error),
        (None, None) => Err(too_fine(tolerance, f64::INFINITY)),
    }
}

/// A side as a line from its lower end.
fn line(numbers: &[f64], side: &str) -> Result<Line> {
    if numbers.len() < 4 || numbers.len() % 2 == 1 {
        let message = format!("expected pairs of radius and height, two at least, found {} numbers", numbers.len());
        return Err(Error::new(Code::WrongType, side, message));
    }
    if numbers.len() > 2 * MOST_POINTS {
        let message = format!("expected at most {MOST_POINTS} points, found {}", numbers.len() / 2);
        let error = Error::new(Code::TooLarge, side, message).with("greatest", MOST_POINTS);
        return Err(error.with("found", numbers.len() / 2));
    }
    for (index, &number) in numbers.iter().enumerate() {
        let path = || format!("{side}[{index}]");
        if !number.is_finite() {
            return Err(Error::new(
                Code::NotFinite,
                path(),
                format!("expected a finite number, found {}", plain(number)),
            ));
        }
        if index % 2 == 0 && number < 0.0 {
            let message = format!("expected a radius of 0 or more, found {}", plain(number));
            return Err(Error::new(Code::OutOfRange, path(), message).with("least", 0.0).with("found", number));
        }
    }
    let mut points: Vec<DVec2> = numbers.chunks_exact(2).map(DVec2::from_slice).collect();
    if points[0].y > points[points.len() - 1].y {
        points.reverse();
    }
    Line::of(points).ok_or_else(|| Error::new(Code::OutOfRange, side, "expected a line that has a length"))
}

/// Samples of one side: what is drawn, and where along the rings it is.
struct Side<'a> {
    line: &'a Line,
    /// Places along the rings at which it is at known places along the line: ends and corners.
    known: Vec<[f64; 2]>,
}

impl Side<'_> {
    /// How far along the line the rings' place `u` is.
    fn along(&self, u: f64) -> f64 {
        let next = self.known.partition_point(|[known, _]| *known <= u).clamp(1, self.known.len() - 1);
        let ([u0, from], [u1, to]) = (self.known[next - 1], self.known[next]);
        from + (to - from) * ((u - u0) / (u1 - u0)).clamp(0.0, 1.0)
    }
}

/// The search for rings that are enough.
struct Search<'a> {
    sides: Vec<Side<'a>>,
    a: f64,
    tolerance: f64,
    /// From 0 to 1.
    places: Vec<Place>,
}

/// Rings, and how far they are off from each of them to the next.
struct Attempt {
    rings: Rings,
    between: Vec<f64>,
}

impl Attempt {
    fn distance(&self) -> f64 {
        self.between.iter().fold(0.0f64, |most, off| most.max(*off))
    }
}

impl<'a> Search<'a> {
    fn of(lines: &'a [Line], a: f64, tolerance: f64) -> Search<'a> {
        let mut sides: Vec<Side> = lines.iter().map(|line| Side { line, known: vec![[0.0; 2]] }).collect();
        let mut places = vec![(0.0, false)];
        let mut corners = together(lines, tolerance);
        // A line with more of them than there may be rings trembles: it is taken for one without any.
        if corners.len() > RINGS {
            corners.clear();
        }
        for corner in corners {
            let u = stepped(corner.iter().sum::<f64>() / corner.len() as f64);
            if u - places[places.len() - 1].0 < STEP || u > 1.0 - STEP {
                continue;
            }
            places.push((u, true));
            for (side, along) in sides.iter_mut().zip(corner) {
                side.known.push([u, along]);
            }
        }
        places.push((1.0, false));
        for side in &mut sides {
            side.known.push([1.0; 2]);
        }
        Search { sides, a, tolerance, places }
    }

    fn run(mut self) -> Result<(Rings, f64)> {
        let mut found = loop {
            let attempt = self.attempt(&self.places)?;
            watch::go_on()?;
            let distance = attempt.distance();
            if distance <= self.tolerance {
                break attempt;
            }
            let before = self.places.len();
            self.refine(&attempt.between, distance);
            if self.places.len() == before || self.places.len() > RINGS + 2 {
                return Err(too_fine(self.tolerance, distance));
            }
        };
        watch::within(MOST_WORK, || self.prune(&mut found));
        watch::go_on()?;
        let distance = found.distance();
        Ok((found.rings, distance))
    }

    /// Leaves out rings that were needed before others came and may not be any more, those first that seem to be needed least, as long as there is time for it.
    fn prune(&mut self, found: &mut Attempt) {
        let mut needed: Vec<f64> = Vec::new();
        loop {
            let inner = self.places.iter().enumerate().take(self.places.len() - 1).skip(1);
            let open = inner.filter(|(_, (u, sharp))| !sharp && !needed.contains(u));
            let off = |index: usize| found.between[index - 1].max(found.between[index]);
            let least = open.map(|(index, _)| index).min_by(|one, other| off(*one).total_cmp(&off(*other)));
            let Some(index) = least else { return };
            let mut fewer = self.places.clone();
            let (u, _) = fewer.remove(index);
            match self.attempt(&fewer) {
                _ if watch::is_stopped() => return,
                Ok(attempt) if attempt.distance() <= self.tolerance => (self.places, *found) = (fewer, attempt),
                _ => needed.push(u),
            }
        }
    }

    /// Rings at these places by least squares: the samples of the line move along the pot's own curve to where they are nearest to it, and the numbers follow, a few times.
    fn attempt(&self, places: &[Place]) -> Result<Attempt> {
        let is_round = self.sides.len() == 1;
        let curves = Curves::of(self.a, places, is_round)?;
        let n = SAMPLES.max(SAMPLES_PER_RING * places.len());
        let even = |i: usize| i as f64 / n as f64;
        // Of each side the samples: where along the rings each is, and where it has to come.
        let mut samples: Vec<Vec<(f64, DVec2)>> = self
            .sides
            .iter()
            .map(|side| (0..=n).map(|i| (even(i), side.line.at(side.along(even(i))))).collect())
            .collect();
        let mut rings = self.solved(&curves, places, &samples)?;
        for _ in 0..ROUNDS {
            let surface = Surface::solve(&rings.boundary_value(), "")?;
            let mut most = 0.0f64;
            for (index, side) in samples.iter_mut().enumerate() {
                let length = self.sides[index].line.length();
                for (u, point) in side.iter_mut() {
                    let next = nearest(&surface, index, *u, *point, places);
                    most = most.max((next - *u).abs() * length);
                    *u = next;
                }
            }
            rings = self.solved(&curves, places, &samples)?;
            if most <= AT_REST * self.tolerance {
                break;
            }
        }
        let between = self.off(&rings, places)?;
        Ok(Attempt { rings, between })
    }

    /// The numbers with the least sum of squares, ends and corners as drawn.
    fn solved(&self, curves: &Curves, places: &[Place], samples: &[Vec<(f64, DVec2)>]) -> Result<Rings> {
        let n = places.len() + 2;
        let n_numbers = n * samples.len();
        let mut normals = [(); 2].map(|()| Normal::new(n_numbers));
        let mut answers = Answers::default();
        for (index, side) in samples.iter().enumerate() {
            watch::work((side.len() * n_numbers) as u64 * (4 + n_numbers as u64 / 24));
            for (u, point) in side {
                curves.at(*u, &mut answers);
                for ((normal, row), goal) in
                    normals.iter_mut().zip([&mut answers.r, &mut answers.z]).zip(point.to_array())
                {
                    if index == 1 {
                        row[n..].iter_mut().for_each(|wave| *wave = -*wave);
                    }
                    normal.add(row, goal);
                }
            }
        }
        let fixed = self.fixed(places);
        let unit = decimal(ROUNDED * self.tolerance);
        let numbers: Vec<Vec<f64>> = normals
            .into_iter()
            .enumerate()
            .map(|(axis, normal)| {
                let given: Vec<Option<f64>> = (0..n_numbers)
                    .map(|number| {
                        let given = fixed.get(number % n)?.as_ref()?;
                        let [mean, lean] = given[axis];
                        Some(if number < n { mean } else { lean })
                    })
                    .collect();
                normal.least(&given).into_iter().map(|number| to_multiple(number, unit)).collect()
            })
            .collect();
        let series = |axis: usize| {
            let numbers = &numbers[axis];
            move |number: usize| match numbers.get(number + n) {
                Some(lean) => leaning(numbers[number], *lean),
                None => curves::plain(numbers[number]),
            }
        };
        Ok(curves::pot(self.a, places, &series(0), &series(1)))
    }

    /// Mean and lean of radius and height on the rings where they are as drawn.
    fn fixed(&self, places: &[Place]) -> Vec<Option<[[f64; 2]; 2]>> {
        let last = places.len() - 1;
        let given = |(index, (u, sharp)): (usize, &Place)| {
            (index == 0 || index == last || *sharp).then(|| {
                let points: Vec<DVec2> = self.sides.iter().map(|side| side.line.at(side.along(*u))).collect();
                let (right, left) = (points[0], points[points.len() - 1]);
                [0, 1].map(|axis| [0.5 * (right[axis] + left[axis]), 0.5 * (right[axis] - left[axis])])
            })
        };
        places.iter().enumerate().map(given).collect()
    }

    /// No place of one is further from the other, either way, from each ring to the next.
    fn off(&self, rings: &Rings, places: &[Place]) -> Result<Vec<f64>> {
        let surface = Surface::solve(&rings.boundary_value(), "")?;
        let mut between = vec![0.0f64; places.len() - 1];
        let close = HIDDEN * self.tolerance;
        for (index, side) in self.sides.iter().enumerate() {
            let bays = places.windows(2).map(|pair| [pair[0].0, pair[1].0]);
            let chords: Vec<Chords> = bays
                .clone()
                .map(|[from, to]| Chords::of(&surface, [from, to], close, |u| seen(&surface, index, u)[0]))
                .collect();
            let hidden = chords.iter().fold(0.0f64, |most, chords| most.max(chords.off));
            let made = Line::of(chords.iter().flat_map(|chords| chords.points.iter().copied()));
            for ((off, [from, to]), chords) in between.iter_mut().zip(bays).zip(&chords) {
                let drawn = side.line.between(side.along(from), side.along(to));
                watch::work(PIECE * (drawn.len() + chords.points.len()) as u64);
                let far = made.as_ref().map_or(f64::INFINITY, |made| farthest(&drawn, made, close, 0.0));
                *off = off.max(farthest(&chords.points, side.line, close, far) + hidden);
            }
        }
        Ok(between)
    }

    fn refine(&mut self, between: &[f64], distance: f64) {
        let mut more = Vec::with_capacity(2 * self.places.len());
        for (pair, off) in self.places.windows(2).zip(between) {
            more.push(pair[0]);
            let middle = stepped(0.5 * (pair[0].0 + pair[1].0));
            let has_room = middle - pair[0].0 >= STEP && pair[1].0 - middle >= STEP;
            if *off > self.tolerance && *off >= WORTH * distance && has_room {
                more.push((middle, false));
            }
        }
        more.push((1.0, false));
        self.places = more;
    }
}

/// The corners of all sides in order, each with where it is on every side.
fn together(lines: &[Line], tolerance: f64) -> Vec<Vec<f64>> {
    let corners = |line: &Line| line.corners((OVER * tolerance).max(LEAST_OVER * line.length()));
    let [right, left] = [lines.first(), lines.get(1)].map(|line| line.map(corners));
    let right = right.unwrap_or_default();
    let Some(mut left) = left else { return right.into_iter().map(|along| vec![along]).collect() };
    let mut all: Vec<Vec<f64>> = Vec::with_capacity(right.len() + left.len());
    for along in right {
        let near = left.iter().position(|other| (other - along).abs() <= SAME_CORNER);
        all.push(vec![along, near.map_or(along, |index| left.remove(index))]);
    }
    all.extend(left.into_iter().map(|along| vec![along, along]));
    all.sort_by(|one, other| one[0].total_cmp(&other[0]));
    all.dedup_by(|next, last| next[1] <= last[1]);
    all
}

/// Radius and height of one side of a pot, and their slopes.
fn seen(surface: &Surface, side: usize, u: f64) -> [DVec2; 2] {
    let (v, sign) = if side == 0 { (0.0, 1.0) } else { (core::f64::consts::PI, -1.0) };
    let jet = surface.at(u, v);
    [jet.position, jet.du].map(|point| DVec2::new(sign * point.x, point.z))
}

/// The place near `u`, between the same two corners, that is nearest to a point.
fn nearest(surface: &Surface, side: usize, u: f64, point: DVec2, places: &[Place]) -> f64 {
    let is_end = |(place, sharp): &&Place| *sharp || *place == 0.0 || *place == 1.0;
    let from = places.iter().rev().filter(is_end).find(|(place, _)| *place <= u).map_or(0.0, |(place, _)| *place);
    let to = places.iter().filter(is_end).find(|(place, _)| *place > u).map_or(1.0, |(place, _)| *place);
    if u == from || u == 1.0 {
        return u;
    }
    let [here, slope] = seen(surface, side, u);
    let step = (point - here).dot(slope) / slope.length_squared();
    let next = if step.is_finite() { (u + step).clamp(from, to) } else { u };
    // A sample never comes to stand on the corner itself, whose other side has another slope.
    if next == to && to < 1.0 { 0.5 * (u + to) } else { next }
}

fn stepped(u: f64) -> f64 {
    to_multiple(u, STEP)
}
