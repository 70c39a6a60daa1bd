//! Closed triangles of several bodies as those of one: their union.

mod boxes;
mod cluster;
mod labelled;
mod narrow;
mod net;
mod swollen;
mod turn;
mod uncrossed;
mod union;
mod unions;

pub(crate) use labelled::Labelled;
pub(crate) use union::Union;
pub(crate) use unions::Unions;
