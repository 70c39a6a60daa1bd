//! Normals where the surface has no tangent plane of its own.

use glam::{DMat3, DVec3};

use super::row::Sums;
use crate::surface::{BLOCK, Block, Surface};

/// `X_u x X_v` counts as vanished when it is this small against the lengths of both: then its direction is rounding.
const VANISHED: f64 = 1e-10;

/// How far into the surface, as a part of `u`, the limit is looked for, in turn.
const STEPS_INWARD: [f64; 4] = [1e-6, 1e-4, 1e-3, 1e-2];

/// The unit normal along `X_u x X_v` if it can be told from rounding.
fn regular(du: DVec3, dv: DVec3) -> Option<DVec3> {
    let normal = du.cross(dv);
    let squared = normal.length_squared();
    if is_direction(squared, du.length_squared(), dv.length_squared()) { Some(normal / squared.sqrt()) } else { None }
}

/// Unit normals of a block of columns, along `X_u x X_v`.
pub(super) struct Facing {
    normal: [Block; 3],
    /// Where the direction can be told from rounding, as [`regular`] judges; elsewhere the normal is not to be used.
    pub(super) is_told: [bool; BLOCK],
}

impl Facing {
    /// As [`regular`], lane by lane, without a branch in the way of vector instructions.
    pub(super) fn of(sums: &Sums) -> Self {
        let ([ux, uy, uz], [vx, vy, vz]) = (&sums.du, &sums.dv);
        let mut normal = [[0.0; BLOCK]; 3];
        let mut is_told = [false; BLOCK];
        for lane in 0..BLOCK {
            let du = ux[lane] * ux[lane] + uy[lane] * uy[lane] + uz[lane] * uz[lane];
            let dv = vx[lane] * vx[lane] + vy[lane] * vy[lane] + vz[lane] * vz[lane];
            let x = uy[lane] * vz[lane] - uz[lane] * vy[lane];
            let y = uz[lane] * vx[lane] - ux[lane] * vz[lane];
            let z = ux[lane] * vy[lane] - uy[lane] * vx[lane];
            let squared = x * x + y * y + z * z;
            is_told[lane] = is_direction(squared, du, dv);
            let inverse = 1.0 / squared.sqrt();
            normal[0][lane] = x * inverse;
            normal[1][lane] = y * inverse;
            normal[2][lane] = z * inverse;
        }
        Facing { normal, is_told }
    }

    /// Puts another direction in one lane.
    pub(super) fn set(&mut self, lane: usize, normal: DVec3) {
        for (component, value) in self.normal.iter_mut().zip(normal.to_array()) {
            component[lane] = value;
        }
    }

    /// Turns the normals by a matrix, which need not keep their length.
    pub(super) fn turn(&mut self, matrix: DMat3) {
        for lane in 0..BLOCK {
            let turned = matrix * DVec3::from_array(self.normal.map(|component| component[lane]));
            self.set(lane, turned.normalize_or(DVec3::Z));
        }
    }

    /// Rounds to single precision, in the direction given by the sign.
    pub(super) fn write(&self, sign: f64, normals: &mut [[f32; 3]]) {
        for (lane, normal) in normals.iter_mut().enumerate() {
            // Adding 0 makes 0 of -0.
            *normal = self.normal.map(|component| (sign * component[lane]) as f32 + 0.0);
        }
    }
}

/// Whether a normal of this squared length is more than rounding beside tangents of these.
///
/// A tangent that is itself nothing but rounding beside the other counts as vanished: at a pole the sums for `X_v` cancel to some `1e-16` of `X_u`.
fn is_direction(squared: f64, du: f64, dv: f64) -> bool {
    (squared > VANISHED * VANISHED * (du * dv)) & (dv > 1e-26 * du) & (du > 1e-26 * dv) & (squared < f64::MAX)
}

/// The limit of the unit normal at a pole or cusp.
///
/// By Taylor's formula a step `h` into the surface turns `X_u x X_v = 0` into `h (X_uu x X_v + X_u x X_uv)`, which is the limit's direction. Where that vanishes
/// too, the normal a little further in is taken; where the surface is a curve or a point all over, the axis `z` is as good as any.
pub(super) fn limit(surface: &Surface, u: f64, v: f64) -> DVec3 {
    let inward = if u < 0.5 { 1.0 } else { -1.0 };
    let jet = surface.at(u, v);
    let turned = inward * (jet.duu.cross(jet.dv) + jet.du.cross(jet.duv));
    let size = jet.duu.length() * jet.dv.length() + jet.du.length() * jet.duv.length();
    let length = turned.length();
    if length.is_finite() && length > 1e-9 * size {
        return turned / length;
    }
    for step in STEPS_INWARD {
        for (u, v) in
            [(u + inward * step, v), (u, v + step * surface.span()), (u + inward * step, v + step * surface.span())]
        {
            let jet = surface.at(u, v);
            if let Some(normal) = regular(jet.du, jet.dv) {
                return normal;
            }
        }
    }
    DVec3::Z
}
