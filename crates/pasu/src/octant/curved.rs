//! The curved side of an octant.

use glam::DVec3;

use super::climb::{Climb, Share, power};
use super::lines::Lines;
use crate::numeric::recent::Recent;
use crate::patch::{Breaks, Cell, Columns, Patch, Row, ShowCell, Side, Spread, Suprema, SurfaceJet};

/// `X(u, v)` on `x^a + y^b + z^c = 1`: `u` from the tip `z = 1` to the plane `z = 0`, `v` from the plane `x = 0` to the plane `y = 0`.
///
/// `1 - z^c` is a share of `u`, of which `x^a` is a share of `v`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curved {
    exponents: [f64; 3],
    down: Share,
    round: Share,
    /// What `x`, `y` and `z` are along `u`.
    along: [Climb; 3],
    /// What `x` and `y` are round `v`.
    across: [Climb; 2],
    /// Cells that are halved again and again have few lines between them.
    strips: Recent<Strip, 2>,
    sectors: Recent<Sector, 2>,
    /// What is along the lines that places lie on.
    rows: Lines<3>,
    meridians: Lines<2>,
}

/// How many strips and sectors are kept.
const KEPT: usize = 64;

impl Curved {
    pub(super) fn new(exponents: [f64; 3]) -> Curved {
        let [a, b, c] = exponents;
        let down = Share { k: power(&[a, b]), l: power(&[c]) };
        let round = Share { k: power(&[a]), l: power(&[b]) };
        Curved {
            exponents,
            down,
            round,
            along: [down.rising(a), down.rising(b), down.falling(c)],
            across: [round.rising(a), round.falling(b)],
            strips: Recent::default(),
            sectors: Recent::default(),
            rows: Lines::default(),
            meridians: Lines::default(),
        }
    }

    /// What `x`, `y` and `z` are along `u` on the edges, and `x` and `y` along `v` on the third.
    pub(super) fn edges(&self) -> ([Climb; 3], [Climb; 2]) {
        (self.along, self.across)
    }

    /// How many waves resolve it along `u` and along `v`.
    pub(super) fn waves(&self) -> [f64; 2] {
        [self.down.waves(), self.round.waves()]
    }

    /// What is to be known of the cells between two lines of constant `u`.
    fn strip(&self, u: [f64; 2]) -> Strip {
        Strip {
            suprema: self.along.map(|climb| climb.suprema(u)),
            ends: self.along.map(|climb| u.map(|u| climb.value(u))),
        }
    }

    /// The same between two lines of constant `v`.
    fn sector(&self, v: [f64; 2]) -> Sector {
        Sector {
            suprema: self.across.map(|climb| climb.suprema(v)),
            ends: self.across.map(|climb| v.map(|v| climb.value(v))),
        }
    }

    fn jet_of(&self, along: &[[f64; 3]; 3], [x, y]: [[f64; 3]; 2]) -> SurfaceJet {
        let product = |i: usize, j: usize| {
            DVec3::new(along[0][i] * x[j], along[1][i] * y[j], if j == 0 { along[2][i] } else { 0.0 })
        };
        SurfaceJet {
            position: product(0, 0),
            du: product(1, 0),
            dv: product(0, 1),
            duu: product(2, 0),
            duv: product(1, 1),
            dvv: product(0, 2),
        }
    }
}

/// Suprema of `x`, `y` and `z` along `u` and of their derivatives, and what they are at both ends.
#[derive(Debug, Clone, Copy)]
struct Strip {
    suprema: [[f64; 3]; 3],
    ends: [[f64; 2]; 3],
}

/// The same of `x` and `y` round `v`.
#[derive(Debug, Clone, Copy)]
struct Sector {
    suprema: [[f64; 3]; 2],
    ends: [[f64; 2]; 2],
}

/// Suprema of the cell that is in both.
fn suprema_of(strip: &Strip, sector: &Sector, stretch: [f64; 3]) -> Suprema {
    let (along, [x, y]) = (&strip.suprema, &sector.suprema);
    let length = |i: usize, j: usize| {
        let z = if j == 0 { along[2][i] } else { 0.0 };
        (DVec3::new(along[0][i] * x[j], along[1][i] * y[j], z) * DVec3::from_array(stretch)).length()
    };
    Suprema { size: length(0, 0), uu: length(2, 0), uv: length(1, 1), vv: length(0, 2) }
}

/// Every coordinate rises or falls all along `u` and all along `v`. So of a cell and of its triangles each has the same range, and for a point of one there is one of the other that agrees in it: they are no further apart than
/// the two other coordinates range. Where an octant has a tip like a needle that is far less than what its second derivatives say.
fn ranging(strip: &Strip, sector: &Sector, stretch: [f64; 3]) -> f64 {
    let ([x, y, z], [across, falling]) = (strip.ends, sector.ends);
    let ranges = [x[1] * across[1] - x[0] * across[0], y[1] * falling[0] - y[0] * falling[1], z[0] - z[1]];
    let squares: [f64; 3] = core::array::from_fn(|i| (ranges[i] * stretch[i]) * (ranges[i] * stretch[i]));
    let [p, q, r] = squares;
    libm::sqrt((p + q).min(q + r).min(r + p))
}

/// Suprema of the cell of these lengths that is in both, and how far its triangles are off.
fn enclosed(strip: &Strip, sector: &Sector, lengths: [f64; 2], stretch: [f64; 3]) -> (Suprema, f64) {
    let suprema = suprema_of(strip, sector, stretch);
    (suprema, suprema.deviation(lengths).min(ranging(strip, sector, stretch)))
}

/// A curve of one height.
struct Level<'a> {
    patch: &'a Curved,
    along: [[f64; 3]; 3],
}

