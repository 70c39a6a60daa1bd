//! The stretches between the ends and rings of a beam.

use super::ring::Ring;

/// Rings nearer each other than this are refused: a slope, a value over a gap, would have fewer digits than a mesh shows.
pub(crate) const CLOSEST: f64 = 1e-6;

/// Lengths that differ by no more than this differ by the rounding of where rings are.
const SAME: f64 = 2.0 * f64::EPSILON;

/// A beam between each two neighbours among the ends and the rings: the same for every mode of a surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bays {
    pub(super) bays: Vec<Bay>,
    /// The different lengths, in the order of their first use.
    pub(super) lengths: Vec<f64>,
    /// The numbers of the bays that begin at a corner.
    pub(super) corners: Vec<usize>,
}

/// The beam between two neighbours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bay {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) length: f64,
    /// Which of the different lengths that is.
    pub(super) kind: usize,
}

impl Bays {
    /// Between the ends, at 0 and 1, and these rings.
    pub(crate) fn between(rings: &[Ring]) -> Self {
        let places = || rings.iter().map(|ring| ring.u);
        let mut lengths: Vec<f64> = Vec::with_capacity(1);
        let bays = [0.0].into_iter().chain(places()).zip(places().chain([1.0])).map(|(from, to)| {
            let length = to - from;
            // Rings are often evenly spaced.
            let known = lengths.iter().position(|known| (known - length).abs() <= SAME);
            let kind = known.unwrap_or_else(|| {
                lengths.push(length);
                lengths.len() - 1
            });
            Bay { from, to, length, kind }
        });
        let bays = bays.collect();
        let corners = rings.iter().enumerate().filter(|(_, ring)| ring.sharp).map(|(index, _)| index + 1).collect();
        Bays { bays, lengths, corners }
    }

    /// The number of the first bay that is too short.
    pub(super) fn crowded(&self) -> Option<usize> {
        self.bays.iter().position(|bay| !(bay.length >= CLOSEST))
    }

    /// The number of the bay at `u`; at a ring the one behind it.
    pub(super) fn at(&self, u: f64) -> usize {
        self.bays.partition_point(|bay| bay.from <= u).saturating_sub(1)
    }
}

impl Bay {
    /// Where `u` is between its ends, from 0 to 1.
    pub(super) fn within(&self, u: f64) -> f64 {
        self.beyond(u).clamp(0.0, 1.0)
    }

    /// The same for any `u`.
    pub(super) fn beyond(&self, u: f64) -> f64 {
        if u == self.to { 1.0 } else { (u - self.from) / self.length }
    }

    /// Derivatives in `u` from those in what runs from 0 to 1.
    pub(super) fn lengthen<const N: usize>(&self, jet: &mut [f64; N]) {
        let mut power = 1.0;
        for value in jet.iter_mut().skip(1) {
            power *= self.length;
            *value /= power;
        }
    }
}
