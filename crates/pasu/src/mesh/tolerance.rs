//! Rows and columns from a tolerance, and the bound that a grid keeps.

use xxhash_rust::xxh64::Xxh64;

use super::contract::{MeshOptions, VERTEX_LIMIT};
use super::profile::{Bend, Profile};
use super::promise::POSITION_ERROR;
use crate::design::plain;
use crate::error::{Code, Error, Result};
use crate::numeric::bisection;

/// Without rows, columns or tolerance a part is sampled to this fraction of its size.
pub(crate) const DEFAULT_FINENESS: f64 = 1.0 / 2000.0;

/// The fewest cells along the profile.
const LEAST_ALONG: f64 = 1.0;

/// The fewest cells round the axis: with fewer a closed surface would be flat.
const LEAST_ROUND: f64 = 6.0;

/// Candidate numbers of columns grow by this factor; what lies between two of them is looked through at the end.
const COLUMN_STEP: f64 = 1.06;

/// The most candidates: up to ten times the fewest columns that hold.
const COLUMN_CANDIDATES: usize = 40;

/// Beyond so many rows the number that a budget takes is as good as the integral over the profile.
const MANY_ROWS: f64 = 1000.0;

/// How often the budget is halved towards the least that a number of rows can keep.
const EVENING: usize = 24;

/// A part of the budget kept for the rounding of where rows are.
const SPARE: f64 = 1e-6;

/// The grid of one part: cells along `u` and round `v`, and where the rows are.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tessellation {
    /// Whole, but perhaps too large for an integer until it has been held against the limit.
    pub(super) along: f64,
    /// As `along`.
    pub(super) round: f64,
    /// The `u` of every row, from 0 to 1, where rows have been placed; otherwise they are even.
    pub(super) rows: Option<Vec<f64>>,
    /// The largest distance between the triangles and the surface, where it had to be known.
    pub(super) bound: Option<f64>,
}

/// What a part has to be bounded: its profile, and how far its vertices are from where they should be.
struct Part<'a> {
    profile: Profile,
    /// Where rows have to stand.
    stops: &'a [f64],
    rounding: f64,
}

impl Tessellation {
    /// The grid for these options. `profile` is asked for only where something depends on it, as it costs much more than a row of vertices; `shift` is how far the
    /// part is from the origin of the design.
    ///
    /// # Errors
    /// `tolerance-too-fine`.
    pub(super) fn choose(
        profile: impl FnOnce() -> Profile,
        stops: &[f64],
        shift: f64,
        options: &MeshOptions,
        is_precise: bool,
        is_bounded: bool,
    ) -> Result<Tessellation> {
        let (along, round) = (options.rows.map(|n| n as f64 - 1.0), options.columns.map(|n| n as f64 - 1.0));
        if let (Some(along), Some(round), None, false) = (along, round, options.tolerance, is_bounded) {
            return Ok(Tessellation { along, round, rows: spread(along, stops), bound: None });
        }
        let part = Part::new(profile(), stops, shift, is_precise);
        let tolerance = options.tolerance.unwrap_or(part.profile.size * DEFAULT_FINENESS + part.rounding);
        if options.tolerance.is_some() && !(tolerance > part.rounding) {
            return Err(part.too_fine(tolerance, &Tessellation { along: 0.0, round: 0.0, rows: None, bound: None }));
        }
        let mut chosen = part.grid(tolerance, along, round);
        let bound = part.bound(&chosen);
        chosen.bound = Some(bound).filter(|bound| bound.is_finite());
        match options.tolerance {
            Some(tolerance) if !(bound <= tolerance * (1.0 + 1e-12)) && part.is_within_limit(&chosen) => {
                Err(part.too_fine(tolerance, &chosen))
            }
            _ => Ok(chosen),
        }
    }
}

impl Tessellation {
    /// The numbers of rows and columns.
    pub(super) fn counts(&self) -> (usize, usize) {
        (self.along as usize + 1, self.round as usize + 1)
    }

    /// The `u` of a row.
    pub(super) fn row(&self, i: usize) -> f64 {
        match &self.rows {
            Some(rows) => rows.get(i).copied().unwrap_or(1.0),
            None => i as f64 / self.along,
        }
    }

    /// Tells apart rows that are placed differently; even rows need none.
    pub(super) fn hash(&self) -> Option<u64> {
        let rows = self.rows.as_ref()?;
        let mut hash = Xxh64::new(0);
        for u in rows {
            hash.update(&u.to_le_bytes());
        }
        Some(hash.digest())
    }
}

