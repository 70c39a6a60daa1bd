//! Where a part stands: scaled, then turned, then moved (ASB88).

use std::f64::consts::PI;

use super::fields::fields;
use super::number::{rounded, rounded_in_unit, rounded_to};
use crate::error::{Code, Error, Result};

fields! {
    /// The placement of a part: scale, then rotation, then shift.
    ///
    /// In a [`Design`](crate::Design) it is canonical, so that equal placements have equal numbers: `scale` has
    /// `Sx, Sz > 0`, and the sign of `Sy` says whether the part is mirrored; `axis = (h, k, l)` is a unit vector with
    /// `k > 0`, or `k = 0` and `h > 0`, or (0, 0, 1); `angle` lies in [-pi, pi); a turn by 0 has the axis (0, 0, 1).
    /// Of the placements that make the same solid, because the shape is its own image under some motion, it is the one that `docs/scenes.md` names.
    pub struct Placement, "a placement" {
        /// Factors along x, y and z, before turning.
        scale: [f64; 3] = [1.0, 1.0, 1.0], Optional, NotZero, One;
        /// The direction of the axis of rotation.
        axis: [f64; 3] = [0.0, 0.0, 1.0], Optional, Any, One;
        /// The angle in radians, anti-clockwise seen from where the axis points to.
        angle: f64 = 0.0, Optional, Any, Angle;
        /// The movement along x, y and z, after turning.
        shift: [f64; 3] = [0.0, 0.0, 0.0], Optional, Any, Length;
    }
}

impl Default for Placement {
    /// Where the shape's own equations put it.
    fn default() -> Self {
        super::fields::Fields::START
    }
}

impl Placement {
    /// The rows of the matrix that scales, then turns (Rodrigues' formula; ASB88 T2, corrected).
    ///
    /// A point `p` of the shape goes to `matrix p + shift`. Turns by 0 and by half a turn are exact.
    ///
    /// ```
    /// let vase = pasu::Design::parse("#1/bloor-wilson")?;
    /// assert_eq!(vase.parts()[0].place.matrix(), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    /// # Ok::<(), pasu::Error>(())
    /// ```
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        // Twelve decimals leave the axis a little off unit length.
        let length = norm(self.axis);
        let rotation = rotation(self.axis.map(|c| c / length), self.angle);
        rotation.map(|row| [row[0] * self.scale[0], row[1] * self.scale[1], row[2] * self.scale[2]])
    }

    /// The same size, neither turned nor moved.
    pub(crate) fn still(&self) -> Placement {
        Placement { scale: self.scale, ..Placement::default() }
    }

    /// The same size and direction, not moved.
    pub(crate) fn unmoved(&self) -> Placement {
        Placement { shift: [0.0; 3], ..*self }
    }

    /// Where the coordinate axes of the shape point to, as unit vectors: a negative factor turns one round. `None` when the axis has no direction.
    pub(super) fn directions(&self) -> Option<[[f64; 3]; 3]> {
        let rotation = rotation(unit(self.axis)?, as_given(self.angle));
        Some([0, 1, 2].map(|axis| rotation.map(|row| if self.scale[axis] < 0.0 { -row[axis] } else { row[axis] })))
    }

    /// The canonical placement that takes the coordinate axes to these directions, which are at right angles to each other, each made so long. The shift is canonical; `digits` are those of the angle that the directions were made of.
    pub(super) fn along(directions: [[f64; 3]; 3], lengths: [f64; 3], shift: [f64; 3], digits: Digits) -> Placement {
        let [x, y, z] = directions;
        let across = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
        let is_mirrored = (0..3).map(|i| across[i] * y[i]).sum::<f64>() < 0.0;
        let y = if is_mirrored { y.map(|c| 0.0 - c) } else { y };
        let Turn { axis, angle } = Turn::to([x, y, z], digits).oriented();
        let [sx, sy, sz] = lengths.map(rounded);
        Placement { scale: [sx, if is_mirrored { -sy } else { sy }, sz], axis, angle, shift }
    }

    /// The digits of the angle.
    pub(super) fn digits(&self) -> Digits {
        let has = |digits: usize| rounded_to(self.angle, digits) == self.angle;
        if has(12) && !has(SHORT) { Digits::Twelve } else { Digits::All }
    }

    /// The one placement that moves every point as this one does (ASB88).
    ///
    /// # Errors
    /// `out-of-range` when the axis has no direction.
    pub(crate) fn canonical(self) -> Result<Self> {
        let Some(axis) = direction(self.axis) else {
            let message = "expected the direction of an axis, found [0, 0, 0]";
            return Err(Error::new(Code::OutOfRange, "axis", message));
        };
        let mut turn = Turn { axis, angle: principal(self.angle) };
        let mut scale = self.scale.map(rounded);
        // Two negative factors are half a turn. `Sy` takes what is left over, so that only it tells the handedness.
        let half_turn_about = match (scale[0] < 0.0, scale[2] < 0.0) {
            (false, false) => None,
            (true, true) => Some(1),
            (true, false) => Some(2),
            (false, true) => Some(0),
        };
        if let Some(about) = half_turn_about {
            for (index, factor) in scale.iter_mut().enumerate() {
                if index != about {
                    *factor = -*factor;
                }
            }
            // From the numbers as they were given, so that no rounding comes on top of another.
            let given = Turn { axis: unit(self.axis).unwrap_or(axis), angle: as_given(self.angle) };
            turn = given.after_half_turn(about, self.digits());
        }
        let Turn { axis, angle } = turn.oriented();
        Ok(Placement { scale, axis, angle, shift: self.shift.map(rounded) })
    }
}

