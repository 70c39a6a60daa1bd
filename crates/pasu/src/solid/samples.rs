//! Samples of a surface, and which of them is nearest to a point.

use core::f64::consts::TAU;

use glam::DVec3;

use super::boxes::{Bounded, Boxes, DEEPEST, Inside};
use super::skin::Skin;
use crate::numeric::triangle::Triangle;
use crate::watch;

/// The fewest rows and columns.
const LEAST: [usize; 2] = [48, 48];

/// The most samples of one surface.
const MOST: usize = 160_000;

/// Samples are no closer together than this part of the size.
const FINEST: f64 = 2e-3;

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
                for triangle in [[a, b, c], [d, c, b]] {
                    least = least.min(at.distance_squared(Triangle(triangle).nearest(at)));
                }
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

/// Samples among which the nearest is found.
#[derive(Debug)]
pub(super) struct Cloud(Boxes<Held>);

/// A point with its number.
#[derive(Debug, Clone, Copy)]
struct Held {
    point: DVec3,
    number: u32,
}

impl Bounded for Held {
    fn bounds(&self) -> [DVec3; 2] {
        [self.point; 2]
    }
}

impl Cloud {
    pub(super) fn new(samples: &Samples) -> Cloud {
        let held = samples.points.iter().zip(0..).map(|(point, number)| Held { point: *point, number });
        Cloud(Boxes::new(held.collect()))
    }

    /// The square of the distance of the nearest point, and its number.
    pub(super) fn nearest(&self, at: DVec3) -> (f64, usize) {
        let square = |number: usize| {
            let node = self.0.node(number);
            at.distance_squared(at.max(node.low).min(node.high))
        };
        let mut best = (f64::INFINITY, 0);
        let mut left = [0usize; DEEPEST];
        let mut n_left = 1usize;
        let mut n_seen = 0;
        while let Some(last) = n_left.checked_sub(1) {
            n_left = last;
            let index = left[last];
            n_seen += 1;
            if !(square(index) < best.0) {
                continue;
            }
            let halves = match self.0.inside(index) {
                Inside::Halves(halves) => halves,
                Inside::Things(points) => {
                    for held in points {
                        let distance = held.point.distance_squared(at);
                        if distance < best.0 {
                            best = (distance, held.number as usize);
                        }
                    }
                    continue;
                }
            };
            let mut halves = halves.map(|half| (half, square(half)));
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
