//! A vase in another order, with what that order can hold of it.

use std::f64::consts::TAU;

use super::family::{BloorWilson, FourthOrder, MixedOrder, SecondOrder};
use super::fields::Fields;
use super::names::names;
use super::number::{rounded, rounded_to};
use super::shape::Shape;
use crate::answer::answers;
use crate::error::{Code, Error, Result};

names! {
    /// An order of the equation for which ZY01 has a vase.
    pub enum VaseOrder {
        /// ZY01 eqs 1-8, [`SecondOrder`].
        Second = "second-order",
        /// ZY01 eqs 9-12, [`MixedOrder`].
        Mixed = "mixed-order",
        /// ZY01 eqs 13-17, [`FourthOrder`].
        Fourth = "fourth-order",
    }
}

names! {
    /// What a vase has to leave behind in another order.
    #[non_exhaustive]
    pub enum Loss {
        /// The waves of the rim of a dint vase.
        Dints = "dints",
        /// The oval of its rim.
        Skew = "skew",
        /// The petals of rim and foot.
        Petals = "petals",
        /// The force along the wall.
        Push = "push",
        /// All turns of the wall but the first.
        Turns = "turns",
        /// How the wall rises: it becomes even.
        Rise = "rise",
        /// The slopes at both ends: the equation decides on them.
        Slopes = "slopes",
    }
}

answers! {
    /// A shape in another order.
    pub struct Conversion as "Conversion" {
        /// It has the same rim, foot and height.
        pub shape: Shape,
        /// What it had to leave behind.
        pub lost: Vec<Loss>,
    }
}

#[cfg(feature = "typescript")]
crate::answer::known_as!(Loss, "Loss");

impl Shape {
    /// The vase in another order, with what that order can hold of it: rim, foot and height always, and of the slopes at both ends what can be prescribed; from second to mixed order, which prescribes one of the two, `z` leaves the rim so that it bends least on the way to a level foot.
    ///
    /// A wall of second order, `s q'' = t k^2 q` with `k = 2 pi n`, also solves `q'''' = (t k^2 / s) q''`. So a vase of fourth order with `s = 1`, that `t`, `w = 0` and the
    /// wall's own slopes is the same wall, but for petals, force and further turns. The way back takes such a vase to the one that it came from, to ten digits.
    /// In the order that it has the shape stays as it is.
    ///
    /// ```
    /// use pasu::{Design, Loss, Shape, VaseOrder};
    ///
    /// let vase = Design::parse("#1/second-order?height=10")?;
    /// let made = vase.parts()[0].shape.convert(VaseOrder::Fourth)?;
    /// let Shape::FourthOrder(fourth) = made.shape else { unreachable!() };
    /// assert_eq!((fourth.r1, fourth.r0, fourth.h1), (1.0, 0.6, 10.0));
    /// assert_eq!(made.lost, [Loss::Petals]);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    ///
    /// # Errors
    /// `unsupported-shape` for boundary data written out, which have no radius of rim and foot to keep, for pots of rings, and for what is no surface between two ends; `overflow` when the numbers of the other order leave the range of
    /// numbers.
    // Compiled where it is called, for size: see `Design::from_value`.
    #[inline]
    pub fn convert(&self, to: VaseOrder) -> Result<Conversion> {
        if self.kind() == to.name() {
            return Ok(Conversion { shape: self.clone(), lost: Vec::new() });
        }
        let Some(outline) = Outline::of(self) else {
            let message = match self {
                Shape::Rings(_) => "a pot of rings cannot be converted: no other family passes through them",
                #[cfg(feature = "patchwork")]
                Shape::Blend(_) => {
                    "a solid between two sections cannot be converted: it is no vase of one of the families"
                }
                #[cfg(feature = "patchwork")]
                Shape::Octant(_) => "an octant cannot be converted: it is no vase of one of the families",
                #[cfg(feature = "patchwork")]
                Shape::VertexFrame(_) => "a network of patches cannot be converted: it has no rim and no foot to keep",
                _ => {
                    "boundary data that are written out cannot be converted as a whole: each component has an order of its own"
                }
            };
            return Err(Error::new(Code::UnsupportedShape, "", message));
        };
        let mut lost = Vec::new();
        if let Shape::BloorWilson(vase) = self {
            lost.extend((vase.h[1] != 0.0 || vase.H[1] != 0.0).then_some(Loss::Dints));
            lost.extend((vase.r[1] + vase.r[2] != 0.0 || vase.R[1] + vase.R[2] != 0.0).then_some(Loss::Skew));
        }
        let shape = match to {
            VaseOrder::Fourth => {
                lost.extend(Planar::of(self).into_iter().flat_map(Planar::lost_in_fourth));
                Shape::FourthOrder(outline.fourth())
            }
            VaseOrder::Second | VaseOrder::Mixed => {
                let planar = Planar::of(self).unwrap_or_else(|| outline.planar());
                lost.extend((outline.is_prescribed()).then_some(Loss::Slopes));
                if to == VaseOrder::Second {
                    lost.extend((!outline.is_even).then_some(Loss::Rise));
                    Shape::SecondOrder(planar.second())
                } else {
                    Shape::MixedOrder(planar.mixed(outline.mixed_rise))
                }
            }
        };
        Ok(Conversion { shape: shape.finite()?, lost })
    }
}