/// How much of an angle is known.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Digits {
    /// As much as double precision holds: a number of few digits that somebody wrote, or all of what somebody computed.
    All,
    /// It was rounded to twelve digits.
    Twelve,
}

/// A number of no more digits than this was hardly rounded to twelve.
const SHORT: usize = 10;

/// A rotation: unit axis to twelve decimals, angle in [-pi, pi).
#[derive(Clone, Copy)]
pub(super) struct Turn {
    axis: [f64; 3],
    angle: f64,
}

impl Turn {
    /// The rotation that takes the coordinate axes to these directions.
    fn to(directions: [[f64; 3]; 3], digits: Digits) -> Turn {
        let [w, vector @ ..] = quaternion(directions);
        let angle = 2.0 * libm::atan2(norm(vector), w);
        match normalised(vector) {
            Some(axis) => Turn { axis, angle: computed(angle, digits) },
            None => Turn { axis: UPRIGHT, angle: 0.0 },
        }
    }

    /// This rotation applied after half a turn about one of the coordinate axes: a product of quaternions.
    fn after_half_turn(self, about: usize, digits: Digits) -> Turn {
        // cos(pi/2) as computed is not 0; half a turn must not leave noise in place of zeros.
        let (w, sin) = if self.angle.abs() == PI {
            (0.0, 1.0)
        } else {
            (libm::cos(self.angle / 2.0), libm::sin(self.angle / 2.0))
        };
        let v = self.axis.map(|c| c * sin);
        let (next, last) = ((about + 1) % 3, (about + 2) % 3);
        let mut vector = [0.0; 3];
        vector[about] = w;
        vector[next] = v[last];
        vector[last] = -v[next];
        let angle = 2.0 * libm::atan2(norm(vector), -v[about]);
        match normalised(vector) {
            Some(axis) => Turn { axis, angle: computed(angle, digits) },
            None => Turn { axis: UPRIGHT, angle: 0.0 },
        }
    }

    /// The same rotation about the one of the two opposite axes that the format prefers.
    fn oriented(self) -> Turn {
        if self.angle == 0.0 {
            return Turn { axis: UPRIGHT, angle: 0.0 };
        }
        let [h, k, l] = self.axis;
        let preferred = k > 0.0 || (k == 0.0 && (h > 0.0 || (h == 0.0 && l > 0.0)));
        if preferred {
            return self;
        }
        let angle = if self.angle == -PI { -PI } else { -self.angle };
        // `0.0 - c` and not `-c`: zero stays without a sign.
        Turn { axis: self.axis.map(|c| 0.0 - c), angle }
    }
}

/// The rotation that takes the coordinate axes to these directions, real part first, of any length: of the four forms that a quaternion has, the one that divides by its largest number.
pub(super) fn quaternion([x, y, z]: [[f64; 3]; 3]) -> [f64; 4] {
    let forms = [
        [1.0 + x[0] + y[1] + z[2], y[2] - z[1], z[0] - x[2], x[1] - y[0]],
        [y[2] - z[1], 1.0 + x[0] - y[1] - z[2], x[1] + y[0], z[0] + x[2]],
        [z[0] - x[2], x[1] + y[0], 1.0 - x[0] + y[1] - z[2], y[2] + z[1]],
        [x[1] - y[0], z[0] + x[2], y[2] + z[1], 1.0 - x[0] - y[1] + z[2]],
    ];
    let largest =
        (1..4).fold(0, |largest, form| if forms[form][form] > forms[largest][largest] { form } else { largest });
    forms[largest]
}

