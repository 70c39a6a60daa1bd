//! How the border of a part lies to an octant, by the formula of that: what is bent without bound along the edges of the octant needs no tiles.

use glam::DVec3;

use super::budget::Budget;
use super::space::Space;
use super::tile::Tile;

/// The most tiles of the other part that are held against the octant.
const MOST: u64 = 5000;

/// So many count for as much as a pair of tiles: a formula is asked for each.
const TILES: u64 = 2;

/// How all of a border lies to an octant.
#[derive(Debug, Clone, Copy)]
pub(super) enum Beside {
    /// All of it is further away than the slack.
    Missed,
    /// This place of it is so deep in the octant at least.
    Deep { at: DVec3, depth: f64 },
}

impl Space {
    /// Whether all of the border of this part is further from an octant than the slack, or a place of it deep in that; `None` where neither is known. Tiles that may be nearer are halved until they are as small as the slack.
    pub(super) fn beside_octant(&self, octant: &Space, slack: f64, budget: &mut Budget) -> Option<Beside> {
        let near = octant.bounds.wider(slack);
        let mut open: Vec<Tile> = Vec::new();
        self.tiles().boxes.each(|bounds| bounds.distance(&near) == 0.0, |tile| open.push(self.tiles().all[tile]));
        let mut n_asked = 0;
        while let Some(tile) = open.pop() {
            n_asked += 1;
            if n_asked > MOST || (n_asked % TILES == 0 && !budget.take(1)) {
                return None;
            }
            if octant.is_missed_by_formula(&tile, slack) {
                continue;
            }
            let deep = tile.corners.iter().find_map(|at| Some((*at, octant.depth_by_formula(*at, slack)?)));
            if let Some((at, depth)) = deep {
                return Some(Beside::Deep { at, depth });
            }
            let halves = (tile.size() > slack).then(|| tile.halves(&self.borders)).flatten();
            open.extend(halves?);
        }
        Some(Beside::Missed)
    }
}