/// What second and mixed order share.
struct Planar {
    r: [f64; 4],
    n: [f64; 2],
    height: f64,
    s: [f64; 2],
    t: [f64; 2],
    force: [f64; 2],
}

impl Planar {
    #[inline]
    fn of(shape: &Shape) -> Option<Planar> {
        match *shape {
            Shape::SecondOrder(SecondOrder { r, n, height, s, t, force })
            | Shape::MixedOrder(MixedOrder { r, n, height, s, t, force, .. }) => {
                Some(Planar { r, n, height, s, t, force })
            }
            _ => None,
        }
    }

    #[inline]
    fn lost_in_fourth(self) -> impl Iterator<Item = Loss> {
        let petals = self.r[1] != 0.0 || self.r[3] != 0.0;
        let push = self.force != [0.0; 2];
        let turns = self.n[0] != 1.0;
        let all = [(petals, Loss::Petals), (push, Loss::Push), (turns, Loss::Turns)];
        all.into_iter().filter(|(is_lost, _)| *is_lost).map(|(_, loss)| loss)
    }

    #[inline]
    fn second(self) -> SecondOrder {
        let Planar { r, n, height, s, t, force } = self;
        SecondOrder { r, n, height, s, t, force }
    }

    #[inline]
    fn mixed(self, rise: f64) -> MixedOrder {
        let Planar { r, n, height, s, t, force } = self;
        MixedOrder { r, n, height, s, t, force, rise }
    }
}

/// What any two orders can share: the wall without petals, `q(u)` away from the axis and `z(u)` along it, with the rim at `u = 0`.
struct Outline {
    rim: f64,
    foot: f64,
    height: f64,
    /// `q'` at the rim and at the foot.
    slopes: [f64; 2],
    /// `q` half way.
    middle: f64,
    /// `z'` at the rim and at the foot.
    rises: [f64; 2],
    /// Whether `z` falls in a straight line.
    is_even: bool,
    /// What mixed order takes for `z'` at the rim.
    mixed_rise: f64,
    /// `q'' / q` of a wall that second order can make, for x and for y.
    tension: Option<[f64; 2]>,
    /// The parameters of the equation of order 4: `s`, `t` and `w`.
    equation: [[f64; 2]; 3],
}

impl Outline {
    #[inline]
    fn of(shape: &Shape) -> Option<Outline> {
        match shape {
            Shape::SecondOrder(vase) => {
                let height = vase.height;
                // The cubic from `height` to a level foot that bends least.
                Some(Outline { is_even: true, ..Outline::of_planar(shape, [-height; 2], -1.5 * height)? })
            }
            Shape::MixedOrder(vase) => Outline::of_planar(shape, [vase.rise, 0.0], vase.rise),
            Shape::FourthOrder(vase) => Some(Outline::of_fourth(vase)),
            Shape::BloorWilson(vase) => Some(Outline::of_dint(vase)),
            _ => None,
        }
    }

    #[inline]
    fn of_planar(shape: &Shape, rises: [f64; 2], mixed_rise: f64) -> Option<Outline> {
        let Planar { r, n, height, s, t, .. } = Planar::of(shape)?;
        let square = (TAU * n[0]) * (TAU * n[0]);
        let tension = [t[0] / s[0] * square, t[1] / s[1] * square];
        let (rim, foot) = (r[0], r[2]);
        let wall = second_order_wall(rim, foot, tension[0]);
        Some(Outline {
            rim,
            foot,
            height,
            slopes: wall.slopes,
            middle: wall.middle,
            rises,
            is_even: false,
            mixed_rise,
            tension: Some(tension),
            equation: [[1.0; 2], tension.map(rounded), [0.0; 2]],
        })
    }

    #[inline]
    fn of_fourth(vase: &FourthOrder) -> Outline {
        let swell = vase.swell();
        let is_second = vase.w == [0.0; 2];
        Outline {
            rim: vase.r1,
            foot: vase.r0,
            height: vase.h1,
            slopes: [-vase.eta[1] * swell, -vase.eta[0] * swell],
            middle: vase.rm,
            rises: [-vase.dz[1], -vase.dz[0]],
            is_even: vase.dz == [vase.h1; 2],
            mixed_rise: -vase.dz[1],
            tension: is_second.then(|| [vase.t[0] / vase.s[0], vase.t[1] / vase.s[1]]),
            equation: [vase.s, vase.t, vase.w],
        }
    }

