//! Samples of a surface, and which of them is nearest to a point.

use core::f64::consts::TAU;

use glam::DVec3;

use super::skin::Skin;
use crate::watch;

/// The fewest rows and columns.
const LEAST: [usize; 2] = [48, 48];

/// The most samples of one surface.
const MOST: usize = 160_000;

/// Samples are no closer together than this part of the size.
const FINEST: f64 = 2e-3;

/// No more points than this are looked at one by one.
const TOGETHER: usize = 8;

/// Halvings of as many points as there can be, twice over.
const DEEPEST: usize = 64;

/// Samples of a surface at rows and even columns.
#[derive(Debug)]
pub(super) struct Samples {
    /// The rows, from foot to rim.
    pub(super) rows: Vec<f64>,
    pub(super) columns: usize,
    /// Row by row, without a column that repeats the first.
    pub(super) points: Vec<DVec3>,
    /// The outward unit normals there.
    pub(super) normals: Vec<DVec3>,
}

impl Samples {
    /// Samples no further apart than `step`, if that takes no more than there can be.
    pub(super) fn of(skin: &Skin, step: f64) -> Samples {
        let mut step = step.max(FINEST * skin.size());
        loop {
            let (rows, columns) = places(skin, step);
            let n = rows.len() * columns;
            if n <= MOST {
                return Samples::at(skin, rows, columns);
            }
            step *= libm::sqrt(n as f64 / MOST as f64).max(1.05);
        }
    }

    /// Samples at so many even rows and columns.
    pub(super) fn even(skin: &Skin, n_rows: usize, columns: usize) -> Samples {
        Samples::at(skin, (0..n_rows).map(|i| i as f64 / (n_rows - 1) as f64).collect(), columns)
    }

    fn at(skin: &Skin, rows: Vec<f64>, columns: usize) -> Samples {
        let even = skin.columns(columns);
        let n = rows.len() * columns;
        let (mut points, mut normals) = (Vec::with_capacity(n), Vec::with_capacity(n));
        let mut walk = skin.walk();
        for s in rows.iter().take_while(|_| !watch::is_stopped()) {
            for j in 0..columns {
                let jet = walk.jet_at(*s, &even, j);
                points.push(jet.position);
                normals.push(jet.normal);
            }
        }
        points.resize(n, DVec3::ZERO);
        normals.resize(n, DVec3::ZERO);
        Samples { rows, columns, points, normals }
    }

    /// The square of the distance of a point from the triangles next to the sample that is nearest to it, the number of that sample, and whether the point is on the outside there.
    pub(super) fn from(&self, cloud: &Cloud, at: DVec3) -> (f64, usize, bool) {
        let (mut least, number) = cloud.nearest(at);
        let n = self.columns;
        let (i, j) = (number / n, number % n);
        let corner = |i: usize, j: usize| self.points[i * n + j % n];
        for i in i.saturating_sub(1)..(i + 1).min(self.rows.len() - 1) {
            for j in [j, j + n - 1] {
                let [a, b, c, d] = [corner(i, j), corner(i, j + 1), corner(i + 1, j), corner(i + 1, j + 1)];
                least = least.min(to_triangle(at, [a, b, c])).min(to_triangle(at, [d, c, b]));
            }
        }
        (least, number, self.normals[number].dot(at - self.points[number]) > 0.0)
    }

    /// The place of a sample.
    pub(super) fn place(&self, number: usize) -> [f64; 2] {
        [self.rows[number / self.columns], TAU * (number % self.columns) as f64 / self.columns as f64]
    }
}

/// Rows and the number of columns, no further apart than `step`.
fn places(skin: &Skin, step: f64) -> (Vec<f64>, usize) {
    let coarse: Vec<f64> = {
        let even = (0..=LEAST[0]).map(|i| i as f64 / LEAST[0] as f64);
        let corners = skin.stretches().iter().flat_map(|stretch| [stretch.from, stretch.to]);
        let mut all: Vec<f64> = even.chain(corners).collect();
        all.sort_by(f64::total_cmp);
        all.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        all
    };
    let n_columns = skin.round().count().max(LEAST[1]);
    let columns = skin.columns(n_columns);
    let mut walk = skin.walk();
    let (mut rows, mut widest) = (vec![0.0], 0.0f64);
    for pair in coarse.windows(2) {
        let width = pair[1] - pair[0];
        let (mut along, mut round) = (0.0f64, 0.0f64);
        for s in [pair[0], 0.5 * (pair[0] + pair[1]), pair[1]] {
            for j in 0..n_columns {
                let jet = walk.second_at(s, &columns, j);
                along = along.max(jet.du.length());
                round = round.max(jet.dv.length());
            }
        }
        widest = widest.max(round);
        let n = libm::ceil(along * width / step).clamp(1.0, MOST as f64) as usize;
        rows.extend((1..=n).map(|i| pair[0] + width * i as f64 / n as f64));
    }
    let round = libm::ceil(widest * TAU / step).clamp(n_columns as f64, MOST as f64) as usize;
    (rows, round)
}

