//! A tree of boxes: which of many things a point, a ray or another box may meet.
//!
//! Of our own, as that of the checks is, and for less: the hierarchies that libraries have come with all of their geometry (`parry3d` with more code than the solver), and none of them can be asked for pairs and
//! for the nearest in the order of a distance that only we know.

use super::bounds::Bounds;

/// Boxes round boxes, halved across the longest side until each holds one thing.
#[derive(Debug)]
pub(super) struct Boxes {
    nodes: Vec<Node>,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    bounds: Bounds,
    /// The first node that is not in it; the nodes that are in it follow it.
    next: u32,
    /// Of a node that has none in it: the number of its thing.
    thing: u32,
}

/// What a node has in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Within {
    Halves([u32; 2]),
    Thing(usize),
}

impl Boxes {
    /// Round things, each by its number. Those that have no box, because something of theirs is not a number, are left out.
    pub(super) fn new(all: &[Bounds]) -> Boxes {
        let mut things: Vec<(u32, Bounds)> = (0u32..).zip(all.iter().copied()).collect();
        things.retain(|(_, bounds)| bounds.low.cmple(bounds.high).all());
        let mut boxes = Boxes { nodes: Vec::with_capacity(2 * things.len()) };
        if !things.is_empty() {
            boxes.build(&mut things);
        }
        boxes
    }

    fn build(&mut self, things: &mut [(u32, Bounds)]) {
        let bounds = things.iter().fold(Bounds::NOTHING, |all, (_, bounds)| all.with(*bounds));
        let at = self.nodes.len();
        self.nodes.push(Node { bounds, next: 0, thing: things.first().map_or(0, |(number, _)| *number) });
        if things.len() > 1 {
            let middles = things.iter().fold(Bounds::NOTHING, |all, (_, b)| all.with(Bounds::of(&[b.middle()])));
            let sides = middles.high - middles.low;
            let axis = (0..3).fold(0, |longest, axis| if sides[axis] > sides[longest] { axis } else { longest });
            let half = things.len() / 2;
            things.select_nth_unstable_by(half, |(i, one), (j, other)| {
                one.middle()[axis].total_cmp(&other.middle()[axis]).then(i.cmp(j))
            });
            let (before, after) = things.split_at_mut(half);
            self.build(before);
            self.build(after);
        }
        self.nodes[at].next = self.nodes.len() as u32;
    }

    /// The node round all; `None` where there is nothing.
    pub(super) fn root(&self) -> Option<u32> {
        (!self.nodes.is_empty()).then_some(0)
    }

    pub(super) fn bounds(&self, node: u32) -> Bounds {
        self.nodes[node as usize].bounds
    }

    pub(super) fn within(&self, node: u32) -> Within {
        let (first, next) = (node + 1, self.nodes[node as usize].next);
        if first == next {
            Within::Thing(self.nodes[node as usize].thing as usize)
        } else {
            Within::Halves([first, self.nodes[first as usize].next])
        }
    }

    /// Calls with every thing whose box, and all those round it, are met.
    pub(super) fn each(&self, is_met: impl Fn(&Bounds) -> bool, mut visit: impl FnMut(usize)) {
        let mut node = 0;
        while let Some(Node { bounds, next, thing }) = self.nodes.get(node).copied() {
            if !is_met(&bounds) {
                node = next as usize;
                continue;
            }
            node += 1;
            if node == next as usize {
                visit(thing as usize);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn what_is_met_is_what_would_be_found_one_by_one() {
        let all: Vec<Bounds> = (0..200)
            .map(|i| {
                let at = DVec3::new(f64::from(i * 37 % 101), f64::from(i * 53 % 89), f64::from(i * 71 % 97));
                Bounds { low: at, high: at + f64::from(i % 7) }
            })
            .collect();
        let boxes = Boxes::new(&all);
        for i in 0..100 {
            let at = DVec3::new(f64::from(i * 13 % 101), f64::from(i * 29 % 89), f64::from(i * 31 % 97));
            let (mut found, near) = (Vec::new(), |bounds: &Bounds| bounds.distance_to(at) <= 9.0);
            boxes.each(near, |thing| found.push(thing));
            found.sort_unstable();
            let expected: Vec<usize> = (0..all.len()).filter(|thing| near(&all[*thing])).collect();
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn nothing_and_what_is_no_box_are_met_by_nobody() {
        assert_eq!(Boxes::new(&[]).root(), None);
        let none = Bounds { low: DVec3::NAN, high: DVec3::NAN };
        assert_eq!(Boxes::new(&[none, Bounds::NOTHING]).root(), None);
    }

    #[test]
    fn a_ray_meets_a_box_that_it_goes_through() {
        let bounds = Bounds { low: DVec3::splat(-1.0), high: DVec3::splat(1.0) };
        for (origin, direction, is_met) in [
            ([-5.0, 0.5, 0.5], [1.0, 0.0, 0.0], true),
            ([-5.0, 1.5, 0.5], [1.0, 0.0, 0.0], false),
            ([5.0, 0.5, 0.5], [1.0, 0.0, 0.0], false),
            ([0.0, 0.0, 0.0], [0.0, 0.0, -1.0], true),
            ([-3.0, -3.0, -3.0], [1.0, 1.0, 1.0], true),
            ([-3.0, -3.0, 3.0], [1.0, 1.0, 1.0], false),
        ] {
            let inverse = DVec3::from_array(direction).recip();
            assert_eq!(bounds.is_met(DVec3::from_array(origin), inverse), is_met, "{origin:?} {direction:?}");
        }
    }
}
