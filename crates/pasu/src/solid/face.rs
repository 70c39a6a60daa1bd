//! The smooth pieces of which the boundary of a pot is made.

use glam::DVec3;

use super::seams::Seams;

/// What a piece of the boundary is to a potter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum FaceKind {
    /// The wall seen from outside.
    Outer,
    /// The wall seen from inside.
    Lining,
    /// The edge between the two at an opening.
    Rim,
    /// What the pot stands on: the underside of the base, or of the foot ring.
    Underside,
    /// The inner side of the foot ring.
    FootRing,
    /// The underside of the base within the foot ring.
    Recess,
    /// The upper side of the base.
    Floor,
    /// The wall of the drain hole.
    Drain,
    /// What closes an open end of a solid for vase mode.
    Lid,
}

impl FaceKind {
    /// The word by which it is known: `outer`, `lining`, `rim`, `underside`, `foot-ring`, `recess`, `floor`, `drain`, `lid`.
    ///
    /// ```
    /// assert_eq!(pasu::FaceKind::FootRing.name(), "foot-ring");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            FaceKind::Outer => "outer",
            FaceKind::Lining => "lining",
            FaceKind::Rim => "rim",
            FaceKind::Underside => "underside",
            FaceKind::FootRing => "foot-ring",
            FaceKind::Recess => "recess",
            FaceKind::Floor => "floor",
            FaceKind::Drain => "drain",
            FaceKind::Lid => "lid",
        }
    }
}

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

/// One smooth piece `F(a, v)` of the boundary, `a` in [0, 1] and `v` in [0, 2 pi], closed in `v`. Neighbours share whole boundary curves `a = 0` or `a = 1`;
/// a boundary may shrink to a point.
///
/// A level face whose outline is not star-shaped may fold over itself as a map; its signed area and moments hold all the same.
pub trait Face {
    /// What it is.
    fn kind(&self) -> FaceKind;

    /// Position and derivatives.
    fn jet(&self, a: f64, v: f64) -> FaceJet;

    /// Whether `jet` is that of the true face to rounding. A lining that had to be thinned is interpolated, and is not.
    fn is_exact(&self) -> bool {
        true
    }

    /// Where the derivatives of a face that is not exact jump; `None` where they do not.
    fn seams(&self) -> Option<Seams<'_>> {
        None
    }

    /// 1 or -1, so that `outward() * (F_a x F_v)` points out of the clay.
    fn outward(&self) -> f64;
}
