//! The greatest value of a function of a surface, with how far it may be off: from the points of two grids, and then between them, where the most promising cell is cut first.

use core::cmp::Ordering;
use std::collections::BinaryHeap;

use super::climb::{Place, climb};
use super::grid::Grid;
use crate::watch;

/// So many times as many cells are cut where they may hold much more.
const LONGER: usize = 5;

/// How much is much, in what is small.
const MUCH: f64 = 5e3;

/// Cells are cut so often at most. About a place where the function jumps they would be cut for ever.
const DEEPEST: u32 = 30;

/// What differs by no more along a row, as a part of its size, is the same there.
const LEVEL: f64 = 1e-9;

/// How far from a top the function is looked at again, as a part of the first step: so near that a smooth one has changed by rounding alone.
const LAST: f64 = 1e-8;

/// A function of what a surface is at a place.
pub(crate) struct Sought<F, M> {
    /// Its value; what is not finite is passed over.
    pub(crate) of: F,
    /// How much more than its values at the corners tell it may be within a cell, along `a` and round `v`.
    pub(crate) more: M,
    /// It is nowhere more than this.
    pub(crate) most: f64,
    /// What may be this much more than what is found is not sought any more, as a part of that.
    pub(crate) small: f64,
    /// So many cells of a grid are cut, and more only where they may hold much more.
    pub(crate) cuts: usize,
}

/// The greatest value, where it is, and how far it may be off: how much the function changes over the last step, what another grid finds besides, and what cells may hold that were not cut any more.
///
/// Where the function is smooth and all cells were cut that had to be, that is little more than its rounding.
pub(crate) fn greatest<T>(
    [grid, other]: [&Grid<T>; 2],
    sought: &Sought<impl Fn(&T) -> f64, impl Fn([&T; 4]) -> [f64; 2]>,
    mut at: impl FnMut(f64, f64) -> T,
) -> Option<(Place, f64)> {
    let first = grid.greatest(&sought.of, &mut at);
    let second = other.greatest(&sought.of, &mut at);
    let known = [first, second].into_iter().flatten().max_by(|x, y| x.value.total_cmp(&y.value))?;
    let (found, left) = improve(grid, known, sought, &mut at);
    let (best, left_besides) = improve(other, found, sought, &mut at);
    let besides = best.value - found.value;
    let (step_a, step_v) = grid.steps();
    // At an end the function may rise towards it.
    let p = if best.a > 0.0 && best.a < 1.0 { LAST * step_a } else { 0.0 };
    let q = LAST * step_v;
    let mut change = 0.0f64;
    for (a, v) in [(p, 0.0), (-p, 0.0), (0.0, q), (0.0, -q), (p, q), (-p, -q)] {
        let near = (sought.of)(&at((best.a + a).clamp(0.0, 1.0), best.v + v));
        if near.is_finite() {
            change = change.max((best.value - near).abs());
        }
    }
    // Either grid has cells all over: what one says of them all is enough.
    Some((best, 2.0 * (besides + change) + left.min(left_besides)))
}

/// How a function bends between points along one of the two parameters.
#[derive(Clone, Copy)]
struct Bend {
    /// Its second difference, of several the largest in size, and their mean.
    size: f64,
    mean: f64,
    /// By how much it is not that of a parabola.
    spread: f64,
}

impl Bend {
    /// Of several second differences between points of one distance; what is not finite, as beside a pole, tells nothing.
    fn of<const N: usize>(all: [f64; N]) -> Bend {
        let all = all.map(|second| if second.is_finite() { second } else { 0.0 });
        let [low, high] =
            all.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(*x), high.max(*x)]);
        let mean = all.iter().sum::<f64>() / N as f64;
        Bend { size: low.abs().max(high.abs()), mean, spread: high - low }
    }

    /// The same, of what had another between points twice as far apart: a quarter is left of that where it is a parabola.
    fn within(self, before: Bend) -> Bend {
        Bend { spread: self.spread.max((self.mean - 0.25 * before.mean).abs()), ..self }
    }

    /// How much a parabola of this bend rises above both its ends, of which one is so much higher than the other, and how much more that may be.
    fn rise(self, apart: f64) -> f64 {
        let rest = (self.size - 2.0 * apart.abs()).max(0.0);
        let rise = if rest > 0.0 { rest * rest / (8.0 * self.size) } else { 0.0 };
        rise + 0.5 * self.spread
    }
}

/// A part of the parameters with what the function may be there at most, and as far as it bends like a parabola.
struct Cell {
    most: f64,
    likely: f64,
    corners: [usize; 4],
    from: (f64, f64),
    size: (f64, f64),
    /// Along `a` and round `v`.
    bends: [Bend; 2],
    is_cut_along: bool,
    depth: u32,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Cell) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Cell) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Cell) -> Ordering {
        self.most.total_cmp(&other.most)
    }
}

/// Points of a grid and those within its cells, with the values there.
struct Points<'a, T, F, M> {
    grid: &'a Grid<T>,
    within: Vec<T>,
    values: Vec<f64>,
    sought: &'a Sought<F, M>,
}

