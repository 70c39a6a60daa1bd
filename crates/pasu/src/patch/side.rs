//! What a patch meets at its border.

/// What one side of a patch is. The sides are numbered `u = 0`, `u = 1`, `v = 0`, `v = 1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// An edge of the surface.
    Free,
    /// All of it is one point.
    Pole,
    /// The patch meets itself there: the opposite side is the same curve, passed in the same direction.
    Joined,
    /// Another patch of the same surface has the same curve as its side `side`; `is_reversed` where the two pass it in opposite directions.
    Shared { patch: usize, side: usize, is_reversed: bool },
}
