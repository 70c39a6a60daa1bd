//! What a mode problem can lack.

/// Why a mode problem has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unsolvable {
    /// The shape control parameter of the highest derivative is 0.
    NoHighestDerivative,
    /// Oscillating solutions whose boundary matrix is singular, or so nearly that no digit of the answer could be promised.
    Resonant,
    /// The numbers leave the range of doubles.
    Overflow,
    /// Two rings, or a ring and an end, are so near each other that slopes could not be told.
    Crowded,
}
