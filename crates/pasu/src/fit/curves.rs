//! How a pot of rings answers to its numbers: its surface is linear in them.

use std::sync::Arc;

use crate::design::{Hoop, Rings, Series, Slopes, Wave};
use crate::error::Result;
use crate::mode::{Beam, Deflection};
use crate::surface::{Surface, Term};

/// A place of rings along the profile, and whether it is a corner.
pub(super) type Place = (f64, bool);

/// The curves along the profile of which a pot with rings at some places is made: one for the value on each ring, then one for the slope at the foot and one at the rim; of a pot that is not round those of the wave `cos v` follow.
///
/// The surfaces that have one number 1 and the others 0 have the same equations, bay for bay: each of these is asked once for all of them.
pub(super) struct Curves {
    /// Of `x` and of `z` where `v = 0`.
    axes: [Vec<Strand>; 2],
    len: usize,
}

/// One mode of all curves.
struct Strand {
    n: f64,
    beam: Arc<Beam>,
    /// As many as there are curves, and 0 up to a multiple of [`SIDE_BY_SIDE`].
    deflections: Vec<Deflection>,
}

/// So many are evaluated with the same transcendental functions.
const SIDE_BY_SIDE: usize = 8;

/// What every number moves at one place of the profile.
#[derive(Debug, Clone, Default)]
pub(super) struct Answers {
    /// `x` where `v = 0`, by a radius.
    pub(super) r: Vec<f64>,
    /// `z` where `v = 0`, by a height.
    pub(super) z: Vec<f64>,
}

impl Curves {
    pub(super) fn of(a: f64, places: &[Place], is_round: bool) -> Result<Curves> {
        let n = places.len() + 2;
        let unit = |index: usize, series: fn(f64) -> Series| {
            let numbers: Vec<f64> = (0..n).map(|other| if other == index { 1.0 } else { 0.0 }).collect();
            let pot = pot(a, places, &|number| series(numbers[number]), &|number| series(numbers[number]));
            Surface::solve(&pot.boundary_value(), "")
        };
        let kinds: &[fn(f64) -> Series] = if is_round { &[plain] } else { &[plain, one_wave] };
        let len = n * kinds.len();
        let mut axes = [Vec::new(), Vec::new()];
        for (kind, series) in kinds.iter().enumerate() {
            for index in 0..n {
                let surface = unit(index, *series)?;
                let [x, _, z] = surface.components();
                for (strands, terms) in axes.iter_mut().zip([x, z]) {
                    for term in terms {
                        strand(strands, term, len).deflections[kind * n + index] = term.cos.clone();
                    }
                }
            }
        }
        Ok(Curves { axes, len })
    }

    /// The answers at a place, the means first.
    pub(super) fn at(&self, u: f64, into: &mut Answers) {
        for (strands, answers) in self.axes.iter().zip([&mut into.r, &mut into.z]) {
            answers.clear();
            answers.resize(self.len, 0.0);
            for Strand { beam, deflections, .. } in strands {
                for (deflections, answers) in
                    deflections.as_chunks::<SIDE_BY_SIDE>().0.iter().zip(answers.chunks_mut(SIDE_BY_SIDE))
                {
                    let found = beam.jets::<1, SIDE_BY_SIDE>(deflections.each_ref(), u);
                    answers.iter_mut().zip(found).for_each(|(answer, [value])| *answer += value);
                }
            }
        }
    }
}

/// The mode of a term among those that are known.
fn strand<'a>(strands: &'a mut Vec<Strand>, term: &Term, len: usize) -> &'a mut Strand {
    let known = strands.iter().position(|strand| strand.n == term.n);
    let index = known.unwrap_or_else(|| {
        let deflections = vec![Deflection::default(); len.next_multiple_of(SIDE_BY_SIDE)];
        strands.push(Strand { n: term.n, beam: Arc::clone(&term.beam), deflections });
        strands.len() - 1
    });
    &mut strands[index]
}

/// The pot with these numbers: as many as there are places, then the slopes at foot and rim.
pub(super) fn pot(a: f64, places: &[Place], r: &dyn Fn(usize) -> Series, z: &dyn Fn(usize) -> Series) -> Rings {
    let hoop = |(index, &(u, sharp)): (usize, &Place)| Hoop { u, r: r(index), z: z(index), sharp };
    let slopes = |index: usize| Some(Slopes { r: r(index), z: z(index) });
    let rings = places.iter().enumerate().map(hoop).collect();
    Rings { a, rings, foot: slopes(places.len()), rim: slopes(places.len() + 1) }
}

pub(super) fn plain(mean: f64) -> Series {
    Series { mean, waves: Vec::new() }
}

pub(super) fn one_wave(cos: f64) -> Series {
    leaning(0.0, cos)
}

/// A mean, and what one side is wider or higher by.
pub(super) fn leaning(mean: f64, cos: f64) -> Series {
    Series { mean, waves: vec![Wave { n: 1.0, cos, sin: 0.0 }] }
}
