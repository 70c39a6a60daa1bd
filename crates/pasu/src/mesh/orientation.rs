//! Which side of a surface is its outside.

use crate::surface::Surface;

/// Enough of the surface to know the sign of the volume that it goes round.
const ROWS: usize = 33;
/// As [`ROWS`], round the axis; not a divisor of common petal counts.
const COLUMNS: usize = 71;

/// Whether `X_u x X_v` points away from the inside.
///
/// Slice by slice, the flux of `(x, y, 0)` through the surface is twice the area that the surface goes round, whatever lies at rim and foot; its sign
/// tells the side. It is taken about the middle of each row, so that a leaning pot counts by its slices. A surface that goes round nothing keeps `X_u x X_v`.
pub(super) fn is_outward(surface: &Surface) -> bool {
    let mut flux = 0.0;
    for i in 0..ROWS {
        let u = (i as f64 + 0.5) / ROWS as f64;
        let row: Vec<_> = (0..COLUMNS).map(|j| surface.at(u, surface.span() * j as f64 / COLUMNS as f64)).collect();
        let middle = row.iter().map(|jet| jet.position / COLUMNS as f64).sum::<glam::DVec3>();
        for jet in &row {
            let (arm, normal) = (jet.position - middle, jet.du.cross(jet.dv));
            flux += arm.x * normal.x + arm.y * normal.y;
        }
    }
    flux >= 0.0
}
