//! Extremes of functions of one and of two variables, from a grid to rounding.

use core::f64::consts::TAU;

/// A place on a face and the value of a function there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    pub(crate) a: f64,
    pub(crate) v: f64,
    pub(crate) value: f64,
}

/// What a face is at the points of an even grid, to be searched for several functions.
pub(crate) struct Grid<T> {
    rows: usize,
    columns: usize,
    points: Vec<T>,
}

/// Local extremes of a grid that are followed to the end. Petals repeat the same one; a shape of several has not many nearly as large.
const FOLLOWED: usize = 6;

impl<T> Grid<T> {
    /// Samples a function of `(a, v)`: `rows` rows from `a = 0` to 1, and round `v` as many columns.
    pub(crate) fn new(rows: usize, columns: usize, mut at: impl FnMut(f64, f64) -> T) -> Grid<T> {
        let (rows, columns) = (rows.max(2), columns.max(4));
        let mut points = Vec::with_capacity(rows * columns);
        for i in 0..rows {
            let a = i as f64 / (rows - 1) as f64;
            points.extend((0..columns).map(|j| at(a, TAU * j as f64 / columns as f64)));
        }
        Grid { rows, columns, points }
    }

    pub(crate) fn points(&self) -> &[T] {
        &self.points
    }

    /// Where point number `index` is.
    pub(crate) fn place(&self, index: usize) -> (f64, f64) {
        let (row, column) = (index / self.columns, index % self.columns);
        (row as f64 / (self.rows - 1) as f64, TAU * column as f64 / self.columns as f64)
    }

    /// The neighbours of a point on either side: along `a`, where it has both, and round `v`.
    pub(crate) fn neighbours(&self, index: usize) -> [Option<[usize; 2]>; 2] {
        let (row, column, n) = (index / self.columns, index % self.columns, self.columns);
        let along = (row > 0 && row + 1 < self.rows).then(|| [index - n, index + n]);
        let round = [(column + n - 1) % n, (column + 1) % n].map(|column| row * n + column);
        [along, Some(round)]
    }

    pub(crate) fn rows(&self) -> usize {
        self.rows
    }

    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// The distance between neighbours.
    pub(crate) fn steps(&self) -> (f64, f64) {
        (1.0 / (self.rows - 1) as f64, TAU / self.columns as f64)
    }

    /// The greatest value of a function of the face, and where: the best local extremes of the grid are each climbed to the top. Values that are not finite are passed over.
    pub(crate) fn greatest(&self, of: impl Fn(&T) -> f64, at: impl Fn(f64, f64) -> T) -> Option<Place> {
        let values: Vec<f64> = self.points.iter().map(&of).collect();
        let mut tops: Vec<usize> = (0..values.len()).filter(|&index| self.is_top(&values, index)).collect();
        tops.sort_by(|&i, &j| values[j].total_cmp(&values[i]).then(i.cmp(&j)));
        let (step_a, step_v) = self.steps();
        let mut best: Option<Place> = None;
        for &index in tops.iter().take(FOLLOWED) {
            let (a, v) = self.place(index);
            let start = Place { a, v, value: values[index] };
            let top = climb(start, step_a, step_v, |a, v| of(&at(a, v)));
            if best.is_none_or(|best| top.value > best.value) {
                best = Some(top);
            }
        }
        best
    }

    /// As [`Self::greatest`], with how far the value may be off: what the same search from another grid finds otherwise, and how much the function changes over the last step. Where the
    /// function is smooth that is little more than its rounding.
    pub(crate) fn greatest_and_error(
        &self,
        other: &Grid<T>,
        of: impl Fn(&T) -> f64,
        at: impl Fn(f64, f64) -> T,
    ) -> Option<(Place, f64)> {
        let found = [self.greatest(&of, &at), other.greatest(&of, &at)];
        let best = found.into_iter().flatten().max_by(|x, y| x.value.total_cmp(&y.value))?;
        let between = found.into_iter().flatten().fold(0.0f64, |most, place| most.max(best.value - place.value));
        let (step_a, step_v) = self.steps();
        // At an end the function may rise towards it.
        let p = if best.a > 0.0 && best.a < 1.0 { LAST * step_a } else { 0.0 };
        let q = LAST * step_v;
        let mut change = 0.0f64;
        for (a, v) in [(p, 0.0), (-p, 0.0), (0.0, q), (0.0, -q), (p, q), (-p, -q)] {
            let near = of(&at((best.a + a).clamp(0.0, 1.0), best.v + v));
            if near.is_finite() {
                change = change.max((best.value - near).abs());
            }
        }
        Some((best, 2.0 * (between + change)))
    }

