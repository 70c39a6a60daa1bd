//! The boxes round bodies.

use glam::DVec3;

/// The lowest and the highest corner of the box round points.
pub(super) fn bounds(positions: &[f32]) -> [DVec3; 2] {
    let points = positions.as_chunks::<3>().0.iter().map(|point| DVec3::from_array(point.map(f64::from)));
    points.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
}

/// Whether boxes have a point in common.
pub(super) fn touch([low, high]: [DVec3; 2], [other_low, other_high]: [DVec3; 2]) -> bool {
    (high.min(other_high) - low.max(other_low)).min_element() >= 0.0
}

/// Whether boxes have a face or a volume in common, and not an edge or a point alone.
pub(super) fn meet([low, high]: [DVec3; 2], [other_low, other_high]: [DVec3; 2]) -> bool {
    let common = high.min(other_high) - low.max(other_low);
    common.min_element() >= 0.0 && common.to_array().iter().filter(|width| **width > 0.0).count() > 1
}