impl<T, F: Fn(&T) -> f64, M: Fn([&T; 4]) -> [f64; 2]> Points<'_, T, F, M> {
    fn point(&self, index: usize) -> &T {
        let points = self.grid.points();
        points.get(index).unwrap_or_else(|| &self.within[index - points.len()])
    }

    fn push(&mut self, point: T) -> f64 {
        let value = (self.sought.of)(&point);
        self.within.push(point);
        self.values.push(value);
        value
    }

    /// The second difference along three points, evenly apart.
    fn second(&self, line: [usize; 3]) -> f64 {
        self.second_between(line, [1.0, 1.0])
    }

    /// The same of points that are so far apart, as if both were as far as the farther.
    fn second_between(&self, line: [usize; 3], [first, second]: [f64; 2]) -> f64 {
        let [before, here, after] = line.map(|index| self.values[index]);
        let longer = first.max(second);
        2.0 * ((before - here) * (longer / first) + (after - here) * (longer / second)) * (longer / (first + second))
    }

    /// No more is in a cell than at the greatest of its corners and half of how much the function bends there, which is four times what a parabola rises between two points and as much as a kink does, and what else is known.
    fn cell(&self, corners: [usize; 4], bends: [Bend; 2], from: (f64, f64), size: (f64, f64), depth: u32) -> Cell {
        let values = corners.map(|index| self.values[index]);
        let top = values.into_iter().fold(f64::NAN, f64::max);
        let [along, round] = (self.sought.more)(corners.map(|index| self.point(index)));
        let [one, two, three, four] = values;
        let [down, right] = [three + four - one - two, two + four - one - three].map(|twice| 0.5 * twice);
        let likely = top + along + round + bends[0].rise(down) + bends[1].rise(right);
        let [along, round] = [along + 0.5 * bends[0].size, round + 0.5 * bends[1].size];
        let most = (top + along + round).min(self.sought.most);
        let likely = likely.min(most);
        Cell { most, likely, corners, from, size, bends, is_cut_along: along >= round, depth }
    }

    /// A cell of the grid.
    fn whole_cell(&self, row: usize, column: usize) -> Cell {
        let (rows, columns) = (self.grid.rows(), self.grid.columns());
        let index = |row: usize, column: usize| row * columns + column % columns;
        let corners = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(down, right)| (row + down, column + right));
        let along = corners.map(|(row, column)| {
            if rows < 3 {
                return 0.0;
            }
            let middle = row.clamp(1, rows - 2);
            let line = [middle - 1, middle, middle + 1].map(|row| index(row, column));
            self.second_between(line, [self.grid.gap(middle - 1), self.grid.gap(middle)])
        });
        let round = corners.map(|(row, column)| {
            self.second([column + columns - 1, column, column + 1].map(|column| index(row, column)))
        });
        let corners = corners.map(|(row, column)| index(row, column));
        let size = (self.grid.gap(row), self.grid.steps().1);
        self.cell(corners, [Bend::of(along), Bend::of(round)], self.grid.place(index(row, column)), size, 0)
    }

    /// The halves of a cell, with the places of the two points between them, which are pushed after each other.
    fn halves(&self, cell: &Cell) -> [Cell; 2] {
        let Cell { corners: [one, two, three, four], from: (a, v), size: (p, q), bends: [along, round], depth, .. } =
            *cell;
        let new = self.values.len() - 2;
        if cell.is_cut_along {
            let seconds = [[one, new, three], [two, new + 1, four]].map(|line| self.second(line));
            let bends = [Bend::of(seconds).within(along), round];
            let size = (0.5 * p, q);
            [([one, two, new, new + 1], a), ([new, new + 1, three, four], a + 0.5 * p)]
                .map(|(corners, a)| self.cell(corners, bends, (a, v), size, depth + 1))
        } else {
            let seconds = [[one, new, two], [three, new + 1, four]].map(|line| self.second(line));
            let bends = [along, Bend::of(seconds).within(round)];
            let size = (p, 0.5 * q);
            [([one, new, three, new + 1], v), ([new, two, new + 1, four], v + 0.5 * q)]
                .map(|(corners, v)| self.cell(corners, bends, (a, v), size, depth + 1))
        }
    }
}

