//! A curve of a pot along `u` as chords.

use glam::DVec2;

use crate::surface::Surface;

/// A stretch between two rings is looked at in this many parts, each with as many chords as its own bend needs,
const PARTS: usize = 8;

/// and no more than these: fewer than they need are further off.
const MOST: f64 = 64.0;

/// Straight pieces from one place of a curve to another.
pub(super) struct Chords {
    /// Where they begin and end, on the curve.
    pub(super) points: Vec<DVec2>,
    /// No place of the curve is further from its chord than this.
    pub(super) off: f64,
}

impl Chords {
    /// From one ring to the next, within this of the curve where no more than 512 of them are.
    ///
    /// On a step of `h` a curve is within `h^2 |X_uu| / 8` of its chord.
    pub(super) fn of(surface: &Surface, [from, to]: [f64; 2], within: f64, point: impl Fn(f64) -> DVec2) -> Chords {
        let at = |part: usize| if part == PARTS { to } else { from + (to - from) * (part as f64 / PARTS as f64) };
        let mut chords = Chords { points: vec![point(from)], off: 0.0 };
        for part in 0..PARTS {
            let [start, end] = [at(part), at(part + 1)];
            let [bend, ..] = surface.strip_suprema(start, end, [1.0; 3]).along;
            let bend = if bend.is_nan() { f64::INFINITY } else { bend };
            let off = |n: f64| ((end - start) / n) * ((end - start) / n) * bend / 8.0;
            let n = libm::ceil(libm::sqrt(off(1.0) / within)).clamp(1.0, MOST);
            chords.off = chords.off.max(off(n));
            let inner = (1..n as usize).map(|i| start + (end - start) * (i as f64 / n));
            chords.points.extend(inner.chain([end]).map(&point));
        }
        chords
    }
}
