//! A scan of a pot that stands upright, level by level.

use core::f64::consts::TAU;
use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use super::handle::without_handle;
use super::section::{DIRECTIONS, Section, bridged};
use crate::design::plain;
use crate::error::{Code, Error, Result};

/// A scan of a pot that stands upright, level by level: how far its outside is from the axis in every direction. Inside and floor are not looked at.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Levels {
    /// Where the axis is, in the scan: x and y.
    pub axis: [f64; 2],
    /// The lowest point of the scan.
    pub bottom: f64,
    /// How high the scan is, with what is not closed all round.
    pub height: f64,
    /// Of the levels above the bottom, from the foot to the rim.
    pub heights: Vec<f64>,
    /// For each of them the distance from the axis in 180 directions, one every two degrees from that of x.
    pub radii: Vec<Vec<f64>>,
    /// The share of all these places where the scan has a hole, and the wall goes on as it does to either side.
    pub holes: f64,
}

impl Levels {
    /// Each level is looked at in so many directions.
    pub const DIRECTIONS: usize = DIRECTIONS;

    /// Rings are fitted to so many levels at most.
    pub const MOST: usize = 1000;

    /// About the z axis, above 0, and as high as the highest level.
    ///
    /// ```
    /// let levels = pasu::Levels::new(vec![0.0, 1.0], vec![vec![3.0; 180]; 2]);
    /// assert_eq!(levels.height, 1.0);
    /// ```
    pub fn new(heights: Vec<f64>, radii: Vec<Vec<f64>>) -> Levels {
        let height = heights.last().copied().unwrap_or_default();
        Levels { axis: [0.0; 2], bottom: 0.0, height, heights, radii, holes: 0.0 }
    }

    /// # Errors
    /// What [`fit_levels`](super::fit_levels) says of levels that are none.
    pub(super) fn check(&self) -> Result<()> {
        let Levels { axis, bottom, height, heights, radii, .. } = self;
        let n = heights.len();
        if n < 2 || n != radii.len() {
            let message =
                format!("expected two levels or more with a section for each, found {n} with {}", radii.len());
            return Err(Error::new(Code::WrongType, "heights", message));
        }
        if n > Levels::MOST {
            let message = format!("expected at most {} levels, found {n}", Levels::MOST);
            return Err(Error::new(Code::TooLarge, "heights", message).with("greatest", Levels::MOST).with("found", n));
        }
        let wrong = |path: String, expected: &str, found: f64| {
            let message = format!("expected {expected}, found {}", plain(found));
            let code = if found.is_finite() { Code::OutOfRange } else { Code::NotFinite };
            Err(Error::new(code, path, message))
        };
        for (name, value) in [("axis[0]", axis[0]), ("axis[1]", axis[1]), ("bottom", *bottom), ("height", *height)] {
            if !value.is_finite() {
                return wrong(name.into(), "a finite number", value);
            }
        }
        for (i, at) in heights.iter().enumerate() {
            let rises = i.checked_sub(1).is_none_or(|before| heights[before] < *at);
            if !(at.is_finite() && rises) {
                return wrong(format!("heights[{i}]"), "a finite height above the one before", *at);
            }
        }
        for (i, section) in radii.iter().enumerate() {
            if section.len() != DIRECTIONS {
                let message = format!("expected {DIRECTIONS} distances, found {}", section.len());
                return Err(Error::new(Code::WrongType, format!("radii[{i}]"), message));
            }
            if let Some(k) = section.iter().position(|radius| !(*radius > 0.0 && radius.is_finite())) {
                return wrong(format!("radii[{i}][{k}]"), "a finite distance greater than 0", section[k]);
            }
        }
        Ok(())
    }
}

const LEVELS: usize = 160;

/// Levels keep off the very foot and the very rim by this part of a gap, where a scan is level and has no section.
const INSET: f64 = 0.25;

/// So many levels at least go all round.
const FEWEST: usize = 24;

/// The axis is where sections have their middle; a few rounds find it.
const ROUNDS: usize = 3;

/// A level is whole if no more than ten degrees of it are missing, as at a slit.
const SLIT: usize = DIRECTIONS / 36;

/// Between whole levels up to a quarter of the turn may be missing of one.
const HOLE: usize = DIRECTIONS / 4;

/// A section in which holes are bridged, and in how many directions it had none of the scan.
struct Level {
    section: Section,
    n_missing: usize,
}

impl Level {
    fn of(section: Section) -> Level {
        let missing: BTreeSet<usize> = (0..DIRECTIONS).filter(|k| !(section[*k] > 0.0)).collect();
        let n_missing = missing.len();
        let section = if (1..=HOLE).contains(&n_missing) { bridged(&section, &missing) } else { section };
        Level { section, n_missing }
    }

    fn is_whole(&self) -> bool {
        self.n_missing <= SLIT
    }
}

