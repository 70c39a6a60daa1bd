//! The names of the pieces of which the boundary of a pot is made.

/// What a piece of the boundary is to a potter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
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

#[cfg(feature = "typescript")]
crate::answer::known_as!(FaceKind, "FaceKind");
