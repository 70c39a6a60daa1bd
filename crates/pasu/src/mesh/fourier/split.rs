//! Rows of which no component has both cosines and sines.

use core::ops::Range;

use super::doubt::Doubt;
use super::lanes::Lanes;
use super::place::{Place, Task};
use super::strands::Strand;
use super::sums::Sums;

/// As [`Layout::Split`](super::strands::Layout::Split).
pub(super) struct Split<'a, const Z_IS_SINE: bool> {
    pub(super) strands: &'a [[Strand; 3]],
    pub(super) row: usize,
}

impl<const Z_IS_SINE: bool> Split<'_, Z_IS_SINE> {
    /// The sums at `v` of some of the harmonics.
    #[inline(always)]
    pub(super) fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> Sums {
        let strands = self.strands.get(harmonics.clone()).unwrap_or_default();
        split_sums::<Z_IS_SINE>(strands, circles.get(harmonics).unwrap_or_default(), self.row)
    }

    /// What is at `v` and at `-v`. There the sums of sines have the other sign, and half of what the two normals are made of is shared:
    /// with `z` of cosines all of it, with `z` of sines what `z_u` is not in.
    #[inline(always)]
    pub(super) fn pair<W: Doubt>(&self, task: &Task, sums: Sums) -> [Place<W>; 2] {
        let [[x, y, z], [xu, yu, zu], [xv, yv, zv]] = sums;
        let [[x0, xu0], [y0, _], [z0, zu0]] = task.constant;
        let (px, here_z) = (x0 + x, z0 + z);
        let here = [px, y0 + y, here_z];
        if !Z_IS_SINE {
            let (normal, seen) = task.normal(&sums);
            let there = Place { position: [px, y0 - y, here_z], normal: [normal[0], -normal[1], normal[2]], seen };
            return [Place { position: here, normal, seen }, there];
        }
        // X_u = (ux, uy, zu0 + zu), X_v = (xv, yv, zv) at v, (ux, -uy, zu0 - zu) and (-xv, yv, zv) at -v.
        let (ux, uy) = (xu0 + xu, yu);
        let (uz, other_uz) = (zu0 + zu, zu0 - zu);
        let (p, q) = (uy * zv, ux * zv);
        let nz = ux * yv - uy * xv;
        let nz_squared = nz * nz;
        let finished = |nx: Lanes, ny: Lanes, uz: Lanes| {
            let squared = nx * nx + ny * ny + nz_squared;
            (task.sign / squared.sqrt(), W::look(&task.limits, [ux, uy, uz], [xv, yv, zv], squared))
        };
        let (nx, ny) = (p - uz * yv, uz * xv - q);
        let (inverse, seen) = finished(nx, ny, uz);
        // The other way round than at v.
        let (other_nx, other_ny) = (p + other_uz * yv, other_uz * xv + q);
        let (other_inverse, other_seen) = finished(other_nx, other_ny, other_uz);
        let turned = -other_inverse;
        [
            Place { position: here, normal: [nx * inverse, ny * inverse, nz * inverse], seen },
            Place {
                position: [px, y0 - y, z0 - z],
                normal: [other_nx * turned, other_ny * turned, nz * other_inverse],
                seen: other_seen,
            },
        ]
    }
}

/// The sums of strands that go with cosines in `x`, with sines in `y`, and with either in `z`.
#[inline(always)]
fn split_sums<const Z_IS_SINE: bool>(strands: &[[Strand; 3]], circles: &[[Lanes; 2]], row: usize) -> Sums {
    let (first, second) = (usize::from(Z_IS_SINE), usize::from(!Z_IS_SINE));
    let products = |(strand, circle): (&[Strand; 3], &[Lanes; 2])| {
        let at = |axis: usize, quantity: usize| Lanes::splat(strand[axis][quantity].as_array()[row & 3]);
        let [cos, sin] = *circle;
        (
            (cos * at(0, 0), cos * at(0, 1), sin * at(0, 2)),
            (sin * at(1, 0), sin * at(1, 1), cos * at(1, 2)),
            (circle[first] * at(2, 0), circle[first] * at(2, 1), circle[second] * at(2, 2)),
        )
    };
    // The first products are where the sums start: nothing is added to 0.
    let mut pairs = strands.iter().zip(circles);
    let Some(pair) = pairs.next() else { return [[Lanes::ZERO; 3]; 3] };
    let ((mut x, mut xu, mut xv), (mut y, mut yu, mut yv), (mut z, mut zu, mut zv)) = products(pair);
    for pair in pairs {
        let ((dx, dxu, dxv), (dy, dyu, dyv), (dz, dzu, dzv)) = products(pair);
        x += dx;
        xu += dxu;
        xv += dxv;
        y += dy;
        yu += dyu;
        yv += dyv;
        z += dz;
        zu += dzu;
        zv += dzv;
    }
    [[x, y, z], [xu, yu, zu], [xv, yv, zv]]
}
