//! What keeps the contract of a face within this crate.

/// Nobody outside can name it, and so nobody outside can implement what asks for it.
pub trait Sealed {}
