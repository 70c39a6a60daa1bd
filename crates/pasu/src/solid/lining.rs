//! A lining of its own: what the inside of a wall is where it does not follow the outside.
//!
//! It solves the equation of the outside (squared where that is of order 2, which the outside solves too) between rings, with fewer waves round it. The rings stand so far inside the outside that the wall is nowhere thinner than
//! it is to be; without them it would come nearer between foot and rim (`docs/blends.md`). Where `A S = p` and `A L = 0` for one operator `A` in `u` and `v`, the wall `(1 - w) L + w S` solves `A X + c X_wwww = w p` for every `c`: it is their blend.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::apart::{Budget, Cells, Nearby, Proof, proven};
use super::samples::{Cloud, Samples};
use super::skin::Skin;
use super::told::place;
use crate::design::{BoundaryValue, Component, Datum, Lining, Mode, Order, Wall, plain};
use crate::error::{Code, Error, Result};
use crate::mode::{Free, Ring};
use crate::solution::Solved;
use crate::surface::{Surface, Term};
use crate::watch;

/// The bays between rings.
const BAYS: usize = 16;

/// Half of the stretch over which the profile's direction is told.
const REACH: f64 = 1.0 / 32.0;

/// Samples are no further apart than this part of the thickness.
const STEP: f64 = 0.2;

/// The wall is to be thicker by this than what was asked for, where it is sought on coarse samples.
const SPARE: f64 = 0.006;

/// How often the rings are moved until the wall is thick enough.
const ROUNDS: usize = 24;

/// Rings that could be moved out by no more than this part of the thickness stay where they are.
const CLOSE: f64 = 0.02;

/// The rounds in which they are moved out as well as in.
const BOTH_WAYS: usize = 8;

/// Rows and columns at which the lining is looked at while its rings are moved.
const ROWS: usize = 65;
const COLUMNS: usize = 72;

/// So many columns for each wave of the outside, but no more than so many.
const PER_WAVE: usize = 8;
const MOST_COLUMNS: usize = 600;

/// The most steps to the nearest point.
const STEPS: usize = 6;

/// How often rings are drawn in a little more where the wall is not proven to be thick enough.
const RAISED: usize = 8;

/// By how much more than what is missing.
const MORE: f64 = 1.1;

/// How many samples there are of what leads straight to the floor, from top to bottom.
const STEPS_DOWN: usize = 8;

/// Where the foot leans so little the lining begins level with it, and where it leans so much, above it.
const UPRIGHT: [f64; 2] = [0.3, 0.6];

/// The lining is at least as wide as this part of the size.
const LEAST: f64 = 5e-3;

/// A lining and how far it is from the surface of the design.
#[derive(Debug)]
pub(crate) struct Lined {
    skin: Arc<Skin>,
    apart: Distances,
    /// Places of it, from which the nearest is found.
    samples: Samples,
    cloud: Cloud,
}

/// How far a lining is from the outside.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distances {
    /// The least distance of a sample, and where.
    pub(super) least: (f64, DVec3),
    /// It is nowhere less than this; 0 where that was not asked for.
    pub(super) bound: f64,
    /// The greatest distance of a sample, and by how much that differs from those next to it.
    pub(super) greatest: (f64, f64),
}

/// By how much a lining is drawn in.
#[derive(Debug, Clone)]
struct Drawn {
    /// A quadratic spline of these numbers along its profile, towards the axis of the pot and up.
    rings: Vec<f64>,
    /// Where it begins it is this much narrower, so that what leads from there to the floor keeps away from the foot.
    foot: f64,
}

impl Drawn {
    /// At a ring.
    fn at(&self, ring: usize) -> f64 {
        let at = |k: usize| self.rings[k.min(BAYS)];
        (at(ring.saturating_sub(1)) + 6.0 * at(ring) + at(ring + 1)) / 8.0
    }
}

/// The profile at a ring.
#[derive(Clone, Copy)]
struct Station {
    /// The mean circle, as a complex number whose length is its radius.
    round: DVec2,
    /// What makes it an ellipse.
    oval: f64,
    /// Outwards and upwards.
    normal: DVec2,
    /// Along the profile from foot to rim.
    tangent: DVec2,
}

