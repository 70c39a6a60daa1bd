//! What is along lines of constant `u` or `v` that are come to again and again.

use super::climb::Climb;
use crate::numeric::recent::Recent;

/// How many lines are kept: more than a grid has columns, and than a rule of integration mostly comes to in every row.
const KEPT: usize = 512;

/// Jets of some climbs at the places that were asked for lately. To form one anew takes longer than all else that is done at a place.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Lines<const N: usize>(Recent<[[f64; 3]; N], 1>);

impl<const N: usize> Lines<N> {
    /// Their jets at a place; always of the same climbs.
    pub(super) fn at(&self, place: f64, climbs: &[Climb; N]) -> [[f64; 3]; N] {
        self.0.at([place], KEPT, || climbs.map(|climb| climb.jet(place)))
    }
}
