//! The mode problem: one scalar two-point boundary value problem with constant coefficients.
//!
//! Every closed form of ZY01 and IA is a sum of `A_n(u) cos(k v) + B_n(u) sin(k v)`, and every `A_n`, `B_n` solves
//!
//! ```text
//! order 2:   s q''   - t k^2 q             = f(u)      q(0), q(1) given                  (ZY01 eq 6, corrected)
//! order 4:   s q'''' - t k^2 q'' + w k^4 q = f(u)      q(0), q'(0), q(1), q'(1) given    (ZY01 eqs 14-17; IA eqs 7-14)
//! ```
//!
//! **How it is solved.** With `x = u - 1/2` the problem splits into an even and an odd half, each with at most two unknowns.
//! An [`Equation`] chooses functions that stay independent for its rates ([`basis`]): a power series while every rate is small, products
//! `cosh(sigma x) cosh(delta x)` of half sum and half difference of the roots while these are near each other or complex, and the two
//! roots by themselves once they are apart. Hyperbolic functions are carried as exponentials that decay from both ends, so that no
//! rate overflows. The force is met by a particular polynomial ([`force`]).

mod basis;
mod bays;
mod beam;
mod equation;
mod expansion;
mod force;
mod order;
mod pair;
mod rate;
mod ring;
mod roots;
mod series;
mod slow;
mod solution;
mod solve;
mod stiffness;
mod supremum;
mod unsolvable;

pub(crate) use bays::{Bays, CLOSEST};
pub(crate) use beam::{Beam, Broken, Deflection, Held};
pub use equation::Equation;
pub(crate) use expansion::{Expansion, ROUNDING, TERMS};
pub use order::Order;
pub use ring::{Free, Ring};
pub use solution::{ModeData, ModeSolution};
pub use unsolvable::Unsolvable;
