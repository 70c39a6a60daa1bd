//! The largest ball that touches a point on one side and holds no other: boxes round boxes of points, of which hardly any is looked into.

use glam::DVec3;

use super::boxes::{Boxes, DEEPEST, Inside, Node};
use crate::watch;

/// Points nearer to each other than this part of the size of all are one place: what is between them is rounding, which would stop a ball of no size. How a surface bends there is known from its derivatives.
const SAME: f64 = 1e-7;

/// Points that may stop a ball.
#[derive(Debug)]
pub(super) struct Crowd {
    boxes: Boxes<DVec3>,
    /// The square of how far away a point has to be to count.
    same: f64,
}

impl Crowd {
    pub(super) fn new(points: Vec<DVec3>) -> Crowd {
        let boxes = Boxes::new(points);
        let whole = boxes.node(0);
        // Of no points at all there is no size.
        let size = (whole.high - whole.low).max(DVec3::ZERO).length();
        Crowd { boxes, same: SAME * SAME * size * size }
    }

    /// The radius of the largest ball, up to `most`, that touches `at`, lies on the side of it that `inward` points to, and holds none of the points `Q`: the least of `|Q - P|^2 / (2 N . (Q - P))` over those on that side
    /// that are not at the same place.
    ///
    /// `touched` is the point that stopped the ball at a neighbour, and then that which did here: mostly it is near, and few others have to be looked at.
    pub(super) fn ball(&self, at: DVec3, inward: DVec3, most: f64, touched: &mut Option<DVec3>) -> f64 {
        let mut radius = most;
        let shrink = |point: DVec3, radius: &mut f64| {
            let across = point - at;
            let (depth, square) = (inward.dot(across), across.length_squared());
            // Most points are outside of the ball, which is seen without dividing.
            let is_inside = square < 2.0 * depth * *radius && square > self.same;
            if is_inside {
                *radius = square / (2.0 * depth);
            }
            is_inside
        };
        if let Some(point) = *touched {
            shrink(point, &mut radius);
        }
        let mut n_seen = 0;
        let mut left = [0; DEEPEST];
        let mut n_left = 1usize;
        while let Some(last) = n_left.checked_sub(1) {
            n_left = last;
            let index: usize = left[last];
            n_seen += 1;
            // The ball may have shrunk since the node was put aside.
            if !(power(self.boxes.node(index), at, inward, radius) < 0.0) {
                continue;
            }
            let halves = match self.boxes.inside(index) {
                Inside::Halves(halves) => halves,
                Inside::Things(points) => {
                    n_seen += points.len() as u64;
                    for point in points {
                        if shrink(*point, &mut radius) {
                            *touched = Some(*point);
                        }
                    }
                    continue;
                }
            };
            // The half that is further inside shrinks the ball by more.
            let mut halves = halves.map(|half| (half, power(self.boxes.node(half), at, inward, radius)));
            if halves[0].1 < halves[1].1 {
                halves.swap(0, 1);
            }
            for (half, _) in halves.into_iter().filter(|(_, power)| *power < 0.0) {
                left[n_left] = half;
                n_left += 1;
            }
        }
        watch::work(n_seen);
        radius
    }
}

/// Negative where the box reaches into the ball: the least of `|Q - P|^2 - 2 r N . (Q - P)` in it, axis by axis, which keeps its digits where the ball is much larger than all boxes.
fn power(node: &Node, at: DVec3, inward: DVec3, radius: f64) -> f64 {
    let middle = inward * radius;
    let nearest = middle.max(node.low - at).min(node.high - at);
    nearest.dot(nearest - 2.0 * middle)
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;
    use core::f64::consts::TAU;
    use core::ops::ControlFlow;
    use std::rc::Rc;

    use super::*;

    /// Of each point the ball on the side of a direction, sought one by one among those that are further away than this.
    fn plain(points: &[DVec3], at: DVec3, inward: DVec3, most: f64, same: f64) -> f64 {
        let across = points.iter().map(|point| *point - at).filter(|across| inward.dot(*across) > 0.0);
        let across = across.filter(|across| across.length() > same);
        across.map(|across| across.length_squared() / (2.0 * inward.dot(across))).fold(most, f64::min)
    }

    #[test]
    fn the_place_itself_but_for_rounding_stops_no_ball() {
        let [at, across] = [DVec3::new(0.1, 0.2, 0.3), DVec3::new(0.3, 0.2, 0.3)];
        let twin = DVec3::new(0.1 + 1e-16, 0.2, 0.3 + 1e-16);
        assert!(twin != at);
        let ball = |points: &[DVec3]| Crowd::new(points.to_vec()).ball(at, DVec3::X, 9.0, &mut None);
        assert_eq!(ball(&[across, twin]), ball(&[across]));
        assert!((ball(&[across]) - 0.1).abs() < 1e-15);
        assert_eq!([ball(&[at, at]), ball(&[])], [9.0; 2]);
    }

    /// Points of a shell, of a line, in one place, and all over a cube.
    fn crowds() -> Vec<Vec<DVec3>> {
        let share = |i: usize, factor: f64| i as f64 * factor % 1.0;
        let shell = |i: usize| {
            let (turn, z) = (TAU * share(i, 0.618_034), 2.0 * share(i, 0.37) - 1.0);
            let width = (1.0 - z * z).sqrt();
            DVec3::new(width * turn.cos(), width * turn.sin(), 3.0 * z)
        };
        vec![
            (0..2000).map(shell).collect(),
            (0..300).map(|i| DVec3::X * i as f64).collect(),
            vec![DVec3::ONE; 40],
            (0..999).map(|i| DVec3::new(share(i, 0.37), share(i, 0.71), share(i, 0.13))).collect(),
            vec![DVec3::ZERO],
            Vec::new(),
        ]
    }

    #[test]
    fn the_ball_is_that_of_looking_at_every_point() {
        for points in crowds() {
            let crowd = Crowd::new(points.clone());
            let mut touched = None;
            for (i, at) in points.iter().chain(&[DVec3::new(0.1, 0.2, 0.3), DVec3::splat(-5.0)]).enumerate().step_by(3)
            {
                let inward = DVec3::new(i as f64 % 3.0 - 1.0, i as f64 % 7.0 - 3.0, 0.5).normalize();
                for most in [1e-6, 0.3, 2.0, 1e9, 1e200] {
                    let (found, expected) =
                        (crowd.ball(*at, inward, most, &mut touched), plain(&points, *at, inward, most, 1e-9));
                    assert!((found - expected).abs() <= 1e-12 * expected, "{found} {expected}");
                }
            }
        }
    }

    #[test]
    fn hardly_any_point_is_looked_at() {
        // Of a wall nearly as thick as a pot is wide, and of one that is a thousand times as thick: each of 2000 points would take as many looks, which a watcher hears of 30 times; there are some 400.
        let points = crowds().swap_remove(0);
        for most in [1.0, 1e3] {
            let told = Rc::new(Cell::new(0));
            let count = Rc::clone(&told);
            let progress = move |_| {
                count.set(count.get() + 1);
                ControlFlow::Continue(())
            };
            let sought = crate::watched(progress, || {
                let crowd = Crowd::new(points.clone());
                let mut touched = None;
                for at in &points {
                    let normal = DVec3::new(at.x, at.y, at.z / 9.0).normalize();
                    crowd.ball(*at, -normal, most, &mut touched);
                }
                Ok(())
            });
            assert!(sought.is_ok() && told.get() <= 12, "{most}: told {} times", told.get());
        }
    }
}
