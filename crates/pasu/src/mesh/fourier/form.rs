//! From a row's strands to positions and normals at four columns, and at those that mirror them.

use core::ops::Range;

use super::lanes::Lanes;
use super::strands::Strand;
use super::sums::{Sums, added, minus, plus, split_sums, subtracted, sums};
use super::watch::{Limits, Watch};

/// How the sums of some of the harmonics are formed.
///
/// Every implementation is inlined into its loop over the columns, or the sums would go through memory.
pub(super) trait Form {
    /// What the sums at `v` and at `-v` are had from.
    type Formed: Copy;
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> Self::Formed;
    fn added(a: Self::Formed, b: Self::Formed) -> Self::Formed;
    fn subtracted(a: Self::Formed, b: Self::Formed) -> Self::Formed;
    /// The sums at `v`.
    fn here(&self, formed: Self::Formed) -> Sums;
    /// What is at `v` and at `-v`.
    fn pair<W: Watch>(&self, task: &Task, formed: Self::Formed) -> [Place<W>; 2];
}

/// Positions and unit normals at four columns, and what was seen of these.
#[derive(Clone, Copy)]
pub(super) struct Place<W> {
    pub(super) position: [Lanes; 3],
    pub(super) normal: [Lanes; 3],
    pub(super) seen: W,
}

/// What all blocks of a row share.
#[derive(Clone, Copy)]
pub(super) struct Task {
    pub(super) constant: [[Lanes; 2]; 3],
    pub(super) limits: Limits,
    pub(super) sign: Lanes,
    pub(super) n_even: usize,
    pub(super) n_steps: usize,
}

impl Task {
    #[inline(always)]
    fn position(&self, sums: &Sums) -> [Lanes; 3] {
        let [[x, _], [y, _], [z, _]] = self.constant;
        plus([x, y, z], sums[0])
    }

    #[inline(always)]
    pub(super) fn place<W: Watch>(&self, sums: &Sums) -> Place<W> {
        let (normal, seen) = self.normal(sums);
        Place { position: self.position(sums), normal, seen }
    }

    /// A position half a turn on, where what goes round the axis has the other sign.
    #[inline(always)]
    pub(super) fn turned_position(&self, [x, y, z]: [Lanes; 3]) -> [Lanes; 3] {
        let [[x0, _], [y0, _], _] = self.constant;
        [x0 + x0 - x, y0 + y0 - y, z]
    }

    /// The unit normal along `X_u x X_v`.
    #[inline(always)]
    fn normal<W: Watch>(&self, sums: &Sums) -> ([Lanes; 3], W) {
        let [[_, xu], [_, yu], [_, zu]] = self.constant;
        let [ux, uy, uz] = plus([xu, yu, zu], sums[1]);
        let [vx, vy, vz] = sums[2];
        let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        let inverse = self.sign / squared.sqrt();
        (normal.map(|component| component * inverse), W::look(&self.limits, [ux, uy, uz], [vx, vy, vz], squared))
    }
}

/// As [`Layout::Split`](super::strands::Layout::Split).
pub(super) struct Split<'a, const Z_IS_SINE: bool> {
    pub(super) strands: &'a [[Strand; 3]],
    pub(super) row: usize,
}

impl<const Z_IS_SINE: bool> Form for Split<'_, Z_IS_SINE> {
    type Formed = Sums;

    #[inline(always)]
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> Sums {
        let strands = self.strands.get(harmonics.clone()).unwrap_or_default();
        split_sums::<Z_IS_SINE>(strands, circles.get(harmonics).unwrap_or_default(), self.row)
    }

    #[inline(always)]
    fn added(a: Sums, b: Sums) -> Sums {
        added(&a, &b)
    }

    #[inline(always)]
    fn subtracted(a: Sums, b: Sums) -> Sums {
        subtracted(&a, &b)
    }

    #[inline(always)]
    fn here(&self, formed: Sums) -> Sums {
        formed
    }

    /// At `-v` the sums of sines have the other sign, and half of what the two normals are made of is shared:
    /// with `z` of cosines all of it, with `z` of sines what `z_u` is not in.
    #[inline(always)]
    fn pair<W: Watch>(&self, task: &Task, sums: Sums) -> [Place<W>; 2] {
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

/// As [`Layout::Both`](super::strands::Layout::Both).
pub(super) struct Both<'a> {
    pub(super) strands: &'a [[Strand; 3]],
    pub(super) sine_strands: &'a [[Strand; 3]],
    pub(super) row: usize,
}

impl Form for Both<'_> {
    /// The sums of the cosine strands and those of the sine strands.
    type Formed = [Sums; 2];

    #[inline(always)]
    fn form(&self, harmonics: Range<usize>, circles: &[[Lanes; 2]]) -> [Sums; 2] {
        let circles = circles.get(harmonics.clone()).unwrap_or_default();
        let even = sums::<false>(self.strands.get(harmonics.clone()).unwrap_or_default(), circles, self.row);
        let odd = sums::<true>(self.sine_strands.get(harmonics).unwrap_or_default(), circles, self.row);
        [even, odd]
    }

    #[inline(always)]
    fn added(a: [Sums; 2], b: [Sums; 2]) -> [Sums; 2] {
        [added(&a[0], &b[0]), added(&a[1], &b[1])]
    }

    #[inline(always)]
    fn subtracted(a: [Sums; 2], b: [Sums; 2]) -> [Sums; 2] {
        [subtracted(&a[0], &b[0]), subtracted(&a[1], &b[1])]
    }

    #[inline(always)]
    fn here(&self, [even, odd]: [Sums; 2]) -> Sums {
        added(&even, &odd)
    }

    #[inline(always)]
    fn pair<W: Watch>(&self, task: &Task, [even, odd]: [Sums; 2]) -> [Place<W>; 2] {
        let mirrored = [minus(even[0], odd[0]), minus(even[1], odd[1]), minus(odd[2], even[2])];
        [task.place(&added(&even, &odd)), task.place(&mirrored)]
    }
}