/// A rotation in double precision, as a unit quaternion and as the rows of its matrix.
#[cfg(feature = "patchwork")]
pub(super) struct Exact {
    real: f64,
    vector: [f64; 3],
    rows: [[f64; 3]; 3],
}

/// What double precision leaves of the angle of a turn that was computed from others.
#[cfg(feature = "patchwork")]
const NOISE: f64 = 1e-14;

#[cfg(feature = "patchwork")]
impl Turn {
    /// A turn as it was given; `None` of one that turns nothing.
    ///
    /// One of more than twelve digits was computed, from turns of twelve: beside a whole number of twenty-fourths it is beside that.
    pub(super) fn exact(axis: [f64; 3], angle: f64) -> Option<Exact> {
        let is_written = !(-PI..PI).contains(&angle) || rounded(angle) == angle;
        let angle = if is_written { as_given(angle) } else { below_half_turn(angle) };
        let axis = unit(axis).filter(|_| angle != 0.0)?;
        let (real, sin) = match angle.abs() == PI {
            true => (0.0, 1.0f64.copysign(angle)),
            false => (libm::cos(angle / 2.0), libm::sin(angle / 2.0)),
        };
        Some(Exact { real, vector: axis.map(|c| c * sin), rows: rotation(axis, angle) })
    }
}

#[cfg(feature = "patchwork")]
impl Exact {
    /// The image of a vector.
    pub(super) fn applied(&self, vector: [f64; 3]) -> [f64; 3] {
        self.rows.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
    }

    /// First the other rotation, then this one. Of the matrix of the product there is no use.
    pub(super) fn after(&self, other: &Exact) -> Exact {
        let ([a, b, c], [x, y, z]) = (self.vector, other.vector);
        let (s, t) = (self.real, other.real);
        let real = s * t - (a * x + b * y + c * z);
        let vector = [s * x + t * a + b * z - c * y, s * y + t * b + c * x - a * z, s * z + t * c + a * y - b * x];
        Exact { real, vector, rows: self.rows }
    }

    /// Axis and angle in the one way of writing them, not rounded but freed of noise.
    pub(super) fn told(&self) -> ([f64; 3], f64) {
        let full = 2.0 * libm::atan2(norm(self.vector), self.real);
        let angle = if full > PI { full - 2.0 * PI } else { full };
        let even = reduced(angle);
        let turn = match unit(self.vector) {
            Some(axis) if angle.abs() > NOISE => {
                let angle = match (angle.abs() - even.abs()).abs() <= NOISE {
                    true if as_given(even) == even => even,
                    // These twelve digits would be read as a whole number of twenty-fourths of a turn, which it is not.
                    true if angle == even => angle.next_up(),
                    _ => angle,
                };
                Turn { axis: settled(axis), angle: below_half_turn(angle) }.oriented()
            }
            _ => Turn { axis: UPRIGHT, angle: 0.0 },
        };
        (turn.axis, turn.angle)
    }
}

/// The axis of twelve decimals that has this direction, if there is one: an axis of so many is a little off unit length, and divided by that it may round to another.
#[cfg(feature = "patchwork")]
fn settled(axis: [f64; 3]) -> [f64; 3] {
    let near = axis.map(rounded_in_unit);
    let steps = (0..27).map(|k| [k % 3, k / 3 % 3, k / 9].map(|step| f64::from(step - 1) * 1e-12));
    let candidates = steps.map(|step| [0, 1, 2].map(|i| rounded_in_unit(near[i] + step[i])));
    let distance = |candidate: &[f64; 3]| {
        let unit = unit(*candidate).unwrap_or(UPRIGHT);
        norm([0, 1, 2].map(|i| unit[i] - axis[i]))
    };
    let proper = candidates.filter(|candidate| direction(*candidate) == Some(*candidate));
    let nearest = proper.min_by(|one, other| distance(one).total_cmp(&distance(other)));
    nearest.filter(|candidate| distance(candidate) <= NOISE).unwrap_or(axis)
}

/// The axis of a turn by 0.
const UPRIGHT: [f64; 3] = [0.0, 0.0, 1.0];

/// The unit vector along an axis of any length, to twelve decimals; `None` when it is zero.
///
/// An axis that is such a vector already stays as it is. Divided by its length again it could change in its last place,
/// and canonical form would not be its own canonical form.
pub(super) fn direction(axis: [f64; 3]) -> Option<[f64; 3]> {
    let near = axis.map(rounded_in_unit);
    // Half a unit of the last place of each component changes the length of a unit vector by no more than this.
    let slack = near.iter().fold(1e-15, |slack, c| slack + 0.5e-12 * c.abs());
    if (norm(near) - 1.0).abs() <= slack { Some(near) } else { normalised(axis) }
}

