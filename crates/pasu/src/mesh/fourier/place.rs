//! From sums to positions and unit normals.

use super::doubt::{Doubt, Limits};
use super::lanes::Lanes;
use super::sums::{Sums, plus};

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
    pub(super) fn position(&self, sums: &Sums) -> [Lanes; 3] {
        let [[x, _], [y, _], [z, _]] = self.constant;
        plus([x, y, z], sums[0])
    }

    #[inline(always)]
    pub(super) fn place<W: Doubt>(&self, sums: &Sums) -> Place<W> {
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
    pub(super) fn normal<W: Doubt>(&self, sums: &Sums) -> ([Lanes; 3], W) {
        let [[_, xu], [_, yu], [_, zu]] = self.constant;
        let [ux, uy, uz] = plus([xu, yu, zu], sums[1]);
        let [vx, vy, vz] = sums[2];
        let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        let inverse = self.sign / squared.sqrt();
        (normal.map(|component| component * inverse), W::look(&self.limits, [ux, uy, uz], [vx, vy, vz], squared))
    }
}
