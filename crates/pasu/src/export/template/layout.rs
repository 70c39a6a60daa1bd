//! How a template is laid out, and the extent of what is on it.

use glam::{DVec2, DVec3};

use crate::export::contents::Body;
use crate::export::shading::point;

/// Free space round the drawing and between its pieces, millimetres.
pub(super) const MARGIN: f64 = 12.0;
pub(super) const GAP: f64 = 10.0;
/// Sizes of letters.
pub(super) const TITLE: f64 = 5.0;
pub(super) const TEXT: f64 = 3.0;
/// Heights of lines.
pub(super) const LINE: f64 = 4.2;

/// The vertices of a body.
pub(super) fn points<'a>(body: &'a Body) -> impl Iterator<Item = DVec3> + 'a {
    (0..body.positions.len() as u32 / 3).map(|vertex| point(body, vertex))
}

/// The corners of the least box round points.
pub(super) fn extent(points: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)))
}
