//! The place of a convex body that is nearest to the origin, by how far it reaches in directions.

use glam::DVec3;

/// E. G. Gilbert's steps (*An iterative procedure for computing the minimum of a quadratic form on a convex set*, 1966), no more than `most`: from a place of the body each goes to what is nearest on the way to a place that is as far as it reaches towards the origin. How many there were.
///
/// `reached` is asked for such a place: it is given the direction from the origin to where it is, and how far that is, and ends the steps by `None`. They end too where no step brings it nearer.
pub(crate) fn gilbert(from: DVec3, most: usize, mut reached: impl FnMut(DVec3, f64) -> Option<DVec3>) -> u64 {
    let mut way = from;
    for step in 1..=most as u64 {
        let length = way.length();
        let direction = way / length;
        if !direction.is_finite() {
            return step;
        }
        let Some(next) = reached(direction, length) else { return step };
        let along = next - way;
        let share = -way.dot(along) / along.length_squared();
        if !(share > 0.0) {
            return step;
        }
        way += along * share.min(1.0);
    }
    most as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How near to the origin a ball and a tetrahedron are found to be.
    #[test]
    fn the_nearest_place_of_a_ball_and_of_corners_is_found() {
        let middle = DVec3::new(3.0, -2.0, 6.0);
        let mut nearest = f64::INFINITY;
        gilbert(middle + DVec3::X, 200, |direction, length| {
            nearest = nearest.min(length);
            Some(middle - direction)
        });
        assert!((nearest - 6.0).abs() < 1e-9, "{nearest}");
        // The side across from the far corner is a unit from the origin.
        let corners = [[1.0, 4.0, -3.0], [1.0, -4.0, -3.0], [1.0, 0.0, 5.0], [4.0, 0.0, 0.0]].map(DVec3::from_array);
        let mut nearest = f64::INFINITY;
        let n_steps = gilbert(corners[3], 500, |direction, length| {
            nearest = nearest.min(length);
            let towards = |corner: &DVec3| -corner.dot(direction);
            corners.into_iter().max_by(|one, other| towards(one).total_cmp(&towards(other)))
        });
        // To a side it comes nearer ever more slowly, and never beyond.
        assert!((1.0 - 1e-12..1.03).contains(&nearest) && n_steps > 1, "{nearest} {n_steps}");
        // It ends where it is told to, and where there is no way.
        assert_eq!([gilbert(DVec3::X, 9, |_, _| None), gilbert(DVec3::ZERO, 9, |_, _| Some(DVec3::X))], [1, 1]);
    }
}
