//! How far a scan is from a pot of rings: of points of the scan's outside, the way along radius and height in the plane through the axis.

use glam::DVec2;

use super::levels::Levels;
use super::section::{DIRECTIONS, Section};
use crate::patch::{Patch, Spread};
use crate::surface::Surface;

/// Rows and columns at which the pot is read.
const ROWS: usize = 240;
const COLUMNS: usize = 60;

/// What was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Off {
    /// The root of the mean of the squares.
    pub(super) rms: f64,
    pub(super) most: f64,
}

/// How far the outside is from the surface, which stands on 0 about the axis; `sections` are those of the levels, or what is taken for them.
pub(super) fn off(levels: &Levels, sections: &[Section], surface: &Surface) -> Off {
    let places: Vec<f64> = (0..COLUMNS).map(|k| k as f64 / COLUMNS as f64).collect();
    let columns = surface.columns(Spread::At(&places));
    let mut lines = vec![Vec::new(); COLUMNS];
    for i in 0..=ROWS {
        let row = Patch::row(surface, i as f64 / ROWS as f64);
        for (k, line) in lines.iter_mut().enumerate() {
            let point = row.jet_at(&columns, k).position;
            line.push(DVec2::new(point.truncate().length(), point.z));
        }
    }
    let (mut squares, mut most) = (0.0, 0.0f64);
    for (k, line) in lines.iter().enumerate() {
        for (height, section) in levels.heights.iter().zip(sections) {
            let squared = nearest(line, DVec2::new(section[k * DIRECTIONS / COLUMNS], *height));
            squares += squared;
            most = most.max(squared);
        }
    }
    let n = (levels.heights.len() * COLUMNS).max(1);
    Off { rms: libm::sqrt(squares / n as f64), most: libm::sqrt(most) }
}

/// Columns go round by equal angles: the surface is one of rings, whose sections go round by `v`.
const _: () = assert!(DIRECTIONS.is_multiple_of(COLUMNS));

/// The square of the distance of a point from a line of straight pieces.
fn nearest(line: &[DVec2], point: DVec2) -> f64 {
    let to_piece = |pair: &[DVec2]| {
        let along = pair[1] - pair[0];
        let whole = along.length_squared();
        let share = if whole > 0.0 { ((point - pair[0]).dot(along) / whole).clamp(0.0, 1.0) } else { 0.0 };
        (pair[0] + along * share).distance_squared(point)
    };
    line.windows(2).map(to_piece).fold(f64::INFINITY, f64::min)
}
