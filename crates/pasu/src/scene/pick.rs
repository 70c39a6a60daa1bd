//! What lies along a ray, and what holds a point.

use glam::DVec3;

use super::crossings::{Crossing, SAME};
use super::hit::{Hit, Ray, point};
use super::space::Space;
use crate::design::Design;
use crate::error::{Code, Error, Result};
use crate::solution::Solution;
use crate::watch;

/// Where a ray meets the parts of a design, in the order of the distance from its origin: every place where it goes through the surface of one, exact to 1e-9 of the size of the part.
///
/// A part with a wall is the body of clay that is made of it, outside, lining, rim and all, in which its foot ring or drain may have given way to another ([`Pot::new`](crate::Pot::new)); where it cannot be made, and without a wall, it is its surface.
/// A ray that touches without going through does not meet. Places of one part that are nearer than 1e-9 of its size are one, as where a ray meets an edge.
///
/// # Errors
/// What is refused of a part, with its path; `not-finite` and `out-of-range` for a ray that is none; `overflow` for a part that is beyond 1e100; `too-large` for a ray that goes along the surface of a part, or meets it where it folds, so closely that it takes too long to tell.
///
/// ```
/// use pasu::{Design, Ray, pick};
///
/// // A ball of radius 2 has eight octants; this is the one with x, y, z >= 0.
/// let design = Design::parse(
///     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "octant", "exponents": [2, 2, 2] }, "place": { "scale": [2, 2, 2] } }] }"#,
/// )?;
/// let hits = pick(&design, Ray { origin: [1.0, 1.0, -5.0], direction: [0.0, 0.0, 1.0] })?;
/// assert_eq!(hits.len(), 2);
/// assert_eq!((hits[0].part, hits[0].distance), (0, 5.0));
/// assert!((hits[1].point[2] - 2f64.sqrt()).abs() < 1e-12);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn pick(design: &Design, ray: Ray) -> Result<Vec<Hit>> {
    Solution::of(design).pick(ray)
}

/// The parts of a design that hold a point, the one whose surface is nearest first: `distance` says how deep beneath it the point is, and `point` where it is nearest.
///
/// Only solids hold anything: octants, blends and closed networks, and what has a wall holds what is in its clay, not what is in its hollow. The border belongs to a solid, to within 1e-9 of its size. Depth is exact to 1e-9 of the size too, but
/// where very much of the surface is all but equally near, as from the middle of a ball.
///
/// # Errors
/// What is refused of a part, with its path; `not-finite` and `out-of-range` for a point that is none; `overflow` for a part that is beyond 1e100; `too-large` where no ray from the point tells on which side of the surface it is.
///
/// ```
/// use pasu::{Design, at};
///
/// let cube = |x: f64| format!(r#"{{ "shape": {{ "kind": "octant", "exponents": [50, 50, 50] }}, "place": {{ "shift": [{x}, 0, 0] }} }}"#);
/// let design = Design::parse(&format!(r#"{{ "pasu": 1, "parts": [{}, {}] }}"#, cube(0.0), cube(0.75)))?;
/// let parts: Vec<(usize, f64)> = at(&design, [0.85, 0.5, 0.5])?.iter().map(|hit| (hit.part, hit.distance)).collect();
/// assert_eq!(parts[0].0, 1);
/// assert!((parts[0].1 - 0.1).abs() < 1e-9 && parts[1].0 == 0);
/// assert!(at(&design, [0.85, 0.5, -0.5])?.is_empty());
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn at(design: &Design, point: [f64; 3]) -> Result<Vec<Hit>> {
    Solution::of(design).at(point)
}

impl Solution {
    /// As [`pick`].
    ///
    /// # Errors
    /// As [`pick`].
    pub fn pick(&self, ray: Ray) -> Result<Vec<Hit>> {
        let (origin, direction) = ray.unit()?;
        let sight = self.sight()?;
        let inverse = direction.recip();
        let (mut hits, mut unclear) = (Vec::new(), None);
        for space in sight.met(self, |bounds| bounds.is_met(origin, inverse))? {
            let crossings = space.crossings(origin, direction);
            if crossings.is_cut {
                unclear.get_or_insert(space.part);
            }
            let same = SAME * space.size();
            let mut last = f64::NEG_INFINITY;
            for crossing in &crossings.found {
                if crossing.t - last > same {
                    hits.push(space.hit(crossing));
                }
                last = crossing.t;
            }
        }
        watch::go_on()?;
        if let Some(part) = unclear {
            let message = "the ray goes along the surface of this part, or meets it where it folds, so closely that it takes too long to tell where: expected another direction, or a surface that does not run through itself";
            return Err(Error::new(Code::TooLarge, format!("parts[{part}]"), message).with("what", "ray"));
        }
        hits.sort_by(|one, other| one.distance.total_cmp(&other.distance).then(one.part.cmp(&other.part)));
        Ok(hits)
    }

    /// As [`at`].
    ///
    /// # Errors
    /// As [`at`].
    pub fn at(&self, at: [f64; 3]) -> Result<Vec<Hit>> {
        let at = point(at, "point")?;
        let sight = self.sight()?;
        let mut hits = Vec::new();
        for space in sight.met(self, |bounds| bounds.holds(at))? {
            match space.holds(at) {
                Some(true) => hits.push(space.beneath(at)),
                Some(false) => {}
                None => {
                    watch::go_on()?;
                    let message = "no ray from here tells on which side of the surface of this part the point is: expected a surface that does not run through itself";
                    return Err(
                        Error::new(Code::TooLarge, format!("parts[{}]", space.part), message).with("what", "point")
                    );
                }
            }
        }
        watch::go_on()?;
        hits.sort_by(|one: &Hit, other: &Hit| one.distance.total_cmp(&other.distance).then(one.part.cmp(&other.part)));
        Ok(hits)
    }
}

impl Space {
    fn hit(&self, crossing: &Crossing) -> Hit {
        let Crossing { border, u, v, t, position, .. } = *crossing;
        let normal = match self.octant() {
            Some(octant) => self.placed_normal(octant.normal(self.own(position), border)),
            None => self.borders[border].normal(u, v),
        };
        self.hit_at(border, [u, v], t, position, normal)
    }

    /// The nearest place of the surface to a point that the part holds.
    fn beneath(&self, at: DVec3) -> Hit {
        let nearest = self.nearest(at);
        let normal = match self.octant() {
            Some(octant) => self.placed_normal(octant.normal(self.own(nearest.position), nearest.border)),
            None => self.borders[nearest.border].normal(nearest.u, nearest.v),
        };
        self.hit_at(nearest.border, [nearest.u, nearest.v], nearest.distance, nearest.position, normal)
    }

    fn hit_at(&self, border: usize, [u, v]: [f64; 2], distance: f64, position: DVec3, normal: DVec3) -> Hit {
        let face = self.borders[border].kind();
        let has_parameters = face.is_none() && self.octant().is_none();
        // A surface between two curves goes round by its own span.
        let span = self.placed().solved().fourier().map_or(1.0, |surface| surface.span());
        Hit {
            part: self.part,
            distance,
            point: position.to_array(),
            normal: normal.to_array(),
            face,
            patch: face.is_none().then_some(border),
            u: has_parameters.then_some(u),
            v: has_parameters.then_some(v * span),
        }
    }
}
