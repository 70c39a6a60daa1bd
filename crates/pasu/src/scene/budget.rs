//! How much work a scene is worth, counted and not timed.

use super::space::TILE;
use crate::watch;

/// So many steps in a plane count as one pair of tiles: they are compared with segments and not with triangles.
const STEPS: u64 = 16;

/// What is left to be done for a scene, in pairs of tiles.
pub(super) struct Budget {
    pub(super) left: u64,
    /// Whether something was asked for that was not there.
    pub(super) is_out: bool,
}

impl Budget {
    pub(super) fn new(units: u64) -> Budget {
        Budget { left: units, is_out: false }
    }

    pub(super) fn take(&mut self, units: u64) -> bool {
        watch::work(TILE * units);
        let is_there = self.left >= units && !watch::is_stopped();
        self.left = self.left.saturating_sub(units);
        self.is_out |= !is_there;
        is_there
    }
}

/// What two parts are worth in the plane through their axis.
pub(super) struct Steps<'a> {
    budget: &'a mut Budget,
    /// In pairs of tiles.
    n_left: u64,
    /// Steps that are paid for.
    n_paid: u64,
}

impl<'a> Steps<'a> {
    /// No more than so many pairs of tiles of a budget.
    pub(super) fn of(budget: &'a mut Budget, most: u64) -> Steps<'a> {
        Steps { budget, n_left: most, n_paid: 0 }
    }

    /// Takes so many steps; `None` where they are not there.
    pub(super) fn take(&mut self, n: u64) -> Option<()> {
        while self.n_paid < n {
            if self.n_left == 0 || !self.budget.take(1) {
                return None;
            }
            self.n_left -= 1;
            self.n_paid += STEPS;
        }
        self.n_paid -= n;
        Some(())
    }
}
