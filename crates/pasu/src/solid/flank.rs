//! One side of a wall from foot to rim, cut at the corners of the profile.

use core::f64::consts::TAU;
use std::sync::Arc;

use super::crease::{Crease, no_room};
use super::sheet::{Sheet, Trim, Trimmed, WallSide};
use super::skin::Skin;
use super::thickness::Thickness;
use super::told::place;
use crate::design::{Wall, plain};
use crate::error::{Code, Error, Result};

/// What is left of a column between two corners is at least this part of what was there.
const LEAST: f64 = 1e-3;

/// What is below a level by no more than this part of the size is not below it, where there are corners that may lie in it.
const LEVEL: f64 = 1e-9;

/// The sheets of one side of a wall, from foot to rim, and the corners between them. There are none on the surface of the design, where neighbours simply meet.
#[derive(Debug, Clone)]
pub(super) struct Flank {
    pub(super) sheets: Vec<Arc<Sheet>>,
    pub(super) creases: Vec<Arc<Crease>>,
}

/// Why a side cannot be trimmed.
pub(super) enum Untrimmed {
    /// It ends before it begins somewhere.
    NoRoom,
    /// The edge would run across a corner.
    Refused(Error),
}

impl Flank {
    /// The surface of the design.
    pub(super) fn design(skin: &Arc<Skin>, thickness: &Arc<Thickness>) -> Flank {
        Flank::of(skin, thickness, WallSide::Design, Vec::new())
    }

    /// A surface of its own, without corners. `trimmed` has to be given the same skin.
    pub(super) fn lining(skin: &Arc<Skin>, thickness: &Arc<Thickness>) -> Flank {
        Flank::of(skin, thickness, WallSide::Lining, Vec::new())
    }

    /// The surface at a distance from it.
    ///
    /// # Errors
    /// `no-room` where it cannot go round a corner.
    pub(super) fn offset(skin: &Arc<Skin>, thickness: &Arc<Thickness>, wall: &Wall, direction: f64) -> Result<Flank> {
        let creases = skin.stretches().array_windows().map(|pair| Crease::new(skin, thickness, wall, direction, *pair));
        let creases = creases.map(|crease| crease.map(Arc::new)).collect::<Result<Vec<_>>>()?;
        let flank = Flank::of(skin, thickness, WallSide::Offset { direction }, creases);
        for sheet in &flank.sheets {
            let all = sheet.stretch();
            let is_short = |v: f64| !(sheet.end(v).s - sheet.start(v).s >= LEAST * (all.to - all.from));
            if let Some(v) = skin.round().find(|v| is_short(*v)) {
                // The corner at its end, or that at its beginning where there is none.
                let stretches = skin.stretches();
                let below = if all.to < 1.0 { &all } else { stretches.iter().rev().nth(1).unwrap_or(&all) };
                return Err(no_room(skin, wall, below, v));
            }
        }
        Ok(flank)
    }

    fn of(skin: &Arc<Skin>, thickness: &Arc<Thickness>, face: WallSide, creases: Vec<Arc<Crease>>) -> Flank {
        let mut flank = Flank { sheets: Vec::new(), creases };
        flank.sheets = (0..skin.stretches().len()).map(|k| Arc::new(flank.sheet(skin, thickness, face, k))).collect();
        flank
    }

    fn sheet(&self, skin: &Arc<Skin>, thickness: &Arc<Thickness>, face: WallSide, number: usize) -> Sheet {
        let crease = |number: Option<usize>| number.and_then(|number| self.creases.get(number)).cloned();
        let creases = [crease(number.checked_sub(1)), crease(Some(number))];
        Sheet::between(skin, thickness, face, skin.stretches()[number], creases)
    }

    /// The same from where it rises, for the last time, above a level or out of a cylinder.
    pub(super) fn trimmed(
        mut self,
        skin: &Arc<Skin>,
        thickness: &Arc<Thickness>,
        face: WallSide,
        trim: Trim,
    ) -> core::result::Result<Flank, Untrimmed> {
        if trim == Trim::Foot {
            return Ok(self);
        }
        let last = self.sheets.len() - 1;
        let slack = if last == 0 { 0.0 } else { LEVEL * skin.size() };
        for number in (0..=last).rev() {
            let (sheet, what) = self.sheet(skin, thickness, face, number).trimmed(trim, slack);
            match what {
                Trimmed::There { cut: None, .. } if number > 0 => {}
                Trimmed::There { above: Some(v), .. } if number > 0 => {
                    return Err(Untrimmed::Refused(across(skin, trim, number - 1, v)));
                }
                Trimmed::There { .. } => {
                    self.sheets[number] = Arc::new(sheet);
                    self.sheets.drain(..number);
                    self.creases.drain(..number.min(self.creases.len()));
                    return Ok(self);
                }
                _ if number == last => return Err(Untrimmed::NoRoom),
                Trimmed::Away => return Err(Untrimmed::Refused(across(skin, trim, number, 0.0))),
                Trimmed::Across(v) => return Err(Untrimmed::Refused(across(skin, trim, number, v))),
            }
        }
        Ok(self)
    }

    /// The lowest.
    pub(super) fn first(&self) -> &Arc<Sheet> {
        &self.sheets[0]
    }

    /// The highest.
    pub(super) fn last(&self) -> &Arc<Sheet> {
        &self.sheets[self.sheets.len() - 1]
    }
}

/// That the edge of a floor or a drain would run across the corner above stretch number `below`.
fn across(skin: &Skin, trim: Trim, below: usize, v: f64) -> Error {
    let stretch = &skin.stretches()[below];
    let at = skin.second(stretch.to, v % TAU).position;
    let ring = stretch.corner(true, skin.is_upward());
    let (field, edge) = if matches!(trim, Trim::Cylinder(_)) { ("wall.drain", "drain") } else { ("wall.base", "base") };
    let message = format!(
        "the {edge} ends in the sharp ring u = {} at {}: expected one that ends above or below it",
        plain(ring),
        place(at)
    );
    let error = Error::new(Code::NoRoom, skin.placed().path(field), message).near(at.to_array());
    error.with("what", "ends-in-ring").with("ring", ring)
}
