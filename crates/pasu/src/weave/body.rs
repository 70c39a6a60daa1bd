//! What was made of one part: a body of clay and its mesh.

use std::sync::Arc;

use glam::DVec3;

use super::meshed::MadePot;
use super::solid_mesh::SolidMesh;
use crate::check::Topology;
use crate::design::Wall;
use crate::solid::Pot;
use crate::solution::Placed;

/// What was made of one part.
pub(crate) struct Made {
    pub(crate) mesh: SolidMesh,
    pub(crate) body: Body,
    pub(crate) topology: Topology,
    /// The tolerance that was asked for, where the mesh does not keep it.
    pub(crate) unkept: Option<f64>,
}

impl From<MadePot> for Made {
    fn from(MadePot { mesh, pot, topology, unkept }: MadePot) -> Made {
        Made { mesh, body: Body::Pot(Box::new(pot)), topology, unkept }
    }
}

/// A body of clay.
pub(crate) enum Body {
    /// A surface from foot to rim with its wall, or its ends closed.
    Pot(Box<Pot>),
    /// Patches that go round it.
    Patches(Arc<Placed>),
}

impl Body {
    /// As a pot, if it is one.
    pub(crate) fn pot(&self) -> Option<&Pot> {
        match self {
            Body::Pot(pot) => Some(pot),
            Body::Patches(_) => None,
        }
    }

    /// The part that it is of.
    pub(crate) fn placed(&self) -> &Placed {
        match self {
            Body::Pot(pot) => pot.skin().placed(),
            Body::Patches(placed) => placed,
        }
    }

    /// The number of the part.
    pub(crate) fn part(&self) -> usize {
        self.placed().index()
    }

    /// Its wall, as it was made.
    pub(crate) fn wall(&self) -> Option<Wall> {
        self.pot().and_then(Pot::wall)
    }

    /// How thick the wall is at least and at most, if it has one.
    pub(crate) fn thickness(&self) -> Option<(f64, f64)> {
        self.pot().filter(|pot| pot.has_wall()).map(Pot::thickness)
    }

    /// How thick the base is, if it has one.
    pub(crate) fn base(&self) -> Option<f64> {
        self.pot().and_then(Pot::base)
    }

    /// How much of the wall had to be thinned, and where most.
    pub(crate) fn thinned(&self) -> Option<(f64, DVec3)> {
        self.pot().and_then(Pot::thinned)
    }
}
