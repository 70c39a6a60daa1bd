//! Normals where the surface has no tangent plane of its own.

use glam::{DMat3, DVec3};

use crate::surface::{BLOCK, Block, Surface, SurfaceJet};

/// `X_u x X_v` counts as vanished when it is this small against the lengths of both: then its direction is rounding.
const VANISHED: f64 = 1e-10;

/// A sum counts as vanished when it is this small against its terms.
const CANCELLED: f64 = 1e-13;

/// How far into the surface, as a part of `u`, the limit is looked for, in turn.
const STEPS_INWARD: [f64; 4] = [1e-6, 1e-4, 1e-3, 1e-2];

/// The unit normal along `X_u x X_v` if it can be told from rounding.
fn regular(du: DVec3, dv: DVec3) -> Option<DVec3> {
    let normal = du.cross(dv);
    let squared = normal.length_squared();
    if is_direction(squared, [du.length_squared(), dv.length_squared()], [0.0; 2]) {
        Some(normal / squared.sqrt())
    } else {
        None
    }
}

/// Unit normals of a block of columns, along `X_u x X_v`.
pub(super) struct Facing {
    normal: [Block; 3],
}

impl Facing {
    /// The normals of a block with these `X_u` and `X_v`, and the lanes in which there is none, as bits: where it cannot be told from rounding, as [`is_direction`] judges.
    ///
    /// `terms` are the squared lengths that `X_u` and `X_v` would have if nothing cancelled.
    pub(super) fn of([[ux, uy, uz], [vx, vy, vz]]: [[Block; 3]; 2], terms: [f64; 2]) -> (Self, u32) {
        let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        let du = (ux * ux + uy * uy + uz * uz).to_array();
        let dv = (vx * vx + vy * vy + vz * vz).to_array();
        let lanes = squared.to_array();
        let missing =
            (0..BLOCK).map(|lane| u32::from(!is_direction(lanes[lane], [du[lane], dv[lane]], terms)) << lane).sum();
        let inverse = Block::ONE / squared.sqrt();
        (Facing { normal: normal.map(|component| component * inverse) }, missing)
    }

    /// Puts another direction in one lane.
    pub(super) fn set(&mut self, lane: usize, normal: DVec3) {
        for (component, value) in self.normal.iter_mut().zip(normal.to_array()) {
            component.as_mut_array()[lane] = value;
        }
    }

    /// Turns the normals by a matrix, which need not keep their length.
    pub(super) fn turn(&mut self, matrix: DMat3) {
        for lane in 0..BLOCK {
            let turned = matrix * DVec3::from_array(self.normal.map(|component| component.to_array()[lane]));
            self.set(lane, turned.normalize_or(DVec3::Z));
        }
    }

    /// Rounds to single precision.
    pub(super) fn write(&self, normals: &mut [[f32; 3]]) {
        write_single(self.normal, normals);
    }
}

/// Rounds a block of vectors to single precision.
pub(super) fn write_single(vectors: [Block; 3], into: &mut [[f32; 3]]) {
    let [x, y, z] = vectors.map(|component| component.to_array().map(|value| value as f32));
    for (((vector, x), y), z) in into.iter_mut().zip(x).zip(y).zip(z) {
        *vector = [x, y, z];
    }
}

/// Whether a normal of this squared length is more than rounding beside tangents of these, which are sums of terms of these.
///
/// A tangent that is itself nothing but rounding beside its terms counts as vanished: at a pole the sums for `X_v` cancel to some `1e-16` of them.
fn is_direction(squared: f64, [du, dv]: [f64; 2], [du_terms, dv_terms]: [f64; 2]) -> bool {
    (squared > VANISHED * VANISHED * (du * dv))
        & (du > CANCELLED * CANCELLED * du_terms)
        & (dv > CANCELLED * CANCELLED * dv_terms)
        & (squared < f64::MAX)
}

/// The limit of the unit normal at a pole or cusp, where the surface has this jet.
///
/// By Taylor's formula a step `h` into the surface turns `X_u x X_v = 0` into `h (X_uu x X_v + X_u x X_uv)`, which is the limit's direction. Where that vanishes
/// too, the normal a little further in is taken. There is none where the surface is a curve or a point all over.
pub(super) fn limit(surface: &Surface, u: f64, v: f64, jet: &SurfaceJet) -> Option<DVec3> {
    let inward = if u < 0.5 { 1.0 } else { -1.0 };
    let turned = inward * (jet.duu.cross(jet.dv) + jet.du.cross(jet.duv));
    let size = jet.duu.length() * jet.dv.length() + jet.du.length() * jet.duv.length();
    let length = turned.length();
    if length.is_finite() && length > 1e-9 * size {
        return Some(turned / length);
    }
    for step in STEPS_INWARD {
        for (u, v) in
            [(u + inward * step, v), (u, v + step * surface.span()), (u + inward * step, v + step * surface.span())]
        {
            let jet = surface.at(u, v);
            if let Some(normal) = regular(jet.du, jet.dv) {
                return Some(normal);
            }
        }
    }
    None
}
