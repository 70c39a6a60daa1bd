//! Boxes round boxes of things that have a place, of which a search looks into hardly any.

use glam::DVec3;

use crate::watch;

/// No more things than this are looked at one by one.
const TOGETHER: usize = 8;

/// Halvings of as many things as there can be, twice over: the most nodes that a search can have put aside.
pub(super) const DEEPEST: usize = 64;

/// What a box can go round.
pub(super) trait Bounded {
    /// Its least and its largest coordinates.
    fn bounds(&self) -> [DVec3; 2];
}

impl Bounded for DVec3 {
    fn bounds(&self) -> [DVec3; 2] {
        [*self; 2]
    }
}

/// Things in boxes round boxes, halved across the widest side until there are few in one. A node is followed by its first half and all that is in that.
#[derive(Debug)]
pub(super) struct Boxes<T> {
    nodes: Vec<Node>,
    things: Vec<T>,
}

/// A box and where what is in it begins.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
    /// The second half; of a node that has no halves 0.
    second: u32,
    first: u32,
    n: u32,
}

/// What is in a box.
pub(super) enum Inside<'a, T> {
    /// Few things.
    Things(&'a [T]),
    /// The numbers of two boxes.
    Halves([usize; 2]),
}

impl<T: Bounded> Boxes<T> {
    pub(super) fn new(mut things: Vec<T>) -> Self {
        let mut nodes = Vec::with_capacity(things.len() / 2 + 1);
        build(&mut nodes, &mut things, 0);
        Boxes { nodes, things }
    }

    /// The box of this number; 0 is round everything.
    pub(super) fn node(&self, number: usize) -> &Node {
        &self.nodes[number]
    }

    pub(super) fn inside(&self, number: usize) -> Inside<'_, T> {
        let node = &self.nodes[number];
        if node.second == 0 {
            Inside::Things(&self.things[node.first as usize..(node.first + node.n) as usize])
        } else {
            Inside::Halves([number + 1, node.second as usize])
        }
    }
}

/// Appends the node of these things, of which there are `before` before them, and all that is in it.
fn build<T: Bounded>(nodes: &mut Vec<Node>, things: &mut [T], before: usize) {
    watch::work(things.len() as u64);
    let bounds = || things.iter().map(Bounded::bounds);
    let low = bounds().fold(DVec3::INFINITY, |low, [least, _]| low.min(least));
    let high = bounds().fold(DVec3::NEG_INFINITY, |high, [_, most]| high.max(most));
    let this = nodes.len();
    nodes.push(Node { low, high, second: 0, first: before as u32, n: things.len() as u32 });
    if things.len() > TOGETHER {
        let axis = (high - low).max_position();
        let half = things.len() / 2;
        let middle = |thing: &T| thing.bounds().map(|corner| 0.5 * corner[axis]).iter().sum::<f64>();
        things.select_nth_unstable_by(half, |one, other| middle(one).total_cmp(&middle(other)));
        let (lower, upper) = things.split_at_mut(half);
        build(nodes, lower, before);
        nodes[this].second = nodes.len() as u32;
        build(nodes, upper, before + half);
    }
}
