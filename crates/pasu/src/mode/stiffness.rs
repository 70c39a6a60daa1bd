//! What it takes to bend a mode: its second derivative at the ends by what is given there.

use super::basis::Basis;
use super::equation::Equation;

/// The second derivative of an even and of an odd solution at `u = 1`, for a unit of slope there and for a unit of value.
///
/// For the span of two even (or two odd) functions `f`, `g` these are `(f g'' - g f'') / D` and `(g' f'' - f' g'') / D` with `D = f g' - f' g`. Written out in the functions of a basis they are sums of what does
/// not cancel: with `c` the product of the squared roots the second is `-c D_odd / D_even` for the even half and `-D_even / D_odd` for the odd one, up to how the functions are normalised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stiffness {
    slope: [f64; 2],
    value: [f64; 2],
}

impl Stiffness {
    /// Of an equation of order 4.
    #[inline(never)]
    pub(super) fn of(equation: &Equation) -> Self {
        let c = equation.c;
        let [even, odd] = &equation.halves;
        match &equation.basis {
            Basis::Products { sigma, delta } => {
                // Of the products of C and S: the difference of the two squares is the root of c.
                let root = c.max(0.0).sqrt();
                // `C^2 - z S^2` is the scale.
                let ((_, [s_sigma], scale), ([c_delta], [s_delta], delta_scale)) =
                    (sigma.jets_at_end::<1>(), delta.jets_at_end::<1>());
                let (fast, slow) = (sigma.z * s_sigma * s_sigma, delta.z * s_delta * s_delta);
                let bent = [scale * c_delta * c_delta + fast * delta_scale, fast * delta_scale - slow * scale];
                Stiffness {
                    slope: [2.0 * bent[0] / even.determinant, 2.0 * bent[1] / odd.determinant],
                    value: [-root * odd.determinant / even.determinant, -root * even.determinant / odd.determinant],
                }
            }
            Basis::Separate(first, second) => {
                let apart = second.z - first.z;
                let [even_product, odd_product] = [even, odd].map(|pair| pair.first[0] * pair.second[0]);
                Stiffness {
                    slope: [even_product * apart / even.determinant, odd_product * apart / odd.determinant],
                    value: [-c * odd.determinant / even.determinant, -even.determinant / odd.determinant],
                }
            }
            // The functions are near 1, x^2 / 2, x, x^3 / 6: nothing cancels but what is next to nothing. Of the second derivatives those of the first and the third are `-c` times the second and the fourth,
            // that of the second is the first and `b` times the second, and that of the fourth the slope of the second.
            Basis::Slow(_) | Basis::Single(_) => {
                let (even_bent, odd_bent) = (even.first[0] + equation.b * even.second[0], even.second[1]);
                Stiffness {
                    slope: [
                        (even.first[0] * even_bent + c * even.second[0] * even.second[0]) / even.determinant,
                        (odd.first[0] * odd_bent + c * odd.second[0] * odd.second[0]) / odd.determinant,
                    ],
                    value: [
                        (-c * even.second[1] * even.second[0] - even.first[1] * even_bent) / even.determinant,
                        (-c * odd.second[1] * odd.second[0] - odd.first[1] * odd_bent) / odd.determinant,
                    ],
                }
            }
        }
    }

    /// `q''` at an end by the slope there, and by the slope at the other end, both with signs as they are: `q''(1) = near q'(1) + far q'(0)`, `q''(0) = -near q'(0) - far q'(1)`.
    pub(super) fn near_and_far(&self) -> [f64; 2] {
        let [even, odd] = self.slope;
        [0.5 * (even + odd), 0.5 * (odd - even)]
    }

    /// `q''` at both ends by what is given at both ends: values, then slopes.
    pub(super) fn second_derivatives(&self, [start, end]: [f64; 2], [start_u, end_u]: [f64; 2]) -> [f64; 2] {
        let even = self.value[0] * (0.5 * start + 0.5 * end) + self.slope[0] * (0.5 * end_u - 0.5 * start_u);
        let odd = self.value[1] * (0.5 * end - 0.5 * start) + self.slope[1] * (0.5 * start_u + 0.5 * end_u);
        [even - odd, even + odd]
    }
}

#[cfg(test)]
mod tests {
    use super::super::{ModeData, Order};
    use super::*;

    /// In every regime, against the second derivatives of solutions.
    #[test]
    fn it_is_what_solutions_have() {
        let mut checked = 0;
        for t in [-30.0, -1.0, 0.0, 1e-9, 0.5, 2.0, 2.000_000_002, 10.1, 300.0] {
            for w in [-400.0, -1.0, 0.0, 1e-12, 1.0, 25.0, 26.0, 9e4] {
                for k in [0.0, 1e-8, 1e-3, 0.3, 1.0, 3.3, 4.0, 40.0, 900.0] {
                    let Ok(equation) = Equation::new(Order::Fourth, 1.0, t, w, k) else { continue };
                    let stiffness = Stiffness::of(&equation);
                    for data in
                        [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.3, -2.0, 0.7, 5.0]]
                    {
                        let [start, end, start_u, end_u] = data;
                        let Ok(solution) = equation.solve(&ModeData { start, end, start_u, end_u, force: &[] }) else {
                            continue;
                        };
                        let expected = [0.0, 1.0].map(|u| equation.jets::<3, 1>([&solution], u)[0][2]);
                        let found = stiffness.second_derivatives([start, end], [start_u, end_u]);
                        let scale = 12.0 + equation.largest_rate() * equation.largest_rate();
                        for (found, expected) in found.into_iter().zip(expected) {
                            let error = (found - expected).abs();
                            assert!(error < 1e-9 * scale, "t {t} w {w} k {k} {data:?}: {found}, not {expected}");
                            checked += 1;
                        }
                    }
                }
            }
        }
        assert!(checked > 2000);
    }

    #[test]
    fn that_of_a_cubic_is_4_and_2() {
        let equation = Equation::new(Order::Fourth, 1.0, 0.0, 0.0, 0.0).unwrap();
        let stiffness = Stiffness::of(&equation);
        let found = [stiffness.near_and_far(), stiffness.second_derivatives([0.0, 1.0], [0.0, 0.0])];
        for (found, expected) in found.as_flattened().iter().zip([4.0, 2.0, 6.0, -6.0]) {
            assert!((found - expected).abs() < 1e-14, "{found}, not {expected}");
        }
    }
}
