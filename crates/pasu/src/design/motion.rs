//! A placement without scale: what takes one solid to where it stands, seen from another.

use super::fields::fields;
use super::number::rounded_to;
use super::placement::{Placement, Turn};

fields! {
    /// A rotation, then a shift: where something stands, seen from something else.
    ///
    /// What is computed has its axis and angle as those of a [`Placement`]: `axis = (h, k, l)` is a unit vector with `k > 0`, or `k = 0` and `h > 0`, or (0, 0, 1); `angle` lies in [-pi, pi); a turn by 0 has the axis (0, 0, 1).
    pub struct Motion, "a motion with axis, angle and shift" {
        /// The direction of the axis of rotation.
        axis: [f64; 3] = [0.0, 0.0, 1.0], Optional, Any, One;
        /// The angle in radians, anti-clockwise seen from where the axis points to.
        angle: f64 = 0.0, Optional, Any, Angle;
        /// The movement along x, y and z, after turning.
        shift: [f64; 3] = [0.0, 0.0, 0.0], Optional, Any, Length;
    }
}

/// What rounding leaves of a shift that is taken apart, as a share of the largest number that it was made of.
const APART: f64 = 2e-15;

/// The same of one that is put together: there is the rounding of both turns, and that by which the shift was freed of noise when it was taken apart.
const TOGETHER: f64 = 1.6e-14;

impl Default for Motion {
    /// No motion at all.
    fn default() -> Self {
        super::fields::Fields::START
    }
}

impl Motion {
    /// How something of this placement stands, but for its size.
    pub(crate) fn of(place: &Placement) -> Motion {
        Motion { axis: place.axis, angle: place.angle, shift: place.shift }
    }

    /// The placement of something of this size that stands so.
    pub(crate) fn placing(&self, scale: [f64; 3]) -> Placement {
        Placement { scale, axis: self.axis, angle: self.angle, shift: self.shift }
    }

    /// First the other motion, then this one.
    ///
    /// Numbers that nothing has to be added to stay as they are. What is computed is not rounded to twelve digits, but freed of what double precision leaves, so that numbers of twelve digits that were taken apart come together again.
    pub(crate) fn around(&self, inner: &Motion) -> Motion {
        let (turn, moved) = match (Turn::exact(self.axis, self.angle), Turn::exact(inner.axis, inner.angle)) {
            (None, _) => ((inner.axis, inner.angle), inner.shift),
            (Some(own), None) => ((self.axis, self.angle), own.applied(inner.shift)),
            (Some(own), Some(other)) => (own.after(&other).told(), own.applied(inner.shift)),
        };
        self.moving(turn, [self.shift, moved], &inner.shift, TOGETHER)
    }

    /// This motion, seen from where another leads to: what has to come before that to make this one.
    pub(crate) fn seen_from(&self, frame: &Motion) -> Motion {
        let away = [0, 1, 2].map(|i| self.shift[i] - frame.shift[i]);
        let (turn, moved) = match (Turn::exact(frame.axis, -frame.angle), Turn::exact(self.axis, self.angle)) {
            (None, _) => ((self.axis, self.angle), away),
            (Some(back), None) => (back.told(), back.applied(away)),
            (Some(back), Some(own)) => (back.after(&own).told(), back.applied(away)),
        };
        self.moving(turn, [[0.0; 3], moved], &frame.shift, APART)
    }

    /// The sum of two shifts, as exact as the numbers are that they were made of, after a turn.
    fn moving(&self, (axis, angle): ([f64; 3], f64), [one, other]: [[f64; 3]; 2], of: &[f64; 3], noise: f64) -> Motion {
        let largest = self.shift.iter().chain(of).fold(0.0f64, |largest, c| largest.max(c.abs()));
        Motion { axis, angle, shift: [0, 1, 2].map(|i| cleared(one[i] + other[i], noise * largest)) }
    }
}

