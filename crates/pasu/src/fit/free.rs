//! A part of a design as rings.

use std::rc::Rc;

use glam::DVec3;

use super::contract::{Ringed, check_tolerance, too_fine};
use super::digits::{decimal, to_multiple};
use super::sections::{Sample, Section, Sections};
use super::series::series;
use crate::design::{Design, Hoop, RINGS, Rings, Series, Shape, Slopes, rounded};
use crate::error::{Code, Error, Result};
use crate::patch::{Columns, Patch, Spread};
use crate::solution::Solution;
use crate::surface::Surface;

/// Waves of a ring leave out this part of the tolerance; the rest is for what lies between rings.
const UNSEEN: f64 = 0.1;

/// Rounding all numbers of a ring together takes this part of it.
const ROUNDED: f64 = 0.1;

/// The least tolerance, in parts of the size: documents have twelve digits.
const FINEST: f64 = 1e-9;

/// Waves of a ring that are looked for: at first and at most.
const FIRST_WAVES: usize = 8;
const MOST_WAVES: usize = 256;

/// Samples round the axis for each wave that is looked for.
const SAMPLES: usize = 4;

/// At how many places from one ring to the next both surfaces are held against each other, the first of them among these: while rings are looked for, and before they are told; and at how many in all then, where rings are few.
const ROWS: usize = 4;
const FINE_ROWS: usize = 16;
const FINE_ROWS_IN_ALL: usize = 128;

/// Between so many places it may be further off than at them by this part.
const UNSEEN_BETWEEN: f64 = 0.01;

/// Where it is off by less than this part of the most, a ring elsewhere helps more.
const WORTH: f64 = 1.0 / 16.0;

/// The design with part `part` as a pot of `rings`, no further from what it was than a tolerance in the unit of the design, where it stands, as far as can be seen on a grid.
///
/// Radius and height are read off by the angle round the axis, so that a pot can be freed whose sections go round the axis once without turning back. Rings are put where the surface is furthest off between two of them, until
/// nowhere it is further than the tolerance; the smoothing parameter stays that of a dint vase, and is 1 otherwise. Wall, placement and look stay. A pot of rings stays as it is.
///
/// ```
/// use pasu::{Design, Shape, free};
///
/// let freed = free(&Design::parse("#1/fourth-order")?, 0, 0.001)?;
/// let Shape::Rings(pot) = &freed.design.parts()[0].shape else { unreachable!() };
/// assert!(freed.distance <= 0.001 && pot.rings.len() < 8);
/// # Ok::<(), pasu::Error>(())
/// ```
///
/// # Errors
/// `no-such-point` for a part that does not exist; `out-of-range` for a tolerance that is not above 0; `tolerance-too-fine` where 66 rings, or 256 waves, are not enough; `unsupported-shape` where a section does not go round the
/// axis once; what [`Surface::solve`](crate::Surface::solve) refuses.
pub fn free(design: &Design, part: usize, tolerance: f64) -> Result<Ringed> {
    check_tolerance(tolerance)?;
    let solution = Solution::of(design);
    let placed = solution.part(part)?;
    let unable = |what: &str, why: &str| {
        let message = format!("this cannot be said by rings: {why}");
        Error::new(Code::UnsupportedShape, format!("parts[{part}].shape"), message).with("what", what)
    };
    let a = match &design.parts()[part].shape {
        Shape::Rings(_) => return Ok(Ringed { design: design.clone(), distance: 0.0 }),
        Shape::BloorWilson(vase) => vase.a,
        _ => 1.0,
    };
    let surface = placed.solved().fourier().ok_or_else(|| unable("no-ends", "it is no surface between two ends"))?;
    if !surface.is_closed() {
        return Err(unable("open", "the surface does not close round the axis"));
    }
    let sections = Sections::of(surface);
    let matrix = placed.matrix();
    let stretch = [matrix.x_axis, matrix.y_axis, matrix.z_axis].into_iter().map(DVec3::length).fold(0.0, f64::max);
    let finest = FINEST * sections.size() * stretch;
    if tolerance < finest {
        return Err(too_fine(tolerance, finest));
    }
    let found = Search::of(&sections, a, tolerance, stretch).run()?;
    let (rings, distance) = found
        .ok_or_else(|| unable("turns-back", "not every section goes round the axis once, without turning back"))?;
    Ok(Ringed { design: design.with_shape(part, Shape::Rings(rings))?, distance })
}

