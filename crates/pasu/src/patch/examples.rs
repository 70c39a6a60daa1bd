//! Patches of other kinds than the solver has: what is said of every patch is tried on them.

use core::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;

use super::{Breaks, Cell, Patch, Side, Suprema, SurfaceJet};

/// The largest length of vectors with their axes stretched.
fn longest(vectors: impl IntoIterator<Item = DVec3>, stretch: [f64; 3]) -> f64 {
    vectors.into_iter().map(|v| (v * DVec3::from_array(stretch)).length()).fold(0.0, f64::max)
}

/// `(1-u)(1-v) P00 + u(1-v) P10 + (1-u)v P01 + uv P11`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bilinear(pub(crate) [DVec3; 4]);

impl Patch for Bilinear {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        let [p00, p10, p01, p11] = self.0;
        let duv = p00 - p10 - p01 + p11;
        let (du, dv) = (p10 - p00 + v * duv, p01 - p00 + u * duv);
        let position = p00 + u * (p10 - p00) + v * (p01 - p00) + u * v * duv;
        SurfaceJet { position, du, dv, duv, ..SurfaceJet::default() }
    }

    fn suprema(&self, _: Cell, stretch: [f64; 3]) -> Suprema {
        let [p00, p10, p01, p11] = self.0;
        Suprema { size: longest(self.0, stretch), uv: longest([p00 - p10 - p01 + p11], stretch), ..Suprema::default() }
    }

    fn breaks(&self) -> [Breaks; 2] {
        [Breaks::smooth(0.5), Breaks::smooth(0.5)]
    }

    fn sides(&self) -> [Side; 4] {
        [Side::Free; 4]
    }
}

/// A bicubic Bezier patch: control points row by row, four of one `u` after the other.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bezier(pub(crate) [[DVec3; 4]; 4]);

/// Bernstein's polynomials of degree 3 and their first and second derivatives.
fn bernstein(x: f64) -> [[f64; 4]; 3] {
    let y = 1.0 - x;
    [
        [y * y * y, 3.0 * x * y * y, 3.0 * x * x * y, x * x * x],
        [-3.0 * y * y, 3.0 * y * y - 6.0 * x * y, 6.0 * x * y - 3.0 * x * x, 3.0 * x * x],
        [6.0 * y, 6.0 * x - 12.0 * y, 6.0 * y - 12.0 * x, 6.0 * x],
    ]
}

impl Patch for Bezier {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        let (u, v) = (bernstein(u), bernstein(v));
        let sum = |i: usize, j: usize| (0..16).map(|k| u[i][k / 4] * v[j][k % 4] * self.0[k / 4][k % 4]).sum::<DVec3>();
        let [position, du, dv, duu, duv, dvv] =
            [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)].map(|(i, j)| sum(i, j));
        SurfaceJet { position, du, dv, duu, duv, dvv }
    }

    /// The derivatives of a Bezier patch are Bezier patches of differences, in the hull of which they stay.
    fn suprema(&self, _: Cell, stretch: [f64; 3]) -> Suprema {
        let p = |i: usize, j: usize| self.0[i][j];
        let all = |n: usize, m: usize| (0..n).flat_map(move |i| (0..m).map(move |j| (i, j)));
        Suprema {
            size: longest(self.0.concat(), stretch),
            uu: 6.0 * longest(all(2, 4).map(|(i, j)| p(i, j) - 2.0 * p(i + 1, j) + p(i + 2, j)), stretch),
            uv: 9.0 * longest(all(3, 3).map(|(i, j)| p(i, j) - p(i + 1, j) - p(i, j + 1) + p(i + 1, j + 1)), stretch),
            vv: 6.0 * longest(all(4, 2).map(|(i, j)| p(i, j) - 2.0 * p(i, j + 1) + p(i, j + 2)), stretch),
        }
    }

    fn breaks(&self) -> [Breaks; 2] {
        [Breaks::smooth(1.5), Breaks::smooth(1.5)]
    }

    fn sides(&self) -> [Side; 4] {
        [Side::Free; 4]
    }
}

/// A torus round the z axis: the circle of radius `tube` whose middle is `radius` from it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Torus {
    pub(crate) radius: f64,
    pub(crate) tube: f64,
}

