//! The design surface of one part as a face: what there is to measure without a wall.

use core::cell::RefCell;
use core::f64::consts::TAU;

use glam::{DMat3, DVec3};

use crate::design::Part;
use crate::error::Result;
use crate::solid::{Face, FaceJet, FaceKind, Seams};
use crate::surface::{RowTable, Surface, SurfaceJet, distinct, of_turns, points_outward};

/// The placed surface `X(u, v)` of a part, from foot (`a = 0`) to rim (`a = 1`).
///
/// The foot is the end whose mean height along the placed z axis is the lower one.
#[derive(Debug)]
pub(crate) struct Bare {
    surface: Surface,
    matrix: DMat3,
    shift: DVec3,
    /// Whether the foot is at `u = 0`.
    is_upward: bool,
    /// 1 where `X_a x X_v` points out of the pot, otherwise -1.
    outward: f64,
    kind: FaceKind,
    distinct: Vec<f64>,
    /// The row that was asked for last: integrals go row by row.
    row: RefCell<(f64, RowTable<3>)>,
}

impl Bare {
    /// The surface of part number `index`, seen from outside.
    ///
    /// # Errors
    /// What [`Surface::solve`] refuses.
    pub(crate) fn new(part: &Part, index: usize) -> Result<Bare> {
        let surface = Surface::of_part(part, index)?;
        let matrix = DMat3::from_cols_array_2d(&part.place.matrix()).transpose();
        let shift = DVec3::from_array(part.place.shift);
        let is_forwards = points_outward(&surface) != (matrix.determinant() < 0.0);
        let distinct = distinct(&surface);
        let row = RefCell::new((f64::NAN, RowTable::at(&surface, &distinct, 0.0)));
        let mut bare = Bare {
            surface,
            matrix,
            shift,
            is_upward: true,
            outward: if is_forwards { 1.0 } else { -1.0 },
            kind: FaceKind::Outer,
            distinct,
            row,
        };
        let axis = bare.axis();
        let [start, end] = [0.0, 1.0].map(|a| axis.dot(bare.centre(a)));
        if end < start {
            bare.is_upward = false;
            bare.outward = -bare.outward;
        }
        Ok(bare)
    }

    /// The same surface seen from inside: a lining without thickness.
    pub(crate) fn inside(self) -> Bare {
        Bare { outward: -self.outward, kind: FaceKind::Lining, ..self }
    }

    /// The direction of the placed z axis.
    pub(crate) fn axis(&self) -> DVec3 {
        self.matrix.z_axis.normalize_or(DVec3::Z)
    }

    /// Whether the surface meets itself round the axis.
    pub(crate) fn is_closed(&self) -> bool {
        self.surface.is_closed()
    }

    /// The highest harmonic.
    pub(crate) fn highest(&self) -> f64 {
        self.distinct.iter().fold(0.0, |highest, n| highest.max(n.abs()))
    }

    /// Where `u` of the shape is along the face.
    pub(crate) fn along(&self, u: f64) -> f64 {
        if self.is_upward { u } else { 1.0 - u }
    }

    /// The mean of a curve of constant `a`.
    pub(crate) fn centre(&self, a: f64) -> DVec3 {
        let n = 2 * self.highest().min(1e4) as usize + 5;
        (0..n).map(|j| self.jet(a, TAU * j as f64 / n as f64).position).sum::<DVec3>() / n as f64
    }

    /// Position and derivatives up to the second with respect to `a` and `v`, placed.
    pub(crate) fn second(&self, a: f64, v: f64) -> SurfaceJet {
        let u = self.along(a);
        let mut row = self.row.borrow_mut();
        if row.0 != u {
            *row = (u, RowTable::at(&self.surface, &self.distinct, u));
        }
        let turns = v / TAU;
        let jet = row.1.jet(|n| of_turns(self.distinct.get(n).copied().unwrap_or(0.0) * turns));
        let (m, along, round) = (self.matrix, if self.is_upward { 1.0 } else { -1.0 }, self.surface.span() / TAU);
        SurfaceJet {
            position: m * jet.position + self.shift,
            du: m * jet.du * along,
            dv: m * jet.dv * round,
            duu: m * jet.duu,
            duv: m * jet.duv * (along * round),
            dvv: m * jet.dvv * (round * round),
        }
    }
}

impl Face for Bare {
    fn kind(&self) -> FaceKind {
        self.kind
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        let SurfaceJet { position, du, dv, .. } = self.second(a, v);
        FaceJet { position, da: du, dv }
    }

    fn outward(&self) -> f64 {
        self.outward
    }
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
        let tip =
            (0..columns).map(|j| face.jet(a, TAU * j as f64 / columns as f64).position).sum::<DVec3>() / columns as f64;
        // Running towards a = 0 of the face, the cap goes on as the face does; towards a = 1 it comes the other way.
        let outward = if a == 0.0 { face.outward() } else { -face.outward() };
        Cap { face, a, tip, outward }
    }
}

impl Face for Cap<'_> {
    fn kind(&self) -> FaceKind {
        FaceKind::Floor
    }

    fn jet(&self, a: f64, v: f64) -> FaceJet {
        let FaceJet { position, dv, .. } = self.face.jet(self.a, v);
        let arm = position - self.tip;
        FaceJet { position: self.tip + arm * a, da: arm, dv: dv * a }
    }

    fn outward(&self) -> f64 {
        self.outward
    }

    fn seams(&self) -> Option<Seams<'_>> {
        let seams = self.face.seams()?;
        Some(Seams::across(self, 1, [seams.round(), seams.crossings()].concat()))
    }
}
