//! Area, volume and first moments of what faces enclose, by the divergence theorem.

use core::f64::consts::TAU;

use glam::DVec3;

use super::accuracy::Accuracy;
use super::quantity::Quantity;
use super::whole_face::over_face;
use crate::face::{Face, FaceJet};
use crate::numeric::integral::Integral;
use crate::solution::Placed;

/// How far what is known in closed form may be off, as a part of it.
const ROUNDING: f64 = 1e-12;

/// The vector of a surface element, `F_a x F_v`, turned out of the clay.
pub(crate) fn element(face: &dyn Face, jet: &FaceJet) -> DVec3 {
    jet.da.cross(jet.dv) * face.outward()
}

/// What surface elements of a face add to its area: their lengths; of one that lies in a plane, where it may go back over itself, what they are to one side of that.
fn extent(face: &dyn Face) -> impl Fn(DVec3) -> f64 + use<> {
    /// Places round it of which the largest element is taken.
    const PLACES: u32 = 8;
    let at = |k| face.jet(0.5, TAU * f64::from(k) / f64::from(PLACES));
    let elements = (0..PLACES).filter(|_| face.is_level()).map(|k| element(face, &at(k)));
    let largest = elements.fold(DVec3::ZERO, |most, e| if e.length() > most.length() { e } else { most });
    let side = largest.try_normalize();
    move |element| side.map_or_else(|| element.length(), |side| side.dot(element))
}

/// The area of one face.
pub(crate) fn area(face: &dyn Face, accuracy: &Accuracy) -> Quantity {
    let extent = extent(face);
    let area = over_face(face, accuracy, |jet| [extent(element(face, jet))]);
    Quantity::new(area.value[0].abs(), area.error[0])
}

/// A volume and its first moments about the origin of the design.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Moments {
    pub(crate) volume: Quantity,
    pub(crate) first: [Quantity; 3],
}

impl Moments {
    /// Of a part whose volume and first moments are known in closed form.
    pub(crate) fn known(placed: &Placed) -> Option<Moments> {
        let (volume, first) = placed.solved().moments()?;
        let scale = placed.matrix().determinant().abs();
        let whole = Quantity::new(volume * scale, ROUNDING * volume * scale);
        let moment = (placed.matrix() * first + placed.shift() * volume) * scale;
        let size = (placed.matrix().abs() * first + placed.shift().abs() * volume) * scale;
        Some(Moments { volume: whole, first: core::array::from_fn(|i| Quantity::new(moment[i], ROUNDING * size[i])) })
    }

    /// Of an integral of `[volume, moments about a point]`.
    pub(crate) fn about(point: DVec3, integral: &Integral<4>) -> Moments {
        let quantity = |i: usize| Quantity::new(integral.value[i], integral.error[i]);
        let volume = quantity(0);
        Moments { volume, first: core::array::from_fn(|i| quantity(i + 1) + volume * point[i]) }
    }

    /// Of the same solid made of something of this density, or the sum of several.
    pub(crate) fn scaled(&self, density: f64) -> Moments {
        Moments { volume: self.volume * density, first: self.first.map(|moment| moment * density) }
    }

    pub(crate) fn plus(&self, other: &Moments) -> Moments {
        Moments { volume: self.volume + other.volume, first: core::array::from_fn(|i| self.first[i] + other.first[i]) }
    }

    /// The centre of mass and how far each of its coordinates may be off; `None` where there is no volume.
    pub(crate) fn centre(&self) -> Option<(DVec3, f64)> {
        let volume = self.volume.value;
        let centre = DVec3::from_array(self.first.map(|moment| moment.value / volume));
        let error = (0..3).fold(0.0f64, |most, i| {
            most.max((self.first[i].error + self.volume.error * centre[i].abs()) / volume.abs())
        });
        (volume > 0.0 && centre.is_finite() && error.is_finite()).then_some((centre, error))
    }
}

