//! Water up to a share of the depth, to be drawn while the pot round it changes.

use super::bare::Bare;
use super::capacity::Vessel;
use super::pond::Pond;
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
    let bares = (0..solution.n_parts())
        .map(|part| Ok(Bare::new(solution.workable(part)?)))
        .collect::<Result<Vec<Option<Bare>>>>()?;
    let insides: Vec<Option<Bare>> = bares.iter().map(|bare| bare.as_ref().map(Bare::inside)).collect();
    let vessels: Vec<Vessel> = insides
        .iter()
        .zip(&bares)
        .zip(pots)
        .filter_map(|((inside, bare), pot)| match (inside, bare, pot) {
            (Some(inside), _, Some(pot)) => Vessel::of_pot(pot, inside.waves()).ok(),
            (Some(inside), Some(bare), None) => Vessel::of_bare(inside, bare).ok(),
            _ => None,
        })
        .collect();
    let ponds: Vec<Vec<Pond>> = vessels.iter().filter_map(|vessel| vessel.ponds().ok()).collect();
    let main = || ponds.iter().filter_map(|ponds| ponds.first());
    let floor = main().fold(f64::INFINITY, |least, pond| least.min(pond.floor));
    let spill = main().fold(f64::NEG_INFINITY, |most, pond| most.max(pond.spill.value));
    if !(spill > floor) {
        return Ok(None);
    }
    let level = (floor + share * (spill - floor)).min(spill);
    let mut surface = WaterSurface { level, range: [floor, spill], ..WaterSurface::default() };
    for pond in ponds.iter().flatten() {
        let level = level.min(pond.spill.value);
        if level > pond.floor {
            let edge = pond.level(level, COLUMNS.max(pond.inside.n_columns()));
            let pool = Pool::new(&edge);
            pool.add(level, &mut surface.positions, &mut surface.indices);
        }
    }
    Ok(Some(surface))
}
