//! What the measures of one part are taken on.

use std::sync::Arc;

use glam::DVec3;

use super::accuracy::Accuracy;
use super::bare::Bare;
use super::capacity::Vessel;
use super::dry::Dry;
use super::folded::Folded;
use super::moments::Moments;
use super::outside::Outside;
use crate::error::{Error, Result};
use crate::face::{Face, PatchFace};
use crate::solid::{Pot, Product};
use crate::solution::{Placed, Solution};

/// What integrals over exact faces are asked to keep, as a part of their size.
pub(super) const ACCURACY: f64 = 1e-9;

/// A part with what its measures are taken on.
pub(super) struct Taken {
    /// Its surface; of a shape without foot and rim its patches.
    pub(super) surface: Naked,
    /// The patches of an open network whose body has a thickness.
    open: Vec<PatchFace>,
    /// The body with its wall, if there can be one.
    pub(super) pot: Result<Pot>,
}

/// A part without a wall.
pub(super) enum Naked {
    /// A surface from foot to rim, seen from outside and from inside.
    Upright { bare: Bare, inside: Bare },
    /// Anything else.
    Patches { patches: Vec<PatchFace>, folded: Vec<Folded>, is_closed: bool, known: Option<Moments> },
}

/// What there is of a part to measure, where it stands.
pub(super) struct Stood {
    placed: Arc<Placed>,
    /// The same, unless an open network has a thickness.
    body: Arc<Placed>,
    /// The body with its wall, if there can be one.
    pub(super) pot: Result<Pot>,
    /// Whether it is to have a wall, and so is no solid by itself.
    is_to_be_hollow: bool,
}

impl Stood {
    /// # Errors
    /// What [`Surface::solve`](crate::Surface::solve) refuses.
    pub(super) fn new(solution: &Solution, index: usize, product: Product) -> Result<Stood> {
        let placed = solution.workable(index)?;
        let is_to_be_hollow = product == Product::Pot && solution.existing(index)?.1.wall.is_some();
        // What cannot have the thickness that is asked for is measured as the surface that it is, and says why.
        let (body, refused) = match solution.has_shell(index, product)? {
            false => (Arc::clone(placed), None),
            true => match solution.patched(index, product) {
                Ok(shell) => (shell, None),
                Err(why) => (Arc::clone(placed), Some(why)),
            },
        };
        let pot = refused.map_or_else(|| solution.sound_pot(index, product), Err);
        Ok(Stood { placed: Arc::clone(placed), body, pot, is_to_be_hollow })
    }

    /// Where it was moved to.
    pub(super) fn shift(&self) -> DVec3 {
        self.placed.shift()
    }

    /// Whether it is a network whose body has a thickness.
    fn is_shell(&self) -> bool {
        !Arc::ptr_eq(&self.placed, &self.body)
    }

    /// Why it has no wall, though patches with a thickness have one without being a pot.
    pub(super) fn refusal(&self) -> Option<&Error> {
        self.pot.as_ref().err().filter(|_| !self.is_shell())
    }

    /// Whether it is the same body wherever it is moved to.
    pub(super) fn is_movable(&self) -> bool {
        self.pot.as_ref().map_or(true, Pot::is_movable)
    }

    /// What is [movable](Stood::is_movable) as it would stand if it were not moved.
    ///
    /// # Errors
    /// As [`Pot::unmoved`].
    pub(super) fn unmoved(&self) -> Result<Stood> {
        let placed = Arc::new(self.placed.unmoved());
        let body = if self.is_shell() { Arc::new(self.body.unmoved()) } else { Arc::clone(&placed) };
        let pot = match &self.pot {
            Ok(pot) => Ok(pot.unmoved()?),
            Err(why) => Err(why.clone()),
        };
        Ok(Stood { placed, body, pot, is_to_be_hollow: self.is_to_be_hollow })
    }
}

impl Taken {
    /// # Errors
    /// As [`Stood::new`].
    pub(super) fn new(solution: &Solution, index: usize, product: Product) -> Result<Taken> {
        Ok(Taken::of(Stood::new(solution, index, product)?))
    }

    pub(super) fn of(stood: Stood) -> Taken {
        let open = if stood.is_shell() { PatchFace::all(&stood.placed) } else { Vec::new() };
        let Stood { placed, body, pot, is_to_be_hollow } = stood;
        let surface = match Bare::new(&placed) {
            Some(bare) => Naked::Upright { inside: bare.inside(), bare },
            None => {
                // What is to have a wall is no solid, unless that is a thickness of its patches.
                let is_closed = body.solved().is_closed() && !(is_to_be_hollow && open.is_empty());
                let patches = PatchFace::all(&body);
                let folded = patches.iter().filter(|patch| !patch.is_closed()).cloned().map(Folded).collect();
                let known = Moments::known(&body).filter(|_| is_closed);
                Naked::Patches { patches, folded, is_closed, known }
            }
        };
        Taken { surface, open, pot }
    }

