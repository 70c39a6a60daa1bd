//! What a part adds to the measures of the whole.

use super::moments::Moments;

/// Clay and water times their densities.
#[derive(Clone)]
pub(super) struct Share {
    pub(super) clay: Option<Moments>,
    pub(super) water: Option<Moments>,
}
