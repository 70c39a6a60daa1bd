//! A surface by its place along the profile and the angle round the axis.

use core::f64::consts::TAU;

use super::azimuth::{Azimuth, onwards, outwards};
use crate::surface::Surface;

/// A surface from its foot to its rim.
pub(super) struct Sections<'a> {
    surface: &'a Surface,
    /// Whether its rim is at `u = 0`.
    is_reversed: bool,
    size: f64,
    waves: f64,
}

/// Radius, height and their derivatives along the profile at one angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) r: f64,
    pub(super) z: f64,
    pub(super) r_u: f64,
    pub(super) z_u: f64,
}

impl<'a> Sections<'a> {
    pub(super) fn of(surface: &'a Surface) -> Sections<'a> {
        let [start, end] = [0.0, 1.0].map(|u| surface.at(u, 0.0).position);
        let waves = surface.distinct().iter().fold(1.0f64, |most, n| most.max(n.abs()));
        Sections { surface, is_reversed: end.z < start.z, size: start.abs().max(end.abs()).max_element(), waves }
    }

    /// The largest coordinate of its edges where `v = 0`.
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    /// The most waves of a section.
    pub(super) fn waves(&self) -> f64 {
        self.waves
    }

    /// Places along the profile at which it has corners or rings, in ascending order, and whether it is a corner.
    pub(super) fn stops(&self) -> Vec<(f64, bool)> {
        let mut stops: Vec<(f64, bool)> = self.surface.rings().map(|(u, sharp)| (self.u(u), sharp)).collect();
        stops.sort_by(|one, other| one.0.total_cmp(&other.0));
        stops
    }

    /// The section at a place from 0, the foot, to 1. Nothing where it does not go round the axis once, without turning back.
    pub(super) fn at(&self, at: f64) -> Option<Section<'a>> {
        let azimuth = Azimuth::of(self.surface, self.u(at), self.size, self.waves)?;
        Some(Section { azimuth, is_reversed: self.is_reversed })
    }

    fn u(&self, at: f64) -> f64 {
        if self.is_reversed { 1.0 - at } else { at }
    }
}

/// The curve of one place along the profile.
pub(super) struct Section<'a> {
    azimuth: Azimuth<'a>,
    is_reversed: bool,
}

impl Section<'_> {
    /// At `n` even angles.
    pub(super) fn samples(&self, n: usize) -> Vec<Sample> {
        (0..n).map(|i| self.sample(TAU * i as f64 / n as f64)).collect()
    }

    /// Where it meets the ray at an angle.
    pub(super) fn sample(&self, angle: f64) -> Sample {
        let jet = self.azimuth.at(angle);
        let (out, on, is_pole) = (outwards(angle), onwards(angle), self.azimuth.is_pole());
        // How v has to change with u for the angle to stay; the ways out of a pole have their angles already.
        let turning = if is_pole { 0.0 } else { -on.dot(jet.du.truncate()) / on.dot(jet.dv.truncate()) };
        let along = (jet.du + jet.dv * turning) * if self.is_reversed { -1.0 } else { 1.0 };
        let r = if is_pole { 0.0 } else { out.dot(jet.position.truncate()) };
        Sample { r, z: jet.position.z, r_u: out.dot(along.truncate()), z_u: along.z }
    }
}
