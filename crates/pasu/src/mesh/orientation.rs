//! Which side of a surface is its outside.

use glam::{DMat3, DVec3};

use super::row::Row;
use crate::surface::{BLOCK, ColumnTable, RowTable, Surface};

/// Enough of the surface to know the sign of the volume that it goes round.
const ROWS: usize = 17;
/// As [`ROWS`], round the axis; a prime, so that no petal is met at the same place each time.
const COLUMNS: usize = 61;

/// Which side is outside, and how large the surface is at least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Orientation {
    /// Whether `X_u x X_v` points away from the inside.
    pub(super) is_outward: bool,
    /// The largest coordinate, in size, of some points of the placed surface.
    pub(super) largest: f64,
}

impl Orientation {
    /// Slice by slice, the flux of `(x, y, 0)` through the surface is twice the area that the surface goes round, whatever lies at rim and foot; its sign
    /// tells the side. It is taken about the middle of each row, so that a leaning pot counts by its slices. A surface that goes round nothing keeps `X_u x X_v`.
    pub(super) fn of(surface: &Surface, matrix: DMat3, shift: DVec3) -> Self {
        let table = ColumnTable::new(surface, COLUMNS + 1);
        let (mut row, mut points) = (Row::default(), Vec::with_capacity(COLUMNS));
        let mut flux = 0.0;
        let mut largest = 0.0f64;
        for i in 0..ROWS {
            let u = (i as f64 + 0.5) / ROWS as f64;
            row.fill(&RowTable::at(surface, &table.distinct, u));
            points.clear();
            let blocks = (0..table.n_blocks()).map(|block| row.sums(table.block(block)));
            points.extend(
                blocks.flat_map(|sums| core::array::from_fn::<_, BLOCK, _>(|lane| sums.at(lane))).take(COLUMNS),
            );
            let middle = points.iter().map(|(position, ..)| *position).sum::<DVec3>() / COLUMNS as f64;
            for (position, du, dv) in &points {
                let (arm, normal) = (*position - middle, du.cross(*dv));
                flux += arm.x * normal.x + arm.y * normal.y;
                largest = largest.max((matrix * *position + shift).abs().max_element());
            }
        }
        Orientation { is_outward: flux >= 0.0, largest }
    }
}
