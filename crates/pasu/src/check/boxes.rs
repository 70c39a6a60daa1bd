//! A tree of bounding boxes: which of many triangles may touch one of them.
//!
//! Of our own because of the time: with the trees of boxes that libraries have (`rstar`) the checks of a pot take three times as long, which is more than anybody should wait.

use core::ops::{ControlFlow, Range};

use crate::watch;

type Point = [f32; 3];

/// No more triangles than this are asked for one by one: of half as many the search takes longer.
const TOGETHER: usize = 8;

/// So many boxes are held against each other between two looks at whether that is still wanted.
const CHUNK: u64 = 1 << 12;

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
    /// The first node that is not in it.
    next: u32,
    /// Of a node that has none in it: its triangles.
    first: u32,
    n: u32,
}

impl Node {
    /// Which triangles it has, if it has no halves.
    fn triangles(&self) -> Option<Range<usize>> {
        let first = self.first as usize;
        (self.n > 0).then(|| first..first + self.n as usize)
    }
}

impl Boxes {
    pub(super) fn new(mut triangles: Vec<Bounded>) -> Boxes {
        let mut nodes = Vec::with_capacity(triangles.len());
        build(&mut nodes, &mut triangles, 0);
        Boxes { nodes, triangles }
    }

    /// Calls with the numbers of every two triangles whose boxes touch, the lower first, once each, until it says that this is enough. Boxes are held against boxes, so that what is
    /// far from each other is told apart by the thousand.
    pub(super) fn pairs(&self, mut visit: impl FnMut(u32, u32) -> ControlFlow<()>) {
        let mut open: Vec<(u32, u32)> = if self.triangles.is_empty() { Vec::new() } else { vec![(0, 0)] };
        let mut n_seen = 0;
        while let Some((one, other)) = open.pop() {
            n_seen += 1;
            if n_seen >= CHUNK {
                watch::work(n_seen);
                n_seen = 0;
                if watch::is_stopped() {
                    return;
                }
            }
            let (a, b) = (&self.nodes[one as usize], &self.nodes[other as usize]);
            if one == other {
                match a.triangles() {
                    Some(range) => {
                        for (i, p) in self.triangles[range.clone()].iter().enumerate() {
                            if self.beside(p, range.start + i + 1..range.end, &mut visit).is_break() {
                                return;
                            }
                        }
                    }
                    None => {
                        let [left, right] = self.halves(one);
                        self.put(&mut open, left, right);
                        open.extend([(right, right), (left, left)]);
                    }
                }
                continue;
            }
            match (a.triangles(), b.triangles()) {
                (Some(these), Some(those)) => {
                    for p in &self.triangles[these] {
                        if touch((&p.low, &p.high), (&b.low, &b.high))
                            && self.beside(p, those.clone(), &mut visit).is_break()
                        {
                            return;
                        }
                    }
                }
                // The one in which there are more is halved.
                (None, those) if those.is_some() || self.n_nodes(one) >= self.n_nodes(other) => {
                    let [left, right] = self.halves(one);
                    self.put(&mut open, left, other);
                    self.put(&mut open, right, other);
                }
                _ => {
                    let [left, right] = self.halves(other);
                    self.put(&mut open, one, left);
                    self.put(&mut open, one, right);
                }
            }
        }
        watch::work(n_seen);
    }

    /// Two nodes are looked into if their boxes touch.
    fn put(&self, open: &mut Vec<(u32, u32)>, one: u32, other: u32) {
        let (a, b) = (&self.nodes[one as usize], &self.nodes[other as usize]);
        if touch((&a.low, &a.high), (&b.low, &b.high)) {
            open.push((one, other));
        }
    }

    /// Those of some triangles whose boxes touch that of one.
    fn beside(
        &self,
        one: &Bounded,
        others: Range<usize>,
        visit: &mut impl FnMut(u32, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        for other in &self.triangles[others] {
            if touch((&other.low, &other.high), (&one.low, &one.high)) {
                visit(one.number.min(other.number), one.number.max(other.number))?;
            }
        }
        ControlFlow::Continue(())
    }

    fn halves(&self, node: u32) -> [u32; 2] {
        [node + 1, self.nodes[node as usize + 1].next]
    }

    fn n_nodes(&self, node: u32) -> u32 {
        self.nodes[node as usize].next - node
    }

    /// How many triangles of those that count there are whose boxes touch that of this one, itself among them.
    pub(super) fn n_beside(&self, one: &Bounded, counts: impl Fn(u32) -> bool) -> usize {
        let (mut index, mut n_seen, mut n_found) = (0, 0, 0);
        while let Some(node) = self.nodes.get(index) {
            n_seen += 1;
            if !touch((&node.low, &node.high), (&one.low, &one.high)) {
                index = node.next as usize;
                continue;
            }
            let within = node.triangles().unwrap_or_default();
            let touches = |other: &&Bounded| touch((&other.low, &other.high), (&one.low, &one.high));
            n_found += self.triangles[within].iter().filter(touches).filter(|other| counts(other.number)).count();
            index += 1;
        }
        watch::work(n_seen);
        n_found
    }
}

type Extent<'a> = (&'a Point, &'a Point);

fn touch((low, high): Extent, (other_low, other_high): Extent) -> bool {
    // Without branches: whether two boxes touch is hard to foresee.
    let mut is_touching = true;
    for i in 0..3 {
        is_touching &= (low[i] <= other_high[i]) & (other_low[i] <= high[i]);
    }
    is_touching
}

/// Appends the node of these triangles, of which there are `before` before them, and all that is in it.
fn build(nodes: &mut Vec<Node>, triangles: &mut [Bounded], before: usize) {
    watch::work(triangles.len() as u64);
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for triangle in triangles.iter() {
        for i in 0..3 {
            low[i] = low[i].min(triangle.low[i]);
            high[i] = high[i].max(triangle.high[i]);
        }
    }
    let this = nodes.len();
    let is_last = triangles.len() <= TOGETHER;
    let n = if is_last { triangles.len() as u32 } else { 0 };
    nodes.push(Node { low, high, next: 0, first: before as u32, n });
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
            let mut found = Vec::new();
            boxes.pairs(|one, other| {
                found.push((one, other));
                ControlFlow::Continue(())
            });
            found.sort_unstable();
            let mut expected = Vec::new();
            for one in &triangles {
                let beside = |other: &&Bounded| touch((&other.low, &other.high), (&one.low, &one.high));
                let later = triangles.iter().filter(beside).filter(|other| other.number > one.number);
                expected.extend(later.map(|other| (one.number, other.number)));
                assert_eq!(
                    boxes.n_beside(one, |_| true),
                    triangles.iter().filter(beside).count(),
                    "{n}: {}",
                    one.number
                );
            }
            assert_eq!(found, expected, "{n}");
            assert!(n < 300 || found.len() > 100 && found.len() < 30_000, "{}", found.len());
            let mut n_visited = 0;
            boxes.pairs(|_, _| {
                n_visited += 1;
                if n_visited < 9 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            });
            assert_eq!(n_visited, expected.len().min(9), "{n}");
        }
    }
}
