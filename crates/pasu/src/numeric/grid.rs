//! Extremes over a whole surface: the best points of an even grid, each [climbed](super::climb) to the top.

use core::f64::consts::TAU;

use super::climb::{Place, climb};
use super::cubic;
use crate::watch;

/// What a face is at the points of an even grid, to be searched for several functions.
pub(crate) struct Grid<T> {
    /// `a` of every row.
    rows: Vec<f64>,
    columns: usize,
    points: Vec<T>,
}

/// How much nearer to each other than evenly the rows of a [graded](Grid::graded) grid are at the ends: what is left of 1.
const GRADED: f64 = 0.9;

/// Local extremes of a grid that are followed to the end. Petals repeat the same one; a shape of several has not many nearly as large.
const FOLLOWED: usize = 6;

impl<T> Grid<T> {
    /// Samples a function of `(a, v)`: `rows` rows from `a = 0` to 1, and round `v` as many columns. Fewer rows once nobody waits for it any more.
    pub(crate) fn new(rows: usize, columns: usize, at: impl FnMut(f64, f64) -> T) -> Grid<T> {
        Grid::at_rows(rows, columns, |a| a, at)
    }

    /// The same with rows that are ten times as close at the ends, where a surface may turn quickly.
    pub(crate) fn graded(rows: usize, columns: usize, at: impl FnMut(f64, f64) -> T) -> Grid<T> {
        Grid::at_rows(rows, columns, |a| a - GRADED * libm::sin(TAU * a) / TAU, at)
    }

    fn at_rows(rows: usize, columns: usize, row: impl Fn(f64) -> f64, mut at: impl FnMut(f64, f64) -> T) -> Grid<T> {
        let (rows, columns) = (rows.max(2), columns.max(4));
        let mut grid = Grid { rows: Vec::with_capacity(rows), columns, points: Vec::with_capacity(rows * columns) };
        for i in 0..rows {
            if i >= 2 && watch::is_stopped() {
                break;
            }
            let a = if i == rows - 1 { 1.0 } else { row(i as f64 / (rows - 1) as f64) };
            grid.rows.push(a);
            grid.points.extend((0..columns).map(|j| at(a, TAU * j as f64 / columns as f64)));
        }
        grid
    }

    /// Something of every point.
    pub(crate) fn map<U>(&self, of: impl Fn(&T) -> U) -> Grid<U> {
        Grid { rows: self.rows.clone(), columns: self.columns, points: self.points.iter().map(of).collect() }
    }

    /// The points row by row.
    pub(crate) fn by_rows(&self) -> impl Iterator<Item = &[T]> {
        self.points.chunks(self.columns)
    }

    pub(crate) fn points(&self) -> &[T] {
        &self.points
    }

    /// Where point number `index` is.
    pub(crate) fn place(&self, index: usize) -> (f64, f64) {
        let (row, column) = (index / self.columns, index % self.columns);
        (self.rows[row], TAU * column as f64 / self.columns as f64)
    }

    pub(crate) fn rows(&self) -> usize {
        self.rows.len()
    }

    /// How far it is from one row to the next.
    pub(crate) fn gap(&self, row: usize) -> f64 {
        self.rows[row + 1] - self.rows[row]
    }

    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// The distance between neighbours, along `a` on average.
    pub(crate) fn steps(&self) -> (f64, f64) {
        (1.0 / (self.rows() - 1) as f64, TAU / self.columns as f64)
    }

    /// The greatest value of a function of the face, and where: the best local extremes of the grid are each climbed to the top. Values that are not finite are passed over.
    pub(crate) fn greatest(&self, of: impl Fn(&T) -> f64, mut at: impl FnMut(f64, f64) -> T) -> Option<Place> {
        let values: Vec<f64> = self.points.iter().map(&of).collect();
        let mut tops: Vec<usize> = (0..values.len()).filter(|&index| self.is_top(&values, index)).collect();
        tops.sort_by(|&i, &j| values[j].total_cmp(&values[i]).then(i.cmp(&j)));
        let step_v = self.steps().1;
        let mut best: Option<Place> = None;
        for &index in tops.iter().take(FOLLOWED) {
            let (a, v) = self.place(index);
            let start = Place { a, v, value: values[index] };
            let top = climb(start, self.step_at(index), step_v, |a, v| of(&at(a, v)));
            if best.is_none_or(|best| top.value > best.value) {
                best = Some(top);
            }
        }
        best
    }