/// Of triangles; nothing where too few levels are closed round an axis.
pub(super) fn of_triangles(triangles: &[[DVec3; 3]]) -> Option<Levels> {
    let points = || triangles.iter().flatten().copied();
    let low = points().reduce(DVec3::min)?;
    let high = points().reduce(DVec3::max)?;
    let (bottom, height) = (low.z, high.z - low.z);
    if !(height > 0.0) {
        return None;
    }
    let place = |i: usize| height * (i as f64 + INSET) / ((LEVELS - 1) as f64 + 2.0 * INSET);
    let all: Vec<f64> = (0..LEVELS).map(place).collect();
    let mut axis = 0.5 * (low + high).truncate();
    let at = |axis: DVec2| -> Vec<Level> { cut(triangles, axis, bottom, &all).into_iter().map(Level::of).collect() };
    let mut levels = at(axis);
    for _ in 0..ROUNDS {
        let whole: Vec<Section> =
            levels.iter().filter(|level| level.is_whole()).map(|level| level.section.clone()).collect();
        axis += middle_of(&without_handle(&whole).unwrap_or(whole))?;
        levels = at(axis);
    }
    // What is not closed all round, at a broken or slanting foot or rim, is left out: the pot is between whole levels, with holes in its wall at most.
    let first = levels.iter().position(Level::is_whole)?;
    let mut within: Vec<Level> = levels.into_iter().skip(first).take_while(|level| level.n_missing <= HOLE).collect();
    within.truncate(within.iter().rposition(Level::is_whole)? + 1);
    let n = within.len();
    let n_missing: usize = within.iter().map(|level| level.n_missing).sum();
    let n_whole = within.iter().filter(|level| level.is_whole()).count();
    (n_whole > FEWEST).then(|| Levels {
        axis: axis.to_array(),
        bottom,
        height,
        heights: all[first..first + n].to_vec(),
        radii: within.into_iter().map(|level| level.section).collect(),
        holes: n_missing as f64 / (n * DIRECTIONS) as f64,
    })
}

/// How far the middles of sections are from where the axis was taken to be: a circle beside the axis has a wave that goes round once, and little else has.
fn middle_of(whole: &[Section]) -> Option<DVec2> {
    let direction = |k: usize| {
        let angle = TAU * k as f64 / DIRECTIONS as f64;
        DVec2::new(libm::cos(angle), libm::sin(angle))
    };
    let of_section = |section: &Section| -> DVec2 { (0..DIRECTIONS).map(|k| direction(k) * section[k]).sum() };
    let sum: DVec2 = whole.iter().map(of_section).sum();
    (!whole.is_empty()).then(|| sum * (2.0 / (DIRECTIONS * whole.len()) as f64))
}

/// The outermost crossing of every triangle with each level and direction; 0 where there is none.
fn cut(triangles: &[[DVec3; 3]], axis: DVec2, bottom: f64, heights: &[f64]) -> Vec<Section> {
    let mut sections = vec![vec![0.0; DIRECTIONS]; heights.len()];
    let (low, gap) = (heights[0], heights[1] - heights[0]);
    for triangle in triangles {
        let z = triangle.map(|corner| corner.z - bottom);
        let (least, most) = (z[0].min(z[1]).min(z[2]), z[0].max(z[1]).max(z[2]));
        let from = libm::ceil((least - low) / gap).max(0.0) as usize;
        let to = libm::floor((most - low) / gap);
        for level in (from..heights.len()).take_while(|level| *level as f64 <= to) {
            let at = heights[level];
            let mut ends = Vec::with_capacity(2);
            for (k, l) in [(0, 1), (1, 2), (2, 0)] {
                if (z[k] < at) != (z[l] < at) {
                    let share = (at - z[k]) / (z[l] - z[k]);
                    ends.push(triangle[k].truncate().lerp(triangle[l].truncate(), share) - axis);
                }
            }
            if let [from, to] = ends[..] {
                mark(&mut sections[level], from, to);
            }
        }
    }
    sections
}

/// A piece is seen beside its ends too, over this part of the gap to the next direction: two that meet in a direction would both be beside it by rounding.
const BESIDE: f64 = 0.01;

/// Marks the directions in which a straight piece is seen from the axis, the short way round.
fn mark(section: &mut [f64], from: DVec2, to: DVec2) {
    let step = TAU / DIRECTIONS as f64;
    let begin = libm::atan2(from.y, from.x);
    let turn = libm::atan2(from.perp_dot(to), from.dot(to));
    let (low, high) = if turn < 0.0 { (begin + turn, begin) } else { (begin, begin + turn) };
    let (low, high) = (low - BESIDE * step, high + BESIDE * step);
    let first = libm::ceil(low / step);
    for k in (0..=DIRECTIONS).map(|k| first + k as f64).take_while(|k| k * step <= high) {
        let direction = DVec2::new(libm::cos(k * step), libm::sin(k * step));
        let across = direction.perp_dot(to - from);
        if across != 0.0 {
            let radius = from.perp_dot(to - from) / across;
            let place = (k as i64).rem_euclid(DIRECTIONS as i64) as usize;
            section[place] = section[place].max(radius);
        }
    }
}
