//! Where a plane cuts a closed mesh.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use super::frame::Frame;
use crate::export::contents::Body;
use crate::export::shading::point;

/// An edge of the mesh, by its vertices in ascending order.
type Edge = (u32, u32);

/// The closed outlines in which the plane through the axis, along `frame.across`, cuts a body: distance from the axis and height.
///
/// A vertex in the plane counts as before it, so that an edge is either cut once or not at all; the mesh being closed, every cut edge has one segment that arrives and one that leaves.
pub(super) fn section(body: &Body, frame: &Frame) -> Vec<Vec<DVec2>> {
    let normal = frame.axis.cross(frame.across);
    let side: Vec<f64> =
        (0..body.positions.len() as u32 / 3).map(|vertex| (point(body, vertex) - frame.origin).dot(normal)).collect();
    let mut next: BTreeMap<Edge, Edge> = BTreeMap::new();
    for corners in body.triangles() {
        let mut cut = [None, None];
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let (from, to) = (corners[from], corners[to]);
            let is_before = [from, to].map(|vertex| side[vertex as usize] >= 0.0);
            if is_before[0] != is_before[1] {
                cut[usize::from(is_before[0])] = Some((from.min(to), from.max(to)));
            }
        }
        if let [Some(arrives), Some(leaves)] = cut {
            next.insert(arrives, leaves);
        }
    }
    let mut outlines = Vec::new();
    while let Some((start, mut at)) = next.pop_first() {
        let mut edges = vec![start];
        while let Some(after) = next.remove(&at) {
            edges.push(at);
            at = after;
        }
        outlines.push(edges.into_iter().map(|edge| frame.plan(cut(body, &side, edge))).collect());
    }
    outlines
}

fn cut(body: &Body, side: &[f64], (from, to): Edge) -> DVec3 {
    let (a, b) = (side[from as usize], side[to as usize]);
    point(body, from).lerp(point(body, to), a / (a - b))
}
