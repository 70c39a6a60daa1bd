//! Unit normals, and where there are none to be told from rounding.

use glam::{DMat3, DVec3};

use crate::surface::{BLOCK, Block};

/// `X_u x X_v` counts as vanished when it is this small against the lengths of both: then its direction is rounding.
const VANISHED: f64 = 1e-10;

/// A sum counts as vanished when it is this small against its terms.
const CANCELLED: f64 = 1e-13;

/// Unit normals of a block of columns, along `X_u x X_v`.
pub(super) struct Facing {
    normal: [Block; 3],
}

impl Facing {
    /// The normals of a block with these `X_u` and `X_v`, and the lanes in which there is none, as bits: where it cannot be told from rounding, as [`are_directions`] judges.
    ///
    /// `terms` are the squared lengths that `X_u` and `X_v` would have if nothing cancelled.
    pub(super) fn of([[ux, uy, uz], [vx, vy, vz]]: [[Block; 3]; 2], terms: [f64; 2]) -> (Self, u32) {
        let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        let (du, dv) = (ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz);
        let missing = !are_directions(squared, [du, dv], terms) & ((1 << BLOCK) - 1);
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

    /// The same in some of the columns.
    pub(super) fn write_some(&self, wanted: &[bool; BLOCK], normals: &mut [[f32; 3]]) {
        let [x, y, z] = self.normal.map(Block::to_array);
        for (lane, (normal, wanted)) in normals.iter_mut().zip(wanted).enumerate() {
            if *wanted {
                *normal = [x[lane] as f32, y[lane] as f32, z[lane] as f32];
            }
        }
    }
}

/// Rounds a block of vectors to single precision.
pub(super) fn write_single(vectors: [Block; 3], into: &mut [[f32; 3]]) {
    let [x, y, z] = vectors.map(|component| component.to_array().map(|value| value as f32));
    for (((vector, x), y), z) in into.iter_mut().zip(x).zip(y).zip(z) {
        *vector = [x, y, z];
    }
}

/// In which lanes a normal of this squared length is more than rounding beside tangents of these, which are sums of terms of these; as bits.
///
/// A tangent that is itself nothing but rounding beside its terms counts as vanished: at a pole the sums for `X_v` cancel to some `1e-16` of them.
fn are_directions(squared: Block, [du, dv]: [Block; 2], terms: [f64; 2]) -> u32 {
    let [du_least, dv_least] = terms.map(|terms| Block::splat(CANCELLED * CANCELLED * terms));
    let is_direction = squared.simd_gt(du * dv * (VANISHED * VANISHED))
        & du.simd_gt(du_least)
        & dv.simd_gt(dv_least)
        & squared.simd_lt(Block::splat(f64::MAX));
    is_direction.to_bitmask()
}

/// The matrix of cofactors, `det(m) m^-T` also where `m` is singular.
pub(super) fn cofactors(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis))
}