impl Lined {
    /// The lining of a wall inside a surface; where it counts, seen along the axis, is above `floor`.
    ///
    /// # Errors
    /// `unsupported-shape` where the outside is no solution of a boundary-value problem; `no-room` where nothing would be left inside.
    pub(super) fn of(outside: &Skin, wall: &Wall, lining: Lining, floor: f64, is_closely: bool) -> Result<Lined> {
        let placed = outside.placed();
        let (Some(surface), Some(problem)) = (placed.solved().fourier(), outside.problem()) else {
            let message = "a lining of its own takes a surface between two curves: expected such a shape, or no lining";
            let error = Error::new(Code::UnsupportedShape, placed.path("wall.lining"), message);
            return Err(error.with("what", "no-lining"));
        };
        let maker = Maker::new(outside, surface, problem, lining);
        let step = if is_closely { STEP } else { 2.0 * STEP } * wall.thickness;
        let of_outside = Samples::of(outside, step);
        let cloud = Cloud::new(&of_outside);
        let search = Search { maker: &maker, outside: &of_outside, cloud: &cloud, floor, thickness: wall.thickness };
        let mut drawn = search.drawn()?;
        let mut proof = None;
        if is_closely {
            let Some(mut cells) = Cells::of(outside, wall.thickness) else {
                return Err(maker.no_room(0.5, "it is not known how far it is from the outside"));
            };
            let boxes = Nearby::of(&cells);
            proof = Some(search.proven(&mut drawn, &mut cells, &boxes)?);
        }
        let skin = maker.skin(&drawn, floor)?;
        let samples = search.samples(&skin);
        let apart = search.apart(&samples, proof.map_or(0.0, |proof| proof.bound));
        let cloud = Cloud::new(&samples);
        Ok(Lined { skin: Arc::new(skin), apart, samples, cloud })
    }

    /// The lining as a surface from foot to rim.
    pub(super) fn skin(&self) -> &Arc<Skin> {
        &self.skin
    }

    /// How far a point is from it: from the nearest of its samples on to where it is nearest, by the method of Gauss and Newton.
    pub(super) fn distance(&self, at: DVec3) -> f64 {
        let (square, number) = self.cloud.nearest(at);
        let ([mut s, mut v], mut least) = (self.samples.place(number), square);
        for _ in 0..STEPS {
            let jet = self.skin.second(s, v);
            let way = at - jet.position;
            let (e, f, g) = (jet.du.length_squared(), jet.du.dot(jet.dv), jet.dv.length_squared());
            let (a, b, area) = (way.dot(jet.du), way.dot(jet.dv), e * g - f * f);
            let next = ((s + (g * a - f * b) / area).clamp(0.0, 1.0), v + (e * b - f * a) / area);
            let square = self.skin.second(next.0, next.1).position.distance_squared(at);
            if !(square < least) {
                break;
            }
            ((s, v), least) = (next, square);
        }
        libm::sqrt(least)
    }

    /// How far it is from the outside.
    pub(super) fn apart(&self) -> &Distances {
        &self.apart
    }
}

/// What of a lining is sought.
struct Search<'a> {
    maker: &'a Maker<'a>,
    /// Samples of the outside.
    outside: &'a Samples,
    cloud: &'a Cloud,
    floor: f64,
    thickness: f64,
}