    /// How far it is from a point to the farther of the rows beside its own.
    fn step_at(&self, index: usize) -> f64 {
        let row = index / self.columns;
        let gap = |row: usize| if row + 1 < self.rows() { self.gap(row) } else { 0.0 };
        gap(row).max(row.checked_sub(1).map_or(0.0, gap))
    }

    /// Every local top above a value of a function of which the slope round `v` is known too, about where it is: between points it is nearly the cubic of their values and slopes, so that two tops are seen that are
    /// nearer to each other than the points. `may_have` says in which rows there may be one, and others are hardly looked at.
    pub(crate) fn crests(
        &self,
        of: impl Fn(&T) -> [f64; 2],
        above: f64,
        may_have: impl Fn(usize) -> bool,
    ) -> Vec<Place> {
        let rows: Vec<bool> = (0..self.rows()).map(may_have).collect();
        let step = self.steps().1;
        let (mut values, mut slopes) = (vec![f64::NAN; self.points.len()], vec![f64::NAN; self.points.len()]);
        for index in self.beside_rows(&rows).flat_map(|row| row * self.columns..(row + 1) * self.columns) {
            [values[index], slopes[index]] = of(&self.points[index]);
        }
        let cubic = |row: usize, column: usize| {
            let ends = [0, 1].map(|right| row * self.columns + (column + right) % self.columns);
            cubic::through(ends.map(|index| values[index]), ends.map(|index| slopes[index] * step))
        };
        let mut found = Vec::new();
        for row in (0..self.rows()).filter(|row| rows[*row]) {
            let first = row * self.columns;
            // Between each point and the next: where, and the value there.
            let between = |column: usize| {
                let cubic = cubic(row, column);
                cubic::top(cubic).map(|x| (x, cubic::at(cubic, x)))
            };
            let tops: Vec<Option<(f64, f64)>> = (0..self.columns).map(between).collect();
            for (column, top) in tops.iter().enumerate() {
                let (a, v) = self.place(first + column);
                if let Some((x, value)) = *top {
                    // Of equal rows the first counts.
                    let is_higher = |other: usize, there: f64| !(there > value || there == value && other < row);
                    let is_top = || {
                        let beside = [row.wrapping_sub(1), row + 1].into_iter().filter(|other| *other < self.rows());
                        beside.into_iter().all(|other| {
                            let about = [self.columns - 1, 0, 1, 2].map(|right| (column + right) % self.columns);
                            let mut points = about.into_iter().map(|column| values[other * self.columns + column]);
                            points.all(|there| is_higher(other, there))
                                && is_higher(other, cubic::at(cubic(other, column), x))
                        })
                    };
                    if value > above && is_top() {
                        found.push(Place { a, v: v + x * step, value });
                    }
                }
                // Where slopes say nothing, or what is not so.
                let value = values[first + column];
                let before = tops[(column + self.columns - 1) % self.columns];
                let is_outdone = [before, *top].into_iter().flatten().any(|(_, top)| top >= value);
                if value > above && !is_outdone && self.is_top(&values, first + column) {
                    found.push(Place { a, v, value });
                }
            }
        }
        found
    }

    /// The rows in which there may be a top, and those beside them: a top is higher than these.
    fn beside_rows(&self, rows: &[bool]) -> impl Iterator<Item = usize> {
        (0..self.rows()).filter(|row| rows[row.saturating_sub(1)..(row + 2).min(self.rows())].contains(&true))
    }

