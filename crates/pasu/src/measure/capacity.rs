//! How much a pot holds.

use core::f64::consts::TAU;

use super::accuracy::Accuracy;
use super::bare::{Bare, Cap};
use super::column::Inside;
use super::fill::{Filling, Level};
use super::quantity::Quantity;
use crate::answer::answers;
use crate::face::{Face, FaceKind};
use crate::solid::Pot;

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

/// Columns of a curve that is closed by a cone.
fn closing_columns(highest: f64) -> usize {
    4 * highest.clamp(1.0, 1e4) as usize + 13
}

/// The faces that water touches, from the middle of the floor to the rim.
pub(crate) struct Vessel<'a> {
    faces: Vec<&'a dyn Face>,
    cap: Option<Cap<'a>>,
    is_stopped: bool,
    axis: glam::DVec3,
    highest: f64,
}

impl<'a> Vessel<'a> {
    /// The inside of a pot; the reason in words where it holds nothing.
    pub(crate) fn of_pot(pot: &'a Pot, highest: f64) -> Result<Vessel<'a>, String> {
        let faces: Vec<&dyn Face> = pot
            .faces()
            .iter()
            .rev()
            .map(|piece| piece as &dyn Face)
            .filter(|face| matches!(face.kind(), FaceKind::Floor | FaceKind::Lining | FaceKind::Rim))
            .collect();
        let is_stopped = pot.faces().iter().any(|face| face.kind() == FaceKind::Drain);
        if pot.is_ring() && !is_stopped {
            return Err("a tube has no bottom to hold anything: give the wall a base greater than 0".to_owned());
        }
        if !faces.iter().any(|face| face.kind() == FaceKind::Lining) {
            return Err("a solid has no inside".to_owned());
        }
        let first = faces.first().copied();
        let cap = first.filter(|_| is_stopped).map(|face| Cap::new(face, 1.0, closing_columns(highest)));
        Ok(Vessel { faces, cap, is_stopped, axis: pot.axis(), highest })
    }

    /// A surface taken as a wall of zero thickness, closed at the foot by a cone; the reason in words where it holds nothing. The surface must be one seen from [inside](Bare::inside).
    pub(crate) fn of_bare(bare: &'a Bare) -> Result<Vessel<'a>, String> {
        if !bare.is_closed() {
            return Err("the surface does not close round the axis, so it holds nothing".to_owned());
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
            return Err(
                "the surface closes to a point where the opening of a pot is, so nothing can be filled in".to_owned()
            );
        }
        let cap = (width(0.0) > 1e-9 * widest).then(|| Cap::new(bare, 0.0, closing_columns(highest)));
        Ok(Vessel { faces: vec![bare], cap, is_stopped: false, axis: bare.axis(), highest })
    }

    /// The chain of faces for columns.
    pub(crate) fn inside(&self) -> Inside<'_> {
        let cap = self.cap.iter().map(|cap| cap as &dyn Face);
        let faces: Vec<&dyn Face> = cap.chain(self.faces.iter().copied()).collect();
        Inside::new(&faces, self.axis, self.highest)
    }

    /// What it holds, and the water at the brim.
    pub(crate) fn capacity(&self, accuracy: &Accuracy, fill: Option<f64>) -> (Capacity, Filling) {
        let inside = self.inside();
        let (level, at) = inside.spill();
        let floor = inside.floor();
        let water = |z: f64| {
            if z > floor { Level::new(&inside, z, inside.n_columns()).filling(accuracy) } else { Filling::default() }
        };
        let full = water(level);
        let fill = fill.map(|fill| fill.min(level)).map(|level| Fill { level, volume: water(level).moments.volume });
        let capacity = Capacity {
            brim: full.moments.volume,
            spill: Spill { level: Quantity::rounded(level, inside.size()), at: at.to_array() },
            floor,
            fill,
            stopped: self.is_stopped,
        };
        (capacity, full)
    }
}
