//! Functions that span the solutions of a mode's equation and stay independent in its regime.

use super::order::Order;
use super::pair::Pair;
use super::rate::Rate;
use super::slow::Slow;
use super::unsolvable::Unsolvable;

/// Below this rate an order 4 equation is solved by power series about the middle: at 4 the series of the four fundamental solutions
/// reach e^2 at the ends, so they lose less than one digit, and above it every other form below is as good.
const SERIES_RATE: f64 = 4.0;

/// Up to this rate no equation of order 4 is in resonance. Of a function that vanishes with its slopes at both ends the integral of `q''^2` is at least `(2 pi)^2` times that of `q'^2` and 500 times that of `q^2`, while `|b| <= 2 rate^2` and
/// `|c| <= rate^4`: 62 % of the first is the most that the others can make up for.
const NO_RESONANCE: f64 = 3.0;

/// Half the difference of two real rates above which the roots are taken by themselves. Products of half sum and half difference would have to
/// write `exp(-rho_2 u)` with factors of size `exp(delta)`; the roots by themselves have a determinant of relative size `delta / sigma`.
const SEPARATION: f64 = 1.0;

/// Two even and two odd solutions of the homogeneous equation about `x = u - 1/2 = 0` (for order 2, one of each).
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Basis {
    /// Order 2: `C`, `S` of the one rate.
    Single(Rate),
    /// Rates at most [`SERIES_RATE`], of any regime: the solutions that begin at the middle as 1, `x^2 / 2`, `x`, `x^3 / 6`, which is what
    /// they are when all rates vanish.
    Slow(Slow),
    /// Roots `+-sigma +-delta` near each other, double, or complex (then `delta^2 < 0`): `C C`, `S S`, `S C`, `C S` of both. The squares
    /// `(b +- 2 sqrt(c)) / 4` are real for every `c > 0`, so that no regime needs complex numbers and the double root nothing at all.
    Products { sigma: Rate, delta: Rate },
    /// Real squared roots that are well apart, of any sign: `C_1`, `C_2`, `S_1`, `S_2`.
    Separate(Rate, Rate),
}

impl Basis {
    /// The basis for `q'' - b q` or `q'''' - b q'' + c q`, the largest rate and the squared roots of which are known.
    pub(super) fn of(order: Order, [b, c]: [f64; 2], rate: f64, roots: Option<(f64, f64)>) -> Self {
        match order {
            Order::Second => Basis::Single(Rate::new(b)),
            Order::Fourth if rate <= SERIES_RATE => Basis::Slow(Slow::new(b, c, rate)),
            Order::Fourth => {
                let sigma_squared = 0.25 * (b + 2.0 * c.max(0.0).sqrt());
                let delta_squared = 0.25 * (b - 2.0 * c.max(0.0).sqrt());
                match roots {
                    Some((z1, z2)) if c <= 0.0 || Self::are_apart(sigma_squared, delta_squared) => {
                        Basis::Separate(Rate::new(z1), Rate::new(z2))
                    }
                    _ => Basis::Products { sigma: Rate::new(sigma_squared), delta: Rate::new(delta_squared) },
                }
            }
        }
    }

    /// Refuses what may be in resonance, by what the functions are at `u = 1`.
    pub(super) fn check(&self, halves: &[Pair; 2]) -> Result<(), Unsolvable> {
        let oscillation = self.oscillation();
        if let Basis::Single(_) = self {
            // The odd function is compared as sin, whose size is 1.
            for value in [halves[0].first[0], halves[1].first[0] * oscillation.max(1.0)] {
                if oscillation > 0.0 && value.abs() < 1e-6 * (2.0 + oscillation) {
                    return Err(Unsolvable::Resonant);
                }
            }
        } else if oscillation > 0.0 {
            for half in halves {
                half.check(oscillation)?;
            }
        }
        Ok(())
    }

    fn are_apart(sigma_squared: f64, delta_squared: f64) -> bool {
        if sigma_squared < 0.0 {
            // Both roots oscillate, and nothing decays: they are apart when the slower is below a third of the faster.
            delta_squared.abs() > 0.25 * sigma_squared.abs() && sigma_squared.abs() > 0.25 * delta_squared.abs()
        } else {
            delta_squared > SEPARATION * SEPARATION
        }
    }

    /// The fastest rate of a problem that can have a singular boundary matrix, which takes a pair of imaginary roots; else 0.
    fn oscillation(&self) -> f64 {
        match self {
            Basis::Single(rate) => rate.oscillation(),
            Basis::Slow(slow) if slow.rate() <= NO_RESONANCE => 0.0,
            // The series do not know their roots, and a decaying problem never comes near the threshold.
            Basis::Slow(_) => SERIES_RATE,
            Basis::Products { sigma, delta } if sigma.z < 0.0 => sigma.oscillation() + delta.oscillation(),
            Basis::Products { .. } => 0.0,
            Basis::Separate(first, second) if first.z < 0.0 || second.z < 0.0 => first.z.abs().sqrt(),
            Basis::Separate(..) => 0.0,
        }
    }

    /// The even and the odd functions at `u = 1`, with their determinants; order 2 has one of each.
    pub(super) fn halves(&self) -> [Pair; 2] {
        let Basis::Products { sigma, delta } = self else {
            let [even, more_even, odd, more_odd] = self.jets::<2>(1.0);
            return [Pair::by_subtraction(even, more_even), Pair::by_subtraction(odd, more_odd)];
        };
        let ((c, s, scale), (c_delta, s_delta, delta_scale)) = (sigma.jets_at_end::<2>(), delta.jets_at_end::<2>());
        let (one, other) = (s[0] * c[0] * delta_scale, s_delta[0] * c_delta[0] * scale);
        [
            Pair { first: product(&c, &c_delta), second: product(&s, &s_delta), determinant: one + other },
            Pair { first: product(&s, &c_delta), second: product(&c, &s_delta), determinant: one - other },
        ]
    }

    /// The functions (two even, two odd; order 2 leaves the second of each 0) at `u` with their derivatives up to order `N - 1`.
    pub(super) fn jets<const N: usize>(&self, u: f64) -> [[f64; N]; 4] {
        match self {
            Basis::Single(rate) => {
                let (even, odd) = rate.jets(u);
                [even, [0.0; N], odd, [0.0; N]]
            }
            Basis::Slow(slow) => slow.jets(u - 0.5),
            Basis::Products { sigma, delta } => {
                let ((c, s), (c_delta, s_delta)) = (sigma.jets(u), delta.jets(u));
                [product(&c, &c_delta), product(&s, &s_delta), product(&s, &c_delta), product(&c, &s_delta)]
            }
            Basis::Separate(first, second) => {
                let ((c1, s1), (c2, s2)) = (first.jets(u), second.jets(u));
                [c1, c2, s1, s2]
            }
        }
    }
}

/// The derivatives of a product, by Leibniz' rule.
pub(super) fn product<const N: usize>(f: &[f64; N], g: &[f64; N]) -> [f64; N] {
    let mut jet = [0.0; N];
    for (order, value) in jet.iter_mut().enumerate() {
        let mut binomial = 1.0;
        for i in 0..=order {
            *value += binomial * f[i] * g[order - i];
            binomial = binomial * (order - i) as f64 / (i + 1) as f64;
        }
    }
    jet
}
