//! Whether a part holds a point.

use glam::DVec3;

use super::budget::Budget;
use super::crossings::{Crossings, SAME};
use super::space::Space;

/// Directions in which the border is counted: no two alike, none along an axis, and always the same.
const DIRECTIONS: [[f64; 3]; 12] = [
    [0.613, 0.391, 0.687],
    [-0.271, 0.842, -0.467],
    [-0.733, -0.519, 0.439],
    [0.387, -0.743, -0.546],
    [0.911, -0.237, 0.337],
    [-0.139, 0.283, 0.949],
    [0.173, -0.317, -0.933],
    [-0.859, 0.461, -0.223],
    [0.541, 0.809, -0.231],
    [-0.479, -0.131, -0.868],
    [0.211, -0.911, 0.355],
    [-0.647, 0.367, 0.668],
];

/// Rays that go in and out by turns settle it at once; of a border that runs through itself, so many that agree on how often it goes round.
const AGREEING: usize = 3;

/// Where so many rays from one place met too many tiles each, so will the next, which nobody waits for who has many places to ask.
const MOST_CUT: usize = 2;

/// So many tiles that a ray meets count as one pair of tiles.
const TILES: u64 = 3;

impl Space {
    /// Whether the part holds a point, its border included to within 1e-9 of its size; `None` where no ray from there tells. What is no solid holds nothing.
    ///
    /// The border is counted along a ray: a point inside of a body leaves it last, and enters and leaves it by turns before. A ray that meets an edge, a tip, or the border along itself tells nothing, and the next one is asked.
    pub(super) fn holds(&self, at: DVec3) -> Option<bool> {
        self.told(at, usize::MAX).0
    }

    /// The same of one of many places, which all have one budget: what rays take beyond what asking counts for is taken from it.
    pub(super) fn holds_within(&self, at: DVec3, budget: &mut Budget) -> Option<bool> {
        let (held, n_tiles) = self.told(at, MOST_CUT);
        budget.take((n_tiles / TILES).saturating_sub(self.asked_for()));
        held
    }

    /// Whether it holds a point, by rays until so many of them met too many tiles, and how many tiles they met.
    fn told(&self, at: DVec3, most_cut: usize) -> (Option<bool>, u64) {
        if !self.is_solid || !self.bounds.holds(at) {
            return (Some(false), 0);
        }
        if let Some(octant) = self.octant() {
            return (Some(octant.holds(self.own(at))), 0);
        }
        let mut counts: Vec<i64> = Vec::new();
        let (mut n_cut, mut n_tiles) = (0, 0);
        for direction in DIRECTIONS {
            let direction = DVec3::from_array(direction).normalize_or(DVec3::Z);
            let crossings = self.crossings(at, direction);
            n_cut += usize::from(crossings.is_cut);
            n_tiles += crossings.n_tiles;
            // On the border itself.
            if crossings.found.iter().any(|crossing| crossing.t <= SAME * self.size()) {
                return (Some(true), n_tiles);
            }
            if n_cut >= most_cut {
                break;
            }
            if !crossings.is_clear {
                continue;
            }
            let Crossings { found, .. } = crossings;
            let is_by_turns =
                found.iter().rev().enumerate().all(|(index, crossing)| crossing.is_out == (index % 2 == 0));
            if is_by_turns {
                return (Some(found.len() % 2 == 1), n_tiles);
            }
            counts.push(found.iter().map(|crossing| if crossing.is_out { 1 } else { -1 }).sum());
            if counts.len() == AGREEING {
                let count = counts[0];
                return (counts.iter().all(|other| *other == count).then_some(count != 0), n_tiles);
            }
        }
        (None, n_tiles)
    }
}
