//! Whether the sines of a method see the waves of the sections.
//!
//! What the equation lacks of a wave grows with the fourth power of its number, and `modal` and `collocation` take it at `M` points along `v`. Fewer than two points for a wave see another in its place, slower and as large, so that the
//! sines may carry the inside far beyond the skin. The skin stays as it is: sines vanish there.

use glam::DVec2;

use super::volume::Volume;
use crate::design::{Blend, Method};

/// A wave that too few sines along `v` are there for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unseen {
    /// How often the fastest wave of both sections goes round.
    pub(crate) n: f64,
    /// The terms along `v` that there are.
    pub(crate) terms: u32,
    /// Where the sines carry the inside farthest, of samples,
    pub(crate) at: [f64; 3],
    /// and how far.
    pub(crate) far: f64,
}

/// What the sines carry no farther than this part of the sections' size is left to the residual to tell.
const FAR: f64 = 0.1;

impl Unseen {
    /// The fastest wave of a blend, if its method takes sines and fewer than two along `v` for each of its turns, and these carry the inside far for sections of this size.
    pub(super) fn of(blend: &Blend, volume: &Volume, size: f64) -> Option<Unseen> {
        let [_, terms, _] = blend.terms;
        let n = blend.harmonics().map(|(_, harmonic)| harmonic.n).fold(0.0, f64::max);
        if blend.method() == Method::Exact || 2.0 * n <= f64::from(terms) {
            return None;
        }
        let (at, far) = volume.farthest_added();
        (far > FAR * size).then_some(Unseen { n, terms, at, far })
    }

    /// The fewest terms along `v` that see it.
    pub(crate) fn least(&self) -> f64 {
        2.0 * self.n
    }
}

/// Samples along each parameter: an odd number, so that no even wave is met where it is 0 all over.
const SAMPLES: usize = 13;

impl Volume {
    fn farthest_added(&self) -> ([f64; 3], f64) {
        let at = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
        let [us, vs] = [0, 1].map(|parameter| (0..SAMPLES).map(|i| self.place(parameter, at(i))).collect::<Vec<_>>());
        let mut found = ([0.5; 3], 0.0);
        for k in 0..SAMPLES {
            let layer = self.layer(at(k));
            for (i, along) in us.iter().enumerate() {
                for (j, across) in vs.iter().enumerate() {
                    let far = layer.with_sines(DVec2::ZERO, along, across, [0, 0, 0]).length();
                    if far > found.1 {
                        found = ([at(i), at(j), at(k)], far);
                    }
                }
            }
        }
        found
    }
}
