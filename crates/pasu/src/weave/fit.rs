//! The ring under a base and the drain through it, fitted to what there is room for.

use std::sync::Arc;

use super::meshed::{GLIMPSE, Made, glimpsed};
use crate::design::Wall;
use crate::error::Error;
use crate::face::FaceKind;
use crate::solid::{Pot, Skin, significant};

/// By how much rings are wider or narrower. Less than a third of the width, or an eighth of the height, is no longer the ring that was asked for.
const WIDTHS: [f64; 12] = [1.0, 0.8, 0.63, 0.5, 0.4, 0.3, 1.25, 1.6, 2.0, 2.5, 3.2, 4.5];

/// By how much rings are lower.
const HEIGHTS: [f64; 8] = [1.0, 0.8, 0.63, 0.5, 0.4, 0.3, 0.2, 0.125];

/// By how much drains are smaller.
const DRAINS: [f64; 7] = [1.0, 0.9, 0.75, 0.6, 0.5, 0.35, 0.25];

/// Widths and heights of rings are sought from this part of the size downwards, whatever was asked for, and drains from all of it.
const LARGEST: f64 = 0.25;

/// Digits of the lengths that are not as asked for: as many as a person would write.
const DIGITS: u32 = 2;

/// The most walls that are tried on a coarse mesh, and on one that keeps the usual tolerance.
const TRIALS: [usize; 2] = [32, 3];

/// Whether there is something of a wall that can be fitted.
pub(super) fn can_give_way(wall: &Wall) -> bool {
    wall.foot.is_some() || wall.drain > 0.0
}

/// Whether a wall may be refused because of that: the ring itself, the drain, or the base that lies higher on a ring.
pub(super) fn may_be_at_fault(wall: &Wall, error: &Error) -> bool {
    let field = error.path().split_once("].").map_or("", |(_, field)| field);
    can_give_way(wall) && matches!(field, "wall.foot" | "wall.drain" | "wall.base")
}

/// The pot with the nearest ring and drain, of those that are tried, with which it passes every check at the usual tolerance, where it is refused with those that are asked for; `None` where it is refused without them too. `refused` is the pot
/// as it is asked for, if it has faces, and `scale` from model units to millimetres.
///
/// A ring gives way before a drain does, and neither is left out. A coarse mesh decides which is worth one that keeps the tolerance, and what one ring is refused for rules out others.
pub(super) fn fitted(skin: &Arc<Skin>, asked: &Wall, refused: Option<&Pot>, scale: f64) -> Option<Made> {
    // A tube has no base under which a ring could stand or through which a drain could go, and a round bottom no edge for a ring.
    if !(asked.base > 0.0) || (skin.poles()[0] && asked.foot.is_some()) {
        return None;
    }
    let plain = Wall { foot: None, drain: 0.0, ..*asked };
    // A pot that has faces has the thickness of all that are tried.
    let plain = refused.map_or_else(|| Pot::of(skin, Some(plain)), |pot| pot.with_foot_of(plain)).ok()?;
    let mut trials = Trials { plain, scale, left: TRIALS };
    trials.seen(&trials.plain).ok()?;
    let largest = LARGEST * skin.size();
    let drains = if asked.drain > 0.0 { &DRAINS[..] } else { &[0.0] };
    for drain in drains.iter().map(|factor| scaled(asked.drain, asked.drain.min(skin.size()), *factor)) {
        let bare = Wall { foot: None, drain, ..*asked };
        let found = match asked.foot {
            None if bare == *asked => None,
            None => trials.made(bare).ok(),
            Some(ring) => {
                let is_bare_seen = drain == 0.0 || trials.tried(bare).is_ok();
                is_bare_seen.then(|| trials.ringed(&bare, ring, largest, drain != asked.drain)).flatten()
            }
        };
        if found.is_some() {
            return found;
        }
    }
    None
}

/// What is tried, as long as there are trials left.
struct Trials {
    /// Without ring and drain.
    plain: Pot,
    scale: f64,
    left: [usize; 2],
}

