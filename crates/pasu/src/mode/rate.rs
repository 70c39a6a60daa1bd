//! One rate: `cosh` and `sinh` about the middle of the interval, or `cos` and `sin`, whichever the sign asks for.

use libm::{cos, cosh, exp, sin, sinh};

/// The functions `C(x) = cosh(sqrt(z) x)` and `S(x) = sinh(sqrt(z) x) / sqrt(z)` of `x = u - 1/2`, entire in `z`:
/// for `z < 0` they are `cos(w x)` and `sin(w x) / w` with `w = sqrt(-z)`, for `z = 0` they are 1 and `x`.
///
/// Beyond [`Rate::ANCHOR`] both carry the factor `exp(-sqrt(z) / 2)`, so that they are at most 1 on [-1/2, 1/2].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rate {
    /// The square of the rate, of either sign.
    pub(super) z: f64,
    root: f64,
}

impl Rate {
    /// Above this root the functions are written as exponentials anchored at the ends. Near 1 both forms are exact to rounding;
    /// below it the difference of the two exponentials would cancel, far above it `cosh` would lose its scale.
    const ANCHOR: f64 = 1.0;

    pub(super) fn new(z: f64) -> Self {
        Rate { z, root: z.abs().sqrt() }
    }

    fn is_anchored(self) -> bool {
        self.z > 0.0 && self.root > Self::ANCHOR
    }

    /// The angular rate of an oscillation, 0 for a hyperbolic one.
    pub(super) fn oscillation(self) -> f64 {
        if self.z < 0.0 { self.root } else { 0.0 }
    }

    /// `(C, S)` at `u`.
    pub(super) fn at(self, u: f64) -> (f64, f64) {
        let x = u - 0.5;
        if self.is_anchored() {
            // At the ends one of them is 1, which need not be computed.
            let from_end = if u == 1.0 { 1.0 } else { exp(-self.root * (1.0 - u)) };
            let from_start = if u == 0.0 { 1.0 } else { exp(-self.root * u) };
            (0.5 * (from_end + from_start), 0.5 * (from_end - from_start) / self.root)
        } else if self.root < 1e-8 {
            // The next terms are below rounding, and sinh(root x) / root may be 0 / 0.
            (1.0 + 0.5 * self.z * x * x, x)
        } else if self.z > 0.0 {
            (cosh(self.root * x), sinh(self.root * x) / self.root)
        } else {
            (cos(self.root * x), sin(self.root * x) / self.root)
        }
    }

    /// `C` and `S` at `u` with their derivatives up to order `N - 1`; `C' = z S`, `S' = C`.
    pub(super) fn jets<const N: usize>(self, u: f64) -> ([f64; N], [f64; N]) {
        self.derived(self.at(u))
    }

    /// The same at `u = 1`, and the scale of `C^2 - z S^2`: `exp(-sqrt(z))` where the functions are anchored, else 1.
    pub(super) fn jets_at_end<const N: usize>(self) -> ([f64; N], [f64; N], f64) {
        let (values, scale) = if self.is_anchored() {
            let from_start = exp(-self.root);
            ((0.5 * (1.0 + from_start), 0.5 * (1.0 - from_start) / self.root), from_start)
        } else {
            (self.at(1.0), 1.0)
        };
        let (even, odd) = self.derived(values);
        (even, odd, scale)
    }

    fn derived<const N: usize>(self, (mut c, mut s): (f64, f64)) -> ([f64; N], [f64; N]) {
        let (mut even, mut odd) = ([0.0; N], [0.0; N]);
        for order in 0..N {
            even[order] = c;
            odd[order] = s;
            (c, s) = (self.z * s, c);
        }
        (even, odd)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_forms_meet_at_the_anchor() {
        let (below, above) = (Rate::new(1.0 - 1e-15), Rate::new(1.0 + 1e-15));
        for u in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let ((c, s), (c_anchored, s_anchored)) = (below.at(u), above.at(u));
            let lost = exp(0.5);
            assert!((c - lost * c_anchored).abs() < 1e-14 && (s - lost * s_anchored).abs() < 1e-14, "u = {u}");
        }
    }

    #[test]
    fn jets_follow_the_differential_equation() {
        for z in [0.0, 1e-30, -1e-30, 0.3, -0.3, 40.0, -40.0, 1e6, -1e6] {
            let (even, odd) = Rate::new(z).jets::<5>(0.7);
            assert_eq!(even[2], z * even[0]);
            assert_eq!(odd[3], z * odd[1]);
        }
    }
}
