//! A flat side of an octant that thins out: a fan of triangles from the origin, and strips along its axes.

use glam::DVec2;

use super::weaver::{Triangle, Weaver};

/// A vertex of an edge, and its place along the axis of the tip to which the edge goes and along that of the other.
#[derive(Clone, Copy)]
pub(super) struct OnEdge {
    pub(super) vertex: u32,
    pub(super) at: DVec2,
}

/// A vertex of an axis.
#[derive(Clone, Copy)]
pub(super) struct OnAxis {
    pub(super) vertex: u32,
    pub(super) at: f64,
}

/// Where on an edge the strip along the other axis ends, and where that along its own begins: towards a tip where the edge is flatter than it is steep.
pub(super) fn strips(chain: &[OnEdge]) -> [usize; 2] {
    let is_flat = |k: &usize| {
        let step = (chain[k + 1].at - chain[*k].at).abs();
        step.y < step.x
    };
    let n = chain.len() - 1;
    let after = n - (0..n).rev().take_while(is_flat).count();
    let before = (0..n).take_while(|k| !is_flat(k)).count();
    [before, after]
}

/// A flat side while it is made.
pub(super) struct FlatSide<'a> {
    pub(super) weaver: &'a mut Weaver,
    pub(super) patch: usize,
    pub(super) is_inward: bool,
}

impl FlatSide<'_> {
    pub(super) fn add(&mut self, [a, b, c]: [u32; 3]) {
        let corners = if self.is_inward { [a, c, b] } else { [a, b, c] };
        self.weaver.triangles.push(Triangle { corners, patch: self.patch });
    }

    /// Between the places of an axis, from the origin on, and those of an edge that goes down to its tip. An edge is seen from all places of the axis that are no further out than it is.
    pub(super) fn strip(&mut self, axis: &[OnAxis], edge: &[OnEdge]) {
        let (mut a, mut e) = (0, 0);
        let tip = edge.len() - 1;
        loop {
            let next = axis.get(a + 1).filter(|next| e + 1 == tip || next.at <= edge[e].at.x);
            if let Some(next) = next {
                self.add([axis[a].vertex, next.vertex, edge[e].vertex]);
                a += 1;
            } else if e < tip {
                self.add([axis[a].vertex, edge[e + 1].vertex, edge[e].vertex]);
                e += 1;
            } else {
                return;
            }
        }
    }
}
