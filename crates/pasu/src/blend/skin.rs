//! The skin of a blend as patches.
//!
//! Sines vanish on the border, so that on every side each term is a product of two functions of one parameter. A disc in a square has infinite derivatives at both ends of its `u`; the skin runs over `u = (1 - cos pi s) / 2`
//! instead, in which everything there is smooth.

use std::sync::Arc;

use glam::DVec3;

use super::function::Function;
use super::section::series;
use super::sheet::Sheet;
use super::volume::Volume;
use crate::design::{Blend, BoundaryValue, Component, Datum, Free, Harmonic, Method, Mode, Order, Span};
use crate::error::Result;
use crate::patch::{Breaks, Cell, Columns, Patch, Row, Side, Spread, Suprema, SurfaceJet};
use crate::surface::Surface;

/// A side of less than this part of the size is a point, and a patch that is no wider a line.
const NOTHING: f64 = 1e-12;

/// The patches that go round a blend.
#[derive(Debug)]
pub(super) struct Skin {
    pub(super) patches: Vec<Box<dyn Patch>>,
    /// For each patch whether `X_u x X_v` points where the volume is not, if the volume is not inside out.
    pub(super) is_outward: Vec<bool>,
    /// The surface of the second patch, where it is that between two caps.
    pub(super) flank: Option<Arc<Surface>>,
}

/// What runs round from one closed section to the other, between two caps.
#[derive(Debug)]
struct Flank(Arc<Surface>);

impl Patch for Flank {
    fn jet(&self, u: f64, v: f64) -> SurfaceJet {
        Patch::jet(&*self.0, u, v)
    }

    fn row(&self, u: f64) -> Box<dyn Row + '_> {
        self.0.row(u)
    }

    fn row_along(&self, u: f64, between: [f64; 2]) -> Box<dyn Row + '_> {
        self.0.row_along(u, between)
    }

    fn columns(&self, spread: Spread) -> Columns {
        self.0.columns(spread)
    }

    fn suprema(&self, cell: Cell, stretch: [f64; 3]) -> Suprema {
        self.0.suprema(cell, stretch)
    }

    fn is_alike_round(&self) -> bool {
        self.0.is_alike_round()
    }

    fn n_terms(&self) -> usize {
        self.0.n_terms()
    }

    fn breaks(&self) -> [Breaks; 2] {
        self.0.breaks()
    }

    fn sides(&self) -> [Side; 4] {
        let met = |patch: usize| Side::Shared { patch, side: 1, is_reversed: false };
        [met(0), met(2), Side::Joined, Side::Joined]
    }

    fn normal_limit(&self, u: f64, v: f64) -> Option<DVec3> {
        self.0.normal_limit(u, v)
    }
}

/// The surface between two closed sections: `w` from one to the other, `v` round them.
///
/// # Errors
/// What [`Surface::solve`] refuses.
pub(super) fn flank(blend: &Blend, path: &str) -> Result<Surface> {
    Surface::solve(&flank_problem(blend), path).map_err(|error| error.at(path))
}

/// What it solves.
pub(crate) fn flank_problem(blend: &Blend) -> BoundaryValue {
    let [_, b, c] = blend.weights;
    // What the sines of the other methods leave on the border is the cubic.
    let w = if blend.method() == Method::Exact { b } else { 0.0 };
    let both = [&blend.start, &blend.end];
    let component =
        |modes: Vec<Mode>| Component { order: Order::Fourth, s: c, t: 0.0, w, free: Free::default(), modes };
    let across = |axis: usize| {
        let mut modes: Vec<Mode> = Vec::new();
        for (index, section) in both.into_iter().enumerate() {
            for Harmonic { n, cos, sin } in series(&section.form, axis) {
                let place = match modes.binary_search_by(|mode| mode.n.total_cmp(&n)) {
                    Ok(place) => place,
                    Err(place) => {
                        modes.insert(place, Mode { n, cos: Datum::default(), sin: Datum::default() });
                        place
                    }
                };
                let mode = &mut modes[place];
                for (datum, value) in [(&mut mode.cos, cos), (&mut mode.sin, sin)] {
                    let (at, slope) = match index {
                        0 => (&mut datum.start, &mut datum.start_u),
                        _ => (&mut datum.end, &mut datum.end_u),
                    };
                    *at += value;
                    *slope += section.taper * value;
                }
            }
        }
        component(modes)
    };
    let [start, end] = both;
    let level = Datum { start: start.z, end: end.z, start_u: start.dz, end_u: end.dz, ..Datum::default() };
    let z = component(vec![Mode { n: 0.0, cos: level, sin: Datum::default() }]);
    BoundaryValue { span: Span::Length(1.0), rings: Vec::new(), x: across(0), y: across(1), z }
}

impl Skin {
    /// Between two closed sections: a cap, the flank, a cap.
    pub(super) fn round(volume: &Volume, flank: Surface) -> Skin {
        let caps = [0, 1].map(|end| {
            // The pole is where u is 0.
            let met = Side::Shared { patch: 1, side: end, is_reversed: false };
            cap(volume, end, false).between([Side::Pole, met, Side::Joined, Side::Joined])
        });
        let [start, end] = caps;
        let flank = Arc::new(flank);
        Skin {
            patches: vec![Box::new(start), Box::new(Flank(Arc::clone(&flank))), Box::new(end)],
            is_outward: vec![false, false, true],
            flank: Some(flank),
        }
    }