impl<'a> Part<'a> {
    fn new(profile: Profile, stops: &'a [f64], shift: f64, is_precise: bool) -> Self {
        // In parts of the largest coordinate, in each of three directions: half a unit in its last place, or what sums in single precision may be off.
        let rounding = (profile.size + shift) * if is_precise { f64::from(f32::EPSILON) } else { 1.8 * POSITION_ERROR };
        Part { profile, stops, rounding }
    }

    fn grid(&self, tolerance: f64, along: Option<f64>, round: Option<f64>) -> Tessellation {
        let budget = 8.0 * (tolerance - self.rounding) * (1.0 - SPARE);
        let even = |along, round| Tessellation { along, round, rows: spread(along, self.stops), bound: None };
        match (along, round) {
            (Some(along), Some(round)) => even(along, round),
            (Some(along), None) => even(along, self.round_for(along, budget)),
            (None, Some(round)) => self.placed(round, budget),
            (None, None) => self.placed(self.best_round(budget), budget),
        }
    }

    /// The fewest cells round the axis with which even cells along `u` hold. Where these spend the budget by themselves, the others are chosen as if they had the whole of it.
    fn round_for(&self, along: f64, budget: f64) -> f64 {
        let mut widest = 1.0 / LEAST_ROUND;
        self.profile.cells(&mut self.rows(along), &mut |p, bend| {
            let beside = bend.widest(p, budget);
            let q = if beside > 0.0 { beside } else { bend.widest(0.0, budget) };
            widest = widest.min(q.max(0.0));
        });
        (1.0 / widest).ceil()
    }

    /// So many cells, evenly spaced between where rows have to stand.
    fn rows(&self, along: f64) -> Box<dyn Iterator<Item = f64>> {
        match spread(along, self.stops) {
            Some(rows) => Box::new(rows.into_iter()),
            None => Box::new(even_rows(along)),
        }
    }

    /// The cells round the axis for which the product with the rows that they take is least.
    fn best_round(&self, budget: f64) -> f64 {
        let fewest = (self.profile.roundest() / budget.max(0.0)).sqrt().ceil().max(LEAST_ROUND);
        let (mut best, mut least, mut round) = (fewest, f64::INFINITY, fewest);
        let mut below = fewest;
        for _ in 0..COLUMN_CANDIDATES {
            let product = (self.along_for(round, budget) + 1.0) * (round + 1.0);
            if product < least {
                (best, least) = (round, product);
            } else if product > 1.5 * least {
                break;
            }
            round = (round * COLUMN_STEP).ceil().max(round + 1.0);
        }
        // The fewest columns that take no more rows.
        let rows = self.along_for(best, budget);
        below = below.max((best / COLUMN_STEP).floor() - 1.0);
        bisection::least_whole(below, best, |round| self.along_for(round, budget) <= rows)
    }

    /// How many cells along `u` hold beside cells round the axis.
    fn along_for(&self, round: f64, budget: f64) -> f64 {
        let q = 1.0 / round;
        let estimate = self.profile.estimate(q, budget);
        if !(estimate < MANY_ROWS) {
            return estimate.max(LEAST_ALONG).ceil();
        }
        self.profile.steps(q, budget, usize::MAX).map_or(f64::INFINITY, |n| n as f64)
    }

    /// Rows placed so that every cell costs about the same, which is what the budget allows or less. Where the columns spend the budget by themselves, as if there were none.
    fn placed(&self, round: f64, budget: f64) -> Tessellation {
        let roundest = self.profile.roundest();
        let q = if self.profile.estimate(1.0 / round, budget).is_finite() { 1.0 / round } else { 0.0 };
        let estimate = self.profile.estimate(q, budget);
        let grid = |along, rows| Tessellation { along, round, rows, bound: None };
        if !((estimate + 1.0) * (round + 1.0) <= 2.0 * VERTEX_LIMIT as f64) {
            return grid(estimate.ceil(), None);
        }
        let Some(n_steps) = self.profile.steps(q, budget, VERTEX_LIMIT) else {
            return grid(estimate.ceil().max(VERTEX_LIMIT as f64), None);
        };
        // The same number of steps at the least budget, so that the last is no shorter than it must be.
        let least = (q * q * roundest).max(0.25 * budget);
        let halvings = if (n_steps as f64) < MANY_ROWS { EVENING } else { 0 };
        let holds = |budget: f64| self.profile.steps(q, budget, n_steps).is_some();
        let [(enough, _), _] = bisection::change((budget, true), (least, false), halvings, holds, |holds| *holds);
        let mut rows = Vec::with_capacity(n_steps + 1);
        rows.push(0.0);
        self.profile.walk(q, enough, n_steps, &mut |u| rows.push(u));
        grid(rows.len() as f64 - 1.0, Some(rows))
    }

