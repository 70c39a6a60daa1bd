//! What lies beside a triangle.

use super::boxes::{Bounded, Boxes};

/// Triangles in a tree of boxes.
pub(crate) struct Neighbours {
    boxes: Boxes,
}

impl Neighbours {
    pub(crate) fn of(triangles: impl Iterator<Item = [[f32; 3]; 3]>) -> Neighbours {
        let bounded = triangles.zip(0..).map(|(corners, number)| Bounded::of(number, None, corners));
        Neighbours { boxes: Boxes::new(bounded.collect()) }
    }

    /// The numbers of the triangles whose boxes touch that of this one.
    pub(crate) fn beside(&self, corners: [[f32; 3]; 3]) -> Vec<u32> {
        let mut found = Vec::new();
        self.boxes.each_beside(&Bounded::of(u32::MAX, None, corners), |number| found.push(number));
        found
    }
}
