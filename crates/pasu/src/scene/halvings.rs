//! Halves of the tiles of a border, kept for whoever asks for the same again.

use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::sync::{Mutex, PoisonError};

use super::border::Border;
use super::tile::Tile;
use crate::numeric::scattered::Scatter;
use crate::patch::Cell;

/// The most of a part that are kept, each of two tiles: so many rays go through twice as many.
const MOST: usize = 1024;

/// A tile, by its piece of the border and the bits of its cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Key([u64; 5]);

impl Key {
    fn of(tile: &Tile) -> Key {
        let Cell { u: [u0, u1], v: [v0, v1] } = tile.cell;
        Key([tile.border as u64, u0.to_bits(), u1.to_bits(), v0.to_bits(), v1.to_bits()])
    }
}

impl Hash for Key {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.iter().for_each(|bits| state.write_u64(*bits));
    }
}

/// What tiles of one border were halved into. It follows from the border, so that whether it is kept changes nothing but the time.
#[derive(Debug, Default)]
pub(super) struct Halvings(Mutex<HashMap<Key, [Tile; 2], Scatter>>);

impl Halvings {
    /// As [`Tile::halves`].
    pub(super) fn of(&self, tile: &Tile, borders: &[Border]) -> Option<[Tile; 2]> {
        let key = Key::of(tile);
        // What a thread left that panicked holds whole entries only.
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).get(&key).copied();
        if known.is_some() {
            return known;
        }
        let halves = tile.halves(borders)?;
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.len() < MOST {
            kept.insert(key, halves);
        }
        Some(halves)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Design;
    use crate::scene::{Hit, Ray};
    use crate::solution::Solution;

    #[test]
    fn what_was_asked_before_changes_no_bit() {
        let design = Design::parse(
            r#"{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": [3, 0.1, 3.5, 0.3], "t": [0.4, 0], "n": [1, 5], "height": 4 },
                "wall": { "thickness": 0.2, "base": 0.4 }, "place": { "axis": [1, 0, 0], "angle": 0.3, "shift": [1, 2, 3] } }] }"#,
        )
        .unwrap();
        let (first, second) = (Solution::of(&design), Solution::of(&design));
        let asked = |solution: &Solution, i: u32| -> Vec<Hit> {
            let turn = f64::from(i) * 2.4;
            let origin = [1.0 + 6.0 * libm::cos(turn), 2.0 + 6.0 * libm::sin(turn), 3.0 + f64::from(i % 40) * 0.1];
            let direction = [1.0 - origin[0], 2.0 - origin[1], 4.5 - origin[2]];
            let mut hits = solution.pick(Ray { origin, direction }).unwrap();
            let near = hits.first().map(|hit| hit.point).unwrap_or_default();
            hits.extend(solution.at([near[0], near[1], near[2] - 0.02]).unwrap());
            hits
        };
        let forwards: Vec<_> = (0..400).map(|i| asked(&first, i)).collect();
        let mut backwards: Vec<_> = (0..400).rev().map(|i| asked(&second, i)).collect();
        backwards.reverse();
        assert_eq!(forwards, backwards);
        // So many that not all of them were kept.
        let space = first.in_space(0).unwrap();
        let kept = space.still().unwrap().0.halvings.0.lock().unwrap().len();
        assert_eq!(kept, MOST);
    }
}
