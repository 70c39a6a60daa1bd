//! The plane of a triangle: on which side of it most points lie, without exact arithmetic.

type Point = [f32; 3];

/// What rounding takes from a volume at most, as a part of the two longest differences of coordinates that span the triangle and that which leads to the point: each of the three products of three differences is
/// rounded ten times at most and is no more than twice that product. Half as much again is added.
const ROUNDING: f64 = 96.0 * (0.5 * f64::EPSILON);

/// The plane of a triangle of which the same is asked for many points.
pub(super) struct Plane {
    normal: [f64; 3],
    /// The bound on the error, for a point at the distance one.
    rounding: f64,
}

impl Plane {
    /// The plane through three points.
    pub(super) fn of([a, b, c]: &[Point; 3]) -> Plane {
        let (p, q) = (from(*a, *b), from(*a, *c));
        let normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        Plane { normal, rounding: ROUNDING * largest(p) * largest(q) }
    }

    /// Six times the volume of the triangle, whose first corner this is, and a point, positive where its corners turn clockwise as seen from there; `None` where rounding could have changed the sign.
    pub(super) fn volume(&self, first: Point, point: Point) -> Option<f64> {
        let to = from(first, point);
        let [x, y, z] = self.normal;
        let volume = -(x * to[0] + y * to[1] + z * to[2]);
        (volume.abs() > self.rounding * largest(to)).then_some(volume)
    }

    /// The two axes between which it looks largest, as far as rounding tells.
    pub(super) fn axes(&self) -> (usize, usize) {
        let [x, y, z] = self.normal.map(f64::abs);
        if z >= x && z >= y {
            (0, 1)
        } else if x >= y {
            (1, 2)
        } else {
            (2, 0)
        }
    }
}

fn from(a: Point, b: Point) -> [f64; 3] {
    [f64::from(b[0]) - f64::from(a[0]), f64::from(b[1]) - f64::from(a[1]), f64::from(b[2]) - f64::from(a[2])]
}

fn largest([x, y, z]: [f64; 3]) -> f64 {
    x.abs().max(y.abs()).max(z.abs())
}

#[cfg(test)]
mod tests {
    use robust::{Coord3D, orient3d};

    use super::*;

    #[test]
    fn a_sign_is_that_of_exact_arithmetic_or_none() {
        // Marsaglia's xorshift.
        let mut state = 88_172_645_463_325_252u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 40) as f32 / (1u64 << 24) as f32 - 0.5
        };
        let exact = |[a, b, c, d]: [Point; 4]| {
            let [a, b, c, d] =
                [a, b, c, d].map(|p| Coord3D { x: f64::from(p[0]), y: f64::from(p[1]), z: f64::from(p[2]) });
            orient3d(a, b, c, d)
        };
        let (mut n_told, mut n_left) = (0, 0);
        for round in 0..20_000 {
            // Points in a plane but for single precision, near and far, of all sizes.
            let size = 2f32.powi(round % 61 - 30);
            let spread = 2f32.powi(-(round % 23));
            let middle = [(); 3].map(|()| random() * size);
            let axes = [(); 2].map(|()| [(); 3].map(|()| random() * size * spread));
            let off = if round % 2 == 0 { 0.0 } else { random() * spread * spread };
            let corners = [(); 4].map(|()| {
                let (s, t) = (random(), random());
                [0, 1, 2].map(|i| middle[i] + s * axes[0][i] + t * axes[1][i] + off * random() * size)
            });
            let [a, b, c, d] = corners;
            match Plane::of(&[a, b, c]).volume(a, d) {
                Some(volume) => {
                    n_told += 1;
                    assert!(volume * exact(corners) > 0.0, "{corners:?}");
                }
                None => n_left += 1,
            }
            // A corner lies in the plane.
            assert_eq!(Plane::of(&[a, b, c]).volume(a, a), None);
        }
        assert!(n_told > 10_000 && n_left > 100, "{n_told} {n_left}");
    }
}
