//! A rectangle of the unit square, and what derivatives do not exceed on it.

/// The parameters from `u[0]` to `u[1]` and from `v[0]` to `v[1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    pub(crate) u: [f64; 2],
    pub(crate) v: [f64; 2],
}

impl Cell {
    /// How long it is along `u` and along `v`.
    pub(crate) fn lengths(&self) -> [f64; 2] {
        [self.u, self.v].map(|[from, to]| to - from)
    }
}

/// Suprema of lengths on a [`Cell`]: never less than what they bound, and never larger on a smaller cell.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Suprema {
    /// Of `|X|`.
    pub(crate) size: f64,
    /// Of `|X_uu|`.
    pub(crate) uu: f64,
    /// Of `|X_uv|`.
    pub(crate) uv: f64,
    /// Of `|X_vv|`.
    pub(crate) vv: f64,
}

impl Suprema {
    /// How far the two triangles of a cell of these lengths are from the surface at most, either way.
    ///
    /// On a right triangle with legs `p`, `q` in the parameters the linear interpolant of `X` is within `(p^2 |X_uu| + 2 p q |X_uv| + q^2 |X_vv|) / 8` of it (Filip, Magedson and Markot, *Surface
    /// algorithms using bounds on derivatives*, 1986, theorem 2). Infinite where a supremum is not a number.
    pub(crate) fn deviation(&self, [p, q]: [f64; 2]) -> f64 {
        let deviation = 0.125 * (p * p * self.uu + 2.0 * p * q * self.uv + q * q * self.vv);
        if deviation.is_nan() { f64::INFINITY } else { deviation }
    }
}
