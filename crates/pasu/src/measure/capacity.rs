//! How much a pot holds.

use core::f64::consts::TAU;

use super::accuracy::Accuracy;
use super::bare::{Bare, Cap};
use super::column::Inside;
use super::dry::Dry;
use super::fill::Filling;
use super::pond::{Pond, ponds};
use super::quantity::Quantity;
use crate::answer::answers;
use crate::face::{Face, FaceKind};
use crate::solid::Pot;
use crate::watch;

/// Why there is no capacity.
fn dry() -> Dry {
    Dry::new("dry", "in this position no water stays in it")
}

/// The same of a tube.
fn no_bottom() -> Dry {
    Dry::new("no-bottom", "a tube has no bottom to hold anything: give the wall a base greater than 0")
}

answers! {
    /// What a pot holds.
    #[derive(Copy)]
    pub struct Capacity as "Capacity" {
        /// To the brim, in the position in which it is placed.
        pub brim: Quantity,
        /// Where water first runs out.
        pub spill: Spill,
        /// The `z` of the lowest point inside.
        pub floor: f64,
        /// Up to the level that was asked for.
        pub fill: Option<Fill>,
        /// Whether there is a drain hole, which is taken as stopped.
        pub stopped: bool,
    }

    /// Where water first runs out of a pot.
    #[derive(Copy)]
    pub struct Spill as "Spill" {
        /// The `z` of the water then.
        pub level: Quantity,
        /// The point.
        pub at: [f64; 3],
    }

    /// A pot that is filled to a level.
    #[derive(Copy)]
    pub struct Fill as "Fill" {
        /// The `z` of the water.
        pub level: f64,
        /// Of the water, in the unit of the design cubed.
        pub volume: Quantity,
    }
}

/// The most work on what a pot holds, and as much again up to a level, in the units of [`watch::work`]: about a second in WebAssembly.
pub(super) const MOST_WORK: u64 = 80_000_000;

/// Why nobody knows.
pub(super) fn too_long() -> Dry {
    Dry::new(
        "too-long",
        "how much it holds takes too long to find out, because the wall is folded or waved too finely: expected fewer waves, shallower ones or a thinner wall",
    )
}

/// A body whose axis rises by more than this stands upright.
const UPRIGHT: f64 = 0.5;

/// Columns of a curve that is closed by a cone.
fn closing_columns(highest: f64) -> usize {
    4 * highest.clamp(1.0, 1e4) as usize + 13
}

/// The faces that water touches, from the middle of the floor to the rim, and the others of the body, from the rim to the middle of the foot. Those of a tube go once round, from the rim at its foot.
pub(crate) struct Vessel<'a> {
    faces: Vec<&'a dyn Face>,
    outside: Vec<&'a dyn Face>,
    /// What closes the first of the faces, and the last of those outside.
    caps: [Option<Cap<'a>>; 2],
    is_stopped: bool,
    is_tube: bool,
    axis: glam::DVec3,
    highest: f64,
}

impl<'a> Vessel<'a> {
    /// The inside of a pot; the reason in words where it holds nothing.
    pub(crate) fn of_pot(pot: &'a Pot, highest: f64) -> Result<Vessel<'a>, Dry> {
        let pieces = || pot.faces().iter().rev().map(|piece| piece as &dyn Face);
        let is_stopped = pieces().any(|face| face.kind() == FaceKind::Drain);
        let is_tube = pot.is_ring() && !is_stopped;
        if is_tube {
            let (faces, outside, caps) = (pieces().collect(), Vec::new(), [None, None]);
            return Ok(Vessel { faces, outside, caps, is_stopped, is_tube, axis: pot.axis(), highest });
        }
        let is_inside = |kind: FaceKind| matches!(kind, FaceKind::Floor | FaceKind::Lining | FaceKind::Rim);
        let faces: Vec<&dyn Face> = pieces().filter(|face| is_inside(face.kind())).collect();
        if !faces.iter().any(|face| face.kind() == FaceKind::Lining) {
            return Err(Dry::new("solid", "a solid has no inside"));
        }
        let outside: Vec<&dyn Face> =
            pieces().filter(|face| !is_inside(face.kind()) && face.kind() != FaceKind::Drain).collect();
        let columns = closing_columns(highest);
        // A hole is stopped at both ends.
        let ends = [faces.first().map(|face| (*face, 1.0)), outside.last().map(|face| (*face, 0.0))];
        let caps = ends.map(|end| end.filter(|_| is_stopped).map(|(face, a)| Cap::new(face, a, columns)));
        Ok(Vessel { faces, outside, caps, is_stopped, is_tube, axis: pot.axis(), highest })
    }

    /// A surface taken as a wall of zero thickness, closed at the foot by a cone; the reason in words where it holds nothing. The first is the surface seen from [inside](Bare::inside), the second the same from outside.
    pub(crate) fn of_bare(bare: &'a Bare, outside: &'a Bare) -> Result<Vessel<'a>, Dry> {
        if !bare.is_closed() {
            return Err(Dry::new("open-surface", "the surface does not close round the axis, so it holds nothing"));
        }
        let highest = bare.waves();
        let width = |a: f64| {
            let n = closing_columns(highest);
            let centre = bare.centre(a);
            let mut walk = bare.walk();
            (0..n).map(|j| walk.jet(a, TAU * j as f64 / n as f64).position.distance(centre)).fold(0.0, f64::max)
        };
        let widest = [0.0, 0.25, 0.5, 0.75, 1.0].map(width).into_iter().fold(0.0, f64::max);
        if !(width(1.0) > 1e-9 * widest) {
            return Err(Dry::new(
                "no-opening",
                "the surface closes to a point where the opening of a pot is, so nothing can be filled in",
            ));
        }
        let is_open = width(0.0) > 1e-9 * widest;
        let caps = [bare, outside].map(|bare| is_open.then(|| Cap::new(bare, 0.0, closing_columns(highest))));
        let (faces, outside): (Vec<&dyn Face>, Vec<&dyn Face>) = (vec![bare], vec![outside]);
        Ok(Vessel { faces, outside, caps, is_stopped: false, is_tube: false, axis: bare.axis(), highest })
    }

