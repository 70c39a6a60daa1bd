//! The strip of paper whose upper edge is the rim, unrolled.

use glam::{DVec2, DVec3};

use super::frame::Frame;

/// A strip in the plane, `y` upwards: the same number of points along its upper and its lower edge, the last where the first is when it is laid round the pot.
pub(super) struct Strip {
    pub(super) upper: Vec<DVec2>,
    pub(super) lower: Vec<DVec2>,
}

/// The strip between two closed curves, each point of one joined to that of the other by a straight line: flattened triangle by triangle, so that every length along an edge, and every straight line across, is that on the pot.
/// Under an upright rim it is straight; where the body is narrower or wider than its rim it is bent, as the mantle of a cone is. It lies so that its ends are equally high, and begins at `x = 0`.
///
/// No two joined points are the same.
pub(super) fn between(rim: &[DVec3], hem: &[DVec3]) -> Strip {
    let n = rim.len();
    let (mut upper, mut lower) = (Vec::with_capacity(n + 1), Vec::with_capacity(n + 1));
    upper.push(DVec2::ZERO);
    lower.push(DVec2::new(0.0, -(hem[0] - rim[0]).length()));
    for i in 0..n {
        let (here, next) = ((rim[i], hem[i]), (rim[(i + 1) % n], hem[(i + 1) % n]));
        let along = beside(upper[i], lower[i], (next.0 - here.0).length(), (next.0 - here.1).length());
        upper.push(along);
        lower.push(beside(along, lower[i], (next.1 - next.0).length(), (next.1 - here.1).length()));
    }
    // Turned until the chords of both edges together are level.
    let chord = (upper[n] - upper[0]) + (lower[n] - lower[0]);
    let turn = chord.try_normalize().unwrap_or(DVec2::X);
    let back = DVec2::new(turn.x, -turn.y);
    for point in upper.iter_mut().chain(lower.iter_mut()) {
        *point = back.rotate(*point);
    }
    Strip { upper, lower }
}

/// The straight strip of a rim under which there is no wall to lay one round: its length is that of the rim as seen from above, `depth` is added below.
pub(super) fn straight(rim: &[DVec3], frame: &Frame, depth: f64) -> Strip {
    let n = rim.len();
    let heights: Vec<f64> = (0..=n).map(|i| frame.height(rim[i % n])).collect();
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let mut along = 0.0;
    let (mut upper, mut lower) = (Vec::with_capacity(n + 1), Vec::with_capacity(n + 1));
    for (i, height) in heights.into_iter().enumerate() {
        if i > 0 {
            along += (frame.above(rim[i % n]) - frame.above(rim[i - 1])).length();
        }
        upper.push(DVec2::new(along, height - low));
        lower.push(DVec2::new(along, -depth));
    }
    Strip { upper, lower }
}

/// The length of the smooth closed curve through points that are evenly apart in its parameter, an even number of them: the chords between neighbours are too short by a quarter of what those between every other one are.
pub(super) fn length(points: &[DVec3]) -> f64 {
    let chords = |step: usize| -> f64 {
        let next = points.iter().cycle().skip(step);
        points.iter().zip(next).step_by(step).map(|(here, next)| (next - here).length()).sum()
    };
    let [fine, coarse] = [1, 2].map(chords);
    fine + (fine - coarse) / 3.0
}

/// The point at these distances from two points, one of each edge, on the side to which the strip goes on.
fn beside(upper: DVec2, lower: DVec2, from_upper: f64, from_lower: f64) -> DVec2 {
    let side = lower - upper;
    let length = side.length();
    let down = side / length;
    let part = (from_upper * from_upper - from_lower * from_lower + length * length) / (2.0 * length);
    let out = libm::sqrt((from_upper * from_upper - part * part).max(0.0));
    // To the right where down is down.
    upper + part * down + out * DVec2::new(-down.y, down.x)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    const N: usize = 720;

    fn ring(radius: f64, height: impl Fn(f64) -> f64) -> Vec<DVec3> {
        let at = |v: f64| DVec3::new(radius * libm::cos(v), radius * libm::sin(v), height(v));
        (0..N).map(|i| at(TAU * i as f64 / N as f64)).collect()
    }

    #[test]
    fn a_strip_round_a_cylinder_is_straight() {
        let wave = |v: f64| 5.0 * libm::sin(2.0 * v);
        let Strip { upper, lower } = between(&ring(30.0, wave), &ring(30.0, |_| -20.0));
        let chord = 2.0 * 30.0 * libm::sin(TAU / 2.0 / N as f64);
        for i in 0..=N {
            let (along, height) = (chord * i as f64, wave(TAU * i as f64 / N as f64));
            assert!((upper[i] - DVec2::new(along, height)).length() < 1e-8, "{i} {}", upper[i]);
            assert!((lower[i] - DVec2::new(along, -20.0)).length() < 1e-8, "{i} {}", lower[i]);
        }
    }

    #[test]
    fn a_strip_round_a_cone_is_part_of_a_ring() {
        // The mantle of a cone: its slant heights are the radii, and its edges as long as the circles.
        for (rim, hem) in [(60.0, 45.0), (45.0, 60.0), (50.0, 10.0)] {
            let slant = libm::hypot(rim - hem, 20.0);
            let (outer, inner) = (slant * rim / (rim - hem), slant * hem / (rim - hem));
            let edges = [ring(rim, |_| 0.0), ring(hem, |_| -20.0)];
            let Strip { upper, lower } = between(&edges[0], &edges[1]);
            // The apex lies on the first line across, beyond the narrower edge.
            let apex = upper[0] + (lower[0] - upper[0]) / slant * outer;
            for (edge, radius) in [(&upper, outer), (&lower, inner)] {
                for point in edge {
                    assert!(((*point - apex).length() - f64::abs(radius)).abs() < 1e-6, "{rim} {hem} {point}");
                }
            }
            for (edge, radius) in edges.iter().zip([rim, hem]) {
                assert!((length(edge) - TAU * radius).abs() < 1e-6, "{radius} {}", length(edge));
            }
            assert!((upper[0].y - upper[N].y).abs() < 1e-6, "the ends are equally high");
        }
    }

    #[test]
    fn both_ends_of_a_strip_meet() {
        let rim = ring(40.0, |v| 4.0 * libm::cos(v) + libm::sin(3.0 * v));
        let Strip { upper, lower } = between(&rim, &ring(33.0, |_| -25.0));
        let ends = [0, N].map(|i| (upper[i] - lower[i]).length());
        assert!((ends[0] - ends[1]).abs() < 1e-9, "{ends:?}");
    }
}
