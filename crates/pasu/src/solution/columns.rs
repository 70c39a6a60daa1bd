//! Angles that many rows have in common.

use core::f64::consts::TAU;

use crate::patch::{self, Patch, Spread};

/// Values of `v` in [0, 2 pi], with what a patch made of them beforehand.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Columns {
    places: Vec<f64>,
    columns: patch::Columns,
}

impl Columns {
    /// Nothing but the values.
    pub(crate) fn plain(places: Vec<f64>) -> Columns {
        Columns { places, columns: patch::Columns::default() }
    }

    /// `n` even ones.
    pub(super) fn even(patch: &dyn Patch, n: usize) -> Columns {
        let places = (0..n).map(|j| TAU * j as f64 / n as f64).collect();
        Columns { places, columns: patch.columns(Spread::Even(n)) }
    }

    /// Those given.
    pub(super) fn at(patch: &dyn Patch, places: Vec<f64>) -> Columns {
        let turns: Vec<f64> = places.iter().map(|v| v / TAU).collect();
        Columns { places, columns: patch.columns(Spread::At(&turns)) }
    }

    /// The number of columns.
    pub(crate) fn len(&self) -> usize {
        self.places.len()
    }

    /// `v` of a column.
    pub(crate) fn v(&self, column: usize) -> f64 {
        self.places.get(column).copied().unwrap_or(0.0)
    }

    /// As the patch knows them.
    pub(super) fn of_patch(&self) -> &patch::Columns {
        &self.columns
    }
}