    #[inline]
    fn of_dint(vase: &BloorWilson) -> Outline {
        let (r, slope) = (vase.r, vase.R);
        let square = vase.a * vase.a;
        Outline {
            rim: r[0],
            foot: r[3],
            height: vase.h[0],
            slopes: [slope[0], slope[3]],
            // Of the cubic with these ends and slopes.
            middle: (r[0] + r[3]) / 2.0 + (slope[0] - slope[3]) / 8.0,
            rises: [vase.H[0], 0.0],
            is_even: false,
            mixed_rise: vase.H[0],
            tension: None,
            equation: [[1.0; 2], [2.0 * square; 2], [square * square; 2]],
        }
    }

    /// Whether its slopes are what no equation of second order has.
    fn is_prescribed(&self) -> bool {
        self.tension.is_none()
    }

    /// A round vase of fourth order with the slopes of this one.
    #[inline]
    fn fourth(&self) -> FourthOrder {
        let Outline { rim, foot, height, middle, .. } = *self;
        let [at_rim, at_foot] = self.slopes.map(|slope| -slope);
        let most = |numbers: &[f64]| numbers.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let start = FourthOrder { r0: foot, r1: rim, rm: rounded(middle), h1: height, ..FourthOrder::START };
        // Where the factor of the flares is next to nothing another belly radius has to make one, so that there are slopes.
        let is_flat = FourthOrder { rm: middle, ..start }.swell().abs() <= 1e-3 * most(&[rim, foot, at_foot, at_rim]);
        let rm = if is_flat { rounded((most(&[at_foot, at_rim, 1.0]) + rim + 3.0 * foot) / 4.0) } else { start.rm };
        let swell = FourthOrder { rm, ..start }.swell();
        let [s, t, w] = self.equation;
        FourthOrder {
            rm,
            eta: [rounded(at_foot / swell), rounded(at_rim / swell)],
            dz: [rounded(-self.rises[1]), rounded(-self.rises[0])],
            s,
            t,
            w,
            ..start
        }
    }

    /// A vase without petals; its wall is the same where second order can make it.
    #[inline]
    fn planar(&self) -> Planar {
        // What went through fourth order at twelve digits and comes back: the last two are rounding.
        let regained = |tension: f64| rounded_to(tension / (TAU * TAU), 10);
        let t = self.tension.map_or([0.1; 2], |tension| tension.map(regained));
        let SecondOrder { n, force, .. } = SecondOrder::START;
        Planar { r: [self.rim, 0.0, self.foot, 0.0], n, height: self.height, s: [1.0; 2], t, force }
    }
}

struct Wall {
    slopes: [f64; 2],
    middle: f64,
}

/// Below this the series of a wall are exact to the last digit or so, and its closed forms are not.
const WEAK: f64 = 1e-4;

/// End slopes and middle of `q'' = tension q`, `q(0) = rim`, `q(1) = foot`.
#[inline]
fn second_order_wall(rim: f64, foot: f64, tension: f64) -> Wall {
    let rate = tension.abs().sqrt();
    // With `r = rate`: `r / sinh r`, `r / tanh r` and `cosh(r / 2)`, which stay finite however strong the pull is; `sin`, `tan` and `cos` where it pushes.
    let (across, along, half) = if tension.abs() < WEAK {
        let t = tension;
        let across = 1.0 - t / 6.0 * (1.0 - t * 7.0 / 60.0 * (1.0 - t * 31.0 / 294.0));
        let along = 1.0 + t / 3.0 * (1.0 - t / 15.0 * (1.0 - t * 2.0 / 21.0));
        (across, along, 1.0 + t / 8.0 * (1.0 + t / 48.0 * (1.0 + t / 120.0)))
    } else if tension < 0.0 {
        let across = rate / libm::sin(rate);
        (across, across * libm::cos(rate), libm::cos(rate / 2.0))
    } else {
        let fall = libm::exp(-rate / 2.0);
        let square = fall * fall;
        let across = 2.0 * rate * square / (1.0 - square * square);
        let along = rate * (1.0 + square * square) / (1.0 - square * square);
        (across, along, (1.0 + square) / (2.0 * fall))
    };
    Wall { slopes: [foot * across - rim * along, foot * along - rim * across], middle: (rim + foot) / 2.0 / half }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weak_pull_is_as_the_closed_forms_where_both_hold() {
        // Either side of where the series end.
        for sign in [1.0, -1.0] {
            let [below, above] =
                [1.0 - 1e-12, 1.0 + 1e-12].map(|factor| second_order_wall(1.0, 0.6, sign * WEAK * factor));
            for (a, b) in [below.slopes[0], below.slopes[1], below.middle].iter().zip([
                above.slopes[0],
                above.slopes[1],
                above.middle,
            ]) {
                assert!((a - b).abs() < 3e-13, "{a} {b}");
            }
        }
    }

    #[test]
    fn no_pull_is_too_strong() {
        for tension in [1e3, 1e5, 1e7, 1e300] {
            let wall = second_order_wall(1.0, 0.6, tension);
            let rate = tension.sqrt();
            assert!(
                (wall.slopes[0] + rate).abs() <= 1e-12 * rate && (wall.slopes[1] - 0.6 * rate).abs() <= 1e-12 * rate
            );
            assert!(wall.middle >= 0.0 && wall.middle < 1e-5);
        }
    }
}
