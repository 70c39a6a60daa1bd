//! Which side of a surface is its outside.

use super::curves::Curves;
use super::row::{Row, Sums};
use super::solve::Surface;
use super::table::{BLOCK, Block, ColumnTable};

/// Enough of the surface to know the sign of the volume that it goes round.
const ROWS: usize = 17;
/// As [`ROWS`], round the axis; a prime, so that no petal is met at the same place each time.
const COLUMNS: usize = 61;

/// Whether `X_u x X_v` points away from the inside.
///
/// Slice by slice, the flux of `(x, y, 0)` through the surface is twice the area that the surface goes round, whatever lies at rim and foot; its sign
/// tells the side. It is taken about the middle of each row, so that a leaning pot counts by its slices. A surface that goes round nothing keeps `X_u x X_v`.
pub(crate) fn is_outward(surface: &Surface, curves: &Curves) -> bool {
    let flux = if surface.is_closed() && goes_round_level_slices(curves) {
        level_flux(surface, curves)
    } else {
        sampled_flux(surface, curves)
    };
    flux >= 0.0
}

/// Whether the flux is that of level rows: `z` does not depend on `v`, or what of it does has no part in the flux, because mirroring at `y = 0`
/// turns it round and leaves all else (`x` is of cosines, `y` of sines and `z` of sines, so that its part of the integrand is odd in `v`).
fn goes_round_level_slices(curves: &Curves) -> bool {
    let is_level = curves.list().iter().all(|curve| curve.axis != 2 || curve.n == 0.0);
    is_level
        || curves.list().iter().all(|curve| curve.is_sine == (curve.axis != 0) || curve.axis == 2 && curve.n == 0.0)
}

/// As [`is_outward`], for a surface that is not sampled.
pub(crate) fn points_outward(surface: &Surface) -> bool {
    let mut curves = Curves::default();
    curves.prepare(surface, 0.0);
    is_outward(surface, &curves)
}

/// The flux where every row is level, in closed form: `z_u` times the integral of `y x_v - x y_v`, which is `-2 pi sum k (a b' - b a')` for
/// `x = sum a cos + b sin`, `y = sum a' cos + b' sin`. The factor `2 pi` is left out.
fn level_flux(surface: &Surface, curves: &Curves) -> f64 {
    let list = curves.list();
    let mut values = Vec::with_capacity(list.len());
    (0..ROWS)
        .map(|i| {
            let u = (i as f64 + 0.5) / ROWS as f64;
            let mut rise = 0.0;
            values.clear();
            curves.row(surface, u, &mut |index, [value, slope]| {
                values.push(value);
                if list[index].axis == 2 && list[index].n == 0.0 {
                    rise += slope;
                }
            });
            let mut area = 0.0;
            for (x, a) in list.iter().zip(&values).filter(|(curve, _)| curve.axis == 0) {
                for (y, b) in list.iter().zip(&values).filter(|(curve, _)| curve.axis == 1 && curve.n == x.n) {
                    match (x.is_sine, y.is_sine) {
                        (false, true) => area += x.k * a * b,
                        (true, false) => area -= x.k * a * b,
                        _ => {}
                    }
                }
            }
            -rise * area
        })
        .sum()
}

/// The flux as a sum over columns. On a closed surface it is a trigonometric polynomial of three times the largest `n` at most, of which evenly spaced columns give the integral.
fn sampled_flux(surface: &Surface, curves: &Curves) -> f64 {
    let highest = curves.list().iter().fold(0.0f64, |n, curve| n.max(curve.n.abs()));
    let n_columns =
        if surface.is_closed() && 3.0 * highest < COLUMNS as f64 { 3 * highest as usize + 1 } else { COLUMNS };
    let table = ColumnTable::new(surface, n_columns + 1);
    // The blocks reach beyond the columns that count.
    let weight = |block: usize| {
        let counts = |lane: usize| f64::from(u8::from(block * BLOCK + lane < n_columns)) / n_columns as f64;
        Block::from(core::array::from_fn::<_, BLOCK, _>(counts))
    };
    let (mut row, mut sums) = (Row::default(), Vec::with_capacity(table.n_blocks()));
    let mut flux = Block::ZERO;
    for i in 0..ROWS {
        row.fill_roughly(surface, curves, &table.distinct, (i as f64 + 0.5) / ROWS as f64);
        sums.clear();
        sums.extend((0..table.n_blocks()).map(|block| (row.sums(table.block(block)), weight(block))));
        let [x0, y0] = [0, 1].map(|axis| {
            let weighted = sums.iter().map(|(sums, weight)| sums.position[axis] * *weight);
            weighted.fold(Block::ZERO, |sum, x| sum + x).reduce_add()
        });
        for (Sums { position: [x, y, _], du: [xu, yu, zu], dv: [xv, yv, zv] }, weight) in &sums {
            let normal = [*yu * *zv - *zu * *yv, *zu * *xv - *xu * *zv];
            flux += ((*x - x0) * normal[0] + (*y - y0) * normal[1]) * *weight;
        }
    }
    flux.reduce_add()
}
