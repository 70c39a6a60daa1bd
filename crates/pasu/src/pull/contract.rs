//! What a hand asks and what it gets.

use crate::answer::answers;
use crate::design::Design;

/// A hand that takes hold of a point and pulls it somewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Hand {
    /// The point that is taken hold of: `(u, v)`, as [`evaluate`](crate::evaluate) takes it.
    pub at: [f64; 2],
    /// Where it is pulled, before placement.
    pub to: [f64; 3],
    /// The angle, in radians, between the two places beside the point where the pull is half as strong. All round the axis if there is none.
    pub width: Option<f64>,
    /// At how many places round the axis the same is done. One if there is none.
    pub petals: Option<u32>,
    /// What stays as it is: `r1` or `eta[0]` of a named family; `r`, `z` or `v` of a pot of rings; `x`, `y` or `z` of boundary data that are written out.
    pub keep: Vec<String>,
}

answers! {
    /// A design whose part was pulled.
    pub struct Pulled as "Pulled" {
        /// The design.
        pub design: Design,
        /// The point that was to arrive: where the hand took hold, but of a pot of rings that is pulled round the axis with another `v`.
        pub at: [f64; 2],
        /// The distance between the point and where it was pulled: 0 but for rounding where the shape can follow.
        pub behind: f64,
    }
}

impl Hand {
    /// One that pulls a point all round the axis and leaves everything free.
    ///
    /// ```
    /// let hand = pasu::Hand::new([0.5, 0.0], [2.0, 0.0, 1.0]);
    /// assert!(hand.width.is_none() && hand.keep.is_empty());
    /// ```
    pub fn new(at: [f64; 2], to: [f64; 3]) -> Hand {
        Hand { at, to, width: None, petals: None, keep: Vec::new() }
    }
}
