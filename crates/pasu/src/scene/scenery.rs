//! All parts of a scene, with what is known of how they meet.

use std::sync::{Arc, OnceLock};

use super::judged::{Judged, Known};
use super::meeting::Task;
use super::sight::Sight;
use crate::error::Result;
use crate::solution::Solution;

impl Solution {
    /// All parts in space.
    ///
    /// # Errors
    /// As [`Solution::sight`].
    pub(super) fn scenery(&self) -> Result<Arc<Scenery>> {
        if let Some(scenery) = self.scene().get::<Arc<Scenery>>() {
            return Ok(Arc::clone(scenery));
        }
        let before = self.scene_before().get::<Arc<Scenery>>();
        let (sight, design) = (self.sight()?, self.design().parts());
        let stands = |before: &Scenery, part: usize| design.get(part).is_some_and(|own| before.sight.stands(part, own));
        let before = before.map_or_else(Known::default, |before| before.found().of(|part| stands(before, part)));
        let scenery = Arc::new(Scenery { sight, before, known: OnceLock::new() });
        self.scene().keep(Arc::clone(&scenery));
        Ok(scenery)
    }
}

/// All parts of a design, each in space once that is wanted.
#[derive(Debug)]
pub(super) struct Scenery {
    pub(super) sight: Arc<Sight>,
    /// What was found of pairs of them in another scene.
    before: Known,
    /// What was found of them in this one.
    known: OnceLock<Known>,
}

impl Scenery {
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