    /// The largest distance between the triangles of a grid and the surface.
    fn bound(&self, grid: &Tessellation) -> f64 {
        // A cell across a corner is as far off as the corner is sharp, which no second derivative says.
        if !self.is_within_limit(grid) || grid.rows.is_none() && !self.stops.is_empty() {
            return f64::INFINITY;
        }
        let (mut cost, q) = (0.0f64, 1.0 / grid.round);
        let mut visit = |p: f64, bend: Bend| cost = cost.max(bend.cost(p, q));
        match &grid.rows {
            Some(rows) => self.profile.cells(&mut rows.iter().copied(), &mut visit),
            None => self.profile.cells(&mut even_rows(grid.along), &mut visit),
        }
        0.125 * cost + self.rounding
    }

    fn is_within_limit(&self, grid: &Tessellation) -> bool {
        (grid.along + 1.0) * (grid.round + 1.0) <= VERTEX_LIMIT as f64
    }

    fn too_fine(&self, tolerance: f64, grid: &Tessellation) -> Error {
        let (rounding, tolerance_found) = (plain(self.rounding), plain(tolerance));
        let message = if !self.rounding.is_finite() {
            format!("no mesh in single precision holds a pot of this size, found {tolerance_found}")
        } else if 2.0 * self.rounding > tolerance {
            format!(
                "a mesh in single precision is only good to {rounding} for a pot of this size, found {tolerance_found}"
            )
        } else {
            format!(
                "{} rows of {} vertices cannot hold {tolerance_found}; leave out rows and columns, or ask for more",
                plain(grid.along + 1.0),
                plain(grid.round + 1.0)
            )
        };
        let error = Error::new(Code::ToleranceTooFine, "tolerance", message).with("found", tolerance);
        if !self.rounding.is_finite() {
            error
        } else if 2.0 * self.rounding > tolerance {
            error.with("least", self.rounding)
        } else {
            error.with("rows", grid.along + 1.0).with("columns", grid.round + 1.0)
        }
    }
}

/// The rows of so many cells with one on each of the stops, evenly spaced between these; `None` where there are no stops, or more than there are rows for. Two stops next to each other have nothing between them.
#[inline(never)]
fn spread(along: f64, stops: &[f64]) -> Option<Vec<f64>> {
    // Numbers of rows beyond the limit are refused later on.
    if stops.is_empty() || along < stops.len() as f64 + 1.0 || along > VERTEX_LIMIT as f64 {
        return None;
    }
    let ends = stops.iter().copied().chain([1.0]);
    let gaps: Vec<(f64, f64)> = [0.0].into_iter().chain(stops.iter().copied()).zip(ends).collect();
    let is_seam = |(from, to): (f64, f64)| from.next_up() == to;
    let free = along - gaps.iter().filter(|gap| is_seam(**gap)).count() as f64;
    let share = |(from, to): (f64, f64)| if is_seam((from, to)) { 1.0 } else { ((to - from) * free).floor().max(1.0) };
    let mut counts: Vec<f64> = gaps.iter().map(|gap| share(*gap)).collect();
    let density = |index: usize, count: f64| count / (gaps[index].1 - gaps[index].0);
    // What rounding left over goes where cells are longest, and what it took too much of from where they are shortest.
    loop {
        let found: f64 = counts.iter().sum();
        let can_change = |index: &usize| !is_seam(gaps[*index]) && (found < along || counts[*index] > 1.0);
        let candidates = (0..gaps.len()).filter(can_change);
        let by_density =
            |one: &usize, other: &usize| density(*one, counts[*one]).total_cmp(&density(*other, counts[*other]));
        if found < along {
            let index = candidates.min_by(by_density)?;
            counts[index] += 1.0;
        } else if found > along {
            let index = candidates.max_by(by_density)?;
            counts[index] -= 1.0;
        } else {
            break;
        }
    }
    let mut rows = Vec::with_capacity(along as usize + 1);
    for ((from, to), count) in gaps.iter().zip(&counts) {
        rows.extend((0..*count as usize).map(|i| from + (to - from) * (i as f64 / count)));
    }
    rows.push(1.0);
    Some(rows)
}

fn even_rows(along: f64) -> impl Iterator<Item = f64> {
    (0..=along as usize).map(move |i| i as f64 / along)
}