    /// The chain of faces for columns.
    fn inside(&self) -> Inside<'_> {
        let cap = self.caps[0].iter().map(|cap| cap as &dyn Face);
        let faces: Vec<&dyn Face> = cap.chain(self.faces.iter().copied()).collect();
        Inside::new(&faces, self.axis, self.highest)
    }

    /// The chain of all faces.
    fn whole(&self) -> Inside<'_> {
        let [first, last] = self.caps.each_ref().map(|cap| cap.iter().map(|cap| cap as &dyn Face));
        let faces: Vec<&dyn Face> =
            first.chain(self.faces.iter().copied()).chain(self.outside.iter().copied()).chain(last).collect();
        let whole = Inside::new(&faces, self.axis, self.highest);
        if self.is_tube { whole.ring() } else { whole }
    }

    /// The waters that stand in it, that which holds most first; the reason in words where there are none.
    pub(crate) fn ponds(&self) -> Result<Vec<Pond<'_>>, Dry> {
        let found = ponds(self.inside(), || self.whole(), self.axis.z > UPRIGHT)?;
        if found.is_empty() { Err(if self.is_tube { no_bottom() } else { dry() }) } else { Ok(found) }
    }

    /// What it holds, and the water at the brim; the reason in words where that is nothing.
    pub(crate) fn capacity(&self, accuracy: &Accuracy, fill: Option<f64>) -> Result<(Capacity, Filling), Dry> {
        let (ponds, full) = soon(|| {
            let ponds = self.ponds()?;
            let full = filled(&ponds, accuracy, f64::INFINITY);
            Ok((ponds, full))
        })?;
        let main = ponds.first().ok_or_else(dry)?;
        let filled_to = |level: f64| {
            // To the brim is what is known already.
            let is_full = ponds.iter().all(|pond| level >= pond.spill.value);
            let water = if is_full { full } else { soon(|| Ok(filled(&ponds, accuracy, level)))? };
            Ok::<_, Dry>(Fill { level, volume: water.moments.volume })
        };
        let capacity = Capacity {
            brim: full.moments.volume,
            spill: Spill { level: main.spill, at: main.at.to_array() },
            floor: main.floor,
            fill: fill.map(|fill| filled_to(fill.min(main.spill.value))).transpose()?,
            stopped: self.is_stopped,
        };
        Ok((capacity, full))
    }
}

/// What is found within the [most work](MOST_WORK).
fn soon<T>(find: impl FnOnce() -> Result<T, Dry>) -> Result<T, Dry> {
    watch::within(MOST_WORK, find).unwrap_or_else(|| Err(too_long()))
}

/// All waters together, up to a level.
fn filled(ponds: &[Pond], accuracy: &Accuracy, z: f64) -> Filling {
    let all = ponds.iter().map(|pond| water(pond, accuracy, z));
    all.reduce(|sum, next| Filling { moments: sum.moments.plus(&next.moments), area: sum.area + next.area })
        .unwrap_or_default()
}

/// One water, up to a level.
fn water(pond: &Pond, accuracy: &Accuracy, z: f64) -> Filling {
    let level = z.min(pond.spill.value);
    if !(level > pond.floor) {
        return Filling::default();
    }
    let mut water = pond.level(level, pond.inside.n_columns()).filling(accuracy);
    // What the level is off by more than rounding is there or is missing all over the water.
    let rounding = Quantity::rounded(pond.spill.value, pond.inside.size()).error;
    if level == pond.spill.value {
        water.moments.volume.error += (pond.spill.error - rounding).max(0.0) * water.area.value.abs();
    }
    water
}
