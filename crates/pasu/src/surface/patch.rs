//! A two-sided surface as a patch: `v` runs once round it.

use glam::DVec3;

use super::circle::of_turns;
use super::circumference::length;
use super::recent::KeptRow;
use super::row_table::RowTable;
use super::solve::Surface;
use crate::numeric::taylor;
use crate::patch::{Breaks, Cell, Columns, Patch, Row, Side, Spread, Suprema, SurfaceJet, normal_limit};

/// An end whose coefficients are all this small beside the largest is a point.
const POINT: f64 = 1e-12;

/// A row of coefficients, asked by turns.
struct SurfaceRow<'a> {
    table: KeptRow<'a>,
    surface: &'a Surface,
}

impl Row for SurfaceRow<'_> {
    fn length(&self) -> f64 {
        self.surface.span()
    }

    fn jet(&self, v: f64) -> SurfaceJet {
        let circles = self.surface.circles(v);
        self.table.jet(|n| circles.get(n).copied().unwrap_or((1.0, 0.0)))
    }

    fn jet_at(&self, columns: &Columns, column: usize) -> SurfaceJet {
        let circles = columns.pairs(column, self.surface.distinct().len());
        self.table.jet(|n| circles.get(n).copied().unwrap_or((1.0, 0.0)))
    }
}

impl Patch for Surface {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        self.row(u).jet(v).stretched(1.0, self.span())
    }

    fn row(&self, u: f64) -> Box<dyn Row + '_> {
        Box::new(SurfaceRow { table: self.row_table(u), surface: self })
    }

    fn row_along(&self, u: f64, between: [f64; 2]) -> Box<dyn Row + '_> {
        Box::new(SurfaceRow { table: self.row_table_along(u, between), surface: self })
    }

    fn columns(&self, spread: Spread) -> Columns {
        let even = |n: f64, j: usize, parts: usize| of_turns(libm::fmod(n * j as f64, parts as f64) / parts as f64);
        let circles = match spread {
            Spread::Even(parts) => {
                (0..parts).flat_map(|j| self.distinct().iter().map(move |n| even(*n, j, parts))).collect()
            }
            Spread::At(places) => places.iter().flat_map(|turns| self.circles(*turns)).collect(),
        };
        Columns::with_pairs(spread, circles)
    }

    /// Amplitudes of all modes added up, whatever `v`: a bound that decays with the modes from the boundary that they come from. Where there are no rings it is tightened by Taylor's formula about the middle of the cell, because
    /// what cancels in a mode counts many times in the bound of its parts.
    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        let is_smooth = self.rings().next().is_none();
        let (middle, half) = (0.5 * (cell.u[0] + cell.u[1]), 0.5 * (cell.u[1] - cell.u[0]));
        let mut sums = [[0.0; 3]; 4];
        for (axis, terms) in self.components().iter().enumerate() {
            for term in terms {
                let k = (term.k * self.span()).abs();
                let data = [&term.cos, &term.sin];
                let mut bounds = term.beam.suprema::<5, 2>(data, cell.u[0], cell.u[1]);
                if is_smooth {
                    let jets = term.beam.jets::<5, 2>(data, middle);
                    for (bound, jet) in bounds.iter_mut().zip(&jets) {
                        taylor::tighten(bound, jet, half);
                    }
                }
                let [a, b] = bounds;
                let [value, u, uu] = [0, 1, 2].map(|order| libm::hypot(a[order], b[order]) * stretch[axis].abs());
                for (sum, bound) in sums.iter_mut().zip([value, uu, k * u, k * k * value]) {
                    sum[axis] += bound;
                }
            }
        }
        let [size, uu, uv, vv] = sums.map(length);
        Suprema { size, uu, uv, vv }
    }

    fn is_alike_round(&self) -> bool {
        true
    }

    fn n_terms(&self) -> usize {
        Surface::n_terms(self)
    }

    fn breaks(&self) -> [Breaks; 2] {
        let waves = self.distinct().iter().fold(0.0f64, |highest, n| highest.max(n.abs()));
        let terms = self.components().iter().flatten();
        let rate = terms.fold(0.0f64, |fastest, term| fastest.max(term.beam.largest_rate()));
        let knots = self.rings().map(|(u, _)| u).collect();
        [Breaks { knots, rate, ..Breaks::smooth(1.0) }, Breaks::smooth(waves)]
    }

    fn sides(&self) -> [Side; 4] {
        let round = if self.is_closed() { Side::Joined } else { Side::Free };
        let rows = [0.0, 1.0].map(|u| self.row_table(u));
        let all = |row: &RowTable<3>, is_wave: fn(f64) -> bool| {
            let terms = row.components.iter().flatten().filter(|term| is_wave(term.k));
            terms.fold(0.0f64, |most, term| most.max(term.cos[0].abs()).max(term.sin[0].abs()))
        };
        let largest = rows.iter().map(|row| all(row, |_| true)).fold(0.0, f64::max);
        let [start, end] =
            rows.each_ref().map(|row| if all(row, |k| k != 0.0) <= POINT * largest { Side::Pole } else { Side::Free });
        [start, end, round, round]
    }

    fn normal_limit(&self, u: f64, v: f64) -> Option<DVec3> {
        normal_limit(&Patch::jet(self, u, v), (u, v), |u, v| self.at(u, v * self.span()))
    }
}
