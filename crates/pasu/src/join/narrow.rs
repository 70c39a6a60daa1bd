//! Triangles that are too narrow for the numbers of a file are done away with: where surfaces cross at next to no angle, or all but in a corner, a union has some.
//!
//! No point is moved: an edge is collapsed into one of its ends, or flipped to the other diagonal. Whether what is left closes and crosses nowhere is seen by the checks afterwards.

use core::f64::consts::PI;
use std::collections::VecDeque;

use glam::DVec3;

use crate::mesh::height;
use crate::watch;

/// What is lower than this share of the largest coordinate is narrow: eight steps of single precision.
const LEAST: f64 = 8.0 * f32::EPSILON as f64;

/// No edge is collapsed that is longer than so many times the least height.
const REACH: f64 = 8.0;

/// Nor does the surface go further than so many times that height anywhere, all steps together.
const MOST_DRIFT: f64 = 16.0;

/// Of more triangles round a vertex each step would take as long.
const MOST_ROUND: usize = 512;

/// So many steps for each triangle that is narrow at first.
const MOST_STEPS: usize = 8;

/// And so many flips.
const MOST_FLIPS: usize = 64;

/// Angles are more than half a turn by so much at least: of four corners on one circle either edge will do.
const FLAT: f64 = 1e-9;

struct Net<'a> {
    points: &'a [[f32; 3]],
    triangles: Vec<[u32; 3]>,
    labels: Vec<u32>,
    is_gone: Vec<bool>,
    /// How far the points of each triangle have been moved at most.
    drift: Vec<f64>,
    /// The triangles round each vertex.
    round: Vec<Vec<u32>>,
    least: f64,
}

/// Triangles instead of others.
struct Step {
    gone: Vec<u32>,
    made: Vec<([u32; 3], u32)>,
    /// How far it moves a point of the surface at most, and how far those of its triangles have been moved then.
    length: f64,
    drift: f64,
    n_narrow: usize,
}

/// The same triangles and labels without those that are too narrow, as far as they can be spared; `None` where none is narrow.
pub(super) fn without_narrow(
    points: &[[f32; 3]],
    triangles: &[[u32; 3]],
    labels: &[u32],
) -> Option<(Vec<[u32; 3]>, Vec<u32>)> {
    let most = points.iter().flatten().fold(0.0f64, |most, x| most.max(f64::from(x.abs())));
    let (is_gone, drift) = (vec![false; triangles.len()], vec![0.0; triangles.len()]);
    let (triangles, labels) = (triangles.to_vec(), labels.to_vec());
    let mut net = Net { points, triangles, labels, is_gone, drift, round: Vec::new(), least: LEAST * most };
    let mut waiting: VecDeque<u32> = (0..net.triangles.len() as u32).filter(|of| net.is_narrow(*of)).collect();
    if waiting.is_empty() {
        return None;
    }
    let triangles_before = net.triangles.len() as u32;
    net.round = vec![Vec::new(); points.len()];
    for (number, corners) in net.triangles.iter().enumerate() {
        corners.iter().for_each(|corner| net.round[*corner as usize].push(number as u32));
    }
    net.even(waiting.iter().copied().collect());
    waiting.retain(|of| !net.is_gone[*of as usize]);
    let made = triangles_before..net.triangles.len() as u32;
    waiting.extend(made.filter(|of| !net.is_gone[*of as usize] && net.is_narrow(*of)));
    let mut n_left = MOST_STEPS * waiting.len();
    while let Some(number) = waiting.pop_front().filter(|_| n_left > 0 && !watch::is_stopped()) {
        n_left -= 1;
        if net.is_gone[number as usize] || !net.is_narrow(number) {
            continue;
        }
        watch::work(100);
        match net.best(number) {
            Some(step) => {
                let first = net.triangles.len() as u32;
                net.take(step);
                waiting.extend((first..net.triangles.len() as u32).filter(|of| net.is_narrow(*of)));
            }
            // What is round it may still change.
            None => waiting.push_back(number),
        }
    }
    let kept = |number: &usize| !net.is_gone[*number];
    let numbers: Vec<usize> = (0..net.triangles.len()).filter(kept).collect();
    let triangles = numbers.iter().map(|number| net.triangles[*number]).collect();
    Some((triangles, numbers.iter().map(|number| net.labels[*number]).collect()))
}

