//! Rows that are copies of one another, written many at a time.
//!
//! Such a row is hardly more than its stores. What is computed between two rows would have to wait until memory has taken the first, and memory for it in turn: a third of the time of a large mesh.

use super::copy::{Circle, Original};
use super::outline::{Outline, OutlineRow};
use super::ring::{Pattern, RingRow};
use super::waves::Waves;
use crate::surface::Turns;

/// Rows that wait before they are written: enough that the way there and back is nothing beside them.
const MOST_WAITING: usize = 64;

/// The tables that copies are made from, and the rows that wait to be written.
#[derive(Debug, Default)]
pub(super) struct Copies {
    /// What copies are of.
    pub(super) original: Original,
    pattern: Pattern,
    outline: Outline,
    /// Whether the surface has an outline, once that was asked.
    has_outline: Option<bool>,
    waiting: Vec<(usize, Row)>,
}

#[derive(Debug, Clone, Copy)]
enum Row {
    Ring(RingRow),
    Outline(OutlineRow),
}

impl Copies {
    /// Takes another surface, whose original has been found.
    pub(super) fn prepare(&mut self, waves: &Waves, turns: &Turns, n_columns: usize) {
        self.has_outline = None;
        self.waiting.clear();
        if let [harmonic] = waves.harmonics.as_slice() {
            self.pattern.prepare(harmonic.n, n_columns, turns);
        }
    }

    /// Takes row `index` of the mesh, which is one of the four of the waves, normals times `sign`; false where it is no copy, or single precision may not hold it.
    pub(super) fn take(
        &mut self,
        waves: &Waves,
        turns: &Turns,
        (index, row): (usize, usize),
        n_columns: usize,
        largest: f64,
        sign: f64,
    ) -> bool {
        let ring = Circle::of(waves, row).and_then(|circle| RingRow::of(&circle, largest, sign));
        let row = ring.map(Row::Ring).or_else(|| {
            let Copies { original, outline, has_outline, .. } = self;
            let copy = original.scaled(waves, row)?;
            let has_outline =
                *has_outline.get_or_insert_with(|| outline.prepare(original, &waves.harmonics, turns, n_columns));
            outline.row(&copy, largest, sign).filter(|_| has_outline).map(Row::Outline)
        });
        self.waiting.extend(row.map(|row| (index, row)));
        row.is_some()
    }

    /// Writes the rows that wait if they are many, or the last ones.
    pub(super) fn write(&mut self, are_last: bool, n_columns: usize, positions: &mut [f32], normals: &mut [f32]) {
        if self.waiting.len() < MOST_WAITING && !are_last {
            return;
        }
        for (index, row) in self.waiting.drain(..) {
            let range = 3 * n_columns * index..3 * n_columns * (index + 1);
            if let (Some(positions), Some(normals)) = (positions.get_mut(range.clone()), normals.get_mut(range)) {
                match row {
                    Row::Ring(row) => self.pattern.write(&row, positions, normals),
                    Row::Outline(row) => self.outline.write(&row, positions, normals),
                }
            }
        }
    }
}
