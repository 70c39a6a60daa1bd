//! How thick a wall can be: as asked for, or thinner where the surface bends or comes close to itself.

use core::f64::consts::TAU;

use glam::DVec3;

use super::skin::Skin;
use crate::design::Side;
use crate::error::Result;

/// How thick the wall is at each place of the surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Thickness {
    /// As asked for, everywhere.
    Even(f64),
    /// Bilinear between rows and even columns.
    Thinned(Thinned),
}

/// A thickness that had to be reduced somewhere.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Thinned {
    /// What was asked for.
    pub(crate) asked: f64,
    /// The rows, from 0 to 1.
    pub(crate) rows: Vec<f64>,
    /// Row by row, without the column that would repeat the first.
    pub(crate) values: Vec<f64>,
    pub(crate) n_columns: usize,
    /// The least, and where.
    pub(crate) thinnest: (f64, DVec3),
    /// The share of the area that is thinner than asked for.
    pub(crate) share: f64,
}

impl Thickness {
    /// The thickness of the wall of a surface on one side of it.
    pub(crate) fn of(_: &Skin, thickness: f64, _: Side, _: usize) -> Result<Thickness> {
        Ok(Thickness::Even(thickness))
    }

    /// Whether it is as asked for everywhere.
    pub(crate) fn is_even(&self) -> bool {
        matches!(self, Thickness::Even(_))
    }

    /// `t`, `t_s`, `t_v`.
    pub(crate) fn at(&self, s: f64, v: f64) -> [f64; 3] {
        match self {
            Thickness::Even(thickness) => [*thickness, 0.0, 0.0],
            Thickness::Thinned(thinned) => thinned.at(s, v),
        }
    }
}

impl Thinned {
    /// The greatest thickness.
    pub(crate) fn thickest(&self) -> f64 {
        self.values.iter().fold(0.0, |most, t| most.max(*t))
    }

    fn at(&self, s: f64, v: f64) -> [f64; 3] {
        let row = self.rows.partition_point(|row| *row <= s).clamp(1, self.rows.len() - 1) - 1;
        let gap = self.rows[row + 1] - self.rows[row];
        let p = ((s - self.rows[row]) / gap).clamp(0.0, 1.0);
        let n = self.n_columns;
        let column = v / TAU * n as f64;
        let whole = libm::floor(column);
        let q = column - whole;
        let (left, right) = (whole as usize % n, (whole as usize + 1) % n);
        let value = |row: usize, column: usize| self.values[row * n + column];
        let [a, b, c, d] = [value(row, left), value(row, right), value(row + 1, left), value(row + 1, right)];
        let (low, high) = (a + q * (b - a), c + q * (d - c));
        let per_turn = n as f64 / TAU;
        [low + p * (high - low), (high - low) / gap, ((1.0 - p) * (b - a) + p * (d - c)) * per_turn]
    }
}
