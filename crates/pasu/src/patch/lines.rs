//! Where the grid lines of patches are.

use super::breaks::Breaks;
use super::cell::{Cell, Suprema};
use super::contract::Patch;
use super::side::Side;
use super::strips::{SAME_LINE, Strips};

/// A patch that closes round is cut into so many cells at least: with fewer it would be flat.
const LEAST_ROUND: usize = 6;

/// The lines of constant `u` and of constant `v` of one patch, from 0 to 1, ascending.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lines {
    pub(crate) u: Vec<f64>,
    pub(crate) v: Vec<f64>,
}

impl Lines {
    /// Even lines.
    pub(crate) fn even(rows: usize, columns: usize) -> Lines {
        let even = |n: usize| (0..n).map(|i| i as f64 / (n - 1) as f64).collect();
        Lines { u: even(rows), v: even(columns) }
    }

    /// Even lines of patches of one shape, and across each side those of its neighbour.
    pub(crate) fn even_of(patches: &[&dyn Patch], rows: usize, columns: usize) -> Vec<Lines> {
        let mut lines = vec![Lines::even(rows, columns); patches.len()];
        Lines::share(patches, &mut lines);
        lines
    }

    /// The lines of patches of one shape that cut what lies between two knots into so many pieces.
    pub(crate) fn pieces_of(patches: &[&dyn Patch], pieces: usize) -> Vec<Lines> {
        let cut = |breaks: &Breaks| {
            let places = breaks.with_ends();
            let between = |pair: &[f64]| {
                let (from, step) = (pair[0], (pair[1] - pair[0]) / pieces as f64);
                (0..pieces).map(|i| from + i as f64 * step).collect::<Vec<f64>>()
            };
            places.windows(2).flat_map(between).chain([1.0]).collect()
        };
        let of = |patch: &&dyn Patch| {
            let [along, round] = patch.breaks();
            Lines { u: cut(&along), v: cut(&round) }
        };
        let mut lines: Vec<Lines> = patches.iter().map(of).collect();
        Lines::share(patches, &mut lines);
        lines
    }

    /// The fewest lines of patches of one shape, with which a closed one is not flat.
    pub(crate) fn fewest_of(patches: &[&dyn Patch]) -> Vec<Lines> {
        let mut lines: Vec<Lines> = patches.iter().map(|patch| Lines::fewest(*patch)).collect();
        Lines::share(patches, &mut lines);
        lines
    }

    /// Knots, and what a closed patch needs not to be flat.
    fn fewest(patch: &dyn Patch) -> Lines {
        let [along, round] = patch.breaks();
        let sides = patch.sides();
        let cut = |places: Vec<f64>, is_round: bool| {
            let pieces = if is_round { LEAST_ROUND.div_ceil(places.len() - 1) } else { 1 };
            let between = |pair: &[f64]| {
                let (from, step) = (pair[0], (pair[1] - pair[0]) / pieces as f64);
                (0..pieces).map(|i| from + i as f64 * step).collect::<Vec<f64>>()
            };
            places.windows(2).flat_map(between).chain([1.0]).collect()
        };
        Lines {
            u: cut(along.with_ends(), sides[0] == Side::Joined),
            v: cut(round.with_ends(), sides[2] == Side::Joined),
        }
    }

    pub(crate) fn n_vertices(&self) -> usize {
        self.u.len() * self.v.len()
    }

    /// The cell in this row and column.
    fn cell(&self, [i, j]: [usize; 2]) -> Cell {
        Cell { u: [self.u[i], self.u[i + 1]], v: [self.v[j], self.v[j + 1]] }
    }

    /// Halves the intervals of these numbers, in one pass: there may be millions.
    pub(crate) fn halve(lines: &mut Vec<f64>, mut intervals: Vec<usize>) {
        intervals.sort_unstable();
        intervals.dedup();
        let mut halved = Vec::with_capacity(lines.len() + intervals.len());
        let mut next = intervals.into_iter().peekable();
        for (i, line) in lines.iter().enumerate() {
            halved.push(*line);
            if let (Some(_), Some(beyond)) = (next.next_if_eq(&i), lines.get(i + 1)) {
                halved.push(0.5 * (line + beyond));
            }
        }
        *lines = halved;
    }

    /// Takes away the line of constant `u` (0) or `v` (1) of a patch at this place, and from the others what of it runs through them.
    pub(crate) fn without(patches: &[&dyn Patch], lines: &mut [Lines], patch: usize, direction: usize, place: f64) {
        let mut taken = vec![Lines { u: Vec::new(), v: Vec::new() }; lines.len()];
        if let Some(own) = taken.get_mut(patch) {
            // The ends are shared as well, and stay.
            *(if direction == 0 { &mut own.u } else { &mut own.v }) = vec![0.0, place, 1.0];
        }
        Lines::share(patches, &mut taken);
        for (own, taken) in directions(lines).into_iter().zip(directions(&mut taken)) {
            let is_inner = |place: f64| SAME_LINE < place && place < 1.0 - SAME_LINE;
            own.retain(|place| !(is_inner(*place) && taken.iter().any(|other| (place - other).abs() <= SAME_LINE)));
        }
    }

    /// Gives every patch the lines that its neighbours have across a shared side, and those that they have from theirs.
    pub(crate) fn share(patches: &[&dyn Patch], lines: &mut [Lines]) {
        Strips::of(patches).share(directions(lines));
    }
}

