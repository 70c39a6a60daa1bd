//! A solid whose inside is turned over somewhere, or carried away by sines that are too few, though its skin is sound.

use super::report::{Finding, Severity};
use crate::blend::{Unseen, Volume};
use crate::design::plain;
use crate::error::Args;
use crate::solid::{place, short};
use crate::solution::Placed;

/// What is noted of a solid that was made from its skin: whoever computes with its inside finds cells of no use there.
pub(super) fn finding(placed: &Placed) -> Option<Finding> {
    let volume = placed.solved().volume()?;
    if let Some(unseen) = placed.solved().unseen() {
        return Some(too_few(placed, volume, &unseen));
    }
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

/// What is noted where a wave of a section goes round more often than the sines can tell: cells are refused there.
fn too_few(placed: &Placed, volume: &Volume, unseen: &Unseen) -> Finding {
    let &Unseen { n, terms, at, far } = unseen;
    let at = placed.matrix() * volume.position(at) + placed.shift();
    let message = format!(
        "{terms} terms along v do not see a wave that goes round {} times, and carry the inside off by {} near {}, though the skin is sound: expected at least {}, or the method \"exact\" where there is one",
        plain(n),
        short(far),
        place(at),
        plain(unseen.least())
    );
    let args = Args::from([
        ("found", f64::from(terms).into()),
        ("least", unseen.least().into()),
        ("waves", n.into()),
        ("distance", far.into()),
    ]);
    let (part, path, at) = (placed.index(), Some(placed.path("shape.terms")), Some(at.to_array()));
    Finding { code: "few-terms", severity: Severity::Note, part, path, message, args, at, remedy: None }
}