/// The decimal number whose last digit is well above this noise, where there is one so near; the number itself otherwise.
fn cleared(x: f64, noise: f64) -> f64 {
    if x.abs() <= noise {
        return 0.0;
    }
    let digits = libm::floor(libm::log10(x.abs())) - libm::ceil(libm::log10(4.0 * noise)) + 1.0;
    if !(1.0..17.0).contains(&digits) {
        return x;
    }
    let near = rounded_to(x, digits as usize);
    if (near - x).abs() <= noise { near } else { x }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;

    fn motion(axis: [f64; 3], angle: f64, shift: [f64; 3]) -> Motion {
        let place = Placement { scale: [1.0; 3], axis, angle, shift };
        Motion::of(&place.canonical().unwrap())
    }

    fn images(motion: &Motion) -> Vec<f64> {
        let place = motion.placing([1.0; 3]);
        let (rows, shift) = (place.matrix(), place.shift);
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let image = |p: [f64; 3]| [0, 1, 2].map(|i| (0..3).map(|j| rows[i][j] * p[j]).sum::<f64>() + shift[i]);
        corners.into_iter().flat_map(image).collect()
    }

    #[test]
    fn simple_numbers_stay_simple() {
        let quarter = motion([0.0, 0.0, 1.0], PI / 2.0, [1.0, 2.0, 0.0]);
        let along = motion([0.0, 0.0, 1.0], 0.0, [0.3, 0.0, 0.1]);
        let found = quarter.around(&along);
        assert_eq!((found.axis, found.angle, found.shift), (quarter.axis, quarter.angle, [1.0, 2.3, 0.1]));
        assert_eq!(found.seen_from(&quarter), along);
        assert_eq!(along.around(&quarter).shift, [1.3, 2.0, 0.1]);
        let half = quarter.around(&quarter);
        assert_eq!((half.axis, half.angle, half.shift), ([0.0, 0.0, 1.0], -PI, [-1.0, 3.0, 0.0]));
        assert_eq!(quarter.seen_from(&quarter), Motion::default());
        assert_eq!(Motion::default().around(&quarter), quarter);
        // A motion as it was written, whatever its axis.
        let written = Motion { axis: [1.0, 2.0, 3.0], angle: 9.0, shift: [1e300, 0.0, 0.0] };
        assert_eq!(Motion::default().around(&written), written);
        assert!(written.around(&written).shift[0].is_finite());
    }

    /// To the last of twelve digits, which may fall to either side where there is a tie; what is 0 is 0.
    fn same(one: &[f64], other: &[f64]) -> bool {
        // One of the last digit, and no more.
        let unit = |a: f64| libm::exp10(libm::floor(libm::log10(a.abs())) - 11.0);
        let near =
            |a: f64, b: f64| a == b || (a != 0.0 && b != 0.0 && (a - b).abs() <= 1.01 * unit(a.abs().max(b.abs())));
        one.iter().zip(other).all(|(a, b)| near(*a, *b))
    }

    /// To the last of twelve decimals of the axis, which a small component has fewer digits of, and of twelve digits of the angle.
    fn is_same_turn(one: &Motion, other: &Motion) -> bool {
        let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1.01e-12;
        one.axis.iter().zip(&other.axis).all(is_near) && same(&[one.angle], &[other.angle])
    }

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            3 => (-40_000i32..40_000).prop_map(|x| f64::from(x) / 1e4),
            1 => -4.0..4.0f64,
            1 => prop::sample::select(vec![0.0, 1.0, -1.0, 0.5]),
        ]
    }

    fn angle() -> impl Strategy<Value = f64> {
        prop_oneof![3 => -3.1..3.1f64, 1 => (-12i32..12).prop_map(|twelfth| f64::from(twelfth) * PI / 12.0)]
    }

    prop_compose! {
        fn motions()(
            axis in [number(), number(), number()].prop_filter("an axis", |axis| axis.iter().any(|c| *c != 0.0)),
            angle in angle(),
            shift in [number(), number(), number()],
        ) -> Motion {
            motion(axis, angle, shift)
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        /// A quarter of a turn between placements of twelve digits is not one to the last digit, and was taken for it: axes of small turns came back 41 units of their last digit aside.
        #[test]
        fn what_stands_at_right_angles_comes_back(frame in motions(), twelfth in -12i32..12, axis in 0usize..4) {
            let axis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, -2.0, 0.5]][axis];
            let even = motion(axis, f64::from(twelfth) * PI / 12.0, [0.0; 3]);
            let given = Motion::of(&frame.around(&even).placing([1.0; 3]).canonical().unwrap());
            let again = Motion::of(&frame.around(&given.seen_from(&frame)).placing([1.0; 3]).canonical().unwrap());
            if given.angle == 0.0 || given.angle.abs() > 0.02 {
                prop_assert!(is_same_turn(&again, &given), "{:?} {:?} {:?}", frame, again, given);
            }
        }

        #[test]
        fn taken_apart_and_put_together(frame in motions(), given in motions()) {
            let relative = given.seen_from(&frame);
            let again = frame.around(&relative);
            let near = images(&given).iter().zip(images(&again)).all(|(one, other)| (one - other).abs() < 1e-11);
            prop_assert!(near, "{:?}\n{:?}\n{:?}", frame, given, again);
            // A small turn has an axis of few digits.
            let canonical = Motion::of(&again.placing([1.0; 3]).canonical().unwrap());
            if given.angle == 0.0 || given.angle.abs() > 0.02 {
                prop_assert!(is_same_turn(&canonical, &given), "{:?} {:?} {:?}", frame, canonical, given);
            }
            let is_small = |c: &f64| c.abs() > 0.0 && c.abs() < 0.1;
            if !given.shift.iter().any(is_small) {
                prop_assert!(same(&canonical.shift, &given.shift), "{:?} {:?} {:?}", frame, canonical, given);
            }
        }
    }
}
