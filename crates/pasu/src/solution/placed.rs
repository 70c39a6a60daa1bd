//! One part of a design: a solved shape where it stands.

use std::sync::{Arc, OnceLock};

use glam::{DMat3, DVec3};

use super::solved::Solved;
use crate::design::{Part, Placement};
use crate::error::Result;
#[cfg(feature = "patchwork")]
use crate::frame::Shell;
use crate::patch::SurfaceJet;
use crate::surface::Round;

/// A solved shape, scaled, turned and moved: `p -> matrix p + shift`.
#[derive(Debug)]
pub(crate) struct Placed {
    solved: Arc<Solved>,
    matrix: DMat3,
    shift: DVec3,
    index: usize,
    /// For each patch.
    is_forwards: OnceLock<Vec<bool>>,
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
        Ok(Placed::of(Arc::new(Solved::of(part, index)?), &part.place, index))
    }

    /// A shape that has been solved.
    pub(super) fn of(solved: Arc<Solved>, place: &Placement, index: usize) -> Placed {
        let matrix = DMat3::from_cols_array_2d(&place.matrix()).transpose();
        let shift = DVec3::from_array(place.shift);
        Placed { solved, matrix, shift, index, is_forwards: OnceLock::new() }
    }

    /// The shell of a network where the network stands.
    #[cfg(feature = "patchwork")]
    pub(crate) fn with(&self, shell: Shell) -> Placed {
        let solved = Arc::new(Solved::Shell(Box::new(shell)));
        let Placed { matrix, shift, index, .. } = *self;
        Placed { solved, matrix, shift, index, is_forwards: OnceLock::new() }
    }

    /// The same shape in another place, as part number `index` of another design.
    pub(crate) fn elsewhere(&self, place: &Placement, index: usize) -> Placed {
        Placed::of(self.shared(), place, index)
    }

    /// The same shape, turned and scaled as it is, but not moved.
    pub(crate) fn unmoved(&self) -> Placed {
        Placed { solved: self.shared(), shift: DVec3::ZERO, is_forwards: OnceLock::new(), ..*self }
    }

    /// Another shape where this one stands.
    pub(crate) fn beside(&self, solved: Solved) -> Placed {
        let Placed { matrix, shift, index, .. } = *self;
        Placed { solved: Arc::new(solved), matrix, shift, index, is_forwards: OnceLock::new() }
    }

    pub(crate) fn solved(&self) -> &Solved {
        &self.solved
    }

    /// The same shape for somebody else to place.
    pub(super) fn shared(&self) -> Arc<Solved> {
        Arc::clone(&self.solved)
    }

    /// The linear part of the placement.
    pub(crate) fn matrix(&self) -> DMat3 {
        self.matrix
    }

    /// Where a point of the shape comes to be.
    pub(crate) fn point(&self, point: DVec3) -> DVec3 {
        self.matrix * point + self.shift
    }

    /// The same of a point with its derivatives.
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

    /// How round it is about its placed z axis, no larger than `size`; as [`Solved::round`], after placement.
    pub(crate) fn round(&self, size: f64) -> Option<Round> {
        let round = self.solved.round()?;
        let [x, y, z] = [self.matrix.x_axis, self.matrix.y_axis, self.matrix.z_axis];
        let axis = z.try_normalize()?;
        let (along, other) = if round.axis == 0 { (x, y) } else { (y, x) };
        // Of an image of the unit circle, how far from a circle across the axis.
        let skew = (x.length() - y.length()).abs()
            + x.dot(axis).abs()
            + y.dot(axis).abs()
            + x.dot(y).abs() / x.length().min(y.length());
        let skew = skew / along.length().min(other.length());
        let stretch = x.length().max(y.length()).max(z.length());
        Some(Round { off: round.off * stretch + skew * size, axis: round.axis })
    }

    /// Whether `X_u x X_v` of a placed patch points away from the inside.
    pub(crate) fn is_forwards(&self, patch: usize) -> bool {
        let all = self.is_forwards.get_or_init(|| {
            let is_mirrored = self.matrix.determinant() < 0.0;
            self.solved.is_outward().into_iter().map(|is_outward| is_outward != is_mirrored).collect()
        });
        all.get(patch).copied().unwrap_or(true)
    }
}
