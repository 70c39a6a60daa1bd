//! Bounding boxes in a tree, to find those that overlap.

use core::ops::ControlFlow;

/// A box along the axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    low: [f32; 3],
    high: [f32; 3],
}

impl Bounds {
    /// The box of some points.
    pub(super) fn of(points: &[[f32; 3]; 3]) -> Bounds {
        let [a, b, c] = points;
        Bounds {
            low: core::array::from_fn(|i| a[i].min(b[i]).min(c[i])),
            high: core::array::from_fn(|i| a[i].max(b[i]).max(c[i])),
        }
    }

    fn with(&self, other: &Bounds) -> Bounds {
        Bounds {
            low: core::array::from_fn(|i| self.low[i].min(other.low[i])),
            high: core::array::from_fn(|i| self.high[i].max(other.high[i])),
        }
    }

    fn overlaps(&self, other: &Bounds) -> bool {
        (0..3).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }

    /// Twice the middle along an axis.
    fn middle(&self, axis: usize) -> f32 {
        self.low[axis] + self.high[axis]
    }

    fn longest_axis(&self) -> usize {
        let length = |axis: usize| self.high[axis] - self.low[axis];
        let longer = |a: usize, b: usize| if length(b) > length(a) { b } else { a };
        longer(longer(0, 1), 2)
    }
}

/// A leaf holds no more boxes than this.
const LEAF: usize = 4;

/// A node of the tree: the boxes of a range, and its halves unless it is a leaf.
#[derive(Debug)]
struct Node {
    bounds: Bounds,
    from: u32,
    to: u32,
    /// The numbers of its halves.
    halves: Option<[u32; 2]>,
}

/// Numbered boxes, halved again and again along the longest side of what they fill.
#[derive(Debug)]
pub(super) struct Boxes {
    /// In the order of the leaves.
    boxes: Vec<(Bounds, u32)>,
    nodes: Vec<Node>,
}

impl Boxes {
    /// Boxes with the numbers 0, 1, 2 and so on.
    pub(super) fn new(boxes: Vec<Bounds>) -> Boxes {
        let mut tree = Boxes { boxes: boxes.into_iter().zip(0..).collect(), nodes: Vec::new() };
        if !tree.boxes.is_empty() {
            tree.grow(0, tree.boxes.len());
        }
        tree
    }

    fn grow(&mut self, from: usize, to: usize) -> u32 {
        let boxes = &mut self.boxes[from..to];
        let bounds = boxes.iter().skip(1).fold(boxes[0].0, |all, (each, _)| all.with(each));
        let number = self.nodes.len();
        self.nodes.push(Node { bounds, from: from as u32, to: to as u32, halves: None });
        if to - from > LEAF {
            let axis = bounds.longest_axis();
            let half = (to - from) / 2;
            boxes.select_nth_unstable_by(half, |(a, i), (b, j)| {
                a.middle(axis).total_cmp(&b.middle(axis)).then(i.cmp(j))
            });
            let halves = [self.grow(from, from + half), self.grow(from + half, to)];
            self.nodes[number].halves = Some(halves);
        }
        number as u32
    }

    /// Calls once with each pair of boxes that have a point in common, until told to stop.
    pub(super) fn overlapping(&self, mut visit: impl FnMut(u32, u32) -> ControlFlow<()>) {
        let mut waiting = Vec::new();
        if !self.nodes.is_empty() {
            waiting.push((0, 0));
        }
        while let Some((a, b)) = waiting.pop() {
            let (one, other) = (&self.nodes[a as usize], &self.nodes[b as usize]);
            if a == b {
                match one.halves {
                    Some([left, right]) => waiting.extend([(right, right), (left, right), (left, left)]),
                    None => {
                        for i in one.from..one.to {
                            if self.row(i, i + 1, one.to, &mut visit).is_break() {
                                return;
                            }
                        }
                    }
                }
            } else if one.bounds.overlaps(&other.bounds) {
                // The one with more boxes is halved, so that both are leaves in the end.
                match (one.halves, other.halves) {
                    (Some([left, right]), _) if one.to - one.from >= other.to - other.from => {
                        waiting.extend([(right, b), (left, b)]);
                    }
                    (_, Some([left, right])) => waiting.extend([(a, right), (a, left)]),
                    (Some([left, right]), None) => waiting.extend([(right, b), (left, b)]),
                    (None, None) => {
                        for i in one.from..one.to {
                            if self.row(i, other.from, other.to, &mut visit).is_break() {
                                return;
                            }
                        }
                    }
                }
            }
        }
    }

    /// One box against those of a range.
    fn row(
        &self,
        one: u32,
        from: u32,
        to: u32,
        visit: &mut impl FnMut(u32, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let (bounds, number) = self.boxes[one as usize];
        for (other, of) in &self.boxes[from as usize..to as usize] {
            if bounds.overlaps(other) {
                visit(number, *of)?;
            }
        }
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_is_found_once() {
        let turn = |i: u32, n: u32| (i * i * 7 % n) as f32 / n as f32;
        for n in [0, 1, 4, 5, 9, 300] {
            let boxes: Vec<Bounds> = (0..n)
                .map(|i| {
                    let low = [turn(i, 101), turn(i + 3, 103), turn(i + 5, 107)];
                    Bounds { low, high: low.map(|x| x + 0.15 * turn(i, 13)) }
                })
                .collect();
            let mut found = Vec::new();
            let tree = Boxes::new(boxes.clone());
            tree.overlapping(|a, b| {
                found.push((a.min(b), a.max(b)));
                ControlFlow::Continue(())
            });
            found.sort_unstable();
            let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
            let expected: Vec<_> = pairs.filter(|(i, j)| boxes[*i as usize].overlaps(&boxes[*j as usize])).collect();
            assert_eq!(found, expected);
            let mut calls = 0;
            tree.overlapping(|_, _| {
                calls += 1;
                ControlFlow::Break(())
            });
            assert_eq!(calls, usize::from(!expected.is_empty()));
        }
    }
}