fn normalised(vector: [f64; 3]) -> Option<[f64; 3]> {
    unit(vector).map(|vector| vector.map(rounded_in_unit))
}

/// The vector of length 1 along a vector of any length; `None` when it is zero.
fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let largest = vector.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
    if largest == 0.0 {
        return None;
    }
    // By the largest first: the squares of very large or small components leave the range of numbers.
    let scaled = vector.map(|c| c / largest);
    let length = norm(scaled);
    Some(scaled.map(|c| c / length))
}

/// The rows of the matrix of a turn about a unit vector (Rodrigues' formula). By 0 and by half a turn they are exact.
fn rotation([h, k, l]: [f64; 3], angle: f64) -> [[f64; 3]; 3] {
    let (sin, cos) = if angle == -PI { (0.0, -1.0) } else { (libm::sin(angle), libm::cos(angle)) };
    let turned = 1.0 - cos;
    [
        [cos + h * h * turned, h * k * turned - l * sin, h * l * turned + k * sin],
        [h * k * turned + l * sin, cos + k * k * turned, k * l * turned - h * sin],
        [h * l * turned - k * sin, k * l * turned + h * sin, cos + l * l * turned],
    ]
}

/// An angle in [-pi, pi) to twelve digits. What rounds to half a turn is half a turn.
fn principal(angle: f64) -> f64 {
    if (-PI..PI).contains(&angle) { below_half_turn(rounded(angle)) } else { reduced(angle) }
}

/// A computed angle in [-pi, pi) to twelve digits and no more than twelve decimals: whole turns are not whole numbers, and what is left of them is noise.
fn reduced(angle: f64) -> f64 {
    let within = libm::atan2(libm::sin(angle), libm::cos(angle));
    // Once and not twice: a number that was rounded to a tie may fall to the other side.
    below_half_turn(if within.abs() < 1.0 { rounded_in_unit(within) } else { rounded(within) })
}

/// A computed angle in [-pi, pi) as a document would have it that says it at once: to twelve digits, which of a small one are more than twelve decimals, as far as it was computed from numbers that tell these.
fn computed(angle: f64, digits: Digits) -> f64 {
    /// An angle below has no twelve digits left in double precision.
    const LEAST: f64 = 1e-3;
    let within = libm::atan2(libm::sin(angle), libm::cos(angle));
    match digits {
        Digits::All if within.abs() >= LEAST => below_half_turn(rounded(within)),
        _ => reduced(angle),
    }
}

/// Half a turn has one angle.
fn below_half_turn(angle: f64) -> f64 {
    if angle.abs() >= PI { -PI } else { angle }
}

/// The angle in [-pi, pi) to all its digits. Of whole turns alone nothing is left.
///
/// The turns go first: twelve digits of a very large angle are those of many others too, among them some of whole twenty-fourths.
fn as_given(angle: f64) -> f64 {
    let within = match (-PI..PI).contains(&angle) {
        true => angle,
        false if reduced(angle) == 0.0 => 0.0,
        false => libm::atan2(libm::sin(angle), libm::cos(angle)),
    };
    below_half_turn(even(within))
}

/// The angle itself where twelve digits hold it as they hold a whole number of twenty-fourths of a turn: a quarter of a turn that was read from a document is one.
fn even(angle: f64) -> f64 {
    let whole = libm::round(angle.abs() * 12.0 / PI) * PI / 12.0;
    if rounded(whole) == rounded(angle.abs()) { whole.copysign(angle) } else { angle }
}

