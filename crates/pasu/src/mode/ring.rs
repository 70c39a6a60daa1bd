//! Curves between the two ends that a surface passes through.

/// A curve of constant `u` inside (0, 1) with given values: a support of every mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Where it is, inside (0, 1).
    pub u: f64,
    /// Whether the profile has a corner there: `q''` is 0 on both sides and `q'` jumps. Otherwise `q''` is continuous. Order 2 has a corner at every ring.
    pub sharp: bool,
}

/// Whether the slope at an end is not given; `q''` is 0 there instead. For order 4 alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Free {
    /// At `u = 0`.
    pub start: bool,
    /// At `u = 1`.
    pub end: bool,
}