/// `x` and `y` round `v` have a value and two derivatives.
const ORDERS: usize = 3;

impl Row for Level<'_> {
    fn length(&self) -> f64 {
        1.0
    }

    fn jet(&self, v: f64) -> SurfaceJet {
        self.patch.jet_of(&self.along, self.patch.meridians.at(v, &self.patch.across))
    }

    fn jet_at(&self, columns: &Columns, column: usize) -> SurfaceJet {
        match columns.pairs(column, ORDERS) {
            [value, first, second] => {
                let across = [[value.0, first.0, second.0], [value.1, first.1, second.1]];
                self.patch.jet_of(&self.along, across)
            }
            _ => self.jet(columns.v(column)),
        }
    }
}

impl Patch for Curved {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        self.row(u).jet(v)
    }

    fn row(&self, u: f64) -> Box<dyn Row + '_> {
        Box::new(Level { patch: self, along: self.rows.at(u, &self.along) })
    }

    fn columns(&self, spread: Spread) -> Columns {
        let pairs = |v: f64| {
            let [x, y] = self.across.map(|climb| climb.jet(v));
            (0..ORDERS).map(move |order| (x[order], y[order]))
        };
        Columns::with_pairs(spread, spread.places().into_iter().flat_map(pairs).collect())
    }

    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        suprema_of(&self.strip(cell.u), &self.sector(cell.v), stretch)
    }

    fn position(&self, u: f64, v: f64) -> DVec3 {
        let [along, other, z] = self.along.map(|climb| climb.value(u));
        let [x, y] = self.across.map(|climb| climb.value(v));
        DVec3::new(along * x, other * y, z)
    }

    fn deviation(&self, cell: Cell, stretch: [f64; 3]) -> f64 {
        self.enclosed(cell, stretch).1
    }

    fn enclosed(&self, cell: Cell, stretch: [f64; 3]) -> (Suprema, f64) {
        let strip = self.strips.at(cell.u, KEPT, || self.strip(cell.u));
        let sector = self.sectors.at(cell.v, KEPT, || self.sector(cell.v));
        enclosed(&strip, &sector, cell.lengths(), stretch)
    }

    fn shows_cells(&self, [u, v]: [&[f64]; 2], stretch: [f64; 3], show: &mut ShowCell) -> bool {
        let between = |places: &[f64]| places.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>();
        let length = |[from, to]: [f64; 2]| to - from;
        let sectors: Vec<_> = between(v).into_iter().map(|v| (length(v), self.sector(v))).collect();
        for (i, u) in between(u).into_iter().enumerate() {
            let strip = self.strip(u);
            for (j, (round, sector)) in sectors.iter().enumerate() {
                let (suprema, deviation) = enclosed(&strip, sector, [length(u), *round], stretch);
                show([i, j], deviation, Some(suprema));
            }
        }
        true
    }

    fn breaks(&self) -> [Breaks; 2] {
        self.waves().map(Breaks::smooth)
    }

    fn sides(&self) -> [Side; 4] {
        let met = |patch: usize| Side::Shared { patch, side: 1, is_reversed: false };
        [Side::Pole, met(3), met(1), met(2)]
    }

    /// Along the gradient of `x^a + y^b + z^c`, against which `X_u x X_v` is. On an edge one of its components may have no bound, and at a tip two: by their logarithms, at the next place inside, the largest is known.
    fn normal_limit(&self, u: f64, v: f64) -> Option<DVec3> {
        let [below, z] = self.down.logarithms(u);
        let [x, y] = self.round.logarithms(v);
        let powers = [below + x, below + y, z];
        // a x^(a - 1) = a (x^a)^(1 - 1/a).
        let gradient: [f64; 3] = core::array::from_fn(|i| {
            let exponent = self.exponents[i];
            libm::log(exponent) + (1.0 - 1.0 / exponent) * powers[i]
        });
        let largest = gradient.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let direction = DVec3::from_array(gradient.map(|component| libm::exp(component - largest)));
        Some(-direction.normalize_or(DVec3::Z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOME: [[f64; 3]; 4] = [[2.0, 2.0, 2.0], [0.5, 0.7, 50.0], [50.0, 50.0, 1.0], [0.05, 3.0, 0.05]];

    #[test]
    fn cells_of_a_grid_are_told_as_each_by_itself() {
        let (u, v) = ([0.0, 0.01, 0.3, 0.75, 1.0], [0.0, 0.25, 0.5, 1.0]);
        let stretch = [1.0, 2.5, 0.3];
        for exponents in SOME {
            let patch = Curved::new(exponents);
            let mut n_cells = 0;
            let is_told = patch.shows_cells([&u, &v], stretch, &mut |[i, j], deviation, suprema| {
                let cell = Cell { u: [u[i], u[i + 1]], v: [v[j], v[j + 1]] };
                assert_eq!((suprema, deviation), (Some(patch.suprema(cell, stretch)), patch.deviation(cell, stretch)));
                n_cells += 1;
            });
            assert_eq!((is_told, n_cells), (true, 12));
        }
    }

    #[test]
    fn columns_have_the_bits_of_their_places() {
        let places = [0.0, 0.125, 0.6, 1.0];
        for exponents in SOME {
            let patch = Curved::new(exponents);
            for (columns, places) in [
                (patch.columns(Spread::At(&places)), &places),
                (patch.columns(Spread::Even(4)), &[0.0, 0.25, 0.5, 0.75]),
            ] {
                for u in [0.0, 0.2, 0.9, 1.0] {
                    let row = patch.row(u);
                    for (column, v) in places.iter().enumerate() {
                        assert_eq!(row.jet_at(&columns, column), patch.jet(u, *v), "{exponents:?} {u} {v}");
                    }
                }
            }
        }
    }
}
