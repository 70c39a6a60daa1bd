//! Sets that grow together, of members each of which is for or against the others of its set.

/// A partition of `0..n` into sets, with a sign between any two members of a set (B. A. Galler and M. J. Fischer, *An improved equivalence algorithm*, 1964, with signs).
#[derive(Debug, Clone)]
pub(crate) struct SignedSets {
    /// The member above each, or itself.
    above: Vec<u32>,
    /// Whether it is against that.
    is_against: Vec<bool>,
    size: Vec<u32>,
    /// Of the top of a set: whether a member of it is against itself.
    is_contradicted: Vec<bool>,
}

impl SignedSets {
    /// Every member by itself.
    pub(crate) fn new(n: usize) -> SignedSets {
        SignedSets {
            above: (0..n as u32).collect(),
            is_against: vec![false; n],
            size: vec![1; n],
            is_contradicted: vec![false; n],
        }
    }

    /// The member that stands for the set of one, and whether that is against it.
    pub(crate) fn find(&mut self, member: usize) -> (usize, bool) {
        let (mut top, mut is_against) = (member, false);
        while self.above[top] as usize != top {
            is_against ^= self.is_against[top];
            top = self.above[top] as usize;
        }
        // Everyone on the way is put right below the top.
        let (mut next, mut left) = (member, is_against);
        while self.above[next] as usize != top && next != top {
            let (above, was_against) = (self.above[next] as usize, self.is_against[next]);
            (self.above[next], self.is_against[next]) = (top as u32, left);
            left ^= was_against;
            next = above;
        }
        (top, is_against)
    }

    /// Joins two sets by two of their members, which are against each other or not.
    pub(crate) fn join(&mut self, one: usize, other: usize, are_against: bool) {
        let ((mut top, one), (mut below, other)) = (self.find(one), self.find(other));
        let is_against = one ^ other ^ are_against;
        if top == below {
            self.is_contradicted[top] |= is_against;
            return;
        }
        if self.size[top] < self.size[below] {
            core::mem::swap(&mut top, &mut below);
        }
        (self.above[below], self.is_against[below]) = (top as u32, is_against);
        self.size[top] += self.size[below];
        self.is_contradicted[top] |= self.is_contradicted[below];
    }

    /// Whether a member of the set that this one stands for was found to be against itself.
    pub(crate) fn is_contradicted(&self, top: usize) -> bool {
        self.is_contradicted[top]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_are_products_along_any_way() {
        let mut sets = SignedSets::new(8);
        for (one, other, are_against) in
            [(0, 1, true), (2, 3, true), (1, 2, true), (4, 5, false), (6, 4, true), (3, 0, true)]
        {
            sets.join(one, other, are_against);
        }
        let found: Vec<(usize, bool)> = (0..8).map(|member| sets.find(member)).collect();
        let against =
            |one: usize, other: usize| (found[one].0 == found[other].0).then_some(found[one].1 ^ found[other].1);
        assert_eq!((against(0, 1), against(0, 2), against(0, 3)), (Some(true), Some(false), Some(true)));
        assert_eq!((against(4, 5), against(6, 5), against(0, 4), against(7, 6)), (Some(false), Some(true), None, None));
        assert!((0..8).all(|member| !sets.is_contradicted(found[member].0)));
        sets.join(3, 1, true);
        assert!(sets.is_contradicted(sets.clone().find(2).0) && !sets.is_contradicted(sets.clone().find(5).0));
        // Of a set that was contradicted before it grew.
        sets.join(5, 0, false);
        assert!(sets.is_contradicted(sets.clone().find(6).0));
    }
}