    /// The six sides of the cube: `u = 0`, `u = 1`, `v = 0`, `v = 1`, `w = 0`, `w = 1`, but for those that are no wider than a line. Each runs over the two other parameters in their order.
    pub(super) fn of_six(volume: &Volume, is_half_round: bool) -> Skin {
        let sheets: Vec<Sheet> = (0..6)
            .map(|face| match face / 2 {
                2 => cap(volume, face % 2, is_half_round),
                axis => side(volume, axis, face % 2, is_half_round),
            })
            .collect();
        let size = sheets.iter().map(Sheet::size).fold(0.0, f64::max);
        let least = NOTHING * size;
        let is_line = |face: usize| (0..2).any(|along| sheets[face].extent(along, None) <= least);
        let kept: Vec<usize> = (0..6).filter(|face| !is_line(*face)).collect();
        let number = |face: usize| kept.iter().position(|kept| *kept == face);
        let sides_of = |face: usize| -> [Side; 4] {
            core::array::from_fn(|side| {
                let (across, end) = (side / 2, side % 2);
                if sheets[face].extent(1 - across, Some(end as f64)) <= least {
                    return Side::Pole;
                }
                match met(face, side) {
                    (other, theirs) if number(other).is_some() => {
                        Side::Shared { patch: number(other).unwrap_or(0), side: theirs, is_reversed: false }
                    }
                    // Beyond a line lies what is on its other side.
                    (line, theirs) => {
                        let (other, theirs) = met(line, theirs ^ 1);
                        number(other).map_or(Side::Free, |patch| Side::Shared {
                            patch,
                            side: theirs,
                            is_reversed: false,
                        })
                    }
                }
            })
        };
        let sides: Vec<[Side; 4]> = kept.iter().map(|face| sides_of(*face)).collect();
        // X_u x X_v of the sides where a parameter is 1 points out for u and w, and in for v.
        let is_outward = kept.iter().map(|face| (face % 2 == 1) != (face / 2 == 1)).collect();
        let patches = kept.iter().zip(sides).map(|(face, sides)| {
            let sheet = sheets[*face].clone().between(sides);
            Box::new(sheet) as Box<dyn Patch>
        });
        Skin { patches: patches.collect(), is_outward, flank: None }
    }
}

/// The side of the cube beyond a side of one of its sides, and which side of that it is.
fn met(face: usize, side: usize) -> (usize, usize) {
    let (axis, end) = (face / 2, face % 2);
    let axes = |axis: usize| {
        if axis == 0 {
            [1, 2]
        } else if axis == 1 {
            [0, 2]
        } else {
            [0, 1]
        }
    };
    let beyond = axes(axis)[side / 2];
    let place = axes(beyond).iter().position(|other| *other == axis).unwrap_or(0);
    (2 * beyond + side % 2, 2 * place + end)
}

/// A function of `u` in the parameter that is smooth for a disc in a square: `u = (1 - cos pi s) / 2`.
fn smooth(function: &Function, is_half_round: bool) -> Vec<(f64, Function)> {
    match function {
        Function::Cubic([a, b, ..]) if is_half_round => {
            vec![(a + 0.5 * b, Function::ONE), (-0.5 * b, Function::Cosine(1.0))]
        }
        Function::HalfRound => vec![(1.0, Function::Sine(1.0))],
        other => vec![(1.0, other.clone())],
    }
}

/// The side where `u` (`axis` 0) or `v` (1) is 0 or 1, over the other of the two and `w`.
fn side(volume: &Volume, axis: usize, end: usize, is_half_round: bool) -> Sheet {
    let [us, vs, ws] = &volume.functions;
    let at = end as f64;
    let products = volume.terms.iter().flat_map(|term| {
        let [f, g, h] = term.of;
        let (held, runs) = match axis {
            0 => (us[f].jet::<1>(at)[0], vec![(1.0, vs[g].clone())]),
            _ => (vs[g].jet::<1>(at)[0], smooth(&us[f], is_half_round)),
        };
        runs.into_iter().map(move |(by, function)| (term.by.extend(0.0) * (held * by), [function, ws[h].clone()]))
    });
    Sheet::new(products.chain([(DVec3::Z, [Function::ONE, volume.z.clone()])]))
}

/// The section at one end over `u` and `v`.
fn cap(volume: &Volume, end: usize, is_half_round: bool) -> Sheet {
    let [us, vs, _] = &volume.functions;
    let terms = volume.terms.iter().filter(|term| term.end == end);
    let products = terms.flat_map(|term| {
        let [f, g, _] = term.of;
        let runs = smooth(&us[f], is_half_round).into_iter();
        runs.map(move |(by, function)| (term.by.extend(0.0) * by, [function, vs[g].clone()]))
    });
    let [level] = volume.z.jet::<1>(end as f64);
    Sheet::new(products.chain([(DVec3::Z * level, [Function::ONE, Function::ONE])])).level()
}
