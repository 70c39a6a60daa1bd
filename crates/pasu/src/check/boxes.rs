//! A tree of bounding boxes: which of many triangles may touch one of them.
//!
//! Of our own because of the time: with the trees of boxes that libraries have (`rstar`) the checks of a pot take three times as long, which is more than anybody should wait.

use crate::watch;

type Point = [f32; 3];

/// No more triangles than this are asked for one by one.
const TOGETHER: usize = 4;

/// A triangle among the others.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounded {
    pub(super) number: u32,
    low: Point,
    high: Point,
}

impl Bounded {
    /// The box round the corners of a triangle.
    pub(super) fn of(number: u32, [a, b, c]: [Point; 3]) -> Bounded {
        let low = core::array::from_fn(|i| a[i].min(b[i]).min(c[i]));
        let high = core::array::from_fn(|i| a[i].max(b[i]).max(c[i]));
        Bounded { number, low, high }
    }
}

/// Boxes round boxes, halved across the longest side until there are few in one. A node is followed by all that is in it.
pub(super) struct Boxes {
    nodes: Vec<Node>,
    triangles: Vec<Bounded>,
}

struct Node {
    low: Point,
    high: Point,
    /// The highest number of a triangle in it.
    highest: u32,
    /// The first node that is not in it.
    next: u32,
    /// Of a node that has none in it: its triangles.
    first: u32,
    n: u32,
}

impl Boxes {
    pub(super) fn new(mut triangles: Vec<Bounded>) -> Boxes {
        let mut nodes = Vec::with_capacity(triangles.len());
        build(&mut nodes, &mut triangles, 0);
        Boxes { nodes, triangles }
    }

    /// Calls with the number of every triangle of a higher number whose box touches that of this one.
    pub(super) fn later(&self, one: &Bounded, mut visit: impl FnMut(u32)) {
        let (mut index, mut n_seen) = (0, 0);
        while let Some(node) = self.nodes.get(index) {
            n_seen += 1;
            if node.highest <= one.number || !touch((&node.low, &node.high), one) {
                index = node.next as usize;
                continue;
            }
            let first = node.first as usize;
            for other in &self.triangles[first..first + node.n as usize] {
                if other.number > one.number && touch((&other.low, &other.high), one) {
                    visit(other.number);
                }
            }
            index += 1;
        }
        watch::work(n_seen);
    }
}

fn touch((low, high): (&Point, &Point), other: &Bounded) -> bool {
    low[0] <= other.high[0]
        && other.low[0] <= high[0]
        && low[1] <= other.high[1]
        && other.low[1] <= high[1]
        && low[2] <= other.high[2]
        && other.low[2] <= high[2]
}

/// Appends the node of these triangles, of which there are `before` before them, and all that is in it.
fn build(nodes: &mut Vec<Node>, triangles: &mut [Bounded], before: usize) {
    watch::work(triangles.len() as u64);
    let (mut low, mut high, mut highest) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3], 0);
    for triangle in triangles.iter() {
        for i in 0..3 {
            low[i] = low[i].min(triangle.low[i]);
            high[i] = high[i].max(triangle.high[i]);
        }
        highest = highest.max(triangle.number);
    }
    let this = nodes.len();
    let is_last = triangles.len() <= TOGETHER;
    let n = if is_last { triangles.len() as u32 } else { 0 };
    nodes.push(Node { low, high, highest, next: 0, first: before as u32, n });
    if !is_last {
        let width = |i: usize| high[i] - low[i];
        let mut axis = if width(1) > width(0) { 1 } else { 0 };
        if width(2) > width(axis) {
            axis = 2;
        }
        let half = triangles.len() / 2;
        let middle = |of: &Bounded| 0.5 * of.low[axis] + 0.5 * of.high[axis];
        triangles.select_nth_unstable_by(half, |one, other| middle(one).total_cmp(&middle(other)));
        let (lower, upper) = triangles.split_at_mut(half);
        build(nodes, lower, before);
        build(nodes, upper, before + half);
    }
    nodes[this].next = nodes.len() as u32;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_of_boxes_that_touch_is_found_once() {
        // Marsaglia's xorshift.
        let mut state = 88_172_645_463_325_252u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 40) as f32 / (1u64 << 24) as f32
        };
        for n in [0, 1, 4, 5, 9, 300] {
            let mut triangle = |number: u32| {
                let at = [(); 3].map(|()| random());
                Bounded::of(number, [(); 3].map(|()| at.map(|x| x + 0.2 * random())))
            };
            let triangles: Vec<Bounded> = (0..n).map(&mut triangle).collect();
            let boxes = Boxes::new(triangles.clone());
            let mut n_found = 0;
            for one in &triangles {
                let mut found = Vec::new();
                boxes.later(one, |other| found.push(other));
                found.sort_unstable();
                let others = triangles.iter().filter(|other| other.number > one.number);
                let expected: Vec<u32> =
                    others.filter(|other| touch((&other.low, &other.high), one)).map(|other| other.number).collect();
                assert_eq!(found, expected, "{n}: {}", one.number);
                n_found += found.len();
            }
            assert!(n < 300 || n_found > 100 && n_found < 30_000, "{n_found}");
        }
    }
}
