//! A blend with its skin.

use super::outline::{DRAWN_WAVES, Polygon, refuse_broken};
use super::skin::{Skin, flank};
use super::unseen::Unseen;
use super::volume::Volume;
use crate::design::{Blend, Form, plain};
use crate::error::{Code, Error, Result};
use crate::patch::Patch;
use crate::surface::Surface;

/// A solved blend: a solid with what goes round it, or a vessel, of which only what is between the sections is there, to carry a wall.
#[derive(Debug)]
pub(crate) struct Blended {
    volume: Volume,
    border: Border,
    /// Of more waves than are drawn: where they are given, and how many.
    too_fine: Option<(String, f64)>,
    /// The sections as a document gives them.
    blend: Blend,
    /// How wide the wider of the two is.
    size: f64,
}

#[derive(Debug)]
enum Border {
    Solid(Skin),
    Vessel(Box<Surface>),
}

/// Samples along either parameter of a patch by which the sign of the volume is told.
const SAMPLES: usize = 17;

impl Blended {
    /// Solves a blend that stands at `path` of its design; `is_hollow` where it has a wall. A wall goes round between two closed sections; what has others stays a solid, of which making a pot is refused.
    ///
    /// # Errors
    /// As [`Volume::solve`]; `crosses-itself` and `pinched-surface` for sections that bound no area, run through themselves or lie in each other.
    pub(crate) fn solve(blend: &Blend, is_hollow: bool, path: &str) -> Result<Blended> {
        let both = [&blend.start, &blend.end];
        let polygons = both.map(|section| Polygon::of(&section.form));
        refuse_broken(both, &polygons, path)?;
        let volume = Volume::solve(blend, path)?;
        let is_round = both.iter().all(|section| section.form.is_closed());
        let is_half_round = both.iter().any(|section| matches!(section.form, Form::DiscInSquare(_)));
        let border = match is_round {
            true if is_hollow => Border::Vessel(Box::new(flank(blend, path)?)),
            true => Border::Solid(Skin::round(&volume, flank(blend, path)?).turned()),
            false => Border::Solid(Skin::of_six(&volume, is_half_round).turned()),
        };
        let too_fine = blend
            .harmonics()
            .map(|(place, harmonic)| (format!("{place}.n"), harmonic.n))
            .find(|(_, n)| *n > DRAWN_WAVES);
        let size = polygons.iter().map(Polygon::extent).fold(0.0, f64::max);
        Ok(Blended { volume, border, too_fine, blend: blend.clone(), size })
    }

    /// Its inside.
    pub(crate) fn volume(&self) -> &Volume {
        &self.volume
    }

    /// A wave that its sines are too few for, and that carries the inside far off.
    pub(crate) fn unseen(&self) -> Option<Unseen> {
        Unseen::of(&self.blend, &self.volume, self.size)
    }

    /// Refuses to draw what has more waves than can be looked at one by one. `path` is that of the shape.
    ///
    /// # Errors
    /// `too-large`.
    pub(crate) fn drawable(&self, path: &str) -> Result<()> {
        let Some((place, n)) = &self.too_fine else { return Ok(()) };
        let message = format!(
            "expected an outline of at most {} waves to be drawn, found {}; points of it can be had",
            plain(DRAWN_WAVES),
            plain(*n)
        );
        let error = Error::new(Code::TooLarge, format!("{path}.{place}"), message);
        Err(error.with("greatest", DRAWN_WAVES).with("found", *n))
    }

    /// One of the patches; the first in place of one that there is not.
    pub(crate) fn patch(&self, index: usize) -> &dyn Patch {
        match &self.border {
            Border::Solid(skin) => &**skin.patches.get(index).unwrap_or(&skin.patches[0]),
            Border::Vessel(surface) => &**surface,
        }
    }

    /// The number of patches.
    pub(crate) fn n_patches(&self) -> usize {
        match &self.border {
            Border::Solid(skin) => skin.patches.len(),
            Border::Vessel(_) => 1,
        }
    }

    /// For each patch whether `X_u x X_v` points away from the inside.
    pub(crate) fn is_outward(&self) -> Vec<bool> {
        match &self.border {
            Border::Solid(skin) => skin.is_outward.clone(),
            Border::Vessel(surface) => vec![crate::surface::points_outward(surface)],
        }
    }

    /// The surface between two closed sections, of what is to be hollow.
    pub(crate) fn vessel(&self) -> Option<&Surface> {
        match &self.border {
            Border::Solid(_) => None,
            Border::Vessel(surface) => Some(surface),
        }
    }

    /// What runs round from one closed section to the other, of a vessel all of it, and of a solid its second patch, between two level caps; `None` of sections that are not closed.
    pub(crate) fn flank(&self) -> Option<&Surface> {
        match &self.border {
            Border::Solid(skin) => skin.flank.as_deref(),
            Border::Vessel(surface) => Some(surface),
        }
    }
}

impl Skin {
    /// Turned round where the volume is inside out, as the order of the sections and the sense of their parameters have it.
    fn turned(mut self) -> Skin {
        let at = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
        let jets = |patch: &dyn Patch| {
            let places = (0..SAMPLES * SAMPLES).map(|k| (at(k / SAMPLES), at(k % SAMPLES)));
            places.map(|(u, v)| patch.jet(u, v)).collect::<Vec<_>>()
        };
        let all: Vec<_> = self.patches.iter().map(|patch| jets(&**patch)).collect();
        let n = all.iter().map(Vec::len).sum::<usize>() as f64;
        let middle = all.iter().flatten().map(|jet| jet.position / n).sum::<glam::DVec3>();
        let flux = |(jets, is_outward): (&Vec<crate::patch::SurfaceJet>, &bool)| {
            let through = jets.iter().map(|jet| (jet.position - middle).dot(jet.du.cross(jet.dv))).sum::<f64>();
            if *is_outward { through } else { -through }
        };
        if all.iter().zip(&self.is_outward).map(flux).sum::<f64>() < 0.0 {
            self.is_outward.iter_mut().for_each(|is_outward| *is_outward = !*is_outward);
        }
        self
    }
}
