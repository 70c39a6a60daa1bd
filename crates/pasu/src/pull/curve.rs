//! Which curve of constant `u` a hand takes hold of.

/// A curve is under the hand if it is no further away in `u`.
const NEAR: f64 = 1.0 / 64.0;

/// The number of the nearest of these places, if it is under the hand at `u`, or if there is no room for one more.
pub(super) fn under_hand(places: impl Iterator<Item = f64>, u: f64, has_room: bool) -> Option<usize> {
    let away = places.map(|place| (place - u).abs()).enumerate();
    let (nearest, away) = away.min_by(|one, other| one.1.total_cmp(&other.1))?;
    (away <= NEAR || !has_room).then_some(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_curve_is_taken_if_it_is_near() {
        let places = || [0.0, 0.3, 0.31, 1.0].into_iter();
        assert_eq!(under_hand(places(), 0.307, true), Some(2));
        assert_eq!(under_hand(places(), 0.3, true), Some(1));
        assert_eq!(under_hand(places(), 0.0, true), Some(0));
        assert_eq!(under_hand(places(), 0.6, true), None);
        assert_eq!(under_hand(places(), 0.6, false), Some(2));
    }
}
