//! The coefficients of a surface at many rows at once.

use super::solve::Surface;
use super::table::{BLOCK, Block};
use super::term::Term;
use crate::mode::{Deflection, Expansion, ROUNDING, TERMS};

/// One datum of one mode, a function of `u` alone.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Curve {
    /// The component: 0 is `x`.
    pub(crate) axis: usize,
    /// Whether it is the coefficient of `sin(k v)`, not of `cos(k v)`.
    pub(crate) is_sine: bool,
    pub(crate) n: f64,
    pub(crate) k: f64,
    /// Which of its component's terms.
    term: usize,
    /// Number of its first expansion, and how many of equal width cover [0, 1]; 0 where the solution itself is asked.
    first: usize,
    n_expansions: usize,
    /// How far value and slope may be off where no expansion serves.
    noise: [f64; 2],
}

/// Every datum of a surface that is not 0, as Taylor expansions on as many intervals as its rate asks for.
///
/// A row then costs a polynomial a datum instead of its exponentials. The error is some 3e-11 of the datum, and told with each row: for single precision only.
#[derive(Debug, Default)]
pub(crate) struct Curves {
    curves: Vec<Curve>,
    expansions: Vec<Expansion>,
}

/// An expansion costs as much as some four rows asked of the solution itself: with fewer rows than this to an interval it does not pay.
const ROWS_PER_EXPANSION: f64 = 4.0;

/// More are not made: 7 MB. What has no expansion is asked of the solution itself.
const MOST_EXPANSIONS: f64 = 65_536.0;

/// Rows that are asked for besides those of the mesh, to know its outside and its size.
const OTHER_ROWS: f64 = 26.0;

impl Curves {
    /// Takes another surface, of which so many rows will be asked for.
    pub(crate) fn prepare(&mut self, surface: &Surface, n_rows: f64) {
        self.curves.clear();
        self.expansions.clear();
        for (axis, terms) in surface.components().iter().enumerate() {
            for (index, term) in terms.iter().enumerate() {
                let reach = term.beam.reach([&term.cos, &term.sin]);
                // Half a width of 1 / n, a little more than which is used: rows come four at a time.
                let n_expansions = (0.5 / reach).ceil();
                let pays = n_expansions * ROWS_PER_EXPANSION <= n_rows + OTHER_ROWS;
                let first = self.expansions.len();
                let has_room = first as f64 + 2.0 * n_expansions <= MOST_EXPANSIONS;
                let n_expansions = if pays && has_room { n_expansions as usize } else { 0 };
                let data = [(false, &term.cos), (true, &term.sin)];
                let is_used =
                    |(is_sine, solution): (bool, &Deflection)| !(solution.is_zero() || is_sine && term.n == 0.0);
                let n_used = data.into_iter().filter(|datum| is_used(*datum)).count();
                self.expansions.resize(first + n_used * n_expansions, Expansion::default());
                let mut noise = [0.0f64; 2];
                for i in 0..n_expansions {
                    let half = 0.5 / n_expansions as f64;
                    let both = term.beam.expansions([&term.cos, &term.sin], (2 * i + 1) as f64 * half, half);
                    let used = data.into_iter().zip(both).filter(|(datum, _)| is_used(*datum));
                    for (slot, (_, expansion)) in used.enumerate() {
                        noise = [noise[0].max(expansion.noise), noise[1].max(expansion.slope_noise(n_expansions))];
                        self.expansions[first + slot * n_expansions + i] = expansion;
                    }
                }
                if n_expansions == 0 {
                    // Of as many derivatives as others ask for: one function less to load.
                    for [value, slope, ..] in term.beam.suprema::<5, 2>([&term.cos, &term.sin], 0.0, 1.0) {
                        noise = [noise[0].max(ROUNDING * value), noise[1].max(ROUNDING * slope)];
                    }
                }
                for (slot, (is_sine, _)) in data.into_iter().filter(|datum| is_used(*datum)).enumerate() {
                    let first = first + slot * n_expansions;
                    let (n, k) = (term.n, term.k);
                    self.insert(Curve { axis, is_sine, n, k, term: index, first, n_expansions, noise });
                }
            }
        }
    }

    /// Puts a curve behind those of no more expansions: rows are placed among intervals once for all curves that have as many.
    fn insert(&mut self, curve: Curve) {
        let place = self.curves.partition_point(|other| other.n_expansions <= curve.n_expansions);
        self.curves.insert(place, curve);
    }

    /// What there is, in the order of [`Curves::rows`].
    pub(crate) fn list(&self) -> &[Curve] {
        &self.curves
    }

    /// Value and slope of every curve at one row, as [`Curves::rows`]: for what asks for few, which then has no loop of its own.
    #[inline(never)]
    pub(crate) fn row(&self, surface: &Surface, u: f64, visit: &mut dyn FnMut(usize, [f64; 2])) {
        self.rows(surface, [u; BLOCK], |index, values, _| visit(index, values.map(|block| block.to_array()[0])));
    }

