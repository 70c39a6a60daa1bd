//! Octants of superspheres (ASB88): `x^a + y^b + z^c <= 1`, `x, y, z >= 0`, from their exponents to patches, moments and what is inside.
//!
//! Where an exponent is below 2 the curved side bends without bound at an edge, and where it is large it bends sharply between. Its parameters slow down towards the edges by powers that the exponents ask for, so that `X` has bounded
//! second derivatives all over its square ([`Climb`](climb::Climb)), and what holds a tolerance on any patch holds it here.

mod climb;
mod curved;
mod flat;
mod inside;
mod lines;
mod moments;
mod solved;

pub(crate) use solved::Supersphere;