impl Trials {
    /// The pot with the nearest ring; `with_asked` where the very one that is asked for is among those that are tried.
    fn ringed(&mut self, bare: &Wall, asked: [f64; 2], largest: f64, with_asked: bool) -> Option<Made> {
        let mut ruled_out: Vec<Bounds> = Vec::new();
        for ring in nearest(asked, largest) {
            if (ring == asked && !with_asked) || ruled_out.iter().any(|bounds| bounds.hold(ring)) {
                continue;
            }
            match self.made(Wall { foot: Some(ring), ..*bare }) {
                Ok(made) => return Some(made),
                Err(Some(error)) => ruled_out.push(Bounds::of(ring, &error)),
                Err(None) => return None,
            }
        }
        None
    }

    /// A wall that passes on a coarse mesh and at the usual tolerance; what it is refused for, or nothing where no trial is left.
    fn made(&mut self, wall: Wall) -> Result<Made, Option<Error>> {
        self.tried(wall)?;
        if self.left[1] == 0 {
            return Err(None);
        }
        self.left[1] -= 1;
        let pot = Pot::of(self.plain.shared_skin(), Some(wall))?;
        Made::at_once(pot, self.scale).map_err(|refused| Some(refused.1))
    }

    /// Whether a wall passes on a coarse mesh.
    fn tried(&mut self, wall: Wall) -> Result<(), Option<Error>> {
        let pot = self.plain.with_foot_of(wall)?;
        if self.left[0] == 0 {
            return Err(None);
        }
        self.left[0] -= 1;
        Ok(self.seen(&pot)?)
    }

    fn seen(&self, pot: &Pot) -> Result<(), Error> {
        glimpsed(pot, GLIMPSE * pot.skin().size(), self.scale).map(drop)
    }
}

/// A length in place of one that is asked for: itself, or so much of the one that it is sought from.
fn scaled(asked: f64, from: f64, factor: f64) -> f64 {
    if factor == 1.0 && from == asked { asked } else { significant(from * factor, DIGITS) }
}

/// Rings that may do instead of one, itself among them, the nearest first: those whose width and height differ by the smallest factors.
fn nearest([width, height]: [f64; 2], largest: f64) -> Vec<[f64; 2]> {
    let all = WIDTHS.into_iter().flat_map(|wider| HEIGHTS.map(|higher| [wider, higher]));
    let mut all: Vec<(f64, [f64; 2])> = all
        .map(|[wider, higher]| {
            let change = libm::log(wider).abs() + libm::log(higher).abs();
            (change, [scaled(width, width.min(largest), wider), scaled(height, height.min(largest), higher)])
        })
        .filter(|(_, ring)| ring.iter().all(|length| *length > 0.0))
        .collect();
    all.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    all.into_iter().map(|(_, ring)| ring).collect()
}

/// Widths and heights from and to which no ring has room, because one is refused.
struct Bounds {
    widths: [f64; 2],
    heights: [f64; 2],
}

impl Bounds {
    /// What is ruled out by what a ring is refused for.
    fn of([width, height]: [f64; 2], error: &Error) -> Bounds {
        let (all, from) = ([0.0, f64::INFINITY], |length: f64| [length, f64::INFINITY]);
        let is_crossing = error.arg("what") == Some(&"crossing".into());
        let is_of = |name: &str, kinds: &[FaceKind]| {
            is_crossing && error.arg(name).is_some_and(|face| kinds.iter().any(|kind| *face == kind.name().into()))
        };
        let beneath = [FaceKind::FootRing, FaceKind::Recess, FaceKind::Underside, FaceKind::Drain];
        let through = ["face", "other"].map(|name| is_of(name, &beneath));
        match through {
            // It fills the foot, or leaves too little within it.
            [true, true] => Bounds { widths: from(width), heights: all },
            // It comes out beside itself: a wider one stands further in.
            [true, false] | [false, true] => Bounds { widths: [0.0, width], heights: from(height) },
            // The base lies too high on it.
            _ if error.path().ends_with("wall.base") => Bounds { widths: all, heights: from(height) },
            _ => Bounds { widths: from(width), heights: all },
        }
    }

    fn hold(&self, [width, height]: [f64; 2]) -> bool {
        let within = |[from, to]: [f64; 2], length: f64| from <= length && length <= to;
        within(self.widths, width) && within(self.heights, height)
    }
}
