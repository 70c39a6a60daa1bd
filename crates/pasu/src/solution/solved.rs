//! The shape of one part, solved.

use glam::DVec3;

#[cfg(feature = "patchwork")]
use crate::blend::{Blended, Unseen, Volume};
use crate::design::{Part, Shape};
use crate::error::Result;
#[cfg(feature = "patchwork")]
use crate::frame::{Frame, Shell};
#[cfg(feature = "patchwork")]
use crate::octant::Supersphere;
use crate::patch::Patch;
#[cfg(test)]
use crate::patch::Side;
use crate::surface::{Round, Surface};

/// The closed form of a shape: patches, whatever its kind. A new kind of shape is one more variant.
#[derive(Debug)]
pub(crate) enum Solved {
    /// A surface between two curves.
    TwoSided(Box<Surface>),
    /// A network of vertex-frames.
    #[cfg(feature = "patchwork")]
    Frame(Frame),
    /// An open one with a thickness.
    #[cfg(feature = "patchwork")]
    Shell(Box<Shell>),
    /// A solid between two sections, or what goes round one.
    #[cfg(feature = "patchwork")]
    Blend(Box<Blended>),
    /// An octant of a supersphere.
    #[cfg(feature = "patchwork")]
    Octant(Box<Supersphere>),
    /// Patches that stand for a kind yet to come: what the contract is tested with.
    #[cfg(test)]
    Patches(Vec<Box<dyn Patch>>),
}

impl Solved {
    /// Solves the shape of part number `index` of a design.
    ///
    /// # Errors
    /// As [`Surface::of_part`], `Frame::solve` and `Blended::solve`.
    pub(crate) fn of(part: &Part, index: usize) -> Result<Solved> {
        let path = || format!("parts[{index}].shape");
        match &part.shape {
            #[cfg(feature = "patchwork")]
            Shape::VertexFrame(network) => Frame::solve(network, &path()).map(Solved::Frame),
            #[cfg(feature = "patchwork")]
            Shape::Blend(blend) => Blended::solve(blend, part.wall.is_some(), &path()).map(Box::new).map(Solved::Blend),
            #[cfg(feature = "patchwork")]
            Shape::Octant(octant) => Ok(Solved::Octant(Box::new(Supersphere::new(octant)))),
            _ => Surface::of_part(part, index).map(Box::new).map(Solved::TwoSided),
        }
    }

