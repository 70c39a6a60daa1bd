//! All parts of a scene, with what is known of how they meet.

use std::sync::{Arc, OnceLock};

use super::bounds::Bounds;
use super::boxes::Boxes;
use super::judged::{Judged, Known};
use super::meeting::Task;
use super::space::Space;
use crate::design::Part;
use crate::error::Result;
use crate::solution::Solution;

impl Solution {
    /// All parts in space.
    ///
    /// # Errors
    /// As [`Solution::in_space`].
    pub(super) fn scenery(&self) -> Result<Arc<Scenery>> {
        if let Some(scenery) = self.scene().get::<Arc<Scenery>>() {
            return Ok(Arc::clone(scenery));
        }
        let before = self.scene_before().get::<Arc<Scenery>>();
        let design = self.design().parts();
        let parts = (0..design.len()).map(|index| self.in_space(index)).collect::<Result<Vec<_>>>()?;
        let bounds: Vec<Bounds> = parts.iter().map(|part| part.bounds).collect();
        let scenery = Arc::new(Scenery {
            boxes: Boxes::new(&bounds),
            parts,
            design: design.to_vec(),
            before: before.map_or_else(Known::default, |before| {
                before.found().of(|part| design.get(part).is_some_and(|own| before.standing(part, own).is_some()))
            }),
            known: OnceLock::new(),
        });
        self.scene().keep(Arc::clone(&scenery));
        Ok(scenery)
    }
}

/// All parts of a design with the tree of their boxes.
#[derive(Debug)]
pub(super) struct Scenery {
    pub(super) parts: Vec<Arc<Space>>,
    pub(super) boxes: Boxes,
    /// What they are of.
    design: Vec<Part>,
    /// What was found of pairs of them in another scene.
    before: Known,
    /// What was found of them in this one.
    known: OnceLock<Known>,
}

impl Scenery {
    /// A part that is here just as it is there.
    fn standing(&self, index: usize, part: &Part) -> Option<&Arc<Space>> {
        let own = self.design.get(index)?;
        let is_same = own.place == part.place && own.wall == part.wall && own.shape == part.shape;
        is_same.then(|| self.parts.get(index)).flatten()
    }

    /// What is known of pairs.
    fn found(&self) -> &Known {
        self.known.get().unwrap_or(&self.before)
    }

    /// How two parts meet, if that was found before.
    pub(super) fn known(&self, both: [usize; 2], task: Task) -> Option<&Judged> {
        self.found().get(both, task)
    }

    /// Keeps what was found, if nothing was kept before.
    pub(super) fn keep(&self, known: Known) {
        self.known.get_or_init(|| known);
    }
}
