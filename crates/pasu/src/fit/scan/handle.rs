//! What stands out of a scan at one side.

use std::collections::BTreeSet;

use super::section::{DIRECTIONS, Section, bridged, middle};

/// A handle stands out by this part of the radius, over less than this part of the turn, at this part of the levels at least.
const OUT: f64 = 0.25;
const NARROW: f64 = 0.22;
const OFTEN: f64 = 0.06;

/// So many directions to either side of it, and levels above and below, are its root.
const ROOT: usize = 3;

/// Sections without what stands out at one side like a handle, round which no ring goes: the wall goes on there as it does to either side. Nothing where there is none.
pub(super) fn without_handle(sections: &[Section]) -> Option<Vec<Section>> {
    let out: Vec<BTreeSet<usize>> = sections.iter().map(|section| handle_in(section)).collect();
    let n_out = out.iter().filter(|directions| !directions.is_empty()).count();
    if n_out as f64 <= OFTEN * out.len() as f64 {
        return None;
    }
    // Above and below it grows out of the wall as well.
    let near = |i: usize| -> BTreeSet<usize> {
        out[i.saturating_sub(ROOT)..out.len().min(i + ROOT + 1)].iter().flatten().copied().collect()
    };
    Some(sections.iter().enumerate().map(|(i, section)| bridged(section, &near(i))).collect())
}

/// The directions in which a section has a handle.
fn handle_in(section: &[f64]) -> BTreeSet<usize> {
    let radius = middle(section);
    let out: Vec<usize> = (0..DIRECTIONS).filter(|k| section[*k] > (1.0 + OUT) * radius).collect();
    if out.len() as f64 >= NARROW * DIRECTIONS as f64 {
        return BTreeSet::new();
    }
    // Where it grows out of the wall it belongs to it as well.
    out.into_iter().flat_map(|k| (0..=2 * ROOT).map(move |i| (k + i + DIRECTIONS - ROOT) % DIRECTIONS)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_handle_is_bridged_and_petals_are_not() {
        let round = vec![vec![3.0; DIRECTIONS]; 40];
        assert_eq!(without_handle(&round), None);
        let petals = |k: usize| 3.0 + 1.4 * libm::cos(core::f64::consts::TAU * (5 * k) as f64 / DIRECTIONS as f64);
        assert_eq!(without_handle(&vec![(0..DIRECTIONS).map(petals).collect(); 40]), None);
        let mut mug = round.clone();
        // Across the direction 0, where numbers begin anew.
        for section in &mut mug[10..30] {
            [176, 177, 178, 179, 0, 1, 2, 3].into_iter().for_each(|k| section[k] = 5.0);
        }
        assert_eq!(without_handle(&mug), Some(round));
    }
}
