//! One part of a design: a solved shape where it stands.

use std::sync::OnceLock;

use glam::{DMat3, DVec3};

use super::solved::Solved;
use crate::design::{Part, Placement};
use crate::error::Result;
use crate::patch::{Patch, SurfaceJet};

/// A solved shape, scaled, turned and moved: `p -> matrix p + shift`.
#[derive(Debug)]
pub(crate) struct Placed {
    solved: Solved,
    matrix: DMat3,
    shift: DVec3,
    index: usize,
    is_forwards: OnceLock<bool>,
}

impl AsRef<Placed> for Placed {
    fn as_ref(&self) -> &Placed {
        self
    }
}

impl Placed {
    /// Solves part number `index` of a design.
    ///
    /// # Errors
    /// As [`Solved::of`].
    pub(crate) fn new(part: &Part, index: usize) -> Result<Placed> {
        Ok(Placed::of(Solved::of(part, index)?, &part.place, index))
    }

    /// A shape that has been solved.
    pub(super) fn of(solved: Solved, place: &Placement, index: usize) -> Placed {
        let matrix = DMat3::from_cols_array_2d(&place.matrix()).transpose();
        let shift = DVec3::from_array(place.shift);
        Placed { solved, matrix, shift, index, is_forwards: OnceLock::new() }
    }

    pub(crate) fn solved(&self) -> &Solved {
        &self.solved
    }

    /// The linear part of the placement.
    pub(crate) fn matrix(&self) -> DMat3 {
        self.matrix
    }

    /// Where a point of the shape comes to be, and its derivatives.
    pub(crate) fn place(&self, jet: &SurfaceJet) -> SurfaceJet {
        let (m, shift) = (self.matrix, self.shift);
        SurfaceJet {
            position: m * jet.position + shift,
            du: m * jet.du,
            dv: m * jet.dv,
            duu: m * jet.duu,
            duv: m * jet.duv,
            dvv: m * jet.dvv,
        }
    }

    /// Where the origin of the shape is.
    pub(crate) fn shift(&self) -> DVec3 {
        self.shift
    }

    /// The number of the part.
    pub(crate) fn index(&self) -> usize {
        self.index
    }

    /// Where something of this part is in the design.
    pub(crate) fn path(&self, field: &str) -> String {
        format!("parts[{}].{field}", self.index)
    }

    /// The part as a path of its own.
    pub(crate) fn own_path(&self) -> String {
        format!("parts[{}]", self.index)
    }

    /// The unit vector along the placed z axis.
    pub(crate) fn axis(&self) -> DVec3 {
        self.matrix.z_axis.normalize_or(DVec3::Z)
    }

    /// Whether `X_u x X_v` of the placed patches points away from the inside.
    pub(crate) fn is_forwards(&self) -> bool {
        *self.is_forwards.get_or_init(|| {
            let is_outward = match self.solved.fourier() {
                Some(surface) => crate::surface::points_outward(surface),
                None => encloses(&self.solved.patches()),
            };
            is_outward != (self.matrix.determinant() < 0.0)
        })
    }
}

/// Samples along either parameter by which the sign of a volume is told.
const SAMPLES: usize = 17;

/// Whether the flux of `X - middle` through the patches along `X_u x X_v` is not negative: it is three times the volume that closed patches go round.
fn encloses(patches: &[&dyn Patch]) -> bool {
    let at = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
    let jets = || {
        let places = (0..SAMPLES * SAMPLES).map(move |k| (at(k / SAMPLES), at(k % SAMPLES)));
        patches.iter().flat_map(move |patch| places.clone().map(move |(u, v)| patch.jet(u, v)))
    };
    let middle = jets().map(|jet| jet.position).sum::<DVec3>() / (patches.len() * SAMPLES * SAMPLES) as f64;
    jets().map(|jet| (jet.position - middle).dot(jet.du.cross(jet.dv))).sum::<f64>() >= 0.0
}
