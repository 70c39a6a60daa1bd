//! Water standing in a design, to be drawn.

use super::accuracy::Accuracy;
use super::capacity::{MOST_WORK, too_long};
use super::design::above_spill;
use super::dry::Dry;
use super::pond::Pond;
use super::pool::Pool;
use super::taken::Taken;
use crate::design::{Design, plain};
use crate::error::{Code, Error, Result};
use crate::solid::Product;
use crate::solution::Solution;
use crate::watch;

/// Water up to a level.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Water {
    /// Its volume in model units cubed.
    pub volume: f64,
    /// How far the volume may be off.
    pub error: f64,
    /// The area of its surface.
    pub area: f64,
    /// `x, y, z` of each vertex of its surface, in model units after placement.
    pub positions: Vec<f32>,
    /// Three vertex numbers per triangle, counter-clockwise from above.
    pub indices: Vec<u32>,
}

/// The relative error that is asked of the volume: water is dragged, and is to be drawn at once.
const ACCURACY: f64 = 1e-6;

/// The fewest columns that draw the water's edge.
const COLUMNS: usize = 192;

/// The water in a design that is filled to a level, the `z` of the world: its volume and its surface.
///
/// Below the floor there is none. Every hollow of the inside is filled; parts that hold nothing are passed over. Among several parts one whose spill point is below the level overflows, and
/// stands full. A part without a wall is taken as one of zero thickness, as [`measure`](crate::measure) does.
///
/// # Errors
/// `out-of-range` for a level that is not finite or above every spill point, the highest of which is in the message; `no-room` for a design that holds nothing, with the reason; what
/// [`Surface::solve`](crate::Surface::solve) refuses.
///
/// ```
/// // A cylinder of radius 3 and height 4, with a wall of 0.5 and a base of 1.
/// # let cup = pasu::Design::parse(
/// #     r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0, 3, 0], "t": [0, 0], "n": [1, 2], "height": 4 },
/// #     "wall": { "thickness": 0.5, "base": 1 } }] }"#,
/// # )?;
/// // The floor is at 1.
/// let water = pasu::water(&cup, 2.0)?;
/// assert!((water.volume - std::f64::consts::PI * 2.5 * 2.5).abs() <= water.error);
/// # Ok::<(), pasu::Error>(())
/// ```
pub fn water(design: &Design, level: f64) -> Result<Water> {
    Solution::of(design).water(level)
}

impl Solution {
    /// As [`water`].
    ///
    /// # Errors
    /// As [`water`].
    pub fn water(&self, level: f64) -> Result<Water> {
        standing(self, level)
    }
}

fn standing(solution: &Solution, level: f64) -> Result<Water> {
    if !level.is_finite() {
        let message = format!("expected a level, found {}", plain(level));
        return Err(Error::new(Code::OutOfRange, "level", message).with("found", level));
    }
    let mut water = Water::default();
    let mut highest: Option<(f64, f64)> = None;
    let mut refusal = None;
    for (index, part) in solution.design().parts().iter().enumerate() {
        let taken = Taken::new(solution, index, Product::Pot)?;
        let mut refused = |dry: Dry| {
            let error = Error::new(Code::NoRoom, format!("parts[{index}]"), dry.message);
            refusal.get_or_insert(error.with("what", dry.cause.code));
        };
        let vessel = match taken.vessel(part.wall.is_some(), Product::Pot) {
            Ok(vessel) => vessel,
            Err(dry) => {
                refused(dry);
                continue;
            }
        };
        let ponds = match vessel.ponds() {
            Ok(ponds) => ponds,
            Err(dry) => {
                refused(dry);
                continue;
            }
        };
        if let Some(Pond { spill, .. }) = ponds.first()
            && highest.is_none_or(|highest| spill.value > highest.0)
        {
            highest = Some((spill.value, spill.error));
        }
        let accuracy = Accuracy {
            relative: ACCURACY,
            seamed: ACCURACY,
            most_columns: 4096,
            most_intervals: 16,
            ..taken.accuracy()
        };
        for pond in &ponds {
            let level = level.min(pond.spill.value);
            if !(level > pond.floor) {
                continue;
            }
            let drawn = watch::within(MOST_WORK, || {
                let edge = pond.level(level, COLUMNS.max(pond.inside.n_columns()));
                (edge.filling(&accuracy), Pool::new(&edge))
            });
            watch::go_on()?;
            let Some((filling, pool)) = drawn else {
                let dry = too_long();
                let error = Error::new(Code::NoRoom, format!("parts[{index}]"), dry.message);
                return Err(error.with("what", dry.cause.code));
            };
            water.volume += filling.moments.volume.value;
            water.error += filling.moments.volume.error;
            water.area += filling.area.value;
            pool.add(level, &mut water.positions, &mut water.indices);
        }
    }
    match (highest, refusal) {
        (Some((spill, slack)), _) if level > spill + slack => Err(above_spill("level", level, spill)),
        (None, Some(refusal)) => Err(refusal),
        _ => Ok(water),
    }
}
