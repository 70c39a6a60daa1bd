//! One level of a scan: how far its outside is from the axis, direction by direction.

/// Directions that a level is looked at in.
pub(super) const DIRECTIONS: usize = 180;

/// Distances from the axis in all directions; 0 where nothing was met.
pub(super) type Section = Vec<f64>;

/// Half of what is around is further out than this.
pub(super) fn middle(section: &[f64]) -> f64 {
    let mut sorted = section.to_vec();
    sorted.sort_by(f64::total_cmp);
    let half = sorted.len() / 2;
    0.5 * (sorted[half - 1] + sorted[half])
}
