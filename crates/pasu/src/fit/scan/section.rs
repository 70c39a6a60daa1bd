//! One level of a scan: how far its outside is from the axis, direction by direction.

use std::collections::BTreeSet;

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

/// A section whose wall goes on in some directions as it does to either side of them.
pub(super) fn bridged(section: &[f64], out: &BTreeSet<usize>) -> Section {
    // Of a section of which most is left out nothing is known.
    if out.len() > DIRECTIONS / 2 {
        return section.to_vec();
    }
    // The nearest direction that is not left out, so many steps on or back.
    let beyond = |k: usize, step: usize| {
        let mut away = 1;
        while out.contains(&((k + away * step) % DIRECTIONS)) {
            away += 1;
        }
        (away as f64, section[(k + away * step) % DIRECTIONS])
    };
    let at = |k: usize| {
        if !out.contains(&k) {
            return section[k];
        }
        let ((back, before), (on, behind)) = (beyond(k, DIRECTIONS - 1), beyond(k, 1));
        (before * on + behind * back) / (back + on)
    };
    (0..DIRECTIONS).map(at).collect()
}