    /// As [`Solved::of`], with every bit the same, where another shape was solved before: of a network whose points were moved the strips alone are solved that have to be.
    ///
    /// # Errors
    /// As [`Solved::of`].
    #[cfg_attr(
        not(feature = "patchwork"),
        expect(unused_variables, reason = "no other kind has parts of its own to keep")
    )]
    pub(crate) fn after(part: &Part, index: usize, before: &Solved) -> Result<Solved> {
        #[cfg(feature = "patchwork")]
        if let (Shape::VertexFrame(network), Solved::Frame(frame)) = (&part.shape, before)
            && let Some(frame) = frame.after(network)
        {
            return Ok(Solved::Frame(frame));
        }
        Solved::of(part, index)
    }

    /// The patches, of which there is at least one.
    pub(crate) fn patches(&self) -> Vec<&dyn Patch> {
        (0..self.n_patches()).map(|index| self.patch(index)).collect()
    }

    /// One of the patches; the first in place of one that there is not.
    pub(crate) fn patch(&self, index: usize) -> &dyn Patch {
        match self {
            Solved::TwoSided(surface) => &**surface,
            #[cfg(feature = "patchwork")]
            Solved::Frame(frame) => frame.patch(index),
            #[cfg(feature = "patchwork")]
            Solved::Shell(shell) => shell.patch(index),
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.patch(index),
            #[cfg(feature = "patchwork")]
            Solved::Octant(octant) => octant.patch(index),
            #[cfg(test)]
            Solved::Patches(patches) => &**patches.get(index).unwrap_or(&patches[0]),
        }
    }

    /// The number of patches.
    pub(crate) fn n_patches(&self) -> usize {
        match self {
            Solved::TwoSided(_) => 1,
            #[cfg(feature = "patchwork")]
            Solved::Frame(frame) => frame.n_patches(),
            #[cfg(feature = "patchwork")]
            Solved::Shell(shell) => shell.n_patches(),
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.n_patches(),
            #[cfg(feature = "patchwork")]
            Solved::Octant(octant) => octant.n_patches(),
            #[cfg(test)]
            Solved::Patches(patches) => patches.len(),
        }
    }

    /// Whether the patches go round a body: none has a free side, and they have an inside and an outside.
    pub(crate) fn is_closed(&self) -> bool {
        match self {
            Solved::TwoSided(_) => false,
            #[cfg(feature = "patchwork")]
            Solved::Frame(frame) => frame.is_closed(),
            #[cfg(feature = "patchwork")]
            Solved::Shell(_) => true,
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.vessel().is_none(),
            #[cfg(feature = "patchwork")]
            Solved::Octant(_) => true,
            #[cfg(test)]
            Solved::Patches(patches) => {
                patches.iter().all(|patch| patch.sides().iter().all(|side| *side != Side::Free))
            }
        }
    }

    /// For each patch whether `X_u x X_v` points away from the inside.
    pub(crate) fn is_outward(&self) -> Vec<bool> {
        match self {
            Solved::TwoSided(surface) => vec![crate::surface::points_outward(surface)],
            #[cfg(feature = "patchwork")]
            Solved::Frame(frame) => frame.is_outward().to_vec(),
            #[cfg(feature = "patchwork")]
            Solved::Shell(shell) => shell.is_outward().to_vec(),
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.is_outward(),
            #[cfg(feature = "patchwork")]
            Solved::Octant(octant) => octant.is_outward(),
            #[cfg(test)]
            Solved::Patches(patches) => vec![encloses(patches); patches.len()],
        }
    }

    /// Edges at which patches meet at less than this angle are shown as if the surface were smooth there, in radians; none are where there is no such angle.
    pub(crate) fn crease(&self) -> Option<f64> {
        match self {
            #[cfg(feature = "patchwork")]
            Solved::Frame(frame) => Some(frame.crease()),
            #[cfg(feature = "patchwork")]
            Solved::Shell(shell) => Some(shell.crease()),
            _ => None,
        }
    }

    /// The patch that runs from one end to the other and closes round between them: what can carry a wall. It is one also where it fails to close, which whoever needs that has to ask.
    pub(crate) fn wall(&self) -> Option<&dyn Patch> {
        match self {
            Solved::TwoSided(surface) => Some(&**surface),
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.vessel().map(|surface| surface as &dyn Patch),
            _ => None,
        }
    }

    /// How round it is, whatever wall it carries: of a surface between two ends, and of a blend between two discs, whose other two patches are then level discs up to the ends of its second one.
    pub(crate) fn round(&self) -> Option<Round> {
        match self {
            Solved::TwoSided(surface) => surface.round(),
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.flank()?.round(),
            _ => None,
        }
    }

    /// The thickness of a shell where it is thinnest, by samples, and where that is before placement.
    pub(crate) fn thinnest(&self) -> Option<(f64, DVec3)> {
        match self {
            #[cfg(feature = "patchwork")]
            Solved::Shell(shell) => Some(shell.thinnest()),
            _ => None,
        }
    }

    /// The open network with a thickness that it is.
    #[cfg(feature = "patchwork")]
    pub(crate) fn shell(&self) -> Option<&Shell> {
        match self {
            Solved::Shell(shell) => Some(shell),
            _ => None,
        }
    }

    /// The network that it is.
    #[cfg(feature = "patchwork")]
    pub(crate) fn frame(&self) -> Option<&Frame> {
        match self {
            Solved::Frame(frame) => Some(frame),
            _ => None,
        }
    }

    /// The Fourier series in `v` that the single precision kernel sums, if it is one: the door to `mesh/fourier`.
    pub(crate) fn fourier(&self) -> Option<&Surface> {
        match self {
            Solved::TwoSided(surface) => Some(&**surface),
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.vessel(),
            _ => None,
        }
    }

    /// The volume and the first moments of its inside, if they are known in closed form.
    pub(crate) fn moments(&self) -> Option<(f64, DVec3)> {
        match self {
            #[cfg(feature = "patchwork")]
            Solved::Octant(octant) => Some(octant.moments()),
            _ => None,
        }
    }

    /// The octant that it is, whose inside is known by a formula.
    #[cfg(feature = "patchwork")]
    pub(crate) fn octant(&self) -> Option<&Supersphere> {
        match self {
            Solved::Octant(octant) => Some(octant),
            _ => None,
        }
    }

    /// Refuses to draw what is finer than can be drawn patch by patch. `path` is that of the shape.
    ///
    /// # Errors
    /// `too-large`.
    pub(crate) fn drawable(&self, path: &str) -> Result<()> {
        match self {
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => blend.drawable(path),
            _ => {
                let _ = path;
                Ok(())
            }
        }
    }

    /// The closed form of its inside, if that is known.
    #[cfg(feature = "patchwork")]
    pub(crate) fn volume(&self) -> Option<&Volume> {
        match self {
            #[cfg(feature = "patchwork")]
            Solved::Blend(blend) => Some(blend.volume()),
            _ => None,
        }
    }

    /// Of a blend, a wave that the sines of its inside are too few for.
    #[cfg(feature = "patchwork")]
    pub(crate) fn unseen(&self) -> Option<Unseen> {
        match self {
            Solved::Blend(blend) => blend.unseen(),
            _ => None,
        }
    }
}

/// Samples along either parameter by which the sign of a volume is told.
#[cfg(test)]
const SAMPLES: usize = 17;

/// Whether the flux of `X - middle` through the patches along `X_u x X_v` is not negative: it is three times the volume that closed patches go round.
#[cfg(test)]
fn encloses(patches: &[Box<dyn Patch>]) -> bool {
    let at = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
    let jets = || {
        let places = (0..SAMPLES * SAMPLES).map(move |k| (at(k / SAMPLES), at(k % SAMPLES)));
        patches.iter().flat_map(move |patch| places.clone().map(move |(u, v)| patch.jet(u, v)))
    };
    let middle = jets().map(|jet| jet.position).sum::<DVec3>() / (patches.len() * SAMPLES * SAMPLES) as f64;
    jets().map(|jet| (jet.position - middle).dot(jet.du.cross(jet.dv))).sum::<f64>() >= 0.0
}
