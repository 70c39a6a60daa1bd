//! What there is to know of a pot of rings beside its fields.

use std::borrow::Cow;

use super::pot::{Rings, Series, Slopes};
use super::spelling;
use crate::design::boundary_value::BoundaryValue;
#[cfg(feature = "typescript")]
use crate::design::declarations::interface;
use crate::design::described::{Described, Spelling};
use crate::design::handles::{Handle, HandleId, Handles, Restraint, steps};
use crate::design::number::rounded;
#[cfg(feature = "typescript")]
use crate::design::tables::{HOOP, RINGS_KIND, SERIES, SLOPES, WAVE};
use crate::error::{Code, Error, Result};

// All that leads here is compiled where it is called, for size: see `Design::from_value`.
impl Described for Rings {
    const SPELLING: Option<Spelling> = Some(Spelling { names: spelling::NAMES, read: spelling::read });

    #[inline]
    fn problem(&self) -> Option<Cow<'_, BoundaryValue>> {
        Some(Cow::Owned(self.boundary_value()))
    }

    /// Numbers rounded, waves in ascending `n`, each `n` once, nothing that is 0.
    #[inline]
    fn canonical(mut self) -> Result<Self> {
        self.a = rounded(self.a);
        let last = self.rings.len().saturating_sub(1);
        for (index, hoop) in self.rings.iter_mut().enumerate() {
            hoop.u = rounded(hoop.u);
            hoop.sharp &= index != 0 && index != last;
            hoop.r.canonical();
            hoop.z.canonical();
        }
        for slopes in [&mut self.foot, &mut self.rim].into_iter().flatten() {
            slopes.r.canonical();
            slopes.z.canonical();
        }
        // Rounding may put a ring on its neighbour, and waves of the same n may add up to more than a number holds.
        self.finite()
    }

    #[inline]
    fn cost(&self) -> usize {
        let [r, z] = self.harmonics();
        // A wave of the radius is two of x and two of y, of which neighbours share some.
        2 * (2 * r.len() + 1) + z.len() + 1
    }

    #[inline]
    fn waves(&self) -> Vec<(String, f64)> {
        let hoops = self.rings.iter().enumerate().map(|(index, hoop)| (format!("rings[{index}]"), &hoop.r, &hoop.z));
        let ends = [("foot", &self.foot), ("rim", &self.rim)].into_iter();
        let ends =
            ends.filter_map(|(name, slopes)| slopes.as_ref().map(|slopes| (name.to_owned(), &slopes.r, &slopes.z)));
        let series = hoops.chain(ends).flat_map(|(name, r, z)| [(format!("{name}.r"), r), (format!("{name}.z"), z)]);
        let waves =
            series.flat_map(|(name, series)| series.waves.iter().enumerate().map(move |wave| (name.clone(), wave)));
        waves.map(|(name, (index, wave))| (format!("{name}.waves[{index}].n"), wave.n)).collect()
    }

    #[inline]
    fn link(&self) -> Option<Vec<String>> {
        Some(spelling::write(self))
    }

    #[inline]
    fn handles(&self) -> Handles {
        let last = self.rings.len().saturating_sub(1);
        let point = |id, index: usize| {
            let [r, z] = ["r", "z"].map(|name| format!("rings[{index}].{name}.mean"));
            Handle::new(id, steps([(&r, 1.0)]), steps([(&z, 1.0)]))
        };
        let slope = |id, name: &str, slopes: &Option<Slopes>| match slopes {
            Some(_) => {
                let [r, z] = ["r", "z"].map(|axis| format!("{name}.{axis}.mean"));
                Handle::new(id, steps([(&r, 1.0)]), steps([(&z, 1.0)]))
            }
            None => Handle::new(id, Vec::new(), Vec::new()).held([Restraint::FreeEnd]),
        };
        Handles::new(
            false,
            [
                point(HandleId::Rim, last),
                slope(HandleId::RimSlope, "rim", &self.rim),
                slope(HandleId::FootSlope, "foot", &self.foot),
                point(HandleId::Foot, 0),
            ],
        )
    }

    /// Refuses rings that do not lead from the foot to the rim, and numbers whose products and sums leave the range of numbers.
    #[inline]
    fn finite(self) -> Result<Self> {
        self.lead_from_foot_to_rim().map_err(|error| error.inside_field("rings"))?;
        let square = self.a * self.a;
        let mut sizes = self.series().map(Series::size).chain([2.0 * square, square * square]);
        let is_finite = sizes.all(f64::is_finite);
        drop(sizes);
        match is_finite {
            true => Ok(self),
            false => {
                let message = "these numbers are so large that their products cannot be computed";
                Err(Error::new(Code::Overflow, "", message))
            }
        }
    }

    #[cfg(feature = "typescript")]
    fn typescript(_: &str, text: &mut String) {
        interface(text, "Rings", "A pot through any number of rings, each a radius and a height.", RINGS_KIND);
        interface(text, "Hoop", "One ring of a pot.", HOOP);
        interface(text, "Slopes", "Derivatives in u of radius and height at an end.", SLOPES);
        interface(text, "Series", "A mean with waves round the axis.", SERIES);
        interface(text, "Wave", "One harmonic of a series.", WAVE);
    }
}
