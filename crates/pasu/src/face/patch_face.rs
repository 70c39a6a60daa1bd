//! One patch of a placed shape as a face.

use core::f64::consts::TAU;
use std::sync::Arc;

use super::contract::{Face, FaceJet, FaceWalk};
use super::kind::FaceKind;
use super::sealed::Sealed;
use super::seams::Seams;
#[cfg(feature = "patchwork")]
use crate::frame::Lie;
use crate::patch::{Patch, Row, Side};
use crate::solution::Placed;
use crate::watch;

/// The placed patch number `patch` of a part: `a` is its `u`, and `v / (2 pi)` its `v`.
#[derive(Debug, Clone)]
pub(crate) struct PatchFace {
    placed: Arc<Placed>,
    patch: usize,
}

impl PatchFace {
    /// Every patch of a part.
    pub(crate) fn all(placed: &Arc<Placed>) -> Vec<PatchFace> {
        let n = placed.solved().patches().len();
        (0..n).map(|patch| PatchFace { placed: Arc::clone(placed), patch }).collect()
    }

    /// The patch before placement.
    pub(crate) fn patch(&self) -> &dyn Patch {
        self.placed.solved().patch(self.patch)
    }
}

/// What patch number `patch` of a part is: of a network with a thickness its outer side, its lining or its rim, and the outside of anything else.
#[cfg_attr(not(feature = "patchwork"), expect(unused_variables, reason = "nothing else has an inside of its own"))]
pub(crate) fn kind_of(placed: &Placed, patch: usize) -> FaceKind {
    #[cfg(feature = "patchwork")]
    if let Some(shell) = placed.solved().shell() {
        return match shell.lie(patch) {
            Lie::Outer => FaceKind::Outer,
            Lie::Inner => FaceKind::Lining,
            Lie::Rim => FaceKind::Rim,
        };
    }
    FaceKind::Outer
}

/// Rows of a patch, of which the last is kept.
struct Walk<'a> {
    face: &'a PatchFace,
    n_terms: usize,
    row: Option<(f64, Box<dyn Row + 'a>)>,
}

impl Sealed for Walk<'_> {}

impl FaceWalk for Walk<'_> {
    fn jet(&mut self, a: f64, v: f64) -> FaceJet {
        let row = match self.row.take().filter(|row| row.0 == a) {
            Some((_, row)) => row,
            None => {
                watch::row(self.n_terms);
                self.face.patch().row(a)
            }
        };
        watch::place(self.n_terms);
        let jet = self.face.placed.place(&row.jet(v / TAU)).stretched(1.0, row.length() / TAU);
        self.row = Some((a, row));
        FaceJet { position: jet.position, da: jet.du, dv: jet.dv }
    }
}

impl Sealed for PatchFace {}

impl Face for PatchFace {
    fn kind(&self) -> FaceKind {
        kind_of(&self.placed, self.patch)
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        self.walk().jet(a, v)
    }

    fn walk(&self) -> Box<dyn FaceWalk + '_> {
        Box::new(Walk { face: self, n_terms: self.patch().n_terms(), row: None })
    }

    fn outward(&self) -> f64 {
        if self.placed.is_forwards(self.patch) { 1.0 } else { -1.0 }
    }

    fn is_closed(&self) -> bool {
        self.patch().sides()[2] == Side::Joined
    }

    fn seams(&self) -> Option<Seams> {
        let [along, round] = self.patch().breaks();
        if along.knots.is_empty() && round.knots.is_empty() {
            return None;
        }
        let turns = round.knots.iter().map(|v| v * TAU).collect();
        Some(Seams { along: along.with_ends(), round: turns, crossings: Vec::new(), rough: Vec::new(), cost: 1 })
    }
}
