//! A solid whose inside is turned over somewhere, though its skin is sound.

use super::report::{Finding, Severity};
use crate::error::Args;
use crate::solid::place;
use crate::solution::Placed;

/// What is noted of a solid that was made from its skin: whoever computes with its inside finds cells of no use there.
pub(super) fn finding(placed: &Placed) -> Option<Finding> {
    let volume = placed.solved().volume()?;
    let inside = volume.inside();
    if !inside.is_folded() {
        return None;
    }
    let [u, v, w] = inside.jacobian_at;
    let at = placed.matrix() * volume.position([u, v, w]) + placed.shift();
    let message = format!(
        "the inside is folded over itself near {}, though the skin is not: cells for analysis are turned inside out there, and other terms, tangents or weights may help",
        place(at)
    );
    let args = Args::from([("jacobian", inside.jacobian.into())]);
    let (part, path, at) = (placed.index(), Some(placed.path("shape")), Some(at.to_array()));
    Some(Finding { code: "folded", severity: Severity::Note, part, path, message, args, at, remedy: None })
}