impl Search<'_> {
    fn samples(&self, skin: &Skin) -> Samples {
        let columns = PER_WAVE * libm::ceil(self.maker.outside.waves()) as usize;
        Samples::even(skin, ROWS, columns.clamp(COLUMNS, MOST_COLUMNS))
    }

    /// The distance of a point from the outside; less than 0 where it is not inside.
    fn distance(&self, at: DVec3) -> f64 {
        let (square, _, is_outside) = self.outside.from(self.cloud, at);
        libm::sqrt(square) * if is_outside { -1.0 } else { 1.0 }
    }

    /// The places of what leads from where a lining begins straight to the floor; none where it begins below it.
    fn led(&self, samples: &Samples) -> Vec<DVec3> {
        let frame = self.maker.outside.frame();
        if self.maker.outside.poles()[0] || self.floor == f64::NEG_INFINITY {
            return Vec::new();
        }
        let starts = samples.points[..samples.columns].iter();
        let led = starts.flat_map(|start| {
            let way = frame.axis() * (self.floor - frame.level(*start)).min(0.0);
            (1..=STEPS_DOWN).map(move |i| *start + way * (i as f64 / STEPS_DOWN as f64))
        });
        if samples.points[..samples.columns].iter().any(|start| frame.level(*start) > self.floor) {
            led.collect()
        } else {
            Vec::new()
        }
    }

    /// Draws a lining in until its samples are far enough from the outside, and no further than it takes.
    fn drawn(&self) -> Result<Drawn> {
        let Search { maker, floor, thickness, .. } = *self;
        let frame = maker.outside.frame();
        let asked = thickness * (1.0 + SPARE);
        // What is next to where it begins counts too.
        let from = floor - 2.0 * STEP * thickness;
        let mut drawn = Drawn { rings: vec![asked + maker.unevenness(self.outside); BAYS + 1], foot: 0.0 };
        let mut round = 0;
        loop {
            watch::go_on()?;
            let samples = self.samples(&maker.skin(&drawn, floor)?);
            // By how much each ring has to be moved for what it moves.
            let mut missing = vec![f64::NEG_INFINITY; BAYS + 1];
            let counts = samples.points.iter().enumerate().filter(|(_, point)| frame.level(**point) >= from);
            let mut place = None;
            for (k, point) in counts {
                let lacks = asked - self.distance(*point);
                if place.is_none_or(|(most, _)| lacks > most) {
                    place = Some((lacks, *point));
                }
                for (number, missing) in missing.iter_mut().enumerate() {
                    if maker.moves(number, samples.place(k)[0]) {
                        *missing = missing.max(lacks);
                    }
                }
            }
            let Some((worst, at)) = place else {
                return Err(maker.no_room(0.0, "the floor is above all of it"));
            };
            let led = self.led(&samples).into_iter().map(|point| (asked - self.distance(point), point));
            let led = led.fold((f64::NEG_INFINITY, at), |most, here| if here.0 > most.0 { here } else { most });
            let is_close = missing.iter().all(|lacks| *lacks == f64::NEG_INFINITY || *lacks >= -CLOSE * thickness);
            let is_thick = worst <= 0.0 && led.0 <= 0.0;
            if is_thick && (round >= BOTH_WAYS || is_close) {
                return Ok(drawn);
            }
            if round >= ROUNDS {
                if worst.max(led.0) > SPARE * thickness {
                    let at = if worst >= led.0 { at } else { led.1 };
                    return Err(maker.no_room_at(at, "it comes too near to the outside"));
                }
                return Ok(drawn);
            }
            drawn.foot += 1.02 * led.0.max(0.0);
            for (drawn, missing) in drawn.rings.iter_mut().zip(missing).filter(|(_, missing)| missing.is_finite()) {
                if missing > 0.0 {
                    *drawn += 1.02 * missing;
                } else if round < BOTH_WAYS {
                    *drawn = (*drawn + 0.8 * missing).max(0.0);
                }
            }
            round += 1;
        }
    }

    /// Draws it in further until that is proven of all of it.
    fn proven(&self, drawn: &mut Drawn, outside: &mut Cells, boxes: &Nearby) -> Result<Proof> {
        const WHY: &str = "it cannot be shown to keep far enough from the outside";
        let Search { maker, floor, thickness, .. } = *self;
        let mut budget = Budget::new();
        let mut round = 0;
        loop {
            watch::go_on()?;
            let skin = maker.skin(drawn, floor)?;
            let mut proof = |cells: Option<Cells>, outside: &mut Cells| {
                let Some(mut cells) = cells else { return Ok(Proof::none(thickness)) };
                let found = proven(&mut cells, outside, boxes, (thickness, floor), &mut budget);
                found.map_err(|at| maker.no_room_at(at, WHY))
            };
            let found = proof(Cells::of(&skin, thickness), outside)?;
            let led = self.led(&self.samples(&skin)).is_empty();
            let below = if led { None } else { Some(proof(Cells::led(&skin, floor, thickness), outside)?) };
            let lacks = |proof: &Proof| thickness - proof.bound;
            let worst = below.as_ref().map_or(0.0, lacks).max(lacks(&found));
            if worst <= 0.0 {
                return Ok(found);
            }
            if round >= RAISED {
                let at = found.at.or(below.and_then(|below| below.at));
                return Err(at.map_or_else(|| maker.no_room(0.5, WHY), |at| maker.no_room_at(at, WHY)));
            }
            drawn.foot += MORE * below.as_ref().map_or(0.0, lacks);
            for (number, drawn) in drawn.rings.iter_mut().enumerate() {
                let near = found.lacks().filter(|(s, _)| maker.moves(number, *s));
                *drawn += MORE * near.fold(0.0f64, |most, (_, lack)| most.max(lack));
            }
            round += 1;
        }
    }

    /// Of each sample of a lining whether it is there: as in its sheet, a column begins where it is below the floor for the last time.
    fn are_there(&self, samples: &Samples) -> Vec<bool> {
        let frame = self.maker.outside.frame();
        let mut are_there = vec![false; samples.points.len()];
        for column in 0..samples.columns {
            let upwards = (column..samples.points.len()).step_by(samples.columns);
            for k in upwards.rev().take_while(|k| frame.level(samples.points[*k]) >= self.floor) {
                are_there[k] = true;
            }
        }
        are_there
    }

    /// How far the samples that are there are from the outside.
    fn apart(&self, samples: &Samples, bound: f64) -> Distances {
        let mut least = (f64::INFINITY, DVec3::ZERO);
        let mut all = vec![f64::NAN; samples.points.len()];
        let mut greatest = (0.0f64, 0);
        let are_there = self.are_there(samples);
        for (k, point) in samples.points.iter().enumerate().filter(|(k, _)| are_there[*k]) {
            all[k] = self.distance(*point).abs();
            if all[k] < least.0 {
                least = (all[k], *point);
            }
            if all[k] > greatest.0 {
                greatest = (all[k], k);
            }
        }
        for point in self.led(samples) {
            let distance = self.distance(point).abs();
            if distance < least.0 {
                least = (distance, point);
            }
        }
        let n = samples.columns;
        let (i, j) = (greatest.1 / n, greatest.1 % n);
        let rows = i.saturating_sub(1)..=(i + 1).min(samples.rows.len() - 1);
        let beside = rows.flat_map(|i| [n - 1, 0, 1].map(|step| all[i * n + (j + step) % n]));
        let apart = beside.filter(|here| here.is_finite()).fold(0.0f64, |most, here| most.max(greatest.0 - here));
        Distances { least, bound: bound.min(least.0), greatest: (greatest.0, apart) }
    }
}

