//! Closed triangles that are mended: an edge is collapsed into one of its ends, or flipped to the other diagonal. No point is moved.

use glam::DVec3;

use crate::mesh::height;

/// What is lower than this share of the largest coordinate is narrow: eight steps of single precision.
const LEAST: f64 = 8.0 * f32::EPSILON as f64;

/// No edge is collapsed that is longer than so many times the least height.
const REACH: f64 = 8.0;

/// Nor does the surface go further than so many times that height anywhere, all steps together.
const MOST_DRIFT: f64 = 16.0;

/// Of more triangles round a vertex each step would take as long.
const MOST_ROUND: usize = 512;

/// Triangles, and what is known of them.
pub(super) struct Net<'a> {
    pub(super) points: &'a [[f32; 3]],
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) labels: Vec<u32>,
    pub(super) is_gone: Vec<bool>,
    /// How far the points of each triangle have been moved at most.
    drift: Vec<f64>,
    /// The triangles round each vertex.
    round: Vec<Vec<u32>>,
    pub(super) least: f64,
}

/// Triangles instead of others.
pub(super) struct Step {
    pub(super) gone: Vec<u32>,
    pub(super) made: Vec<([u32; 3], u32)>,
    /// How far it moves a point of the surface at most, and how far those of its triangles have been moved then.
    pub(super) length: f64,
    drift: f64,
    pub(super) narrow: Narrow,
}

/// The heights of those of some triangles that are narrow, the least first.
pub(super) struct Narrow(Vec<f64>);

impl Narrow {
    /// Whether the first height in which they differ is higher, or there is none any more.
    pub(super) fn is_better_than(&self, other: &Narrow) -> bool {
        let differ = self.0.iter().zip(&other.0).find(|(own, other)| own != other);
        differ.map_or(self.0.len() < other.0.len(), |(own, other)| own > other)
    }
}

impl<'a> Net<'a> {
    pub(super) fn of(points: &'a [[f32; 3]], triangles: &[[u32; 3]], labels: &[u32]) -> Self {
        let most = points.iter().flatten().fold(0.0f64, |most, x| most.max(f64::from(x.abs())));
        let mut round = vec![Vec::new(); points.len()];
        for (number, corners) in triangles.iter().enumerate() {
            corners.iter().for_each(|corner| round[*corner as usize].push(number as u32));
        }
        let (is_gone, drift) = (vec![false; triangles.len()], vec![0.0; triangles.len()]);
        let (triangles, labels) = (triangles.to_vec(), labels.to_vec());
        Net { points, triangles, labels, is_gone, drift, round, least: LEAST * most }
    }

    pub(super) fn labelled(&self, number: u32) -> ([u32; 3], u32) {
        (self.triangles[number as usize], self.labels[number as usize])
    }

    /// The numbers of the triangles that are left.
    pub(super) fn kept(&self) -> Vec<u32> {
        (0..self.triangles.len() as u32).filter(|number| !self.is_gone[*number as usize]).collect()
    }

    /// How far any step has moved the surface at most, all together.
    pub(super) fn moved(&self) -> f64 {
        self.kept().into_iter().map(|number| self.drift[number as usize]).fold(0.0, f64::max)
    }

    pub(super) fn place(&self, vertex: u32) -> DVec3 {
        DVec3::from_array(self.points[vertex as usize].map(f64::from))
    }

    pub(super) fn normal(&self, corners: [u32; 3]) -> DVec3 {
        let [a, b, c] = corners.map(|vertex| self.place(vertex));
        (b - a).cross(c - a)
    }

    fn height(&self, corners: [u32; 3]) -> f64 {
        let [a, b, c] = corners.map(|vertex| self.place(vertex));
        height(a, b, c)
    }

    pub(super) fn is_low(&self, corners: [u32; 3]) -> bool {
        !(self.height(corners) >= self.least)
    }

    pub(super) fn narrow(&self, triangles: impl Iterator<Item = [u32; 3]>) -> Narrow {
        let low = triangles.filter(|corners| self.is_low(*corners));
        let mut heights: Vec<f64> = low.map(|corners| self.height(corners)).collect();
        heights.sort_by(f64::total_cmp);
        Narrow(heights)
    }

    pub(super) fn is_narrow(&self, number: u32) -> bool {
        self.is_low(self.triangles[number as usize])
    }

    pub(super) fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let corners = self.round[vertex as usize].iter().flat_map(|of| self.triangles[*of as usize]);
        let mut all: Vec<u32> = corners.filter(|of| *of != vertex).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The other triangle of an edge.
    pub(super) fn across(&self, number: u32, [a, b]: [u32; 2]) -> Option<u32> {
        let is_other = |of: &u32| *of != number && self.triangles[*of as usize].contains(&b);
        self.round[a as usize].iter().copied().find(is_other)
    }

    pub(super) fn collapsed(&self, from: u32, to: u32) -> Option<Step> {
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

    pub(super) fn flipped(&self, number: u32, [a, b, c]: [u32; 3]) -> Option<Step> {
        let other = self.across(number, [a, b])?;
        let corners = self.triangles[other as usize];
        let d = corners.into_iter().find(|vertex| *vertex != a && *vertex != b)?;
        let [from, to, apex] = [a, b, c].map(|vertex| self.place(vertex));
        let along = (apex - from).dot(to - from) / (to - from).length_squared();
        // The foot of the third corner is on the edge, which goes there.
        if c == d || self.neighbours(c).binary_search(&d).is_ok() || !(0.0 < along && along < 1.0) {
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
    pub(super) fn step(&self, gone: Vec<u32>, made: Vec<([u32; 3], u32)>, length: f64) -> Option<Step> {
        let narrow = self.narrow(made.iter().map(|(corners, _)| *corners));
        let drift = gone.iter().map(|of| self.drift[*of as usize]).fold(0.0, f64::max) + length;
        (drift <= MOST_DRIFT * self.least).then_some(Step { gone, made, length, drift, narrow })
    }

    pub(super) fn take(&mut self, Step { gone, made, drift, .. }: Step) {
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
