//! How a pot of rings answers to its numbers: its surface is linear in them.

use crate::design::{Hoop, Rings, Series, Slopes, Wave};
use crate::error::Result;
use crate::surface::Surface;

/// A place of rings along the profile, and whether it is a corner.
pub(super) type Place = (f64, bool);

/// The curves along the profile of which a pot with rings at some places is made: one for the value on each ring, then one for the slope at the foot and one at the rim.
pub(super) struct Curves {
    mean: Vec<Surface>,
    /// Of the wave `cos v`; empty where a pot is round.
    wave: Vec<Surface>,
}

/// What one number of the mean, or of the wave, moves at one place of the profile.
#[derive(Debug, Clone, Copy)]
pub(super) struct Answer {
    /// `x` where `v = 0`, by a radius.
    pub(super) r: f64,
    /// `z` where `v = 0`, by a height.
    pub(super) z: f64,
}

impl Curves {
    pub(super) fn of(a: f64, places: &[Place], is_round: bool) -> Result<Curves> {
        let n = places.len() + 2;
        let unit = |index: usize, series: fn(f64) -> Series| {
            let numbers: Vec<f64> = (0..n).map(|other| if other == index { 1.0 } else { 0.0 }).collect();
            let pot = pot(a, places, &|number| series(numbers[number]), &|number| series(numbers[number]));
            Surface::solve(&pot.boundary_value(), "")
        };
        let mean = (0..n).map(|index| unit(index, plain)).collect::<Result<_>>()?;
        let wave =
            if is_round { Vec::new() } else { (0..n).map(|index| unit(index, one_wave)).collect::<Result<_>>()? };
        Ok(Curves { mean, wave })
    }

    /// Value and slope of the answers at a place, the means first.
    pub(super) fn at(&self, u: f64) -> Vec<[Answer; 2]> {
        let all = self.mean.iter().chain(&self.wave);
        let answer = |surface: &Surface| {
            let jet = surface.at(u, 0.0);
            [jet.position, jet.du].map(|point| Answer { r: point.x, z: point.z })
        };
        all.map(answer).collect()
    }
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