impl Net<'_> {
    fn place(&self, vertex: u32) -> DVec3 {
        DVec3::from_array(self.points[vertex as usize].map(f64::from))
    }

    fn normal(&self, corners: [u32; 3]) -> DVec3 {
        let [a, b, c] = corners.map(|vertex| self.place(vertex));
        (b - a).cross(c - a)
    }

    fn is_low(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|vertex| self.place(vertex));
        !(height(a, b, c) >= self.least)
    }

    fn is_narrow(&self, number: u32) -> bool {
        self.is_low(self.triangles[number as usize])
    }

    fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let corners = self.round[vertex as usize].iter().flat_map(|of| self.triangles[*of as usize]);
        let mut all: Vec<u32> = corners.filter(|of| *of != vertex).collect();
        all.sort_unstable();
        all.dedup();
        all
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
        if !is_same_face || angle(c) + angle(d) <= PI + FLAT || self.neighbours(c).binary_search(&d).is_ok() {
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

    /// The other triangle of an edge.
    fn across(&self, number: u32, [a, b]: [u32; 2]) -> Option<u32> {
        let is_other = |of: &u32| *of != number && self.triangles[*of as usize].contains(&b);
        self.round[a as usize].iter().copied().find(is_other)
    }

    /// Of all steps that leave fewer narrow triangles than before that which moves least.
    fn best(&self, number: u32) -> Option<Step> {
        let [a, b, c] = self.triangles[number as usize];
        let edges = [[a, b, c], [b, c, a], [c, a, b]];
        let collapses =
            edges.into_iter().flat_map(|[from, to, _]| [self.collapsed(from, to), self.collapsed(to, from)]);
        let flips = edges.into_iter().map(|edge| self.flipped(number, edge));
        let fewer = collapses.chain(flips).flatten().filter(|step| {
            let before = step.gone.iter().filter(|of| self.is_narrow(**of)).count();
            step.n_narrow < before
        });
        fewer.min_by(|one, other| one.length.total_cmp(&other.length))
    }

    fn collapsed(&self, from: u32, to: u32) -> Option<Step> {
        let length = self.place(from).distance(self.place(to));
        let gone = &self.round[from as usize];
        if length > REACH * self.least || gone.len() > MOST_ROUND || self.round[to as usize].len() > MOST_ROUND {
            return None;
        }
        // The ends of an edge that can be collapsed have two neighbours in common.
        let others = self.neighbours(to);
        if self.neighbours(from).iter().filter(|vertex| others.binary_search(vertex).is_ok()).count() != 2 {
            return None;
        }
        let mut made = Vec::with_capacity(gone.len());
        for of in gone {
            let corners = self.triangles[*of as usize];
            if !corners.contains(&to) {
                let moved = corners.map(|vertex| if vertex == from { to } else { vertex });
                if !self.is_low(corners) && !(self.normal(moved).dot(self.normal(corners)) > 0.0) {
                    return None;
                }
                made.push((moved, self.labels[*of as usize]));
            }
        }
        self.step(gone.clone(), made, length)
    }

    fn flipped(&self, number: u32, [a, b, c]: [u32; 3]) -> Option<Step> {
        let other = self.across(number, [a, b])?;
        let corners = self.triangles[other as usize];
        let d = corners.into_iter().find(|vertex| *vertex != a && *vertex != b)?;
        let [from, to, apex] = [a, b, c].map(|vertex| self.place(vertex));
        let along = (apex - from).dot(to - from) / (to - from).length_squared();
        // The foot of the third corner is on the edge, which goes there.
        if self.neighbours(c).binary_search(&d).is_ok() || !(0.0 < along && along < 1.0) {
            return None;
        }
        let length = apex.distance(from + (to - from) * along);
        let normal = self.normal(corners);
        let halves = [[a, d, c], [d, b, c]];
        let is_turned = |half: &[u32; 3]| !(self.normal(*half).dot(normal) > 0.0);
        if length > self.least || !self.is_low(corners) && halves.iter().any(is_turned) {
            return None;
        }
        let label = self.labels[other as usize];
        self.step(vec![number, other], halves.map(|half| (half, label)).into(), length)
    }

    /// `None` where the surface would go too far from where it was at first.
    fn step(&self, gone: Vec<u32>, made: Vec<([u32; 3], u32)>, length: f64) -> Option<Step> {
        let n_narrow = made.iter().filter(|(corners, _)| self.is_low(*corners)).count();
        let drift = gone.iter().map(|of| self.drift[*of as usize]).fold(0.0, f64::max) + length;
        (drift <= MOST_DRIFT * self.least).then_some(Step { gone, made, length, drift, n_narrow })
    }

    fn take(&mut self, Step { gone, made, drift, .. }: Step) {
        for number in gone {
            self.is_gone[number as usize] = true;
            for corner in self.triangles[number as usize] {
                self.round[corner as usize].retain(|of| *of != number);
            }
        }
        for (corners, label) in made {
            let number = self.triangles.len() as u32;
            corners.iter().for_each(|corner| self.round[*corner as usize].push(number));
            self.triangles.push(corners);
            self.labels.push(label);
            self.is_gone.push(false);
            self.drift.push(drift);
        }
    }
}

#[cfg(test)]
mod tests {
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
            let labels = vec![0; triangles.len()];
            let (found, kept) = without_narrow(&points, &triangles, &labels).unwrap();
            assert_eq!(found.len(), kept.len());
            assert!(check::closed(&found, points.len()).is_ok(), "{n}");
            assert_eq!(without_narrow(&points, &found, &kept).map(|_| ()), None, "{n}: {found:?}");
            assert!((volume(&points, &found) - volume(&points, &triangles)).abs() < 1e-5);
        }
    }

    #[test]
    fn what_has_nothing_narrow_stays() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(without_narrow(&points, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], &[0; 4]), None);
    }
}
