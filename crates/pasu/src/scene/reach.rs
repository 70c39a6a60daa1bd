//! How far a part reaches in a direction.

use std::collections::BinaryHeap;

use glam::DVec3;

use super::border::Border;
use super::boxes::Within;
use super::budget::Budget;
use super::open::Open;
use super::space::{Space, Tiles};
use super::tile::Tile;

/// The most boxes and tiles that are looked at for how far a part reaches in one direction.
const MOST: usize = 4000;

/// So many boxes that are halved count as one pair of tiles.
const BOXES: u32 = 8;

/// What is still to be looked at.
enum What {
    Node(u32),
    /// A tile, and whether it is to be halved along `u` to know more, where that matters.
    Tile(Box<Tile>, Option<bool>),
}

impl Space {
    /// How far the part reaches in a direction at most, to within `enough` unless that takes too long, and the furthest place that was seen.
    pub(super) fn reach(&self, direction: DVec3, enough: f64, budget: &mut Budget) -> (f64, DVec3) {
        let by_formula = self.reach_by_formula(direction);
        by_formula.unwrap_or_else(|| self.tiles().reach(&self.borders, direction, enough, budget))
    }
}

impl Tiles {
    /// The same of what they enclose; their borders are these.
    pub(super) fn reach(&self, borders: &[Border], direction: DVec3, enough: f64, budget: &mut Budget) -> (f64, DVec3) {
        let of_tile = |tile: &Tile| {
            let corners = tile.corners.map(|at| (at.dot(direction), at));
            corners.into_iter().fold(corners[0], |most, corner| if corner.0 > most.0 { corner } else { most })
        };
        let of_node = |node: u32| {
            let bounds = self.boxes.bounds(node);
            let farthest = DVec3::select(direction.cmpge(DVec3::ZERO), bounds.high, bounds.low);
            farthest.dot(direction)
        };
        let mut open = BinaryHeap::new();
        // The furthest first.
        let entry = |most: f64, of: What| Open { least: -most, rank: 0.0, of };
        open.extend(self.boxes.root().map(|root| entry(of_node(root), What::Node(root))));
        let middle = self.boxes.root().map_or(DVec3::ZERO, |root| self.boxes.bounds(root).middle());
        let mut reached = (f64::NEG_INFINITY, middle);
        let mut n_boxes = 0;
        for _ in 0..MOST {
            let Some(Open { least, of, .. }) = open.pop() else { break };
            let most = -least;
            if most <= reached.0 + enough {
                return (most, reached.1);
            }
            let is_paid = match &of {
                What::Node(node) if matches!(self.boxes.within(*node), Within::Halves(_)) => {
                    n_boxes += 1;
                    n_boxes % BOXES > 0 || budget.take(1)
                }
                _ => budget.take(1),
            };
            if !is_paid {
                return (most, reached.1);
            }
            let mut look = |tile: Tile| {
                let (corner, at) = of_tile(&tile);
                if corner > reached.0 {
                    reached = (corner, at);
                }
                let (beyond, is_along) = match tile.deviation > enough {
                    true => tile.beyond(borders, direction),
                    false => (tile.deviation, None),
                };
                open.push(entry((corner + beyond).min(most), What::Tile(Box::new(tile), is_along)));
            };
            match of {
                What::Node(node) => match self.boxes.within(node) {
                    Within::Thing(tile) => look(self.all[tile]),
                    Within::Halves(halves) => {
                        open.extend(halves.map(|half| entry(of_node(half).min(most), What::Node(half))));
                    }
                },
                What::Tile(tile, is_along) => match tile.halves_along(borders, is_along) {
                    Some(halves) => halves.into_iter().for_each(look),
                    None => return (most, reached.1),
                },
            }
        }
        (open.peek().map_or(reached.0, |open| -open.least), reached.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::solution::Solution;

    /// What is furthest of the tetrahedron round a hollow octant may be in the middle of an edge of that, far from the octant.
    #[test]
    fn the_furthest_place_of_a_hollow_octant_is_one_of_its_own() {
        let part = r#"{ "shape": { "kind": "octant", "exponents": [0.4, 0.4, 0.4] }, "place": { "scale": [2, 2, 2], "shift": [1, 2, 3] } }"#;
        let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{part}] }}"#)).unwrap();
        let space = Solution::of(&design).in_space(0).unwrap();
        for direction in [DVec3::new(1.0, 1.0, 0.0), DVec3::ONE, DVec3::X, -DVec3::ONE, DVec3::new(1.0, 0.999, 0.2)] {
            let (most, at) = space.reach(direction.normalize(), 1e-9, &mut Budget::new(1000));
            // But for rounding, which may put a place of the border outside.
            assert!(space.nearest(at).distance < 1e-9 || space.holds(at) == Some(true), "{direction} {at}");
            assert!(at.dot(direction.normalize()) <= most + 1e-12, "{direction} {at} {most}");
        }
    }
}