/// The search for rings and waves that are enough.
struct Search<'a> {
    sections: &'a Sections<'a>,
    a: f64,
    /// Where the part stands.
    tolerance: f64,
    /// How much longer anything may be there than it is in the shape.
    stretch: f64,
    waves: usize,
    /// From 0 to 1, each with whether it is a corner.
    places: Vec<(f64, bool)>,
    /// The sections that were looked at, by place.
    known: Vec<(f64, Rc<Section<'a>>)>,
}

/// How far rings are from the surface that they are to be, where the part stands.
struct Off {
    /// On the rings themselves: what their waves leave out.
    on: f64,
    /// From each ring to the next.
    between: Vec<f64>,
}

impl Off {
    fn distance(&self) -> f64 {
        self.between.iter().fold(self.on, |most, off| most.max(*off))
    }

    fn widened(mut self, factor: f64) -> Off {
        self.between.iter_mut().for_each(|off| *off *= factor);
        self
    }
}

impl<'a> Search<'a> {
    fn of(sections: &'a Sections<'a>, a: f64, tolerance: f64, stretch: f64) -> Search<'a> {
        let waves = (2.0 * sections.waves()).clamp(FIRST_WAVES as f64, MOST_WAVES as f64) as usize;
        let corners = sections.stops().into_iter().filter(|(_, is_corner)| *is_corner);
        let places = core::iter::once((0.0, false)).chain(corners).chain([(1.0, false)]).collect();
        Search { sections, a, tolerance, stretch, waves, places, known: Vec::new() }
    }

    fn run(mut self) -> Result<Option<(Rings, f64)>> {
        loop {
            let Some(rings) = self.rings() else { return Ok(None) };
            let fitted = Surface::solve(&rings.boundary_value(), "")?;
            let Some(mut off) = self.off(&fitted, ROWS) else { return Ok(None) };
            if off.distance() <= self.tolerance {
                let rows = FINE_ROWS.max(FINE_ROWS_IN_ALL.div_ceil(self.places.len() - 1));
                match self.off(&fitted, rows) {
                    Some(finer) => off = finer.widened(1.0 + UNSEEN_BETWEEN),
                    None => return Ok(None),
                }
            }
            let distance = off.distance();
            if distance <= self.tolerance {
                return Ok(Some((rings, distance)));
            }
            if off.on > 0.5 * self.tolerance {
                if self.waves == MOST_WAVES {
                    return Err(too_fine(self.tolerance, distance));
                }
                self.waves = MOST_WAVES.min(2 * self.waves);
                continue;
            }
            self.refine(&off.between, distance);
            if self.places.len() > RINGS + 2 {
                return Err(too_fine(self.tolerance, distance));
            }
        }
    }

    /// The pot with rings at these places.
    fn rings(&mut self) -> Option<Rings> {
        let places = self.places.clone();
        let mut rings = Vec::with_capacity(places.len());
        let mut slopes = Vec::with_capacity(2);
        for (index, (at, sharp)) in places.iter().copied().enumerate() {
            let samples = self.section(at)?.samples(SAMPLES * self.waves);
            let [r, z] = self.series(&samples, [|sample| sample.r, |sample| sample.z], |_| 1.0);
            rings.push(Hoop { u: rounded(at), r, z, sharp });
            let gap = match index {
                0 => places[1].0,
                _ if index + 1 == places.len() => 1.0 - places[index - 1].0,
                _ => continue,
            };
            // What a slope of 1 at an end moves at most until the next ring: of a cubic, and of `u exp(-a n u)`.
            let seen = |n: f64| (gap * 4.0 / 27.0).min(1.0 / (core::f64::consts::E * self.a.abs() * n));
            let [r, z] = self.series(&samples, [|sample| sample.r_u, |sample| sample.z_u], seen);
            slopes.push(Slopes { r, z });
        }
        let mut slopes = slopes.into_iter();
        Some(Rings { a: self.a, rings, foot: slopes.next(), rim: slopes.next() })
    }

    fn series(&self, samples: &[Sample], of: [fn(&Sample) -> f64; 2], seen: impl Fn(f64) -> f64 + Copy) -> [Series; 2] {
        let tolerance = self.tolerance / self.stretch;
        of.map(|of| {
            let numbers: Vec<f64> = samples.iter().map(of).collect();
            let mut series = series(&numbers, self.waves, UNSEEN * tolerance, seen);
            let unit = decimal(ROUNDED * tolerance / (1 + series.waves.len()) as f64);
            let waves = series.waves.iter_mut().flat_map(|wave| [&mut wave.cos, &mut wave.sin]);
            for number in core::iter::once(&mut series.mean).chain(waves) {
                *number = to_multiple(*number, unit);
            }
            series.waves.retain(|wave| wave.cos != 0.0 || wave.sin != 0.0);
            series
        })
    }

    /// The section at a place, followed once.
    fn section(&mut self, at: f64) -> Option<Rc<Section<'a>>> {
        if let Some((_, section)) = self.known.iter().find(|(known, _)| *known == at) {
            return Some(Rc::clone(section));
        }
        let section = Rc::new(self.sections.at(at)?);
        self.known.push((at, Rc::clone(&section)));
        Some(section)
    }

    /// How far rings are from the sections, at the same place along the profile and the same angle: no less than the distance between both surfaces, at these points. Nothing where a section cannot be read.
    fn off(&mut self, fitted: &Surface, rows: usize) -> Option<Off> {
        let n = SAMPLES * self.waves;
        // In between the angles at which the waves are read.
        let halfway: Vec<f64> = (0..n).map(|i| (i as f64 + 0.5) / n as f64).collect();
        let columns = fitted.columns(Spread::At(&halfway));
        let places = self.places.clone();
        let (mut on, mut between) = (0.0f64, Vec::with_capacity(places.len()));
        for pair in places.windows(2) {
            let [from, to] = [pair[0].0, pair[1].0];
            let mut most = 0.0f64;
            for row in 0..rows {
                let off = self.off_at(from + (to - from) * (row as f64 / rows as f64), fitted, &columns, n)?;
                if row == 0 {
                    on = on.max(off);
                } else {
                    most = most.max(off);
                }
            }
            between.push(most);
        }
        Some(Off { on: on.max(self.off_at(1.0, fitted, &columns, n)?), between })
    }

    fn off_at(&mut self, at: f64, fitted: &Surface, columns: &Columns, n: usize) -> Option<f64> {
        let section = self.section(at)?;
        let row = Patch::row(fitted, at);
        let off = |column: usize| {
            let DVec3 { x, y, z } = row.jet_at(columns, column).position;
            let there = section.sample(libm::atan2(y, x));
            libm::hypot(libm::hypot(x, y) - there.r, z - there.z)
        };
        Some((0..n).map(off).fold(0.0, f64::max) * self.stretch)
    }

    fn refine(&mut self, between: &[f64], distance: f64) {
        let mut more = Vec::with_capacity(2 * self.places.len());
        for (pair, off) in self.places.windows(2).zip(between) {
            more.push(pair[0]);
            if *off > self.tolerance && *off >= WORTH * distance {
                more.push((0.5 * (pair[0].0 + pair[1].0), false));
            }
        }
        more.push((1.0, false));
        self.places = more;
    }
}
