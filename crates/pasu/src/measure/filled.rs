//! Water up to a share of the depth, to be drawn while the pot round it changes.

use super::bare::Bare;
use super::capacity::Vessel;
use super::column::Inside;
use super::fill::Level;
use super::pool::Pool;
use crate::error::Result;
use crate::solid::Pot;
use crate::solution::Solution;

/// A level surface of water.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct WaterSurface {
    /// Its height in model units, the `z` of the world.
    pub level: f64,
    /// The level of the lowest point inside, and that at which water runs out.
    pub range: [f64; 2],
    /// `x, y, z` of each vertex, in model units after placement.
    pub positions: Vec<f32>,
    /// Three vertex numbers per triangle, counter-clockwise from above.
    pub indices: Vec<u32>,
}

/// The fewest columns that draw the water's edge.
const COLUMNS: usize = 96;

/// The water in a design whose pots are made already, part by part, and which is filled to a share of the depth. Parts without a pot are taken as in [`water`](crate::water());
/// `None` where nothing holds any.
///
/// # Errors
/// What [`Surface::solve`](crate::Surface::solve) refuses.
pub(crate) fn filled(solution: &Solution, pots: &[Option<Pot>], share: f64) -> Result<Option<WaterSurface>> {
    let bares = solution.parts().map(|placed| Ok(Bare::new(placed?))).collect::<Result<Vec<Option<Bare>>>>()?;
    let insides: Vec<Option<Bare>> = bares.iter().map(|bare| bare.as_ref().map(Bare::inside)).collect();
    let vessels: Vec<Vessel> = insides
        .iter()
        .zip(pots)
        .filter_map(|(inside, pot)| match (inside, pot) {
            (Some(inside), Some(pot)) => Vessel::of_pot(pot, inside.waves()).ok(),
            (Some(inside), None) => Vessel::of_bare(inside).ok(),
            (None, _) => None,
        })
        .collect();
    let insides: Vec<(Inside, f64, f64)> = vessels
        .iter()
        .map(Vessel::inside)
        .map(|inside| {
            let (floor, (spill, _)) = (inside.floor(), inside.spill());
            (inside, floor, spill)
        })
        .collect();
    let floor = insides.iter().fold(f64::INFINITY, |least, (_, floor, _)| least.min(*floor));
    let spill = insides.iter().fold(f64::NEG_INFINITY, |most, (.., spill)| most.max(*spill));
    if !(spill > floor) {
        return Ok(None);
    }
    let level = (floor + share * (spill - floor)).min(spill);
    let mut surface = WaterSurface { level, range: [floor, spill], ..WaterSurface::default() };
    for (inside, floor, spill) in &insides {
        let level = level.min(*spill);
        if level > *floor {
            let edge = Level::new(inside, level, COLUMNS.max(inside.n_columns()));
            let pool = Pool::new(&edge);
            pool.add(level, &mut surface.positions, &mut surface.indices);
        }
    }
    Ok(Some(surface))
}
