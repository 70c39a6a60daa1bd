//! The equation of a blend on a grid of finite differences over the unit cube: what the sines of a blend are held against.
//!
//! ```text
//! a r_uuuu + b r_vvvv + c r_wwww = f      r = r_uu = 0 at both ends of u, the same of v, r = r_w = 0 at both ends of w
//! ```
//!
//! These are the conditions that sines along `u` and `v` meet, so that `r` is what the method `modal` adds to the cubic between the sections. Central differences of second order; a condition enters through a point
//! beyond the border, `r(-h) = -r(h)` where `r_uu` vanishes and `r(-h) = r(h)` where `r_w` does. The matrix is symmetric and positive definite, and is solved by conjugate gradients without ever being written down.

/// A system is solved when what is left of it is this part of what it was.
const SOLVED: f64 = 1e-11;

/// `r` on `n` intervals along each parameter.
#[derive(Debug, Clone)]
pub struct Differences {
    n: usize,
    weights: [f64; 3],
}

impl Differences {
    /// A grid with the weights `a`, `b`, `c`.
    pub fn new(n: usize, weights: [f64; 3]) -> Differences {
        Differences { n, weights }
    }

    /// Points along each parameter, with one beyond either end.
    fn side(&self) -> usize {
        self.n + 3
    }

