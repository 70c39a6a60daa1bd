//! How far a scan is from a pot of rings: of points of the scan's outside, the way along radius and height in the plane through the axis, and to which side.

use glam::DVec2;

use super::levels::Levels;
use super::section::{DIRECTIONS, Section};
use crate::patch::{Patch, Spread};
use crate::surface::Surface;

/// Rows and columns at which the pot is read.
const ROWS: usize = 240;
const COLUMNS: usize = 60;

/// What was found.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Off {
    /// The root of the mean of the squares.
    pub(super) rms: f64,
    pub(super) most: f64,
    /// Level by level in so many directions as the pot is read in: above 0 outside of it.
    pub(super) away: Vec<f32>,
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
    let mut away = Vec::with_capacity(levels.heights.len() * COLUMNS);
    for (height, section) in levels.heights.iter().zip(sections) {
        for (k, line) in lines.iter().enumerate() {
            let Nearest { squared, inside } = nearest(line, DVec2::new(section[k * DIRECTIONS / COLUMNS], *height));
            squares += squared;
            most = most.max(squared);
            let distance = libm::sqrt(squared) as f32;
            away.push(if inside { -distance } else { distance });
        }
    }
    Off { rms: libm::sqrt(squares / away.len().max(1) as f64), most: libm::sqrt(most), away }
}

/// Columns go round by equal angles: the surface is one of rings, whose sections go round by `v`.
const _: () = assert!(DIRECTIONS.is_multiple_of(COLUMNS));

/// Where a line comes nearest to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Nearest {
    /// The square of the distance.
    squared: f64,
    /// Whether the point is on the left of the line there: of one that goes up, on the side of the axis.
    inside: bool,
}

/// Of a line of straight pieces.
fn nearest(line: &[DVec2], point: DVec2) -> Nearest {
    let mut found = Nearest { squared: f64::INFINITY, inside: false };
    for pair in line.windows(2) {
        let along = pair[1] - pair[0];
        let whole = along.length_squared();
        let share = if whole > 0.0 { ((point - pair[0]).dot(along) / whole).clamp(0.0, 1.0) } else { 0.0 };
        let to = point - (pair[0] + along * share);
        let squared = to.length_squared();
        if squared < found.squared {
            found = Nearest { squared, inside: along.perp_dot(to) > 0.0 };
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_between_a_line_and_the_axis_is_inside() {
        let line = [DVec2::new(3.0, 0.0), DVec2::new(3.0, 2.0), DVec2::new(4.0, 5.0)];
        assert_eq!(nearest(&line, DVec2::new(2.0, 1.0)), Nearest { squared: 1.0, inside: true });
        assert_eq!(nearest(&line, DVec2::new(3.5, 1.0)), Nearest { squared: 0.25, inside: false });
        // Beyond its upper end.
        assert_eq!(nearest(&line, DVec2::new(4.0, 7.0)), Nearest { squared: 4.0, inside: true });
    }
}
