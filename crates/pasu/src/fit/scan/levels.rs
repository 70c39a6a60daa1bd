//! A scan of a pot that stands upright, level by level.

use core::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::handle::without_handle;
use super::section::{DIRECTIONS, Section};

/// A scan by how far its outside is from the axis. Inside and floor are not looked at.
#[derive(Debug, Clone)]
pub(super) struct Levels {
    pub(super) axis: DVec2,
    /// The lowest point.
    pub(super) bottom: f64,
    /// Above that, from the foot to the rim.
    pub(super) heights: Vec<f64>,
    pub(super) sections: Vec<Section>,
}

const LEVELS: usize = 160;

/// Levels keep off the very foot and the very rim by this part of a gap, where a scan is level and has no section.
const INSET: f64 = 0.25;

/// So many levels at least go all round.
const FEWEST: usize = 24;

/// The axis is where sections have their middle; a few rounds find it.
const ROUNDS: usize = 3;

/// Of triangles; nothing where too few levels are closed round an axis.
pub(super) fn levels(triangles: &[[DVec3; 3]]) -> Option<Levels> {
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
    let mut sections = cut(triangles, axis, bottom, &all);
    for _ in 0..ROUNDS {
        let whole: Vec<Section> = sections.iter().filter(|section| is_whole(section)).cloned().collect();
        axis += middle_of(&without_handle(&whole).unwrap_or(whole))?;
        sections = cut(triangles, axis, bottom, &all);
    }
    // What is not closed all round, at a broken or slanting rim, is left out; from there on the pot ends.
    let first = sections.iter().position(|section| is_whole(section))?;
    let n = sections[first..].iter().take_while(|section| is_whole(section)).count();
    let within = first..first + n;
    (n > FEWEST).then(|| Levels {
        axis,
        bottom,
        heights: all[within.clone()].to_vec(),
        sections: sections[within].to_vec(),
    })
}

fn is_whole(section: &[f64]) -> bool {
    section.iter().all(|radius| *radius > 0.0)
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