fn norm([h, k, l]: [f64; 3]) -> f64 {
    (h * h + k * k + l * l).sqrt()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::design::fields::Fields;

    fn canonical(place: Placement) -> Placement {
        place.canonical().unwrap()
    }

    /// The largest distance between two placements' images of the corners of the unit cube.
    fn distance(a: &Placement, b: &Placement) -> f64 {
        let mut largest = 0.0f64;
        for corner in 0..8 {
            let p = [0, 1, 2].map(|axis| f64::from(corner >> axis & 1));
            let [a, b] = [a, b].map(|place| {
                let m = place.matrix();
                [0, 1, 2].map(|i| m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + place.shift[i])
            });
            largest = (0..3).fold(largest, |largest, i| largest.max((a[i] - b[i]).abs()));
        }
        largest
    }

    #[derive(serde::Deserialize)]
    struct Case {
        given: Placement,
        canonical: Placement,
    }

    #[test]
    fn every_reference_placement() {
        let text = include_str!("../../tests/reference/placements.json");
        let cases: Vec<Case> = serde_json::from_str(text).unwrap();
        assert_eq!(cases.len(), 25);
        for Case { given, canonical: expected } in cases {
            let found = canonical(given);
            for (found, expected) in found.numbers().concat().iter().zip(expected.numbers().concat()) {
                assert!((found - expected).abs() < 1e-9, "{given:?}\n{found:?}\n{expected:?}");
            }
            assert!(distance(&given, &found) < 1e-9);
            assert!(distance(&expected, &found) < 1e-9);
        }
    }

    #[test]
    #[allow(clippy::approx_constant, reason = "half a turn as people write it")]
    fn special_turns() {
        let place = |axis, angle| canonical(Placement { axis, angle, ..Placement::default() });
        // A whole turn is none, whatever its axis.
        assert_eq!(place([1.0, 2.0, 3.0], 2.0 * PI), Placement::default());
        assert_eq!(place([1.0, 2.0, 3.0], -6.0 * PI), Placement::default());
        // Half a turn has two axes and two angles.
        for (axis, angle) in [([0.0, 0.0, -2.0], PI), ([0.0, 0.0, 1.0], -PI), ([0.0, 0.0, -1.0], 3.14159265359)] {
            let found = place(axis, angle);
            assert_eq!((found.axis, found.angle), ([0.0, 0.0, 1.0], -PI));
            assert_eq!(found.matrix(), [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
        }
        // The largest angle below half a turn that twelve digits tell from it.
        assert_eq!(place([0.0, 1.0, 0.0], 3.14159265358).angle, 3.14159265358);
        assert_eq!(place([3e200, 0.0, -4e200], 1.0).axis, [0.6, 0.0, -0.8]);
        assert_eq!(place([5e-324, 0.0, 0.0], 1.0).axis, [1.0, 0.0, 0.0]);
        let error = Placement { axis: [0.0; 3], ..Placement::default() }.canonical().unwrap_err();
        assert_eq!(error.to_string(), "axis: expected the direction of an axis, found [0, 0, 0]");
    }

    /// Zeros of both signs, ones, multiples of right angles, noise beside them, tiny and huge numbers.
    fn awkward() -> impl Strategy<Value = f64> {
        prop_oneof![
            3 => -4.0..4.0f64,
            1 => Just(0.0),
            1 => Just(-0.0),
            1 => prop::sample::select(vec![1.0, -1.0, PI, -PI, PI / 2.0, 1e-13, -1e-17, 1e-300, 5e-324, 1e9, -1e300]),
            1 => (-8i32..8, -1e-11..1e-11f64).prop_map(|(quarter, noise)| f64::from(quarter) * PI / 2.0 + noise),
        ]
    }

    fn factor() -> impl Strategy<Value = f64> {
        awkward().prop_filter("a factor is not 0", |x| *x != 0.0)
    }

    prop_compose! {
        fn placement()(
            scale in [factor(), factor(), factor()],
            axis in [awkward(), awkward(), awkward()].prop_filter("an axis", |axis| axis.iter().any(|c| *c != 0.0)),
            angle in awkward(),
            shift in [awkward(), awkward(), awkward()],
        ) -> Placement {
            Placement { scale, axis, angle, shift }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn canonical_form_is_its_own_and_moves_nothing(given in placement()) {
            let once = canonical(given);
            let bits = |place: &Placement| place.numbers().concat().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            prop_assert_eq!(bits(&canonical(once)), bits(&once));
            prop_assert!(once.scale[0] > 0.0 && once.scale[2] > 0.0 && once.scale[1] != 0.0);
            prop_assert!((-PI..PI).contains(&once.angle));
            prop_assert!((norm(once.axis) - 1.0).abs() <= 1e-12);
            let [h, k, _] = once.axis;
            prop_assert!(k > 0.0 || (k == 0.0 && h > 0.0) || once.axis == UPRIGHT);
            let unit = Placement { axis: given.axis.map(|c| c / given.axis.iter().fold(0.0, |m: f64, c| m.max(c.abs()))), ..given };
            let size = given.scale.iter().chain(&given.shift).fold(1.0f64, |size, x| size.max(x.abs()));
            prop_assert!(distance(&unit, &once) <= 1e-10 * size, "{:?}\n{:?}", given, once);
        }
    }
}