    /// The faces of the surface itself.
    pub(super) fn naked_faces(&self) -> Vec<&dyn Face> {
        match &self.surface {
            Naked::Upright { bare, .. } => vec![bare],
            Naked::Patches { patches, .. } => patches.iter().map(|patch| patch as &dyn Face).collect(),
        }
    }

    /// The faces of an open network whose body is another: of all patches on both sides of its clay.
    pub(super) fn open_faces(&self) -> Vec<&dyn Face> {
        self.open.iter().map(|patch| patch as &dyn Face).collect()
    }

    /// Whether the faces of the surface itself go round clay.
    pub(super) fn is_its_own_body(&self) -> bool {
        matches!((&self.pot, &self.surface), (Err(_), Naked::Patches { is_closed: true, .. }))
    }

    /// The faces that go round clay: those of the pot, or closed patches.
    pub(super) fn body(&self) -> Option<Vec<&dyn Face>> {
        match (&self.pot, &self.surface) {
            (Ok(pot), _) => Some(pot.faces().iter().map(|piece| piece as &dyn Face).collect()),
            _ if self.is_its_own_body() => Some(self.naked_faces()),
            (Err(_), _) => None,
        }
    }

    /// Volume and first moments of the clay, where they are known in closed form.
    pub(super) fn known(&self) -> Option<Moments> {
        match (&self.pot, &self.surface) {
            (Err(_), Naked::Patches { known, .. }) => *known,
            _ => None,
        }
    }

    /// The faces between which heights and widths are: all of a body, because a lining may be higher and wider than the outside.
    pub(super) fn faces(&self) -> Vec<&dyn Face> {
        match (&self.pot, &self.surface) {
            (Err(_), Naked::Patches { patches, folded, .. }) => {
                let closed = patches.iter().filter(|patch| patch.is_closed()).map(|patch| patch as &dyn Face);
                closed.chain(folded.iter().map(|folded| folded as &dyn Face)).collect()
            }
            _ => self.body().unwrap_or_else(|| self.naked_faces()),
        }
    }

    /// How many waves go round at most.
    pub(super) fn waves(&self) -> f64 {
        match &self.surface {
            Naked::Upright { bare, .. } => bare.waves(),
            Naked::Patches { patches, .. } => {
                let waves = patches.iter().flat_map(|patch| patch.patch().breaks()).map(|breaks| breaks.waves);
                waves.fold(0.0, f64::max)
            }
        }
    }

    pub(super) fn outside(&self) -> Outside<'_> {
        Outside::new(self.faces(), self.waves())
    }

    /// How fast the surface may change next to its ends.
    fn rate(&self) -> f64 {
        match &self.surface {
            Naked::Upright { bare, .. } => bare.rate(),
            Naked::Patches { .. } => 0.0,
        }
    }

    /// Where derivatives of the surface jump along it.
    fn knots(&self) -> Vec<f64> {
        match &self.surface {
            Naked::Upright { bare, .. } => {
                let lining = self.pot.as_ref().map(Pot::knots_of_lining).unwrap_or_default();
                let mut knots = bare.knots();
                if !lining.is_empty() {
                    knots.extend(lining);
                    knots.sort_by(f64::total_cmp);
                    knots.dedup();
                }
                knots
            }
            Naked::Patches { .. } => Vec::new(),
        }
    }

    pub(super) fn accuracy(&self) -> Accuracy {
        Accuracy::new(ACCURACY, self.waves()).falling(self.rate()).broken(self.knots())
    }

    /// What holds water: the pot, or the bare surface where no wall is asked for; the reason in words where nothing does.
    pub(super) fn vessel(&self, has_wall: bool, product: Product) -> std::result::Result<Vessel<'_>, Dry> {
        match (&self.pot, &self.surface) {
            _ if product == Product::Solid => Err(Dry::new("solid", "a solid has no inside")),
            (Ok(pot), _) => Vessel::of_pot(pot, self.waves()),
            (Err(why), _) if has_wall && self.open.is_empty() => Err(why.into()),
            (Err(_), Naked::Upright { inside, bare }) => Vessel::of_bare(inside, bare),
            (Err(_), Naked::Patches { .. }) => Err(Dry::new(
                "no-foot",
                "the shape has no foot and no rim, between which it would be found how much it holds",
            )),
        }
    }
}
