//! Triangles that are too narrow for the numbers of a file are done away with: where surfaces cross at next to no angle, or all but in a corner, a union has some.
//!
//! No point is moved: an edge is collapsed into one of its ends, or flipped to the other diagonal. Whether what is left closes and crosses nowhere is seen by the checks afterwards.

use core::f64::consts::PI;
use std::collections::VecDeque;

use super::net::{Net, Step};
use crate::watch;

/// So many steps for each triangle that is narrow at first.
const MOST_STEPS: usize = 8;

/// And so many flips.
const MOST_FLIPS: usize = 64;

/// Angles are more than half a turn by so much at least: of four corners on one circle either edge will do.
const FLAT: f64 = 1e-9;

impl Net<'_> {
    /// Does away with triangles that are too narrow, as far as they can be spared; whether any was.
    pub(super) fn widen(&mut self) -> bool {
        let mut waiting: VecDeque<u32> = self.kept().into_iter().filter(|of| self.is_narrow(*of)).collect();
        if waiting.is_empty() {
            return false;
        }
        let first = self.triangles.len() as u32;
        self.even(waiting.iter().copied().collect());
        waiting.retain(|of| !self.is_gone[*of as usize]);
        let made = first..self.triangles.len() as u32;
        waiting.extend(made.filter(|of| !self.is_gone[*of as usize] && self.is_narrow(*of)));
        let mut n_left = MOST_STEPS * waiting.len();
        while let Some(number) = waiting.pop_front().filter(|_| n_left > 0 && !watch::is_stopped()) {
            n_left -= 1;
            if self.is_gone[number as usize] || !self.is_narrow(number) {
                continue;
            }
            watch::work(100);
            match self.best(number) {
                Some(step) => {
                    let first = self.triangles.len() as u32;
                    self.take(step);
                    waiting.extend((first..self.triangles.len() as u32).filter(|of| self.is_narrow(*of)));
                }
                // What is round it may still change.
                None => waiting.push_back(number),
            }
        }
        true
    }

    /// Flips edges between triangles that lie in one plane until no corner is within the circle round another triangle (C. L. Lawson, 1977), beginning with these: in a plane a union has fans of triangles that are as narrow as their rim is straight.
    fn even(&mut self, mut waiting: VecDeque<u32>) {
        let mut n_left = MOST_FLIPS * waiting.len();
        while let Some(number) = waiting.pop_front().filter(|_| n_left > 0 && !watch::is_stopped()) {
            if self.is_gone[number as usize] {
                continue;
            }
            watch::work(100);
            let [a, b, c] = self.triangles[number as usize];
            let evener = [[a, b, c], [b, c, a], [c, a, b]].into_iter().find_map(|edge| self.evener(number, edge));
            if let Some(step) = evener {
                n_left -= 1;
                let first = self.triangles.len() as u32;
                self.take(step);
                waiting.extend(first..self.triangles.len() as u32);
            }
        }
    }

    /// The flip of an edge, where it is one of two triangles of one face and one plane whose angles across from it are more than half a turn together.
    fn evener(&self, number: u32, [a, b, c]: [u32; 3]) -> Option<Step> {
        let other = self.across(number, [a, b])?;
        let corners = self.triangles[other as usize];
        let d = corners.into_iter().find(|vertex| *vertex != a && *vertex != b)?;
        let label = self.labels[number as usize];
        let angle = |at: u32| {
            let [one, other] = [a, b].map(|end| self.place(end) - self.place(at));
            libm::atan2(one.cross(other).length(), one.dot(other))
        };
        let is_same_face = label == self.labels[other as usize];
        if !is_same_face || c == d || angle(c) + angle(d) <= PI + FLAT || self.neighbours(c).binary_search(&d).is_ok() {
            return None;
        }
        let normal = (self.normal([a, b, c]) + self.normal(corners)).try_normalize()?;
        let height = |vertex: u32| (self.place(vertex) - self.place(a)).dot(normal).abs();
        let highest = [b, c, d].map(height).into_iter().fold(0.0, f64::max);
        let halves = [[a, d, c], [d, b, c]];
        let is_turned = |half: &[u32; 3]| !(self.normal(*half).dot(normal) > 0.0);
        if highest > self.least || halves.iter().any(is_turned) {
            return None;
        }
        // Both ways of dividing the four lie within that height on either side of the plane.
        self.step(vec![number, other], halves.map(|half| (half, label)).into(), 2.0 * highest)
    }

    /// Of all steps whose triangles are less narrow than those before that which moves least.
    fn best(&self, number: u32) -> Option<Step> {
        let [a, b, c] = self.triangles[number as usize];
        let edges = [[a, b, c], [b, c, a], [c, a, b]];
        let collapses =
            edges.into_iter().flat_map(|[from, to, _]| [self.collapsed(from, to), self.collapsed(to, from)]);
        let flips = edges.into_iter().map(|edge| self.flipped(number, edge));
        let better = collapses.chain(flips).flatten().filter(|step| {
            let before = self.narrow(step.gone.iter().map(|of| self.triangles[*of as usize]));
            step.narrow.is_better_than(&before)
        });
        better.min_by(|one, other| one.length.total_cmp(&other.length))
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::check;

    /// A flat lid over a base point, closed: a hub, and a rim across from it that is as straight as a file can hold.
    fn fan(n: u32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let rim = (0..=n)
            .map(|k| [1.0 + k as f32 / n as f32, if k == 0 { 0.0 } else { 1e-7 * (k * k) as f32 / n as f32 }, 1.0]);
        let points: Vec<[f32; 3]> =
            [[0.0, 0.0, 1.0], [1.5, 0.5, 0.0], [1.5, 4.0, 1.0]].into_iter().chain(rim).collect();
        let mut triangles = vec![];
        for k in 3..3 + n {
            triangles.push([0, k, k + 1]);
            triangles.push([1, k + 1, k]);
        }
        let last = 3 + n;
        triangles.extend([[0, last, 2], [1, 2, last], [1, 3, 0], [1, 0, 2]]);
        (points, triangles)
    }

    fn volume(points: &[[f32; 3]], triangles: &[[u32; 3]]) -> f64 {
        let at = |vertex: u32| DVec3::from_array(points[vertex as usize].map(f64::from));
        triangles.iter().map(|t| at(t[0]).dot(at(t[1]).cross(at(t[2])))).sum::<f64>() / 6.0
    }

    #[test]
    fn a_flat_fan_is_divided_so_that_nothing_of_it_is_narrow() {
        for n in [2, 7, 40] {
            let (points, triangles) = fan(n);
            assert!(check::closed(&triangles, points.len()).is_ok());
            let mut net = Net::of(&points, &triangles, &vec![0; triangles.len()]);
            assert!(net.widen());
            let found: Vec<[u32; 3]> = net.kept().into_iter().map(|of| net.labelled(of).0).collect();
            assert!(check::closed(&found, points.len()).is_ok(), "{n}");
            assert!(!Net::of(&points, &found, &vec![0; found.len()]).widen(), "{n}: {found:?}");
            assert!((volume(&points, &found) - volume(&points, &triangles)).abs() < 1e-5);
        }
    }

    #[test]
    fn what_has_nothing_narrow_stays() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        let mut net = Net::of(&points, &triangles, &[0; 4]);
        assert!(!net.widen() && !net.uncross());
        assert_eq!(net.kept(), [0, 1, 2, 3]);
    }
}
