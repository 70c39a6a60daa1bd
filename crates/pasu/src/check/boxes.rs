//! A tree of bounding boxes: which of many triangles may touch one of them.
//!
//! Of our own because of the time: with the trees of boxes that libraries have (`rstar`) the checks of a pot take three times as long, which is more than anybody should wait.

use core::ops::{ControlFlow, Range};

use glam::Vec3A;

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
    /// Of a group no two cross each other.
    group: Option<u32>,
    low: Vec3A,
    high: Vec3A,
}

impl Bounded {
    /// The box round the corners of a triangle.
    pub(super) fn of(number: u32, group: Option<u32>, corners: [Point; 3]) -> Bounded {
        let [a, b, c] = corners.map(Vec3A::from_array);
        Bounded { number, group, low: a.min(b).min(c), high: a.max(b).max(c) }
    }

    pub(super) fn touches(&self, other: &Bounded) -> bool {
        touch((self.low, self.high), (other.low, other.high))
    }
}

/// Boxes round boxes, halved across the longest side until there are few in one. A node is followed by all that is in it.
pub(super) struct Boxes {
    nodes: Vec<Node>,
    triangles: Vec<Bounded>,
}

struct Node {
    low: Vec3A,
    high: Vec3A,
    /// The first node that is not in it.
    next: u32,
    /// Of a node that has none in it: its triangles.
    first: u32,
    n: u32,
    /// The group that all its triangles are of.
    group: Option<u32>,
}

impl Node {
    /// Which triangles it has, if it has no halves.
    fn triangles(&self) -> Option<Range<usize>> {
        let first = self.first as usize;
        (self.n > 0).then(|| first..first + self.n as usize)
    }
}

impl Boxes {
    /// Of each group there is a branch of its own, so that what is known not to cross is passed over at once, and the two sides of a wall are not in one box.
    pub(super) fn new(mut triangles: Vec<Bounded>) -> Boxes {
        let mut nodes = Vec::with_capacity(triangles.len());
        triangles.sort_by_key(|triangle| triangle.group);
        let mut groups = Vec::new();
        let mut first = 0;
        for group in triangles.chunk_by(|one, other| one.group == other.group) {
            let (low, high) = around(group);
            groups.push(Group { triangles: first..first + group.len(), low, high });
            first += group.len();
        }
        build_groups(&mut nodes, &mut groups, &mut triangles);
        Boxes { nodes, triangles }
    }