/// The size that values usually have: half of them are smaller.
pub(crate) fn usual(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut sizes: Vec<f64> = values.into_iter().map(f64::abs).filter(|size| size.is_finite()).collect();
    let middle = sizes.len() / 2;
    if sizes.is_empty() { 0.0 } else { *sizes.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// From the greatest value that is known, a greater one where cells of a grid hold it; and what those may hold besides that were not cut any more.
fn improve<T>(
    grid: &Grid<T>,
    known: Place,
    sought: &Sought<impl Fn(&T) -> f64, impl Fn([&T; 4]) -> [f64; 2]>,
    mut at: impl FnMut(f64, f64) -> T,
) -> (Place, f64) {
    let values: Vec<f64> = grid.points().iter().map(&sought.of).collect();
    let is_level = |row: &[f64]| row.iter().all(|value| !((value - row[0]).abs() > LEVEL * row[0].abs()));
    // What is the same all round is in every column.
    let columns = if values.chunks(grid.columns()).all(is_level) { 1 } else { grid.columns() };
    let small = sought.small * known.value.abs().max(usual(values.iter().copied()));
    let mut points = Points { grid, within: Vec::new(), values, sought };
    let mut best = known;
    let all = (0..grid.rows() - 1).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let mut cells: BinaryHeap<Cell> =
        all.map(|(row, column)| points.whole_cell(row, column)).filter(|cell| cell.most > best.value + small).collect();
    for n_cuts in 0..LONGER * sought.cuts {
        let least = if n_cuts < sought.cuts { small } else { MUCH * small };
        if watch::is_stopped() || !cells.peek().is_some_and(|cell| cell.most > best.value + least) {
            break;
        }
        let Some(cell) = cells.pop() else { break };
        let ((a, v), (p, q)) = (cell.from, cell.size);
        let between = if cell.is_cut_along {
            [0.0, 1.0].map(|x| (a + 0.5 * p, v + x * q))
        } else {
            [0.0, 1.0].map(|x| (a + x * p, v + 0.5 * q))
        };
        for (a, v) in between {
            let value = points.push(at(a, v));
            if value > best.value {
                best = climb(Place { a, v, value }, p, q, |a, v| (sought.of)(&at(a, v)));
            }
        }
        if cell.depth < DEEPEST {
            cells.extend(points.halves(&cell).into_iter().filter(|cell| cell.most > best.value + small));
        }
    }
    let left = cells.iter().map(|cell| cell.likely - best.value).fold(0.0, f64::max);
    (best, left)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The greatest value of a function that is known at the points of two grids.
    fn found(hill: impl Fn(f64, f64) -> f64) -> (Place, f64) {
        let grids = [Grid::new(17, 25, &hill), Grid::graded(17, 34, &hill)];
        let sought = Sought {
            of: |value: &f64| *value,
            more: |_: [&f64; 4]| [0.0; 2],
            most: f64::INFINITY,
            small: 1e-6,
            cuts: 2_000,
        };
        greatest([&grids[0], &grids[1]], &sought, &hill).unwrap()
    }

    #[test]
    fn the_greater_of_two_tops_is_found_though_points_are_nearer_to_the_other() {
        for shift in (0..40).map(|i| 0.01 * f64::from(i)) {
            // One that is broad, and one of half the width of a cell that is a little higher.
            let hill = |a: f64, v: f64| {
                let bump = |a0: f64, v0: f64, width: f64| {
                    let (p, q) = ((a - a0) / width, libm::sin(0.5 * (v - v0)) / width);
                    libm::exp(-p * p - q * q)
                };
                bump(0.25, 1.0, 0.3) + 1.05 * bump(0.6, 4.0 + shift, 0.06)
            };
            let (place, error) = found(hill);
            let top = hill(0.6, 4.0 + shift);
            assert!((place.value - top).abs() <= error + 1e-9 && (place.a - 0.6).abs() < 1e-2, "{shift}: {place:?}");
            assert!(error < 1e-6, "{shift}: {error}");
        }
    }

    #[test]
    fn a_top_beside_an_end_is_found() {
        for rate in [30.0, 100.0, 300.0] {
            // x exp(1 - x) is 1 at 1.
            let hill = |a: f64, v: f64| rate * a * libm::exp(1.0 - rate * a) * (1.0 + 0.1 * libm::cos(v));
            let (place, error) = found(hill);
            assert!((place.value - 1.1).abs() <= error + 1e-12 && error < 1e-6, "{rate}: {place:?} {error}");
        }
    }

    #[test]
    fn what_is_left_uncut_is_part_of_the_error() {
        // A hundred times more waves than columns.
        let hill = |a: f64, v: f64| libm::sin(300.0 * a) * libm::sin(251.0 * v) * (1.0 + a);
        let (place, error) = found(hill);
        assert!(place.value + error >= 1.99 && place.value > 1.5, "{place:?} {error}");
    }

    #[test]
    fn a_ridge_and_what_is_level_come_to_an_end() {
        for (name, hill) in [
            ("level", (|_, _| 2.0) as fn(f64, f64) -> f64),
            ("ridge", |a, v| 2.0 - (a - 0.3 - 0.1 * libm::sin(v)) * (a - 0.3 - 0.1 * libm::sin(v))),
            ("round", |a, _| 2.0 - (a - 0.3) * (a - 0.3)),
        ] {
            let (place, error) = found(hill);
            assert!((place.value - 2.0).abs() < 1e-12 && error < 1e-4, "{name}: {place:?} {error}");
        }
        assert!(
            greatest(
                [&Grid::new(3, 4, |_, _| f64::NAN), &Grid::new(3, 4, |_, _| f64::NAN)],
                &Sought { of: |value: &f64| *value, more: |_: [&f64; 4]| [0.0; 2], most: 1.0, small: 0.0, cuts: 10 },
                |_, _| f64::NAN
            )
            .is_none()
        );
    }
}