/// What linings of one surface are made from.
struct Maker<'a> {
    outside: &'a Skin,
    surface: &'a Surface,
    problem: &'a BoundaryValue,
    waves: f64,
    /// The factors of the placement along the axes of the shape.
    scale: [f64; 3],
    /// Whether the circle goes round clockwise.
    is_mirrored: bool,
    stations: Vec<Station>,
}

impl<'a> Maker<'a> {
    fn new(outside: &'a Skin, surface: &'a Surface, problem: &'a BoundaryValue, lining: Lining) -> Maker<'a> {
        let matrix = outside.placed().matrix();
        let scale = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(DVec3::length);
        let waves = f64::from(lining.waves);
        let mut maker = Maker { outside, surface, problem, waves, scale, is_mirrored: false, stations: Vec::new() };
        let (mut one, mut other) = (0.0, 0.0);
        for i in 0..=BAYS {
            let [p, q] = maker.circles(i as f64 / BAYS as f64);
            one += p.length();
            other += q.length();
        }
        maker.is_mirrored = other > one;
        let is_rising = maker.profile(1.0).1 >= maker.profile(0.0).1;
        let poles = outside.poles();
        let end_is_pole = |u: f64| {
            let s = if outside.is_upward() { u } else { 1.0 - u };
            (s == 0.0 && poles[0]) || (s == 1.0 && poles[1])
        };
        maker.stations = (0..=BAYS)
            .map(|i| {
                let u = i as f64 / BAYS as f64;
                let [p, q] = maker.circles(u);
                let (round, oval) = if maker.is_mirrored { (q, p) } else { (p, q) };
                let (low, high) = (maker.profile((u - REACH).max(0.0)), maker.profile((u + REACH).min(1.0)));
                let along = DVec2::new(high.0 - low.0, high.1 - low.1) * if is_rising { 1.0 } else { -1.0 };
                let along = if end_is_pole(u) { DVec2::new(along.x, 0.0) } else { along };
                let tangent = along.normalize_or(DVec2::Y);
                Station { round, oval: oval.length(), normal: DVec2::new(tangent.y, -tangent.x), tangent }
            })
            .collect();
        maker
    }

    /// Of one component the factors of `cos nv` and `sin nv` at `u`, and their slopes.
    fn factors(&self, axis: usize, n: f64, u: f64) -> [[f64; 2]; 2] {
        let mut sum = [[0.0; 2]; 2];
        for term in self.surface.components()[axis].iter().filter(|term: &&Term| term.n.abs() == n) {
            let [a, b] = term.slopes(u);
            let sign = if term.n < 0.0 { -1.0 } else { 1.0 };
            for order in [0, 1] {
                sum[0][order] += a[order];
                sum[1][order] += sign * b[order];
            }
        }
        sum
    }

    /// What goes round once, as `p e^(iv) + q e^(-iv)` with `x + iy` in the units of the placement.
    fn circles(&self, u: f64) -> [DVec2; 2] {
        let [xc, xs] = self.factors(0, 1.0, u).map(|f| f[0] * self.scale[0]);
        let [yc, ys] = self.factors(1, 1.0, u).map(|f| f[0] * self.scale[1]);
        [DVec2::new(xc + ys, yc - xs) * 0.5, DVec2::new(xc - ys, yc + xs) * 0.5]
    }

    /// Radius and height of the mean profile.
    fn profile(&self, u: f64) -> (f64, f64) {
        let [p, q] = self.circles(u);
        let round = if self.is_mirrored { q } else { p };
        (round.length(), self.factors(2, 0.0, u)[0][0] * self.scale[2])
    }

    /// How far the outside is from what of it the lining keeps, at most.
    fn unevenness(&self, outside: &Samples) -> f64 {
        let radii: Vec<f64> = self.stations.iter().map(|station| station.round.length() - station.oval).collect();
        let frame = self.outside.frame();
        let mut most = 0.0f64;
        for (i, s) in outside.rows.iter().enumerate() {
            let u = if self.outside.is_upward() { *s } else { 1.0 - *s };
            let radius = radii[libm::round(u * BAYS as f64) as usize];
            let row = &outside.points[i * outside.columns..(i + 1) * outside.columns];
            let middle = row.iter().sum::<DVec3>() / row.len() as f64;
            let narrowest = row.iter().map(|p| frame.turned(*p - middle).length()).fold(f64::INFINITY, f64::min);
            most = most.max(radius - narrowest);
        }
        most.max(0.0)
    }

    /// Whether a ring has a say at a place from foot to rim.
    fn moves(&self, ring: usize, s: f64) -> bool {
        let u = if self.outside.is_upward() { s } else { 1.0 - s };
        (u * BAYS as f64 - ring as f64).abs() <= 1.5
    }

    /// The lining with its rings drawn in so far.
    fn skin(&self, drawn: &Drawn, floor: f64) -> Result<Skin> {
        let mut shifts = Vec::with_capacity(BAYS + 1);
        for (i, station) in self.stations.iter().enumerate() {
            let by = drawn.at(i);
            let u = i as f64 / BAYS as f64;
            let s = if self.outside.is_upward() { u } else { 1.0 - u };
            let mut shift = station.normal * -by;
            if s == 0.0 && station.normal.x > 0.0 {
                // Along itself until it is level with the foot.
                let share = ((station.normal.x - UPRIGHT[0]) / (UPRIGHT[1] - UPRIGHT[0])).clamp(0.0, 1.0);
                let share = share * share * (3.0 - 2.0 * share);
                shift -= station.tangent * (share * shift.y / station.tangent.y.max(UPRIGHT[0]));
            }
            if s == 0.0 {
                shift.x -= drawn.foot;
            }
            let radius = station.round.length();
            let width = radius + shift.x - station.oval;
            let least = LEAST * self.outside.size();
            if radius > least && width < least {
                let at = self.outside.middle(s);
                if self.outside.frame().level(at) >= floor || radius - station.oval < least {
                    return Err(self.no_room(u, "nothing would be left inside"));
                }
                // Beneath the floor it is cut off.
                shift.x = least + station.oval - radius;
            }
            let direction = if radius > 0.0 { station.round / radius } else { DVec2::ZERO };
            shifts.push((direction * shift.x, shift.y));
        }
        let problem = self.problem_of(&shifts);
        let path = self.outside.placed().path("wall.lining");
        let surface = Surface::solve(&problem, &path).map_err(|error| error.at(path.clone()))?;
        let placed = Arc::new(self.outside.placed().beside(Solved::TwoSided(Box::new(surface))));
        Skin::beside(&placed, self.outside).map_err(|_| self.no_room(0.5, "nothing would be left inside"))
    }

    /// The boundary-value problem of the lining.
    fn problem_of(&self, shifts: &[(DVec2, f64)]) -> BoundaryValue {
        // Rim and foot go up and down as those of the outside do, and what is between goes with them.
        let most = [self.waves + 1.0, self.waves + 1.0, f64::INFINITY];
        let mut components = [&self.problem.x, &self.problem.y, &self.problem.z].map(smoothed);
        for (axis, component) in components.iter_mut().enumerate() {
            let own = if axis == 2 { 0.0 } else { 1.0 };
            let mut harmonics: Vec<f64> =
                self.surface.components()[axis].iter().map(|term| term.n.abs()).filter(|n| *n <= most[axis]).collect();
            harmonics.push(own);
            harmonics.sort_by(f64::total_cmp);
            harmonics.dedup();
            let free = component.free;
            component.modes = harmonics
                .into_iter()
                .map(|n| {
                    let shift = |i: usize| if n == own { self.shift(axis, shifts[i]) } else { [0.0; 2] };
                    let factors: Vec<[[f64; 2]; 2]> =
                        (0..=BAYS).map(|i| self.factors(axis, n, i as f64 / BAYS as f64)).collect();
                    let datum = |which: usize| {
                        let value = |i: usize| factors[i][which][0] + shift(i)[which];
                        // The slope of the parabola through the three shifts next to an end.
                        let slope = |[a, b, c]: [usize; 3], sign: f64| {
                            let [a, b, c] = [a, b, c].map(|i| shift(i)[which]);
                            sign * BAYS as f64 * (2.0 * b - 1.5 * a - 0.5 * c)
                        };
                        let start_u = factors[0][which][1] + slope([0, 1, 2], 1.0);
                        let end_u = factors[BAYS][which][1] + slope([BAYS, BAYS - 1, BAYS - 2], -1.0);
                        Datum {
                            start: value(0),
                            end: value(BAYS),
                            start_u: if free.start { 0.0 } else { start_u },
                            end_u: if free.end { 0.0 } else { end_u },
                            rings: (1..BAYS).map(value).collect(),
                            force: Vec::new(),
                        }
                    };
                    let sin = if n == 0.0 { Datum::default() } else { datum(1) };
                    Mode { n, cos: datum(0), sin }
                })
                .collect();
        }
        let [x, y, z] = components;
        let rings = (1..BAYS).map(|i| Ring { u: i as f64 / BAYS as f64, sharp: false }).collect();
        BoundaryValue { span: self.problem.span, rings, x, y, z }
    }

    /// What a shift is of the factors of cosine and sine of a component, in the units of the shape.
    fn shift(&self, axis: usize, (round, up): (DVec2, f64)) -> [f64; 2] {
        let turn = if self.is_mirrored { -1.0 } else { 1.0 };
        let [cos, sin] = match axis {
            0 => [round.x, -turn * round.y],
            1 => [round.y, turn * round.x],
            _ => [up, 0.0],
        };
        [cos / self.scale[axis], sin / self.scale[axis]]
    }

    fn no_room(&self, u: f64, why: &str) -> Error {
        let s = if self.outside.is_upward() { u } else { 1.0 - u };
        self.no_room_at(self.outside.middle(s), why)
    }

    fn no_room_at(&self, at: DVec3, why: &str) -> Error {
        let message = format!(
            "the lining has no room at {}: {why}; expected a thinner wall, a lining of more than {} waves, or none",
            place(at),
            plain(self.waves)
        );
        let error = Error::new(Code::NoRoom, self.outside.placed().path("wall.lining"), message);
        error.near(at.to_array()).with("what", "lining").with("waves", self.waves)
    }
}

/// The equation of a component, squared where it is of order 2: `(s d^2/du^2 - t k^2)^2`. What solves the one solves the other.
fn smoothed(component: &Component) -> Component {
    let Component { order, s, t, w, free, .. } = *component;
    let [s, t, w] = match order {
        Order::Second => [s * s, 2.0 * s * t, t * t],
        Order::Fourth => [s, t, w],
    };
    let free = if order == Order::Second { Free::default() } else { free };
    Component { order: Order::Fourth, s, t, w, free, modes: Vec::new() }
}