/// Area, volume and first moments of what closed faces enclose.
///
/// `3 V` is the flux of `p`, and `4 int p dV` that of `p` times itself, through the whole boundary (the divergence theorem); `p` is taken from a point in the middle, so that little
/// cancels. The areas come face by face.
pub(crate) fn enclosed(faces: &[&dyn Face], accuracy: &Accuracy) -> (Vec<Quantity>, Moments) {
    let middle = faces.iter().map(|face| face.jet(0.5, 0.0).position + face.jet(0.5, core::f64::consts::PI).position);
    let middle = middle.sum::<DVec3>() / (2 * faces.len()).max(1) as f64;
    let mut total = Integral::<4>::default();
    let mut areas = Vec::with_capacity(faces.len());
    for &face in faces {
        let extent = extent(face);
        let integral = over_face(face, accuracy, |jet| {
            let (arm, element) = (jet.position - middle, element(face, jet));
            let flux = arm.dot(element);
            let moment = arm * (0.25 * flux);
            [flux / 3.0, moment.x, moment.y, moment.z, extent(element)]
        });
        let Integral { value, error, size } = integral;
        areas.push(Quantity::new(value[4].abs(), error[4]));
        let first = |all: [f64; 5]| [all[0], all[1], all[2], all[3]];
        total.add(&Integral { value: first(value), error: first(error), size: first(size) });
    }
    (areas, Moments::about(middle, &total))
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::*;
    use crate::face::{FaceKind, Sealed};

    /// A face from a function of `(a, v)`.
    struct Patch<F>(F);

    impl<F> Sealed for Patch<F> {}

    impl<F: Fn(f64, f64) -> [DVec3; 3] + Send + Sync> Face for Patch<F> {
        fn kind(&self) -> FaceKind {
            FaceKind::Outer
        }

        fn jet(&self, a: f64, v: f64) -> FaceJet {
            let [position, da, dv] = (self.0)(a, v);
            FaceJet { position, da, dv }
        }

        fn outward(&self) -> f64 {
            1.0
        }
    }

    /// A surface of revolution from its profile `(r, z)` and the derivative, traversed so that the outside is on the right.
    fn turned(profile: impl Fn(f64) -> [[f64; 2]; 2] + Send + Sync) -> impl Face {
        Patch(move |a, v: f64| {
            let [[r, z], [dr, dz]] = profile(a);
            let (s, c) = v.sin_cos();
            let x = DVec3::new(r * c, r * s, z);
            // F_v x F_a of an ascending profile points outwards; v is reversed to make it F_a x F_v.
            let x = DVec3::new(x.x, -x.y, x.z);
            [x, DVec3::new(dr * c, -dr * s, dz), DVec3::new(-r * s, -r * c, 0.0)]
        })
    }

    fn disc(from: f64, to: f64, z: f64) -> impl Face {
        turned(move |a| [[from + a * (to - from), z], [to - from, 0.0]])
    }

    fn near(found: Quantity, exact: f64, size: f64) {
        assert!((found.value - exact).abs() <= 1e-10 * size, "{found:?} {exact}");
        assert!((found.value - exact).abs() <= found.error, "dishonest: {found:?} {exact}");
        assert!(found.error <= 1e-9 * size, "{found:?}");
    }

    fn accuracy() -> Accuracy {
        Accuracy::new(1e-11, 1.0)
    }

    #[test]
    fn a_cylinder() {
        let (r, h, z) = (1.7, 5.3, 40.0);
        let (foot, side, lid) = (disc(0.0, r, z), turned(move |a| [[r, z + h * a], [0.0, h]]), disc(r, 0.0, z + h));
        let (areas, moments) = enclosed(&[&foot, &side, &lid], &accuracy());
        near(areas[0], PI * r * r, 1.0);
        near(areas[1], TAU * r * h, 50.0);
        let volume = PI * r * r * h;
        near(moments.volume, volume, volume);
        near(moments.first[2], volume * (z + 0.5 * h), volume * z);
        let (centre, error) = moments.centre().unwrap();
        assert!((centre - DVec3::new(0.0, 0.0, z + 0.5 * h)).length() < 1e-12 && error < 1e-8, "{centre} {error}");
    }

    #[test]
    fn a_cone() {
        let (r, h) = (2.3, 0.9);
        let side = turned(move |a| [[r * (1.0 - a), h * a], [-r, h]]);
        let (areas, moments) = enclosed(&[&disc(0.0, r, 0.0), &side], &accuracy());
        near(areas[1], PI * r * r.hypot(h), 10.0);
        let volume = PI * r * r * h / 3.0;
        near(moments.volume, volume, volume);
        near(moments.first[2], volume * h / 4.0, volume);
    }

    #[test]
    fn a_sphere_and_a_leaning_hemisphere() {
        let r = 3.1f64;
        let ball = |to: f64| {
            turned(move |a| {
                let t = PI * to * a;
                [[r * t.sin(), -r * t.cos()], [r * PI * to * t.cos(), r * PI * to * t.sin()]]
            })
        };
        let (areas, moments) = enclosed(&[&ball(1.0)], &accuracy());
        near(areas[0], 4.0 * PI * r * r, 100.0);
        near(moments.volume, 4.0 / 3.0 * PI * r.powi(3), 100.0);
        let (areas, moments) = enclosed(&[&ball(0.5), &disc(r, 0.0, 0.0)], &accuracy());
        near(areas[0], 2.0 * PI * r * r, 100.0);
        near(moments.volume, 2.0 / 3.0 * PI * r.powi(3), 100.0);
        assert!((moments.centre().unwrap().0.z + 3.0 / 8.0 * r).abs() < 1e-10);
    }

    #[test]
    fn a_torus_and_a_torus_with_flutes() {
        let (far, r) = (4.0f64, 1.25f64);
        let torus = turned(move |a| {
            let (s, c) = (TAU * a).sin_cos();
            [[far + r * s, -r * c], [r * TAU * c, r * TAU * s]]
        });
        let (areas, moments) = enclosed(&[&torus], &accuracy());
        near(areas[0], 4.0 * PI * PI * far * r, 200.0);
        near(moments.volume, 2.0 * PI * PI * far * r * r, 200.0);
        assert!(moments.centre().unwrap().0.length() < 1e-12);

        // Radius r + e cos(40 v) at every place: the mean of its square is r^2 + e^2 / 2.
        let e = 0.1;
        let fluted = Patch(move |a: f64, v: f64| {
            let (s, c) = (TAU * a).sin_cos();
            let (rho, d_rho) = (r + e * (40.0 * v).cos(), -40.0 * e * (40.0 * v).sin());
            let (sv, cv) = v.sin_cos();
            let round = |radius: f64, z: f64| DVec3::new(radius * cv, -radius * sv, z);
            let dv = round(d_rho * s, -d_rho * c) + (far + rho * s) * DVec3::new(-sv, -cv, 0.0);
            [round(far + rho * s, -rho * c), round(rho * TAU * c, rho * TAU * s), dv]
        });
        let (_, moments) = enclosed(&[&fluted], &Accuracy::new(1e-11, 40.0));
        near(moments.volume, 2.0 * PI * PI * far * (r * r + 0.5 * e * e), 200.0);
    }
}