    /// Every local top that begins above a value, climbed.
    pub(crate) fn tops(&self, of: impl Fn(&T) -> f64, above: f64, at: impl Fn(f64, f64) -> T) -> Vec<Place> {
        let values: Vec<f64> = self.points.iter().map(&of).collect();
        let (step_a, step_v) = self.steps();
        let starts = (0..values.len()).filter(|&index| values[index] > above && self.is_top(&values, index));
        starts
            .map(|index| {
                let (a, v) = self.place(index);
                climb(Place { a, v, value: values[index] }, step_a, step_v, |a, v| of(&at(a, v)))
            })
            .collect()
    }

    fn is_top(&self, values: &[f64], index: usize) -> bool {
        let (row, column) = (index / self.columns, index % self.columns);
        let here = values[index];
        // Of equal neighbours the first counts: a level curve has one top, not as many as columns.
        here.is_finite()
            && [-1, 0, 1].iter().all(|down: &isize| {
                let Some(row) = row.checked_add_signed(*down).filter(|row| *row < self.rows) else { return true };
                [self.columns - 1, 0, 1].iter().all(|right| {
                    let other = row * self.columns + (column + right) % self.columns;
                    let there = values[other];
                    !(there > here || there == here && other < index)
                })
            })
    }
}

/// How often a step is taken or shortened at most.
const MOST_STEPS: usize = 60;

/// Steps end when they are this part of the first: then a quadratic top is reached to rounding.
const SHORTEST: f64 = 1e-8;

/// How far from a top the function is looked at again, as a part of the first step: so near that a smooth one has changed by rounding alone.
const LAST: f64 = 1e-8;

/// Climbs from a place to a local maximum, within `a` in [0, 1].
///
/// At each step a quadratic is laid through nine points; its top, or the best of the nine where it has none, is taken if it is higher, otherwise the points draw together. A kink slows
/// this down and does not mislead it.
pub(crate) fn climb(start: Place, step_a: f64, step_v: f64, mut of: impl FnMut(f64, f64) -> f64) -> Place {
    let mut best = start;
    let (mut p, mut q) = (step_a.min(0.5), step_v);
    for _ in 0..MOST_STEPS {
        if p < SHORTEST * step_a {
            break;
        }
        let centre = best.a.clamp(p, 1.0 - p);
        let mut f = [[0.0; 3]; 3];
        let before = best;
        for (i, row) in f.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                let (a, v) = (centre + (i as f64 - 1.0) * p, before.v + (j as f64 - 1.0) * q);
                *value = of(a, v);
                if *value > best.value {
                    best = Place { a, v, value: *value };
                }
            }
        }
        let (ga, gv) = (0.5 * (f[2][1] - f[0][1]), 0.5 * (f[1][2] - f[1][0]));
        let (haa, hvv) = (f[2][1] - 2.0 * f[1][1] + f[0][1], f[1][2] - 2.0 * f[1][1] + f[1][0]);
        let hav = 0.25 * (f[2][2] - f[2][0] - f[0][2] + f[0][0]);
        let determinant = haa * hvv - hav * hav;
        let alone = |gradient: f64, bend: f64| {
            let step = if bend < 0.0 { -gradient / bend } else { gradient * 1e300 };
            if step.is_finite() { step.clamp(-3.0, 3.0) } else { 0.0 }
        };
        let joint = [(hav * gv - hvv * ga) / determinant, (hav * ga - haa * gv) / determinant];
        let shorter = (3.0 / joint[0].abs().max(joint[1].abs())).min(1.0);
        let joint = joint.map(|step| step * shorter);
        let is_top = haa < 0.0 && determinant > 1e-8 * haa * hvv && joint.iter().all(|step| step.is_finite());
        let [sa, sv] = if is_top { joint } else { [alone(ga, haa), alone(gv, hvv)] };
        let mut candidates = vec![(centre + sa * p, before.v + sv * q)];
        if !(0.0..=1.0).contains(&candidates[0].0) {
            // Against an end: the best along it.
            let end = candidates[0].0.clamp(0.0, 1.0);
            let slope = gv + hav * (end - centre) / p;
            candidates[0] = (end, before.v + alone(slope, hvv) * q);
        }
        for (a, v) in candidates {
            let value = of(a, v);
            if value > best.value {
                best = Place { a, v, value };
            }
        }
        let moved = ((best.a - before.a) / p).abs().max(((best.v - before.v) / q).abs());
        if moved < 0.5 {
            // Nearly there: the quadratic is the better the closer its points.
            (p, q) = (0.125 * p, 0.125 * q);
        } else if moved < 1.5 {
            (p, q) = (0.5 * p, 0.5 * q);
        } else if moved > 2.5 {
            (p, q) = ((2.0 * p).min(0.5), 2.0 * q);
        }
    }
    best
}