impl Patch for Torus {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        let ((su, cu), (sv, cv)) = (libm::sincos(TAU * u), libm::sincos(TAU * v));
        let (out, round, r) = (DVec3::new(cv, sv, 0.0), DVec3::new(-sv, cv, 0.0), self.radius + self.tube * cu);
        SurfaceJet {
            position: r * out + self.tube * su * DVec3::Z,
            du: TAU * self.tube * (cu * DVec3::Z - su * out),
            dv: TAU * r * round,
            duu: -TAU * TAU * self.tube * (cu * out + su * DVec3::Z),
            duv: -TAU * TAU * self.tube * su * round,
            dvv: -TAU * TAU * r * out,
        }
    }

    fn suprema(&self, _: Cell, stretch: [f64; 3]) -> Suprema {
        let most = stretch.into_iter().fold(0.0, f64::max);
        let (tube, whole) = (most * self.tube, most * (self.radius + self.tube));
        Suprema { size: whole, uu: TAU * TAU * tube, uv: TAU * TAU * tube, vv: TAU * TAU * whole }
    }

    fn breaks(&self) -> [Breaks; 2] {
        [Breaks::smooth(1.0), Breaks::smooth(1.0)]
    }

    fn sides(&self) -> [Side; 4] {
        [Side::Joined; 4]
    }
}

/// An eighth of a sphere, from its pole on the z axis (`u = 0`) to its equator.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Eighth {
    pub(crate) radius: f64,
}

impl Patch for Eighth {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        let ((su, cu), (sv, cv)) = (libm::sincos(FRAC_PI_2 * u), libm::sincos(FRAC_PI_2 * v));
        let (out, round) = (DVec3::new(cv, sv, 0.0), DVec3::new(-sv, cv, 0.0));
        let (r, h) = (self.radius, FRAC_PI_2);
        SurfaceJet {
            position: r * (su * out + cu * DVec3::Z),
            du: h * r * (cu * out - su * DVec3::Z),
            dv: h * r * su * round,
            duu: -h * h * r * (su * out + cu * DVec3::Z),
            duv: h * h * r * cu * round,
            dvv: -h * h * r * su * out,
        }
    }

    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        let size = self.radius * stretch.into_iter().fold(0.0, f64::max);
        let second = FRAC_PI_2 * FRAC_PI_2 * size;
        let [from, to] = cell.u.map(|u| FRAC_PI_2 * u);
        Suprema { size, uu: second, uv: second * libm::cos(from), vv: second * libm::sin(to) }
    }

    fn breaks(&self) -> [Breaks; 2] {
        [Breaks::smooth(0.25), Breaks::smooth(0.25)]
    }

    fn sides(&self) -> [Side; 4] {
        [Side::Pole, Side::Free, Side::Free, Side::Free]
    }
}

/// `(u, v, u v)`: a saddle.
pub(crate) fn saddle() -> Bilinear {
    Bilinear([DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE])
}

/// `(u, v, v^2)`: a gutter along the x axis.
pub(crate) fn gutter() -> Bezier {
    let squares = [0.0, 0.0, 1.0 / 3.0, 1.0];
    Bezier(core::array::from_fn(|i| core::array::from_fn(|j| DVec3::new(i as f64 / 3.0, j as f64 / 3.0, squares[j]))))
}

/// A cube of six bilinear patches from -1 to 1, each turned another way, with the sides that they share.
pub(crate) fn cube() -> Vec<Box<dyn Patch>> {
    /// A face of the cube with its neighbours.
    #[derive(Debug)]
    struct Face(Bilinear, [Side; 4]);
    impl Patch for Face {
        fn jet(&self, u: f64, v: f64) -> SurfaceJet {
            self.0.jet(u, v)
        }
        fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
            self.0.suprema(cell, stretch)
        }
        fn breaks(&self) -> [Breaks; 2] {
            self.0.breaks()
        }
        fn sides(&self) -> [Side; 4] {
            self.1
        }
    }
    let corner = |bits: usize| DVec3::from_array([0, 1, 2].map(|axis| if bits >> axis & 1 == 1 { 1.0 } else { -1.0 }));
    // P00, P10, P01, P11, so that X_u x X_v points outwards.
    let faces = [[0, 2, 1, 3], [4, 5, 6, 7], [0, 1, 4, 5], [3, 2, 7, 6], [6, 2, 4, 0], [1, 3, 5, 7]];
    // The corners at which each side begins and ends.
    let ends = |face: [usize; 4]| [[face[0], face[2]], [face[1], face[3]], [face[0], face[1]], [face[2], face[3]]];
    let side = |this: usize, [from, to]: [usize; 2]| {
        let all = (0..6).filter(|other| *other != this).flat_map(|other| (0..4).map(move |side| (other, side)));
        let mut met = all.filter_map(|(other, side)| match ends(faces[other])[side] {
            pair if pair == [from, to] => Some(Side::Shared { patch: other, side, is_reversed: false }),
            pair if pair == [to, from] => Some(Side::Shared { patch: other, side, is_reversed: true }),
            _ => None,
        });
        met.next().unwrap()
    };
    let face = |i: usize| Face(Bilinear(faces[i].map(corner)), ends(faces[i]).map(|pair| side(i, pair)));
    (0..6).map(|i| Box::new(face(i)) as Box<dyn Patch>).collect()
}
