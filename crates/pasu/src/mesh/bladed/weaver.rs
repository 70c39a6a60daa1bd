//! The mesh of an octant that thins out, while it is made.

use glam::DVec3;

/// A triangle seen from outside, and the patch that it is of.
#[derive(Clone, Copy)]
pub(super) struct Triangle {
    pub(super) corners: [u32; 3],
    pub(super) patch: usize,
}

/// An octant as it was before it was turned and moved, scaled to its lengths.
pub(super) struct Weaver {
    pub(super) places: Vec<DVec3>,
    pub(super) triangles: Vec<Triangle>,
    pub(super) is_lifted: bool,
    pub(super) least: f64,
}

impl Weaver {
    /// One more vertex.
    pub(super) fn vertex(&mut self, place: DVec3) -> u32 {
        self.places.push(place);
        self.places.len() as u32 - 1
    }
}
