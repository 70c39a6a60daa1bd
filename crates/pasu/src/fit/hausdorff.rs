//! How far one line is from another at most: the directed Hausdorff distance of lines of straight pieces.

use glam::DVec2;

use super::line::{Line, Nearest};

/// A piece is halved until what it may hide is this part of what was found.
const HIDDEN: f64 = 0.01;

/// No place of a line of straight pieces is further from another one than this, which is `least` or more; too much by `close` and a hundredth of it at most.
///
/// What is nearer than was found already is not looked at more closely. The distance from one straight piece is convex along another, so that on a piece it is no larger than at the worse of its ends. A piece from whose ends different pieces are nearest is halved until both tell as much.
pub(super) fn farthest(points: &[DVec2], from: &Line, close: f64, least: f64) -> f64 {
    let Some(first) = points.first() else { return least };
    let mut here = from.nearest(*first, 0, least);
    let mut found = least.max(here.distance);
    let mut bound = found;
    let mut open: Vec<[(DVec2, Nearest); 2]> = Vec::new();
    for pair in points.windows(2) {
        let there = from.nearest(pair[1], here.piece, found);
        open.push([(pair[0], here), (pair[1], there)]);
        here = there;
        while let Some([one, other]) = open.pop() {
            let worse = |(_, near): (DVec2, Nearest), (point, _): (DVec2, Nearest)| {
                near.distance.max(from.distance_of(near.piece, point))
            };
            let most = worse(one, other).min(worse(other, one));
            found = found.max(one.1.distance).max(other.1.distance);
            let middle = one.0.midpoint(other.0);
            // No number is larger than one that is none.
            if !(most > (1.0 + HIDDEN) * found + close) || middle == one.0 || middle == other.0 {
                bound = bound.max(most);
                continue;
            }
            let near = from.nearest(middle, one.1.piece, found);
            open.extend([[one, (middle, near)], [(middle, near), other]]);
        }
    }
    bound
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A zigzag beside a wave, against many places: the largest distance is at a vertex of one, or inside a piece of the other.
    #[test]
    fn it_bounds_what_many_places_find() {
        let zigzag = |i: i32| DVec2::new(2.0 + 0.3 * f64::from(i * 37 % 11), 0.5 * f64::from(i));
        let wavy = |i: i32| DVec2::new(2.5 + (0.21 * f64::from(i)).sin(), 0.1 * f64::from(i));
        let lines = [(0..21).map(zigzag).collect::<Vec<_>>(), (0..101).map(wavy).collect()];
        for [one, other] in [[0, 1], [1, 0], [0, 0]] {
            let to = Line::of(lines[other].iter().copied()).unwrap();
            let place = |pair: &[DVec2], i: i32| pair[0].lerp(pair[1], f64::from(i) / 500.0);
            let places = lines[one].windows(2).flat_map(|pair| (0..=500).map(|i| place(pair, i)));
            let found = places.map(|point| to.nearest(point, 0, 0.0).distance).fold(0.0, f64::max);
            let told = farthest(&lines[one], &to, 1e-6, 0.0);
            assert!(told >= found - 1e-14 && told <= 1.011 * found + 1e-6, "{one} {other}: {told} and {found}");
            let told = farthest(&lines[one], &to, 1e-6, 9.0);
            assert!((9.0..9.1).contains(&told), "{told}");
        }
    }

    /// From the middle of the upper line both ends of the lower one are far, from its own ends neither.
    #[test]
    fn the_farthest_place_may_be_within_a_piece() {
        let lower = Line::of([[-1.0, 0.0], [-0.9, 0.0], [0.0, -5.0], [0.9, 0.0], [1.0, 0.0]].map(DVec2::from)).unwrap();
        let upper = [[-1.0, 0.0], [1.0, 0.0]].map(DVec2::from);
        let told = farthest(&upper, &lower, 1e-9, 0.0);
        let most = 4.5 / (0.9f64 * 0.9 + 25.0).sqrt();
        assert!((most..1.011 * most).contains(&told), "{told} {most}");
    }
}
