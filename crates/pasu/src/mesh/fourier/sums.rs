//! The sums of products of a row's strands with the cosines and sines of four columns.

use super::lanes::Lanes;
use super::strands::Strand;

/// Position, `X_u` and `X_v` at four columns, component by component.
pub(super) type Sums = [[Lanes; 3]; 3];

/// The sums of strands that all go with cosines, or all with sines.
///
/// A rolled loop over named sums: with sums in arrays, or the loop unrolled, compilers keep them in memory.
#[inline(always)]
pub(super) fn sums<const SINE: bool>(strands: &[[Strand; 3]], circles: &[[Lanes; 2]], row: usize) -> Sums {
    let (mut x, mut xu, mut xv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    let (mut y, mut yu, mut yv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    let (mut z, mut zu, mut zv) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    for (strand, &[cos, sin]) in strands.iter().zip(circles) {
        let at = |axis: usize, quantity: usize| Lanes::splat(strand[axis][quantity].as_array()[row & 3]);
        let (a, b) = if SINE { (sin, cos) } else { (cos, sin) };
        x += a * at(0, 0);
        xu += a * at(0, 1);
        xv += b * at(0, 2);
        y += a * at(1, 0);
        yu += a * at(1, 1);
        yv += b * at(1, 2);
        z += a * at(2, 0);
        zu += a * at(2, 1);
        zv += b * at(2, 2);
    }
    [[x, y, z], [xu, yu, zu], [xv, yv, zv]]
}

#[inline(always)]
pub(super) fn added(a: &Sums, b: &Sums) -> Sums {
    [plus(a[0], b[0]), plus(a[1], b[1]), plus(a[2], b[2])]
}

#[inline(always)]
pub(super) fn subtracted(a: &Sums, b: &Sums) -> Sums {
    [minus(a[0], b[0]), minus(a[1], b[1]), minus(a[2], b[2])]
}

#[inline(always)]
pub(super) fn plus(a: [Lanes; 3], b: [Lanes; 3]) -> [Lanes; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(super) fn minus(a: [Lanes; 3], b: [Lanes; 3]) -> [Lanes; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
