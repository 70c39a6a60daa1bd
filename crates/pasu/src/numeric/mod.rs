//! Numerical algorithms, each once: quadrature rules, root finders, line minimisers, extrapolation.
//!
//! Nothing here knows what it computes: functions come in, numbers go out, and nothing of the crate is imported. Accuracy and effort are parameters, a remaining constant is named where it stands, and everything comes to an end whatever the function does.

pub(crate) mod adaptive;
pub(crate) mod ascend;
pub(crate) mod ascending;
pub(crate) mod bisection;
pub(crate) mod brent;
pub(crate) mod climb;
pub(crate) mod cubic;
pub(crate) mod gauss_kronrod;
pub(crate) mod gauss_legendre;
pub(crate) mod gilbert;
pub(crate) mod golden_section;
pub(crate) mod greatest;
pub(crate) mod grid;
pub(crate) mod horner;
pub(crate) mod illinois;
pub(crate) mod integral;
pub(crate) mod limit;
pub(crate) mod minima;
pub(crate) mod recent;
pub(crate) mod romberg;
pub(crate) mod scattered;
pub(crate) mod signed_sets;
pub(crate) mod taylor;
pub(crate) mod trapezoid;
pub(crate) mod triangle;
pub(crate) mod tridiagonal;
pub(crate) mod turn;
