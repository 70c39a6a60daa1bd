//! The fields of an octant.

use serde::{Deserialize, Serialize};

use crate::design::quantity::exponents;

/// The octant `x^a + y^b + z^c <= 1`, `x, y, z >= 0` of a supersphere (ASB88): 2, 2, 2 is an eighth of a ball, large exponents come near to a box, 1, 1, 1 is a tetrahedron, and below 1 it is hollow.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "a shape")]
pub struct Octant {
    /// `a`, `b` and `c`, each from 0.05 to 50.
    #[serde(deserialize_with = "exponents")]
    pub exponents: [f64; 3],
}