/// The least value of a function of one variable between two ends, by golden section and parabolas (R. P. Brent, *Algorithms for minimization without derivatives*, 1973, chapter 5).
/// Gives the place and the value.
pub(crate) fn least(from: f64, to: f64, tolerance: f64, mut of: impl FnMut(f64) -> f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.381_966_011_250_105_1;
    let (mut low, mut high) = (from, to);
    let mut x = low + GOLDEN * (high - low);
    let (mut w, mut v, mut fx) = (x, x, of(x));
    let (mut fw, mut fv) = (fx, fx);
    let (mut step, mut before) = (0.0f64, 0.0f64);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (high - low) {
            break;
        }
        let (mut p, mut q, mut r) = (0.0, 0.0, 0.0);
        if before.abs() > tolerance {
            r = (x - w) * (fx - fv);
            q = (x - v) * (fx - fw);
            p = (x - v) * q - (x - w) * r;
            q = 2.0 * (q - r);
            if q > 0.0 {
                p = -p;
            } else {
                q = -q;
            }
            r = before;
            before = step;
        }
        if p.abs() < (0.5 * q * r).abs() && p > q * (low - x) && p < q * (high - x) {
            step = p / q;
            let u = x + step;
            if u - low < 2.0 * tolerance || high - u < 2.0 * tolerance {
                step = if x < middle { tolerance } else { -tolerance };
            }
        } else {
            before = if x < middle { high - x } else { low - x };
            step = GOLDEN * before;
        }
        let u = x + if step.abs() >= tolerance { step } else { libm::copysign(tolerance, step) };
        let fu = of(u);
        if fu <= fx {
            if u < x {
                high = x;
            } else {
                low = x;
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                low = u;
            } else {
                high = u;
            }
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    (x, fx)
}

/// The root of a function between two ends at which its signs differ, to the last bits: secants held in by bisection (the ITP method of I. F. D. Oliveira and R. H. C. Takahashi, 2020, in
/// the simpler form of Illinois).
pub(crate) fn root(from: (f64, f64), to: (f64, f64), mut of: impl FnMut(f64) -> f64) -> f64 {
    let ((mut x0, mut f0), (mut x1, mut f1)) = (from, to);
    let mut side = 0i32;
    for _ in 0..200 {
        if f0 == 0.0 {
            return x0;
        }
        if f1 == 0.0 {
            return x1;
        }
        let gap = x1 - x0;
        if gap.abs() <= 4.0 * f64::EPSILON * x0.abs().max(x1.abs()).max(1e-3) {
            break;
        }
        let secant = x1 - f1 * gap / (f1 - f0);
        let within = (secant - x0) * (x1 - secant) > 0.0;
        let x = if within && side.abs() < 4 { secant } else { 0.5 * (x0 + x1) };
        let f = of(x);
        if (f < 0.0) == (f1 < 0.0) {
            (x1, f1) = (x, f);
            if side > 0 {
                f0 *= 0.5;
            }
            side = if side.abs() >= 4 { 0 } else { side.max(0) + 1 };
        } else {
            (x0, f0) = (x, f);
            if side < 0 {
                f1 *= 0.5;
            }
            side = if side.abs() >= 4 { 0 } else { side.min(0) - 1 };
        }
    }
    if f0.abs() < f1.abs() { x0 } else { x1 }
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
    fn least_and_roots() {
        let (x, value) = least(0.0, 3.0, 1e-9, |x| (x - 1.7).powi(2) + 4.0);
        assert!((x - 1.7).abs() < 1e-7 && (value - 4.0).abs() < 1e-15);
        let (x, _) = least(0.0, 3.0, 1e-9, |x| (x - 1.7).abs());
        assert!((x - 1.7).abs() < 1e-8);
        for f in [|x: f64| x.powi(9) - 1e-5, |x: f64| (x - 0.3).tanh(), |x: f64| x - 0.999_999] {
            let mut n = 0;
            let x = root((0.0, f(0.0)), (1.0, f(1.0)), |x| {
                n += 1;
                f(x)
            });
            assert!(f(x).abs() < 1e-15 && n < 60, "{x} {} {n}", f(x));
        }
    }
}
