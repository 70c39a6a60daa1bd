//! What the benchmarks have in common: the designs they measure and the numerical baseline they compare with.
//!
//! Never shipped. `cargo xtask bench` runs it.

pub mod blend_differences;
pub mod designs;
pub mod finite_difference;
pub mod rounds;
pub mod storage;