    /// The place of the point with these numbers along `u`, `v` and `w`, each from 0 to `n`.
    pub fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        ((i + 1) * self.side() + j + 1) * self.side() + k + 1
    }

    /// All points from one of these numbers to another along each parameter.
    fn points(from: usize, to: usize) -> impl Iterator<Item = [usize; 3]> {
        (from..=to).flat_map(move |i| (from..=to).flat_map(move |j| (from..=to).map(move |k| [i, j, k])))
    }

    fn place(&self, at: [usize; 3]) -> [f64; 3] {
        at.map(|i| i as f64 / self.n as f64)
    }

    /// The solution for a force at each point inside: at [`Differences::index`], 0 on the border.
    pub fn solve(&self, force: impl Fn([f64; 3]) -> f64) -> Vec<f64> {
        let mut left = vec![0.0; self.side().pow(3)];
        for at in Self::points(1, self.n - 1) {
            left[self.index(at)] = force(self.place(at));
        }
        let (mut found, mut along) = (vec![0.0; left.len()], left.clone());
        let mut squared = dot(&left, &left);
        let enough = SOLVED * SOLVED * squared;
        let mut applied = vec![0.0; left.len()];
        while squared > enough {
            self.apply(&mut along, &mut applied);
            let step = squared / dot(&along, &applied);
            for ((found, left), (along, applied)) in found.iter_mut().zip(&mut left).zip(along.iter().zip(&applied)) {
                *found += step * along;
                *left -= step * applied;
            }
            let next = dot(&left, &left);
            let turn = next / squared;
            along.iter_mut().zip(&left).for_each(|(along, left)| *along = left + turn * *along);
            squared = next;
        }
        found
    }

    /// The operator at every point inside, after the points beyond the border were given what the conditions ask for.
    fn apply(&self, r: &mut [f64], out: &mut [f64]) {
        let steps = [self.side() * self.side(), self.side(), 1];
        for (axis, (step, beyond)) in steps.into_iter().zip([-1.0, -1.0, 1.0]).enumerate() {
            for (j, k) in (1..self.n).flat_map(|j| (1..self.n).map(move |k| (j, k))) {
                let low = self.index([[0, j, k], [j, 0, k], [j, k, 0]][axis]);
                let high = low + self.n * step;
                r[low - step] = beyond * r[low + step];
                r[high + step] = beyond * r[high - step];
            }
        }
        let fourth = (self.n as f64).powi(4);
        let weights = self.weights.map(|weight| weight * fourth);
        for at in Self::points(1, self.n - 1) {
            let at = self.index(at);
            let along = |step: usize, weight: f64| {
                weight * (6.0 * r[at] - 4.0 * (r[at - step] + r[at + step]) + r[at - 2 * step] + r[at + 2 * step])
            };
            out[at] = along(steps[0], weights[0]) + along(steps[1], weights[1]) + along(steps[2], weights[2]);
        }
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

/// A disc of radii `from` that becomes one of radii `to`, by their tangents too: what is compared.
#[derive(Debug, Clone, Copy)]
pub struct Discs {
    /// Radii along `x` and `y`.
    pub radii: [[f64; 2]; 2],
    /// Tangents in parts of the position.
    pub taper: f64,
}

/// The second example of ZY04, in `x` and `y`.
pub const DISCS: Discs = Discs { radii: [[2.0, 3.0], [1.0, 1.0]], taper: -0.1 };

impl Discs {
    /// The cubic between both sections, which is what a plain loft is: `x` and `y`.
    pub fn loft(&self, [u, v, w]: [f64; 3]) -> [f64; 2] {
        let (from, to) = (1.0 - w * w * (3.0 - 2.0 * w), w * w * (3.0 - 2.0 * w));
        let (leaves, comes) = (self.taper * w * (1.0 - w) * (1.0 - w), self.taper * w * w * (w - 1.0));
        let by = [0, 1].map(|axis| self.radii[0][axis] * (from + leaves) + self.radii[1][axis] * (to + comes));
        let (s, c) = (std::f64::consts::TAU * v).sin_cos();
        [by[0] * u * s, by[1] * u * c]
    }

    /// What the loft leaves of the equation with even weights, apart from the fourth derivative along `w`, which a cubic has none of.
    pub fn left(&self, at: [f64; 3]) -> [f64; 2] {
        self.loft(at).map(|x| std::f64::consts::TAU.powi(4) * x)
    }

    /// The document of a blend between them, solved by a method with so many terms.
    ///
    /// # Errors
    /// None, unless the solver no longer takes it.
    pub fn design(&self, method: &str, terms: [usize; 3]) -> pasu::Result<pasu::Design> {
        let section = |radius: [f64; 2], z: f64| serde_json::json!({ "form": "disc", "radius": radius, "z": z, "taper": self.taper, "dz": -2 });
        let [start, end] = self.radii;
        let shape = serde_json::json!({ "kind": "blend", "start": section(start, 3.0), "end": section(end, 1.0), "method": method, "terms": terms });
        pasu::Design::parse(&serde_json::json!({ "pasu": 1, "parts": [{ "shape": shape }] }).to_string())
    }

    /// The blend with even weights by finite differences on `n` intervals: `(u, v, w)` and `x`, `y` at every point of the grid.
    pub fn by_differences(&self, n: usize) -> Vec<([f64; 3], [f64; 2])> {
        let grid = Differences::new(n, [1.0; 3]);
        let ripples = [0, 1].map(|axis| grid.solve(|at| -self.left(at)[axis]));
        let point = |at: [usize; 3]| {
            let (place, index) = (grid.place(at), grid.index(at));
            let loft = self.loft(place);
            (place, [0, 1].map(|axis| loft[axis] + ripples[axis][index]))
        };
        Differences::points(0, n).map(point).collect()
    }

    /// How far a design is at most, in `x` or `y`, from what [`Discs::by_differences`] found.
    ///
    /// # Errors
    /// As [`pasu::evaluate`].
    pub fn apart(&self, design: &pasu::Design, found: &[([f64; 3], [f64; 2])]) -> pasu::Result<f64> {
        let at: Vec<f64> = found.iter().flat_map(|(place, _)| *place).collect();
        let points = pasu::evaluate(design, 0, &at)?;
        Ok(points.chunks_exact(3).zip(found).map(|(point, (_, other))| farther(&point[..2], other)).fold(0.0, f64::max))
    }

    /// The same of the plain loft.
    pub fn loft_apart(&self, found: &[([f64; 3], [f64; 2])]) -> f64 {
        found.iter().map(|(place, other)| farther(&self.loft(*place), other)).fold(0.0, f64::max)
    }
}

fn farther(one: &[f64], other: &[f64; 2]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_solution_that_is_known_comes_nearer_with_the_square_of_the_step() {
        let weights = [1.0, 0.5, 2.0];
        let bump = |w: f64| (w * (1.0 - w)).powi(2);
        let known = |[u, v, w]: [f64; 3]| (PI * u).sin() * (2.0 * PI * v).sin() * bump(w);
        let force = |[u, v, w]: [f64; 3]| {
            let across = PI.powi(4) * (weights[0] + 16.0 * weights[1]);
            (across * bump(w) + 24.0 * weights[2]) * (PI * u).sin() * (2.0 * PI * v).sin()
        };
        let errors = [8, 16].map(|n| {
            let grid = Differences::new(n, weights);
            let found = grid.solve(force);
            let off = |at| (found[grid.index(at)] - known(grid.place(at))).abs();
            Differences::points(0, n).map(off).fold(0.0, f64::max)
        });
        assert!(errors[0] < 0.02 && (1.7..2.3).contains(&(errors[0] / errors[1]).log2()), "{errors:?}");
    }

    #[test]
    fn differences_come_nearer_to_a_blend_by_modes_with_the_square_of_the_step() {
        let design = DISCS.design("modal", [48, 48, 1]).unwrap();
        let found = [6, 12, 24].map(|n| DISCS.by_differences(n));
        let apart = found.each_ref().map(|found| DISCS.apart(&design, found).unwrap());
        for pair in apart.windows(2) {
            assert!((1.7..2.3).contains(&(pair[0] / pair[1]).log2()), "{apart:?}");
        }
        // A loft is no solution.
        let loft = DISCS.loft_apart(&found[2]);
        assert!(loft > 20.0 * apart[2], "{loft} {apart:?}");
    }
}
