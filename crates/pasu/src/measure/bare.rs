//! The design surface of one part as a face: what there is to measure without a wall.

use core::f64::consts::TAU;
use std::sync::Arc;

use glam::DVec3;

use crate::face::{Face, FaceJet, FaceKind, FaceWalk, Sealed, Seams};
use crate::patch::SurfaceJet;
use crate::solution::{Placed, Upright, Walk};

/// An [`Upright`] surface as a face, from foot (`a = 0`) to rim (`a = 1`), closed or not.
#[derive(Debug, Clone)]
pub(crate) struct Bare {
    upright: Upright,
    kind: FaceKind,
    /// 1 where `X_a x X_v` points to the side from which it is seen, otherwise -1.
    outward: f64,
}

impl Bare {
    /// The surface of a part, seen from outside; `None` for a shape without foot and rim.
    pub(crate) fn new(placed: &Arc<Placed>) -> Option<Bare> {
        let upright = Upright::new(placed)?;
        let outward = upright.outward();
        Some(Bare { upright, kind: FaceKind::Outer, outward })
    }

    /// The same surface seen from inside: a lining without thickness.
    pub(crate) fn inside(&self) -> Bare {
        Bare { upright: self.upright.clone(), kind: FaceKind::Lining, outward: -self.outward }
    }

    /// The direction of the placed z axis.
    pub(crate) fn axis(&self) -> DVec3 {
        self.upright.placed().axis()
    }

    /// Whether the surface meets itself round the axis.
    pub(crate) fn is_closed(&self) -> bool {
        self.upright.is_closed()
    }

    /// How many waves go round at most.
    pub(crate) fn waves(&self) -> f64 {
        self.upright.waves()
    }

    /// How fast it may change next to its ends, as `exp(-rate a)`.
    pub(crate) fn rate(&self) -> f64 {
        self.upright.rate()
    }

    /// Where its derivatives jump along `a`.
    pub(crate) fn knots(&self) -> Vec<f64> {
        self.upright.knots()
    }

    /// Where `u` of the shape is along the face.
    pub(crate) fn along(&self, u: f64) -> f64 {
        self.upright.along(u)
    }

    /// The mean of a curve of constant `a`.
    pub(crate) fn centre(&self, a: f64) -> DVec3 {
        self.upright.centre(a)
    }

    /// Position and derivatives up to the second with respect to `a` and `v`, placed.
    pub(crate) fn second(&self, a: f64, v: f64) -> SurfaceJet {
        self.upright.at(a, v)
    }

    /// The same, one place after the other.
    pub(crate) fn second_walk(&self) -> Walk<'_> {
        self.upright.walk()
    }
}

impl Sealed for Bare {}

impl Face for Bare {
    fn kind(&self) -> FaceKind {
        self.kind
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        first(&self.second(a, v))
    }

    fn walk(&self) -> Box<dyn FaceWalk + '_> {
        let mut walk = self.upright.walk();
        Box::new(move |a: f64, v: f64| first(&walk.at(a, v)))
    }

    fn outward(&self) -> f64 {
        self.outward
    }
}

fn first(jet: &SurfaceJet) -> FaceJet {
    FaceJet { position: jet.position, da: jet.du, dv: jet.dv }
}

/// The cone from a closed curve of a face to the mean of its points: closes a foot or a drain hole.
pub(crate) struct Cap<'a> {
    face: &'a dyn Face,
    a: f64,
    tip: DVec3,
    outward: f64,
}

impl<'a> Cap<'a> {
    /// Closes a face at its curve `a = 0` or 1; the cap, from its tip at `a = 0`, is turned to the same side as the face.
    pub(crate) fn new(face: &'a dyn Face, a: f64, columns: usize) -> Cap<'a> {
        let mut walk = face.walk();
        let tip =
            (0..columns).map(|j| walk.jet(a, TAU * j as f64 / columns as f64).position).sum::<DVec3>() / columns as f64;
        // Running towards a = 0 of the face, the cap goes on as the face does; towards a = 1 it comes the other way.
        let outward = if a == 0.0 { face.outward() } else { -face.outward() };
        Cap { face, a, tip, outward }
    }
}

impl Cap<'_> {
    /// On the way from the tip to a place of the curve.
    fn over(&self, FaceJet { position, dv, .. }: FaceJet, a: f64) -> FaceJet {
        let arm = position - self.tip;
        FaceJet { position: self.tip + arm * a, da: arm, dv: dv * a }
    }
}

impl Sealed for Cap<'_> {}

impl Face for Cap<'_> {
    fn kind(&self) -> FaceKind {
        FaceKind::Floor
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        self.over(self.face.jet(self.a, v), a)
    }

    fn walk(&self) -> Box<dyn FaceWalk + '_> {
        let mut walk = self.face.walk();
        Box::new(move |a: f64, v: f64| self.over(walk.jet(self.a, v), a))
    }

    fn outward(&self) -> f64 {
        self.outward
    }

    fn seams(&self) -> Option<Seams> {
        let seams = self.face.seams()?;
        Some(Seams::across(1, [seams.round, seams.crossings].concat()))
    }
}