/// Points in boxes round boxes, halved across the widest side until there are few in one. A node is followed by all that is in it.
#[derive(Debug)]
pub(super) struct Cloud {
    nodes: Vec<Node>,
    points: Vec<Held>,
}

/// A point with its number.
#[derive(Debug, Clone, Copy)]
struct Held {
    point: DVec3,
    number: u32,
}

#[derive(Debug)]
struct Node {
    low: DVec3,
    high: DVec3,
    /// The second half; of a node that has no halves 0.
    second: u32,
    first: u32,
    n: u32,
}

impl Cloud {
    pub(super) fn new(samples: &Samples) -> Cloud {
        let mut points: Vec<Held> =
            samples.points.iter().zip(0..).map(|(point, number)| Held { point: *point, number }).collect();
        let mut nodes = Vec::with_capacity(points.len() / 2 + 1);
        build(&mut nodes, &mut points, 0);
        Cloud { nodes, points }
    }

    /// The square of the distance of the nearest point, and its number.
    pub(super) fn nearest(&self, at: DVec3) -> (f64, usize) {
        let mut best = (f64::INFINITY, 0);
        let mut left = [0usize; DEEPEST];
        let mut n_left = 1usize;
        let mut n_seen = 0;
        while let Some(last) = n_left.checked_sub(1) {
            n_left = last;
            let index = left[last];
            let node = &self.nodes[index];
            n_seen += 1;
            if !(node.distance(at) < best.0) {
                continue;
            }
            if node.second == 0 {
                for held in &self.points[node.first as usize..(node.first + node.n) as usize] {
                    let distance = held.point.distance_squared(at);
                    if distance < best.0 {
                        best = (distance, held.number as usize);
                    }
                }
                continue;
            }
            let of = |half: usize| (half, self.nodes[half].distance(at));
            let mut halves = [of(index + 1), of(node.second as usize)];
            if halves[0].1 < halves[1].1 {
                halves.swap(0, 1);
            }
            for (half, _) in halves.into_iter().filter(|(_, distance)| *distance < best.0) {
                left[n_left] = half;
                n_left += 1;
            }
        }
        watch::work(n_seen);
        best
    }
}

impl Node {
    /// The square of the distance of the box.
    fn distance(&self, at: DVec3) -> f64 {
        at.distance_squared(at.max(self.low).min(self.high))
    }
}

fn build(nodes: &mut Vec<Node>, points: &mut [Held], before: usize) {
    let low = points.iter().fold(DVec3::INFINITY, |low, held| low.min(held.point));
    let high = points.iter().fold(DVec3::NEG_INFINITY, |high, held| high.max(held.point));
    let this = nodes.len();
    nodes.push(Node { low, high, second: 0, first: before as u32, n: points.len() as u32 });
    if points.len() > TOGETHER {
        let axis = (high - low).max_position();
        let half = points.len() / 2;
        points.select_nth_unstable_by(half, |one, other| one.point[axis].total_cmp(&other.point[axis]));
        let (lower, upper) = points.split_at_mut(half);
        build(nodes, lower, before);
        nodes[this].second = nodes.len() as u32;
        build(nodes, upper, before + half);
    }
}

/// The square of the distance of a point from a triangle (C. Ericson, *Real-time collision detection*, 2005, section 5.1.5).
fn to_triangle(at: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let (ab, ac) = (b - a, c - a);
    let from = |q: DVec3| (ab.dot(at - q), ac.dot(at - q));
    let [(d1, d2), (d3, d4), (d5, d6)] = [from(a), from(b), from(c)];
    let [va, vb, vc] = [d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2];
    let nearest = if d1 <= 0.0 && d2 <= 0.0 {
        a
    } else if d3 >= 0.0 && d4 <= d3 {
        b
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        a + ab * (d1 / (d1 - d3))
    } else if d6 >= 0.0 && d5 <= d6 {
        c
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        a + ac * (d2 / (d2 - d6))
    } else if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))
    } else {
        a + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc))
    };
    // A triangle without area has nearer corners than this says, or as near.
    if nearest.is_finite() { at.distance_squared(nearest) } else { f64::INFINITY }
}
