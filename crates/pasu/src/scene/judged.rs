//! What was found of two parts, kept for the next scene in which both stand as they do in this one.

use std::collections::BTreeMap;

use super::meeting::{Meeting, Task};

/// The most that is kept: of so many pairs there is hardly one in which a moved part is not.
const MOST: usize = 20_000;

/// How two parts meet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Judged {
    pub(super) meeting: Meeting,
    /// Of parts of one object of which only this is known, that they touch: for each whether a place of its own was found.
    pub(super) is_own: [bool; 2],
    /// Whether more work might say more.
    pub(super) is_cut: bool,
    /// What it took, in pairs of tiles.
    pub(super) work: u64,
}

/// How pairs of parts meet, by what was to be found. Nothing of which the work of a scene was not enough is among it, so that it is what would be found again.
#[derive(Debug, Clone, Default)]
pub(super) struct Known {
    slack: f64,
    pairs: BTreeMap<([usize; 2], bool, u64), Judged>,
}

impl Known {
    pub(super) fn new(slack: f64) -> Known {
        Known { slack, pairs: BTreeMap::new() }
    }

    pub(super) fn get(&self, both: [usize; 2], task: Task) -> Option<&Judged> {
        if self.slack != task.slack {
            return None;
        }
        self.pairs.get(&(both, task.is_touch_enough, task.most_pairs))
    }

    pub(super) fn insert(&mut self, both: [usize; 2], task: Task, judged: Judged) {
        if self.pairs.len() < MOST && self.slack == task.slack && !task.is_distance_sought {
            self.pairs.insert((both, task.is_touch_enough, task.most_pairs), judged);
        }
    }

    /// What is known of parts both of which this is true of.
    pub(super) fn of(&self, is_kept: impl Fn(usize) -> bool) -> Known {
        let pairs = self.pairs.iter().filter(|((both, ..), _)| both.iter().all(|part| is_kept(*part)));
        Known { slack: self.slack, pairs: pairs.map(|(key, judged)| (*key, *judged)).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::super::meeting::MET;
    use crate::design::Design;
    use crate::solution::Solution;

    /// How often two parts were held against each other meanwhile.
    fn met(solution: &Solution) -> usize {
        let before = MET.get();
        solution.constraints(None).unwrap();
        MET.get() - before
    }

    /// A row of which each octant runs into the next, every second one glued to it, with one moved aside.
    fn row(aside: f64) -> Design {
        let octant = |i: usize| {
            let (x, y) = (0.8 * i as f64, if i == 30 { aside } else { 0.0 });
            format!(
                r#"{{ "object": {}, "shape": {{ "kind": "octant", "exponents": [2, 3, 1.5] }}, "place": {{ "shift": [{x}, {y}, 0] }} }}"#,
                i / 2
            )
        };
        let parts: Vec<String> = (0..60).map(octant).collect();
        Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}] }}"#, parts.join(", "))).unwrap()
    }

    #[test]
    fn a_moved_part_is_held_against_its_neighbours_alone() {
        let first = Solution::of(&row(0.0));
        let all = met(&first);
        assert!(all >= 59, "{all}");
        // Asked again nothing is, of what was told.
        assert_eq!(met(&first), 0);
        let second = first.after(&row(0.25));
        let few = met(&second);
        // Its neighbours on both sides, and each once more where little work did not tell.
        assert!((2..=4).contains(&few), "{few}");
        assert_eq!(second.constraints(None).unwrap(), crate::scene::constraints(&row(0.25), None).unwrap());
        // Over a scene of which nothing was asked, and away from all others.
        let third = second.after(&row(0.5)).after(&row(0.9));
        assert!(met(&third) <= 6);
        assert_eq!(third.constraints(None).unwrap(), crate::scene::constraints(&row(0.9), None).unwrap());
        // Another slack is another question.
        let slack = Some(1e-3);
        assert_eq!(third.constraints(slack).unwrap(), crate::scene::constraints(&row(0.9), slack).unwrap());
    }

    #[test]
    fn what_is_known_tells_of_no_other_part() {
        let first = Solution::of(&row(0.0));
        met(&first);
        let parts = row(0.0);
        let other = parts.to_json().replace("[2,3,1.5]", "[2,3,1.25]");
        let other = Design::parse(&other).unwrap();
        assert_eq!(met(&first.after(&other)), met(&Solution::of(&other)));
    }
}