/// Lines for patches of one shape, with which every cell keeps a distance, and the largest that one has; `None` beyond so many vertices, and where lines would have to lie too near to each other. Patches that share a side have the same lines across it.
///
/// A cell that does not is halved across the direction that adds more to its bound, and with it the strip of cells that has the same lines. The axes are stretched by these factors.
pub(crate) fn lines_within(
    patches: &[&dyn Patch],
    stretch: [f64; 3],
    distance: f64,
    most_vertices: usize,
) -> Option<(Vec<Lines>, f64)> {
    // A patch has two rows at least, which leaves a width for its columns; where one cell tells of all, nothing has to be cut to know that they would be narrower.
    let finest = 2.0 / most_vertices as f64;
    let is_beyond = |patch: &&dyn Patch| {
        let on_end = |u: f64| patch.suprema(Cell { u: [u; 2], v: [0.0, finest] }, stretch).vv;
        let is_round = patch.is_alike_round() && patch.sides()[2] == Side::Joined;
        is_round && [0.0, 1.0].iter().any(|u| 0.125 * finest * finest * on_end(*u) > distance)
    };
    if patches.iter().any(is_beyond) {
        return None;
    }
    let mut lines: Vec<Lines> = patches.iter().map(|patch| Lines::fewest(*patch)).collect();
    let strips = Strips::of(patches);
    strips.share(directions(&mut lines));
    // Of each patch whether its lines are others than when its cells were looked at last, and the largest distance of one.
    let mut is_new = vec![true; patches.len()];
    let mut largest = vec![0.0f64; patches.len()];
    let mut before = 0;
    loop {
        let n_vertices = lines.iter().map(Lines::n_vertices).sum::<usize>();
        // Lines that would lie nearer to each other than two can are none: then halving comes to nothing.
        if n_vertices > most_vertices || n_vertices <= before {
            return None;
        }
        before = n_vertices;
        let mut is_done = true;
        let each = patches.iter().zip(&mut lines).zip(is_new.iter_mut().zip(&mut largest));
        for ((patch, lines), (is_new, largest)) in each.filter(|(_, (is_new, _))| **is_new) {
            *largest = 0.0;
            let (mut rows, mut columns) = (Vec::new(), Vec::new());
            visit(*patch, lines, stretch, |place, deviation, suprema| {
                *largest = largest.max(deviation);
                if !(deviation <= distance) {
                    let cell = lines.cell(place);
                    let ([p, q], suprema) = (cell.lengths(), suprema.unwrap_or_else(|| patch.suprema(cell, stretch)));
                    let [i, j] = place;
                    if p * p * suprema.uu >= q * q * suprema.vv { rows.push(i) } else { columns.push(j) }
                }
            });
            *is_new = !(rows.is_empty() && columns.is_empty());
            is_done &= !*is_new;
            Lines::halve(&mut lines.u, rows);
            Lines::halve(&mut lines.v, columns);
        }
        if is_done {
            return Some((lines, largest.into_iter().fold(0.0, f64::max)));
        }
        for (is_new, are_others) in is_new.iter_mut().zip(strips.share(directions(&mut lines)).chunks_exact(2)) {
            *is_new |= are_others.contains(&true);
        }
    }
}

/// Lines of constant `u` and of constant `v`, patch by patch.
fn directions(lines: &mut [Lines]) -> Vec<&mut Vec<f64>> {
    lines.iter_mut().flat_map(|Lines { u, v }| [u, v]).collect()
}

/// The largest distance between patches and the triangles of their cells.
pub(crate) fn deviation_of(patches: &[&dyn Patch], lines: &[Lines], stretch: [f64; 3]) -> f64 {
    let mut most = 0.0f64;
    for (patch, lines) in patches.iter().zip(lines) {
        visit(*patch, lines, stretch, |_, deviation, _| most = most.max(deviation));
    }
    most
}

/// Shows every cell with the numbers of its row and column, and what is known of it.
fn visit(patch: &dyn Patch, lines: &Lines, stretch: [f64; 3], mut show: impl FnMut([usize; 2], f64, Option<Suprema>)) {
    #[cfg(feature = "patchwork")]
    if patch.shows_cells([&lines.u, &lines.v], stretch, &mut show) {
        return;
    }
    let is_alike = patch.is_alike_round();
    for i in 1..lines.u.len() {
        let mut of_row = None;
        for j in 1..lines.v.len() {
            let place = [i - 1, j - 1];
            let cell = lines.cell(place);
            if is_alike {
                let suprema = *of_row.get_or_insert_with(|| patch.suprema(cell, stretch));
                show(place, patch.deviation_by(cell, &suprema), Some(suprema));
            } else {
                show(place, patch.deviation(cell, stretch), None);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_halved_each_once_and_the_rest_stays() {
        let mut lines = vec![0.0, 0.25, 0.5, 1.0];
        Lines::halve(&mut lines, vec![2, 0, 2]);
        assert_eq!(lines, [0.0, 0.125, 0.25, 0.5, 0.75, 1.0]);
        // There is nothing beyond the last line.
        Lines::halve(&mut lines, vec![5, 9]);
        assert_eq!(lines, [0.0, 0.125, 0.25, 0.5, 0.75, 1.0]);
    }
}