    /// Every point above a value that is no lower than those about it; `may_have` says in which rows there may be one, and others are hardly looked at.
    pub(crate) fn tops(&self, of: impl Fn(&T) -> f64, above: f64, may_have: impl Fn(usize) -> bool) -> Vec<Place> {
        let rows: Vec<bool> = (0..self.rows()).map(may_have).collect();
        let mut values = vec![f64::NAN; self.points.len()];
        for index in self.beside_rows(&rows).flat_map(|row| row * self.columns..(row + 1) * self.columns) {
            values[index] = of(&self.points[index]);
        }
        let meant = (0..self.rows()).filter(|row| rows[*row]);
        let points = meant.flat_map(|row| row * self.columns..(row + 1) * self.columns);
        let tops = points.filter(|&index| values[index] > above && self.is_top(&values, index));
        tops.map(|index| {
            let (a, v) = self.place(index);
            Place { a, v, value: values[index] }
        })
        .collect()
    }

    fn is_top(&self, values: &[f64], index: usize) -> bool {
        let (row, column) = (index / self.columns, index % self.columns);
        let here = values[index];
        // Of equal neighbours the first counts: a level curve has one top, not as many as columns.
        here.is_finite()
            && [-1, 0, 1].iter().all(|down: &isize| {
                let Some(row) = row.checked_add_signed(*down).filter(|row| *row < self.rows()) else { return true };
                [self.columns - 1, 0, 1].iter().all(|right| {
                    let other = row * self.columns + (column + right) % self.columns;
                    let there = values[other];
                    !(there > here || there == here && other < index)
                })
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tops_inside_and_at_ends() {
        type Hill = (&'static str, fn(f64, f64) -> f64, f64);
        let hills: [Hill; 5] = [
            ("round", |a, v| 3.0 - (a - 0.3).powi(2) - (v - 2.0).sin().powi(2), 3.0),
            ("ridge", |a, _| 2.0 - (a - 0.71).powi(2), 2.0),
            ("askew", |a, v| 1.0 - (5.0 * (a - 0.4) + (v - 1.0).sin()).powi(2) - 0.01 * (a - 0.5).powi(2), 1.0),
            ("at an end", |a, v| a + 0.1 * (3.0 * v).cos(), 1.1),
            ("kink", |a, v| 1.0 - (a - 0.37).abs() - (0.5 * (v - 4.0)).sin().abs(), 1.0),
        ];
        for (name, hill, top) in hills {
            let found = Grid::new(17, 24, hill).greatest(|value| *value, hill).unwrap();
            assert!((found.value - top).abs() < if name == "kink" { 1e-7 } else { 1e-12 }, "{name}: {found:?}");
        }
    }

    #[test]
    fn two_tops_that_are_nearer_to_each_other_than_the_points_are_seen_on_either_side_of_a_dent() {
        let grid = |shift: f64| {
            Grid::new(5, 24, |a, v| {
                let x = v - 2.0 - shift;
                // Level at 0 and at 0.2 on both sides.
                [x * x * (0.08 - x * x) - (a - 0.5) * (a - 0.5), 0.16 * x - 4.0 * x * x * x]
            })
        };
        for shift in (0..30).map(|i| f64::from(i) * 0.01) {
            let found = grid(shift).crests(|value| *value, -0.1, |_| true);
            assert_eq!(found.len(), 2, "{shift}: {found:?}");
            for (Place { a, v, value }, x) in found.into_iter().zip([-0.2, 0.2]) {
                assert!(
                    a == 0.5 && (v - 2.0 - shift - x).abs() < 0.04 && (value - 0.0016).abs() < 1e-3,
                    "{shift}: {v} {value}"
                );
            }
        }
        // What is level all round has one place, and where there are no slopes a point is the place.
        let found = Grid::new(5, 24, |a, _| [a * (1.0 - a), 0.0]).crests(|value| *value, 0.0, |_| true);
        assert_eq!(found, [Place { a: 0.5, v: 0.0, value: 0.25 }]);
        let found = Grid::new(5, 24, |_, v| [v * (6.0 - v), f64::NAN]).crests(|value| *value, 0.0, |row| row == 3);
        assert_eq!(found.len(), 0);
        let found = Grid::new(5, 24, |a, v| [v * (6.0 - v) + a, f64::NAN]).crests(|value| *value, 0.0, |row| row == 4);
        assert_eq!(found.len(), 1);
        assert!(found[0].a == 1.0 && (found[0].v - 3.0).abs() < 0.15, "{found:?}");
    }
}
