//! The smooth pieces of which the boundary of a body is made.

use glam::DVec3;

use super::kind::FaceKind;
use super::sealed::Sealed;
use super::seams::Seams;
use crate::solution::Columns;

/// Position and first derivatives of a face at one point, in model units, after placement.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FaceJet {
    /// `F(a, v)`.
    pub position: DVec3,
    /// `F_a`.
    pub da: DVec3,
    /// `F_v`.
    pub dv: DVec3,
}

/// Jets of one place of a face after the other: places of one row share what depends on it alone.
///
/// Sealed: only Pasu has such.
pub trait FaceWalk: Sealed {
    /// The jet at a place.
    fn jet(&mut self, a: f64, v: f64) -> FaceJet;

    /// The same at one of several columns of the face.
    fn jet_at(&mut self, a: f64, columns: &Columns, column: usize) -> FaceJet {
        self.jet(a, columns.v(column))
    }
}

impl<F: FnMut(f64, f64) -> FaceJet> Sealed for F {}

/// A walk over a face of whose places nothing is shared.
impl<F: FnMut(f64, f64) -> FaceJet> FaceWalk for F {
    fn jet(&mut self, a: f64, v: f64) -> FaceJet {
        self(a, v)
    }
}

/// One smooth piece `F(a, v)` of the boundary, `a` in [0, 1] and `v` in [0, 2 pi]. Faces of a pot are closed in `v`, and neighbours share whole boundary curves `a = 0` or `a = 1`;
/// a boundary may shrink to a point.
///
/// A level face whose outline is not star-shaped may fold over itself as a map; its signed area and moments hold all the same.
///
/// Sealed: what a face must be may grow, so that only Pasu implements it.
pub trait Face: Sealed + Send + Sync {
    /// What it is.
    fn kind(&self) -> FaceKind;

    /// Position and derivatives.
    fn jet(&self, a: f64, v: f64) -> FaceJet;

    /// Jets of one place after the other.
    fn walk(&self) -> Box<dyn FaceWalk + '_> {
        Box::new(|a: f64, v: f64| self.jet(a, v))
    }

    /// 1 or -1, so that `outward() * (F_a x F_v)` points out of the clay.
    fn outward(&self) -> f64;

    /// Whether `v = 0` and `v = 2 pi` are the same curve.
    fn is_closed(&self) -> bool {
        true
    }

    /// Whether it is run through against the sense of its tangents at this `v`, as what goes to an end and back is on the way back.
    fn goes_back(&self, _v: f64) -> bool {
        false
    }

    /// Of what goes to an end and back the face that it passes twice, for integrals, which would count everything twice; where that was moved it stands as before.
    fn passed_once(&self) -> Option<&dyn Face> {
        None
    }

    /// Whether the whole face lies in one plane across the axis of the pot, in which it may fold over itself as a map.
    ///
    /// ```
    /// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
    /// # let cup = pasu::Design::parse(
    /// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
    /// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
    /// # )?;
    /// use pasu::{Face, FaceKind, Pot, Product};
    ///
    /// let pot = Pot::new(&cup, 0, Product::Pot)?;
    /// let floor = pot.faces().iter().find(|face| face.kind() == FaceKind::Floor).expect("a floor");
    /// assert!(floor.is_level());
    /// # Ok::<(), pasu::Error>(())
    /// ```
    fn is_level(&self) -> bool {
        false
    }

    /// Whether `jet` is that of the true face to rounding. A lining that had to be thinned is interpolated, and is not.
    fn is_exact(&self) -> bool {
        true
    }

    /// Where the derivatives of a face jump; `None` where they do not.
    fn seams(&self) -> Option<Seams> {
        None
    }

    /// Where `a` of a column is in the coordinate `s` in which seams are straight: `a` itself but for a trimmed side of a wall, which has that of the whole.
    fn straight(&self, a: f64, _v: f64) -> f64 {
        a
    }

    /// As [`Face::walk`], in the coordinates `(s, v)`; the derivative by `s` is turned, so that the two span the face in the sense of its own coordinates.
    fn straight_walk(&self) -> Box<dyn FaceWalk + '_> {
        self.walk()
    }

    /// Columns at which jets are asked for.
    fn columns(&self, places: Vec<f64>) -> Columns {
        Columns::plain(places)
    }
}
