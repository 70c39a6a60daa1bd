//! What is still to be looked at where something near is sought.

use std::cmp::Ordering;

/// One of several things, of which a heap gives out the one first that may be nearest.
pub(super) struct Open<T> {
    /// It is no nearer than this.
    pub(super) least: f64,
    /// Of those that may be as near the greatest comes first.
    pub(super) rank: f64,
    pub(super) of: T,
}

impl<T> PartialEq for Open<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<T> Eq for Open<T> {}

impl<T> PartialOrd for Open<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T> Ord for Open<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.least.total_cmp(&self.least).then(self.rank.total_cmp(&other.rank))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BinaryHeap;

    use super::*;

    #[test]
    fn the_nearest_comes_first_and_of_equals_the_one_of_greatest_rank() {
        let things = [(2.0, 9.0), (1.0, -1.0), (1.0, 3.0), (f64::INFINITY, 9.0)];
        let mut heap = BinaryHeap::from_iter(things.map(|(least, rank)| Open { least, rank, of: () }));
        let found: Vec<_> = std::iter::from_fn(|| heap.pop().map(|open| (open.least, open.rank))).collect();
        assert_eq!(found, [(1.0, 3.0), (1.0, -1.0), (2.0, 9.0), (f64::INFINITY, 9.0)]);
    }
}
