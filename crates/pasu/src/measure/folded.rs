//! An open face, passed there and back.

use core::f64::consts::{PI, TAU};

use crate::face::{Face, FaceJet, FaceKind, PatchFace, Sealed};
use crate::numeric::turn;

/// A patch whose `v = 0` and `v = 1` are two curves, run through from the one to the other and back while `v` goes once round: what is searched for extremes round a closed face can be searched for them on it. It is
/// no face to be integrated over, which would count everything twice; tangents keep the sense that they have on the way there.
#[derive(Debug, Clone)]
pub(super) struct Folded(pub(super) PatchFace);

impl Sealed for Folded {}

impl Face for Folded {
    fn kind(&self) -> FaceKind {
        self.0.kind()
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        let v = turn::within(v);
        let jet = self.0.jet(a, if v <= PI { 2.0 * v } else { 2.0 * (TAU - v) });
        FaceJet { dv: 2.0 * jet.dv, ..jet }
    }

    fn outward(&self) -> f64 {
        self.0.outward()
    }

    fn goes_back(&self, v: f64) -> bool {
        turn::within(v) > PI
    }

    fn passed_once(&self) -> Option<&dyn Face> {
        Some(&self.0)
    }
}