    /// Value and slope of every curve at four rows, one in each lane, in ascending order; and how far either may be off.
    pub(crate) fn rows(&self, surface: &Surface, u: [f64; BLOCK], mut visit: impl FnMut(usize, [Block; 2], [f64; 2])) {
        // The boundary data are met to the bit: a pole is where they are 0.
        let is_end = u.map(|u| u == 0.0 || u == 1.0);
        let has_end = is_end.contains(&true);
        let mut place = Place::of(u, 0);
        for (index, curve) in self.curves.iter().enumerate() {
            if place.n_expansions != curve.n_expansions {
                place = Place::of(u, curve.n_expansions);
            }
            let expansion = place.interval.and_then(|interval| self.expansions.get(curve.first + interval));
            let values = match expansion {
                Some(expansion) if !has_end => place.evaluated(expansion),
                expansion => {
                    let Some(term) = surface.components()[curve.axis].get(curve.term) else { continue };
                    match expansion {
                        Some(expansion) => with_ends(curve, term, u, is_end, place.evaluated(expansion)),
                        None => asked(curve, term, u),
                    }
                }
            };
            let noise = match expansion {
                Some(expansion) => [expansion.noise, expansion.slope_noise(curve.n_expansions)],
                None => curve.noise,
            };
            visit(index, values, noise);
        }
    }
}

/// Where four rows are among so many equal intervals.
struct Place {
    n_expansions: usize,
    /// The interval in which all four are, or nearly.
    interval: Option<usize>,
    /// From -1 to 1 in that interval.
    x: Block,
}

impl Place {
    fn of(u: [f64; BLOCK], n_expansions: usize) -> Self {
        let n = n_expansions as f64;
        let interval = (0.5 * (u[0] + u[BLOCK - 1]) * n).min(n - 1.0) as usize;
        let x = (Block::from(u) * n - interval as f64) * 2.0 - 1.0;
        let [first, .., last] = x.to_array();
        let is_near = n_expansions > 0 && first.abs() <= OVERHANG && last.abs() <= OVERHANG;
        Place { n_expansions, interval: is_near.then_some(interval), x }
    }

    /// Value and slope, by Horner's rule in `x^2` for the even and for the odd powers: two chains that do not wait for each other.
    #[inline(always)]
    fn evaluated(&self, Expansion { terms, .. }: &Expansion) -> [Block; 2] {
        const LAST: usize = TERMS / 2 - 1;
        let square = self.x * self.x;
        let term = |m: usize| Block::splat(terms[m]);
        // The first step has no slopes yet to go on with.
        let (mut even_slope, mut odd_slope) = (term(2 * LAST), term(2 * LAST + 1));
        let mut even = even_slope * square + term(2 * LAST - 2);
        let mut odd = odd_slope * square + term(2 * LAST - 1);
        for m in (0..LAST - 1).rev() {
            even_slope = even_slope * square + even;
            odd_slope = odd_slope * square + odd;
            even = even * square + term(2 * m);
            odd = odd * square + term(2 * m + 1);
        }
        let value = even + odd * self.x;
        let slope = odd + (even_slope * self.x + odd_slope * square) * 2.0;
        [value, slope * (2.0 * self.n_expansions as f64)]
    }
}

/// Two chains take all terms between them.
const _: () = assert!(TERMS.is_multiple_of(2));

/// How far beyond its interval an expansion is used, whose half-width is 1: the terms left out are at most six times as large there.
const OVERHANG: f64 = 1.14;

/// The boundary data where a row has them, and `values` elsewhere.
#[inline(never)]
fn with_ends(curve: &Curve, term: &Term, u: [f64; BLOCK], is_end: [bool; BLOCK], values: [Block; 2]) -> [Block; 2] {
    let [mut value, mut slope] = values.map(Block::to_array);
    let mut last = None;
    for lane in (0..BLOCK).filter(|lane| is_end[*lane]) {
        let end = last.filter(|(at, _)| *at == u[lane]).map_or_else(|| jet(curve, term, u[lane]), |(_, jet)| jet);
        last = Some((u[lane], end));
        [value[lane], slope[lane]] = end;
    }
    [value.into(), slope.into()]
}

#[inline(never)]
fn asked(curve: &Curve, term: &Term, u: [f64; BLOCK]) -> [Block; 2] {
    // Where one row is asked for it is in every lane.
    if u.iter().all(|other| *other == u[0]) {
        return jet(curve, term, u[0]).map(Block::splat);
    }
    let jets = u.map(|u| jet(curve, term, u));
    [jets.map(|[value, _]| value).into(), jets.map(|[_, slope]| slope).into()]
}

fn jet(curve: &Curve, term: &Term, u: f64) -> [f64; 2] {
    let solution = if curve.is_sine { &term.sin } else { &term.cos };
    let [jet] = term.beam.jets::<2, 1>([solution], u);
    jet
}
