//! The one placement of an octant among those that make the same solid.
//!
//! An octant is the same when its exponents change places, each with its axis. So it has six placements, of which three mirror it: three directions from its corner, each with a length and an exponent, and nothing says which of them is `x`.
//! Canonical is the order in which the directions come nearest to the coordinate axes: an octant whose edges are parallel to these is turned by half turns alone, however it was described, and one that is not turned stays as it was written.

use super::fields::Octant;
use crate::design::placement::Placement;

/// All orders of three.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Numbers that are this near count as equal: far above what twelve digits leave of two descriptions of one solid, and far below what tells two directions from each other.
const SLACK: f64 = 1e-9;

/// How often an order is looked for again. Only where numbers differ by [`SLACK`] to the last digit does rounding a placement change the order once more.
const TRIES: usize = 6;

impl Octant {
    /// The same solid; `place` is the canonical form of the placement that was `given`.
    pub(super) fn in_order(self, given: &Placement, place: Placement) -> (Octant, Placement) {
        let Some(directions) = given.directions() else { return (self, place) };
        // From the numbers as they were given, so that no rounding comes on top of another.
        let placed = |order: [usize; 3]| {
            let lengths = order.map(|axis| place.scale[axis].abs());
            Placement::along(order.map(|axis| directions[axis]), lengths, place.shift, given.digits())
        };
        let is_half_turned = given.scale[0] < 0.0 || given.scale[2] < 0.0;
        let (mut order, mut found) = (ORDERS[0], if is_half_turned { placed(ORDERS[0]) } else { place });
        for _ in 0..TRIES {
            let better = found.directions().map_or(ORDERS[0], |directions| best(&directions));
            if better == ORDERS[0] {
                break;
            }
            order = better.map(|axis| order[axis]);
            found = placed(order);
        }
        (Octant { exponents: order.map(|axis| self.exponents[axis]) }, found)
    }
}

/// The order in which directions are nearest to `x`, `y` and `z`, whatever their sense. Where several are as near, the one whose first direction has the greatest `x`, or where that is equal the greatest `y`, and so on.
fn best(directions: &[[f64; 3]; 3]) -> [usize; 3] {
    let nearness = |order: &[usize; 3]| (0..3).map(|axis| directions[order[axis]][axis].abs()).sum::<f64>();
    let most = ORDERS.iter().map(nearness).fold(0.0, f64::max);
    let numbers = |order: &[usize; 3]| order.map(|axis| directions[axis]).into_iter().flatten().collect::<Vec<f64>>();
    let is_before = |order: &[usize; 3], other: &[usize; 3]| {
        let both = numbers(order).into_iter().zip(numbers(other));
        both.map(|(one, other)| one - other).find(|more| more.abs() > SLACK).is_some_and(|more| more > 0.0)
    };
    let near = ORDERS.into_iter().filter(|order| nearness(order) >= most - SLACK);
    near.reduce(|least, order| if is_before(&order, &least) { order } else { least }).unwrap_or(ORDERS[0])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn canonical(exponents: [f64; 3], given: Placement) -> (Octant, Placement) {
        Octant { exponents }.in_order(&given, given.canonical().unwrap())
    }

    #[test]
    #[allow(clippy::approx_constant, reason = "a quarter of a turn as documents hold it")]
    fn octants_along_the_axes_are_turned_by_half_turns_alone() {
        let third = 2.0 * std::f64::consts::PI / 3.0;
        let place = Placement { axis: [1.0; 3], angle: third, scale: [3.0, 4.0, 5.0], ..Placement::default() };
        let (octant, found) = canonical([1.0, 2.0, 6.0], place);
        assert_eq!(octant.exponents, [6.0, 1.0, 2.0]);
        assert_eq!(found, Placement { scale: [5.0, 3.0, 4.0], ..Placement::default() });
        // Its mirror image in the plane x = y.
        let quarter = Placement { angle: std::f64::consts::FRAC_PI_2, scale: [1.0, -1.0, 1.0], ..Placement::default() };
        for angle in [quarter.angle, 1.57079632679] {
            let (octant, found) = canonical([1.0, 2.0, 6.0], Placement { angle, ..quarter });
            assert_eq!((octant.exponents, found), ([2.0, 1.0, 6.0], Placement::default()));
        }
        // What is not turned stays as it is, in whatever order its exponents are.
        let (octant, found) = canonical([6.0, 1.0, 2.0], Placement::default());
        assert_eq!((octant.exponents, found), ([6.0, 1.0, 2.0], Placement::default()));
    }

    prop_compose! {
        fn placement()(
            scale in prop::array::uniform3(prop_oneof![0.2..4.0f64, -4.0..-0.2f64, Just(1.0), Just(-1.0), Just(2.0)]),
            axis in prop::array::uniform3(prop_oneof![-1.0..1.0f64, Just(0.0), Just(1.0)]),
            angle in prop_oneof![-3.1..3.1f64, (-4i32..4).prop_map(|eighth| f64::from(eighth) * std::f64::consts::FRAC_PI_4)],
        ) -> Placement {
            let axis = if axis == [0.0; 3] { [0.0, 0.0, 1.0] } else { axis };
            Placement { scale, axis, angle, ..Placement::default() }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn every_description_of_an_octant_has_one_form(
            given in placement(), exponents in prop::array::uniform3(prop::sample::select(vec![0.5, 1.0, 2.0, 7.5])), order in prop::sample::select(ORDERS.to_vec()),
        ) {
            let once = canonical(exponents, given);
            let again = canonical(once.0.exponents, once.1);
            prop_assert_eq!(&again, &once, "not its own canonical form");
            let directions = given.directions().unwrap();
            let matrix = given.matrix();
            // Every edge is one of those that were given, with its exponent.
            let found = once.1.matrix();
            for (axis, exponent) in once.0.exponents.into_iter().enumerate() {
                let is_given = |other: usize| {
                    let is_there = (0..3).all(|row| (found[row][axis] - matrix[row][other]).abs() < 1e-9);
                    is_there && exponents[other] == exponent
                };
                prop_assert!((0..3).any(is_given), "{:?}\n{:?}", given, once);
            }
            // The same edges in another order, as a placement of its own.
            let lengths = order.map(|axis| given.scale[axis].abs());
            let other = Placement::along(order.map(|axis| directions[axis]), lengths, given.shift, given.digits());
            let (octant, place) = canonical(order.map(|axis| exponents[axis]), other);
            prop_assert_eq!(octant.exponents, once.0.exponents);
            prop_assert_eq!(place.scale, once.1.scale);
            let (one, other) = (place.matrix(), once.1.matrix());
            for (one, other) in one.iter().flatten().zip(other.iter().flatten()) {
                prop_assert!((one - other).abs() < 1e-9, "{:?}\n{:?}", place, once.1);
            }
        }
    }
}