    /// Calls with the numbers of every two triangles that are not of one group and whose boxes touch, the lower first, once each, until it says that this is enough. Boxes are held against boxes, so that what is
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
            if a.group.is_some() && a.group == b.group {
                continue;
            }
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
                        if touch((p.low, p.high), (b.low, b.high))
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
        if touch((a.low, a.high), (b.low, b.high)) {
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
            if touch((other.low, other.high), (one.low, one.high)) {
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

    /// How many triangles there are that are not of its group and whose boxes touch that of this one, itself among them if it is of none.
    pub(super) fn n_beside(&self, one: &Bounded) -> usize {
        let mut n_found = 0;
        self.each_beside(one, |_| n_found += 1);
        n_found
    }

    /// Calls with the number of each of these.
    pub(super) fn each_beside(&self, one: &Bounded, mut visit: impl FnMut(u32)) {
        let (mut index, mut n_seen) = (0, 0);
        while let Some(node) = self.nodes.get(index) {
            n_seen += 1;
            let is_apart = one.group.is_some() && one.group == node.group;
            if is_apart || !touch((node.low, node.high), (one.low, one.high)) {
                index = node.next as usize;
                continue;
            }
            let within = node.triangles().unwrap_or_default();
            let touches = |other: &&Bounded| touch((other.low, other.high), (one.low, one.high));
            self.triangles[within].iter().filter(touches).for_each(|other| visit(other.number));
            index += 1;
        }
        watch::work(n_seen);
    }
}

fn touch((low, high): (Vec3A, Vec3A), (other_low, other_high): (Vec3A, Vec3A)) -> bool {
    // Without branches: whether two boxes touch is hard to foresee.
    (low.cmple(other_high) & other_low.cmple(high)).all()
}

/// The triangles of one group, or of none.
struct Group {
    triangles: Range<usize>,
    low: Vec3A,
    high: Vec3A,
}

/// Appends the node of these groups, and all that is in it.
fn build_groups(nodes: &mut Vec<Node>, groups: &mut [Group], triangles: &mut [Bounded]) {
    let [.., _, _] = groups else {
        for Group { triangles: range, .. } in groups {
            build(nodes, &mut triangles[range.clone()], range.start);
        }
        return;
    };
    let (low, high) = groups.iter().fold(NOTHING, |(low, high), group| (low.min(group.low), high.max(group.high)));
    let this = nodes.len();
    nodes.push(Node { low, high, next: 0, first: 0, n: 0, group: None });
    let half = groups.len() / 2;
    let axis = longest(high - low);
    let middle = |of: &Group| 0.5 * of.low[axis] + 0.5 * of.high[axis];
    groups.select_nth_unstable_by(half, |one, other| middle(one).total_cmp(&middle(other)));
    let (lower, upper) = groups.split_at_mut(half);
    build_groups(nodes, lower, triangles);
    build_groups(nodes, upper, triangles);
    nodes[this].next = nodes.len() as u32;
}

/// Appends the node of these triangles of one group, of which there are `before` before them, and all that is in it.
fn build(nodes: &mut Vec<Node>, triangles: &mut [Bounded], before: usize) {
    watch::work(triangles.len() as u64);
    let (low, high) = around(triangles);
    let this = nodes.len();
    let is_last = triangles.len() <= TOGETHER;
    let n = if is_last { triangles.len() as u32 } else { 0 };
    let group = triangles.first().and_then(|first| first.group);
    nodes.push(Node { low, high, next: 0, first: before as u32, n, group });
    if !is_last {
        let axis = longest(high - low);
        let half = triangles.len() / 2;
        let middle = |of: &Bounded| 0.5 * of.low[axis] + 0.5 * of.high[axis];
        triangles.select_nth_unstable_by(half, |one, other| middle(one).total_cmp(&middle(other)));
        let (lower, upper) = triangles.split_at_mut(half);
        build(nodes, lower, before);
        build(nodes, upper, before + half);
    }
    nodes[this].next = nodes.len() as u32;
}

const NOTHING: (Vec3A, Vec3A) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);

fn around(triangles: &[Bounded]) -> (Vec3A, Vec3A) {
    triangles.iter().fold(NOTHING, |(low, high), triangle| (low.min(triangle.low), high.max(triangle.high)))
}

/// The number of the axis along which something is longest.
fn longest(width: Vec3A) -> usize {
    let axis = if width.y > width.x { 1 } else { 0 };
    if width.z > width[axis] { 2 } else { axis }
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
        for (n, n_groups) in [0, 1, 4, 5, 9, 300].into_iter().flat_map(|n| [(n, 0), (n, 3)]) {
            let mut triangle = |number: u32| {
                let at = [(); 3].map(|()| random());
                // Some are of a group, some of none, and what is of one lies together.
                let group = (at[0] * (n_groups + 1) as f32) as u32;
                let group = (group < n_groups).then_some(group);
                Bounded::of(number, group, [(); 3].map(|()| at.map(|x| x + 0.2 * random())))
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
                let is_other = |other: &Bounded| one.group.is_none() || one.group != other.group;
                let beside = |other: &&Bounded| is_other(other) && touch((other.low, other.high), (one.low, one.high));
                let later = triangles.iter().filter(beside).filter(|other| other.number > one.number);
                expected.extend(later.map(|other| (one.number, other.number)));
                assert_eq!(boxes.n_beside(one), triangles.iter().filter(beside).count(), "{n}: {}", one.number);
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
